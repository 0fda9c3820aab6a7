// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What can go wrong with the computer itself while a run is in progress: rivulet-cli and
/// rivulet-machine as processes, over OPC UA, in real time. Whatever happens, no point is executed
/// twice or left out; the judge is the machine's own list of executed blocks.

#include <netinet/in.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDirIterator>
#include <QProcess>
#include <QtTest>
#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <vector>

#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;

namespace {

using rivulet::tests::kRunMs;
constexpr int kPollMs = 10;
/// Of a connection: the other side may be silent for so long.
constexpr unsigned long kSilenceMaxMs = 10'000;

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

}  // namespace

class TestHostFaults : public QObject {
  Q_OBJECT

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  std::size_t m_before = 0;  ///< blocks executed before this test

  [[nodiscard]] QStringList streamed(const QString& resume = {}) const {
    QStringList arguments{QStringLiteral("stream"), m_scene.programFile()};
    arguments += words("--feed 1500 --points 4 --json --endpoint");
    arguments << m_scene.endpoint();
    if (!resume.isEmpty()) {
      arguments << QStringLiteral("--resume") << resume;
    }
    return arguments;
  }
  void start(QProcess& client, const QStringList& arguments) const {
    client.setProcessEnvironment(m_scene.environment());
    client.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    client.start(QStringLiteral(RIVULET_CLI), arguments);
    QVERIFY(client.waitForStarted(kRunMs));
  }
  /// The run has begun and its first blocks are executed.
  void awaitMotion(QProcess& client) const {
    constexpr std::size_t kBlocks = 6;
    while (client.state() == QProcess::Running && m_scene.executed(m_before).size() < kBlocks) {
      client.waitForFinished(kPollMs);
    }
    QVERIFY2(client.state() == QProcess::Running, client.readAllStandardError().constData());
  }
  static json endOf(QProcess& client, int exit) {
    const bool isEnded = client.state() == QProcess::NotRunning || client.waitForFinished(kRunMs);
    const QByteArray said = client.readAllStandardOutput();
    if (!isEnded || client.exitStatus() != QProcess::NormalExit || client.exitCode() != exit) {
      qWarning("exit code %d: %s%s", client.exitCode(), said.constData(),
               client.readAllStandardError().constData());
      return {};
    }
    return json::parse(said.toStdString(), nullptr, false);
  }
  void suspend(const QProcess& process, unsigned long ms) const {
    const auto number = static_cast<pid_t>(process.processId());
    QCOMPARE(kill(number, SIGSTOP), 0);
    QThread::msleep(ms);
    QCOMPARE(kill(number, SIGCONT), 0);
  }

 private Q_SLOTS:
  void initTestCase() { m_scene.switchOn(); }
  void init() {
    m_scene.forgetRuns();
    m_before = m_scene.executed().size();
  }

  void aShortSuspensionDelaysARun() {
    QProcess client;
    start(client, streamed());
    awaitMotion(client);
    suspend(client, kSilenceMaxMs / 3);
    const json report = endOf(client, 0);
    QVERIFY(report.is_object() && report["faultless"].get<bool>());
    QVERIFY(m_scene.isWhole(m_before));
  }

  void aLongSuspensionEndsARunThatCanBeResumed() {
    QProcess client;
    start(client, streamed());
    awaitMotion(client);
    suspend(client, kSilenceMaxMs + 2000);
    const json report = endOf(client, 3);
    QVERIFY(report.is_object());
    const std::string why = report["error"]["message"];
    QVERIFY2(why.find("suspended") != std::string::npos, why.c_str());
    const std::size_t moved = m_scene.executed(m_before).size();
    // Nothing moves again without an operator.
    m_scene.awaitRest();
    QCOMPARE(m_scene.executed(m_before).size(), moved);

    QProcess again;
    start(again, streamed(m_scene.savedRuns().value(0)));
    QVERIFY(endOf(again, 0).is_object());
    QVERIFY(m_scene.isWhole(m_before));
  }

