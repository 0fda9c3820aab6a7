// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/path_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nc/unknown.h"

namespace rivulet::gcode {

using base::Vec3;

PathBuilder::PathBuilder(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics,
                         nc::FaultSink& faults)
    : m_options(options), m_trajectory(trajectory), m_statistics(statistics), m_faults(faults) {
  m_statistics.minMm = {nc::kUnknown, nc::kUnknown, nc::kUnknown};
  m_statistics.maxMm = m_statistics.minMm;
}

double PathBuilder::chordToleranceMm(const nc::Position& from) const {
  return m_options.chordToleranceMm / from.frame.stretchMax();
}

void PathBuilder::begin(const nc::Position& from, const nc::Move& move) {
  if (move.motion < nc::Motion::None) {
    ++m_statistics.motions[static_cast<std::size_t>(move.motion)];
  }
  m_from = &from;
  m_chords.clear();
  m_line = move.line;
  m_feedMmPerS = move.feedMmPerS;
  if (move.turns && !m_hasRotary) {
    m_hasRotary = true;
    m_trajectory.rotary.resize(m_trajectory.points.size());
  }
  m_rotary.degrees = move.turns ? move.rotaryDeg : from.rotaryDeg;
  if (move.toolDirection) {
    m_toolDirection = from.frame.turned(*move.toolDirection);
    if (!m_hasToolDirections) {
      m_hasToolDirections = true;
      m_trajectory.toolDirections.resize(m_trajectory.points.size(), Vec3{0.0, 0.0, 1.0});
    }
  }
}

void PathBuilder::append(Vec3 programmedMm, MoveKind kind) {
  m_trajectory.points.push_back({m_from->frame.toWorkpiece(programmedMm),
                                 kind == MoveKind::Rapid ? 0.0 : m_feedMmPerS, m_line, kind});
  if (m_hasRotary) {
    m_trajectory.rotary.push_back(m_rotary);
  }
  if (m_hasToolDirections) {
    m_trajectory.toolDirections.push_back(m_toolDirection);
  }
}

void PathBuilder::count(Vec3 programmedMm) {
  const Vec3 workpieceMm = m_from->frame.toWorkpiece(programmedMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    // fmin and fmax pass over the NaN of an axis not seen before.
    m_statistics.minMm.set(axis, std::fmin(m_statistics.minMm[axis], workpieceMm[axis]));
    m_statistics.maxMm.set(axis, std::fmax(m_statistics.maxMm[axis], workpieceMm[axis]));
  }
}

void PathBuilder::line(const nc::Position& from, Vec3 targetMm, const nc::Move& move) {
  begin(from, move);
  const bool rapid = move.motion == nc::Motion::Rapid;
  const double turnDeg = move.turns ? from.turnDegTo(move.rotaryDeg) : 0.0;
  const double lengthMm = from.lengthMmTo(targetMm);
  if (base::wayAlongFeed(lengthMm, turnDeg) != lengthMm) {
    m_feedMmPerS = move.feedDegPerS;  // F is in degrees
  }
  (rapid ? m_statistics.rapidLengthMm : m_statistics.cutLengthMm) += lengthMm;
  append(targetMm, rapid ? MoveKind::Rapid : MoveKind::Feed);
  count(targetMm);
}

void PathBuilder::unknownWay(const nc::Position& from, Vec3 targetMm, const nc::Move& move) {
  begin(from, move);
  append(targetMm, MoveKind::ArcPiece);
  count(targetMm);
}

void PathBuilder::keepArc(const nc::SpaceArc& arc, Vec3 targetMm) {
  // Two directions in the plane of the turn, carried along, say where its axis points afterwards.
  const nc::Frame& frame = m_from->frame;
  const Vec3 helper = std::abs(arc.axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 first = base::cross(arc.axis, helper);
  const Vec3 axis = base::cross(frame.turned(first), frame.turned(base::cross(arc.axis, first)));
  append(targetMm, MoveKind::Arc);
  m_trajectory.arcs.push_back({m_trajectory.points.size() - 1, frame.toWorkpiece(arc.centreMm),
                               (1.0 / base::norm(axis)) * axis, arc.sweepRad});
}

double PathBuilder::workpieceLengthMm(double programmedMm) const {
  const nc::Frame& frame = m_from->frame;
  if (frame.keepsCircles()) {
    return programmedMm * frame.stretchMax();
  }
  double sumMm = 0.0;
  Vec3 from = frame.toWorkpiece(m_from->programmedMm);
  for (const Vec3& chord : m_chords) {
    const Vec3 to = frame.toWorkpiece(chord);
    sumMm += base::distance(from, to);
    from = to;
  }
  return sumMm;
}

void PathBuilder::appendCurve(MoveKind kind, double lengthMm,
                              const std::optional<nc::SpaceArc>& kept) {
  m_statistics.cutLengthMm += workpieceLengthMm(lengthMm);
  if (m_options.keepArcs && kept && m_from->frame.keepsCircles()) {
    keepArc(*kept, m_chords.back());
  } else {
    for (const Vec3& chord : m_chords) {
      append(chord, kind);
    }
  }
  count(m_chords.back());
}

void PathBuilder::arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) {
  const nc::ArcRadii radii = nc::arcRadii(arc);
  if (!hasFewChords(from, nc::arcSweep(arc), std::max(radii.startMm, radii.endMm), move)) {
    unknownWay(from, arc.endMm, move);
    return;
  }
  begin(from, move);
  const double lengthMm = nc::flattenArc(arc, chordToleranceMm(from), m_chords);
  // A spiral is not an arc: it becomes chords in any case.
  const bool isCircle = std::abs(radii.startMm - radii.endMm) <= nc::kArcRadiusToleranceMm;
  appendCurve(MoveKind::ArcPiece, lengthMm,
              isCircle ? std::optional(nc::inSpace(arc)) : std::nullopt);
}

void PathBuilder::spaceArc(const nc::Position& from, const nc::SpaceArc& arc, Vec3 targetMm,
                           const nc::Move& move) {
  if (!hasFewChords(from, arc.sweepRad, base::distance(arc.centreMm, from.programmedMm), move)) {
    unknownWay(from, targetMm, move);
    return;
  }
  begin(from, move);
  const double lengthMm =
      nc::flattenSpaceArc(arc, from.programmedMm, targetMm, chordToleranceMm(from), m_chords);
  appendCurve(MoveKind::ArcPiece, lengthMm, arc);
}

void PathBuilder::spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) {
  // A frame with an angle or scale that is not known, or of which no number is left.
  const double toleranceMm = chordToleranceMm(from);
  if (!(toleranceMm > 0.0) || !std::isfinite(toleranceMm)) {
    m_faults.report(nc::Severity::Error, move.column, nc::FaultCode::ValueOutOfRange, "SCALE ROT");
    unknownWay(from, spline.controlMm.back(), move);
    return;
  }
  begin(from, move);
  const double lengthMm = nc::flattenSpline(spline, toleranceMm, m_chords);
  appendCurve(MoveKind::SplinePiece, lengthMm, std::nullopt);
}

