// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a flexible program moves on without stopping: what a recording stores of the program on
/// the control, so that a stop can be told to be its STOPRE. @threadsafety pure.
#pragma once

#include <string_view>
#include <vector>

#include "base/continuation.h"

namespace rivulet::templates {

/// Finds all pairs of motion blocks (G1) of which the second can follow the first without a STOPRE
/// between them, by lines, jumps and labels. Between all other pairs the axes stop. Ascending.
/// @param program  text of a flexible program  @return empty: it has no STOPRE or no motion
[[nodiscard]] std::vector<base::Continuation> continuationsOf(std::string_view program);

}  // namespace rivulet::templates
