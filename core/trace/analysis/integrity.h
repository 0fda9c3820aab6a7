// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The independent oracle: was each point executed exactly once, in order? It uses only what the
/// control executed and the list of points. It knows nothing of methods and slots, nor of the
/// client's view. @threadsafety pure.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/axes.h"
#include "base/id.h"
#include "gcode/trajectory.h"
#include "trace/control_trace.h"

namespace rivulet::trace {

/// The first faults, for the log and the path view.
struct IntegrityFault {
  enum class Kind { Repeated, Skipped, Foreign, OutOfOrder } kind = Kind::Repeated;
  base::PointIndex point;  ///< the point repeated, skipped or out of order; for Foreign the one due
  base::Instant at{};      ///< begin of the block; for Skipped of the first block of a later point
};

struct Integrity {
  bool judged = false;       ///< false: no trace of the control was available
  std::size_t executed = 0;  ///< points executed at least once
  std::size_t repeated = 0;  ///< executions beyond the first that moved an axis
  std::size_t skipped = 0;   ///< points never executed although a later one was
  std::size_t foreign = 0;   ///< moving blocks whose end is not a point of the program
  /// Points executed at the wrong place: the fewest that have to be left out so that the first
  /// executions of all others are in program order.
  std::size_t outOfOrder = 0;
  std::vector<IntegrityFault> faults;  ///< at most 100, in time order

  /// Nothing repeated, skipped, foreign or out of order. Whether the run was complete is told by
  /// `executed`: a run that was stopped in the middle is faultless too.
  [[nodiscard]] bool isFaultless() const {
    return judged && repeated + skipped + foreign + outOfOrder == 0;
  }
};

/// Judges what was executed. A block that moves nothing (1e-9 mm, 1e-9 deg) is not an execution,
/// unless the axes are at the point due: then it executes that point. If several points of the
/// program coincide, a block is assigned to the point due; if that does not fit, to the point that
/// the following blocks indicate. O(blocks) for a faultless run; otherwise the points are sorted
/// once and each fault costs O(log(points)).
/// @param points  in program order, finite, workpiece frame
/// @param blocks  in time order; all of them: a truncated trace cannot be judged
/// @param toleranceMm  how far a block's end may be from its point (numbers in R-parameters are
///        doubles: 1e-6 suffices for the virtual machine); for angles as many degrees
/// @param rotaryAxes  those that were streamed: their angles have to be right too
[[nodiscard]] Integrity judgeIntegrity(const std::vector<gcode::StreamPoint>& points,
                                       const std::vector<ExecutedBlock>& blocks, double toleranceMm,
                                       const base::RotarySet& rotaryAxes = {});

/// Whether all points are known when the first block is judged.
enum class PointsOfRun {
  Known,
  Growing,  ///< a live run: a block that does not fit waits for `finish`
};

/// The same judgement while the run lasts: blocks in pieces of any size. Bounded memory until the
/// first fault.
class IntegrityJudge {
 public:
  /// @param points  as for `judgeIntegrity`; must outlive the judge, and may grow if `known` says
  /// so
  IntegrityJudge(const std::vector<gcode::StreamPoint>& points, double toleranceMm,
                 const base::RotarySet& rotaryAxes, PointsOfRun known);
  ~IntegrityJudge();
  IntegrityJudge(const IntegrityJudge&) = delete;
  IntegrityJudge& operator=(const IntegrityJudge&) = delete;

  /// The next blocks, in time order.
  void add(std::span<const ExecutedBlock> blocks);
  /// The judgement of all of them. To be called once, when all points are known.
  [[nodiscard]] Integrity finish();

 private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

/// R-parameters are doubles on both sides: a point arrives as it was sent. A thousandth of a
/// micrometre leaves room for a control that rounds its display values.
inline constexpr double kPointToleranceMm = 1e-6;

/// The judgement of a run from the control's trace, for the run itself and for its recording alike.
/// A trace of which a part is missing is not judged. A trace without blocks is judged by its set
/// points (`path_match`), to its tolerance; not if rotary axes were streamed, nor if its samples
/// are too far apart to show each point, or show other motion, too (`hasOwnBlocksOnly`). Such a
/// trace is kept until the end; of all others only what `IntegrityJudge` needs.
class RunJudge {
 public:
  /// @param points  see `IntegrityJudge`
  RunJudge(const std::vector<gcode::StreamPoint>& points, const base::RotarySet& rotaryAxes,
           PointsOfRun known);

  /// The next part of the trace.
  void add(const ControlTrace& piece);
  /// To be called once, when all points are known.
  [[nodiscard]] Integrity finish();

 private:
  const std::vector<gcode::StreamPoint>& m_points;
  bool m_bySamples;
  IntegrityJudge m_blocks;
  ControlTrace m_withoutBlocks;
  bool m_hasBlocks = false;
  bool m_hasSamples = false;
  bool m_isTruncated = false;
};

/// The same of a whole trace.
[[nodiscard]] Integrity judgeRun(const std::vector<gcode::StreamPoint>& points,
                                 const ControlTrace& trace, const base::RotarySet& rotaryAxes);

}  // namespace rivulet::trace
