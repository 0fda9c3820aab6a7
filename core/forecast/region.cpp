// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "forecast/region.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/contract.h"
#include "base/random.h"
#include "forecast/planner_motion.h"

namespace rivulet::forecast {

namespace {

using feasibility::SweepAxis;

/// A run without progress is abandoned after this time.
constexpr base::Duration kStallDeadline = std::chrono::seconds{3};
/// A run that repeats points takes longer than planned. It is limited to the planned time
/// multiplied by this factor, plus this rest.
constexpr double kLimitFactor = 1.5;
constexpr double kLimitRestS = 5.0;
/// Distance from the start to the first point, in addition to δ.
constexpr double kApproachMm = 1.0;

/// Time at the programmed feed, plus a standstill at every signal.
double plannedSeconds(const streaming::Scenario& scenario) {
  const std::vector<gcode::TrajectoryPoint>& points = scenario.program->trajectory.points;
  double lengthMm = 0.0;
  double approachMm = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double wayMm = points.front().positionMm[axis] - scenario.machine.axes[axis].startMm;
    approachMm += std::isfinite(wayMm) ? std::abs(wayMm) : 0.0;
  }
  // Moves with their own feed count as long as the feed of the run goes in their time.
  const auto slower = [&](const gcode::TrajectoryPoint& point) {
    const auto& feeds = scenario.settings.programFeeds;
    return feeds ? scenario.settings.feedMmPerS / gcode::commandedMmPerS(point, *feeds) : 1.0;
  };
  approachMm *= slower(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double stepMm = base::distance(points[i - 1].positionMm, points[i].positionMm);
    lengthMm += std::isfinite(stepMm) ? stepMm * slower(points[i]) : 0.0;
  }
  const double stops = 2.0 * static_cast<double>(points.size()) /
                       static_cast<double>(scenario.settings.parameters.pointsPerLoop);
  return (lengthMm + approachMm) / scenario.settings.feedMmPerS +
         stops * 1.5 * base::toSeconds(scenario.machine.standstillMean);
}

/// The program at one abscissa of the grid.
std::shared_ptr<const gcode::Program> programAt(const std::vector<gcode::StreamPoint>& points,
                                                double scale, const base::RotarySet& rotaryAxes) {
  const base::Vec3 originMm = points.front().positionMm;
  std::vector<base::Vec3> positions;
  std::vector<base::RotaryDeg> angles;
  for (const gcode::StreamPoint& point : points) {
    positions.push_back(originMm + scale * (point.positionMm - originMm));
    angles.push_back(point.rotaryDeg);
  }
  auto program = std::make_shared<gcode::Program>(
      base::any(rotaryAxes) ? *streaming::programOf(positions, angles, rotaryAxes)
                            : *streaming::programOf(positions));
  for (std::size_t i = 0; i < points.size(); ++i) {
    program->trajectory.points[i].feedMmPerS = points[i].feedMmPerS;
  }
  return program;
}

/// The places of the region to be tried, feed by feed, and the program of each abscissa.
struct Grid {
  std::vector<RegionPoint> points;
  std::vector<std::shared_ptr<const gcode::Program>> programs;
};

Grid gridOf(const RegionRequest& request) {
  const double distanceMmMin = feasibility::programDistances(request.points, 2).pointDistanceMmMin;
  Grid grid;
  for (const double abscissa : request.abscissas) {
    RIVULET_ASSERT(abscissa > 0.0);
    const bool scales = request.axis == SweepAxis::PointDistance;
    const double scale = scales ? abscissa / distanceMmMin : 1.0;
    grid.programs.push_back(
        programAt(request.points, scale, request.settings.parameters.rotaryAxes));
    for (const double feedMmPerS : request.feedsMmPerS) {
      RIVULET_ASSERT(feedMmPerS > 0.0);
      RegionPoint point;
      point.abscissa = abscissa;
      point.feedMmPerS = feedMmPerS;
      point.pointsPerLoop = request.axis == SweepAxis::PointsPerLoop
                                ? static_cast<int>(std::lround(abscissa))
                                : request.settings.parameters.pointsPerLoop;
      point.deltaMm = request.axis == SweepAxis::Delta ? abscissa : request.settings.deltaMm;
      point.pointDistanceMmMin = distanceMmMin * scale;
      grid.points.push_back(point);
    }
  }
  return grid;
}

/// A run at one place of the region; its seed is still open.
streaming::Scenario scenarioAt(const RegionRequest& request, const Grid& grid, std::size_t at) {
  const RegionPoint& point = grid.points[at];
  streaming::Scenario scenario;
  scenario.machine =
      streaming::withRotaryAxes(request.machine, request.settings.parameters.rotaryAxes);
  scenario.program = grid.programs[at / request.feedsMmPerS.size()];
  const base::Vec3 startMm = regionStartMm(request.points, point.deltaMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    machine::AxisLimits& limits = scenario.machine.axes[axis];
    limits.startMm = std::clamp(startMm[axis], limits.positionMmMin, limits.positionMmMax);
  }
  scenario.settings = request.settings;
  scenario.settings.feedMmPerS = point.feedMmPerS;
  if (request.settings.programFeeds) {
    // The points carry the feeds at which the run is to be made.
    scenario.settings.programFeeds = gcode::ProgramFeeds{
        std::clamp(point.feedMmPerS / request.settings.feedMmPerS, gcode::kOverrideMin,
                   gcode::kOverrideMax),
        request.settings.programFeeds->rapidMmPerS, request.settings.programFeeds->feedMmPerSMax};
  }
  scenario.settings.deltaMm = point.deltaMm;
  scenario.settings.parameters.pointsPerLoop = point.pointsPerLoop;
  return scenario;
}

}  // namespace

