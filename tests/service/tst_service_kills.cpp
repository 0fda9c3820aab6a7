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
};

RIVULET_TEST(TestServiceKills)
#include "tst_service_kills.moc"
