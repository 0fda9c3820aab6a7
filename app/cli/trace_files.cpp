// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/trace_files.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/file.h"
#include "trace_fetch/agent.h"

namespace rivulet::cli {

namespace {

/// So often an agent is asked for what is new.
constexpr auto kAgentInterval = std::chrono::milliseconds{500};

class SecondsFromNow final : public trace_fetch::RecordingTime {
 public:
  explicit SecondsFromNow(double seconds)
      : m_end(std::chrono::steady_clock::now() +
              std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                  std::chrono::duration<double>(seconds))) {}

  [[nodiscard]] bool isOver() override { return std::chrono::steady_clock::now() >= m_end; }
  void wait() override {
    std::this_thread::sleep_until(
        std::min(m_end, std::chrono::steady_clock::now() + kAgentInterval));
  }

 private:
  std::chrono::steady_clock::time_point m_end;
};

base::Result<trace::Trace> openAgent(const std::string& url, const AnalyseOptions& options) {
  const auto address = trace_fetch::parseAgentAddress(url);
  if (!address) {
    return base::fail(address.error());
  }
  const auto http = trace_fetch::makeHttpReader({});
  if (!http) {
    return base::fail(http.error());
  }
  SecondsFromNow time(options.recordS);
  const auto text = trace_fetch::fetchFromAgent(
      *address, **http, options.recordS > 0.0 ? &time : nullptr, memoryBudget());
  if (!text) {
    return base::fail(text.error());
  }
  // Before it is read: what was recorded cannot be recorded again.
  if (!options.keep.empty()) {
    if (auto done = base::writeFile(options.keep, *text); !done) {
      return base::fail(done.error());
    }
  }
  return report::openTraceBytes(*text, url, options.columns, options.rateHz, memoryBudget());
}

}  // namespace

base::Result<trace::Trace> openTrace(const std::string& file, const AnalyseOptions& options) {
  auto trace = trace_fetch::isAgentAddress(file)
                   ? openAgent(file, options)
                   : report::openTrace(file, options.columns, options.rateHz, memoryBudget());
  return trace && options.hasWindow() ? trace->cut(options.fromS, options.untilS) : trace;
}

trace::AnalysisOptions analysisOf(const AnalyseOptions& options, const gcode::Program* program) {
  trace::AnalysisOptions analysis;
  analysis.program = program;
  if (options.toleranceMm > 0.0) {
    analysis.toleranceMm = options.toleranceMm;
  }
  return analysis;
}

}  // namespace rivulet::cli
