// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Two clients that start a run on the same control within two seconds: two processes of
/// rivulet-cli and a rivulet-machine, over OPC UA, in real time. One run goes to its end
/// undisturbed, the other client is told whose it is. RIVULET_SCENARIOS pairs from the seed
/// RIVULET_FIRST on.

#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/random.h"
#include "opcua/await.h"
#include "opcua/open62541/ua_link.h"
#include "streaming/start/cell_claim.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "templates/window_protocol.h"

using namespace rivulet;
using nlohmann::json;

namespace {

using rivulet::tests::kRunMs;
/// Pairs at the same time, each with a machine of its own; they mostly wait.
constexpr int kPairsAtOnce = 5;

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// One program of Rivulet that streams.
class Client {
 public:
  Client(const QString& folder, const QStringList& arguments) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_STATE_HOME"), folder);
    environment.insert(QStringLiteral("XDG_DATA_HOME"), folder);
    m_process.setProcessEnvironment(environment);
    m_process.start(QStringLiteral(RIVULET_CLI), arguments);
    if (!m_process.waitForStarted(kRunMs)) {
      qFatal("rivulet-cli does not start");
    }
  }
  /// Exit code of the program; below 0: it did not end by itself.
  int finish() {
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(kRunMs)) {
      m_process.kill();
      m_process.waitForFinished();
      return -1;
    }
    m_json = json::parse(m_process.readAllStandardOutput().toStdString(), nullptr, false);
    return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -2;
  }
  void kill() {
    m_process.kill();
    m_process.waitForFinished();
  }
  [[nodiscard]] std::string said() const { return m_json.is_object() ? m_json.dump(1) : ""; }
  /// Its run came to the end of the path, each point once.
  [[nodiscard]] bool isFaultless() const {
    return m_json.is_object() && m_json.value("faultless", false) &&
           m_json.value("outcome", "") == "completed";
  }
  /// Of its run or of its refusal.
  [[nodiscard]] std::string error() const {
    return m_json.is_object() && m_json.contains("error") && m_json["error"].is_object()
               ? m_json["error"].value("message", "")
               : std::string();
  }
  /// Its job came to its end, each point once.
  [[nodiscard]] bool isWholeJob(int points) const {
    return m_json.is_object() && m_json.value("outcome", "") == "completed" &&
           m_json.value("executed_points", 0) == points;
  }
  [[nodiscard]] std::string jobNumber() const {
    return m_json.is_object() ? std::to_string(m_json.value("run_number", 0)) : "-";
  }
  [[nodiscard]] std::string runNumber() const {
    return m_json.is_object() && m_json.contains("checkpoint")
               ? std::to_string(m_json["checkpoint"].value("run_number", 0))
               : "-";
  }

 private:
  QProcess m_process;
  json m_json;
};

}  // namespace

