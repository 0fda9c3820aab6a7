// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Text helpers that do not depend on the locale. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rivulet::base {

[[nodiscard]] constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
/// Characters of names in NC programs; digits are allowed after the first character.
[[nodiscard]] constexpr bool isNameLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
[[nodiscard]] constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t';
}

/// The number in `text`; nothing if it holds anything else. A leading '+' is allowed, a comma not.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The whole number in `text`; nothing if it holds anything else.
[[nodiscard]] std::optional<int> parseInteger(std::string_view text);

/// Shortest text that reads back as the same double ("0.1", "12", "nan").
[[nodiscard]] std::string formatNumber(double value);

/// `value` with a fixed number of decimals, trailing zeros removed ("12.5", "3").
[[nodiscard]] std::string formatFixed(double value, int decimals);

/// `text` without blanks, tabs and line ends at both ends.
[[nodiscard]] std::string_view trim(std::string_view text);

/// ASCII upper case; other bytes stay.
[[nodiscard]] constexpr char toUpper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
[[nodiscard]] std::string toUpper(std::string_view text);

/// A text file's content as UTF-8: UTF-16 of both byte orders, with and without a mark, is
/// converted, everything else stays as it is.
[[nodiscard]] std::string asUtf8(std::string content);

/// True if a TOML key has so many parts (a.b.c) that its reader, which calls itself for each, might
/// not come back.
[[nodiscard]] bool hasEndlessKey(std::string_view text);

/// The code of the invisible character that `text` begins with, "U+00A0" for a no-break blank in
/// UTF-8 or Latin-1; "" if it begins with another one.
[[nodiscard]] std::string invisibleCharacter(std::string_view text);

}  // namespace rivulet::base
