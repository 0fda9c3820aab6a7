// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The service is killed at drawn moments and started again; somebody then goes on with the run.
/// The judge has nothing but the list of points and the machine's own list of executed blocks.

#include <QtTest>

#include "base/random.h"
#include "support/kill_scene.h"
#include "support/service_process.h"
#include "support/setting.h"
#include "support/test_program.h"

using namespace rivulet;
using tests::ServiceProcess;

namespace {

/// Of a whole run, about: kills are drawn within it.
constexpr double kStreamMs = 6500.0;

}  // namespace

class TestServiceKills : public QObject {
  Q_OBJECT

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  base::Random m_random{1};
  int m_kills = 0;
  int m_resumed = 0;

  [[nodiscard]] std::unique_ptr<ServiceProcess> service() const {
    return std::make_unique<ServiceProcess>(
        QStringLiteral(RIVULET_SERVICE), m_scene.endpoint(), m_scene.environment(),
        QStringList{QStringLiteral("--jobs"), m_scene.path("")});
  }
  /// Starts the program, or goes on with the run that was left.
  /// @return empty: there is nothing left to do
  std::string begin(ServiceProcess& service, bool isNew) {
    if (isNew) {
      if (!service.call("LoadJob", {m_scene.programFile().toStdString(), "feed=1500;points=4"})
               .accepted) {
        return "LoadJob is refused";
      }
      const auto answer = service.call("Start", {service.confirmation("Preflight")});
      return answer.accepted ? "started" : answer.message;
    }
    const std::string confirmation = service.confirmation("PreflightResume");
    if (confirmation.empty()) {
      return service.refusal();
    }
    const auto answer = service.call("ResumeRun", {confirmation});
    m_resumed += answer.accepted ? 1 : 0;
    return answer.accepted ? "started" : answer.message;
  }

  /// One run to the end of the path, killed on the way. @return false if something was wrong
  bool run(int killsMax) {
    const std::size_t before = m_scene.executed().size();
    bool isNew = true;
    for (int kills = 0;;) {
      const auto service = this->service();
      if (!service->await("Monitoring/IsConnected", "true") ||
          !service->awaitThat([&](const ServiceProcess::Values& values) {
            return !values.at("Monitoring/Position").empty() &&
                   (isNew || values.at("Monitoring/State") != "idle" ||
                    m_scene.savedRuns().isEmpty());
          })) {
        qWarning("the service does not come to its machine");
        return false;
      }
      if (!isNew && m_scene.savedRuns().isEmpty()) {
        break;  // killed after the end of the run
      }
      const std::string begun = begin(*service, isNew);
      if (begun.find("Every point has been executed already") != std::string::npos) {
        // The windows that had been delivered were the last.
        const bool isForgotten = service->call("ForgetRun").accepted;
        m_scene.awaitStandstill();
        return isForgotten && m_scene.savedRuns().isEmpty() && m_scene.isWhole(before);
      }
      if (begun != "started") {
        qWarning("after %zu blocks: %s", m_scene.executed(before).size(), begun.c_str());
        return false;
      }
      if (kills < killsMax) {
        ++kills;
        ++m_kills;
        QThread::msleep(static_cast<unsigned long>(m_random.uniform() * kStreamMs));
        service->end(SIGKILL);
        m_scene.awaitStandstill();
        // Killed before it was kept, the run has not moved anything.
        isNew = m_scene.savedRuns().isEmpty() && m_scene.executed(before).empty();
        continue;
      }
      if (!service->await("Session/LastOutcome", "completed")) {
        return false;
      }
      break;
    }
    m_scene.awaitStandstill();
    return m_scene.isWhole(before);
  }

 private Q_SLOTS:
  void cleanupTestCase() { m_scene.switchOff(); }

