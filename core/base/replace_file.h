// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How `writeFile` and `writePrivateFile` replace a file as a whole; each system has a way of its
/// own. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/result.h"

namespace rivulet::base {

/// @param isPrivate  nobody else may read it; else it keeps the rights of the file before
/// @return NotWritable
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& requested,
                                       std::string_view text, bool isPrivate);

}  // namespace rivulet::base
