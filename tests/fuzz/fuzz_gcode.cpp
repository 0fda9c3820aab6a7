// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are an NC program: reading them never fails in a way that is not said, and what comes
// out keeps its promises. Built and started by scripts/fuzz.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/require.h"
#include "gcode/interpreter.h"
#include "gcode/path_deviation.h"
#include "gcode/thinning.h"

namespace {

using namespace rivulet;
using tests::require;

/// Finite, or NaN for a coordinate that was never named.
void checkPoints(const gcode::Trajectory& trajectory, std::size_t lines) {
  for (const gcode::TrajectoryPoint& point : trajectory.points) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      require(!std::isinf(point.positionMm[axis]));
    }
    require(std::isfinite(point.feedMmPerS) && point.feedMmPerS >= 0.0);
    require(point.line.value <= lines + 1);
  }
  require(trajectory.rotary.empty() || trajectory.rotary.size() == trajectory.points.size());
  require(trajectory.toolDirections.empty() ||
          trajectory.toolDirections.size() == trajectory.points.size());
  for (const gcode::PathEvent& event : trajectory.events) {
    require(event.point <= trajectory.points.size());
  }
  for (const gcode::KeptArc& arc : trajectory.arcs) {
    require(arc.point < trajectory.points.size() && arc.sweepRad > 0.0);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  gcode::LoadOptions options;
  // The first byte chooses how the rest is read.
  const unsigned choice = data[0];
  if (choice % 8 < gcode::kDialects.size()) {
    options.dialect = gcode::kDialects[choice % 8];
  }
  options.keepArcs = (choice & 0x10U) != 0;
  options.blockSkip = (choice & 0x20U) != 0;
  options.chordToleranceMm = (choice & 0x40U) != 0 ? 1.0 : 0.01;
  options.repeatedLinesMax = 200;
  options.subprogram = [](std::string_view name) {
    return name.size() % 2 == 0 ? std::optional(nc::LoadedText{"G91 G0 X1\nM17\n", "part.spf"})
                                : std::nullopt;
  };
  // Memory of its own, so that a look at the byte before it is noticed, too.
  const std::vector<char> text(data + 1, data + size);
  const gcode::Interpretation result = gcode::interpret({text.data(), text.size()}, options);
  checkPoints(result.trajectory, result.statistics.lines);
  for (const gcode::Diagnostic& diagnostic : result.diagnostics) {
    require(!gcode::describe(diagnostic).empty());
  }
  if (result.trajectory.points.size() < 5000) {
    const gcode::ThinnedTrajectory thinned = gcode::thin(result.trajectory, {0.1});
    checkPoints(thinned.trajectory, result.statistics.lines);
    require(gcode::isAlong(gcode::placesOf(result.trajectory), gcode::placesOf(thinned.trajectory),
                           0.1));
  }
  return 0;
}
