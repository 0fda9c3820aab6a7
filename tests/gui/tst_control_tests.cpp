// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The tests of a control from the window, on the virtual machine: its result is kept for the
/// machine.

#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "hmi/control_tests.h"
#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::ControlTests;
using streaming::CommissioningStep;

namespace {

using rivulet::tests::kSoonMs;

struct Cell {
  machine::Machine machine{*machine::loadPreset("dmu75"), 1};
  streaming::SimulatedLink link{machine};
};

opcua::Attempt connectToCell(const opcua::ConnectRequest& asked) {
  auto cell = std::make_shared<Cell>();
  return {opcua::Connection{cell, &cell->link, &cell->link, asked.endpoint}};
}

struct Models {
  explicit Models(const QTemporaryDir& folder, opcua::Connector connector = connectToCell)
      : store(
            report::MachineFolders::below(folder.filePath(QStringLiteral("data")).toStdString(),
                                          folder.filePath(QStringLiteral("config")).toStdString())),
        session(std::move(connector), store) {}

  report::MachineStore store;
  hmi::Messages messages;
  session::StreamSession session;
  hmi::Document document{{}};
  hmi::MachineModel machine{session, store, messages};
  hmi::RunController runs{session, document, machine, messages};
  ControlTests tests{session, machine, runs, document, store};
};

}  // namespace

