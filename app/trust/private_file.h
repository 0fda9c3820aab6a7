// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Files that nobody but their owner may read. @threadsafety reads and writes files; shares
/// nothing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace rivulet::trust {

/// A new file of mode 0600. @return NotWritable, also if the file exists
[[nodiscard]] base::Result<void> writePrivateFile(const std::filesystem::path& path,
                                                  std::string_view bytes);

/// @return Unreadable, also if others may read the file
[[nodiscard]] base::Result<std::string> readPrivateFile(const std::filesystem::path& path);

}  // namespace rivulet::trust
