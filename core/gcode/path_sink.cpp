// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/path_sink.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rivulet::gcode {

PathSink::PathSink(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics,
                   Findings& findings, FactCounter& facts)
    : m_trajectory(trajectory),
      m_statistics(statistics),
      m_findings(findings),
      m_facts(facts),
      m_path(options, trajectory, statistics) {
}

// --- path ---------------------------------------------------------------------------------------

void PathSink::count(const nc::Move& move) {
  if (move.motion < nc::Motion::None) {
    ++m_statistics.motions[static_cast<std::size_t>(move.motion)];
  }
}

void PathSink::line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) {
  count(move);
  m_path.line(from, targetMm, move);
}

void PathSink::arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) {
  const nc::ArcRadii radii = nc::arcRadii(arc);
  if (!hasFewChords(from, nc::arcSweep(arc), std::max(radii.startMm, radii.endMm), move)) {
    unknownWay(from, arc.endMm, move);
    return;
  }
  count(move);
  m_path.arc(from, arc, move);
}

void PathSink::spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                        const nc::Move& move) {
  const double radiusMm = base::distance(arc.centreMm, from.programmedMm);
  if (!hasFewChords(from, arc.sweepRad, radiusMm, move)) {
    unknownWay(from, targetMm, move);
    return;
  }
  m_path.spaceArc(from, arc, targetMm, move);
}

void PathSink::spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) {
  m_path.spline(from, spline, move);
}

void PathSink::unknownWay(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) {
  count(move);
  m_path.unknownWay(from, targetMm, move);
}

bool PathSink::hasFewChords(const nc::Position& from, double sweepRad, double radiusMm,
                            const nc::Move& move) {
  constexpr double kChordsMax = 1e6;
  if (nc::chordCount(sweepRad, radiusMm, m_path.chordToleranceMm(from)) <= kChordsMax) {
    return true;
  }
  m_findings.report(Severity::Error, move.column, DiagnosticCode::TooManyPoints,
                    fmt::format("{:.0f}", kChordsMax));
  return false;
}

// --- findings -----------------------------------------------------------------------------------

void PathSink::report(Severity severity, int column, nc::FaultCode code, std::string argument) {
  m_findings.report(severity, column, code, std::move(argument));
}

void PathSink::fault(int column, const nc::Fault& fault) {
  m_findings.report(
      Severity::Error, column,
      nc::isAboutOrder(fault.code) ? DiagnosticCode::FlowFault : DiagnosticCode::ExpressionFault,
      nc::describe(fault));
}

void PathSink::ignore(const nc::Token& token, std::string word) {
  m_findings.ignore(token, std::move(word));
}

void PathSink::ignoreG(int key, const nc::Token& token) {
  m_findings.ignoreG(static_cast<std::size_t>(key), token);
}

void PathSink::ignoreM(Severity severity, int number, const nc::Token& token) {
  m_findings.ignoreM(severity, static_cast<std::size_t>(number), token);
}

void PathSink::ignoreLetter(const nc::Token& token) {
  m_findings.ignoreLetter(token);
}

// --- what the program has for the machine -------------------------------------------------------

void PathSink::machineWord(nc::MachineWord kind, double value) {
  m_trajectory.events.push_back({m_trajectory.points.size(), value, m_line, kind});
}

void PathSink::toolName(std::string_view name) {
  m_trajectory.toolNames.emplace_back(name);
  machineWord(nc::MachineWord::NamedTool, static_cast<double>(m_trajectory.toolNames.size() - 1));
}

void PathSink::programmedFeed(double feed, std::optional<double> mmPerMin) {
  m_facts.feed(feed);
  std::vector<double>& feeds = m_statistics.feedsMmPerMin;
  if (mmPerMin && *mmPerMin > 0.0 && (feeds.empty() || feeds.back() != *mmPerMin)) {
    feeds.push_back(*mmPerMin);
  }
}

}  // namespace rivulet::gcode
