// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/control_tests.h"

#include <utility>

namespace rivulet::hmi {

ControlTests::ControlTests(session::StreamSession& session, MachineModel& machine,
                           RunController& runs, Document& document, report::MachineStore store)
    : m_session(session),
      m_machine(machine),
      m_runs(runs),
      m_document(document),
      m_store(std::move(store)) {
  connect(&m_machine, &MachineModel::linkChanged, this, &ControlTests::load);
  connect(&m_runs, &RunController::permissionsChanged, this, &ControlTests::permissionsChanged);
  connect(&m_session, &session::StreamSession::commissioningProgressed, this,
          [this](const session::CommissioningProgress& progress) {
            Q_EMIT progressed(progress.kind, progress.step);
          });
  connect(&m_session, &session::StreamSession::commissioningFinished, this, &ControlTests::take);
}

void ControlTests::take(const session::CommissioningFinished& finished) {
  if (finished.credit) {
    m_credit = finished.credit;
  }
  if (finished.feed) {
    m_feed = finished.feed;
  }
  if (finished.jobs) {
    m_jobs = finished.jobs;
  }
  if (finished.credit || finished.feed || finished.jobs) {
    tellProof();
    Q_EMIT testChanged();
  }
  Q_EMIT progressed(finished.kind, std::nullopt);
  if (finished.error.code) {
    Q_EMIT failed(finished.kind, finished.error);
  }
  Q_EMIT m_runs.permissionsChanged();
}

void ControlTests::start(session::CommissionCommand command) {
  if (blocked()) {
    return;
  }
  const session::TestKind kind = command.kind;
  m_session.commission(std::move(command));
  // Nobody reads the state of the control meanwhile, and its program may move an axis.
  m_machine.showRunning(QString::fromStdString(
      kind == session::TestKind::FeedCell ? streaming::feedTestFileName()
      : kind == session::TestKind::Credit ? streaming::commissioningFileName()
                                          : streaming::jobTestName()));
  Q_EMIT progressed(kind, streaming::CommissioningStep::CycleStart);
  Q_EMIT m_runs.permissionsChanged();
}

void ControlTests::confirmBlock(std::size_t index) {
  if (blocked() || !m_jobs || index >= m_jobs->result.tried.size()) {
    return;
  }
  streaming::TriedBlock& block = m_jobs->result.tried[index];
  block.witness = streaming::Witness::Operator;
  block.message = "The operator has seen it.";
  if (const base::Result<void> saved = m_store.save(*m_jobs); !saved) {
    Q_EMIT failed(session::TestKind::Jobs, saved.error());
  }
  tellProof();
  Q_EMIT testChanged();
}

void ControlTests::cancel() {
  if (isRunning()) {
    m_session.stop();
  }
}

void ControlTests::load() {
  m_credit.reset();
  m_feed.reset();
  m_jobs.reset();
  if (m_machine.isConnected()) {
    // A file that cannot be read counts as no test: nothing is promised by it.
    const std::string endpoint = m_machine.endpoint().toStdString();
    m_credit = m_store.creditTest(endpoint, m_machine.link().server).value_or(std::nullopt);
    m_feed = m_store.feedTest(endpoint, m_machine.link().server).value_or(std::nullopt);
    m_jobs = m_store.jobTest(endpoint, m_machine.link().server).value_or(std::nullopt);
  }
  tellProof();
  Q_EMIT testChanged();
}

void ControlTests::tellProof() {
  // Without a connection nobody knows on which machine a run will be.
  if (!m_machine.isConnected()) {
    m_document.setFeedProof(streaming::FeedProof::Proved, templates::kLiftMmMax);
    m_document.setJobRelease({});
    return;
  }
  const opcua::ServerIdentity& server = m_machine.link().server;
  const bool isVirtual = m_machine.view().isVirtualMachine;
  m_document.setFeedProof(streaming::feedProof(m_feed, server, isVirtual),
                          streaming::provedLiftMm(m_feed, server, isVirtual));
  m_document.setJobRelease({m_jobs, m_machine.endpoint().toStdString(), server, isVirtual});
}

}  // namespace rivulet::hmi
