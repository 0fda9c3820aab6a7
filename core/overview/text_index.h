// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the lines of a program text begin, so that a view finds any of a million at once. Made
/// outside the GUI thread. @threadsafety immutable once made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rivulet::overview {

class TextIndex {
 public:
  TextIndex() = default;
  /// LF, CRLF and CR end a line, as for the interpreter. @param text  less than 4 GiB
  explicit TextIndex(std::string_view text);

  [[nodiscard]] std::size_t lines() const { return m_starts.size(); }
  /// A line without its end. @param text  the one the index was made of @param line  from 0
  [[nodiscard]] std::string_view line(std::string_view text, std::size_t line) const;
  /// Bytes of the longest line.
  [[nodiscard]] std::size_t longestBytes() const { return m_longestBytes; }
  /// The bytes are UTF-8; if not, read them as Latin-1, in which every byte is valid.
  [[nodiscard]] bool isUtf8() const { return m_isUtf8; }

 private:
  std::vector<std::uint32_t> m_starts;
  std::size_t m_longestBytes = 0;
  bool m_isUtf8 = true;
};

/// True if the bytes are well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates).
[[nodiscard]] bool isUtf8(std::string_view bytes);

}  // namespace rivulet::overview
