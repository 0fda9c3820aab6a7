// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/scenario.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "streaming/run/job.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::streaming {

namespace {

/// At this distance from the centre a drawn contour turns back, mm.
constexpr double kAreaMm = 100.0;
/// Standard deviation of the change of course from step to step, rad: a CAM contour has gentle
/// bends.
constexpr double kTurnRadDeviation = 0.15;
/// Greatest change of course per step on the way back, rad.
constexpr double kReturnTurnRad = 0.2;

/// Observes the run; requests a stop when the time is over.
class TimeLimit final : public RunSink, public RunOrders {
 public:
  explicit TimeLimit(base::Duration limit) : m_limit(limit) {}
  void update(const LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant now) override {
    if (!m_first) {
      m_first = now;
    }
    return now - *m_first >= m_limit;
  }

 private:
  base::Duration m_limit;
  std::optional<base::Instant> m_first;
};

}  // namespace

RunReport simulate(const Scenario& scenario, ServiceLoad* load) {
  machine::Machine machine(scenario.machine, scenario.seed);
  SimulatedLink link(machine);
  TimeLimit watcher(scenario.limit);
  RunReport report = runJob(link, link, *scenario.program, scenario.settings, watcher, watcher);
  if (load != nullptr) {
    *load = link.served();
  }
  return report;
}

std::shared_ptr<const gcode::Program> programOf(const std::vector<base::Vec3>& pointsMm) {
  auto program = std::make_shared<gcode::Program>();
  program->name = "contour";
  for (const base::Vec3& pointMm : pointsMm) {
    program->trajectory.points.push_back({});
    program->trajectory.points.back().positionMm = pointMm;
  }
  return program;
}

std::shared_ptr<const gcode::Program> programOf(const std::vector<base::Vec3>& pointsMm,
                                                const std::vector<base::RotaryDeg>& anglesDeg,
                                                const base::RotarySet& rotaryAxes) {
  auto program = std::make_shared<gcode::Program>(*programOf(pointsMm));
  for (const base::RotaryDeg& angles : anglesDeg) {
    gcode::RotaryPosition& at = program->trajectory.rotary.emplace_back();
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      at.degrees[axis] = rotaryAxes[axis] ? angles[axis] : at.degrees[axis];
    }
  }
  return program;
}

machine::MachineConfig withRotaryAxes(machine::MachineConfig machine,
                                      const base::RotarySet& rotaryAxes) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (rotaryAxes[axis] && !machine.rotaryAxes[axis]) {
      machine.rotaryAxes[axis] = machine::loadPreset("dmu75-5axis")->rotaryAxes[0];
    }
  }
  return machine;
}

std::vector<base::Vec3> drawContour(const ContourOptions& options, base::Random& random) {
  std::vector<base::Vec3> points;
  base::Vec3 at{};
  double courseRad = 0.0;
  for (std::size_t i = 0; i < options.points; ++i) {
    points.push_back(at);
    const double stepMm =
        options.pointDistanceMmMin +
        (options.restMmMean > 0.0 ? options.restMmMean * random.exponential() : 0.0);
    courseRad += kTurnRadDeviation * random.normal();
    if (base::norm(at) > kAreaMm) {
      const double homeRad =
          std::remainder(std::atan2(-at.y, -at.x) - courseRad, 2.0 * std::numbers::pi);
      courseRad += std::clamp(homeRad, -kReturnTurnRad, kReturnTurnRad);
    }
    at = at + stepMm * base::Vec3{std::cos(courseRad), std::sin(courseRad), 0.0};
  }
  return points;
}

}  // namespace rivulet::streaming
