// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Simulates the region around an operating point outside the GUI thread: a job goes in, its result
/// comes back in one queued signal.
/// @threadsafety GUI thread. The work is done by its own threads, which this class ends.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "forecast/region.h"

namespace rivulet::session {

/// Everything a simulation of the region needs.
struct RegionJob {
  std::vector<gcode::StreamPoint> points;  ///< at least 2: the section to be simulated
  streaming::RunSettings settings;
  feasibility::SweepAxis axis = feasibility::SweepAxis::PointDistance;
  std::vector<double> abscissas;  ///< see forecast::RegionRequest
  std::vector<double> feedsMmPerS;
  std::size_t seedsPerPoint = 4;
  std::shared_ptr<const machine::MachineConfig> machine{};  ///< null: that of the paper
};

/// Feeds at which one run of a thousand and half of the runs fail, by the extended model.
struct RegionBandPoint {
  double abscissa = 0.0;
  double rareMmPerS = 0.0;
  double halfMmPerS = 0.0;
};

struct RegionOutcome {
  RegionJob job;
  std::vector<forecast::RegionPoint> points;
  std::vector<RegionBandPoint> band;
  base::Error error;  ///< code clear if every run could be executed
};

class RegionWorker final : public QObject {
  Q_OBJECT

 public:
  explicit RegionWorker(QObject* parent = nullptr) : QObject(parent) {}
  /// Ends the work; takes as long as the run that is being simulated.
  ~RegionWorker() override;

  /// Begins a job; one in progress is cancelled.
  void start(RegionJob job);
  /// Of a cancelled job only `cancelled` is reported.
  void cancel();
  [[nodiscard]] bool isBusy() const { return m_busy; }

 Q_SIGNALS:
  void progressed(int percent);
  void finished(const std::shared_ptr<const rivulet::session::RegionOutcome>& outcome);
  void cancelled();

 private:
  void work(const RegionJob& job, int request, const std::stop_token& stop);
  void report(int request, int percent);

  std::jthread m_thread;
  int m_latest = 0;
  bool m_busy = false;
};

}  // namespace rivulet::session
