// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/scenario.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "streaming/job.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::streaming {

namespace {

/// Half the side of the square a drawn contour stays in, mm.
constexpr double kAreaMm = 100.0;
/// Standard deviation of the change of course from step to step, rad: a CAM contour bends gently.
constexpr double kTurnRadDeviation = 0.15;

/// Looks on; orders a stop when the time is over.
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

RunReport simulate(const Scenario& scenario) {
  machine::Machine machine(scenario.machine, scenario.seed);
  SimulatedLink link(machine);
  TimeLimit watcher(scenario.limit);
  return runJob(link, link, *scenario.program, scenario.settings, watcher, watcher);
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
    base::Vec3 next =
        at + base::Vec3{stepMm * std::cos(courseRad), stepMm * std::sin(courseRad), 0};
    if (std::abs(next.x) > kAreaMm || std::abs(next.y) > kAreaMm) {
      courseRad = std::atan2(-at.y, -at.x);
      next = at + base::Vec3{stepMm * std::cos(courseRad), stepMm * std::sin(courseRad), 0};
    }
    at = next;
  }
  return points;
}

}  // namespace rivulet::streaming
