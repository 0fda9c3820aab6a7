// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The service and the virtual machine as programs, over OPC UA in real time: what a client can do,
/// what is refused, and what happens when a client, the service or the machine goes away. The judge
/// has nothing but the list of points and the machine's own list of executed blocks.

#include <QFileInfo>
#include <QtTest>

#include "preparation/release_file.h"
#include "service/service_session.h"
#include "support/kill_scene.h"
#include "support/service_process.h"
#include "support/test_program.h"
#include "trust/connect.h"

using namespace rivulet;
using tests::ServiceProcess;

namespace {

constexpr const char* kSettings = "feed=1500;points=4";

service::Caller engineer() {
  return {"anna", {permission::Role::Engineer, false}, true};
}
service::Caller operatorAt() {
  return {"otto", {permission::Role::Operator, false}, true};
}

}  // namespace

class TestService : public QObject {
  Q_OBJECT

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};

  [[nodiscard]] std::string file() const { return m_scene.programFile().toStdString(); }
  [[nodiscard]] std::unique_ptr<ServiceProcess> service(const QStringList& options = {}) const {
    return std::make_unique<ServiceProcess>(QStringLiteral(RIVULET_SERVICE), m_scene.endpoint(),
                                            m_scene.environment(), options);
  }
  /// Loads the program of the scene and starts it.
  [[nodiscard]] bool start(ServiceProcess& service) const {
    if (!service.await("Monitoring/IsConnected", "true")) {
      return false;
    }
    const service::Answer loaded = service.call("LoadJob", {file(), kSettings});
    if (!loaded.accepted) {
      qWarning("%s", loaded.message.c_str());
      return false;
    }
    const service::Answer started = service.call("Start", {service.confirmation("Preflight")});
    if (!started.accepted) {
      qWarning("%s", started.message.c_str());
    }
    return started.accepted;
  }
  [[nodiscard]] static bool awaitPoints(ServiceProcess& service, int points) {
    return service.awaitThat([points](const ServiceProcess::Values& values) {
      return std::stoi(values.at("Production/ActiveProgram/PointsDone")) >= points;
    });
  }
  [[nodiscard]] static bool resume(ServiceProcess& service) {
    if (!service.await("Monitoring/State", "left")) {
      return false;
    }
    const service::Answer resumed =
        service.call("ResumeRun", {service.confirmation("PreflightResume")});
    if (!resumed.accepted) {
      qWarning("%s", resumed.message.c_str());
    }
    return resumed.accepted;
  }

 private Q_SLOTS:
  void initTestCase() { m_scene.switchOn(); }
  void cleanup() { m_scene.awaitStandstill(); }
  void cleanupTestCase() { m_scene.switchOff(); }

  void executesEveryPointOnce() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(start(*service));
    QVERIFY(awaitPoints(*service, 8));
    QCOMPARE(service->value("MachineryItemState/CurrentState"), "Executing");
    QCOMPARE(service->value("Production/ActiveProgram/State/CurrentState"), "Running");
    const auto refused = service->call("LoadJob", {file(), ""});
    QVERIFY(!refused.accepted);
    QCOMPARE(refused.message, "A run is in progress. Wait until it has ended.");
    QVERIFY(service->call("Hold").accepted);
    QVERIFY(service->await("Monitoring/State", "holding"));
    QVERIFY(service->call("Resume").accepted);
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QCOMPARE(service->value("Production/ActiveProgram/PointsDone"), "49");
    QCOMPARE(service->value("Production/ActiveProgram/Progress"), "100");
    QCOMPARE(service->value("Production/ActiveProgram/State/CurrentState"), "Ended");
    QCOMPARE(service->value("Notification/Alarm"), "");
    QVERIFY(QFileInfo::exists(QString::fromStdString(service->value("Session/LastReport"))));
    QVERIFY(m_scene.isWhole(before));
    QCOMPARE(service->end(SIGTERM), 0);
  }

  void startsOnlyWhatWasConfirmed() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QCOMPARE(service->call("Preflight").message, "No program is loaded. Open one first.");
    QVERIFY(service->call("LoadJob", {file(), kSettings}).accepted);
    QVERIFY(!service->call("Start", {""}).accepted);
    const std::string first = service->confirmation("Preflight");
    const std::string second = service->confirmation("Preflight");
    QVERIFY(!first.empty() && !second.empty() && first != second);
    const auto refused = service->call("Start", {first});
    QVERIFY(!refused.accepted);
    QVERIFY2(refused.message.starts_with("Start needs the confirmation"), refused.message.c_str());
    // Another job is not the one that was shown.
    QVERIFY(service->call("LoadJob", {file(), "feed=1000"}).accepted);
    QVERIFY(!service->call("Start", {second}).accepted);
    QCOMPARE(service->value("Monitoring/State"), "loaded");
    QCOMPARE(m_scene.executed().size(), before);
  }

  void refusesWhatCannotBeLoaded() {
    const auto service = this->service({QStringLiteral("--jobs"), m_scene.path("")});
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    const auto refusal = [&](const std::string& name, const std::string& settings) {
      const service::Answer answer = service->call("LoadJob", {name, settings});
      return answer.accepted ? std::string("accepted") : answer.message;
    };
    const auto says = [&](const std::string& name, const std::string& settings,
                          const std::string& why) {
      const std::string said = refusal(name, settings);
      if (said.find(why) == std::string::npos) {
        qWarning("%s", said.c_str());
      }
      return said.find(why) != std::string::npos;
    };
    QCOMPARE(refusal("rows.nc", ""), "accepted");
    QVERIFY(says("../rows.nc", "", "Only files in the folder of jobs"));
    QVERIFY(says("/etc/passwd", "", "Only files in the folder of jobs"));
    QVERIFY(refusal("none.nc", "") != "accepted");
    QVERIFY(says("rows.nc", "points=four", "four is no value of the setting points"));
    QVERIFY(says("rows.nc", "colour=blue", "There is no setting colour."));
    QVERIFY(says("rows.nc", "fast", "Settings are written as name=value"));
  }

  void refusesASecondService() {
    const auto first = this->service();
    const auto second = this->service();
    QVERIFY(second->endpoint().isEmpty());
    QCOMPARE(second->finish(), 4);
    const QString errors = second->errors();
    QVERIFY2(errors.contains(QStringLiteral("already streams to this machine")),
             qPrintable(errors));
    QCOMPARE(first->end(SIGTERM), 0);
    QVERIFY(!this->service()->endpoint().isEmpty());
  }

  void leavesARunThatCanBeResumed() {
    const std::size_t before = m_scene.executed().size();
    auto service = this->service();
    QVERIFY(start(*service));
    QVERIFY(awaitPoints(*service, 10));
    QCOMPARE(service->end(SIGTERM), 0);
    m_scene.awaitStandstill();
    const std::size_t executed = m_scene.executed(before).size();
    QVERIFY(executed >= 10 && executed < 49);
    QCOMPARE(m_scene.savedRuns().size(), qsizetype{1});
    service = this->service();
    QVERIFY(resume(*service));
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
    QVERIFY(m_scene.savedRuns().isEmpty());
    const QDir reports(m_scene.path("state/rivulet/history"));
    QVERIFY(!reports.entryList({QStringLiteral("*.json")}, QDir::Files).isEmpty());
  }

  void doesNotNeedItsClients() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QProcess follower;
    follower.start(QStringLiteral(RIVULET_SERVICE),
                   {QStringLiteral("show"), QStringLiteral("--follow"), service->endpoint()});
    QVERIFY(follower.waitForReadyRead());
    QVERIFY(start(*service));
    QVERIFY(awaitPoints(*service, 6));
    follower.kill();
    QVERIFY(follower.waitForFinished());
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
  }

  void waitsForAMachineThatIsGone() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(start(*service));
    QVERIFY(awaitPoints(*service, 10));
    m_scene.switchOff();
    QVERIFY(service->await("Monitoring/State", "disconnected"));
    QVERIFY(!service->value("Notification/Alarm").empty());
    QCOMPARE(service->value("Session/LastOutcome"), "failed");
    m_scene.switchOn();
    QVERIFY(resume(*service));
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
  }

  /// The rules of the window: an operator starts what is released, with the released settings.
  void asksWhoMayStart() {
    const std::filesystem::path folder = m_scene.path("state/rivulet").toStdString();
    opcua::ConnectRequest request;
    request.endpoint = m_scene.endpoint().toStdString();
    service::ServiceSession session(
        {request, {}, folder},
        [this](const opcua::ConnectRequest& asked) {
          return trust::connect(asked, m_scene.path("config/trust").toStdString());
        },
        report::MachineStore(report::MachineFolders::below(m_scene.path("data").toStdString(),
                                                           m_scene.path("config").toStdString())));
    const auto isSeen = [&] {
      session.turn(service::ServiceSession::Clock::now());
      return !session.snapshot().positionMm.empty();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(), 20'000);
    service::Caller nobody;
    nobody.standing.isLocked = true;
    QVERIFY(session.loadJob(nobody, file(), "").message.starts_with("This service has users"));
    QCOMPARE(session.loadJob(operatorAt(), file(), kSettings).message,
             "Only an engineer may do this. Log in as one.");
    QVERIFY(session.loadJob(operatorAt(), file(), "").accepted);
    QCOMPARE(session.preflight(operatorAt()).message,
             "This program with these settings is not released. An engineer has to release it.");
    QVERIFY(session.loadJob(engineer(), file(), kSettings).accepted);
    QVERIFY(session.preflight(engineer()).accepted);
    const service::Snapshot seen = session.snapshot();
    permission::Release release;
    release.job = {seen.hash, seen.settings, ""};
    release.programName = seen.program;
    release.by = "anna";
    release.at = 1;
    QVERIFY(preparation::appendRelease(preparation::releaseFileIn(folder), release));
    QVERIFY(session.loadJob(operatorAt(), file(), "").accepted);
    QCOMPARE(session.snapshot().settings, seen.settings);
    QVERIFY(session.preflight(operatorAt()).accepted);
    const std::string confirmation = session.preflight(operatorAt()).confirmation;
    QVERIFY(!session.start(nobody, confirmation).accepted);
    // Who may not start does not take the confirmation from somebody who may.
    QVERIFY(!session.preflight(nobody).accepted);
    QVERIFY(session.start(operatorAt(), confirmation).accepted);
    QVERIFY(session.stop(nobody).accepted);
    const auto hasEnded = [&] {
      session.turn(service::ServiceSession::Clock::now());
      return !session.isRunning();
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasEnded(), 30'000);
  }
};

RIVULET_TEST(TestService)
#include "tst_service.moc"
