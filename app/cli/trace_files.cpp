// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/trace_files.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/file.h"
#include "base/utc.h"
#include "cli/connection.h"
#include "opcua/control_map.h"
#include "opcua/error.h"
#include "trace/import/import.h"
#include "trace_fetch/agent.h"
#include "trace_fetch/history.h"

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

base::Result<trace_fetch::HistoryRequest> historyOf(const AnalyseOptions& options) {
  trace_fetch::HistoryRequest request;
  for (const std::string& text : options.nodes) {
    auto node = trace_fetch::parseHistoryNode(text);
    if (!node) {
      return base::fail(node.error());
    }
    request.nodes.push_back(std::move(*node));
  }
  const auto from = base::utcOfText(options.since);
  const auto until = base::utcOfText(options.to);
  if (request.nodes.empty() || !from || !until || *from >= *until) {
    return base::fail(trace_fetch::FetchError::BadAddress,
                      "The history of an OPC UA server needs --node NAME=NODE, and --since and "
                      "--to with times such as 2026-01-02T03:04:05Z, the first one earlier.");
  }
  request.from = *from;
  request.until = *until;
  return request;
}

base::Result<trace::Trace> openHistory(const std::string& endpoint, const AnalyseOptions& options) {
  const auto request = historyOf(options);
  if (!request) {
    return base::fail(request.error());
  }
  const auto mapping = trace::parseTableMapping(options.columns);
  if (!mapping) {
    return base::fail(mapping.error());
  }
  // It need not be a control: no variable of one is looked for.
  const auto connection = connectTo(endpoint, std::make_shared<opcua::ControlMap>());
  if (!connection) {
    return base::fail(connection.error());
  }
  if (connection->history == nullptr) {
    return base::fail(opcua::LinkError::NoHistory, "This link reads no history. Leave out --link.",
                      endpoint);
  }
  auto signalTrace = trace_fetch::fetchHistory(*connection->history, *request, memoryBudget());
  if (!signalTrace) {
    return base::fail(signalTrace.error());
  }
  auto imported = trace::importSignals(std::move(*signalTrace), *mapping);
  return imported ? base::Result<trace::Trace>(trace::Trace(std::move(*imported)))
                  : base::fail(imported.error());
}

}  // namespace

base::Result<trace::Trace> openTrace(const std::string& file, const AnalyseOptions& options) {
  auto trace = trace_fetch::isAgentAddress(file) ? openAgent(file, options)
               : trace_fetch::isOpcUaAddress(file)
                   ? openHistory(file, options)
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
