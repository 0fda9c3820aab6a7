// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whole files in and out, for traces and recordings. @threadsafety reads and writes files; the
/// functions share nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace rivulet::trace {

/// Larger files are refused instead of filling the memory.
inline constexpr std::uintmax_t kFileBytesMax = std::uintmax_t{2} << 30;

/// @return error FileUnreadable: missing, a folder, no permission, larger than `kFileBytesMax`
[[nodiscard]] base::Result<std::string> readFile(const std::filesystem::path& path);

/// Replaces the file as a whole: the text goes to a temporary file in the same folder, which then
/// takes the file's name. Whatever happens, the file holds the old or the new text, never a part.
/// Anything but an ordinary file (a device, a pipe) is written to directly.
/// @return error FileNotWritable; an existing file is then unchanged
[[nodiscard]] base::Result<void> writeFile(const std::filesystem::path& path,
                                           std::string_view text);

}  // namespace rivulet::trace
