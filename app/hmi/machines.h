// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machines that this computer knows: those of which facts are kept, and those on which runs
/// have ended here. Of those that are not connected, only the port is looked at.
/// @threadsafety GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/past_runs.h"
#include "hmi/run_controller.h"
#include "report/machine_store.h"
#include "session/port_check.h"
#include "widgets/connection/machines_page.h"

namespace rivulet::hmi {

class Machines final : public QObject {
  Q_OBJECT

 public:
  Machines(Document& document, MachineModel& machine, RunController& runs, PastRuns& pastRuns,
           report::MachineStore store);

  /// By name and endpoint; without the number of alarms. Machines that were removed are back as
  /// soon as a run has ended there.
  [[nodiscard]] std::vector<widgets::MachineCardView> cards() const;
  [[nodiscard]] bool canChange() const { return !m_runs.isRunning() && !m_runs.isCalibrating(); }
  /// Connects with another machine, unless it is connected already.
  void open(const QString& endpoint);
  /// Looks at the ports of all machines that are not connected, unless that was done a short while
  /// ago.
  void look();
  /// Its facts are put aside; its runs stay. Says why if that cannot be.
  void remove(const QString& endpoint);
  /// Reads the facts again.
  void refresh();

 Q_SIGNALS:
  /// Once, when all machines are known for the first time.
  void found();
  void changed();
  void removed(const QString& endpoint);
  void removeFailed(const rivulet::base::Error& error);

 private:
  [[nodiscard]] bool isConnectedWith(const std::string& endpoint) const;

  struct Look {
    bool isThere = false;
    qint64 atMs = 0;  ///< of `m_clock`
  };

  Document& m_document;
  MachineModel& m_machine;
  RunController& m_runs;
  report::MachineStore m_store;
  session::PortCheck m_portCheck;
  QElapsedTimer m_clock;
  std::optional<qint64> m_lookedAtMs;
  std::map<std::string, Look> m_looks;
  std::vector<report::KnownMachine> m_known;
  std::map<std::string, base::UtcMs> m_removed;
  std::shared_ptr<const report::HistoryList> m_history;  ///< null: not read yet
};

}  // namespace rivulet::hmi
