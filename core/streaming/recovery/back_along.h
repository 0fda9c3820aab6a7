// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run that was left is driven back along its own path, as a run of its own; then it goes on from
/// where the tool stands. A held control still has its blocks: this begins once its program has
/// ended, or after a reset (`resumeOnPart`). Whole jobs are not driven back. @threadsafety pure.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/axes.h"
#include "base/result.h"
#include "gcode/program.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

/// Where the way back ends.
struct BackWish {
  /// Length of the way, mm, > 0; nothing: where the last rapid ended.
  std::optional<double> mm;
};

struct BackWay {
  BackPart part;
  std::vector<base::AxisPosition> places;  ///< one after another, the first behind the tool
  double lengthMm = 0.0;
};

/// The way back of a run from where it was left.
/// @param settings, last  of the run  @param next  the first point that it has not executed
/// @param tool  on the move to that point
/// @return CannotResume with the reason: the way would cross a rapid, a tool change or another
/// function of the machine, or pass a place twice; the tool is not on its path
[[nodiscard]] base::Result<BackWay> backAlong(const gcode::Program& program,
                                              const RunSettings& settings, const Checkpoint& last,
                                              std::size_t next, base::AxisPosition tool,
                                              const BackWish& wish);

/// A program of these moves.
[[nodiscard]] gcode::Program backProgram(const BackWay& way, const base::RotarySet& rotaryAxes);

}  // namespace rivulet::streaming
