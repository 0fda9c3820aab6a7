// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Look-ahead and interpolation. Prepared motion blocks go in at one end; one set point per
/// interpolation cycle comes out. @threadsafety one object, one thread; `step` allocates only
/// when a block ends and its record is kept.
///
/// How it works. Blocks become pieces: lines and arcs. If a block is to be rounded into the next
/// one, both give up some length to an arc between them (path_piece.h). Everywhere else the
/// direction must be continuous, or the path stops at the corner. Each piece has a speed that its
/// curvature and its axes allow, and a junction speed at which it may be entered.
///
/// One jerk-limited motion covers all pieces. `SpeedCeiling` says which states of motion are safe:
/// from these the path can stop at the end of the last piece within all limits. A block that is
/// appended can only lengthen the path: the corner to it is opened if the motion in progress stays
/// safe; otherwise the path stops there. So no limit is ever exceeded, whenever blocks arrive.
///
/// The override may change the feed at any moment. It takes effect as soon as the motion is safe
/// with the new feed.
///
/// A block that would be passed in less than a cycle gets a lower feed, as on the control
/// (`blocksPerCycleMax`): many short blocks make the path slow.
///
/// Limits per axis. BRISK: along an arc half of the acceleration is used along the path and 0.866
/// of it across (the two are at right angles, so together they use all of it); the jerk is so high
/// that it does not matter. SOFT: half of the jerk is used along the path; the other half is kept
/// for arcs and for the steps of the curvature at their ends.
///
/// Rotary axes turn in proportion to the path: each piece has its degrees per mm, and its speed,
/// acceleration and jerk along the path are such that no rotary axis exceeds its own. A block that
/// moves nothing else (or less than 10 µm per degree) is measured in degrees, and the path stops
/// at both its ends. Corners at blocks that turn rotary axes are not rounded: if the direction or
/// the degrees per mm change, the path passes at the speed at which every axis can follow the step
/// (as between an arc and a line), or it stops.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "machine/config.h"
#include "machine/path_piece.h"
#include "machine/path_place.h"
#include "machine/prepared.h"
#include "machine/rough_motion.h"
#include "machine/speed_ceiling.h"
#include "machine/speed_profile.h"
#include "trace/control_trace.h"

namespace rivulet::machine {

/// What the main run does besides moving the axes.
class AuxiliaryRun {
 public:
  virtual ~AuxiliaryRun() = default;
  /// @return s, how long the next block has to wait; infinity: until `PathPlanner::release`
  [[nodiscard]] virtual double begin(const PreparedActions& actions, base::Instant at) = 0;
  /// A dwell of the program begins.
  virtual void dwell(base::LineNumber line, base::Instant at, double seconds) = 0;
};

class PathPlanner {
 public:
  PathPlanner(const MachineConfig& config, base::Vec3 startMm, base::RotaryDeg startDeg = {});

  /// Appends a block after the last one.
  void append(const PreparedMotion& motion);
  /// The same of a block whose geometry is known. @param rough  begins where the last block ends
  void append(const RoughMotion& rough);
  void append(const PreparedDwell& dwell);
  void append(PreparedActions actions);

  /// Blocks appended between two cycles are planned together, also in motion: for whoever appends
  /// hundreds at once. A corner that only the blocks behind it make passable in the motion in
  /// progress is opened then, too.
  void planTogether() { m_unplanned.may = true; }

  /// Who carries out actions; outlives the planner. Without one they take no time.
  void setAuxiliaryRun(AuxiliaryRun& auxiliaries) { m_auxiliaries = &auxiliaries; }
  /// Ends the wait of the actions in progress.
  void release() { m_dwellLeftS = 0.0; }

  /// Blocks taken over and not finished.
  [[nodiscard]] int blockCount() const { return static_cast<int>(m_blocks.size()); }
  /// Blocks taken over and finished since the planner was made, dwells included.
  [[nodiscard]] std::uint64_t blocksAppended() const { return m_appended; }
  [[nodiscard]] std::uint64_t blocksFinished() const { return m_finished; }
  [[nodiscard]] bool isStanding() const { return m_state.speedMmPerS == 0.0; }

