// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/overlay.h"

#include <fmt/format.h>

namespace rivulet::templates {

namespace {

/// Below this an overlay is gone, mm.
constexpr double kOverlayGoneMm = 0.0005;

std::string anyOf(const WindowCells& cells, std::string (*condition)(char axis)) {
  std::string text;
  for (const Corrected& axis : correctedAxes(cells)) {
    text += (text.empty() ? "" : " OR ") + condition(axis.letter);
  }
  return text;
}

}  // namespace

std::vector<Corrected> correctedAxes(const WindowCells& cells) {
  std::vector<Corrected> axes;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.correction[axis] >= 0) {
      axes.push_back({base::kAxisNames[axis], cells.correction[axis],
                      ActionNumber::kCorrection + static_cast<int>(axis)});
    }
  }
  return axes;
}

std::string overlayThere(const WindowCells& cells) {
  return anyOf(cells, [](char axis) {
    return fmt::format("(ABS($AA_OFF_VAL[{}])>{})", axis, kOverlayGoneMm);
  });
}

std::string overlayIntegrates(const WindowCells& cells) {
  return anyOf(cells,
               [](char axis) { return fmt::format("(($MA_AA_OFF_MODE[{}] B_AND 1)>0)", axis); });
}

std::vector<std::string> overlayBlocks(const WindowCells& cells, double limitMm) {
  std::vector<std::string> blocks;
  // No comparison holds for a value that is not a number.
  const std::string held =
      cells.lifts ? fmt::format("($R{}<=0) AND ", cells.overrideWanted) : std::string();
  const std::string least = cells.lifts ? "0" : fmt::format("-{:.3f}", limitMm);
  for (const Corrected& axis : correctedAxes(cells)) {
    blocks.push_back(fmt::format(
        "ID={} WHENEVER {}($R{}>={}) AND ($R{}<={:.3f}) DO $AA_OFF[{}]=$R{}", axis.action, held,
        axis.cell, least, axis.cell, limitMm, axis.letter, axis.cell));
    if (cells.lifts) {
      blocks.push_back(fmt::format("ID={} WHENEVER $R{}>0 DO $AA_OFF[{}]=0", ActionNumber::kLowered,
                                   cells.overrideWanted, axis.letter));
    }
  }
  return blocks;
}

std::string andLowered(const WindowCells& cells) {
  return cells.lifts
             ? fmt::format(" AND ($AA_OFF_VAL[{}]<={})", base::kAxisNames.back(), kOverlayGoneMm)
             : std::string();
}

}  // namespace rivulet::templates
