// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Executes the words of one block: what they make of the modal state, and the move they name. The
/// preview and the virtual machine have this executor in common; they differ in their sinks. Calls,
/// jumps and the end of a program are its caller's. @threadsafety one object, one thread.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nc/exec/block_reader.h"
#include "nc/exec/block_words.h"
#include "nc/exec/position.h"
#include "nc/exec/sink.h"
#include "nc/modal/state.h"
#include "nc/syntax/language.h"

namespace rivulet::nc {

/// Largest coordinate, centre offset or radius accepted, mm: a kilometre is no machine tool.
inline constexpr double kCoordinateMmMax = 1.0e6;

struct ExecutorOptions {
  CentreReading centres = CentreReading::AsProgrammed;
  bool arcLineIsSaid = false;  ///< of `Language::arcMayBeLine`; else a finding says it
  /// The tool stands where a G92 before its axis has moved says; else a finding says it.
  bool placeIsSaid = false;
  /// Largest difference of an arc's start and end radius.
  double arcRadiusToleranceMm = kArcRadiusToleranceMm;
  base::RotarySet rotaryAxes{true, true, true};  ///< words of others move nothing
  bool refusesFurtherAxes = true;                ///< U, V, W; else they move nothing
  /// Where the zero of the workpiece lies in the machine; else a move in its coordinates is left
  /// out.
  bool knowsMachineCoordinates = false;
  /// Of the machine: S beyond it is cut down to it.
  double spindlePerMinMax = std::numeric_limits<double>::infinity();
  bool unitIsSaid = false;         ///< by who loads it, else by the first G20, G21 or the like
  bool runsCannedCycles = false;   ///< of RS-274; else whoever takes the path makes them
  bool compensatesRadius = false;  ///< else G41 and G42 are refused
  bool knowsWorkOffsets = false;   ///< else the one active at the control holds for the whole path
  std::map<int, base::Vec3> workOffsetsMm{};  ///< by key of G54 to G599; none: zero
  std::map<int, base::Vec3> fixedPointsMm{};  ///< of G75, by number, machine coordinates
};

/// The settings that a subprogram can bring back when it returns: G functions, units, plane, work
/// offset, programmable frame. What else it takes along is a matter of the dialect.
struct SavedState {
  ModalState modal;
  Frame frame;
};

class Executor {
 public:
  /// All outlive the executor.
  Executor(const Language& language, const ExecutorOptions& options, Variables& variables,
           Sinks to);

  /// Before the first block.
  [[nodiscard]] ModalState& state() { return m_state; }
  [[nodiscard]] Position& start() { return m_position; }

  void read(const Token& token, BlockWords& words) { m_reader.read(token, words); }
  /// What `read` has taken in. Ends the block: the tokens may go afterwards.
  void execute(BlockWords& words);
  /// A step of a cycle: straight there, whatever is modal. @param feedMmPerS  nothing: rapid
  void moveTo(base::Vec3 programmedMm, std::optional<double> feedMmPerS, base::LineNumber line);
  /// Where a block names a place across the tool: the tool's own axis stays. For a cycle, whose
  /// words the executor does not carry out.
  [[nodiscard]] base::Vec3 placeInPlane(BlockWords words) {
    words.axes.remove(m_state.planeThirdAxis());
    return targetOf(words);
  }
  /// Where a block turns the rotary axes, for such a cycle.
  [[nodiscard]] base::RotaryDeg rotaryOf(const BlockWords& words) {
    Move move;
    takeRotary(words, move);
    return move.rotaryDeg;
  }
  /// Of a coordinate or offset that may be a diameter.
  [[nodiscard]] double radiusMm(const BlockWords& words, std::size_t axis) const {
    const bool isDiameter = axis == 0 && m_state.diameter &&
                            (m_state.diameterIncrements || !words.axes.isIncrement(axis));
    return isDiameter ? lengthMm(words, axis) / 2.0 : lengthMm(words, axis);
  }
  /// The programmed feed along the path; 0: none, or it is not known without a block.
  [[nodiscard]] double feedMmPerS() const;
  /// Ends a curve in progress.
  [[nodiscard]] SavedState save();
  void restore(const SavedState& saved);
  /// A subprogram begins. @param saves  PROC … SAVE: its return brings the present state back
  void enterCall(bool saves);
  /// It returns. Brings back what SAVE or M73 has saved.
  void leaveCall();
  /// Ends a curve that goes over several blocks.
  void finishCurve();
  /// From 1, as RS-274 counts them: G54 to G59.3. G54 is in force from the beginning.
  [[nodiscard]] int workOffsetNumber() const;

