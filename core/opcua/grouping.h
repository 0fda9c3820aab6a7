// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Forms of reading or writing several variables. `streaming/control/access_probe` finds out which
/// of them a control understands. @threadsafety pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "opcua/variable.h"

namespace rivulet::opcua {

/// How several variables are transferred. With the array forms, consecutive R-parameters of a
/// request whose numbers ascend by one share a node. Everything else in the request has a node of
/// its own. All nodes are in one service call, in the order of the request.
enum class Grouping {
  List,        ///< all in one service call ([P1] V2)
  Single,      ///< one service call each, one after another ([P1] V1)
  ArrayCount,  ///< as List, arrays as R[u1,first,#count]
  ArrayRange,  ///< as List, arrays as R[u1,first,last]
};

[[nodiscard]] constexpr bool isArray(Grouping grouping) {
  return grouping == Grouping::ArrayCount || grouping == Grouping::ArrayRange;
}

/// "list", "single", "array-count", "array-range".
[[nodiscard]] std::string_view groupingName(Grouping grouping);
/// Inverse of `groupingName`; nothing for any other word.
[[nodiscard]] std::optional<Grouping> groupingFromName(std::string_view name);

/// How many of the variables from `first` on share its node, at least 1.
/// @param first  below the number of variables
[[nodiscard]] std::size_t sharedNodeLength(std::span<const Variable> variables, std::size_t first,
                                           Grouping grouping);

}  // namespace rivulet::opcua
