// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/credit_commissioning.h"

#include <utility>

namespace rivulet::hmi {

CreditCommissioning::CreditCommissioning(session::StreamSession& session, MachineModel& machine,
                                         RunController& runs, report::MachineStore store)
    : m_session(session), m_machine(machine), m_runs(runs), m_store(std::move(store)) {
  connect(&m_machine, &MachineModel::linkChanged, this, &CreditCommissioning::load);
  connect(&m_runs, &RunController::permissionsChanged, this,
          &CreditCommissioning::permissionsChanged);
  connect(
      &m_session, &session::StreamSession::commissioningProgressed, this,
      [this](const session::CommissioningProgress& progress) { Q_EMIT progressed(progress.step); });
  connect(&m_session, &session::StreamSession::commissioningFinished, this,
          [this](const session::CommissioningFinished& finished) {
            if (finished.test) {
              m_test = finished.test;
              Q_EMIT testChanged();
            }
            Q_EMIT progressed(std::nullopt);
            if (finished.error.code) {
              Q_EMIT failed(finished.error);
            }
            Q_EMIT m_runs.permissionsChanged();
          });
}

void CreditCommissioning::start(int firstCell, bool isByHand) {
  if (blocked()) {
    return;
  }
  m_session.commission(firstCell,
                       isByHand ? streaming::TransferWay::ByHand : streaming::TransferWay::Link);
  Q_EMIT progressed(streaming::CommissioningStep::CycleStart);
  Q_EMIT m_runs.permissionsChanged();
}

void CreditCommissioning::cancel() {
  if (isRunning()) {
    m_session.stop();
  }
}

bool CreditCommissioning::isOutdated() const {
  return m_test && m_machine.isConnected() &&
         streaming::versionText(m_test->server) != streaming::versionText(m_machine.link().server);
}

void CreditCommissioning::load() {
  std::optional<streaming::CreditTest> test;
  if (m_machine.isConnected()) {
    // A file that cannot be read counts as no test: method credit does not start.
    test = m_store.creditTest(m_machine.endpoint().toStdString(), m_machine.link().server)
               .value_or(std::nullopt);
  }
  m_test = std::move(test);
  Q_EMIT testChanged();
}

}  // namespace rivulet::hmi
