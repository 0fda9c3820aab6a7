// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A control that gives no right to its part programs: the programs as their users start them.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

constexpr int kPatienceMs = 120'000;

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
  if (process.waitForFinished(kPatienceMs) && process.exitStatus() == QProcess::NormalExit) {
    outcome.exit = process.exitCode();
  }
  outcome.result =
      json::parse(process.readAllStandardOutput().toStdString(), nullptr, /*exceptions=*/false);
  outcome.errors = QString::fromUtf8(process.readAllStandardError());
  return outcome;
}

/// Ended with the object.
class MachineProgram {
 public:
  explicit MachineProgram(const QStringList& arguments) {
    m_process.start(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                    QStringList{QStringLiteral("--port"), QStringLiteral("0")} + arguments);
    while (!m_process.canReadLine() && m_process.waitForReadyRead(kPatienceMs)) {
    }
    m_endpoint = QString::fromUtf8(m_process.readLine()).trimmed();
  }
  ~MachineProgram() {
    m_process.terminate();
    m_process.waitForFinished(kPatienceMs);
  }
  [[nodiscard]] QString endpoint() const { return m_endpoint; }

 private:
  QProcess m_process;
  QString m_endpoint;
};

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
    const auto stream = [&](const MachineProgram& machine, const QStringList& more) {
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
      const MachineProgram machine({QStringLiteral("--no-file-rights")});
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
    const MachineProgram machine(
        {QStringLiteral("--no-file-rights"), QStringLiteral("--program"), program});
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
    const MachineProgram machine({QStringLiteral("--no-file-rights"), QStringLiteral("--program"),
                                  folder.filePath(QStringLiteral("OTHER.MPF"))});
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

QTEST_GUILESS_MAIN(TestTransferByHand)
#include "tst_transfer_by_hand.moc"
