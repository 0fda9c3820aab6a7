// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Expected failures. Every folder declares one enum of codes and one `std::error_category`;
/// the message is one English sentence that says what is wrong and what to do.
/// @threadsafety plain values.
#pragma once

#include <string>
#include <system_error>
#include <utility>

namespace rivulet::base {

/// What went wrong and what to do about it.
struct Error {
  std::error_code code;  ///< for programs: compared with the enums of the folders
  std::string message;   ///< for people: one or two sentences, says what to do
  std::string context;   ///< the file, node or place it happened at; may be empty

  /// Context and message, as logs and the command line show them.
  [[nodiscard]] std::string text() const {
    return context.empty() ? message : context + ": " + message;
  }
};

[[nodiscard]] inline Error makeError(std::error_code code, std::string message,
                                     std::string context = {}) {
  return Error{code, std::move(message), std::move(context)};
}

/// Defines `make_error_code` and the category of one folder's error enum.
/// Use in the folder's namespace, after the enum; the enum needs `std::is_error_code_enum`.
class NamedCategory final : public std::error_category {
 public:
  explicit NamedCategory(const char* name) : m_name(name) {}
  [[nodiscard]] const char* name() const noexcept override { return m_name; }
  [[nodiscard]] std::string message(int value) const override {
    return std::string(m_name) + " error " + std::to_string(value);
  }

 private:
  const char* m_name;
};

}  // namespace rivulet::base
