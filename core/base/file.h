// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whole files in and out. @threadsafety reads and writes files; the functions share nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "base/budget.h"
#include "base/result.h"

namespace rivulet::base {

enum class FileError {
  Unreadable = 1,
  NotWritable,
};

[[nodiscard]] std::error_code make_error_code(FileError code);

/// A device without an end is not read farther than the budget either.
/// @return error Unreadable: missing, a folder, no permission; BudgetError::Exceeded
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path,
                                           const Budget& budget = {});
/// A file of a kind that is never larger than `bytesMax`. @return error Unreadable, also if it is
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path,
                                           std::uintmax_t bytesMax);

/// Replaces the file as a whole: the text goes to a temporary file in the same folder, which then
/// takes the file's name. Whatever happens, the file holds the old or the new text, never a part. A
/// temporary file that a killed program left makes room for the next one.
/// When it returns, the text survives a loss of power. Anything but an ordinary file (a device, a
/// pipe) is written to directly.
/// @return error NotWritable; an existing file is then unchanged
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace rivulet::base

template <>
struct std::is_error_code_enum<rivulet::base::FileError> : std::true_type {};
