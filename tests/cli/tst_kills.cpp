// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Clients and virtual machines that are killed at drawn moments, by the programs themselves over
/// OPC UA in real time. What is left is found from the checkpoint on disk and the cells on the
/// control, which the machine keeps over a loss of power; the judge has nothing but the list of
/// points and the machine's own list of executed blocks.

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/random.h"
#include "gcode/program.h"
#include "opcua/await.h"
#include "opcua/open62541/ua_link.h"
#include "support/machine_process.h"
#include "support/test_program.h"
#include "trace/analysis/integrity.h"

using namespace rivulet;
using nlohmann::json;

namespace {

constexpr int kRunMs = 120'000;
constexpr int kPollMs = 10;
/// Of the axes of dmu75 at F1500: time constant of their servos and one cycle of 4 ms.
constexpr double kFollowingErrorMm = 25.0 * (0.010 + 0.004);
constexpr qsizetype kHistoryBytes = 300;  // of what a client has printed
/// Of a whole run, about: kills are drawn within it.
constexpr double kStreamMs = 6000.0;

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// A number of the environment.
int setting(const char* name, int otherwise) {
  return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

/// Rows of short moves; the first block names every axis, so the start does not matter.
QByteArray rows() {
  QByteArray text("G1 X1 Y1 Z20 F3000\n");
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i <= 7; ++i) {
      text += QByteArray("G1 X") + QByteArray::number(row % 2 == 0 ? 2 * i : 14 - 2 * i) + " Y" +
              QByteArray::number(3 + 3 * row) + " Z" + QByteArray::number(10 - row) + '\n';
    }
  }
  return text;
}

struct Tally {
  int kills = 0;
  int clientKills = 0;
  int machineKills = 0;
  int runs = 0;     ///< to the end of the path
  int resumed = 0;  ///< starts that resumed a run
  int refused = 0;  ///< with the reason, because the place on the path is not known for certain
};

}  // namespace

