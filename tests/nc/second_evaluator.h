// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A second reader of NC programs, to judge the first one: written from the controls' manuals
/// alone, it shares no line with core/nc and core/gcode. It follows what is worth its lines: moves
/// and arcs in the plane, poles, feeds, units, offsets and frames of SINUMERIK, rotary axes,
/// conditions, loops and jumps, calls without O words, expressions. At any other word it stops and
/// names it, and whoever asks counts that. mm, degrees, mm/min. @threadsafety pure.
///
/// Sources: SINUMERIK Programming Manual Fundamentals and Job Planning; Fanuc B-63944EN; Haas Mill
/// Operator's Manual; LinuxCNC docs/src/gcode; the source of Grbl 1.1; Heidenhain iTNC 530 User's
/// Manual.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"

namespace rivulet::tests {

struct EvaluatedMove {
  enum class Kind : unsigned char { Rapid, Line, Arc };
  Kind kind = Kind::Line;
  std::array<double, 6> end{};  ///< X Y Z A B C as in the workpiece; NaN: not known
  base::Vec3 centre;            ///< of an arc: a point on its axis
  base::Vec3 axis;              ///< unit vector; the turn is counterclockwise seen against it
  double sweepDeg = 0.0;        ///< > 0
  double mismatch = 0.0;        ///< by which start and end differ in their distance from the centre
  double feed = 0.0;            ///< 0: rapid, or none is known
  std::size_t line = 0;         ///< of the text it stands in
};

struct Evaluation {
  std::vector<EvaluatedMove> moves;
  std::string cannotFollow;  ///< the word at which it stopped; "": it followed to the end
};

/// @param control  "sinumerik", "fanuc", "haas", "linuxcnc", "grbl", "heidenhain"
/// @param beside   the text of a subprogram that is not in this one, by its name in upper case
[[nodiscard]] Evaluation evaluate(
    std::string_view control, std::string_view text,
    const std::function<std::optional<std::string>(std::string_view)>& beside = {});

}  // namespace rivulet::tests
