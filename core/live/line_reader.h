// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Puts lines together from what arrives in pieces. A line ends with LF; CR before it is left out.
/// @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rivulet::live {

/// Longer than any point.
inline constexpr std::size_t kLineBytesMax = 1000;

class LineReader {
 public:
  /// @param bytes  as they come; a line may be cut anywhere
  void add(std::string_view bytes);

  /// The next whole line; valid until the next call of this object. Nothing: there is none yet.
  [[nodiscard]] std::optional<std::string_view> next();

  /// A whole line is here.
  [[nodiscard]] bool hasLine() const;
  /// What has no end yet.
  [[nodiscard]] std::string_view rest() const;
  /// It is longer than a line can be.
  [[nodiscard]] bool isTooLong() const { return !hasLine() && rest().size() > kLineBytesMax; }

 private:
  std::string m_bytes;
  std::size_t m_begin = 0;  ///< what is before has been given out
};

}  // namespace rivulet::live
