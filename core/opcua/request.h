// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What every link over the network does with a request before it is sent, whichever library
/// carries it. @threadsafety pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
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

/// Why a request is not sent at all: TooManyItems; BadValue for a value that is not finite.
/// @param values  of a request to write
[[nodiscard]] std::optional<LinkError> requestFault(std::span<const Variable> variables,
                                                    std::span<const double> values);

/// The end of a time that may be `Duration::max`.
[[nodiscard]] base::Instant addSaturating(base::Instant instant, base::Duration duration);

}  // namespace rivulet::opcua
