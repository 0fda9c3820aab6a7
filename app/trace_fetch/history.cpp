// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_fetch/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/control_trace.h"
#include "trace_fetch/http.h"

namespace rivulet::trace_fetch {

namespace {

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr std::int64_t kNsPerDay = 86'400'000 * kNsPerMs;
/// Of a value, as it comes and as a signal with its time, in lists that grow.
constexpr std::size_t kValueBytes = 4 * (sizeof(double) + sizeof(std::int64_t));

/// Values in the order of their time, each time once: the last one that the server names.
/// @return how many had the time of another one
std::size_t sortByTime(std::vector<opcua::HistoryValue>& values) {
  std::stable_sort(values.begin(), values.end(),
                   [](const auto& a, const auto& b) { return a.utcNs < b.utcNs; });
  std::vector<opcua::HistoryValue> kept;
  for (const opcua::HistoryValue& value : values) {
    if (!kept.empty() && kept.back().utcNs == value.utcNs) {
      kept.back() = value;
    } else {
      kept.push_back(value);
    }
  }
  const std::size_t same = values.size() - kept.size();
  values = std::move(kept);
  return same;
}

}  // namespace

bool isOpcUaAddress(std::string_view text) {
  return text.starts_with("opc.tcp://");
}

base::Result<HistoryNode> parseHistoryNode(std::string_view text) {
  const std::size_t equal = text.find('=');
  const HistoryNode node{std::string(text.substr(0, equal)),
                         std::string(text.substr(std::min(equal, text.size() - 1) + 1))};
  if (equal == std::string_view::npos || node.name.empty() || node.address.find('=') == 0 ||
      node.address.find('=') == std::string::npos || node.name == "ns" || node.name == "nsu") {
    return base::fail(FetchError::BadAddress,
                      fmt::format("\"{}\" names no node. Write NAME=NODE, such as "
                                  "x_act=ns=2;s=Axis.X.",
                                  text));
  }
  return node;
}

base::Result<trace::SignalTrace> fetchHistory(opcua::NodeHistory& server,
                                              const HistoryRequest& request,
                                              const base::Budget& budget) {
  trace::SignalTrace trace;
  trace.format = "OPC UA history";
  std::size_t held = 0;
  std::size_t sameTime = 0;
  for (const HistoryNode& node : request.nodes) {
    const opcua::HistorySpan span{
        request.from * kNsPerMs, request.until * kNsPerMs,
        budget.without(held).items(kValueBytes + trace::kAnalysedSampleBytes)};
    auto read = server.history(node.address, span);
    if (!read) {
      return base::fail(read.error());
    }
    // What lies far outside was not asked for: a clock that was wrong would stretch the trace.
    read->withoutTime += std::erase_if(read->values, [&span](const opcua::HistoryValue& one) {
      return one.utcNs < span.fromUtcNs - kNsPerDay || one.utcNs > span.untilUtcNs + kNsPerDay;
    });
    held += read->values.size() * (kValueBytes + trace::kAnalysedSampleBytes);
    sameTime += sortByTime(read->values);
    if (read->withoutTime > 0) {
      trace.remarks.push_back({trace::RemarkCode::UnreadableObservations,
                               {std::to_string(read->withoutTime), node.name}});
    }
    const bool isEmpty =
        std::none_of(read->values.begin(), read->values.end(),
                     [](const opcua::HistoryValue& one) { return std::isfinite(one.value); });
    if (isEmpty) {
      trace.remarks.push_back({trace::RemarkCode::ItemsUnavailable, {"1", node.name}});
      continue;
    }
    trace::Signal signal{node.name, {}, trace.timeBases.size(), {}};
    trace::TimeBase base{"time", {}};
    for (const opcua::HistoryValue& one : read->values) {
      base.at.push_back(base::Instant{base::Duration{one.utcNs}});
      signal.values.push_back(one.value);
    }
    trace.timeBases.push_back(std::move(base));
    trace.signalList.push_back(std::move(signal));
  }
  if (trace.signalList.empty()) {
    return base::fail(FetchError::WrongAnswer,
                      fmt::format("The server has recorded no values of these nodes between {} "
                                  "and {}. Choose another time.",
                                  base::utcText(request.from), base::utcText(request.until)));
  }
  if (sameTime > 0) {
    trace.remarks.push_back({trace::RemarkCode::ValuesAtOnce, {std::to_string(sameTime)}});
  }
  if (trace.signalList.size() > 1) {
    trace.remarks.push_back({trace::RemarkCode::SparseRows});
  }
  return trace;
}

}  // namespace rivulet::trace_fetch
