// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/rehearsal.h"

#include <algorithm>
#include <array>

#include "forecast/machine_verdict.h"
#include "forecast/region.h"
#include "report/known_machine.h"
#include "report/operating_point.h"
#include "session/background.h"

namespace rivulet::session {

namespace {

/// Points of a program that are simulated at most.
constexpr std::size_t kRehearsedPointsMax = 1500;
constexpr std::size_t kRuns = 3;
/// Shares of the wanted feed that are tried if it fails, until one does not.
constexpr std::array<double, 7> kSlower{0.9, 0.8, 0.65, 0.5, 0.35, 0.2, 0.1};

class SameThread final : public base::Executor {
 public:
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    for (std::size_t index = 0; index < count; ++index) {
      job(index);
    }
  }
};

}  // namespace

RehearsalOutcome rehearse(const RehearsalJob& job, const std::atomic<bool>& stop) {
  RehearsalOutcome outcome;
  machine::MachineConfig machine = job.machine ? *job.machine : report::configOf(nullptr);
  if (base::isPublished(job.settings.parameters.method)) {
    const feasibility::OperatingPoint point = report::operatingPointOf(job.settings);
    feasibility::AccessModel access;
    access.measured = job.access;
    std::vector<gcode::StreamPoint> points = *job.points;
    forecast::commandFeeds(points, job.settings.programFeeds);
    const auto verdict = forecast::judgeOn(
        machine, points, point,
        feasibility::programDistances(points, point.pointsPerLoop, point.feedMmPerS), access);
    if (verdict) {
      outcome.verdict = *verdict;
    }
  }
  if (job.access) {
    forecast::charge(machine.access, *job.access);
  }
  forecast::RegionRequest request;
  request.points = forecast::stretchOf(*job.points, job.tightest, kRehearsedPointsMax);
  forecast::commandFeeds(request.points, job.settings.programFeeds);
  request.settings = job.settings;
  request.settings.resume.reset();
  request.machine = machine;
  request.axis = feasibility::SweepAxis::PointsPerLoop;
  request.abscissas = {static_cast<double>(job.settings.parameters.pointsPerLoop)};
  request.seedsPerPoint = kRuns;
  outcome.points = request.points.size();
  outcome.isWhole = outcome.points == job.points->size();
  const auto at = [&](double feedMmPerS) {
    SameThread executor;
    request.feedsMmPerS = {feedMmPerS};
    return forecast::simulateRegion(request, executor,
                                    [&](std::size_t, std::size_t) { return !stop.load(); });
  };
  const forecast::RegionResult wanted = at(job.settings.feedMmPerS);
  outcome.error = wanted.error;
  outcome.runs = wanted.points.front().runs;
  outcome.faulty = wanted.points.front().faulty;
  outcome.stalled = wanted.points.front().stalled;
  if (!outcome.hasFailed()) {
    return outcome;
  }
  for (const double share : kSlower) {
    const double feedMmPerS = share * job.settings.feedMmPerS;
    const forecast::RegionResult slower = at(feedMmPerS);
    const forecast::RegionPoint& point = slower.points.front();
    if (point.runs == kRuns && point.faulty == 0) {
      outcome.safeFeedMmPerS = feedMmPerS;
      break;
    }
  }
  return outcome;
}

void Rehearsal::cancel() {
  if (m_stop) {
    m_stop->store(true);
    m_stop.reset();
  }
}

void Rehearsal::start(RehearsalJob job, const std::string& key) {
  cancel();
  m_stop = std::make_shared<std::atomic<bool>>(false);
  inBackground(
      this,
      [stop = m_stop, job = std::move(job)] {
        return std::make_shared<const RehearsalOutcome>(rehearse(job, *stop));
      },
      [stop = m_stop, key](Rehearsal& self,
                           const std::shared_ptr<const RehearsalOutcome>& outcome) {
        if (self.m_stop == stop) {
          self.m_stop.reset();
          Q_EMIT self.finished(outcome, key);
        }
      });
}

}  // namespace rivulet::session
