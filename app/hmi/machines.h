// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machines that this computer knows: those of which facts are kept, and those on which runs
/// have ended here. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/past_runs.h"
#include "hmi/run_controller.h"
#include "report/machine_store.h"
#include "widgets/connection/machines_page.h"

namespace rivulet::hmi {

class Machines final : public QObject {
  Q_OBJECT

 public:
  Machines(Document& document, MachineModel& machine, RunController& runs, PastRuns& pastRuns,
           report::MachineStore store);

  /// By name and endpoint; without the number of alarms.
  [[nodiscard]] std::vector<widgets::MachineCardView> cards() const;
  [[nodiscard]] bool canChange() const { return !m_runs.isRunning() && !m_runs.isCalibrating(); }
  /// Connects with another machine, unless it is connected already.
  void open(const QString& endpoint);
  /// Reads the facts again.
  void refresh();

 Q_SIGNALS:
  /// Once, when all machines are known for the first time.
  void found();
  void changed();

 private:
  Document& m_document;
  MachineModel& m_machine;
  RunController& m_runs;
  report::MachineStore m_store;
  std::vector<report::KnownMachine> m_known;
  std::shared_ptr<const report::HistoryList> m_history;  ///< null: not read yet
};

}  // namespace rivulet::hmi
