// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/region_worker.h"

#include <QMetaObject>
#include <algorithm>

#include "report/known_machine.h"
#include "report/operating_point.h"

namespace rivulet::session {

namespace {

/// The runs take most of the time, the band the rest.
constexpr int kBandPercent = 30;

/// One thread per processor, except the one that draws the window.
class ThreadExecutor final : public base::Executor {
 public:
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    const std::size_t processors = std::max(2U, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    const auto drain = [&] {
      for (std::size_t index = next++; index < count; index = next++) {
        job(index);
      }
    };
    std::vector<std::jthread> helpers;
    for (std::size_t i = 0; i + 2 < processors; ++i) {
      helpers.emplace_back(drain);
    }
    drain();
  }
};

/// The job at one abscissa, as input of the model.
RegionBandPoint bandAt(const RegionJob& job, double abscissa,
                       const feasibility::StreamModel& model) {
  feasibility::OperatingPoint point = report::operatingPointOf(job.settings);
  point.feedMmPerS = 1.0;
  std::vector<gcode::StreamPoint> points = job.points;
  switch (job.axis) {
    case feasibility::SweepAxis::PointDistance: {
      const double scale = abscissa / feasibility::programDistances(points, 2).pointDistanceMmMin;
      const base::Vec3 originMm = points.front().positionMm;
      for (gcode::StreamPoint& each : points) {
        each.positionMm = originMm + scale * (each.positionMm - originMm);
      }
      break;
    }
    case feasibility::SweepAxis::PointsPerLoop:
      point.pointsPerLoop = static_cast<int>(std::lround(abscissa));
      break;
    case feasibility::SweepAxis::Delta:
      point.deltaMm = abscissa;
      break;
  }
  const double slowest = 0.1 * job.feedsMmPerS.front();
  const double fastest = 2.0 * job.feedsMmPerS.back();
  return {abscissa, feasibility::feedMmPerSAt(1e-3, points, point, model, slowest, fastest),
          feasibility::feedMmPerSAt(0.5, points, point, model, slowest, fastest)};
}

}  // namespace

RegionWorker::~RegionWorker() {
  // Joined here, before anything that the thread uses is destroyed.
  m_thread = {};
}

void RegionWorker::start(RegionJob job) {
  cancel();
  const int request = ++m_latest;
  m_busy = true;
  m_thread = std::jthread([this, job = std::move(job), request](const std::stop_token& stop) {
    work(job, request, stop);
  });
}

void RegionWorker::cancel() {
  if (!m_busy) {
    return;
  }
  m_busy = false;
  ++m_latest;
  m_thread.request_stop();
  Q_EMIT cancelled();
}

void RegionWorker::report(int request, int percent) {
  QMetaObject::invokeMethod(
      this,
      [this, request, percent] {
        if (request == m_latest) {
          Q_EMIT progressed(percent);
        }
      },
      Qt::QueuedConnection);
}

void RegionWorker::work(const RegionJob& job, int request, const std::stop_token& stop) {
  auto outcome = std::make_shared<RegionOutcome>();
  outcome->job = job;
  const machine::MachineConfig machine = job.machine ? *job.machine : report::configOf(nullptr);
  const feasibility::StreamModel model = forecast::streamModelOf(machine);
  std::atomic<int> shown{0};
  const auto show = [&](int percent) {
    if (int before = shown; percent > before && shown.compare_exchange_strong(before, percent)) {
      report(request, percent);
    }
  };
  ThreadExecutor executor;
  outcome->band.resize(job.abscissas.size());
  std::atomic<int> bands{0};
  executor.forEach(job.abscissas.size(), [&](std::size_t index) {
    if (!stop.stop_requested()) {
      outcome->band[index] = bandAt(job, job.abscissas[index], model);
      show(kBandPercent * ++bands / static_cast<int>(job.abscissas.size()));
    }
  });
  forecast::RegionRequest wanted;
  wanted.points = job.points;
  wanted.settings = job.settings;
  wanted.machine = machine;
  wanted.axis = job.axis;
  wanted.abscissas = job.abscissas;
  wanted.feedsMmPerS = job.feedsMmPerS;
  wanted.seedsPerPoint = job.seedsPerPoint;
  forecast::RegionResult result =
      forecast::simulateRegion(wanted, executor, [&](std::size_t done, std::size_t total) {
        show(kBandPercent + static_cast<int>((100 - kBandPercent) * done / total));
        return !stop.stop_requested();
      });
  outcome->points = std::move(result.points);
  outcome->error = std::move(result.error);
  QMetaObject::invokeMethod(
      this,
      [this, request, outcome] {
        if (request == m_latest) {
          m_busy = false;
          Q_EMIT finished(outcome);
        }
      },
      Qt::QueuedConnection);
}

}  // namespace rivulet::session
