// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a reader makes of a program: a path, or a refusal. The same for LinuxCNC and for Rivulet,
/// so that they can be compared. @threadsafety plain values.
#pragma once

#include <string>
#include <vector>

#include "base/axes.h"
#include "base/vec3.h"

namespace rivulet::tests {

enum class MoveForm { Rapid, Feed, Arc, Spline };

struct ReadMove {
  MoveForm form = MoveForm::Rapid;
  /// mm, in the work offset G54, without the length of the tool. NaN: the reader does not say.
  base::Vec3 endMm;
  base::RotaryDeg rotaryDeg{};  ///< NaN: the reader does not say
  double feedPerMin = 0.0;      ///< mm or degrees; 0: a rapid
  base::Vec3 centreMm;          ///< of an arc: a place on its axis
  base::Vec3 axis;              ///< of an arc: unit vector
  double sweepRad = 0.0;        ///< of an arc, > 0: counterclockwise seen against `axis`
  double errorMm = 0.0;         ///< by which the reader's output is rounded
};

struct PathReading {
  bool accepted = false;
  std::string refusal;  ///< the first sentence
  std::string word;     ///< what the refusal is about, if the reader says so
  std::vector<ReadMove> moves;
};

/// One line for people.
[[nodiscard]] std::string describe(const ReadMove& move);

}  // namespace rivulet::tests
