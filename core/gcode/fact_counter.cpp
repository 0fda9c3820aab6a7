// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/fact_counter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rivulet::gcode {

void FactCounter::takeOver(const nc::AxisValues& axes) {
  for (std::size_t axis = 0; axis < kProgrammedAxisCount; ++axis) {
    if (!axes.has(axis)) {
      continue;
    }
    if (std::isnan(axes.value[axis])) {
      m_facts.boundsUnknown[axis] = true;
      m_known[axis] = false;
      continue;
    }
    if (axes.isIncrement(axis)) {
      if (!m_known[axis]) {
        m_facts.boundsUnknown[axis] = true;
        continue;
      }
      m_value[axis] += axes.value[axis];
    } else {
      m_value[axis] = axes.value[axis];
      m_known[axis] = true;
    }
    std::optional<ProgrammedRange>& range = m_facts.bounds[axis];
    if (!range) {
      range = ProgrammedRange{m_value[axis], m_value[axis]};
    }
    range->smallest = std::min(range->smallest, m_value[axis]);
    range->largest = std::max(range->largest, m_value[axis]);
  }
}

void FactCounter::line(const nc::AxisValues& axes) {
  double squares = 0.0;
  bool known = true;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!axes.has(axis)) {
      continue;
    }
    if (std::isnan(axes.value[axis])) {
      m_facts.lengthsKnown = false;
    }
    known &= m_known[axis] || axes.isIncrement(axis);
    const double step =
        axes.isIncrement(axis) ? axes.value[axis] : axes.value[axis] - m_value[axis];
    squares += step * step;
  }
  takeOver(axes);
  if (known) {
    m_facts.g1Length += std::sqrt(squares);
  } else {
    ++m_facts.g1Excluded;
  }
}

void FactCounter::motion(int g, const nc::AxisValues& axes) {
  if (m_isMade) {
    forget(std::nullopt);
    return;
  }
  count(g);
  noteUnits(axes);
  if (g == 1) {
    line(axes);
  } else {
    takeOver(axes);
  }
}

void FactCounter::arc(const nc::AxisValues& axes, nc::Arc arc, nc::ArcWords words) {
  if (m_isMade) {
    forget(std::nullopt);
    return;
  }
  count(arc.clockwise ? 2 : 3);
  noteUnits(axes);
  const std::size_t third = (arc.firstAxis + 2) % base::kAxisCount;
  bool known = true;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    // A rise needs its start as well; an axis that does not move needs none.
    const bool absolute = axes.has(axis) && !axes.isIncrement(axis);
    const bool needed = axis == third ? absolute : absolute || words.centreIsAbsolute[axis];
    known &= m_known[axis] || !needed;
    const double start = m_known[axis] ? m_value[axis] : 0.0;
    arc.startMm.set(axis, start);
    arc.endMm.set(axis, !axes.has(axis)          ? start
                        : axes.isIncrement(axis) ? start + axes.value[axis]
                                                 : axes.value[axis]);
  }
  takeOver(axes);
  // With TURN= the number of circles is not a matter of geometry alone.
  known &= arc.turns == 0;
  if (!known || !base::isFinite(arc.startMm) || !base::isFinite(arc.endMm)) {
    ++m_facts.arcExcluded;
    return;
  }
  // A centre across the plane says nothing about the arc in it.
  words.centre[third].reset();
  bool counted = false;
  for (std::size_t reading = 0; reading < kCentreReadings.size(); ++reading) {
    ArcReading& sums = m_readings[reading];
    const nc::ResolvedArc resolved =
        nc::resolveArc(arc, nc::readAs(kCentreReadings[reading], words));
    switch (resolved.problem) {
      case nc::ArcProblem::None: {
        const nc::ArcRadii radii = nc::arcRadii(resolved.arc);
        const double rise = arc.endMm[third] - arc.startMm[third];
        sums.mismatch = std::max(sums.mismatch, std::abs(radii.startMm - radii.endMm));
        // The radius of the start stands for the arc: a convention, the two differ by rounding.
        sums.length += std::hypot(radii.startMm * nc::arcSweep(resolved.arc), rise);
        counted = true;
        break;
      }
      case nc::ArcProblem::RadiusMismatch:
        sums.mismatch = std::max(sums.mismatch, resolved.mismatch);
        counted = true;
        break;
      case nc::ArcProblem::RadiusTooSmall:
        sums.mismatch = std::max(sums.mismatch, resolved.halfChord - resolved.mismatch);
        counted = true;
        break;
      default:
        break;
    }
  }
  m_facts.arcExcluded += counted ? 0U : 1U;
}

void FactCounter::machineMotion(int g, const nc::AxisValues& axes) {
  count(g);
  ++m_facts.machineMotions;
  if (g == 1) {
    ++m_facts.g1Excluded;
  }
  for (std::size_t axis = 0; axis < kProgrammedAxisCount; ++axis) {
    m_known[axis] = m_known[axis] && !axes.has(axis);
  }
}

void FactCounter::forget(std::optional<std::size_t> axis) {
  if (axis) {
    m_known[*axis] = false;
  } else {
    m_known.fill(false);
  }
}

void FactCounter::feed(double value) {
  if (m_isMade) {
    return;
  }
  if (m_facts.feeds.empty() || m_facts.feeds.back() != value) {
    m_facts.feeds.push_back(value);
  }
}

void FactCounter::units(bool inches) {
  const FileUnits units = inches ? FileUnits::Inches : FileUnits::Millimetres;
  if (m_facts.units == FileUnits::Unspecified || m_facts.units == units) {
    m_facts.units = units;
  } else {
    m_facts.units = FileUnits::Mixed;
  }
}

ProgramFacts FactCounter::take() {
  std::sort(m_facts.feeds.begin(), m_facts.feeds.end());
  m_facts.feeds.erase(std::unique(m_facts.feeds.begin(), m_facts.feeds.end()), m_facts.feeds.end());
  // If the arcs do not fit as the language has it, but fit another way of writing, that is it.
  const auto fits = [this](std::size_t reading) {
    return m_readings[reading].mismatch <= nc::kArcRadiusToleranceMm;
  };
  std::size_t chosen = 0;
  for (std::size_t reading = 1; reading < kCentreReadings.size() && !fits(chosen); ++reading) {
    chosen = fits(reading) ? reading : chosen;
  }
  m_facts.centreReading = kCentreReadings[chosen];
  m_facts.arcLength = m_readings[chosen].length;
  m_facts.arcRadiusMismatch = m_readings[chosen].mismatch;
  return std::move(m_facts);
}

}  // namespace rivulet::gcode
