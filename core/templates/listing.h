// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Text of a flexible program: its lines, and the notation of axes and slots.
/// @threadsafety plain values.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "templates/cells.h"

namespace rivulet::templates {

/// Collects the lines of the program: one block or comment per line.
class Listing {
 public:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(m_text), text, std::forward<Arguments>(arguments)...);
    m_text += '\n';
  }
  void text(std::string_view lines) { m_text += lines; }
  /// Pieces on as few lines as hold them, each line begun anew.
  void pieces(std::string_view begin, const std::vector<std::string>& pieces,
              std::string_view between, std::size_t lineMax = 110);
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
};

/// "X Y Z", "X=R11 Y=R12 Z=R13", "R11 R12 R13".
struct SlotText {
  std::string axes;
  std::string words;
  std::string cells;
};

[[nodiscard]] SlotText slotText(const CellMap& cells, int slot);

/// "XYZ", in the order of a slot's cells.
[[nodiscard]] std::string lettersOf(const CellMap& cells);

/// Values that a program copies of each point: the coordinates, and its feed where it has its own.
[[nodiscard]] int copiedPerPoint(const CellMap& cells);

/// "" or "s".
[[nodiscard]] constexpr std::string_view plural(int count) {
  return count == 1 ? "" : "s";
}

}  // namespace rivulet::templates
