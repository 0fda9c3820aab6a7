// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The tests that a control must pass: before method credit or whole jobs may run on it, and before
/// a stop is promised by the feed cell. The results are kept for the machine, as the command line
/// does it.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <optional>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/run_controller.h"
#include "report/machine_store.h"
#include "session/stream_session.h"

namespace rivulet::hmi {

class ControlTests final : public QObject {
  Q_OBJECT

 public:
  /// @param document  is told what is known of the feed cell
  ControlTests(session::StreamSession& session, MachineModel& machine, RunController& runs,
               Document& document, report::MachineStore store);

  /// Nothing stands in the way: begins. Else nothing happens; `blocked` says why.
  void start(session::CommissionCommand command);
  void cancel();
  /// The operator has seen the control execute this block of the test of whole jobs. Nothing
  /// happens where a test could not be started.
  void confirmBlock(std::size_t index);
  /// The rules are those of a calibration: connected, in reset, nothing else in progress.
  [[nodiscard]] std::optional<streaming::Blocked> blocked() const {
    return m_runs.calibrationBlocked();
  }
  [[nodiscard]] bool isRunning() const { return m_session.isCommissioning(); }
  /// The last test of method credit on the connected machine; nothing: none.
  [[nodiscard]] const std::optional<streaming::CreditTest>& test() const { return m_credit; }
  /// The same of the feed cell.
  [[nodiscard]] const std::optional<streaming::FeedTest>& feedTest() const { return m_feed; }
  /// The same of whole jobs.
  [[nodiscard]] const std::optional<streaming::JobTest>& jobTest() const { return m_jobs; }
  /// A test was made with another version of the server.
  template <class Test>
  [[nodiscard]] bool isOutdated(const std::optional<Test>& test) const {
    return test && m_machine.isConnected() &&
           streaming::versionText(test->server) != streaming::versionText(m_machine.link().server);
  }

 Q_SIGNALS:
  /// One of them.
  void testChanged();
  /// @param kind  of the test  @param step  nothing: it is over
  void progressed(rivulet::session::TestKind kind,
                  const std::optional<rivulet::streaming::CommissioningStep>& step);
  /// The test could not be made or not be stored.
  void failed(rivulet::session::TestKind kind, const rivulet::base::Error& error);
  /// What may be started, or why not, has changed.
  void permissionsChanged();

 private:
  void load();
  void take(const session::CommissioningFinished& finished);
  /// What the preflight says of a stop depends on it.
  void tellProof();

  session::StreamSession& m_session;
  MachineModel& m_machine;
  RunController& m_runs;
  Document& m_document;
  report::MachineStore m_store;
  std::optional<streaming::CreditTest> m_credit;
  std::optional<streaming::FeedTest> m_feed;
  std::optional<streaming::JobTest> m_jobs;
};

}  // namespace rivulet::hmi
