// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Writing to an open file by its descriptor, where a stream is too much: files that are appended
/// to under a lock, and recordings. Only on systems with POSIX files.
/// @threadsafety the functions share nothing.
#pragma once

#include <string_view>

namespace rivulet::base {

/// Writes all of the text, also if the system takes it in pieces or a signal interrupts.
/// @return 0 or the system's error number
[[nodiscard]] int writeWhole(int descriptor, std::string_view text);

/// Returns when what was written is on the disk. Pipes and devices refuse this, which is not an
/// error. @return 0 or the system's error number
[[nodiscard]] int syncToDisk(int descriptor);

}  // namespace rivulet::base
