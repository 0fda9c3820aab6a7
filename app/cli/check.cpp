// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cmath>

#include "cli/commands.h"
#include "gcode/program.h"
#include "report/report_json.h"

namespace rivulet::cli {

Exit check(const CheckOptions& options) {
  const auto program = gcode::loadProgram(options.file, {options.chordToleranceMm});
  if (!program) {
    return reportError(program.error(), options.json);
  }
  const Exit exit = program->isStreamable() ? Exit::Done : Exit::Wrong;
  if (options.json) {
    printJson(report::programJson(*program));
    return exit;
  }
  const gcode::Statistics& statistics = program->statistics;
  fmt::print("{}  ({})\n", program->name, program->hash);
  fmt::print("  lines    {}\n", statistics.lines);
  fmt::print("  motions  G0 {}, G1 {}, G2 {}, G3 {}; {} points\n", statistics.motions[0],
             statistics.motions[1], statistics.motions[2], statistics.motions[3],
             statistics.points);
  fmt::print("  length   {:.3f} mm rapid, {:.3f} mm cut\n", statistics.rapidLengthMm,
             statistics.cutLengthMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isfinite(statistics.minMm[axis])) {
      fmt::print("  {}        {:.3f} to {:.3f} mm\n", base::kAxisNames[axis],
                 statistics.minMm[axis], statistics.maxMm[axis]);
    }
  }
  fmt::print("  feeds    {} mm/min\n", fmt::join(statistics.feedsMmPerMin, ", "));
  for (const gcode::Diagnostic& diagnostic : program->diagnostics) {
    fmt::print("{}:{}:{}: {}: {}\n", program->name, diagnostic.line.value, diagnostic.column,
               gcode::severityName(diagnostic.severity), gcode::describe(diagnostic));
  }
  fmt::print("{}\n", program->isStreamable()
                         ? "The whole path is known: the program can be streamed."
                         : "The path is not known everywhere: the program cannot be streamed.");
  return exit;
}

}  // namespace rivulet::cli
