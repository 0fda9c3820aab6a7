// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds code that reads memory of the stack which it has never written.
/// @threadsafety the stack of the caller's thread.
#pragma once

#include <algorithm>
#include <array>

namespace rivulet::tests {

/// Fills what lies below the caller's frame: the next functions find no memory that was cleared.
[[gnu::noinline]] inline void soilStack() {
  std::array<volatile char, 64 * 1024> dirt;
  std::fill(dirt.begin(), dirt.end(), 0x5a);
}

}  // namespace rivulet::tests
