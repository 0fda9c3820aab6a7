// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The program `rivulet-machine` as its user starts it.

#include <signal.h>

#include <QProcess>
#include <QtTest>

#include "opcua/open62541/ua_link.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;

namespace {

constexpr int kPatienceMs = 60'000;

void startProgram(QProcess& process, const QStringList& arguments) {
  process.start(QStringLiteral(RIVULET_MACHINE_PROGRAM), arguments);
}

/// The line the program prints when it is ready.
QString endpointOf(QProcess& process) {
  while (!process.canReadLine() && process.waitForReadyRead(kPatienceMs)) {
  }
  return QString::fromUtf8(process.readLine()).trimmed();
}

QStringList lines(const QByteArray& text) {
  return QString::fromUtf8(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

}  // namespace

class TestRivuletMachine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void servesUntilItIsInterrupted_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGINT") << SIGINT;
  }

  void servesUntilItIsInterrupted() {
    QFETCH(int, signal);
    QProcess process;
    startProgram(process, {QStringLiteral("--port"), QStringLiteral("0")});
    const QString endpoint = endpointOf(process);
    QVERIFY2(endpoint.startsWith(QLatin1String("opc.tcp://127.0.0.1:")), qPrintable(endpoint));

    opcua::ConnectOptions options;
    options.endpoint = endpoint.toStdString();
    options.connectDeadline = std::chrono::milliseconds(kPatienceMs);
    const auto link = opcua::UaLink::connect(options);
    QVERIFY(link.has_value());
    QVERIFY((*link)->isVirtualMachine());

    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    QVERIFY(process.waitForFinished(kPatienceMs));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 0);
    const auto event = (*link)->wait((*link)->now() + 60s);
    QVERIFY(event && event->kind == opcua::EventKind::ConnectionLost);
    QVERIFY(process.readAllStandardOutput().isEmpty());  // one line and no more
    QVERIFY(process.readAllStandardError().isEmpty());
  }

  void aTakenPortIsOneSentence() {
    QProcess first;
    startProgram(first, {QStringLiteral("--port"), QStringLiteral("0")});
    const QString endpoint = endpointOf(first);
    const QString port = endpoint.mid(endpoint.lastIndexOf(QLatin1Char(':')) + 1);
    QProcess second;
    startProgram(second, {QStringLiteral("--port"), port});
    QVERIFY(second.waitForFinished(kPatienceMs));
    QCOMPARE(second.exitCode(), 3);
    QVERIFY(second.readAllStandardOutput().isEmpty());
    const QStringList complaint = lines(second.readAllStandardError());
    QCOMPARE(complaint.size(), 1);
    QVERIFY(complaint[0].contains(port));
    first.terminate();
    QVERIFY(first.waitForFinished(kPatienceMs));
  }

  void wrongUsageIsExitCode2_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("unknown option") << QStringList{QStringLiteral("--nix")};
    QTest::newRow("port out of range") << QStringList{QStringLiteral("--port=65536")};
    QTest::newRow("no port") << QStringList{QStringLiteral("--port=x")};
    QTest::newRow("unknown preset") << QStringList{QStringLiteral("--preset=nix")};
    QTest::newRow("no such preset file") << QStringList{QStringLiteral("--preset=./nix.toml")};
    QTest::newRow("no such host") << QStringList{QStringLiteral("--host=host.invalid")};
  }

  void wrongUsageIsExitCode2() {
    QFETCH(QStringList, arguments);
    QProcess process;
    startProgram(process, arguments);
    QVERIFY(process.waitForFinished(kPatienceMs));
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardOutput().isEmpty());
    QVERIFY(!process.readAllStandardError().isEmpty());
  }

  void saysItsVersion() {
    QProcess process;
    startProgram(process, {QStringLiteral("--version")});
    QVERIFY(process.waitForFinished(kPatienceMs));
    QCOMPARE(process.exitCode(), 0);
    QVERIFY(process.readAllStandardOutput().startsWith("rivulet-machine "));
  }
};

RIVULET_TEST(TestRivuletMachine)
#include "tst_rivulet_machine.moc"
