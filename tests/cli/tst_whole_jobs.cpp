// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole jobs by the programs themselves: rivulet-cli in virtual time, and against a live
/// rivulet-machine over OPC UA, in real time.

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "support/machine_process.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;

namespace {

constexpr int kRunMs = 120'000;

const char* const kPart =
    "N10 G17 G90 G71\n"
    "T1 D1 M6\n"
    "S3000 M3\n"
    "G0 X5 Y5 Z2\n"
    "G1 Z-1 F2000\n"
    "X10\n"
    "Y10\n"
    "SUPA G0 Z20\n"
    "T2 M6\n"
    "G0 X1 Y1 Z17\n"
    "G91 G0 Z-3 M8\n"
    "G90 G1 X3 Y3 F1000\n"
    "M5 M9\n"
    "M30\n";

}  // namespace

class TestWholeJobs : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  [[nodiscard]] QString part(const char* text = kPart) const {
    QFile file(m_folder.filePath(QStringLiteral("part.mpf")));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) {
      qFatal("the test's folder cannot be written");
    }
    return file.fileName();
  }

  struct Outcome {
    int exit = -1;
    QByteArray output;
    QByteArray errors;
  };
  static Outcome run(const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(RIVULET_CLI), QStringList{QStringLiteral("job")} + arguments);
    if (!process.waitForFinished(kRunMs)) {
      process.kill();
      process.waitForFinished(kRunMs);
    }
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
  }

 private Q_SLOTS:
  void writesItsFiles() {
    const QString folder = m_folder.filePath(QStringLiteral("out"));
    const Outcome outcome = run({part(), QStringLiteral("-o"), folder});
    QCOMPARE(outcome.exit, 0);
    const QStringList files = QDir(folder).entryList(QDir::Files, QDir::Name);
    QCOMPARE(files.size(), 4);
    QVERIFY2(files.join(QLatin1Char(' ')).contains(QStringLiteral("README.txt")),
             qPrintable(files.join(QLatin1Char(' '))));
    QFile readMe(folder + QStringLiteral("/README.txt"));
    QVERIFY(readMe.open(QIODevice::ReadOnly));
    const QByteArray text = readMe.readAll();
    QVERIFY(text.contains("retract             SUPA G0 Z20"));
    for (const QString& name : files) {
      QVERIFY(name == QStringLiteral("README.txt") || name == QStringLiteral("job.json") ||
              text.contains(name.toUtf8()));
    }
  }

  void refusesWhatIsNoJob() {
    const Outcome outcome =
        run({part("G0 X1\nG999\n"), QStringLiteral("--simulate"), QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 2);
    QVERIFY(outcome.output.contains("G999"));
  }

  /// What is beyond the machine is said before anything moves.
  void refusesWhatTheMachineCannot() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE),
                                        {QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    const Outcome outcome = run({part("T99 M6\nG0 X500\nM30\n"), QStringLiteral("--endpoint"),
                                 machine.endpoint(), QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 2);
    const json result = json::parse(outcome.output.toStdString());
    QCOMPARE(result["hazards"].size(), std::size_t{2});
    QCOMPARE(result["hazards"][0]["line"].get<int>(), 1);
    QCOMPARE(result["hazards"][1]["axis"].get<std::string>(), std::string("X"));
    QCOMPARE(result["hazards"][1]["target"].get<double>(), 500.0);
    QVERIFY(result["error"]["message"].get<std::string>().find("tool T99") != std::string::npos);
  }

  void inVirtualTime() {
    const Outcome outcome = run({part(), QStringLiteral("--simulate"), QStringLiteral("--json")});
    QVERIFY2(outcome.exit == 0, outcome.output.constData());
    const json result = json::parse(outcome.output.toStdString());
    QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(result["runs"].size(), std::size_t{3});
    QCOMPARE(result["executed_points"].get<int>(), 6);
    QCOMPARE(result["reached"]["stretch"].get<int>(), 3);
    QVERIFY(result["times"]["streamed_s"].get<double>() > 0.0);
    QVERIFY(result["estimated"]["total_s"].get<double>() > 0.0);
  }

  /// The control has no more to do when the client is done: it is in reset, and can be started
  /// again.
  void overOpcUa() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE));
    QVERIFY(!machine.endpoint().isEmpty());
    for (int round = 0; round < 2; ++round) {
      const Outcome outcome =
          run({part(), QStringLiteral("--endpoint"), machine.endpoint(), QStringLiteral("--json")});
      QVERIFY2(outcome.exit == 0, (outcome.output + outcome.errors).constData());
      const json result = json::parse(outcome.output.toStdString());
      QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
      QCOMPARE(result["executed_points"].get<int>(), 6);
      QCOMPARE(result["runs"][1]["start_mm"].size(), std::size_t{3});
    }
  }
};

RIVULET_TEST(TestWholeJobs)
#include "tst_whole_jobs.moc"
