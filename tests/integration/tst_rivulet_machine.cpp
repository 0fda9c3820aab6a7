// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The program `rivulet-machine` as its user starts it.

#include <signal.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <memory>

#include "opcua/await.h"
#include "opcua/open62541/ua_link.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;

namespace {

using rivulet::tests::kRunMs;

void startProgram(QProcess& process, const QStringList& arguments) {
  process.start(QStringLiteral(RIVULET_MACHINE_PROGRAM), arguments);
}

/// The line the program prints when it is ready.
QString endpointOf(QProcess& process) {
  while (!process.canReadLine() && process.waitForReadyRead(kRunMs)) {
  }
  return QString::fromUtf8(process.readLine()).trimmed();
}

std::unique_ptr<opcua::UaLink> connectTo(const QString& endpoint) {
  opcua::ConnectOptions options;
  options.security = opcua::unencrypted();
  options.endpoint = endpoint.toStdString();
  options.connectDeadline = std::chrono::milliseconds(kRunMs);
  auto link = opcua::UaLink::connect(options);
  return link ? std::move(*link) : nullptr;
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

    const auto link = connectTo(endpoint);
    QVERIFY(link != nullptr);
    QVERIFY(link->isVirtualMachine());

    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    QVERIFY(process.waitForFinished(kRunMs));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 0);
    const auto event = link->wait(link->now() + 60s);
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
    QVERIFY(second.waitForFinished(kRunMs));
    QCOMPARE(second.exitCode(), 3);
    QVERIFY(second.readAllStandardOutput().isEmpty());
    const QStringList complaint = lines(second.readAllStandardError());
    QCOMPARE(complaint.size(), 1);
    QVERIFY(complaint[0].contains(port));
    first.terminate();
    QVERIFY(first.waitForFinished(kRunMs));
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
    QVERIFY(process.waitForFinished(kRunMs));
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardOutput().isEmpty());
    QVERIFY(!process.readAllStandardError().isEmpty());
  }

  /// R-parameters, programs and places outlive `kill -9`; a damaged state is not used.
  void keepsItsStateOverALossOfPower() {
    QTemporaryDir folder;
    const QStringList arguments{QStringLiteral("--port"),   QStringLiteral("0"),
                                QStringLiteral("--preset"), QStringLiteral("ideal"),
                                QStringLiteral("--state"),  folder.path()};
    const std::vector<opcua::Variable> watched{opcua::rParameter(20),
                                               {opcua::VariableKind::ActualPosition, 0}};
    QProcess first;
    startProgram(first, arguments);
    {
      const auto link = connectTo(endpointOf(first));
      const opcua::Assignment value{watched[0], 1.25};
      QVERIFY(opcua::writeNow(*link, {&value, 1}, 20s));
      QVERIFY(link->uploadProgram("GO.MPF", "G1 X7.5 F6000\nM30\n", true));
      QVERIFY(link->selectProgram("GO.MPF"));
      QVERIFY(link->cycleStart());
      const auto isThere = [&] {
        const auto numbers = opcua::readNumbers(*link, watched, 20s);
        return numbers && std::abs((*numbers)[1] - 7.5) < 1e-6;
      };
      QTRY_VERIFY_WITH_TIMEOUT(isThere(), kRunMs);

      QProcess second;
      startProgram(second, arguments);
      QVERIFY(second.waitForFinished(kRunMs));
      QCOMPARE(second.exitCode(), 2);
      // An answer shows that the state has been written since the tool arrived.
      QVERIFY(isThere());
    }
    first.kill();
    QVERIFY(first.waitForFinished(kRunMs));

    QProcess again;
    startProgram(again, arguments);
    {
      const auto link = connectTo(endpointOf(again));
      const auto numbers = opcua::readNumbers(*link, watched, 20s);
      QVERIFY(numbers);
      QCOMPARE((*numbers)[0], 1.25);
      QVERIFY(std::abs((*numbers)[1] - 7.5) < 1e-6);
      QCOMPARE(link->downloadProgram("GO.MPF").value_or(""), std::string("G1 X7.5 F6000\nM30\n"));
    }
    again.kill();
    QVERIFY(again.waitForFinished(kRunMs));

    QFile state(folder.filePath(QStringLiteral("state")));
    QVERIFY(state.open(QIODevice::ReadWrite));
    QVERIFY(state.write(QByteArray(static_cast<int>(state.size()), 'x')) > 0);
    state.close();
    QProcess damaged;
    startProgram(damaged, arguments);
    QVERIFY(damaged.waitForFinished(kRunMs));
    QCOMPARE(damaged.exitCode(), 2);
    QVERIFY(damaged.readAllStandardError().contains("damaged"));
  }

  void saysItsVersion() {
    QProcess process;
    startProgram(process, {QStringLiteral("--version")});
    QVERIFY(process.waitForFinished(kRunMs));
    QCOMPARE(process.exitCode(), 0);
    QVERIFY(process.readAllStandardOutput().startsWith("rivulet-machine "));
  }
};

RIVULET_TEST(TestRivuletMachine)
#include "tst_rivulet_machine.moc"
