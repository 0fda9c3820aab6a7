// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The control's own trace of one run: taken in pieces while the run lasts, judged and recorded as
/// it comes. What is kept of it does not grow with the run, except its pauses.
/// @threadsafety one thread: that of the run.
#pragma once

#include <optional>
#include <vector>

#include "gcode/trajectory.h"
#include "streaming/run.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/pauses.h"
#include "trace/recording.h"
#include "trace/trace_piece.h"

namespace rivulet::streaming {

class RunTrace {
 public:
  /// Samples and blocks of the beginning that the report keeps: 15 minutes at 4 ms. The recording
  /// has all of them.
  static constexpr std::size_t kKeptMax = 225'000;

  /// @param points  of the run; see `trace::IntegrityJudge`
  /// @param rotaryAxes  those that are streamed
  /// @param writer  null: nothing is recorded
  RunTrace(const std::vector<gcode::StreamPoint>& points, const base::RotarySet& rotaryAxes,
           trace::PointsOfRun known, trace::RecordingWriter* writer)
      : m_judge(points, rotaryAxes, known), m_writer(writer) {}

  /// Where the next piece begins.
  [[nodiscard]] const trace::TracePosition& position() const { return m_position; }
  void take(const trace::TracePiece& piece);
  /// Nothing more comes, and all points are known: integrity, trace, and of a whole trace pauses
  /// and duration. To be called once.
  /// @return false if a part of the trace is missing: the run is not judged
  bool finish(RunReport& report);

 private:
  trace::RunJudge m_judge;
  trace::RecordingWriter* m_writer;
  trace::TracePosition m_position;
  trace::PauseFinder m_finder;
  std::vector<trace::Pause> m_pauses;
  std::optional<base::Instant> m_first;
  base::Instant m_last{};
  trace::ControlTrace m_kept;
  bool m_isBegun = false;
  bool m_isTruncated = false;
};

}  // namespace rivulet::streaming
