// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/feed_cell.h"

#include <fmt/format.h>

#include <algorithm>

#include "templates/overlay.h"

namespace rivulet::templates {

// The override is made up in its own cell, from nothing in each cycle, and one action writes
// $AC_OVR: which of several would win is not documented. What is not written in a cycle is 100 %.

bool watchesClient(const CellMap& cells) {
  return cells.hasFeedCell() && cells.silenceLimitS > 0.0;
}

bool isSilenceLimit(double seconds) {
  return seconds == 0.0 || (seconds >= kSilenceLimitSMin && seconds <= kSilenceLimitSMax);
}

bool areFactorBounds(double least, double most) {
  return least >= kFactorMin && least <= 1.0 && most >= 1.0 && most <= kFactorMax;
}

double overrideOf(const CellMap& cells, double percent, double factor) {
  const bool isWanted = percent >= FeedCell::kHold && percent <= FeedCell::kMax;
  if (!cells.hasFactor() || !isWanted) {
    return isWanted ? percent : FeedCell::kHold;
  }
  const bool isAgreed = factor >= cells.factorLeast && factor <= cells.factorMost;
  return isAgreed ? std::min(percent * factor, FeedCell::kProductMax) : FeedCell::kHold;
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
  const std::string agreed = cells.hasFactor()
                                 ? fmt::format(" AND ($R{0}>={1}) AND ($R{0}<={2})", cells.factor,
                                               cells.factorLeast, cells.factorMost)
                                 : std::string();
  const std::string product = cells.hasFactor() ? fmt::format("$R{}*$R{}", wanted, cells.factor)
                                                : fmt::format("$R{}", wanted);
  std::vector<std::string> blocks{
      fmt::format("R{}={} R{}=0{}", wanted, FeedCell::kProgrammed, acts,
                  cells.hasFactor() ? fmt::format(" R{}=1", cells.factor) : std::string()),
      fmt::format("ID={} DO $R{}=0", ActionNumber::kHeld, acts),
      fmt::format("ID={} WHENEVER ($R{}>=0) AND ($R{}<={}){}{}{} DO $R{}={}", ActionNumber::kWanted,
                  wanted, wanted, FeedCell::kMax, lives, agreed, andLowered(cells), acts, product),
  };
  if (watchesClient(cells)) {
    blocks.push_back(fmt::format(
        "ID={0} WHENEVER ($R{1}>$AC_PARAM[{2}]) OR ($R{1}<$AC_PARAM[{2}]) DO $AC_PARAM[{2}]=$R{1} "
        "$AC_TIMER[{3}]=0",
        ActionNumber::kBeat, cells.heartbeat, FeedCell::kBeatSeen, FeedCell::kBeatTimer));
  }
  if (cells.hasFactor()) {
    blocks.push_back(fmt::format("ID={} WHENEVER $R{}>{} DO $R{}={}", ActionNumber::kCapped, acts,
                                 FeedCell::kProductMax, acts, FeedCell::kProductMax));
  }
  blocks.push_back(fmt::format("ID={} DO $AC_OVR=$R{}",
                               cells.hasFactor() ? ActionNumber::kCappedActs : ActionNumber::kActs,
                               acts));
  return blocks;
}

std::string feedLimitBlock(const CellMap& cells, int action, const std::string& condition,
                           const std::string& percent) {
  return fmt::format("ID={} WHENEVER ({}) AND ($R{}>{}) DO $R{}={}", action, condition,
                     cells.overrideActs, percent, cells.overrideActs, percent);
}

}  // namespace rivulet::templates
