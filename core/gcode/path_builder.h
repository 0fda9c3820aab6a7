// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Appends moves to a trajectory: carries programmed coordinates through the frame, turns arcs and
/// splines into chords, and counts lengths and bounds. Knows nothing of words.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "gcode/arc.h"
#include "gcode/frame.h"
#include "gcode/program.h"

namespace rivulet::gcode {

/// What the points of a block have in common.
struct MoveWords {
  double feedMmPerS = 0.0;
  base::LineNumber line;
  std::array<std::optional<double>, base::kAxisCount> rotaryDegrees;
  std::optional<base::Vec3> toolDirection;
};

class PathBuilder {
 public:
  PathBuilder(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics);

  /// Where the path stands, in programmed coordinates; NaN where it is not known.
  [[nodiscard]] base::Vec3 position() const { return m_programmedMm; }
  [[nodiscard]] double rotary(std::size_t axis) const { return m_rotary.degrees[axis]; }
  [[nodiscard]] const Frame& frame() const { return m_frame; }
  /// The axis stands at this place, which no motion has said yet (G92).
  void place(std::size_t axis, double programmedMm) { m_programmedMm.set(axis, programmedMm); }
  void placeRotary(std::size_t axis, double degrees) { m_rotary.degrees[axis] = degrees; }
  /// The machine does not move; the same place gets other coordinates.
  void setFrame(const Frame& frame);
  /// Direction of the last move, programmed coordinates; zero if there was none.
  [[nodiscard]] base::Vec3 direction() const { return m_direction; }

  /// Length of a straight move from here; 0 if it comes from a place that is not known.
  [[nodiscard]] double lengthTo(base::Vec3 targetMm) const;

  /// How far the chords of a curve may be from it in programmed coordinates, so that they are
  /// within the tolerance in the workpiece.
  [[nodiscard]] double chordToleranceMm() const;

  void line(base::Vec3 targetMm, bool rapid, const MoveWords& words);
  void arc(const Arc& arc, const MoveWords& words);
  void spaceArc(const SpaceArc& arc, base::Vec3 targetMm, const MoveWords& words);
  void spline(const Spline& spline, const MoveWords& words);
  /// To a place whose way is not known (an arc with a fault): drawn straight.
  void unknownWay(base::Vec3 targetMm, const MoveWords& words);

 private:
  void append(base::Vec3 programmedMm, MoveKind kind, const MoveWords& words);
  /// The chords collected, or one point for the arc they stand for.
  /// @param lengthMm  true length of the curve, programmed coordinates
  void appendCurve(MoveKind kind, double lengthMm, const std::optional<SpaceArc>& kept,
                   const MoveWords& words);
  /// Length in the workpiece of the curve whose chords are collected.
  [[nodiscard]] double workpieceLengthMm(double programmedMm) const;
  void keepArc(const SpaceArc& arc, base::Vec3 targetMm, const MoveWords& words);
  void takeRotary(const MoveWords& words);
  void count(base::Vec3 workpieceMm);

  const LoadOptions& m_options;
  Trajectory& m_trajectory;
  Statistics& m_statistics;
  Frame m_frame;
  base::Vec3 m_programmedMm;
  base::Vec3 m_direction;
  RotaryPosition m_rotary;
  base::Vec3 m_toolDirection{0.0, 0.0, 1.0};
  bool m_hasRotary = false;
  bool m_hasToolDirections = false;
  std::vector<base::Vec3> m_chords;
};

}  // namespace rivulet::gcode
