// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Appends moves to a trajectory: carries programmed coordinates through the frame, turns arcs and
/// splines into chords, and counts lengths and bounds. Knows nothing of words.
/// @threadsafety one object, one thread.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gcode/program.h"
#include "nc/exec/sink.h"

namespace rivulet::gcode {

class PathBuilder final : public nc::PathSink {
 public:
  /// All outlive the builder.
  PathBuilder(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics,
              nc::FaultSink& faults);

  void line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override;
  void arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) override;
  void spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                const nc::Move& move) override;
  void spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) override;
  /// Drawn straight.
  void unknownWay(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override;
  void feed(double mmPerMin) override;
  void machineWord(nc::MachineWord kind, double value, base::LineNumber line) override;
  void toolName(std::string_view name, base::LineNumber line) override;
  /// A tool, a cutting edge or a change: which length holds, the control knows.
  [[nodiscard]] bool namesTool() const { return m_namesTool; }

 private:
  void begin(const nc::Position& from, const nc::Move& move);
  /// How far the chords of a curve may be from it in programmed coordinates, so that they are
  /// within the tolerance in the workpiece.
  [[nodiscard]] double chordToleranceMm(const nc::Position& from) const;
  /// One block may not fill the memory, however large its arc and small the tolerance.
  [[nodiscard]] bool hasFewChords(const nc::Position& from, double sweepRad, double radiusMm,
                                  const nc::Move& move);
  void append(base::Vec3 programmedMm, MoveKind kind);
  /// The chords collected, or one point for the arc they stand for.
  /// @param lengthMm  true length of the curve, programmed coordinates
  void appendCurve(MoveKind kind, double lengthMm, const std::optional<nc::SpaceArc>& kept);
  /// Length in the workpiece of the curve whose chords are collected.
  [[nodiscard]] double workpieceLengthMm(double programmedMm) const;
  void keepArc(const nc::SpaceArc& arc, base::Vec3 targetMm);
  void count(base::Vec3 programmedMm);

  const LoadOptions& m_options;
  Trajectory& m_trajectory;
  Statistics& m_statistics;
  nc::FaultSink& m_faults;
  // Of the move in progress.
  const nc::Position* m_from = nullptr;
  base::LineNumber m_line;
  double m_feedMmPerS = 0.0;
  RotaryPosition m_rotary;
  base::Vec3 m_toolDirection{0.0, 0.0, 1.0};
  std::vector<base::Vec3> m_chords;

  bool m_namesTool = false;
  bool m_hasRotary = false;
  bool m_hasToolDirections = false;
};

}  // namespace rivulet::gcode
