// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_scenario.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Random;
using base::Vec3;

/// Between low and high, evenly over the decades.
double drawLogarithmic(Random& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

Duration scaled(Duration duration, double factor) {
  return Duration{std::llround(static_cast<double>(duration.count()) * factor)};
}

std::vector<Vec3> drawPoints(Random& random) {
  const auto count = 1 + static_cast<std::size_t>(drawLogarithmic(random, 1.0, 160.0));
  const double stepMm = drawLogarithmic(random, 0.005, 5.0);
  const double wildness = random.below(3) == 0 ? 2.0 : 0.2;
  const bool planar = random.below(2) == 0;
  std::vector<Vec3> points;
  Vec3 at{};
  double course = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t kind = random.below(20);
    if (kind == 0 && !points.empty()) {
      at = points[random.below(points.size())];  // comes back to where it has been
    } else if (kind == 1 && points.size() > 1) {
      at = points[points.size() - 2];  // turns round
    } else {
      course += wildness * random.normal();
      const double step = stepMm * (random.below(8) == 0 ? 0.01 : 0.2 + random.exponential());
      at = at + Vec3{step * std::cos(course), step * std::sin(course),
                     planar ? 0.0 : 0.3 * step * random.normal()};
      if (base::norm(at) > 200.0) {
        at = {};
      }
    }
    points.push_back(at);
  }
  return points;
}

machine::MachineConfig vary(machine::MachineConfig machine, Random& random) {
  const double speed = drawLogarithmic(random, 0.1, 5.0);
  machine.access.readOverhead = scaled(machine.access.readOverhead, speed);
  machine.access.writeOverhead = scaled(machine.access.writeOverhead, speed);
  machine.access.nodeTimeMean = scaled(machine.access.nodeTimeMean, speed);
  machine.access.nodeTimeDeviation =
      scaled(machine.access.nodeTimeDeviation, speed * 2.0 * random.uniform());
  machine.relatch = scaled(machine.relatch, 2.0 * random.uniform());
  machine.standstillMean = scaled(machine.standstillMean, 2.0 * random.uniform());
  machine.blockPreparation = scaled(machine.blockPreparation, 0.1 + 4.0 * random.uniform());
  machine.bufferedBlocksMax = 1 + static_cast<int>(random.below(100));
  machine.jumpStops = random.below(4) == 0;
  machine.rRead = random.below(4) == 0 ? machine::RParameterReading::CachedUntilStopre
                                       : machine::RParameterReading::AtInterpretation;
  machine.resetDynamics = random.below(2) == 0 ? machine::Dynamics::Brisk : machine::Dynamics::Soft;
  machine.roundingMm = random.below(4) == 0 ? 0.0 : 0.02 * random.uniform();
  return machine;
}

}  // namespace

RandomScenario drawScenario(std::uint64_t seed, const machine::MachineConfig& preset) {
  Random random = Random(seed).fork(21);
  RandomScenario drawn;
  drawn.pointsMm = drawPoints(random);
  Scenario& scenario = drawn.scenario;
  scenario.machine = vary(preset, random);
  scenario.program = programOf(drawn.pointsMm);
  RunSettings& settings = scenario.settings;
  settings.parameters.method =
      random.below(2) == 0 ? base::MethodKind::Position : base::MethodKind::Signal;
  settings.parameters.pointsPerLoop = 2 + static_cast<int>(random.below(8));
  settings.parameters.layout =
      random.below(2) == 0 ? templates::Layout::Paper : templates::Layout::Contiguous;
  settings.deltaMm = drawLogarithmic(random, 0.01, 3.0);
  settings.feedMmPerS = base::mmPerSFromMmPerMin(drawLogarithmic(random, 100.0, 20000.0));
  settings.grouping = random.below(4) == 0 ? opcua::Grouping::Single : opcua::Grouping::List;
  settings.monitor = random.below(2) == 0;
  settings.stallDeadline = std::chrono::seconds{3};
  scenario.seed = seed;
  // A third of the runs is stopped at some moment.
  scenario.limit = random.below(3) == 0 ? base::fromSeconds(drawLogarithmic(random, 0.1, 60.0))
                                        : base::Duration{std::chrono::minutes{3}};
  return drawn;
}

}  // namespace rivulet::streaming
