// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a server has recorded of its variables. @threadsafety as the link.
/// @source OPC UA Part 11 (Historical Access), raw values; Part 4, HistoryRead
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace rivulet::opcua {

struct HistoryValue {
  std::int64_t utcNs = 0;  ///< since 1970: of the source, or else of the server
  double value = 0.0;      ///< NaN: its status is bad, or it is no number
};

struct NodeValues {
  std::vector<HistoryValue> values;  ///< in the order of the server
  std::size_t withoutTime = 0;       ///< left out
};

struct HistorySpan {
  std::int64_t fromUtcNs = 0;
  std::int64_t untilUtcNs = 0;  ///< > `fromUtcNs`
  std::size_t valuesMax = 0;    ///< more are refused
};

class NodeHistory {
 public:
  virtual ~NodeHistory() = default;
  /// Blocks until all pages of the server are read. @param address  node id in text form
  /// @return VariableMissing: no node of this address; NoHistory: it is not recorded;
  /// TooManyItems; the error of a request
  [[nodiscard]] virtual base::Result<NodeValues> history(const std::string& address,
                                                         const HistorySpan& span) = 0;
};

}  // namespace rivulet::opcua
