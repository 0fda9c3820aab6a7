// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/first_move.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contract.h"

namespace rivulet::streaming {

namespace {

/// Axes that stand are told so far off.
constexpr double kStandsMm = 0.01;

/// With the axes that stay.
base::Vec3 placeFrom(const base::Vec3& toolMm, const base::Vec3& openMm) {
  base::Vec3 placeMm = openMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    placeMm.set(axis, std::isnan(openMm[axis]) ? toolMm[axis] : openMm[axis]);
  }
  return placeMm;
}

/// The straight way between two places passes below the top of the box, and not only upwards.
/// @param toMm  NaN: the axis stays
bool passes(const base::Vec3& fromMm, const base::Vec3& toMm, const CutBox& cut) {
  const base::Vec3 way = placeFrom(fromMm, toMm) - fromMm;
  if (std::abs(way.x) <= kStandsMm && std::abs(way.y) <= kStandsMm && way.z >= 0.0) {
    return false;
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
    clip(fromMm[axis], way[axis], cut.lowestMm[axis], cut.highestMm[axis]);
  }
  clip(fromMm.z, way.z, -CutBox::kNowhere, cut.highestMm.z - kStandsMm);
  return leaves > enters;
}

}  // namespace

void CutBox::add(const base::Vec3& placeMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    lowestMm.set(axis, std::min(lowestMm[axis], placeMm[axis]));
    highestMm.set(axis, std::max(highestMm[axis], placeMm[axis]));
  }
}

CutBox cutOf(std::span<const gcode::StreamPoint> program) {
  CutBox cut;
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

base::Vec3 firstPlace(const gcode::Trajectory& trajectory, const base::Vec3& toolMm) {
  const auto first = std::find_if(
      trajectory.points.begin(), trajectory.points.end(),
      [&](const auto& point) { return placeFrom(toolMm, point.positionMm) != toolMm; });
  constexpr double kStays = std::numeric_limits<double>::quiet_NaN();
  return first != trajectory.points.end() ? first->positionMm : base::Vec3{kStays, kStays, kStays};
}

std::optional<CutOnTheWay> cutOnTheWay(const base::Vec3& toolMm, const base::Vec3& firstMm,
                                       const CutBox& cut) {
  if (cut.isEmpty() || !passes(toolMm, firstMm, cut)) {
    return std::nullopt;
  }
  const base::Vec3 aboveMm{toolMm.x, toolMm.y, cut.highestMm.z};
  return CutOnTheWay{cut.highestMm.z, aboveMm.z > toolMm.z && !passes(aboveMm, firstMm, cut)};
}

std::string describe(const CutOnTheWay& cut) {
  return fmt::format(
      "The straight way to the first point passes within what the program cuts{}",
      cut.isClearFromAbove
          ? fmt::format(": raise the tool above Z {:.3f} first, or make sure that nothing is in "
                        "the way.",
                        cut.heightMm)
          : ", also from above: bring the tool to a place from which it is clear, or make sure "
            "that nothing is in the way.");
}

gcode::Program raiseProgram(double toMm) {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  auto program =
      gcode::interpretProgram("RAISE", fmt::format("G90 G710 G1 Z{:.3f}\nM30\n", toMm), options);
  RIVULET_ASSERT(program.has_value());
  return std::move(*program);
}

}  // namespace rivulet::streaming
