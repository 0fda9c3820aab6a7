// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What others write while this program does something else: a pipe, a file that grows, standard
/// input. Asking never waits. @threadsafety one descriptor, one thread.
#pragma once

#include <cstddef>
#include <span>

namespace rivulet::platform {

inline constexpr int kStandardInput = 0;

/// What a read that does not wait has brought.
struct Input {
  std::size_t bytes = 0;
  bool isAtEnd = false;   ///< now; a file may grow, and a pipe get another writer
  bool isBroken = false;  ///< it cannot be read
};

/// Standard input may be shared with other programs: its mode is left as it is.
[[nodiscard]] Input readNow(int descriptor, std::span<char> into);

/// Standard input is a pipe, a file or a socket, not a terminal or nothing.
[[nodiscard]] bool isInputFed();

}  // namespace rivulet::platform
