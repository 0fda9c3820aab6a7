// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Clients and virtual machines that are killed at drawn moments, by the programs themselves over
/// OPC UA in real time. What is left is found from the checkpoint on disk and the cells on the
/// control, which the machine keeps over a loss of power; the judge has nothing but the list of
/// points and the machine's own list of executed blocks.

#include <QProcess>
#include <QtTest>
#include <csignal>

#include "base/random.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/setting.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
constexpr int kPollMs = 10;
constexpr qsizetype kHistoryBytes = 300;  // of what a client has printed
/// Of a whole run, about: kills are drawn within it.
constexpr double kStreamMs = 6000.0;

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
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

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  base::Random m_random{1};
  Tally m_tally;
  QStringList m_history;  ///< of this run, shown if something is wrong

  /// A program of Rivulet with homes of its own.
  void start(QProcess& process, const QStringList& arguments) const {
    process.setProcessEnvironment(m_scene.environment());
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

  [[nodiscard]] QStringList streamed(bool credit, const QString& resume) const {
    QStringList arguments = QStringList{QStringLiteral("stream"), m_scene.programFile()} +
                            words("--feed 1500 --points 4 --json --endpoint");
    arguments << m_scene.endpoint();
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
    while (!early && client.state() == QProcess::Running && !m_scene.isGranted()) {
      client.waitForFinished(kPollMs);
    }
    return client.state() == QProcess::Running && !client.waitForFinished(delayMs);
  }

  void note(const QString& what) {
    m_history << QStringLiteral("%1 blocks: %2").arg(m_scene.executed().size()).arg(what);
  }

  /// One run to the end of the path, killed on the way. @return false if something was wrong
  bool run(bool credit, int killsMax) {
    const std::size_t before = m_scene.executed().size();
    m_history.clear();
    QStringList candidates;
    int kills = 0;
    bool wasSwitchedOff = false;
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
          wasSwitchedOff = true;
          m_scene.switchOff();
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
        m_scene.switchOn();
        if (exit == 0) {
          break;  // it was at its end
        }
        candidates = m_scene.savedRuns();
        continue;
      }
      if (exit == 2 && !wasKilled) {
        if (output.contains("Every point has been executed already")) {
          // The windows that had been delivered were the last.
          m_scene.forgetRuns();
          break;
        }
        if (!candidates.isEmpty()) {
          continue;  // an older one that has been replaced
        }
        // A loss of power on a rounded corner leaves the tool beside the path, for example.
        if (wasSwitchedOff && output.contains("error")) {
          ++m_tally.refused;
          qInfo("refused after a loss of power: %s", output.constData());
          m_scene.forgetRuns();
          return true;
        }
        qWarning("refused: %s", output.constData());
        return false;
      }
      m_tally.resumed += resume.isEmpty() ? 0 : 1;
      if (wasKilled && m_random.uniform() < 0.5) {
        QProcess stop;  // not even the windows that were delivered are waited for
        start(stop, words("runs --stop --endpoint") << m_scene.endpoint());
        note(QStringLiteral("stop, exit %1").arg(finished(stop)));
      }
      m_scene.awaitStandstill();
      if (!wasKilled) {
        if (exit != 0) {
          qWarning("exit %d: %s", exit, output.constData());
          return false;
        }
        break;
      }
      candidates = m_scene.savedRuns();
    }
    ++m_tally.runs;
    const bool isWhole = m_scene.isWhole(before);
    if (!isWhole) {
      qWarning("%s", qPrintable(m_history.join(QLatin1Char('\n'))));
    }
    return isWhole;
  }

 private Q_SLOTS:
  void cleanupTestCase() { m_scene.switchOff(); }

  /// RIVULET_KILLS kills from the seed RIVULET_FIRST on.
  void everyPointOnceWhateverIsKilled() {
    const int kills = tests::setting("RIVULET_KILLS", 4);
    const auto seed = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 1));
    m_random = base::Random(seed);
    m_scene.switchOn();
    QProcess test;  // of method credit
    start(test, words("commission --json --endpoint") << m_scene.endpoint());
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