class TestTwoClients : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_program;

  [[nodiscard]] QStringList streamed(const QString& endpoint) const {
    return QStringList{QStringLiteral("stream"), m_program, QStringLiteral("--endpoint"),
                       endpoint} +
           words("--feed 1500 --json");
  }

  struct Pair {
    std::unique_ptr<tests::MachineProcess> machine;
    std::unique_ptr<Client> first;
    std::unique_ptr<Client> second;
    int offsetMs = 0;
  };

  /// @return what is wrong; empty: nothing
  static std::string judge(Pair& pair) {
    const int exits[] = {pair.first->finish(), pair.second->finish()};
    const bool firstWins = exits[0] == 0;
    const Client& winner = firstWins ? *pair.first : *pair.second;
    const Client& loser = firstWins ? *pair.second : *pair.first;
    const bool isNamed = loser.error().find(winner.runNumber()) != std::string::npos &&
                         loser.error().find(qgetenv("USER").toStdString()) != std::string::npos;
    if (exits[firstWins ? 0 : 1] == 0 && exits[firstWins ? 1 : 0] == 2 && winner.isFaultless() &&
        isNamed) {
      return {};
    }
    return "second client after " + std::to_string(pair.offsetMs) + " ms: exits " +
           std::to_string(exits[0]) + " and " + std::to_string(exits[1]) + "\n" +
           pair.first->said() + "\n" + pair.second->said();
  }

 private Q_SLOTS:
  void initTestCase() {
    m_program = m_folder.filePath(QStringLiteral("row.nc"));
    QFile program(m_program);
    QVERIFY(program.open(QIODevice::WriteOnly));
    QByteArray text("G1 X0 Y0 Z40 F1500\n");
    for (int i = 1; i <= 40; ++i) {
      text += QByteArray("G1 X") + QByteArray::number(2 * i) + " Y" +
              QByteArray::number(i % 2 == 0 ? 2 : 0) + '\n';
    }
    QVERIFY(program.write(text) > 0);
  }

  void oneRunsAndTheOtherIsToldWhoseRunItIs() {
    const int pairs = tests::setting("RIVULET_SCENARIOS", 5);
    const int first = tests::setting("RIVULET_FIRST", 1);
    for (int done = 0; done < pairs; done += kPairsAtOnce) {
      std::vector<Pair> running;
      for (int seed = first + done; seed < first + std::min(done + kPairsAtOnce, pairs); ++seed) {
        Pair pair;
        pair.offsetMs = static_cast<int>(
            base::Random(static_cast<std::uint64_t>(seed)).fork(13).uniform() * 2000.0);
        pair.machine = std::make_unique<tests::MachineProcess>(QStringLiteral(RIVULET_MACHINE),
                                                               words("--seed 1"));
        const QString folder = m_folder.filePath(QString::number(seed));
        pair.first = std::make_unique<Client>(folder, streamed(pair.machine->endpoint()));
        QThread::msleep(static_cast<unsigned long>(pair.offsetMs));
        pair.second =
            std::make_unique<Client>(folder + QLatin1Char('b'), streamed(pair.machine->endpoint()));
        running.push_back(std::move(pair));
      }
      for (Pair& pair : running) {
        const std::string wrong = judge(pair);
        QVERIFY2(wrong.empty(), wrong.c_str());
      }
    }
  }

  /// A whole job, and within two seconds another one or a single run: the second is told whose it
  /// is, and the first is not disturbed.
  void aJobIsNotDisturbed() {
    constexpr int kPoints = 21;
    const QString part = m_folder.filePath(QStringLiteral("part.mpf"));
    QFile program(part);
    QVERIFY(program.open(QIODevice::WriteOnly));
    QByteArray text("G1 X0 Y0 Z40 F1500\n");
    for (int i = 1; i < kPoints; ++i) {
      text += (i % 7 == 0 ? "G4 F0.5\nG1 X" : "X") + QByteArray::number(2 * i) + '\n';
    }
    QVERIFY(program.write(text + "M30\n") > 0);
    program.close();
    std::vector<Pair> running;
    for (const int offsetMs : {0, 700, 1900, 4000}) {
      const tests::MachineProcess* const machine =
          running
              .emplace_back(Pair{std::make_unique<tests::MachineProcess>(
                                     QStringLiteral(RIVULET_MACHINE), words("--seed 1")),
                                 {},
                                 {},
                                 offsetMs})
              .machine.get();
      const QString folder = m_folder.filePath(QStringLiteral("job%1").arg(offsetMs));
      const QStringList job = QStringList{QStringLiteral("job"), part, QStringLiteral("--endpoint"),
                                          machine->endpoint()} +
                              words("--json");
      running.back().first = std::make_unique<Client>(folder, job);
      QThread::msleep(static_cast<unsigned long>(offsetMs));
      running.back().second = std::make_unique<Client>(
          folder + QLatin1Char('b'), offsetMs == 700 ? streamed(machine->endpoint()) : job);
    }
    for (const Pair& pair : running) {
      const int exits[] = {pair.first->finish(), pair.second->finish()};
      const bool firstWins = exits[0] == 0;
      const Client& winner = firstWins ? *pair.first : *pair.second;
      const Client& loser = firstWins ? *pair.second : *pair.first;
      const std::string all = std::to_string(pair.offsetMs) + " ms: exits " +
                              std::to_string(exits[0]) + " and " + std::to_string(exits[1]) + "\n" +
                              pair.first->said() + "\n" + pair.second->said();
      const bool isRun = firstWins || pair.offsetMs != 700;
      QVERIFY2(exits[firstWins ? 0 : 1] == 0 && exits[firstWins ? 1 : 0] == 2, all.c_str());
      QVERIFY2(isRun ? winner.isWholeJob(kPoints) : winner.isFaultless(), all.c_str());
      QVERIFY2(
          loser.error().find(isRun ? winner.jobNumber() : winner.runNumber()) != std::string::npos,
          all.c_str());
    }
  }

  /// A client that dies between its claim and its start locks nobody out.
  void claimOfADeadClientLapses() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE), words("--seed 1"));
    const QString folder = m_folder.filePath(QStringLiteral("dead"));
    Client dying(folder, streamed(machine.endpoint()));
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = machine.endpoint().toStdString();
    const auto link = opcua::UaLink::connect(options);
    QVERIFY(link);
    const std::vector<opcua::Variable> cell{
        opcua::rParameter(templates::WindowProtocol::Heartbeat)};
    const auto isClaimed = [&] {
      const auto numbers = opcua::readNumbers(**link, cell, std::chrono::seconds(20));
      return numbers && streaming::claimantOf((*numbers)[0]);
    };
    QTRY_VERIFY_WITH_TIMEOUT(isClaimed(), kRunMs);
    dying.kill();
    QVERIFY(isClaimed());
    Client next(folder, streamed(machine.endpoint()));
    QCOMPARE(next.finish(), 0);
    QVERIFY2(next.isFaultless(), next.said().c_str());
    QVERIFY(!isClaimed());
  }
};

RIVULET_TEST(TestTwoClients)
#include "tst_two_clients.moc"
