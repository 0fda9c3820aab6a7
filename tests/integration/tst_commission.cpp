// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The tests of a control over OPC UA, as their user meets them, by the programs: method credit is
/// refused, tested, allowed; whole jobs are tested, with permissions that come late and a client
/// that is lost.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;

struct Outcome {
  int exit = -1;
  nlohmann::json json;
};

}  // namespace

class TestCommission : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  Outcome run(const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_folder.path());
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RIVULET_CLI), arguments + QStringList{QStringLiteral("--json")});
    Outcome outcome;
    if (process.waitForFinished(kRunMs) && process.exitStatus() == QProcess::NormalExit) {
      outcome.exit = process.exitCode();
    }
    outcome.json =
        nlohmann::json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);
    return outcome;
  }

  QString write(const char* name, const QByteArray& text) {
    QFile file(m_folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      qFatal("the test's folder cannot be written");
    }
    return file.fileName();
  }

 private Q_SLOTS:
  void refusedTestedAllowed_data() {
    QTest::addColumn<QByteArray>("rRead");
    QTest::addColumn<bool>("passes");
    QTest::newRow("at interpretation") << QByteArray("atInterpretation") << true;
    QTest::newRow("cached until STOPRE") << QByteArray("cachedUntilStopre") << false;
  }

  void refusedTestedAllowed() {
    QFETCH(QByteArray, rRead);
    QFETCH(bool, passes);
    QFile preset(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    QVERIFY(preset.open(QIODevice::ReadOnly));
    QByteArray text = preset.readAll();
    QVERIFY(text.contains("atInterpretation"));
    const QString config = write("machine.toml", text.replace("atInterpretation", rRead));
    QByteArray program("G90 G1 F1000\n");
    for (int i = 1; i <= 20; ++i) {
      program += "X" + QByteArray::number(0.4 * i) + " Y" + QByteArray::number(0.1 * i) + "\n";
    }
    const QString path = write("line.nc", program + "M30\n");

    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                        {QStringLiteral("--preset"), config});
    const QString& endpoint = machine.endpoint();
    QVERIFY2(endpoint.startsWith(QLatin1String("opc.tcp://")), qPrintable(endpoint));
    const QStringList stream{QStringLiteral("stream"),     path,
                             QStringLiteral("--method"),   QStringLiteral("credit"),
                             QStringLiteral("--feed"),     QStringLiteral("400"),
                             QStringLiteral("--endpoint"), endpoint};

    const Outcome refused = run(stream);
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.json["error"]["message"].get<std::string>().find("has not been tested") !=
            std::string::npos);

    const Outcome test =
        run({QStringLiteral("commission"), QStringLiteral("--endpoint"), endpoint});
    QCOMPARE(test.exit, passes ? 0 : 1);
    QCOMPARE(test.json["passed"].get<bool>(), passes);
    QVERIFY(!test.json["server"]["version"].get<std::string>().empty());

    const Outcome then = run(stream);
    QCOMPARE(then.exit, passes ? 0 : 2);
    if (passes) {
      QCOMPARE(then.json["outcome"].get<std::string>(), std::string("completed"));
      QVERIFY(then.json["faultless"].get<bool>());
      QCOMPARE(then.json["executed"].get<int>(), 20);
    } else {
      QVERIFY(then.json["error"]["message"].get<std::string>().find("failed the test") !=
              std::string::npos);
    }
  }

  void wholeJobsAreTested() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                        {QStringLiteral("--preset"), QStringLiteral("dmu75-mill")});
    const Outcome test =
        run({QStringLiteral("commission"), QStringLiteral("--jobs"), QStringLiteral("--air-move"),
             QStringLiteral("Y20"), QStringLiteral("--feed"), QStringLiteral("600"),
             QStringLiteral("--block"), QStringLiteral("S500 M3"), QStringLiteral("--block"),
             QStringLiteral("M27"), QStringLiteral("--endpoint"), machine.endpoint()});
    QVERIFY2(test.exit == 0, test.json.dump(1).c_str());
    QVERIFY(test.json["passed"].get<bool>());
    QCOMPARE(test.json["tried"].size(), std::size_t{2});
    QCOMPARE(test.json["tried"][0]["seen_by"].get<std::string>(), std::string("control"));
    QCOMPARE(test.json["tried"][1]["seen_by"].get<std::string>(), std::string("nobody"));
  }
};

RIVULET_TEST(TestCommission)
#include "tst_commission.moc"
