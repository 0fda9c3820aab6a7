// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The file of releases (docs/formats.md), which is only appended to: window and services share it.
/// @threadsafety reads and writes files; shares nothing.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "permission/permission.h"

namespace rivulet::preparation {

/// "releases.jsonl" in the folder of what is kept.
[[nodiscard]] std::filesystem::path releaseFileIn(const std::filesystem::path& folder);

/// In the order in which they were made; lines that are none are left out. A file that does not
/// exist has none. @return Unreadable
[[nodiscard]] base::Result<std::vector<permission::Release>> readReleases(
    const std::filesystem::path& path);
/// @return NotWritable
[[nodiscard]] base::Result<void> appendRelease(const std::filesystem::path& path,
                                               const permission::Release& release);

}  // namespace rivulet::preparation
