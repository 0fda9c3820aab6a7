// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The history of alarms on disk: one JSON object per line (docs/formats.md). Bounded: the file and
/// one older file. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>
#include <vector>

#include "alarm/alarm_list.h"
#include "base/result.h"

namespace rivulet::journal {

class AlarmHistory {
 public:
  static constexpr std::uintmax_t kFileBytesMax = std::uintmax_t{1} << 20U;

  /// @param folder  empty: nothing is kept
  explicit AlarmHistory(std::filesystem::path folder = {});

  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  [[nodiscard]] bool isKept() const { return !m_path.empty(); }
  /// @return NotWritable
  [[nodiscard]] base::Result<void> append(const alarm::Transition& transition) const;

  struct Content {
    std::vector<alarm::Transition> transitions;  ///< the oldest first
    std::size_t dropped = 0;                     ///< lines that are cut or damaged
  };
  /// The error code of a kind ("opcua") and value; clear if it is not known.
  using CodeOf = std::function<std::error_code(std::string_view kind, int value)>;
  /// @return Unreadable
  [[nodiscard]] base::Result<Content> read(const CodeOf& codeOf = {}) const;

 private:
  std::filesystem::path m_path;
};

/// Alarms that nobody had acknowledged when the history ends.
[[nodiscard]] std::vector<alarm::Alarm> unacknowledged(
    const std::vector<alarm::Transition>& transitions);

}  // namespace rivulet::journal
