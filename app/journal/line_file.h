// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Files of lines that are only appended to: the audit trail and the history of alarms. Several
/// programs may append to one file. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rivulet::journal {

/// Below $XDG_STATE_HOME, or ~/.local/state: what has to survive the end of the program.
[[nodiscard]] std::filesystem::path stateFolderOfUser();

struct Lines {
  std::vector<std::string> lines;  ///< without their ends
  bool isCut = false;              ///< a last line without an end was left out
};

/// The text at `key` of a line that is JSON; empty if there is none.
[[nodiscard]] std::string textOf(const nlohmann::ordered_json& line, const char* key);

/// A file that does not exist has no lines. @return Unreadable
[[nodiscard]] base::Result<Lines> readLines(const std::filesystem::path& path);

/// Makes the next line from the last complete one (empty: there is none).
using MakeLine = std::function<std::string(std::string_view last)>;

/// A line that is on the disk, and the file around it.
struct Appended {
  std::string_view line;
  std::string_view last;  ///< the complete line before it; empty: there is none
  std::uintmax_t bytesBefore = 0;
  std::uintmax_t bytesAfter = 0;
};
using LineDone = std::function<base::Result<void>(const Appended& appended)>;

/// Appends a line, and returns when it is on the disk. Nobody else appends meanwhile. A line that
/// was cut before stays as it is; the new one begins after it. The folder and the file (mode 0600)
/// are made if they are missing.
/// @param bytesMax  a file of this size becomes `path`.1, in place of an older one, before the line
///                  is written; 0: never
/// @param done  called before anybody else may append. May be empty
/// @return NotWritable; what `done` returns
[[nodiscard]] base::Result<void> appendLine(const std::filesystem::path& path, const MakeLine& make,
                                            std::uintmax_t bytesMax = 0, const LineDone& done = {});

}  // namespace rivulet::journal
