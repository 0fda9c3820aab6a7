// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A program that builds on Rivulet: reads an NC program and says how fast method window can stream
// it by the reach alone: infinitely quick axes, and the access time of the paper.

#include <cstdio>

#include "base/units.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"

using namespace rivulet;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: largest_feed PROGRAM.nc\n");
    return 2;
  }
  const base::Result<gcode::Program> program = gcode::loadProgram(argv[1]);
  if (!program) {
    std::fprintf(stderr, "%s\n", program.error().text().c_str());
    return 1;
  }
  constexpr base::Vec3 kStartMm{0.0, 0.0, 0.0};
  const auto points = gcode::streamPoints(program->trajectory, kStartMm).points;
  const feasibility::OperatingPoint point;  // method window, N = 7, F 500 mm/min
  const auto verdict =
      feasibility::judge(point, feasibility::programDistances(points, point.pointsPerLoop));
  if (!verdict) {
    std::fprintf(stderr, "%s\n", verdict.error().text().c_str());
    return 1;
  }
  std::printf("%zu points, largest feed by the reach: %.0f mm/min\n", points.size(),
              base::mmPerMinFromMmPerS(verdict->feedMmPerSMax));
  return 0;
}
