// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Index types that cannot be mixed up.
#pragma once

#include <compare>
#include <cstdint>

namespace rivulet::base {

/// A number with a meaning. `Id<A>` and `Id<B>` do not convert into each other.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  friend constexpr auto operator<=>(const Id&, const Id&) = default;
  constexpr Id& operator++() {
    ++value;
    return *this;
  }
};

using LineNumber = Id<struct LineNumberTag>;  ///< line of an NC program file, from 1; 0 = none
using PointIndex = Id<struct PointIndexTag>;  ///< index into a list of points, from 0
using RequestId = Id<struct RequestIdTag>;    ///< one OPC UA request of a link, from 1

}  // namespace rivulet::base
