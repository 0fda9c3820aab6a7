// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test that a control must pass before method credit may run on it. The result is kept for the
/// machine, as the command line does it. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <optional>

#include "hmi/machine_model.h"
#include "hmi/run_controller.h"
#include "report/machine_store.h"
#include "session/stream_session.h"

namespace rivulet::hmi {

class CreditCommissioning final : public QObject {
  Q_OBJECT

 public:
  CreditCommissioning(session::StreamSession& session, MachineModel& machine, RunController& runs,
                      report::MachineStore store);

  /// Nothing stands in the way: begins. Else nothing happens; `blocked` says why.
  void start(int firstCell, bool isByHand);
  void cancel();
  /// The rules are those of a calibration: connected, in reset, nothing else in progress.
  [[nodiscard]] std::optional<streaming::Blocked> blocked() const {
    return m_runs.calibrationBlocked();
  }
  [[nodiscard]] bool isRunning() const { return m_session.isCommissioning(); }
  /// The last test of the connected machine; nothing: none.
  [[nodiscard]] const std::optional<streaming::CreditTest>& test() const { return m_test; }
  /// It was made with another version of the server.
  [[nodiscard]] bool isOutdated() const;

 Q_SIGNALS:
  void testChanged();
  /// @param step  nothing: no test is in progress
  void progressed(const std::optional<rivulet::streaming::CommissioningStep>& step);
  /// The test could not be made or not be stored.
  void failed(const rivulet::base::Error& error);
  /// What may be started, or why not, has changed.
  void permissionsChanged();

 private:
  void load();

  session::StreamSession& m_session;
  MachineModel& m_machine;
  RunController& m_runs;
  report::MachineStore m_store;
  std::optional<streaming::CreditTest> m_test;
};

}  // namespace rivulet::hmi
