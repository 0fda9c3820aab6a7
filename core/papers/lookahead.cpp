// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "papers/lookahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/units.h"
#include "papers/planned_run.h"
#include "training/recorded_run.h"

namespace rivulet::papers {

namespace {

using base::Result;
using base::Vec3;

/// A set point slower than this is at standstill.
constexpr double kStandingMmPerS = 1e-6;

/// From the first to the last motion, without programmed dwells (G4).
double movingSeconds(const std::vector<training::RecordedSample>& samples) {
  double seconds = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].pathMmPerS > kStandingMmPerS || samples[i - 1].pathMmPerS > kStandingMmPerS) {
      seconds += samples[i].timeS - samples[i - 1].timeS;
    }
  }
  return seconds;
}

/// Greatest share of the limits used, 1 for all.
double usageOf(const PlannedRun& run, const machine::MachineConfig& config) {
  const double h = base::toSeconds(config.interpolationCycle);
  double usage = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    for (std::size_t i = 2; i < run.commandsMm.size(); ++i) {
      const double before = run.commandsMm[i - 2][axis];
      const double middle = run.commandsMm[i - 1][axis];
      const double after = run.commandsMm[i][axis];
      usage = std::max({usage, std::abs(after - middle) / h / config.axes[axis].speedMmPerSMax,
                        std::abs(after - 2.0 * middle + before) / (h * h) /
                            config.axes[axis].accelerationMmPerS2Max});
    }
  }
  return usage;
}

/// Lowest path speed within reach of a corner.
template <class PositionOf, class SpeedOf>
double cornerSpeed(Vec3 cornerMm, double reachMm, std::size_t count, PositionOf positionOf,
                   SpeedOf speedOf) {
  double slowest = 1e9;
  for (std::size_t i = 0; i < count; ++i) {
    if (base::distance(positionOf(i), cornerMm) < reachMm) {
      slowest = std::min(slowest, speedOf(i));
    }
  }
  return slowest;
}

using PlannerChange = std::function<void(machine::MachineConfig&)>;

/// The machine that plans: the recorded one, unless a wrong one is asked for.
machine::MachineConfig planningMachine(double accelerationShare, const PlannerChange& wrong) {
  machine::MachineConfig config = recordedMachine(accelerationShare);
  if (wrong) {
    wrong(config);
  }
  return config;
}

Result<void> compareTimes(const std::filesystem::path& folder, const PlannerChange& wrong,
                          Experiment& result) {
  Table table{"Exact stop at every block, straight contours",
              {"contour", "blocks", "recorded (s)", "ours (s)", "deviation (%)"},
              {}};
  for (const char* name :
       {"G1_g61", "G2_g61", "G3_g61", "corners_F3000_g61", "star5_F3000_g61", "cam_F3000_g61"}) {
    const Result<training::RecordedRun> run = training::loadRecordedRun(folder, name);
    if (!run) {
      return base::fail(run.error());
    }
    const PlannedRun ours = planRun(run->blocks, run->samples.front().commandMm,
                                    planningMachine(kExactStopShare, wrong));
    const double recorded = movingSeconds(run->samples);
    table.rows.push_back({name, fmt::format("{}", run->blocks.size()),
                          fmt::format("{:.3f}", recorded), fmt::format("{:.3f}", ours.seconds),
                          fmt::format("{:+.2f}", 100.0 * (ours.seconds / recorded - 1.0))});
    Check check;
    check.what = fmt::format("cycle time of {}", name);
    check.unit = "s";
    check.source = "recording";
    check.reference = recorded;
    check.ours = ours.seconds;
    check.lowest = 0.97 * recorded;
    check.highest = 1.03 * recorded;
    check.mark = Mark::Fitted;  // the share of 0.9 was
    result.checks.push_back(check);
  }
  result.tables.push_back(std::move(table));
  return {};
}

