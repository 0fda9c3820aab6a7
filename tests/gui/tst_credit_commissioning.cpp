// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The credit test from the window, on the virtual machine: its result is kept for the machine.

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "hmi/credit_commissioning.h"
#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::CreditCommissioning;
using streaming::CommissioningStep;

namespace {

using rivulet::tests::kSoonMs;

struct Cell {
  machine::Machine machine{*machine::loadPreset("dmu75"), 1};
  streaming::SimulatedLink link{machine};
};

base::Result<opcua::Connection> connectToCell(const opcua::ConnectRequest& asked) {
  auto cell = std::make_shared<Cell>();
  return opcua::Connection{cell, &cell->link, &cell->link, asked.endpoint};
}

struct Models {
  explicit Models(const QTemporaryDir& folder)
      : store(report::MachineFolders::below(
            folder.filePath(QStringLiteral("data")).toStdString(),
            folder.filePath(QStringLiteral("config")).toStdString())) {}

  report::MachineStore store;
  hmi::Messages messages;
  session::StreamSession session{connectToCell, store};
  hmi::Document document{{}};
  hmi::MachineModel machine{session, store, messages};
  hmi::RunController runs{session, document, machine, messages};
  CreditCommissioning credit{session, machine, runs, store};
};

}  // namespace

class TestCreditCommissioning : public QObject {
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
      QVERIFY(models.credit.blocked()->reason == streaming::BlockReason::NotConnected);
      models.credit.start(0, false);
      QVERIFY(!models.credit.isRunning());
      models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
      QTRY_VERIFY_WITH_TIMEOUT(!models.credit.blocked(), kSoonMs);
      QVERIFY(!models.credit.test());
      QSignalSpy progressed(&models.credit, &CreditCommissioning::progressed);
      QSignalSpy changed(&models.credit, &CreditCommissioning::testChanged);
      models.credit.start(0, false);
      QVERIFY(models.credit.isRunning());
      // Meanwhile nothing else starts.
      QVERIFY(models.credit.blocked()->reason == streaming::BlockReason::CommissioningInProgress);
      QVERIFY(models.runs.startBlocked()->reason ==
              streaming::BlockReason::CommissioningInProgress);
      QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kSoonMs);
      QVERIFY(models.credit.test() && models.credit.test()->result.passed());
      QVERIFY(!models.credit.isOutdated());
      QTRY_VERIFY_WITH_TIMEOUT(!models.credit.isRunning(), kSoonMs);
      QVERIFY(!progressed.last()[0].value<std::optional<CommissioningStep>>());
    }
    // The next time it is known as soon as there is a connection.
    Models models(m_folder);
    QVERIFY(!models.credit.test());
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    QTRY_VERIFY_WITH_TIMEOUT(models.credit.test().has_value(), kSoonMs);
    QVERIFY(models.credit.test()->result.passed());
    models.machine.disconnectFrom();
    QTRY_VERIFY_WITH_TIMEOUT(!models.credit.test(), kSoonMs);
  }
};

RIVULET_TEST(TestCreditCommissioning)
#include "tst_credit_commissioning.moc"