  void aRunThatMayOpenNoFurtherFileGoesOn() {
    if (rivulet::tests::kIsSanitized) {
      QSKIP("The undefined behaviour sanitizer opens files itself, and warns where it cannot.");
    }
    QProcess client;
    start(client, streamed());
    awaitMotion(client);
    const rlimit none{3, 3};
    QCOMPARE(prlimit(static_cast<pid_t>(client.processId()), RLIMIT_NOFILE, &none, nullptr), 0);
    const json report = endOf(client, 0);
    QVERIFY(report.is_object() && report["faultless"].get<bool>());
    QVERIFY(m_scene.isWhole(m_before));
    const QByteArray said = client.readAllStandardError();
    QVERIFY2(said.contains("not in the history"), said.constData());
  }

  void aFullDiskEndsNoRun() {
    // A file system of its own that is full; only the client sees it.
    const QString full = m_scene.path("full");
    QVERIFY(QDir().mkpath(full));
    QProcess probe;
    const QStringList alone = words("-m --map-root-user --user");
    probe.start(QStringLiteral("unshare"),
                alone + words("mount -t tmpfs tmpfs") + QStringList{full});
    if (!probe.waitForFinished(kRunMs) || probe.exitCode() != 0) {
      QSKIP("This system allows no file system of one's own (unshare).");
    }
    QProcess client;
    client.setProcessEnvironment([&] {
      QProcessEnvironment environment = m_scene.environment();
      for (const char* kind : {"XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) {
        environment.insert(QString::fromUtf8(kind), full + QStringLiteral("/home"));
      }
      environment.insert(QStringLiteral("FULL"), full);
      return environment;
    }());
    client.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
    client.start(
        QStringLiteral("unshare"),
        alone +
            QStringList{QStringLiteral("sh"), QStringLiteral("-c"),
                        QStringLiteral("mount -t tmpfs -o size=64k tmpfs \"$FULL\" && "
                                       "head -c 60k /dev/zero >\"$FULL\"/fill && "
                                       "exec \"$@\""),
                        QStringLiteral("sh"), QStringLiteral(RIVULET_CLI)} +
            streamed() +
            QStringList{QStringLiteral("--record"), full + QStringLiteral("/run.rivulet")});
    // 1: the recording that was asked for is not there.
    const json report = endOf(client, 1);
    QVERIFY(report.is_object() && report["faultless"].get<bool>());
    QCOMPARE(report["outcome"], json("completed"));
    QVERIFY(m_scene.isWhole(m_before));
    const QByteArray said = client.readAllStandardError();
    QVERIFY2(said.contains("The recording is incomplete") && said.contains("No space left"),
             said.constData());
    QVERIFY2(said.contains("not in the history"), said.constData());
  }

  /// The disk takes nothing more in mid-run: this is said while the run goes on.
  void aDiskThatFillsUpInMidRunIsSaidAtOnce() {
    QProcess client;
    const QString recording = m_scene.path("cut.rivulet");
    start(client, streamed() + QStringList{QStringLiteral("--record"), recording});
    awaitMotion(client);
    const rlimit none{0, 0};
    QCOMPARE(prlimit(static_cast<pid_t>(client.processId()), RLIMIT_FSIZE, &none, nullptr), 0);
    QByteArray said;
    while (client.state() == QProcess::Running && !said.contains("The run goes on.")) {
      client.waitForReadyRead(kPollMs);
      said += client.readAllStandardError();
    }
    const std::size_t executed = m_scene.executed(m_before).size();
    QVERIFY2(said.contains("The recording is incomplete"), said.constData());
    const json report = endOf(client, 1);
    QVERIFY(report.is_object() && report["faultless"].get<bool>());
    QVERIFY(!report["recording_complete"].get<bool>());
    QVERIFY(m_scene.isWhole(m_before));
    QVERIFY(executed < m_scene.executed(m_before).size());
    QProcess reader;
    start(reader, QStringList{QStringLiteral("analyse"), recording});
    QVERIFY(reader.waitForFinished(kRunMs));
    QVERIFY(reader.readAllStandardOutput().contains("the recording was cut off"));
  }

  /// What a run prints and logs comes to nothing: it goes on to its end, and says so by its exit
  /// code.
  void nothingThatCannotBeWrittenEndsARun_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("exit");
    QTest::newRow("a full disk") << QStringLiteral("exec \"$0\" \"$@\" >/dev/full") << 1;
    QTest::newRow("full disks") << QStringLiteral("exec \"$0\" \"$@\" >/dev/full 2>/dev/full") << 1;
    QTest::newRow("closed output") << QStringLiteral("exec \"$0\" \"$@\" >&-") << 1;
    QTest::newRow("closed errors") << QStringLiteral("exec \"$0\" \"$@\" 2>&-") << 0;
    QTest::newRow("nothing is open") << QStringLiteral("exec \"$0\" \"$@\" <&- >&- 2>&-") << 1;
    // The log, the recording and what else is kept may not grow.
    QTest::newRow("no file may grow") << QStringLiteral("ulimit -f 1; exec \"$0\" \"$@\"") << 0;
    QTest::newRow("a reader that is gone")
        << QStringLiteral("set -o pipefail; \"$0\" \"$@\" | true") << 0;
  }
  void nothingThatCannotBeWrittenEndsARun() {
    QFETCH(QString, command);
    QFETCH(int, exit);
    QProcess client;
    client.setProcessEnvironment(m_scene.environment());
    client.start(QStringLiteral("bash"),
                 QStringList{QStringLiteral("-c"), command, QStringLiteral(RIVULET_CLI)} +
                     streamed() + words("--log-level trace"));
    QVERIFY(client.waitForFinished(kRunMs));
    QVERIFY2(client.exitStatus() == QProcess::NormalExit && client.exitCode() == exit,
             (QByteArray::number(client.exitCode()) + client.readAllStandardError()).constData());
    QVERIFY(m_scene.isWhole(m_before));
  }

