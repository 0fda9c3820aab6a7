// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// LinuxCNC's stand-alone interpreter, `rs274 -g`, as a reader of programs. Its work offsets are
/// zero and its tools are T1 to T3. @threadsafety one object, one thread; several objects at once.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nc/rs274/path_reading.h"

namespace rivulet::tests {

class Rs274 {
 public:
  /// @return empty: it is not installed
  [[nodiscard]] static std::filesystem::path program();

  /// @param folder  of this object alone
  explicit Rs274(std::filesystem::path folder);
  /// A program that does not end is refused after some seconds of the processor.
  [[nodiscard]] PathReading read(std::string_view text);
  /// What it printed last, and on which line it stopped.
  [[nodiscard]] const std::string& output() const { return m_output; }

 private:
  [[nodiscard]] int run();

  std::filesystem::path m_folder;
  std::string m_output;
};

/// @param output  of `rs274`, standard output and errors together
/// @return accepted or not is not told: that says its exit code
[[nodiscard]] PathReading readCanonical(std::string_view output);

}  // namespace rivulet::tests
