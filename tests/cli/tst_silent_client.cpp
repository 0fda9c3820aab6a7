// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A client that is suspended, goes on, and is killed or interrupted in mid-motion, over OPC UA in
/// real time: the axes stand in the middle of a move or cycle, go on with the client, and stay
/// where they are without it, until somebody lets the program come to its end.

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>

#include "opcua/await.h"
#include "opcua/open62541/ua_link.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
/// Long enough that the axes move in between, and arrive nowhere.
constexpr unsigned long kPollMs = 20;
constexpr double kMovesMm = 1e-4;

}  // namespace

class TestSilentClient : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  struct Look {
    std::array<double, 3> place{};
    bool isReset = false;
  };

  static Look look(opcua::Link& link) {
    const std::array<opcua::Variable, 4> watched{{{opcua::VariableKind::ActualPosition, 0},
                                                  {opcua::VariableKind::ActualPosition, 1},
                                                  {opcua::VariableKind::ActualPosition, 2},
                                                  {opcua::VariableKind::ChannelStatus, 0}}};
    const auto numbers = opcua::readNumbers(link, watched, std::chrono::milliseconds(kRunMs));
    if (!numbers) {
      qFatal("%s", numbers.error().text().c_str());
    }
    return {{(*numbers)[0], (*numbers)[1], (*numbers)[2]}, (*numbers)[3] == opcua::kChannelReset};
  }

  static double movedMm(const Look& a, const Look& b) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < a.place.size(); ++axis) {
      most = std::max(most, std::abs(a.place[axis] - b.place[axis]));
    }
    return most;
  }

  /// Waits until the axes stand. @return where
  static Look awaitRest(opcua::Link& link) {
    constexpr int kReads = 15;
    Look last = look(link);
    for (int standing = 0; standing < kReads;) {
      QThread::msleep(kPollMs);
      const Look now = look(link);
      standing = movedMm(now, last) < kMovesMm ? standing + 1 : 0;
      last = now;
    }
    return last;
  }

  /// Waits until the tool is there. @param isThere  asked with each look
  template <class Asked>
  static bool awaitPlace(opcua::Link& link, QProcess& client, Asked isThere) {
    const QDeadlineTimer until(kRunMs);
    while (!until.hasExpired() && client.state() == QProcess::Running) {
      if (isThere(look(link))) {
        return true;
      }
      client.waitForFinished(static_cast<int>(kPollMs));
    }
    return false;
  }

  static base::Result<std::unique_ptr<opcua::UaLink>> connectTo(
      const tests::MachineProcess& machine) {
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = machine.endpoint().toStdString();
    options.connectDeadline = std::chrono::milliseconds(kRunMs);
    return opcua::UaLink::connect(options);
  }

  /// @return whether the order was carried out
  static bool runs(const char* order, const tests::MachineProcess& machine) {
    QProcess other;
    other.start(QStringLiteral(RIVULET_CLI),
                {QStringLiteral("runs"), QString::fromUtf8(order), QStringLiteral("--json"),
                 QStringLiteral("--endpoint"), machine.endpoint()});
    const bool isDone = other.waitForFinished(kRunMs) && other.exitCode() == 0;
    if (!isDone) {
      qInfo() << other.readAllStandardError() << other.readAllStandardOutput();
    }
    return isDone;
  }

 private Q_SLOTS:
  void standsAndGoesOn_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("x");
    QTest::addColumn<int>("number");
    // The tool is between both for seconds at this X or beyond, and in no other move.
    for (const int number : {SIGKILL, SIGINT, SIGTERM}) {
      const std::string kind = number == SIGKILL ? "killed" : number == SIGINT ? "Ctrl-C" : "ended";
      QTest::addRow("long move, %s", kind.c_str())
          << QByteArray("G90 G1 X0 Y0 Z10 F3000\nX200 F1500\nY10\nX0\nM30\n")
          << QStringList{QStringLiteral("stream"), QStringLiteral("--motion-only"),
                         QStringLiteral("--points"), QStringLiteral("2")}
          << 0 << 20.0 << 180.0 << 20.0 << number;
      QTest::addRow("native cycle, %s", kind.c_str())
          << QByteArray(
                 "G17 G90 G71 G94 F1000\nT1 M6\nS1000 M3\nG0 X0 Y0 Z25\nG1 X5 F200\n"
                 "CYCLE81(25,0,2,-20)\nG0 Z25\nM30\n")
          << QStringList{QStringLiteral("job")} << 2 << -15.0 << -1.0 << 4.99 << number;
    }
  }

  void standsAndGoesOn() {
    QFETCH(QByteArray, text);
    QFETCH(QStringList, arguments);
    QFETCH(int, axis);
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, x);
    QFETCH(int, number);
    QFile program(m_folder.filePath(QStringLiteral("part.mpf")));
    QVERIFY(program.open(QIODevice::WriteOnly | QIODevice::Truncate));
    program.write(text);
    program.close();
    const bool isJob = arguments.front() == QLatin1String("job");
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE),
        isJob ? QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75-mill")}
              : QStringList());
    const auto link = connectTo(machine);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());

    QProcess client;
    client.start(QStringLiteral(RIVULET_CLI),
                 QStringList{arguments.front(), program.fileName()} + arguments.mid(1) +
                     QStringList{QStringLiteral("--dialect"), QStringLiteral("sinumerik"),
                                 QStringLiteral("--json"), QStringLiteral("--endpoint"),
                                 machine.endpoint()});
    QVERIFY(client.waitForStarted(kRunMs));
    const auto isWithin = [&](const Look& at) {
      const double place = at.place[static_cast<std::size_t>(axis)];
      return place > from && place < to && at.place[0] >= x;
    };
    QVERIFY2(awaitPlace(**link, client, isWithin), client.readAllStandardError().constData());

    // Silent, the axes stand where they are: not at an end of the move.
    QVERIFY(client.processId() > 0);  // 0 would stop all that the tests have started
    ::kill(static_cast<pid_t>(client.processId()), SIGSTOP);
    const Look stopped = awaitRest(**link);
    QVERIFY(!stopped.isReset && isWithin(stopped));
    QVERIFY(movedMm(awaitRest(**link), stopped) < kMovesMm);

    // They go on with the client.
    ::kill(static_cast<pid_t>(client.processId()), SIGCONT);
    const auto hasLeft = [&](const Look& at) { return movedMm(at, stopped) > 0.1; };
    QVERIFY2(awaitPlace(**link, client, hasLeft), client.readAllStandardError().constData());
    QVERIFY(isWithin(look(**link)));

    // Without it they stand for good: killed, it cannot say so; else it holds them, and leaves.
    ::kill(static_cast<pid_t>(client.processId()), number);
    QVERIFY(client.waitForFinished(kRunMs));
    const QByteArray report = client.readAllStandardOutput();
    const auto said = nlohmann::json::parse(report.toStdString(), nullptr, false);
    if (number != SIGKILL) {
      const QByteArray errors = client.readAllStandardError();
      QCOMPARE(client.exitCode(), 0);
      QVERIFY2(errors.contains("runs --end"), errors.constData());
      QVERIFY2(said["outcome"] == "stopped" && said["left_held"].get<bool>(), report.constData());
      qInfo("stood %.3f s after the order", said["feed"].back()["stood"]["after_s"].get<double>());
    }
    const Look left = awaitRest(**link);
    QVERIFY(!left.isReset && isWithin(left));
    QVERIFY(movedMm(awaitRest(**link), left) < kMovesMm);

    // Somebody else stops the run: they stay where they are.
    QVERIFY(runs("--stop", machine));
    QVERIFY(!look(**link).isReset);
    QVERIFY(movedMm(awaitRest(**link), left) < kMovesMm);
    // The program comes to its next window or block, and no further.
    QVERIFY(runs("--end", machine));
    QVERIFY(look(**link).isReset);
  }

  /// What has no cells that Rivulet knows is stopped by the reset of the control.
  void whatIsNoRunIsReset_data() {
    QTest::addColumn<bool>("isTest");
    QTest::newRow("program of somebody else") << false;
    QTest::newRow("test whose client was killed") << true;
  }

  void whatIsNoRunIsReset() {
    QFETCH(bool, isTest);
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), {});
    const auto link = connectTo(machine);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    QVERIFY(!runs("--stop", machine));  // nothing moves
    const Look begun = look(**link);
    constexpr double kLengthMm = 20.0;
    QProcess client;
    if (isTest) {
      client.start(QStringLiteral(RIVULET_CLI),
                   {QStringLiteral("commission"), QStringLiteral("--feed-cell"),
                    QStringLiteral("--air-move"), QStringLiteral("X20"), QStringLiteral("--feed"),
                    QStringLiteral("100"), QStringLiteral("--endpoint"), machine.endpoint()});
      QVERIFY(client.waitForStarted(kRunMs));
    } else {
      const auto starter = connectTo(machine);
      QVERIFY((*starter)->uploadProgram("JOG.MPF", "G91 G1 X20 F100\nX-20\nM30\n", true));
      QVERIFY((*starter)->selectProgram("JOG.MPF") && (*starter)->cycleStart());
      QVERIFY(!runs("--stop", machine));  // the virtual machine obeys whoever has started it
    }
    const QDeadlineTimer until(kRunMs);
    while (movedMm(look(**link), begun) < 1.0) {
      QVERIFY(!until.hasExpired());
      QThread::msleep(kPollMs);
    }
    if (isTest) {
      client.kill();
      QVERIFY(client.waitForFinished(kRunMs));
      QVERIFY(!awaitRest(**link).isReset);  // held, and nothing says by whom
    }
    QVERIFY(!runs("--end", machine));
    QVERIFY(runs("--stop", machine));
    const Look stopped = look(**link);
    QVERIFY(stopped.isReset);
    QVERIFY(movedMm(stopped, begun) < kLengthMm);  // on its way
    QVERIFY(movedMm(awaitRest(**link), stopped) < kMovesMm);
  }
};

RIVULET_TEST(TestSilentClient)
#include "tst_silent_client.moc"
