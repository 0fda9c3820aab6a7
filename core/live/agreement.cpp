// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/packing.h"
#include "base/ranges.h"
#include "base/units.h"
#include "live/error.h"

namespace rivulet::live {

namespace {

using base::Result;

/// Angles that differ by less are the same.
constexpr double kTurnDegMin = 0.0005;

double turnedDegMost(const base::RotaryDeg& from, const base::RotaryDeg& to) {
  double most = 0.0;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    most = std::max(most, std::abs(to[axis] - from[axis]));
  }
  return most;
}

}  // namespace

bool reaches(const Agreement& agreement, const base::Vec3& toolMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (toolMm[axis] < agreement.lowestMm[axis] - agreement.startMmMax ||
        toolMm[axis] > agreement.highestMm[axis] + agreement.startMmMax) {
      return false;
    }
  }
  return true;
}

Agreement around(Agreement agreement, const base::Vec3& toolMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double sizeMm = agreement.highestMm[axis] - agreement.lowestMm[axis];
    agreement.lowestMm.set(axis, std::floor(toolMm[axis] - 0.5 * sizeMm));
    agreement.highestMm.set(axis, std::ceil(toolMm[axis] + 0.5 * sizeMm));
  }
  return agreement;
}

Gate::Gate(const Agreement& agreement, const base::AxisPosition& tool, double feedMmPerMin,
           std::array<bool, base::kAxisCount> axes, base::RotarySet rotaryAxes, bool packs)
    : m_agreement(agreement),
      m_last(tool),
      m_named(tool),
      m_feedMmPerMin(feedMmPerMin),
      m_axes(axes),
      m_rotaryAxes(rotaryAxes),
      m_packs(packs) {
}

Result<void> Gate::takeFeed(const Line& line) {
  if (!line.feedMmPerMin) {
    return {};
  }
  if (!(*line.feedMmPerMin >= base::kFeedMmPerMinLeast) ||
      *line.feedMmPerMin > m_agreement.feedMmPerMinMax) {
    return base::fail(
        LiveError::FeedTooLarge,
        fmt::format("F{} is not in what was agreed: from F{} to F{}.", *line.feedMmPerMin,
                    base::kFeedMmPerMinLeast, m_agreement.feedMmPerMinMax));
  }
  m_feedMmPerMin = *line.feedMmPerMin;
  return {};
}

Result<void> Gate::requireAxes(const Line& line) const {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (line.mm[axis] && !m_axes[axis]) {
      return base::fail(
          LiveError::AxisNotChosen,
          fmt::format("{} is not one of the axes of this run.", base::kAxisNames[axis]));
    }
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (line.deg[axis] && !m_rotaryAxes[axis]) {
      return base::fail(
          LiveError::AxisNotChosen,
          fmt::format("{} is not one of the axes of this run.", base::kRotaryAxisNames[axis]));
    }
  }
  return {};
}

Result<void> Gate::requireInside(base::Vec3 pointMm) const {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double lowestMm = m_agreement.lowestMm[axis];
    const double highestMm = m_agreement.highestMm[axis];
    if (m_axes[axis] && !(pointMm[axis] >= lowestMm && pointMm[axis] <= highestMm)) {
      return base::fail(LiveError::OutsideBox,
                        fmt::format("{}{:.3f} is outside the box: {:.3f} to {:.3f} was agreed.",
                                    base::kAxisNames[axis], pointMm[axis], lowestMm, highestMm));
    }
  }
  return {};
}

Result<void> Gate::requireNear(const base::AxisPosition& point) const {
  const double stepMm = base::distance(m_last.mm, point.mm);
  if (m_isFirst && stepMm > m_agreement.startMmMax) {
    return base::fail(
        LiveError::TooFarAway,
        fmt::format("The first point is {:.3f} mm from the tool; {:.3f} mm was "
                    "agreed. Move the tool there, or begin where it is: X{:.3f} "
                    "Y{:.3f} Z{:.3f}.",
                    stepMm, m_agreement.startMmMax, m_last.mm.x, m_last.mm.y, m_last.mm.z));
  }
  if (!m_isFirst && stepMm > m_agreement.stepMmMax) {
    return base::fail(LiveError::StepTooLong, fmt::format("A step of {:.3f} mm; {:.3f} mm was "
                                                          "agreed.",
                                                          stepMm, m_agreement.stepMmMax));
  }
  if (const double turnDeg = turnedDegMost(m_last.deg, point.deg);
      turnDeg > m_agreement.turnDegMax) {
    return base::fail(LiveError::TurnTooLarge,
                      fmt::format("A rotary axis turns by {:.3f} degrees in one step; {:.3f} was "
                                  "agreed.",
                                  turnDeg, m_agreement.turnDegMax));
  }
  return {};
}

Result<std::optional<gcode::StreamPoint>> Gate::take(const Line& line, base::LineNumber number) {
  for (const Result<void>& step : {requireAxes(line), takeFeed(line)}) {
    if (!step) {
      return base::fail(step.error());
    }
  }
  const auto stepOf = [this](double coordinate) {
    return m_packs ? base::Packing::rounded(coordinate) : coordinate;
  };
  base::AxisPosition at = m_named;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    at.mm.set(axis, line.mm[axis] ? stepOf(*line.mm[axis]) : at.mm[axis]);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    at.deg[axis] = line.deg[axis] ? stepOf(*line.deg[axis]) : at.deg[axis];
  }
  for (const Result<void>& step : {requireInside(at.mm), requireNear(at)}) {
    if (!step) {
      return base::fail(step.error());
    }
  }
  m_named = at;
  const double stepMm = base::distance(m_last.mm, at.mm);
  const bool turns = turnedDegMost(m_last.deg, at.deg) >= kTurnDegMin;
  if (!turns && (stepMm == 0.0 || stepMm < m_agreement.distanceMmMin)) {
    return std::optional<gcode::StreamPoint>();
  }
  m_last = at;
  m_isFirst = false;
  gcode::StreamPoint point;
  point.positionMm = at.mm;
  point.rotaryDeg = at.deg;
  point.line = number;
  point.feedMmPerS = base::mmPerSFromMmPerMin(m_feedMmPerMin);
  return std::optional(point);
}

}  // namespace rivulet::live
