// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/motion_text.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "nc/nc_number.h"

namespace rivulet::job {

namespace {

std::string lengthText(double mm) {
  return nc::ncNumber(mm);
}

std::string feedText(double mmPerS) {
  return " F" + nc::ncNumber(base::mmPerMinFromMmPerS(mmPerS));
}

bool isUpright(const nc::Frame& frame) {
  return frame.isAligned() && frame.turned({1.0, 1.0, 1.0}) == base::Vec3{1.0, 1.0, 1.0};
}

}  // namespace

std::string lineText(base::Vec3 fromMm, base::Vec3 toMm, std::optional<double> feedMmPerS) {
  std::string text;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!std::isnan(toMm[axis]) && toMm[axis] != fromMm[axis]) {
      text += fmt::format(" {}{}", base::kAxisNames[axis], lengthText(toMm[axis]));
    }
  }
  return text.empty() ? text
                      : (feedMmPerS ? "G1" : "G0") + text +
                            (feedMmPerS && *feedMmPerS > 0.0 ? feedText(*feedMmPerS) : "");
}

std::optional<std::string> incrementText(
    const nc::Frame& frame, base::Vec3 fromMm, base::Vec3 toMm,
    const std::array<std::optional<double>, base::kAxisCount>& incrementsMm,
    std::optional<double> feedMmPerS) {
  if (!isUpright(frame)) {
    return std::nullopt;
  }
  std::string text = feedMmPerS ? "G1" : "G0";
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (incrementsMm[axis]) {
      text += fmt::format(" {}=IC({})", base::kAxisNames[axis], lengthText(*incrementsMm[axis]));
    } else if (!std::isnan(toMm[axis]) && toMm[axis] != fromMm[axis]) {
      text += fmt::format(" {}{}", base::kAxisNames[axis], lengthText(toMm[axis]));
    }
  }
  return feedMmPerS && *feedMmPerS > 0.0 ? text + feedText(*feedMmPerS) : text;
}

std::optional<std::string> arcText(const nc::Position& from, const nc::Arc& arc,
                                   const nc::Move& move) {
  if (arc.firstAxis != 0 || !isUpright(from.frame)) {
    return std::nullopt;
  }
  const base::Vec3 endMm = from.frame.toWorkpiece(arc.endMm);
  const base::Vec3 centreMm = from.frame.toWorkpiece(arc.centreMm);
  std::string text = fmt::format("{} X{} Y{}", arc.clockwise ? "G2" : "G3", lengthText(endMm.x),
                                 lengthText(endMm.y));
  if (!std::isnan(endMm.z) && arc.endMm.z != arc.startMm.z) {
    text += " Z" + lengthText(endMm.z);
  }
  text += fmt::format(" I=AC({}) J=AC({})", lengthText(centreMm.x), lengthText(centreMm.y));
  if (arc.turns > 0) {
    text += fmt::format(" TURN={}", arc.turns);
  }
  return move.feedMmPerS > 0.0 ? text + feedText(move.feedMmPerS) : text;
}

std::optional<std::string> arcText(const nc::Frame& frame, const ArcWithoutStart& arc) {
  if (!isUpright(frame)) {
    return std::nullopt;
  }
  std::string text = arc.isClockwise ? "G2" : "G3";
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (arc.incrementsMm[axis]) {
      text +=
          fmt::format(" {}=IC({})", base::kAxisNames[axis], lengthText(*arc.incrementsMm[axis]));
    } else if (!std::isnan(arc.endMm[axis])) {
      text += fmt::format(" {}{}", base::kAxisNames[axis], lengthText(arc.endMm[axis]));
    }
  }
  for (std::size_t axis = 0; axis < arc.centreMm.size(); ++axis) {
    if (arc.centreMm[axis]) {
      text += fmt::format(" {}{}", axis == 0 ? 'I' : 'J', lengthText(*arc.centreMm[axis]));
    }
  }
  if (arc.radiusMm) {
    text += " CR=" + lengthText(*arc.radiusMm);
  }
  return arc.feedMmPerS > 0.0 ? text + feedText(arc.feedMmPerS) : text;
}

}  // namespace rivulet::job