std::string_view runFateName(RunFate fate) {
  switch (fate) {
    case RunFate::Ran:
      return "ran";
    case RunFate::Faulty:
      return "faulty";
    case RunFate::Stalled:
      return "stalled";
    case RunFate::Cancelled:
      return "cancelled";
    case RunFate::Refused:
      break;
  }
  return "refused";
}

RunFate fateOf(streaming::Scenario scenario, base::Error* error) {
  scenario.settings.stallDeadline = kStallDeadline;
  scenario.settings.isCommissioned = true;  // the virtual machine needs no commissioning test
  scenario.limit = base::fromSeconds(kLimitFactor * plannedSeconds(scenario) + kLimitRestS);
  const streaming::RunReport report = streaming::simulate(scenario);
  const trace::Integrity& integrity = report.integrity;
  if (integrity.judged && !integrity.isFaultless()) {
    return RunFate::Faulty;
  }
  if (integrity.judged && report.outcome == streaming::Outcome::Completed) {
    return RunFate::Ran;
  }
  using streaming::StreamError;
  const std::error_code code = report.error.code;
  if (integrity.judged &&
      (!code || code == StreamError::StreamStalled || code == StreamError::StopNotConfirmed ||
       code == StreamError::EndedEarly)) {
    return RunFate::Stalled;
  }
  if (error != nullptr) {
    *error = report.error;
  }
  return RunFate::Refused;
}

std::vector<gcode::StreamPoint> stretchOf(const std::vector<gcode::StreamPoint>& points,
                                          std::size_t around, std::size_t count) {
  RIVULET_ASSERT(around < points.size() || points.empty());
  const std::size_t length = std::min(count, points.size());
  const std::size_t from = std::min(around - std::min(around, count / 2), points.size() - length);
  const auto begin = points.begin() + static_cast<std::ptrdiff_t>(from);
  return {begin, begin + static_cast<std::ptrdiff_t>(length)};
}

void commandFeeds(std::vector<gcode::StreamPoint>& points,
                  const std::optional<gcode::ProgramFeeds>& feeds) {
  for (gcode::StreamPoint& point : points) {
    gcode::TrajectoryPoint asWritten;
    asWritten.kind = point.kind;
    asWritten.feedMmPerS = point.feedMmPerS;
    point.feedMmPerS = feeds ? gcode::commandedMmPerS(asWritten, *feeds) : 0.0;
  }
}

base::Vec3 regionStartMm(const std::vector<gcode::StreamPoint>& points, double deltaMm) {
  RIVULET_ASSERT(!points.empty());
  return points.front().positionMm + base::Vec3{0.0, 0.0, kApproachMm + 2.0 * deltaMm};
}

feasibility::StreamModel streamModelOf(const machine::MachineConfig& machine) {
  feasibility::StreamModel model;
  model.access = {machine.access.readOverhead, machine.access.writeOverhead,
                  machine.access.nodeTimeMean, machine.access.nodeTimeDeviation,
                  machine.access.nodeTimeMin};
  feasibility::ControlTimes& control = model.control;
  control.interpolationCycle = machine.interpolationCycle;
  control.standstillMean = machine.standstillMean;
  control.standstillDeviation = machine.standstillDeviation;
  control.relatch = machine.relatch;
  control.blockPreparation = machine.blockPreparation;
  control.accelerationMmPerS2 = machine.axes[0].accelerationMmPerS2Max;
  for (const machine::AxisLimits& axis : machine.axes) {
    control.accelerationMmPerS2 =
        std::min(control.accelerationMmPerS2, axis.accelerationMmPerS2Max);
  }
  control.servoLag = machine.followingLag();
  model.motion = std::make_shared<PlannerMotion>(machine);
  return model;
}

RegionResult simulateRegion(const RegionRequest& request, base::Executor& executor,
                            const RegionProgress& progress) {
  RIVULET_ASSERT(request.points.size() >= 2);
  RIVULET_ASSERT(request.seedsPerPoint > 0);
  const Grid grid = gridOf(request);
  const std::size_t total = grid.points.size() * request.seedsPerPoint;
  std::vector<RunFate> fates(total, RunFate::Cancelled);
  std::vector<base::Error> errors(total);
  std::atomic<bool> cancelled{false};
  std::atomic<std::size_t> done{0};
  executor.forEach(total, [&](std::size_t index) {
    if (cancelled) {
      return;
    }
    const std::size_t at = index / request.seedsPerPoint;
    streaming::Scenario scenario = scenarioAt(request, grid, at);
    scenario.seed = base::Random(request.seed).fork(index).bits();
    fates[index] = fateOf(std::move(scenario), &errors[index]);
    if (progress && !progress(++done, total)) {
      cancelled = true;
    }
  });

  RegionResult result;
  result.cancelled = cancelled;
  result.points = grid.points;
  for (std::size_t index = 0; index < total; ++index) {
    if (fates[index] == RunFate::Refused) {
      if (!result.error.code) {
        result.error = errors[index];
      }
    } else if (fates[index] != RunFate::Cancelled) {
      RegionPoint& point = result.points[index / request.seedsPerPoint];
      ++point.runs;
      point.faulty += fates[index] == RunFate::Faulty ? 1 : 0;
      point.stalled += fates[index] == RunFate::Stalled ? 1 : 0;
    }
  }
  return result;
}

}  // namespace rivulet::forecast
