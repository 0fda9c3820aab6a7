// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole jobs whose programs are killed at drawn moments, up to three times in a row: the client on
/// the command line, the service, the machine, or both at once; in stretches, in blocks of the
/// control, in a tool change, and while the job is being resumed. Everything goes over OPC UA in
/// real time. The judge has nothing but the machine's own list of executed blocks.

#include <QProcess>
#include <QtTest>
#include <algorithm>
#include <csignal>
#include <map>

#include "base/random.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/service_process.h"
#include "support/setting.h"
#include "support/test_program.h"

using namespace rivulet;
using tests::KillScene;
using tests::kRunMs;
using tests::ServiceProcess;

namespace {

constexpr int kPollMs = 20;
/// Of a job without a tool change, about: kills are drawn within it.
constexpr double kJobMs = 5000.0;
constexpr int kStartsMax = 40;

struct Tally {
  int kills = 0;
  std::map<QString, int> killed;  ///< by what
  int jobs = 0;                   ///< to their end
  int resumed = 0;                ///< starts that went on with a job
  int resumedKilled = 0;          ///< of these, killed again
};

}  // namespace

class TestJobKills : public QObject {
  Q_OBJECT

  KillScene m_scene{QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                    KillScene::Kept::Jobs};
  base::Random m_random{1};
  Tally m_tally;
  QStringList m_history;  ///< of this job, shown if something is wrong
  int m_moves = 0;        ///< of this job

  enum class Came {
    Ended,    ///< the job is done
    Waits,    ///< the control is busy with blocks of its own: later
    Failed,   ///< as after a lost machine: the job is kept
    Refused,  ///< it does not go on
  };

  void note(const QString& what) {
    m_history << QStringLiteral("%1 blocks: %2").arg(m_scene.executed().size()).arg(what);
  }
  int drawn(int count) { return static_cast<int>(m_random.uniform() * count) % count; }

  /// Moves of 1 mm in X, one after the other, with blocks of the control between them.
  [[nodiscard]] QString writeJob() {
    QByteArray text("G54\n");
    const bool hasTool = drawn(4) == 0;
    text += hasTool ? "T2 D1 M6\n" : "T1 D1 M6\n";
    text += "S3000 M3\nG0 X0 Y0 Z20\n";
    const std::array<const char*, 4> native{"M8\n", "G4 F0.4\n", "S2500 M3\n", "M9\n"};
    m_moves = 0;
    const int stretches = 2 + drawn(3);
    for (int stretch = 0; stretch < stretches; ++stretch) {
      for (int i = 0; i < 10; ++i) {
        ++m_moves;
        text += "G1 X" + QByteArray::number(m_moves) + " Y" + QByteArray::number(m_moves % 2) +
                " F1200\n";
      }
      text += native[static_cast<std::size_t>(drawn(4))];
    }
    QFile file(m_scene.path("part.mpf"));
    if (!file.open(QIODevice::WriteOnly) || file.write(text + "G0 Z30\nM5 M9\nM30\n") <= 0) {
      qFatal("the job cannot be written");
    }
    return file.fileName();
  }

  static QByteArray runCli(const QStringList& arguments, const QProcessEnvironment& environment) {
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    if (!process.waitForFinished(kRunMs)) {
      process.kill();
      process.waitForFinished(kRunMs);
    }
    return QByteArray::number(process.exitCode()) + ' ' + process.readAllStandardError();
  }
  /// Somebody ends what the control still executes.
  void endOnControl() {
    for (const char* how : {"--stop", "--end"}) {
      note(QStringLiteral("runs %1: %2")
               .arg(QString::fromUtf8(how),
                    QString::fromUtf8(runCli({QStringLiteral("runs"), QString::fromUtf8(how),
                                              QStringLiteral("--endpoint"), m_scene.endpoint()},
                                             m_scene.environment()))));
    }
  }

