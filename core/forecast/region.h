// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The feasibility region by simulation instead of equations: whole runs in virtual time at the
/// points of a grid, with the production job and methods on the virtual machine, judged by the
/// oracle.
/// @threadsafety pure; the runs go through the executor, so on as many threads as it has.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "feasibility/probability.h"
#include "feasibility/sweep.h"
#include "gcode/feeds.h"
#include "streaming/simulation/scenario.h"

namespace rivulet::forecast {

/// Result of one simulated run.
enum class RunFate {
  Ran,        ///< every point once, in order, to the end
  Faulty,     ///< repeated, skipped, foreign or points out of order
  Stalled,    ///< no wrong motion, but the run did not finish
  Cancelled,  ///< not executed
  Refused,    ///< could not be started: see the error
};

/// "ran", "faulty", ...
[[nodiscard]] std::string_view runFateName(RunFate fate);

/// Runs one scenario and returns its result. A run that repeats forever is ended soon after its
/// program would have been completed: `stallDeadline` and `limit` are set here.
/// @param error set if the fate is Refused
[[nodiscard]] RunFate fateOf(streaming::Scenario scenario, base::Error* error = nullptr);

/// The points of a run: at most `count`, those around the point `around`. A section stands for a
/// long program.
[[nodiscard]] std::vector<gcode::StreamPoint> stretchOf(
    const std::vector<gcode::StreamPoint>& points, std::size_t around, std::size_t count);

/// The feeds of the program at 100 % become those that are commanded.
/// @param feeds  nothing: the run has one feed for all, and the points none
void commandFeeds(std::vector<gcode::StreamPoint>& points,
                  const std::optional<gcode::ProgramFeeds>& feeds);

/// The tool's position before a run of a region: a short distance above the first point. A section
/// begins somewhere in the program, and the move to it is not of interest. But if the tool were
/// within δ of the first point, method position would consider that point passed.
[[nodiscard]] base::Vec3 regionStartMm(const std::vector<gcode::StreamPoint>& points,
                                       double deltaMm);

/// The figures of the preset that the model of `feasibility/probability` uses.
[[nodiscard]] feasibility::StreamModel streamModelOf(const machine::MachineConfig& machine);

/// A grid of feeds and one more quantity.
struct RegionRequest {
  std::vector<gcode::StreamPoint> points;  ///< at least 2, workpiece frame
  streaming::RunSettings settings;         ///< method, N, δ, ...: all but the swept quantity
  machine::MachineConfig machine;          ///< rotary axes that it lacks are added
  feasibility::SweepAxis axis = feasibility::SweepAxis::PointDistance;
  /// d_min in mm (the program is scaled so that its d_min becomes this), N (whole numbers, as many
  /// as fit the control), or δ in mm; > 0
  std::vector<double> abscissas;
  std::vector<double> feedsMmPerS;  ///< > 0
  std::size_t seedsPerPoint = 5;    ///< runs with different seeds at each point of the grid
  std::uint64_t seed = 1;           ///< of the whole request
};

struct RegionPoint {
  double abscissa = 0.0;  ///< as in the request
  double feedMmPerS = 0.0;
  int pointsPerLoop = 0;
  double deltaMm = 0.0;
  double pointDistanceMmMin = 0.0;
  std::size_t runs = 0;
  std::size_t faulty = 0;   ///< of these
  std::size_t stalled = 0;  ///< and of these

  [[nodiscard]] std::size_t failures() const { return faulty + stalled; }
};

/// Called with the number of completed runs and of all runs. @return false: cancel. Called on the
/// threads of the executor, several at a time.
using RegionProgress = std::function<bool(std::size_t done, std::size_t total)>;

struct RegionResult {
  std::vector<RegionPoint> points;  ///< abscissas outside, feeds inside; runs = 0: not simulated
  bool cancelled = false;
  base::Error error;  ///< of the first run that was refused; code clear otherwise
};

/// Simulates the grid. The seed of each run depends only on the request's seed and the run's place
/// in the grid, so the result does not depend on the number of threads.
[[nodiscard]] RegionResult simulateRegion(const RegionRequest& request, base::Executor& executor,
                                          const RegionProgress& progress = {});

}  // namespace rivulet::forecast
