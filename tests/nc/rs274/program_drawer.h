// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Draws programs for LinuxCNC. Most are valid, with words of every group; a few contain what
/// LinuxCNC refuses. A program ends in a bounded number of steps. @threadsafety pure.
#pragma once

#include <cstdint>
#include <string>

namespace rivulet::tests {

/// @param seed, number  the same program for the same two
[[nodiscard]] std::string drawProgram(std::uint64_t seed, std::uint64_t number);

}  // namespace rivulet::tests
