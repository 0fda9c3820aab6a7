// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Passes on what a run tells, and keeps what its report and its recording need.
/// @threadsafety one thread.
#pragma once

#include <functional>

#include "streaming/run/driver.h"
#include "streaming/run/run.h"
#include "trace/analysis/statistics.h"
#include "trace/recording.h"

namespace rivulet::streaming {

class Ledger final : public RunSink {
 public:
  /// @param writer  null: nothing is recorded
  Ledger(RunSink& next, trace::RecordingWriter* writer) : m_next(next), m_writer(writer) {}

  void update(const LiveUpdate& update) override;
  void access(const trace::Access& access) override;
  void note(const trace::Note& note) override;
  void granted() override;

  std::function<void()> onGranted;

  [[nodiscard]] AccessStatistics statistics() const;

 private:
  RunSink& m_next;
  trace::RecordingWriter* m_writer;
  trace::DurationCounter m_requests;
  trace::DurationCounter m_perNode;
  std::size_t m_nodes = 0;
};

/// The settings of a run, for its recording. @param known  tool version, endpoint and time
[[nodiscard]] trace::RunStart runStartOf(trace::RunStart known, const RunSettings& settings,
                                         const gcode::Program& program);

}  // namespace rivulet::streaming