  /// One interpolation cycle ending at `end`. Blocks that end within it are reported; a rounded
  /// block ends in the middle of the arc to the next one.
  void step(base::Instant end, std::vector<trace::ExecutedBlock>& executed);

  /// Brakes to a standstill on the path and drops the rest.
  void abort();

  /// Path override, 1 for 100 %: scales the feed of what follows; the path brakes and
  /// accelerates within its limits. @param factor >= 0; 0 holds the path
  void setOverride(double factor);

  /// Machine coordinates, as all places here.
  [[nodiscard]] base::Vec3 commandMm() const { return m_place.positionMm(); }
  /// The same as a place on the path, not evaluated yet.
  [[nodiscard]] const PathPlace& place() const { return m_place; }
  /// Of the workpiece frame in the block in motion, or after the last one.
  [[nodiscard]] base::Vec3 zeroMm() const { return m_zeroMm; }
  /// Of the frame that holds while no program runs, as after a reset.
  void setZero(base::Vec3 zeroMm) {
    m_zeroMm = zeroMm;
    m_endZeroMm = zeroMm;
  }
  [[nodiscard]] base::RotaryDeg commandDeg() const { return m_place.positionDeg(); }
  /// Path speed; deg/s in a block that only turns rotary axes.
  [[nodiscard]] double speedMmPerS() const { return m_state.speedMmPerS; }
  [[nodiscard]] double feedCommandMmPerS() const;
  [[nodiscard]] base::Vec3 distanceToGoMm() const;
  [[nodiscard]] base::RotaryDeg distanceToGoDeg() const;
  /// Path length to the end of the block in motion.
  [[nodiscard]] double pathToGoMm() const;
  /// How much of the block in motion has been passed, 0 to 1.
  [[nodiscard]] double pathShare() const;
  [[nodiscard]] base::LineNumber line() const { return m_line; }
  /// End point of the last appended block, where the path will stop.
  [[nodiscard]] base::Vec3 endMm() const { return m_endMm; }
  [[nodiscard]] const base::RotaryDeg& endDeg() const { return m_endDeg; }

 private:
  struct Piece {
    PathPiece path;
    bool isSoft = false;
    double feedMmPerS = 0.0;
    double speedMmPerSMax = 0.0;  ///< what curvature and axes allow
    SpeedLimits limits;
    double junctionMmPerSMax = 0.0;  ///< at its start; 0: the path stops there
    double junctionMmPerS2Max = std::numeric_limits<double>::infinity();
    bool boundToCycle = false;  ///< must take a cycle at least: there are steps at its ends
    bool holdsReserve = false;  ///< its limits leave room for a step of the direction
    bool endsBlock = false;
    base::RotaryDeg startDeg{};
    base::RotaryDeg degPerMm{};  ///< of A, B, C along the path
    bool inDegrees = false;      ///< the path is measured by the turn
  };
  struct Block {
    base::LineNumber line;
    base::Vec3 toMm;
    base::RotaryDeg toDeg{};
    double lengthMm = 0.0;      ///< as programmed
    double wayMm = 0.0;         ///< of X Y Z alone
    double turnDeg = 0.0;       ///< of the rotary axes
    double pathLengthMm = 0.0;  ///< with its share of the corners
    std::size_t pieces = 0;
    BlockEnd end = BlockEnd::ExactStop;
    RoundingKind rounding = RoundingKind::Deviation;
    double roundingMm = 0.0;
    Dynamics dynamics = Dynamics::Brisk;
    bool isStraight = true;
    bool isDwell = false;
    double dwellS = 0.0;
    std::shared_ptr<const PreparedActions> actions;
    base::Vec3 zeroMm;
    std::optional<base::Instant> startedAt;
  };

  /// What an append has changed of the last piece and block, to take it back.
  struct Undo {
    Piece piece;
    Block block;
    std::size_t pieces = 0;
    std::size_t blocks = 0;
  };

