// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A control that gives no right to its part programs: the programs as their users start them.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using nlohmann::json;
using rivulet::tests::MachineProcess;

namespace {

using rivulet::tests::kRunMs;
const QString kMachine = QStringLiteral(RIVULET_MACHINE_PROGRAM);

struct Outcome {
  int exit = -1;
  json result;
  QString errors;
};

Outcome runCli(const QStringList& arguments, const QString& folder) {
  QProcess process;
  process.setWorkingDirectory(folder);
  process.start(QStringLiteral(RIVULET_CLI), arguments);
  Outcome outcome;
  if (process.waitForFinished(kRunMs) && process.exitStatus() == QProcess::NormalExit) {
    outcome.exit = process.exitCode();
  }
  outcome.result =
      json::parse(process.readAllStandardOutput().toStdString(), nullptr, /*exceptions=*/false);
  outcome.errors = QString::fromUtf8(process.readAllStandardError());
  return outcome;
}

/// With no right to its part programs.
QStringList withoutRights(const QString& program = {}) {
  const QStringList arguments{QStringLiteral("--no-file-rights")};
  return program.isEmpty() ? arguments
                           : arguments + QStringList{QStringLiteral("--program"), program};
}

}  // namespace

class TestTransferByHand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theStepsLeadToARun() {
    const QTemporaryDir folder;
    QFile cam(folder.filePath(QStringLiteral("cam.nc")));
    QVERIFY(cam.open(QIODevice::WriteOnly));
    cam.write("G0 X0 Y0 Z50\nG1 X10 F3000\nY10\nX0\nY0\nM30\n");
    cam.close();
    const auto stream = [&](const MachineProcess& machine, const QStringList& more) {
      return runCli(QStringList{QStringLiteral("stream"), cam.fileName(), QStringLiteral("--json"),
                                QStringLiteral("--feed"), QStringLiteral("3000"),
                                QStringLiteral("--endpoint"), machine.endpoint()} +
                        more,
                    folder.path());
    };
    const QStringList byHand{QStringLiteral("--transfer"), QStringLiteral("by-hand"),
                             QStringLiteral("--program-file"),
                             QStringLiteral("RIVULET_WINDOW_7X2.MPF")};
    {
      const MachineProcess machine(kMachine, withoutRights());
      const Outcome refused = stream(machine, {});
      QCOMPARE(refused.exit, 1);
      const std::string message = refused.result["error"]["message"].get<std::string>();
      QVERIFY2(message.find("by hand") != std::string::npos, message.c_str());
      // Nothing was put there: the start fails, and the file for the operator is left.
      const Outcome tooEarly = stream(machine, byHand);
      QVERIFY(tooEarly.exit != 0);
      QVERIFY(tooEarly.errors.contains(QStringLiteral("Press cycle start")));
    }
    const QString program = folder.filePath(QStringLiteral("RIVULET_WINDOW_7X2.MPF"));
    QVERIFY(QFile::exists(program));
    const MachineProcess machine(kMachine, withoutRights(program));
    const Outcome done = stream(machine, byHand);
    QVERIFY2(done.exit == 0, qPrintable(done.errors));
    QCOMPARE(done.result["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(done.result["transfer"]["written"].get<bool>(), false);
    QCOMPARE(done.result["transfer"]["compared"].get<bool>(), false);
    QCOMPARE(done.result["executed"].get<int>(), 5);
  }

  void aWrongProgramOnTheControlIsNotDriven() {
    const QTemporaryDir folder;
    QFile cam(folder.filePath(QStringLiteral("cam.nc")));
    QVERIFY(cam.open(QIODevice::WriteOnly));
    cam.write("G0 X0 Y0 Z50\nG1 X10 F3000\nM30\n");
    cam.close();
    // The template of other settings waits on the control.
    QCOMPARE(runCli({QStringLiteral("template"), QStringLiteral("--points"), QStringLiteral("9"),
                     QStringLiteral("-o"), QStringLiteral("OTHER.MPF")},
                    folder.path())
                 .exit,
             0);
    const MachineProcess machine(kMachine,
                                 withoutRights(folder.filePath(QStringLiteral("OTHER.MPF"))));
    const Outcome wrong =
        runCli({QStringLiteral("stream"), cam.fileName(), QStringLiteral("--json"),
                QStringLiteral("--feed"), QStringLiteral("3000"), QStringLiteral("--endpoint"),
                machine.endpoint(), QStringLiteral("--transfer"), QStringLiteral("by-hand")},
               folder.path());
    QCOMPARE(wrong.exit, 1);
    const std::string message = wrong.result["error"]["message"].get<std::string>();
    QVERIFY2(message.find("another flexible program") != std::string::npos, message.c_str());
  }
};

RIVULET_TEST(TestTransferByHand)
#include "tst_transfer_by_hand.moc"