Result<void> compareLimits(const std::filesystem::path& folder, const PlannerChange& wrong,
                           Experiment& result) {
  for (const char* name : {"G1_g64p001", "G2_g64p001", "G3_g64p001", "cam_F3000_g64p001",
                           "corners_F3000_g64p001", "star5_F3000_g64p001", "roundsq_r5_F3000_g61",
                           "roundsq_r5_F3000_g64p001", "circle_r10_g61", "circle_r25_g61"}) {
    const Result<training::RecordedRun> run = training::loadRecordedRun(folder, name);
    if (!run) {
      return base::fail(run.error());
    }
    // Half of the acceleration is kept for the way along an arc: a circle alone uses no more.
    constexpr double kLeastUse = 0.9;
    constexpr double kLeastUseOfCircle = 0.45;
    const bool isCircle = std::string_view(name).starts_with("circle");
    Check check;
    check.what = fmt::format("greatest use of an axis's speed or acceleration, {}", name);
    check.source = "limits of the recording";
    check.reference = 1.0;
    check.ours =
        usageOf(planRun(run->blocks, run->samples.front().commandMm, planningMachine(1.0, wrong)),
                recordedMachine(1.0));
    check.lowest = isCircle ? kLeastUseOfCircle : kLeastUse;
    check.highest = 1.0 + 1e-6;
    check.mark = Mark::ByConstruction;
    result.checks.push_back(check);
  }
  return {};
}

Result<void> compareCorners(const std::filesystem::path& folder, const PlannerChange& wrong,
                            Experiment& result) {
  const Result<training::RecordedRun> run =
      training::loadRecordedRun(folder, "corners_F3000_g64p001");
  if (!run) {
    return base::fail(run.error());
  }
  const PlannedRun ours =
      planRun(run->blocks, run->samples.front().commandMm, planningMachine(1.0, wrong));
  Table table{"Speed at corners between lines of 15 mm, F 3000, rounded within 0.01 mm",
              {"turn (°)", "recorded (mm/s)", "ours (mm/s)"},
              {}};
  Series recorded{"recorded planner", SeriesStyle::Points, true, {}, {}, {}};
  Series simulated{"virtual machine", SeriesStyle::Points, false, {}, {}, {}};
  Vec3 from = run->samples.front().commandMm;
  constexpr double kReachMm = 1.0;
  for (std::size_t i = 0; i + 1 < run->blocks.size(); ++i) {
    const Vec3 corner = run->blocks[i].targetMm;
    const Vec3 before = corner - from;
    const Vec3 after = run->blocks[i + 1].targetMm - corner;
    const double turn = std::acos(
        std::clamp(base::dot(before, after) / (base::norm(before) * base::norm(after)), -1.0, 1.0));
    const double degrees = turn * 180.0 / std::numbers::pi;
    from = corner;
    const double theirs = cornerSpeed(
        corner, kReachMm, run->samples.size(),
        [&](std::size_t k) { return run->samples[k].commandMm; },
        [&](std::size_t k) { return run->samples[k].pathMmPerS; });
    const double mine = cornerSpeed(
        corner, kReachMm, ours.commandsMm.size(), [&](std::size_t k) { return ours.commandsMm[k]; },
        [&](std::size_t k) { return ours.speeds[k]; });
    table.rows.push_back({fmt::format("{:.0f}", degrees), fmt::format("{:.2f}", theirs),
                          fmt::format("{:.2f}", mine)});
    recorded.x.push_back(degrees);
    recorded.y.push_back(theirs);
    simulated.x.push_back(degrees);
    simulated.y.push_back(mine);
  }
  result.tables.push_back(std::move(table));
  result.plots.push_back({"Corner speed over turn angle, rounded within 0.01 mm",
                          "turn (°)",
                          "lowest path speed at the corner (mm/s)",
                          {std::move(recorded), std::move(simulated)}});
  return {};
}

}  // namespace

Result<Experiment> runLookahead(const std::filesystem::path& folder, const PlannerChange& wrong) {
  Experiment result;
  result.name = "lookahead";
  result.title = "Look-ahead compared with another motion planner";
  result.setup =
      "The same programs as in the recordings, planned by the virtual machine with the limits of "
      "the recorded one (250, 200, 150 mm/s; 600, 500, 350 mm/s²; cycle 1 ms; no jerk limit). With "
      "exact stops the recorded planner uses 0.9 of the acceleration, so our planner is set to the "
      "same.";
  for (const auto compare : {compareTimes, compareLimits, compareCorners}) {
    if (const Result<void> done = compare(folder, wrong, result); !done) {
      return base::fail(done.error());
    }
  }
  result.notes = {
      "Both planners insert an arc within the tolerance between the lines. The recorded planner "
      "uses 500 mm/s² for every corner of the XY plane; ours uses the weaker axis of the arc's "
      "plane, which is the same here.",
      "The lowest path speed is read from samples 1 ms apart. Where the arc takes less time, the "
      "recorded planner's slowest moment may be between two samples.",
      "The recorded planner passes the smallest turns without slowing down and stops at the "
      "sharpest ones; ours stops beyond 172°."};
  return result;
}

}  // namespace rivulet::papers
