// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Simulates the program that is to be started, with the settings it is to be started with, on the
/// virtual machine, before it is started: equations and averages do not see what scattered access
/// times do to this path. Outside the GUI thread; only the last request is reported.
/// @threadsafety GUI thread; the work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "feasibility/access_model.h"
#include "feasibility/verdict.h"
#include "gcode/trajectory.h"
#include "machine/config.h"
#include "streaming/run/run.h"

namespace rivulet::session {

struct RehearsalJob {
  /// Of the whole program, at least 2, with their feeds at 100 %.
  std::shared_ptr<const std::vector<gcode::StreamPoint>> points;
  std::size_t tightest = 0;         ///< index of the point where it is most difficult
  streaming::RunSettings settings;  ///< with the axes the program turns
  /// The machine it is simulated on; null: that of the paper.
  std::shared_ptr<const machine::MachineConfig> machine{};
  /// Cost of access; nothing: that of the virtual machine.
  std::optional<feasibility::MeasuredAccess> access;
};

struct RehearsalOutcome {
  std::size_t runs = 0;
  std::size_t faulty = 0;   ///< of these: points repeated, skipped or foreign
  std::size_t stalled = 0;  ///< and of these: moved right, but took much longer than planned
  std::size_t points = 0;   ///< that were simulated
  bool isWhole = false;     ///< all points of the program
  /// If runs were faulty: a feed at which none did, mm/s; nothing: none was found.
  std::optional<double> safeFeedMmPerS;
  /// Methods of [P1]: the verdict on the machine, stricter than that of the equations.
  std::optional<feasibility::Verdict> verdict;
  base::Error error;  ///< a run could not be simulated; code clear otherwise

  [[nodiscard]] bool hasFailed() const { return faulty > 0; }
};

/// The work itself. @param stop  set by another thread: give up  @threadsafety pure
[[nodiscard]] RehearsalOutcome rehearse(const RehearsalJob& job, const std::atomic<bool>& stop);

class Rehearsal final : public QObject {
  Q_OBJECT

 public:
  explicit Rehearsal(QObject* parent = nullptr) : QObject(parent) {}
  ~Rehearsal() override { cancel(); }

  /// Begins; work in progress is dropped. @param key  comes back with the outcome
  void start(RehearsalJob job, const std::string& key);
  void cancel();

 Q_SIGNALS:
  void finished(const std::shared_ptr<const rivulet::session::RehearsalOutcome>& outcome,
                const std::string& key);

 private:
  std::shared_ptr<std::atomic<bool>> m_stop;  ///< of the work in progress; null: none
};

}  // namespace rivulet::session
