// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The programmable frame: where the coordinates of a program lie in the workpiece frame the stream
/// works in (TRANS, ROT, SCALE, MIRROR; G52, G92). @threadsafety plain values.
#pragma once

#include <array>

#include "base/vec3.h"

namespace rivulet::nc {

/// workpiece = matrix · programmed + translation. Coordinates the program has never named are NaN;
/// they stay so as long as no rotation mixes them with others.
class Frame {
 public:
  [[nodiscard]] base::Vec3 toWorkpiece(base::Vec3 programmedMm) const {
    return m_isIdentity ? programmedMm : turned(programmedMm) + m_translationMm;
  }
  [[nodiscard]] base::Vec3 toProgrammed(base::Vec3 workpieceMm) const;
  /// Of a direction: without the translation.
  [[nodiscard]] base::Vec3 turned(base::Vec3 programmed) const;
  [[nodiscard]] bool isIdentity() const { return m_isIdentity; }
  /// True if the axes are not mixed: no rotation.
  [[nodiscard]] bool isAligned() const;

  /// True if it turns a counterclockwise arc into a clockwise one.
  [[nodiscard]] bool mirrors() const;
  /// True if a circle stays one: scaled evenly or not at all.
  [[nodiscard]] bool keepsCircles() const;

  /// No length grows by more than this factor; exact unless axes that were scaled unevenly have
  /// been turned afterwards.
  [[nodiscard]] double stretchMax() const;

  // Each follows the frame there is: what it does happens in the programmed coordinates.
  void translate(base::Vec3 offsetMm);
  /// @param axis 0, 1, 2: about X, Y, Z, counterclockwise seen against it
  void rotate(std::size_t axis, double degrees);
  /// @param factors  none is 0; -1 mirrors
  void scale(base::Vec3 factors);

 private:
  using Columns = std::array<base::Vec3, base::kAxisCount>;
  void setMatrix(const Columns& columns);
  [[nodiscard]] bool isSkewed() const;

  Columns m_columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Columns m_inverseColumns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  base::Vec3 m_translationMm;
  bool m_isIdentity = true;
};

}  // namespace rivulet::nc
