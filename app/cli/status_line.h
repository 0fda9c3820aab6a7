// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far the work is, in the last line of a terminal.

#pragma once

#include <mutex>
#include <string>

namespace rivulet::cli {

/// Whether somebody reads standard error on a terminal.
[[nodiscard]] bool isTerminal();

/// A line on a terminal that the next one replaces; nothing in a pipe or a file.
/// @threadsafety any thread
class StatusLine {
 public:
  StatusLine() = default;
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// The same text once more is not written again.
  void show(const std::string& text);
  void clear();

 private:
  std::mutex m_mutex;
  std::string m_text;
};

/// Writes a message to standard error; a line that is shown there makes way.
void sayOverStatus(const std::string& message);

}  // namespace rivulet::cli