bool PathBuilder::hasFewChords(const nc::Position& from, double sweepRad, double radiusMm,
                               const nc::Move& move) {
  constexpr double kChordsMax = 1e6;
  if (nc::chordCount(sweepRad, radiusMm, chordToleranceMm(from)) <= kChordsMax) {
    return true;
  }
  m_faults.report(nc::Severity::Error, move.column, nc::FaultCode::TooManyPoints,
                  fmt::format("{:.0f}", kChordsMax));
  return false;
}

// --- what the program has for the machine
// -------------------------------------------------------

void PathBuilder::feed(double mmPerMin) {
  std::vector<double>& feeds = m_statistics.feedsMmPerMin;
  if (mmPerMin > 0.0 && (feeds.empty() || feeds.back() != mmPerMin)) {
    feeds.push_back(mmPerMin);
  }
}

void PathBuilder::machineWord(nc::MachineWord kind, double value, base::LineNumber line) {
  constexpr double kChangesTool = 6.0;
  m_namesTool = m_namesTool || kind == nc::MachineWord::Tool ||
                kind == nc::MachineWord::NamedTool || kind == nc::MachineWord::Edge ||
                (kind == nc::MachineWord::M && value == kChangesTool);
  if (kind != nc::MachineWord::Edge) {  // its length is not on the path
    m_trajectory.events.push_back({m_trajectory.points.size(), value, line, kind});
  }
}

void PathBuilder::toolName(std::string_view name, base::LineNumber line) {
  m_trajectory.toolNames.emplace_back(name);
  machineWord(nc::MachineWord::NamedTool, static_cast<double>(m_trajectory.toolNames.size() - 1),
              line);
}

}  // namespace rivulet::gcode
