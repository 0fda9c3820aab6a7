// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The control's own trace of a run: taken in pieces while the run lasts, judged and recorded as
/// it comes. What is kept of it does not grow with the run, except its pauses.
/// @threadsafety one thread: that of the run.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/result.h"
#include "gcode/trajectory.h"
#include "opcua/link.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/pauses.h"
#include "trace/recording.h"
#include "trace/trace_piece.h"

namespace rivulet::streaming {

/// A piece of the trace is fetched this often while a run lasts, where the stream leaves time.
inline constexpr base::Duration kTraceInterval = std::chrono::seconds{2};

/// Who takes the pieces.
class TraceTaker {
 public:
  virtual ~TraceTaker() = default;
  /// Where the next piece begins.
  [[nodiscard]] virtual const trace::TracePosition& position() const = 0;
  virtual void take(const trace::TracePiece& piece) = 0;
};

/// Asks for the pieces one by one while a run lasts, if the control gives its trace in pieces. What
/// was not answered is fetched later: the run does not depend on it.
class TraceFetch {
 public:
  /// @param taker  outlives this object
  void begin(TraceTaker& taker, base::Instant first) {
    m_taker = &taker;
    m_next = first;
  }
  /// How late the next piece is; nothing: none is to be asked for now.
  [[nodiscard]] std::optional<base::Duration> lateness(base::Instant now) const;
  void ask(opcua::Link& link, base::Duration deadline);
  /// The request that has not been answered.
  [[nodiscard]] std::optional<base::RequestId> pending() const { return m_pending; }
  /// @param event  its answer; null: it failed
  void answered(const opcua::Event* event, base::Instant now);

 private:
  TraceTaker* m_taker = nullptr;  ///< null: nobody, or the control gives the trace as a whole
  std::optional<base::RequestId> m_pending;
  base::Instant m_next{};
};

/// Fetches what is left of the trace after the stream. @return the error of a request
[[nodiscard]] base::Result<void> fetchRest(opcua::Control& control, TraceTaker& taker);

/// What the trace says.
struct TraceFindings {
  bool isWhole = false;  ///< false: a part of the trace is missing, and nothing is judged
  trace::Integrity integrity;
  std::vector<trace::Pause> pauses;  ///< of the part that is there
  base::Duration duration{};         ///< from the first sample to the last; 0: there is none
  std::shared_ptr<const trace::ControlTrace> kept;  ///< the beginning
};

class RunTrace final : public TraceTaker {
 public:
  /// Samples and blocks of the beginning that the report keeps: 15 minutes at 4 ms. The recording
  /// has all of them.
  static constexpr std::size_t kKeptMax = 225'000;

  /// @param points  of the run; see `trace::IntegrityJudge`
  /// @param rotaryAxes  those that are streamed
  /// @param writer  null: nothing is recorded
  /// @param isOfRun  which blocks are judged and recorded; empty: all of them
  RunTrace(const std::vector<gcode::StreamPoint>& points, const base::RotarySet& rotaryAxes,
           trace::PointsOfRun known, trace::RecordingWriter* writer,
           std::function<bool(const trace::ExecutedBlock&)> isOfRun = {})
      : m_judge(points, rotaryAxes, known), m_writer(writer), m_isOfRun(std::move(isOfRun)) {}

  [[nodiscard]] const trace::TracePosition& position() const override { return m_position; }
  void take(const trace::TracePiece& piece) override;
  /// Found so far, in time order.
  [[nodiscard]] const std::vector<trace::Pause>& pauses() const { return m_pauses; }
  /// Nothing more comes, and all points are known. To be called once.
  [[nodiscard]] TraceFindings finish();

 private:
  void judge(const trace::ControlTrace& records);
  void keepBeginning(const trace::ControlTrace& records);

  trace::RunJudge m_judge;
  trace::RecordingWriter* m_writer;
  std::function<bool(const trace::ExecutedBlock&)> m_isOfRun;
  trace::TracePosition m_position;
  trace::PauseFinder m_finder;
  std::vector<trace::Pause> m_pauses;
  std::optional<base::Instant> m_first;
  base::Instant m_last{};
  trace::ControlTrace m_kept;
  bool m_isBegun = false;
  bool m_hasBlocks = false;  ///< of the run or not
  bool m_isTruncated = false;
};

}  // namespace rivulet::streaming
