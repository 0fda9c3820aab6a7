// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The terminal, if a person sits at one. @threadsafety main thread.
#pragma once

#include <memory>
#include <string>

namespace rivulet::platform {

/// Standard input comes from a keyboard.
[[nodiscard]] bool isInputTerminal();
/// Somebody reads standard error on a terminal.
[[nodiscard]] bool isErrorTerminal();
/// Only the job in the foreground may ask its terminal.
[[nodiscard]] bool isInForeground();

/// For as long as it lives, standard input brings each key at once, and shows none.
class SingleKeys {
 public:
  /// @return null: standard input is no terminal, or not that of this program
  [[nodiscard]] static std::unique_ptr<SingleKeys> take();
  ~SingleKeys();
  SingleKeys(const SingleKeys&) = delete;
  SingleKeys& operator=(const SingleKeys&) = delete;

 private:
  struct Mode;
  explicit SingleKeys(std::unique_ptr<Mode> before);

  std::unique_ptr<Mode> m_before;
};

/// Asks on the terminal of this process, wherever standard input comes from, and does not show what
/// is typed. @param answer  receives the line @return false: there is no terminal
[[nodiscard]] bool askInSecret(const std::string& question, std::string& answer);

}  // namespace rivulet::platform