  /// What is killed at the drawn moment; empty: nothing is.
  [[nodiscard]] QString drawVictim(const QString& host) {
    const int kind = drawn(8);
    return kind < 5 ? host : kind < 7 ? QStringLiteral("machine") : QStringLiteral("both");
  }
  [[nodiscard]] int drawDelayMs(bool resumes) {
    const bool isEarly = drawn(4) == 0;
    const double most = isEarly ? 1500.0 : kJobMs + (resumes ? 0.0 : 1000.0);
    return 200 + static_cast<int>(m_random.uniform() * most);
  }
  void killMachine(const QString& victim) {
    if (victim == QLatin1String("machine") || victim == QLatin1String("both")) {
      m_scene.switchOff();
    }
  }
  void countKill(const QString& victim, bool resumes) {
    ++m_tally.kills;
    ++m_tally.killed[victim];
    m_tally.resumedKilled += resumes ? 1 : 0;
    note(victim + QStringLiteral(" killed"));
  }

  /// @param kept  the job to go on with; empty: from its start  @param killsLeft  becomes less
  Came byCommandLine(const QString& file, const QString& kept, int& killsLeft) {
    QStringList arguments{QStringLiteral("job"), file, QStringLiteral("--endpoint"),
                          m_scene.endpoint()};
    if (!kept.isEmpty()) {
      arguments << QStringLiteral("--resume") << kept << QStringLiteral("--yes");
    }
    QProcess client;
    client.setProcessEnvironment(m_scene.environment());
    client.start(QStringLiteral(RIVULET_CLI), arguments);
    QString victim;
    if (killsLeft > 0 && client.waitForStarted(kRunMs) &&
        !client.waitForFinished(drawDelayMs(!kept.isEmpty())) &&
        client.state() == QProcess::Running) {
      --killsLeft;
      victim = drawVictim(QStringLiteral("client"));
      killMachine(victim);
      if (victim != QLatin1String("machine")) {
        client.kill();
      }
      countKill(victim, !kept.isEmpty());
    }
    const bool hasEnded = client.state() == QProcess::NotRunning || client.waitForFinished(kRunMs);
    if (!hasEnded) {
      client.kill();
      client.waitForFinished(kRunMs);
    }
    const QByteArray errors = client.readAllStandardError();
    note(QStringLiteral("command line: exit %1 %2")
             .arg(client.exitCode())
             .arg(QString::fromUtf8(errors.right(400))));
    if (!hasEnded) {
      return Came::Refused;
    }
    if (!victim.isEmpty()) {
      return Came::Failed;
    }
    return client.exitCode() == 0                                            ? Came::Ended
           : errors.contains("runs --end") || errors.contains("runs --stop") ? Came::Waits
                                                                             : Came::Refused;
  }

  Came byService(const QString& file, bool resumes, int& killsLeft) {
    ServiceProcess service(QStringLiteral(RIVULET_SERVICE), m_scene.endpoint(),
                           m_scene.environment(),
                           QStringList{QStringLiteral("--jobs"), m_scene.path("")});
    if (!service.await("Monitoring/IsConnected", "true") ||
        !service.awaitThat([&](const ServiceProcess::Values& values) {
          return !values.at("Monitoring/Position").empty() &&
                 (!resumes || values.at("ProductionPlan/CanResume") == "true");
        })) {
      note(QStringLiteral("the service does not come to its machine or job"));
      return Came::Refused;
    }
    service::Answer started;
    if (resumes) {
      const std::string confirmation = service.confirmation("PreflightResume");
      started = confirmation.empty() ? service::Answer{false, service.refusal(), {}}
                                     : service.call("ResumeRun", {confirmation});
    } else {
      started = service.call("LoadJob", {file.toStdString(), ""});
      const std::string confirmation =
          started.accepted ? service.confirmation("Preflight") : std::string();
      started = !started.accepted      ? started
                : confirmation.empty() ? service::Answer{false, service.refusal(), {}}
                                       : service.call("Start", {confirmation});
    }
    if (!started.accepted) {
      note(QStringLiteral("service: ") + QString::fromStdString(started.message));
      return started.message.find("EndRun") != std::string::npos ||
                     started.message.find("still") != std::string::npos
                 ? Came::Waits
                 : Came::Refused;
    }
    const auto hasEnded = [&] { return !service.value("Session/LastOutcome").empty(); };
    if (killsLeft > 0) {
      QElapsedTimer timer;
      timer.start();
      const int delayMs = drawDelayMs(resumes);
      bool isOver = hasEnded();
      while (!isOver && timer.elapsed() < delayMs) {
        QThread::msleep(kPollMs);
        isOver = hasEnded();
      }
      if (!isOver) {
        --killsLeft;
        const QString victim = drawVictim(QStringLiteral("service"));
        killMachine(victim);
        service.end(victim == QLatin1String("machine") ? SIGTERM : SIGKILL);
        countKill(victim, resumes);
        return Came::Failed;
      }
    }
    const bool isCompleted = service.await("Session/LastOutcome", "completed");
    note(QStringLiteral("service: %1").arg(isCompleted ? "completed" : "not completed"));
    return isCompleted ? Came::Ended : Came::Refused;
  }