  void aClockThatJumpsDisturbsNoEncryptedRun() {
    QString library;
    for (QDirIterator each(QStringLiteral("/usr/lib"), {QStringLiteral("libfaketime.so.1")},
                           QDir::Files, QDirIterator::Subdirectories);
         each.hasNext();) {
      library = each.next();
    }
    if (library.isEmpty()) {
      QSKIP("The package faketime is not installed.");
    }
    if (rivulet::tests::kIsSanitized) {
      QSKIP("Under a sanitizer no other library can take the place of the system's clock.");
    }
    const QString offset = m_scene.path("offset");
    const auto jump = [&offset](const char* by) {
      QFile file(offset);
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(by) > 0);
    };
    const auto withItsClock = [&](QProcess& process, const QString& program,
                                  const QStringList& arguments) {
      QProcessEnvironment environment = m_scene.environment();
      environment.insert(QStringLiteral("LD_PRELOAD"), library);
      environment.insert(QStringLiteral("FAKETIME_TIMESTAMP_FILE"), offset);
      environment.insert(QStringLiteral("FAKETIME_NO_CACHE"), QStringLiteral("1"));
      environment.insert(QStringLiteral("FAKETIME_DONT_FAKE_MONOTONIC"), QStringLiteral("1"));
      process.setProcessEnvironment(environment);
      process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
      process.start(program, arguments);
      QVERIFY(process.waitForStarted(kRunMs));
    };
    jump("+0");
    QProcess machine;
    withItsClock(machine, QStringLiteral(RIVULET_MACHINE),
                 words("--seed 1 --port 0 --encrypted --certificates") +
                     QStringList{m_scene.path("certificates"), QStringLiteral("--state"),
                                 m_scene.path("other machine")});
    while (!machine.canReadLine()) {
      QVERIFY(machine.waitForReadyRead(kRunMs));
    }
    const QString endpoint = QString::fromUtf8(machine.readLine()).trimmed();
    QProcess asked;
    start(asked, words("rights --json --endpoint") << endpoint);
    const json unknown = endOf(asked, 3);
    QVERIFY(unknown.is_object());
    const QRegularExpression pattern(QStringLiteral("fingerprint ([0-9A-F:]{95})"));
    const QString fingerprint =
        pattern.match(QString::fromStdString(unknown["error"]["message"].get<std::string>()))
            .captured(1);
    QVERIFY(!fingerprint.isEmpty());