  /// As programmed, in the unit of the program. @return nothing if no motion has said it yet
  [[nodiscard]] std::optional<double> positionOf(char axis) const;

 private:
  // executor.cpp: the order within a block.
  void leaveOutMissingAxes(BlockWords& words) const;
  void setModes(const BlockWords& words);
  void setBlockEnd(G function);
  void setSpindle(const BlockWords& words);
  [[nodiscard]] double spindlePerMin(const BlockWords& words, base::Vec3 target);
  void changeSavedState(const BlockWords& words);
  void restoreFeedAndSpeed(const ModalState& now);
  void setCompensation(const BlockWords& words);
  void executeRare(BlockWords& words);
  void executeTurningCycle(BlockWords& words);
  [[nodiscard]] bool hasUnusedParameter(const BlockWords& words) const;
  void executeDwell(const BlockWords& words);
  void setUnits(G units);
  void takeFeed(BlockWords& words);
  void setFeed(const BlockWords& words);
  void rejectArcWords(const BlockWords& words);

  // frames.cpp
  void setFrame(const std::string& name, const BlockWords& words);
  [[nodiscard]] std::optional<base::Vec3> scaleFactors(bool mirrors, const BlockWords& words);
  [[nodiscard]] bool knowsAllAxes(const BlockWords& words, const std::string& statement);
  void setOffset(const BlockWords& words);
  void setPosition(const BlockWords& words, const std::string& statement);
  void setTurn(const BlockWords& words);
  void setScale(const BlockWords& words);
  void setMirror(const BlockWords& words);
  [[nodiscard]] bool takeCentre(const BlockWords& words, std::size_t axis, base::Vec3& centreMm);
  void setWorkOffset(const BlockWords& words);
  void makeBaseFrame();
  void setPole(const BlockWords& words);
  void takeZero();
  void keepIncrements(base::Vec3 before);
  void addPolar(base::Vec3& point, double radiusMm, double degrees) const;

  // motion.cpp
  void executeMotion(BlockWords& words);
  void leaveOutMachineMove(const BlockWords& words);
  void moveToFixedPoint(const BlockWords& words);
  void move(BlockWords& words);
  [[nodiscard]] int motionNumber() const;
  [[nodiscard]] base::Vec3 targetOf(const BlockWords& words);
  [[nodiscard]] double coordinate(const BlockWords& words, std::size_t axis, base::Vec3 from);
  void takePolarWords(const BlockWords& words, base::Vec3 from, base::Vec3& target);
  void takePolarPlane(const BlockWords& words, base::Vec3 from, base::Vec3& target);
  void setPolar(const BlockWords& words, base::Vec3 from, base::Vec3& target);
  [[nodiscard]] Move moveOf(const BlockWords& words, base::Vec3 target);
  void takeRotary(const BlockWords& words, Move& move);
  [[nodiscard]] std::optional<double> rotaryTarget(const BlockWords& words, std::size_t axis);
  void takeBlockFeed(const BlockWords& words, base::Vec3 target, Move& move);
  void takeDirection(const BlockWords& words, Move& move);
  void noteRotary(std::size_t axis, double degrees, int column);
  void noteMissingFeed(const BlockWords& words);
  void line(base::Vec3 target, const Move& move);
  void unknownWay(base::Vec3 target, const Move& move);
  void arrive(base::Vec3 target, base::Vec3 direction, const Move& move);

  // arcs.cpp
  void moveArc(const BlockWords& words, base::Vec3 target, Move move);
  [[nodiscard]] bool isLine(const BlockWords& words) const;
  [[nodiscard]] std::optional<Arc> arcOf(const BlockWords& words, base::Vec3 target);
  [[nodiscard]] bool takeTurns(const BlockWords& words, Arc& arc);
  [[nodiscard]] ArcWords arcWordsOf(const BlockWords& words) const;
  void usePoleAsCentre(const BlockWords& words, ArcWords& given) const;
  void tellArc(const BlockWords& words, const Arc& arc, const ArcWords& given);
  [[nodiscard]] bool toMillimetres(const BlockWords& words, ArcWords& given);
  [[nodiscard]] bool startIsKnown(const BlockWords& words);
  void ignoreCentreAcross(const BlockWords& words, ArcWords& given);
  [[nodiscard]] bool reportArcProblem(const ResolvedArc& resolved, const BlockWords& words);
  void moveSpaceArc(const BlockWords& words, base::Vec3 target, const Move& move);