class TestControlTests : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
  }

  void theResultIsKeptForTheMachine() {
    {
      Models models(m_folder);
      QVERIFY(models.tests.blocked()->reason == streaming::BlockReason::NotConnected);
      models.tests.start({});
      QVERIFY(!models.tests.isRunning());
      models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
      QTRY_VERIFY_WITH_TIMEOUT(!models.tests.blocked(), kSoonMs);
      QVERIFY(!models.tests.test());
      QSignalSpy progressed(&models.tests, &ControlTests::progressed);
      QSignalSpy changed(&models.tests, &ControlTests::testChanged);
      models.tests.start({});
      QVERIFY(models.tests.isRunning());
      // Meanwhile nothing else starts.
      QVERIFY(models.tests.blocked()->reason == streaming::BlockReason::CommissioningInProgress);
      QVERIFY(models.runs.startBlocked()->reason ==
              streaming::BlockReason::CommissioningInProgress);
      QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kSoonMs);
      QVERIFY(models.tests.test() && models.tests.test()->result.passed());
      QVERIFY(!models.tests.isOutdated(models.tests.test()));
      QTRY_VERIFY_WITH_TIMEOUT(!models.tests.isRunning(), kSoonMs);
      QVERIFY(!progressed.last()[1].value<std::optional<CommissioningStep>>());
    }
    // The next time it is known as soon as there is a connection.
    Models models(m_folder);
    QVERIFY(!models.tests.test());
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    QTRY_VERIFY_WITH_TIMEOUT(models.tests.test().has_value(), kSoonMs);
    QVERIFY(models.tests.test()->result.passed());
    models.machine.disconnectFrom();
    QTRY_VERIFY_WITH_TIMEOUT(!models.tests.test(), kSoonMs);
  }

  /// The test of the feed cell beside it; the virtual machine needs none for its promise.
  void theFeedCellIsKeptToo() {
    Models models(m_folder);
    models.machine.connectTo(QStringLiteral("opc.tcp://feed"));
    QTRY_VERIFY_WITH_TIMEOUT(!models.tests.blocked(), kSoonMs);
    QVERIFY(!models.tests.feedTest());
    QVERIFY(models.document.feedProof() == streaming::FeedProof::Proved);
    session::CommissionCommand command{session::TestKind::FeedCell};
    command.move = streaming::AirMove{0, 20.0, 400.0};
    models.tests.start(command);
    QTRY_VERIFY_WITH_TIMEOUT(models.tests.feedTest().has_value(), kSoonMs);
    QVERIFY(models.tests.feedTest()->result.proves());
    QVERIFY(!models.tests.test());
    const auto kept = models.store.feedTest("opc.tcp://feed", models.machine.link().server);
    QVERIFY(kept && *kept && (*kept)->result.proves());
  }

  /// On a control with real axes a whole job has only blocks that were tried.
  void theTestOfJobsReleasesThem() {
    tests::SimulatedControl control("dmu75-mill");
    control.passForReal();
    Models models(m_folder,
                  [&control](const auto& asked) { return control.connect(asked.endpoint); });
    QFile part(m_folder.filePath(QStringLiteral("part.mpf")));
    QVERIFY(part.open(QIODevice::WriteOnly));
    part.write("G17 G90 G94\nS500 M3\nG1 X5 F400\nM27\nG1 X9\nM30\n");
    part.close();
    models.document.open(part.fileName());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.view(), kSoonMs);
    models.document.chooseJob(true);
    QTRY_VERIFY_WITH_TIMEOUT(models.document.isJob(), kSoonMs);
    models.machine.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_VERIFY_WITH_TIMEOUT(!models.tests.blocked(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(!models.document.isJob(), kSoonMs);  // it has not been tested
    session::CommissionCommand command{session::TestKind::Jobs};
    command.move = streaming::AirMove{0, 20.0, 400.0};
    command.blocks = {"S500 M3", "M27"};
    models.tests.start(command);
    QVERIFY(models.machine.mayMove());
    QTRY_VERIFY_WITH_TIMEOUT(models.tests.jobTest().has_value(), kSoonMs);
    QVERIFY(models.tests.jobTest()->result.passed());
    QTRY_VERIFY_WITH_TIMEOUT(models.document.isJob(), kSoonMs);
    const auto blocked = [&] {
      const auto why = models.runs.startBlocked();
      return why && why->reason == streaming::BlockReason::BeyondMachine;
    };
    QTRY_VERIFY_WITH_TIMEOUT(blocked(), kSoonMs);
    QVERIFY(models.runs.startBlocked()->cause->message.find("Line 4: \"M27\"") !=
            std::string::npos);
    models.tests.confirmBlock(1);
    QVERIFY(!blocked());
    // Not without the machine.
    models.machine.disconnectFrom();
    QTRY_VERIFY_WITH_TIMEOUT(models.tests.blocked().has_value(), kSoonMs);
    models.tests.confirmBlock(0);
    models.machine.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_VERIFY_WITH_TIMEOUT(models.tests.jobTest().has_value(), kSoonMs);
    QVERIFY(models.tests.jobTest()->result.tried[0].witness == streaming::Witness::Control);
    const auto kept =
        models.store.jobTest(tests::SimulatedControl::endpoint(), models.machine.link().server);
    QVERIFY(kept && *kept && (*kept)->result.tried[1].witness == streaming::Witness::Operator);
  }

  /// An axis may move while a control is tested: the machine is seen as before, and Stop can be
  /// pressed and holds it.
  void stopHoldsTheAxisOfTheTest() {
    const tests::SimulatedControl control("dmu75", 5.0);
    Models models(m_folder,
                  [&control](const auto& asked) { return control.connect(asked.endpoint); });
    models.machine.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_VERIFY_WITH_TIMEOUT(!models.tests.blocked(), kSoonMs);
    QVERIFY(!models.machine.mayMove());
    QSignalSpy progressed(&models.tests, &ControlTests::progressed);
    QSignalSpy failed(&models.tests, &ControlTests::failed);
    session::CommissionCommand command{session::TestKind::FeedCell};
    command.move = streaming::AirMove{0, 200.0, 400.0};
    models.tests.start(command);
    QVERIFY(models.machine.mayMove());
    // The last look before the test is told after its start.
    session::MachineSeen before;
    before.channelStatus = opcua::kChannelReset;
    Q_EMIT models.session.machineSeen(before);
    QVERIFY(models.machine.mayMove());
    QTRY_VERIFY_WITH_TIMEOUT(progressed.size() >= 2, kSoonMs);
    QVERIFY(models.machine.mayMove());
    const base::Vec3 begin = models.machine.view().positionMm.value();
    QTRY_VERIFY_WITH_TIMEOUT(models.machine.view().positionMm.value() != begin, kSoonMs);
    models.runs.stop();
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kSoonMs);
    QCOMPARE(failed.first()[1].value<base::Error>().code,
             make_error_code(streaming::StreamError::Cancelled));
    QVERIFY(!models.tests.feedTest());
    QTRY_VERIFY_WITH_TIMEOUT(!models.tests.isRunning(), kSoonMs);
    // The program waits, held, until somebody ends it.
    QVERIFY(models.machine.mayMove());
  }

  /// Until it is proved, windows of a run take no longer than the machine's limit.
  void withoutProofWindowsAreShort() {
    hmi::Document document{{}};
    QCOMPARE(document.runSettings().windowSMax, 0.0);
    document.setFeedProof(streaming::FeedProof::WithoutMotion, 0.0);
    QCOMPARE(document.runSettings().windowSMax, 5.0);
    document.setStopLimit(3.0);
    QCOMPARE(document.runSettings().windowSMax, 3.0);
    document.setFeedProof(streaming::FeedProof::Proved, 0.0);
    QCOMPARE(document.runSettings().windowSMax, 0.0);
  }
};

RIVULET_TEST(TestControlTests)
#include "tst_control_tests.moc"
