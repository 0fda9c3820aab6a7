// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What every link over the network does with a request before it is sent, whichever library
/// carries it. @threadsafety pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/instant.h"
#include "opcua/error.h"
#include "opcua/link.h"

namespace rivulet::opcua {

/// Largest number of variables of one request, as the control's server accepts.
inline constexpr std::size_t kItemsMax = 1000;

/// Assignments as links keep them.
struct Targets {
  std::vector<Variable> variables;
  std::vector<double> values;  ///< one per variable
};
[[nodiscard]] Targets targetsOf(std::span<const Assignment> assignments);

enum class Operation { Read, Write, Call };

/// One request of the caller while it is on its way; its service calls are made from the front of
/// the item list on.
struct PendingRequest {
  base::RequestId id;
  Operation operation = Operation::Read;
  Grouping grouping = Grouping::List;
  std::vector<Variable> variables;
  std::vector<double> values;                ///< Write: one per variable
  std::string path;                          ///< Call: of the program to be stored
  std::string text;                          ///< Call
  std::optional<trace::TracePosition> from;  ///< Call: for the trace, not for a program
  base::Instant deadline{};
  std::uint64_t serial = 0;   ///< of the service call in progress; 0 none
  std::size_t itemsSent = 0;  ///< Call: 1
  std::uint32_t failure = 0;  ///< status code of OPC UA; 0 none
  Event event;                ///< grows with every answer
  bool done = false;

  [[nodiscard]] bool isSent() const {
    return itemsSent == (operation == Operation::Call ? 1 : variables.size());
  }
};

/// A request without its subject. Its event is ReadDone or WriteDone, unless the caller says
/// otherwise.
/// @param deadline  from `sent` on
[[nodiscard]] PendingRequest newRequest(base::RequestId id, Operation operation, base::Instant sent,
                                        base::Duration deadline);

/// Why a request is not sent at all: TooManyItems; BadValue for a value that is not finite.
/// @param values  of a request to write
[[nodiscard]] std::optional<LinkError> requestFault(std::span<const Variable> variables,
                                                    std::span<const double> values);

/// A request that nobody answered until its deadline. @param at  when the client gives up
[[nodiscard]] Event unanswered(base::RequestId id, base::Instant sent, base::Instant at);

/// The end of a time that may be `Duration::max`.
[[nodiscard]] base::Instant addSaturating(base::Instant instant, base::Duration duration);

}  // namespace rivulet::opcua