    const auto blocks = [this] {
      QFile file(m_scene.path("other machine/executed.txt"));
      return file.open(QIODevice::ReadOnly) ? file.readAll().count('\n') : 0;
    };
    for (const char* by : {"+1d", "-1d"}) {
      jump("+0");
      const qsizetype before = blocks();
      QProcess client;
      withItsClock(client, QStringLiteral(RIVULET_CLI),
                   QStringList{QStringLiteral("stream"), m_scene.programFile()} +
                       words("--feed 1500 --points 4 --json --trust") +
                       QStringList{fingerprint, QStringLiteral("--endpoint"), endpoint});
      while (client.state() == QProcess::Running && blocks() < before + 6) {
        client.waitForFinished(kPollMs);
      }
      QVERIFY2(client.state() == QProcess::Running, client.readAllStandardError().constData());
      jump(by);  // for both
      const json report = endOf(client, 0);
      QVERIFY2(report.is_object() && report["faultless"].get<bool>(), by);
      QVERIFY2(report["duration_s"].get<double>() < 100.0, by);
    }
    machine.terminate();
    QVERIFY(machine.waitForFinished(kRunMs));
  }

  /// The library would stop listening, for good, when it may open no further connection.
  void aMachineHasHandlesForAllItsConnections_data() {
    QTest::addColumn<int>("soft");
    QTest::addColumn<int>("hard");
    QTest::addColumn<int>("exit");
    QTest::newRow("raised") << 16 << 4096 << 0;
    QTest::newRow("refused") << 16 << 16 << 3;
  }
  void aMachineHasHandlesForAllItsConnections() {
    QFETCH(int, soft);
    QFETCH(int, hard);
    QFETCH(int, exit);
    QProcess machine;
    machine.setChildProcessModifier([soft, hard] {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      const rlimit few{static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
      setrlimit(RLIMIT_NOFILE, &few);
    });
    machine.start(QStringLiteral(RIVULET_MACHINE), words("--seed 1 --port 0"));
    while (machine.state() != QProcess::NotRunning && !machine.canReadLine()) {
      machine.waitForReadyRead(kPollMs);
    }
    const QString endpoint = QString::fromUtf8(machine.readLine()).trimmed();
    if (exit != 0) {
      QCOMPARE(machine.exitCode(), exit);
      const QByteArray said = machine.readAllStandardError();
      QVERIFY2(said.contains("ulimit -n"), said.constData());
      return;
    }
    // Strangers that connect and say nothing: more than it takes.
    std::vector<int> strangers;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(endpoint.section(QLatin1Char(':'), -1).toUShort());
    for (int i = 0; i < 100; ++i) {
      strangers.push_back(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
      static_cast<void>(
          ::connect(strangers.back(), reinterpret_cast<const sockaddr*>(&address), sizeof address));
    }
    // It has turned some of them away.
    const auto isClosed = [](int stranger) {
      pollfd state{stranger, POLLIN, 0};
      char byte = 0;
      return poll(&state, 1, 0) == 1 && recv(stranger, &byte, 1, MSG_DONTWAIT) <= 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(std::any_of(strangers.begin(), strangers.end(), isClosed), kRunMs);
    for (const int stranger : strangers) {
      close(stranger);
    }
    QProcess later;
    start(later, words("rights --json --endpoint") << endpoint);
    QVERIFY(endOf(later, 0).is_object());
    machine.terminate();
    QVERIFY(machine.waitForFinished(kRunMs));
  }
};

RIVULET_TEST(TestHostFaults)
#include "tst_host_faults.moc"