class TestKills : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<tests::MachineProcess> m_machine;
  QString m_endpoint;
  QString m_program;
  base::Random m_random{1};
  Tally m_tally;
  QStringList m_history;  ///< of this run, shown if something is wrong

  [[nodiscard]] QString path(const char* name) const {
    return m_folder.filePath(QString::fromUtf8(name));
  }

  /// A program of Rivulet with homes of its own.
  void start(QProcess& process, const QStringList& arguments) const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_STATE_HOME"), path("state"));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), path("data"));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    if (!process.waitForStarted(kRunMs)) {
      qFatal("rivulet-cli does not start");
    }
  }
  int finished(QProcess& process) const {
    if (process.state() != QProcess::NotRunning && !process.waitForFinished(kRunMs)) {
      process.kill();
      process.waitForFinished();
      return -1;
    }
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2;
  }

  void switchOn() {
    // A given port, below those the system gives to clients: it can be used again at once.
    constexpr qint64 kFirstPort = 21'000;
    constexpr qint64 kPorts = 8000;
    QStringList arguments = words("--seed 1 --state");
    arguments << path("machine") << QStringLiteral("--port")
              << QString::number(kFirstPort + QCoreApplication::applicationPid() % kPorts);
    if (m_machine) {
      m_machine->kill();
    }
    m_machine = std::make_unique<tests::MachineProcess>(QStringLiteral(RIVULET_MACHINE), arguments);
    m_endpoint = m_machine->endpoint();
    QVERIFY(!m_endpoint.isEmpty());
  }

  /// Files of the runs that are kept, the newest first.
  [[nodiscard]] QStringList savedRuns() const {
    const QDir folder(path("state") + QStringLiteral("/rivulet/runs"));
    QStringList files;
    for (const QString& name :
         folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Time)) {
      files << folder.filePath(name);
    }
    return files;
  }
  [[nodiscard]] bool isGranted() const {
    const QStringList files = savedRuns();
    QFile file(files.value(0));
    return !files.isEmpty() && file.open(QIODevice::ReadOnly) &&
           file.readAll().contains("\"granted\": true");
  }

  /// Waits until nothing moves any more.
  void awaitStandstill() const {
    opcua::ConnectOptions options;
    options.endpoint = m_endpoint.toStdString();
    options.connectDeadline = std::chrono::seconds(20);
    options.commandDeadline = std::chrono::seconds(20);
    const auto link = opcua::UaLink::connect(options);
    if (!link) {
      qFatal("the machine does not answer");
    }
    const std::vector<opcua::Variable> watched{{opcua::VariableKind::ChannelStatus, 0},
                                               opcua::rParameter(1),
                                               opcua::rParameter(2),
                                               opcua::rParameter(3)};
    for (;;) {
      const auto numbers = opcua::readNumbers(**link, watched, std::chrono::seconds(5));
      if (!numbers) {
        qFatal("the machine cannot be read");
      }
      const std::vector<double>& now = *numbers;
      if (now[0] == 0.0 || (now[1] == now[2] && now[2] == now[3])) {
        break;
      }
      QThread::msleep(kPollMs);
    }
  }

  /// All that the machine has executed, over all losses of power. @param skip  blocks of earlier
  /// runs
  [[nodiscard]] std::vector<trace::ExecutedBlock> executed(std::size_t skip = 0) const {
    constexpr qsizetype kColumns = 8;
    constexpr qsizetype kLength = 6;
    std::vector<trace::ExecutedBlock> blocks;
    QFile file(path("machine/executed.txt"));
    if (!file.open(QIODevice::ReadOnly)) {
      qFatal("the machine has not kept what it executed");
    }
    for (const QByteArray& line : file.readAll().split('\n')) {
      const QList<QByteArray> words = line.split(' ');
      if (words.size() != kColumns) {
        continue;
      }
      trace::ExecutedBlock block;
      block.targetMm = {words[0].toDouble(), words[1].toDouble(), words[2].toDouble()};
      block.lengthMm = words[kLength].toDouble();
      blocks.push_back(block);
    }
    const auto first = static_cast<std::ptrdiff_t>(std::min(skip, blocks.size()));
    return {blocks.begin() + first, blocks.end()};
  }

  /// The same without the rests of blocks: a control has executed a block when its set point is at
  /// the end. If its power fails then, the axes are still behind by the following error, and the
  /// resumed run takes them over the rest.
  /// @param powerFailedAt  number of blocks, of all runs, each time the machine was switched on
  /// again
  [[nodiscard]] std::vector<trace::ExecutedBlock> executedWithoutRests(
      std::size_t skip, const std::vector<std::size_t>& powerFailedAt) const {
    std::vector<trace::ExecutedBlock> blocks = executed(skip);
    for (auto failed = powerFailedAt.rbegin(); failed != powerFailedAt.rend(); ++failed) {
      const std::size_t next = *failed - skip;
      if (next > 0 && next < blocks.size() && blocks[next].targetMm == blocks[next - 1].targetMm &&
          blocks[next].lengthMm <= kFollowingErrorMm) {
        blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(next));
      }
    }
    return blocks;
  }

  [[nodiscard]] QStringList streamed(bool credit, const QString& resume) const {
    QStringList arguments = QStringList{QStringLiteral("stream"), m_program} +
                            words("--feed 1500 --points 4 --json --endpoint");
    arguments << m_endpoint;
    if (credit) {
      arguments << words("--method credit --windows-ahead 2");
    }
    if (!resume.isEmpty()) {
      arguments << QStringLiteral("--resume") << resume;
    }
    return arguments;
  }

  /// Waits until the drawn moment. @return false if the client ended before it
  bool waitForMoment(QProcess& client) {
    const bool early = m_random.uniform() < 0.15;
    const int delayMs = static_cast<int>(m_random.uniform() * (early ? 2500.0 : kStreamMs));
    while (!early && client.state() == QProcess::Running && !isGranted()) {
      client.waitForFinished(kPollMs);
    }
    return client.state() == QProcess::Running && !client.waitForFinished(delayMs);
  }

  void note(const QString& what) {
    m_history << QStringLiteral("%1 blocks: %2").arg(executed().size()).arg(what);
  }

  /// One run to the end of the path, killed on the way. @return false if something was wrong
  bool run(bool credit, int killsMax) {
    const std::size_t before = executed().size();
    m_history.clear();
    QStringList candidates;
    int kills = 0;
    std::vector<std::size_t> powerFailedAt;
    for (int starts = 0; starts < 100; ++starts) {
      const QString resume = candidates.isEmpty() ? QString() : candidates.takeFirst();
      QProcess client;
      note(resume.isEmpty() ? QStringLiteral("start") : QStringLiteral("resume ") + resume);
      start(client, streamed(credit, resume));
      bool wasKilled = false;
      bool wasMachine = false;
      if (kills < killsMax && waitForMoment(client)) {
        wasKilled = true;
        ++kills;
        ++m_tally.kills;
        wasMachine = m_random.uniform() < 0.12;
        const std::array kinds{SIGKILL, SIGKILL, SIGHUP, SIGTERM};
        const int number = kinds[static_cast<std::size_t>(m_random.uniform() * 4.0)];
        if (wasMachine) {
          ++m_tally.machineKills;
          m_machine->kill();
        } else {
          ++m_tally.clientKills;
          ::kill(static_cast<pid_t>(client.processId()), number);
        }
      }
      const int exit = finished(client);
      const QByteArray output = client.readAllStandardOutput();
      const QByteArray errors = client.readAllStandardError();
      note(QStringLiteral("%1, exit %2 %3")
               .arg(wasMachine  ? QStringLiteral("machine off")
                    : wasKilled ? QStringLiteral("client killed")
                                : QStringLiteral("not killed"))
               .arg(exit)
               .arg(QString::fromUtf8(output.left(kHistoryBytes))));
      if (wasMachine) {
        if (exit != 3 && exit != 0) {
          qWarning("exit %d after the machine was switched off: %s", exit, errors.constData());
          return false;
        }
        switchOn();
        powerFailedAt.push_back(executed().size());
        if (exit == 0) {
          break;  // it was at its end
        }
        candidates = savedRuns();
        continue;
      }
      if (exit == 2 && !wasKilled) {
        if (output.contains("Every point has been executed already")) {
          // The windows that had been delivered were the last.
          QDir(path("state")).removeRecursively();
          break;
        }
        if (!candidates.isEmpty()) {
          continue;  // an older one that has been replaced
        }
        // A loss of power on a rounded corner leaves the tool beside the path, for example.
        if (!powerFailedAt.empty() && output.contains("error")) {
          ++m_tally.refused;
          qInfo("refused after a loss of power: %s", output.constData());
          QDir(path("state")).removeRecursively();
          return true;
        }
        qWarning("refused: %s", output.constData());
        return false;
      }
      m_tally.resumed += resume.isEmpty() ? 0 : 1;
      if (wasKilled && m_random.uniform() < 0.5) {
        QProcess stop;  // not even the windows that were delivered are waited for
        start(stop, words("runs --stop --endpoint") << m_endpoint);
        note(QStringLiteral("stop, exit %1").arg(finished(stop)));
      }
      awaitStandstill();
      if (!wasKilled) {
        if (exit != 0) {
          qWarning("exit %d: %s", exit, output.constData());
          return false;
        }
        break;
      }
      candidates = savedRuns();
    }
    ++m_tally.runs;
    const auto program = gcode::loadProgram(m_program.toStdString());
    const auto points = gcode::streamPoints(program->trajectory, {}).points;
    const trace::Integrity integrity = trace::judgeIntegrity(
        points, executedWithoutRests(before, powerFailedAt), trace::kPointToleranceMm);
    if (!integrity.isFaultless() || integrity.executed != points.size()) {
      qWarning("%zu of %zu executed, %zu repeated, %zu skipped, %zu foreign", integrity.executed,
               points.size(), integrity.repeated, integrity.skipped, integrity.foreign);
      for (const trace::ExecutedBlock& block : executed(before)) {
        m_history << QStringLiteral("to X%1 Y%2 Z%3 over %4 mm")
                         .arg(block.targetMm.x)
                         .arg(block.targetMm.y)
                         .arg(block.targetMm.z)
                         .arg(block.lengthMm);
      }
      qWarning("%s", qPrintable(m_history.join(QLatin1Char('\n'))));
      return false;
    }
    return true;
  }

 private Q_SLOTS:
  void initTestCase() {
    m_program = path("rows.nc");
    QFile program(m_program);
    QVERIFY(program.open(QIODevice::WriteOnly));
    QVERIFY(program.write(rows()) > 0);
  }
  void cleanupTestCase() { m_machine.reset(); }

  /// RIVULET_KILLS kills from the seed RIVULET_FIRST on.
  void everyPointOnceWhateverIsKilled() {
    const int kills = setting("RIVULET_KILLS", 4);
    const auto seed = static_cast<std::uint64_t>(setting("RIVULET_FIRST", 1));
    m_random = base::Random(seed);
    switchOn();
    QProcess test;  // of method credit
    start(test, words("commission --json --endpoint") << m_endpoint);
    QCOMPARE(finished(test), 0);
    for (int number = 0; m_tally.kills < kills; ++number) {
      const bool credit = number % 2 == 1;
      const int most =
          std::min(kills - m_tally.kills, 1 + static_cast<int>(m_random.uniform() * 5.0));
      QVERIFY2(run(credit, most),
               qPrintable(QStringLiteral("seed %1, run %2").arg(seed).arg(number)));
    }
    qInfo(
        "%d kills: %d of clients, %d of machines; %d runs to the end, %d starts resumed; %d "
        "refused after a loss of power",
        m_tally.kills, m_tally.clientKills, m_tally.machineKills, m_tally.runs, m_tally.resumed,
        m_tally.refused);
  }
};

RIVULET_TEST(TestKills)
#include "tst_kills.moc"