  // canned_cycles.cpp
  [[nodiscard]] bool takeCycleWords(const BlockWords& words);
  void runCannedCycle(const BlockWords& words);
  void drill(base::Vec3 atR, std::size_t third, double bottomMm, const BlockWords& words);

  // splines.cpp
  void selectSpline(G function);
  void takeKnot(const BlockWords& words);
  void addControlPoint(const BlockWords& words, base::Vec3 target, const Move& move);
  [[nodiscard]] double weightOf(const BlockWords& words);
  void moveBezier(const BlockWords& words, base::Vec3 target, const Move& move);
  void spline(const Spline& spline, const Move& move);

  [[nodiscard]] base::Vec3 programmed() const {
    return m_curve.end ? *m_curve.end : m_position.programmedMm;
  }
  [[nodiscard]] double lengthMm(const BlockWords& words, std::size_t axis) const {
    return words.axes.value[axis] * m_state.lengthFactor;
  }
  [[nodiscard]] bool isIncremental(const NamedWord& word) const {
    return word.reference == Reference::Incremental ||
           (m_state.relative && word.reference == Reference::Modal);
  }
  void error(const BlockWords& words, FaultCode code, std::string argument = {}) {
    m_to.faults.report(Severity::Error, words.motionColumn, code, std::move(argument));
  }

  const Language& m_language;
  const ExecutorOptions& m_options;
  Sinks m_to;
  ModalState m_state;
  Position m_position;
  BlockReader m_reader;
  bool m_pathBegun = false;  ///< X, Y or Z has moved

  struct SavedCall {
    std::unique_ptr<const SavedState> saved;
    bool restoresOnReturn = false;
  };
  std::vector<SavedCall> m_calls = std::vector<SavedCall>(1);  ///< the main program first

  /// Of G92.
  struct Offset {
    base::Vec3 mm;
    base::RotaryDeg rotaryDeg{};
  };
  /// What G10 has set of a work offset besides X, Y and Z.
  struct WorkOffset {
    double degrees = 0.0;  ///< about Z
    base::RotaryDeg rotaryDeg{};
  };
  /// G68, G51 and G51.1 of Fanuc: about a place, in the coordinates of the work offset.
  struct Change {
    base::Vec3 centreMm;
    double degrees = 0.0;  ///< in the plane
    std::size_t axis = 2;  ///< across the plane
    base::Vec3 factors{1.0, 1.0, 1.0};
  };
  std::optional<Change> m_turn;
  std::optional<Change> m_scale;
  std::optional<Change> m_mirror;
  Offset m_setOffset;
  /// For G92.3; nothing: what an earlier program has kept, which only the control knows.
  std::optional<Offset> m_keptOffset;
  base::Vec3 m_localOffsetMm;
  std::map<int, WorkOffset> m_workOffsets;  ///< by number, from 1
  int m_frameOffset = -1;                   ///< work offset that the frame is made for
  double m_polarTurnDegrees = 0.0;          ///< of the present block, where it is an increment

  /// In progress.
  struct Curve {
    Spline spline;
    std::optional<base::Vec3> end;  ///< its last control point so far
    Move move;
    int degree = 3;
    bool hasKnots = false;      ///< G6.2
    bool isClosed = false;      ///< by G5.3
    std::vector<double> knots;  ///< as far as they have been named
    double firstWeight = 1.0;   ///< of G5.2
    base::Vec3 lastTangent;     ///< P Q of the last G5
  };
  Curve m_curve;

  bool m_unitIsSaid = false;  ///< mm or inch, by the program or by who loads it

  // Findings made once.
  bool m_feedMissingReported = false;
  bool m_feedIsNamed = false;  ///< by an F of the program
  bool m_directionReported = false;
  bool m_tipReported = false;
  std::array<std::optional<double>, base::kRotaryAxisCount> m_rotaryFirst;
  std::array<bool, base::kRotaryAxisCount> m_rotaryReported{};
};

}  // namespace rivulet::nc
