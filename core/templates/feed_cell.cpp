// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/feed_cell.h"

#include <fmt/format.h>

namespace rivulet::templates {

// The override is made up in its own cell, from nothing in each cycle, and one action writes
// $AC_OVR: which of several would win is not documented. What is not written in a cycle is 100 %.

bool watchesClient(const CellMap& cells) {
  return cells.hasFeedCell() && cells.silenceLimitS > 0.0;
}

bool isSilenceLimit(double seconds) {
  return seconds == 0.0 || (seconds >= kSilenceLimitSMin && seconds <= kSilenceLimitSMax);
}

std::vector<std::string> feedCellBlocks(const CellMap& cells) {
  if (!cells.hasFeedCell()) {
    return {};
  }
  const int wanted = cells.overrideWanted;
  const int acts = cells.overrideActs;
  // No comparison holds for a value that is not a number, or for a timer that has not been started.
  const std::string lives =
      watchesClient(cells) ? fmt::format(" AND ($AC_TIMER[{0}]>=0) AND ($AC_TIMER[{0}]<={1:g})",
                                         FeedCell::kBeatTimer, cells.silenceLimitS)
                           : std::string();
  std::vector<std::string> blocks{
      fmt::format("R{}={} R{}=0", wanted, FeedCell::kProgrammed, acts),
      fmt::format("ID={} DO $R{}=0", ActionNumber::kHeld, acts),
      fmt::format("ID={} WHENEVER ($R{}>=0) AND ($R{}<={}){} DO $R{}=$R{}", ActionNumber::kWanted,
                  wanted, wanted, FeedCell::kMax, lives, acts, wanted),
  };
  if (watchesClient(cells)) {
    blocks.push_back(fmt::format(
        "ID={0} WHENEVER ($R{1}>$AC_PARAM[{2}]) OR ($R{1}<$AC_PARAM[{2}]) DO $AC_PARAM[{2}]=$R{1} "
        "$AC_TIMER[{3}]=0",
        ActionNumber::kBeat, cells.heartbeat, FeedCell::kBeatSeen, FeedCell::kBeatTimer));
  }
  blocks.push_back(fmt::format("ID={} DO $AC_OVR=$R{}", ActionNumber::kActs, acts));
  return blocks;
}

std::string feedLimitBlock(const CellMap& cells, int action, const std::string& condition,
                           int percent) {
  return fmt::format("ID={} WHENEVER ({}) AND ($R{}>{}) DO $R{}={}", action, condition,
                     cells.overrideActs, percent, cells.overrideActs, percent);
}

}  // namespace rivulet::templates
