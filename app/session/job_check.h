// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Compares a whole job with the machine that is to run it, as the command line does: travel,
/// spindle and tools. Outside the GUI thread; only the last request is reported.
/// @threadsafety GUI thread; the work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <atomic>
#include <memory>

#include "forecast/job_forecast.h"

namespace rivulet::session {

class JobCheck final : public QObject {
  Q_OBJECT

 public:
  explicit JobCheck(QObject* parent = nullptr) : QObject(parent) {}
  ~JobCheck() override { cancel(); }

  /// Begins; work in progress is dropped.
  void start(std::shared_ptr<const job::Plan> plan,
             std::shared_ptr<const machine::MachineConfig> machine);
  void cancel();

 Q_SIGNALS:
  void finished(const std::shared_ptr<const rivulet::forecast::CheckedJob>& checked);

 private:
  std::shared_ptr<std::atomic<bool>> m_wanted;  ///< of the work in progress; null: none
};

}  // namespace rivulet::session
