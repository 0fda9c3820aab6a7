// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/listing.h"

namespace rivulet::templates {

void Listing::pieces(std::string_view begin, const std::vector<std::string>& pieces,
                     std::string_view between, std::size_t lineMax) {
  std::string written;
  for (const std::string& piece : pieces) {
    if (!written.empty() && written.size() + between.size() + piece.size() > lineMax) {
      line("{}", written);
      written.clear();
    }
    written += written.empty() ? begin : between;
    written += piece;
  }
  if (!written.empty()) {
    line("{}", written);
  }
}

std::string lettersOf(const CellMap& cells) {
  TemplateParameters chosen;
  chosen.axes = cells.axes;
  chosen.rotaryAxes = cells.rotaryAxes;
  return axisLetters(chosen);
}

SlotText slotText(const CellMap& cells, int slot) {
  SlotText text;
  const std::vector<int> numbers = cells.slotCells(slot);
  std::size_t next = 0;
  const bool isPacked = cells.packed && slot % cells.pointsPerLoop > 0;
  for (const char letter : lettersOf(cells)) {
    const std::string_view blank = text.axes.empty() ? "" : " ";
    if (isPacked) {
      text.axes += fmt::format("{}{}", blank, letter);
      continue;
    }
    text.axes += fmt::format("{}{}", blank, letter);
    text.words += fmt::format("{}{}=R{}", blank, letter, numbers[next]);
    text.cells += fmt::format("{}R{}", blank, numbers[next]);
    ++next;
  }
  for (; next < numbers.size(); ++next) {  // the feed of the point, or what is packed
    text.cells += fmt::format("{}R{}", text.cells.empty() ? "" : " ", numbers[next]);
  }
  return text;
}

int copiedPerPoint(const CellMap& cells) {
  return static_cast<int>(lettersOf(cells).size()) + (cells.feedPerPoint ? 1 : 0);
}

}  // namespace rivulet::templates
