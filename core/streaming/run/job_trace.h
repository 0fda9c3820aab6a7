// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the control's own trace of a whole job says of its stretches. The main program never moves
/// in a line in which the loop moves, so the line of a block tells who moved. It is taken in pieces
/// like that of a run. @threadsafety one thread: that of the job.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "gcode/trajectory.h"
#include "streaming/run/run_trace.h"
#include "templates/job_loop.h"
#include "trace/analysis/tool_use.h"
#include "trace/control_trace.h"
#include "trace/pause.h"

namespace rivulet::streaming {

/// Standstills within stretches, not those of native blocks and of the change between the two. Its
/// memory grows with the pauses and with what the control does between stretches, not with the
/// time.
class StretchPauses {
 public:
  /// @param loop  must outlive it
  explicit StretchPauses(const templates::JobLoop& loop) : m_loop(loop) {}

  /// The next part of the trace, with all its blocks.
  /// @param pauses  all that were found up to the end of this part
  void add(const trace::ControlTrace& piece, const std::vector<trace::Pause>& pauses);
  /// In time order. To be called once.
  [[nodiscard]] std::vector<trace::Pause> finish();

 private:
  struct Move {
    base::Instant to{};
    bool isStreamed = false;
  };
  void dropMovesBefore(base::Instant at);

  const templates::JobLoop& m_loop;
  base::Instant m_latest{};            ///< time of the last sample
  std::deque<Move> m_moves;            ///< from the last one that ended before what is not settled
  std::size_t m_settled = 0;           ///< pauses; of the next one the next move is not known yet
  std::vector<trace::Pause> m_within;  ///< between two streamed blocks
  std::vector<trace::ControlEvent> m_between;
};

/// The trace of a whole job: of all blocks the streamed ones are judged and recorded.
class JobTrace final : public TraceTaker {
 public:
  /// @param points  of the stretches that have begun; they grow  @param loop  must outlive it
  /// @param writer  null: nothing is recorded
  JobTrace(const std::vector<gcode::StreamPoint>& points, const templates::JobLoop& loop,
           trace::RecordingWriter* writer);

  [[nodiscard]] const trace::TracePosition& position() const override { return m_run.position(); }
  void take(const trace::TracePiece& piece) override;
  /// Nothing more comes. The pauses are those in stretches. To be called once.
  [[nodiscard]] TraceFindings finish();
  /// To be called once.
  [[nodiscard]] std::vector<trace::ToolUse> tools() { return m_tools.finish(); }

 private:
  RunTrace m_run;
  StretchPauses m_pauses;
  trace::ToolUseFinder m_tools;
};

}  // namespace rivulet::streaming
