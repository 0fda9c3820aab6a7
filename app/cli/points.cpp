// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/text.h"
#include "base/units.h"
#include "cli/commands.h"
#include "gcode/program.h"
#include "gcode/thinning.h"
#include "platform/log.h"

namespace rivulet::cli {

namespace {

std::string_view kindName(gcode::MoveKind kind) {
  switch (kind) {
    case gcode::MoveKind::Rapid:
      return "rapid";
    case gcode::MoveKind::Feed:
      return "line";
    case gcode::MoveKind::ArcPiece:
      return "arc-piece";
    case gcode::MoveKind::SplinePiece:
      return "spline-piece";
    case gcode::MoveKind::Arc:
      return "arc";
  }
  return "";
}

/// Empty if there is no number.
std::string cell(double value) {
  return std::isnan(value) ? std::string() : base::formatNumber(value);
}

void print(const gcode::Trajectory& trajectory, std::FILE* out) {
  const bool hasRotary = !trajectory.rotary.empty();
  const bool hasDirection = !trajectory.toolDirections.empty();
  fmt::print(out, "line,kind,x_mm,y_mm,z_mm{}{},feed_mm_per_min\n",
             hasRotary ? ",a_deg,b_deg,c_deg" : "", hasDirection ? ",tool_x,tool_y,tool_z" : "");
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const gcode::TrajectoryPoint& point = trajectory.points[i];
    fmt::print(out, "{},{},{},{},{}", point.line.value, kindName(point.kind),
               cell(point.positionMm.x), cell(point.positionMm.y), cell(point.positionMm.z));
    if (hasRotary) {
      const auto& degrees = trajectory.rotary[i].degrees;
      fmt::print(out, ",{},{},{}", cell(degrees[0]), cell(degrees[1]), cell(degrees[2]));
    }
    if (hasDirection) {
      const base::Vec3& direction = trajectory.toolDirections[i];
      fmt::print(out, ",{},{},{}", cell(direction.x), cell(direction.y), cell(direction.z));
    }
    fmt::print(out, ",{}\n",
               point.feedMmPerS > 0.0
                   ? base::formatFixed(base::mmPerMinFromMmPerS(point.feedMmPerS), 6)
                   : std::string());
  }
}

}  // namespace

base::Result<void> ResamplingOptions::split(gcode::Program& program) const {
  if (splitMm <= 0.0) {
    return {};
  }
  const std::uint64_t held = program.trajectory.points.capacity() * sizeof(gcode::TrajectoryPoint);
  auto parts = gcode::split(program.trajectory, splitMm, memoryBudget().without(held));
  if (!parts) {
    parts.error().message += " Or give a longer move with --split.";
    return base::fail(parts.error());
  }
  program.trajectory = *std::move(parts);
  return {};
}

base::Result<void> ResamplingOptions::resample(gcode::Program& program, bool onSteps) const {
  gcode::MoveRules rules;
  rules.tolerance = toleranceMm;
  rules.onSteps = onSteps;
  if (const auto merged = gcode::applyRules(program, rules); !merged) {
    return base::fail(merged.error());
  }
  tellMerged(program);
  return split(program);
}

void tellMerged(const gcode::Program& program) {
  if (program.merged) {
    log::logger().warn(gcode::describe(*program.merged));
  }
}

Exit points(const PointsOptions& options) {
  gcode::LoadOptions loading = options.loading.loadOptions();
  loading.keepArcs = options.keepArcs;
  base::Result<gcode::Program> program = gcode::loadProgram(options.file, loading);
  if (!program) {
    return reportError(program.error(), false);
  }
  if (const auto resampled = options.resampling.resample(*program); !resampled) {
    return reportError(resampled.error(), false);
  }
  const gcode::Trajectory& trajectory = program->trajectory;
  if (options.output.empty()) {
    print(trajectory, stdout);
  } else {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        base::openStreamToWrite(options.output), &std::fclose);
    if (!file) {
      return reportError(
          base::makeError(base::FileError::NotWritable,
                          "The file cannot be written. Check the folder and its permissions.",
                          options.output),
          false);
    }
    print(trajectory, file.get());
  }
  for (const gcode::Diagnostic& diagnostic : program->diagnostics) {
    if (diagnostic.severity == gcode::Severity::Error) {
      fmt::print(stderr, "{}:{}:{}: error: {}\n", program->name, diagnostic.line.value,
                 diagnostic.column, gcode::describe(diagnostic));
    }
  }
  return program->isUnderstood() ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
