// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads what an MTConnect agent has kept, page by page, as one text that `trace::importTrace`
/// reads: the description, the state at the beginning, and all pages. @threadsafety one thread.
/// @source MTConnect Standard, Part 1: requests probe, current and sample; sequence numbers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/budget.h"
#include "base/result.h"
#include "trace_fetch/http.h"

namespace rivulet::trace_fetch {

/// "http://host:5000/device/sample?path=//Linear&from=100&count=500".
struct AgentAddress {
  std::string base;                   ///< "http://host:5000/device"
  std::string path;                   ///< XPath as it stands in the address; empty: all items
  std::optional<std::uint64_t> from;  ///< the first sequence number; nothing: the oldest
  std::uint64_t count = 10'000;       ///< observations per page, >= 1
};

[[nodiscard]] bool isAgentAddress(std::string_view text);
/// @return error BadAddress: a user or password in it, or a parameter that makes no pages
[[nodiscard]] base::Result<AgentAddress> parseAgentAddress(std::string_view text);

/// How long a recording goes on after what the agent has kept.
class RecordingTime {
 public:
  virtual ~RecordingTime() = default;
  [[nodiscard]] virtual bool isOver() = 0;
  /// Until there may be more.
  virtual void wait() = 0;
};

/// @param time    null: only what the agent has kept when it is asked
/// @param budget  of the text; what is made of it comes beside
/// @return error ImportError::AgentRefused: with the words of the agent; errors of `HttpReader`;
/// WrongAnswer; BudgetError::Exceeded
[[nodiscard]] base::Result<std::string> fetchFromAgent(const AgentAddress& address,
                                                       HttpReader& http, RecordingTime* time,
                                                       const base::Budget& budget);

}  // namespace rivulet::trace_fetch
