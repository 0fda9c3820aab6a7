// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/first_move.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rivulet::streaming {

namespace {

/// Axes that stand are told so far off.
constexpr double kStandsMm = 0.01;

/// What the moves with feed sweep, with where each begins.
struct Cut {
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();
  base::Vec3 lowestMm{kNowhere, kNowhere, kNowhere};
  base::Vec3 highestMm{-kNowhere, -kNowhere, -kNowhere};

  void add(const base::Vec3& placeMm) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      lowestMm.set(axis, std::min(lowestMm[axis], placeMm[axis]));
      highestMm.set(axis, std::max(highestMm[axis], placeMm[axis]));
    }
  }
};

Cut cutOf(std::span<const gcode::StreamPoint> program) {
  Cut cut;
  for (std::size_t i = 0; i < program.size(); ++i) {
    if (program[i].kind == gcode::MoveKind::Rapid) {
      continue;
    }
    cut.add(program[i].positionMm);
    if (i > 0) {
      cut.add(program[i - 1].positionMm);  // where it begins to plunge is above the workpiece
    }
  }
  return cut;
}

}  // namespace

std::optional<double> cutOnTheWay(const base::Vec3& toolMm, const base::Vec3& firstMm,
                                  std::span<const gcode::StreamPoint> program) {
  const Cut cut = cutOf(program);
  const base::Vec3 way = firstMm - toolMm;
  const bool goesUp = std::abs(way.x) <= kStandsMm && std::abs(way.y) <= kStandsMm && way.z >= 0.0;
  if (goesUp || cut.lowestMm.x > cut.highestMm.x) {
    return std::nullopt;
  }
  // The part of the way, from 0 to 1, that is within the box.
  double enters = 0.0;
  double leaves = 1.0;
  const auto clip = [&](double from, double along, double least, double most) {
    if (along == 0.0) {
      leaves = from >= least && from <= most ? leaves : -1.0;
      return;
    }
    const double a = (least - from) / along;
    const double b = (most - from) / along;
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    clip(toolMm[axis], way[axis], cut.lowestMm[axis], cut.highestMm[axis]);
  }
  clip(toolMm.z, way.z, -Cut::kNowhere, cut.highestMm.z - kStandsMm);
  return leaves > enters ? std::optional(cut.highestMm.z) : std::nullopt;
}

std::string describeCutOnTheWay(double heightMm) {
  return fmt::format(
      "The straight way to the first point passes within what the program cuts: bring the tool "
      "above Z {:.3f} first, or make sure that nothing is in the way.",
      heightMm);
}

}  // namespace rivulet::streaming
