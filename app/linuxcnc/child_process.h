// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Another program that is started, and lines of text exchanged with it. Nothing waits.
/// @threadsafety one object, one thread at a time.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rivulet::linuxcnc {

enum class ProcessError {
  NotStarted = 1,  ///< there is no such program, or it may not be executed
  Ended,           ///< it has ended, or does not read what it is told
};

[[nodiscard]] std::error_code make_error_code(ProcessError code);

class ChildProcess {
 public:
  /// @param words  the program (by path, or as found on PATH) and its arguments, at least one
  [[nodiscard]] static base::Result<ChildProcess> start(const std::vector<std::string>& words);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  /// Closes its input, at which it is expected to end, and ends it by SIGTERM.
  ~ChildProcess();

  /// @param line  without its end
  [[nodiscard]] base::Result<void> write(std::string_view line);
  /// The next line that has arrived. @return nothing if there is none yet
  [[nodiscard]] std::optional<std::string> readLine();
  /// Its output has been read to the end.
  [[nodiscard]] bool hasEnded() const { return m_isAtEnd && m_next == m_arrived.size(); }
  /// For `poll`: readable when more has arrived.
  [[nodiscard]] int output() const { return m_output; }

 private:
  ChildProcess(pid_t pid, int input, int output) : m_pid(pid), m_input(input), m_output(output) {}

  pid_t m_pid;
  int m_input;   ///< of the program: we write
  int m_output;  ///< of the program: we read
  std::string m_arrived;
  std::size_t m_next = 0;  ///< in `m_arrived`: everything before it has been returned
  bool m_isAtEnd = false;
};

}  // namespace rivulet::linuxcnc

template <>
struct std::is_error_code_enum<rivulet::linuxcnc::ProcessError> : std::true_type {};