  /// RIVULET_KILLS kills from the seed RIVULET_FIRST on.
  void everyPointOnceWheneverItIsKilled() {
    const int kills = tests::setting("RIVULET_KILLS", 4);
    const auto seed = static_cast<std::uint64_t>(tests::setting("RIVULET_FIRST", 1));
    m_random = base::Random(seed);
    m_scene.switchOn();
    int runs = 0;
    for (; m_kills < kills; ++runs) {
      const int most = std::min(kills - m_kills, 1 + static_cast<int>(m_random.uniform() * 4.0));
      QVERIFY2(run(most), qPrintable(QStringLiteral("seed %1, run %2").arg(seed).arg(runs)));
    }
    qInfo("%d kills of the service, %d runs to the end, %d starts resumed", m_kills, runs,
          m_resumed);
  }

  /// The service is killed in each stretch of a job, of which every one but the first is executed
  /// by a resume, and in the blocks of the control between two of them.
  void aJobGoesOnHoweverOftenItIsKilled() {
    m_scene.switchOff();  // both have the same port
    tests::KillScene mill{QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill"),
                          tests::KillScene::Kept::Jobs};
    mill.switchOn();
    constexpr int kStretches = 4;
    constexpr int kMoves = 10;
    QByteArray text("G54\nT1 D1 M6\nS3000 M3\nG0 X0 Y0 Z20\n");
    for (int move = 1; move <= kStretches * kMoves; ++move) {
      text += "G1 X" + QByteArray::number(move) + " Y" + QByteArray::number(move % 2) + " F600\n";
      text += move % kMoves == 0 ? "M8\nG4 F2\n" : "";
    }
    QFile job(mill.path("part.mpf"));
    QVERIFY(job.open(QIODevice::WriteOnly));
    QVERIFY(job.write(text + "G0 Z30\nM5 M9\nM30\n") > 0);
    job.close();
    const auto serviceOfMill = [&mill] {
      auto service = std::make_unique<ServiceProcess>(
          QStringLiteral(RIVULET_SERVICE), mill.endpoint(), mill.environment(),
          QStringList{QStringLiteral("--jobs"), mill.path("")});
      return service->await("Monitoring/IsConnected", "true") ? std::move(service) : nullptr;
    };
    auto service = serviceOfMill();
    QVERIFY(service);
    QVERIFY(service->call("LoadJob", {"part.mpf", ""}).accepted);
    QVERIFY(service->call("Start", {service->confirmation("Preflight")}).accepted);
    const auto resume = [&]() -> std::string {
      std::string confirmation = service->await("Monitoring/State", "left")
                                     ? service->confirmation("PreflightResume")
                                     : std::string();
      if (confirmation.empty() &&
          service->refusal().find("EndRun of a service") != std::string::npos) {
        // It stands in a block of its own: somebody lets it end.
        const bool isEnded =
            service->call("EndRun").accepted &&
            service->await("Notification/Message", "The program on the control has ended.");
        mill.awaitStandstill();
        confirmation = isEnded ? service->confirmation("PreflightResume") : std::string();
      }
      const service::Answer resumed = service->call("ResumeRun", {confirmation});
      return resumed.accepted ? std::string() : service->refusal() + ' ' + resumed.message;
    };
    int resumed = 0;
    for (int stretch = 1; stretch <= kStretches; ++stretch) {
      // In the stretch, and at its end: then in the blocks after it.
      for (const int points : {stretch * kMoves - 6, stretch * kMoves}) {
        QVERIFY2(service->awaitPoints(points), qPrintable(QString::number(points)));
        service->end(SIGKILL);
        mill.awaitRest();
        service = serviceOfMill();
        QVERIFY(service);
        const std::string why = resume();
        QVERIFY2(why.empty(), why.c_str());
        ++resumed;
      }
    }
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QCOMPARE(resumed, 2 * kStretches);
    QCOMPARE(mill.movesMade(0), kStretches * kMoves);
    QVERIFY(mill.savedRuns().isEmpty());
    service.reset();
    mill.switchOff();
  }
};

RIVULET_TEST(TestServiceKills)
#include "tst_service_kills.moc"
