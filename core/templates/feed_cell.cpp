// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/feed_cell.h"

#include <fmt/format.h>

namespace rivulet::templates {

// The override is made up in its own cell, from nothing in each cycle, and one action writes
// $AC_OVR: which of several would win is not documented. What is not written in a cycle is 100 %.

std::vector<std::string> feedCellBlocks(const CellMap& cells) {
  if (!cells.hasFeedCell()) {
    return {};
  }
  const int wanted = cells.overrideWanted;
  const int acts = cells.overrideActs;
  return {
      fmt::format("R{}={} R{}=0", wanted, FeedCell::kProgrammed, acts),
      fmt::format("ID={} DO $R{}=0", ActionNumber::kHeld, acts),
      // No comparison holds for a value that is not a number.
      fmt::format("ID={} WHENEVER ($R{}>=0) AND ($R{}<={}) DO $R{}=$R{}", ActionNumber::kWanted,
                  wanted, wanted, FeedCell::kMax, acts, wanted),
      fmt::format("ID={} DO $AC_OVR=$R{}", ActionNumber::kActs, acts),
  };
}

std::string feedLimitBlock(const CellMap& cells, int action, const std::string& condition,
                           int percent) {
  return fmt::format("ID={} WHENEVER ({}) AND ($R{}>{}) DO $R{}={}", action, condition,
                     cells.overrideActs, percent, cells.overrideActs, percent);
}

}  // namespace rivulet::templates