  /// What has been appended and not planned.
  struct Unplanned {
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    bool may = false;                  ///< in motion, too
    std::size_t from = kNone;          ///< first piece
    std::vector<RoughMotion> motions;  ///< appended in motion
    Undo undo;                         ///< takes them back
  };

  [[nodiscard]] Piece makePiece(const PathPiece& path, double feedMmPerS, Dynamics dynamics,
                                const base::RotaryDeg& degPerMm) const;
  /// @param plansAtOnce  else `settle` does
  void extend(const RoughMotion& rough, bool plansAtOnce);
  /// Plans what was to be planned together. If the motion in progress could not keep the limits,
  /// once more block by block, each as far as it can.
  void settle();
  [[nodiscard]] Undo undoOfLast() const;
  void takeBack(const Undo& undo);
  void push(Block& block, Piece piece);
  /// Opens the corner between the last piece and `next`, so that the path need not stand there.
  /// @return false if it has to
  bool connect(Block& next, Piece& piece);
  /// The length that a block can give to the corner at one of its ends.
  [[nodiscard]] double cutMmMax(double blockMm, const Piece& piece) const;
  bool roundCornerInto(Block& next, Piece& piece);
  /// @param turn  change of the direction of X Y Z; @param rateTurn  of the degrees per mm
  bool stepInto(Piece& next, double turn, double rateTurn);
  [[nodiscard]] bool isLastUnderWay() const;
  void boundToCycle(Piece& piece) const;
  [[nodiscard]] double curvatureStepSpeed(const Piece& before, const Piece& after) const;
  /// Replans from a piece to the end.
  /// @return false if the motion in progress could not keep the limits; then nothing may stay
  bool planFrom(std::size_t index, bool atOnce);
  bool plan();
  /// Speed limit of the piece in motion.
  [[nodiscard]] double capMmPerS() const;
  /// Applies the override that is set as soon as the motion is safe with it.
  void takeOverride();
  void follow(SpeedProfile profile);
  void makeProfile(double seconds);
  /// Hardest braking for a time, or to the end of the piece, that can still end at a speed.
  /// @return nothing if what follows could not be passed within its limits then
  [[nodiscard]] std::optional<SpeedProfile> brakeFor(double seconds, double speedMmPerS) const;
  /// Moves on for at most `seconds`. @return the time left
  double advance(double seconds);
  /// The axes are at a place of the piece in motion.
  void moveTo(double mm);
  [[nodiscard]] double beginBlock(Block& block, base::Instant at);
  void finishPiece();
  void finishBlock(base::Instant at, std::vector<trace::ExecutedBlock>& executed);

  MachineConfig m_config;
  double m_cycleS;
  std::deque<Block> m_blocks;
  std::deque<Piece> m_pieces;
  double m_pathMm = 0.0;   ///< on the first piece
  double m_blockMm = 0.0;  ///< passed of the first block, in finished pieces
  Unplanned m_unplanned;
  SpeedCeiling m_ceiling;  ///< a section for each piece
  SpeedState m_state;
  std::optional<SpeedProfile> m_profile;
  double m_profileS = 0.0;     ///< time passed on it
  double m_offsetMm = 0.0;     ///< place on the first piece minus length passed on the profile
  bool m_standsAtEnd = false;  ///< the profile ends in a standstill, wherever that is
  bool m_isCommitted = false;  ///< only the end of the profile is safe
  std::size_t m_reach = 0;     ///< last piece that the profile depends on
  double m_override = 1.0;
  double m_dwellLeftS = 0.0;
  std::uint64_t m_appended = 0;
  std::uint64_t m_finished = 0;
  bool m_aborting = false;
  PathPlace m_place;
  bool m_isPlaced = false;  ///< on the first piece
  base::Vec3 m_endMm;
  base::RotaryDeg m_endDeg;
  base::LineNumber m_line;
  base::Vec3 m_zeroMm;
  base::Vec3 m_endZeroMm;  ///< of the last appended block
  AuxiliaryRun* m_auxiliaries = nullptr;
};

}  // namespace rivulet::machine
