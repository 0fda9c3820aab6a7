// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/path_builder.h"

#include <cmath>
#include <limits>

namespace rivulet::gcode {

using base::Vec3;

PathBuilder::PathBuilder(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics)
    : m_options(options), m_trajectory(trajectory), m_statistics(statistics) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  m_programmedMm = {kUnknown, kUnknown, kUnknown};
  m_statistics.minMm = m_programmedMm;
  m_statistics.maxMm = m_programmedMm;
}

void PathBuilder::setFrame(const Frame& frame) {
  const Vec3 workpieceMm = m_frame.toWorkpiece(m_programmedMm);
  m_frame = frame;
  m_programmedMm = m_frame.toProgrammed(workpieceMm);
}

double PathBuilder::lengthTo(Vec3 targetMm) const {
  double squares = 0.0;
  const Vec3 from = m_frame.toWorkpiece(m_programmedMm);
  const Vec3 to = m_frame.toWorkpiece(targetMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double step = to[axis] - from[axis];
    if (!std::isnan(step)) {
      squares += step * step;
    } else if (!std::isnan(to[axis])) {
      return 0.0;
    }
  }
  return std::sqrt(squares);
}

void PathBuilder::count(Vec3 workpieceMm) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    // fmin and fmax pass over the NaN of an axis not seen before.
    m_statistics.minMm.set(axis, std::fmin(m_statistics.minMm[axis], workpieceMm[axis]));
    m_statistics.maxMm.set(axis, std::fmax(m_statistics.maxMm[axis], workpieceMm[axis]));
  }
}

void PathBuilder::takeRotary(const MoveWords& words) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.rotaryDegrees[axis]) {
      m_rotary.degrees[axis] = *words.rotaryDegrees[axis];
      if (!m_hasRotary) {
        m_hasRotary = true;
        m_trajectory.rotary.resize(m_trajectory.points.size());
      }
    }
  }
  if (words.toolDirection) {
    m_toolDirection = m_frame.turned(*words.toolDirection);
    if (!m_hasToolDirections) {
      m_hasToolDirections = true;
      m_trajectory.toolDirections.resize(m_trajectory.points.size(), Vec3{0.0, 0.0, 1.0});
    }
  }
}

void PathBuilder::append(Vec3 programmedMm, MoveKind kind, const MoveWords& words) {
  m_trajectory.points.push_back({m_frame.toWorkpiece(programmedMm),
                                 kind == MoveKind::Rapid ? 0.0 : words.feedMmPerS, words.line,
                                 kind});
  if (m_hasRotary) {
    m_trajectory.rotary.push_back(m_rotary);
  }
  if (m_hasToolDirections) {
    m_trajectory.toolDirections.push_back(m_toolDirection);
  }
}

void PathBuilder::line(Vec3 targetMm, bool rapid, const MoveWords& words) {
  takeRotary(words);
  const double lengthMm = lengthTo(targetMm);
  (rapid ? m_statistics.rapidLengthMm : m_statistics.cutLengthMm) += lengthMm;
  append(targetMm, rapid ? MoveKind::Rapid : MoveKind::Feed, words);
  if (lengthMm > 0.0) {
    m_direction = targetMm - m_programmedMm;
  }
  m_programmedMm = targetMm;
  count(m_frame.toWorkpiece(targetMm));
}

void PathBuilder::unknownWay(Vec3 targetMm, const MoveWords& words) {
  takeRotary(words);
  append(targetMm, MoveKind::ArcPiece, words);
  m_programmedMm = targetMm;
  count(m_frame.toWorkpiece(targetMm));
}

void PathBuilder::keepArc(const SpaceArc& arc, Vec3 targetMm, const MoveWords& words) {
  // Two directions in the plane of the turn, carried along, say where its axis points afterwards.
  const Vec3 helper = std::abs(arc.axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 first = base::cross(arc.axis, helper);
  const Vec3 axis =
      base::cross(m_frame.turned(first), m_frame.turned(base::cross(arc.axis, first)));
  append(targetMm, MoveKind::Arc, words);
  m_trajectory.arcs.push_back({m_trajectory.points.size() - 1, m_frame.toWorkpiece(arc.centreMm),
                               (1.0 / base::norm(axis)) * axis, arc.sweepRad});
}

double PathBuilder::chordToleranceMm() const {
  return m_options.chordToleranceMm / m_frame.stretchMax();
}

double PathBuilder::workpieceLengthMm(double programmedMm) const {
  if (m_frame.keepsCircles()) {
    return programmedMm * m_frame.stretchMax();
  }
  double sumMm = 0.0;
  Vec3 from = m_frame.toWorkpiece(m_programmedMm);
  for (const Vec3& chord : m_chords) {
    const Vec3 to = m_frame.toWorkpiece(chord);
    sumMm += base::distance(from, to);
    from = to;
  }
  return sumMm;
}

void PathBuilder::appendCurve(MoveKind kind, double lengthMm, const std::optional<SpaceArc>& kept,
                              const MoveWords& words) {
  m_statistics.cutLengthMm += workpieceLengthMm(lengthMm);
  const Vec3 before = m_chords.size() > 1 ? m_chords[m_chords.size() - 2] : m_programmedMm;
  if (m_options.keepArcs && kept && m_frame.keepsCircles()) {
    keepArc(*kept, m_chords.back(), words);
  } else {
    for (const Vec3& chord : m_chords) {
      append(chord, kind, words);
    }
  }
  m_direction = m_chords.back() - before;
  m_programmedMm = m_chords.back();
  count(m_frame.toWorkpiece(m_programmedMm));
}

void PathBuilder::arc(const Arc& arc, const MoveWords& words) {
  takeRotary(words);
  m_chords.clear();
  const double lengthMm = flattenArc(arc, chordToleranceMm(), m_chords);
  const ArcRadii radii = arcRadii(arc);
  // A spiral is not an arc: it becomes chords in any case.
  const bool isCircle = std::abs(radii.startMm - radii.endMm) <= kArcRadiusToleranceMm;
  appendCurve(MoveKind::ArcPiece, lengthMm, isCircle ? std::optional(inSpace(arc)) : std::nullopt,
              words);
}

void PathBuilder::spaceArc(const SpaceArc& arc, Vec3 targetMm, const MoveWords& words) {
  takeRotary(words);
  m_chords.clear();
  const double lengthMm =
      flattenSpaceArc(arc, m_programmedMm, targetMm, chordToleranceMm(), m_chords);
  appendCurve(MoveKind::ArcPiece, lengthMm, arc, words);
}

void PathBuilder::spline(const Spline& spline, const MoveWords& words) {
  takeRotary(words);
  m_chords.clear();
  const double lengthMm = flattenSpline(spline, chordToleranceMm(), m_chords);
  appendCurve(MoveKind::SplinePiece, lengthMm, std::nullopt, words);
}

}  // namespace rivulet::gcode