  /// One job to its end, killed on the way. @return false: a motion is wrong, or the job is lost
  bool run(int killsMax) {
    const std::size_t before = m_scene.executed().size();
    m_history.clear();
    const QString file = writeJob();
    int killsLeft = killsMax;
    bool isDone = false;
    for (int starts = 0; !isDone && starts < kStartsMax; ++starts) {
      const QStringList kept = m_scene.savedRuns();
      const int made = m_scene.movesMade(before);
      if (kept.isEmpty() && made != 0) {
        isDone = made == m_moves;
        if (!isDone) {
          note(QStringLiteral("nothing is kept after %1 of %2 moves").arg(made).arg(m_moves));
          break;
        }
        continue;  // killed after its end
      }
      const bool isService = drawn(2) == 1;
      note(QStringLiteral("%1 by the %2")
               .arg(kept.isEmpty() ? "start" : "resume", isService ? "service" : "command line"));
      const Came came = isService ? byService(file, !kept.isEmpty(), killsLeft)
                                  : byCommandLine(file, kept.value(0), killsLeft);
      if (came == Came::Refused) {
        break;
      }
      m_tally.resumed += kept.isEmpty() || came == Came::Waits ? 0 : 1;
      isDone = came == Came::Ended;
      if (m_scene.isOff()) {
        m_scene.switchOn();
      } else if (came == Came::Waits || (came == Came::Failed && drawn(2) == 0)) {
        endOnControl();
      }
    }
    const bool isRight =
        isDone && m_scene.movesMade(before) == m_moves && m_scene.savedRuns().isEmpty();
    if (!isRight) {
      qWarning("%s", qPrintable(m_history.join(QLatin1Char('\n'))));
      for (const trace::ExecutedBlock& block : m_scene.executed(before)) {
        qWarning("to X%g Y%g Z%g", block.targetMm.x, block.targetMm.y, block.targetMm.z);
      }
    }
    m_tally.jobs += isRight ? 1 : 0;
    return isRight;
  }

 private Q_SLOTS:
  void cleanupTestCase() { m_scene.switchOff(); }

  /// RIVULET_KILLS kills from the seed RIVULET_FIRST on.
  void everyMotionOnceWhateverIsKilled() {
    const int kills = tests::setting("RIVULET_KILLS", 3);
    const auto seed = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 1));
    m_random = base::Random(seed);
    m_scene.switchOn();
    for (int number = 0; m_tally.kills < kills; ++number) {
      const int most = std::min(kills - m_tally.kills, 1 + drawn(3));
      QVERIFY2(run(most), qPrintable(QStringLiteral("seed %1, job %2").arg(seed).arg(number)));
    }
    QStringList victims;
    for (const auto& [victim, count] : m_tally.killed) {
      victims << QStringLiteral("%1 %2").arg(victim).arg(count);
    }
    qInfo(
        "%d kills (%s), %d of them of a job that was being resumed; %d jobs to the end, %d starts "
        "that went on with one",
        m_tally.kills, qPrintable(victims.join(QStringLiteral(", "))), m_tally.resumedKilled,
        m_tally.jobs, m_tally.resumed);
  }
};

RIVULET_TEST(TestJobKills)
#include "tst_job_kills.moc"
