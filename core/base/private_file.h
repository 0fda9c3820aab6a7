// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Files and folders that only this user may read. @threadsafety reads and writes files; the
/// functions share nothing.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/result.h"

namespace rivulet::base {

/// Mode of such a file.
inline constexpr int kPrivateFileMode = 0600;

/// Makes the folder and those above it that are missing, mode 0700. Others lose their rights on a
/// folder that is there already. @return NotWritable
[[nodiscard]] Result<void> makePrivateFolder(const std::filesystem::path& folder);

/// As `writeFile`, but nobody else may read the file, whatever its rights were.
[[nodiscard]] Result<void> writePrivateFile(const std::filesystem::path& path,
                                            std::string_view text);

/// Nobody but the owner may read the file; so too if there is none. On Windows, where the rights of
/// a file are those of its folder, this is taken for granted.
[[nodiscard]] bool isForOwnerAlone(const std::filesystem::path& path);

}  // namespace rivulet::base
