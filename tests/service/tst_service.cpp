// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The service and the virtual machine as programs, over OPC UA in real time: what a client can do,
/// what is refused, and what happens when a client, the service or the machine goes away. The judge
/// has nothing but the list of points and the machine's own list of executed blocks.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "journal/audit.h"
#include "opcua/error.h"
#include "opcua/open62541/discovery.h"
#include "preparation/release_file.h"
#include "service/node_table.h"
#include "service/service_session.h"
#include "service/service_watch.h"
#include "support/empty_arrays.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/plain_server.h"
#include "support/service_process.h"
#include "support/test_program.h"
#include "support/user_list.h"
#include "trust/connect.h"

using namespace rivulet;
using tests::ServiceProcess;

namespace {

constexpr const char* kSettings = "feed=1500;points=4";

/// A TCP socket of this computer, closed at the end.
class Sensor {
 public:
  Sensor() : m_socket(::socket(AF_INET, SOCK_STREAM, 0)) {}
  ~Sensor() { ::close(m_socket); }
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;

  /// A port that nobody has now.
  [[nodiscard]] static int freePort() {
    const Sensor probe;
    sockaddr_in address = at(0);
    socklen_t size = sizeof(address);
    ::bind(probe.m_socket, generic(address), size);
    ::getsockname(probe.m_socket, generic(address), &size);
    return ntohs(address.sin_port);
  }
  [[nodiscard]] bool connect(int port) const {
    sockaddr_in address = at(port);
    return ::connect(m_socket, generic(address), sizeof(address)) == 0;
  }
  [[nodiscard]] bool send(const std::string& line) const {
    return ::send(m_socket, line.data(), line.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(line.size());
  }

 private:
  [[nodiscard]] static sockaddr_in at(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
  }
  [[nodiscard]] static sockaddr* generic(sockaddr_in& address) {
    return reinterpret_cast<sockaddr*>(&address);
  }
  int m_socket;
};

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
  [[nodiscard]] std::unique_ptr<ServiceProcess> service(QStringList options = {}) const {
    if (!options.contains(QStringLiteral("--jobs"))) {
      options << QStringLiteral("--jobs") << m_scene.path("");
    }
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
    QVERIFY(service->awaitPoints(8));
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

  /// By the feed cell: the axes stand in the middle of a window, and go on from there.
  void holdsAndOverridesAtOnce() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(!service->call("SetOverride", {"50"}).accepted);  // nothing runs
    QVERIFY(start(*service));
    QVERIFY(service->awaitPoints(4));
    for (const char* wrong : {"250", "-1", "nan", "121", "half", ""}) {
      QVERIFY2(!service->call("SetOverride", {wrong}).accepted, wrong);
    }
    QVERIFY(service->call("SetOverride", {"50"}).accepted);
    QVERIFY(service->await("Monitoring/Override", "50"));
    QVERIFY(service->call("Hold").accepted);
    QVERIFY(service->await("Monitoring/Stands", "true"));
    QCOMPARE(service->value("Monitoring/Override"), "0");
    QCOMPARE(service->value("Monitoring/State"), "holding");
    // It is empty while it has not been read for long.
    std::string place;
    QTRY_VERIFY_WITH_TIMEOUT(!(place = service->value("Monitoring/Position")).empty(),
                             tests::kSoonMs);
    const std::string points = service->value("Production/ActiveProgram/PointsDone");
    QVERIFY(service->call("SetOverride", {"100"}).accepted);  // it stays held
    QVERIFY(service->await("Monitoring/State", "holding"));
    QCOMPARE(service->value("Production/ActiveProgram/PointsDone"), points);
    QTRY_COMPARE_WITH_TIMEOUT(service->value("Monitoring/Position"), place, tests::kSoonMs);
    QVERIFY(service->call("Resume").accepted);
    QVERIFY(service->await("Monitoring/Override", "100"));
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
  }

  /// How the points travel is said before they do.
  void pointsArePackedAndMerged() {
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QVERIFY(!service->call("LoadJob", {file(), std::string(kSettings) + ";tolerance=7"}).accepted);
    const auto loaded =
        service->call("LoadJob", {file(), std::string(kSettings) + ";tolerance=0.01;packed=yes"});
    QVERIFY2(loaded.accepted, loaded.message.c_str());
    service::Answer shown;
    QTRY_VERIFY_WITH_TIMEOUT((shown = service->call("Preflight")).accepted, tests::kSoonMs);
    QVERIFY2(shown.message.find(" points are streamed, at most ") != std::string::npos,
             shown.message.c_str());
  }

  /// A sensor over a real socket: its factors act, within what was agreed and shown before.
  void factorsMultiplyTheOverride() {
    const std::size_t before = m_scene.executed().size();
    const int port = Sensor::freePort();
    const std::string name = "tcp:" + std::to_string(port);
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    const std::string factor =
        ";feed_from=" + name + ";feed_factor_least=0.2;feed_factor_most=1.2;feed_silence=600";
    const auto loaded = service->call("LoadJob", {file(), kSettings + factor});
    QVERIFY2(loaded.accepted, loaded.message.c_str());
    service::Answer shown;
    QTRY_VERIFY_WITH_TIMEOUT((shown = service->call("Preflight")).accepted, tests::kSoonMs);
    QVERIFY2(shown.message.find("The feed follows " + name +
                                ": factor 0.2 to 1.2; without one for 600 s the axes are held.") !=
                 std::string::npos,
             shown.message.c_str());
    QCOMPARE(service->value("Monitoring/FeedFactor"), "-1");
    QVERIFY(service->call("Start", {shown.confirmation}).accepted);
    QVERIFY(service->await("Monitoring/FeedFactor", "0"));
    QVERIFY(service->await("Monitoring/FeedSource",
                           name + ": No factor has come yet: the axes are held."));
    const Sensor sensor;
    QVERIFY(sensor.connect(port));
    QVERIFY(sensor.send("feed 0.5\n"));
    QVERIFY(service->await("Monitoring/Override", "50"));
    QVERIFY(service->await("Monitoring/FeedFactor", "0.5"));
    QVERIFY(service->await("Monitoring/FeedSource", name + ": followed."));
    QVERIFY(sensor.send("feed 250\n"));
    QVERIFY(service->await("Monitoring/Override", "0"));
    QVERIFY(service->awaitThat([](const ServiceProcess::Values& values) {
      return values.at("Monitoring/FeedSource").find("The factor 250 was not agreed") !=
             std::string::npos;
    }));
    QVERIFY(service->await("Monitoring/Stands", "true"));
    // Without the source, until its next factor.
    QVERIFY(service->call("Resume").accepted);
    QVERIFY(service->await("Monitoring/Override", "100"));
    QVERIFY(sensor.send("feed 1.2\n"));
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
    QCOMPARE(service->value("Monitoring/FeedSource"), "");
    QFile report(QString::fromStdString(service->value("Session/LastReport")));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const auto json = nlohmann::json::parse(report.readAll().toStdString());
    QCOMPARE(json.at("factor").at("source").get<std::string>(), name);
    QCOMPARE(json.at("factor").at("refused").get<int>(), 1);
  }

  /// Whoever stops and ends a run does not wait for its source of factors.
  void aSourceThatHoldsDoesNotKeepARun() {
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QVERIFY(service
                ->call("LoadJob",
                       {file(), std::string(kSettings) + ";feed_from=udp:0;feed_factor_least=0.2;"
                                                         "feed_factor_most=1.2"})
                .accepted);
    QVERIFY(service->call("Start", {service->confirmation("Preflight")}).accepted);
    QVERIFY(service->await("Monitoring/FeedFactor", "0"));
    QVERIFY(service->call("Stop").accepted);
    QVERIFY(service->await("Monitoring/Stands", "true"));
    QVERIFY(service->call("Resume").accepted);
    QVERIFY(service->await("Session/LastOutcome", "stopped"));
    QVERIFY(m_scene.isReset());
    if (service->value("ProductionPlan/CanResume") == "true") {
      QVERIFY(service->call("ForgetRun").accepted);
    }
  }

  /// Stop holds first: the axes stand in the middle of a window, and the run ends behind it when
  /// somebody lets it.
  void stopHoldsFirst() {
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QVERIFY(service->call("LoadJob", {file(), "feed=300;points=8"}).accepted);
    QVERIFY(service->call("Start", {service->confirmation("Preflight")}).accepted);
    QVERIFY(service->awaitPoints(8));
    const std::string passed = service->value("Monitoring/Position");
    QVERIFY(service->awaitThat([&passed](const ServiceProcess::Values& values) {
      return values.at("Monitoring/Position") != passed;
    }));
    QVERIFY(service->call("Stop").accepted);
    QVERIFY(service->await("Monitoring/Stands", "true"));
    QVERIFY(!m_scene.isReset());
    const std::string place = service->value("Monitoring/Position");
    QVERIFY(service->call("Stop").accepted);
    QVERIFY(service->await("Monitoring/Override", "0"));
    QCOMPARE(service->value("Monitoring/Position"), place);
    QVERIFY(service->call("Resume").accepted);
    QVERIFY(service->await("Session/LastOutcome", "stopped"));
    QVERIFY(m_scene.isReset());
    QVERIFY(service->await("Monitoring/State", "left"));
    QVERIFY(service->call("ForgetRun").accepted);
  }

  /// Nobody reads what it prints any more.
  void followingEndsWithItsReader() {
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QProcess follower;
    follower.start(
        QStringLiteral("bash"),
        {QStringLiteral("-c"),
         QStringLiteral("\"$0\" show --follow \"$1\" | { read -r line; echo \"$line\"; }"),
         QStringLiteral(RIVULET_SERVICE), service->endpoint()});
    QVERIFY(follower.waitForReadyRead());
    QVERIFY(service->call("LoadJob", {file(), kSettings}).accepted);  // something to print
    QVERIFY(follower.waitForFinished(tests::kRunMs));
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

  void emptyArraysAreNoTexts() {
    const auto service = this->service();
    QVERIFY(tests::callWithEmptyArrays(service->endpoint().toStdString(),
                                       {service::kNamespaceUri,
                                        service::kMethodsObject,
                                        service::methodIdentifier("LoadJob"),
                                        {UA_TYPES_STRING, UA_TYPES_STRING}}) ==
            (std::array{UA_STATUSCODE_BADINVALIDARGUMENT, UA_STATUSCODE_BADINVALIDARGUMENT}));
    QVERIFY(service->await("Monitoring/IsConnected", "true"));  // it goes on
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
    QVERIFY(says("rows.nc", "feed=1e308", "1e308 is no value of the setting feed"));
    QVERIFY(says("rows.nc", "feed=1e-300", "1e-300 is no value of the setting feed"));
    QVERIFY(says("rows.nc", "units=feet", "feet is no value of the setting units"));
    QVERIFY(says("rows.nc", "dialect=apt", "apt is no value of the setting dialect"));
    QCOMPARE(refusal("rows.nc", "units=in;dialect=fanuc;no_point=units"), "accepted");
    QCOMPARE(refusal("rows.nc", "settings=plane=0 lift=-X"), "accepted");
    QVERIFY(says("rows.nc", "settings=depth=0", "depth=0 is no value of the setting settings"));
    QVERIFY(says("rows.nc", "colour=blue", "There is no setting colour."));
    // A client of the service names a port: a path would be one of the service's user.
    for (const char* wrong : {"feed_from=unix:/tmp/x", "feed_from=-", "feed_from=opcua:/etc/passwd",
                              "feed_from=tcp:70000", "feed_factor_most=250", "feed_factor_least=-1",
                              "feed_silence=0", "feed_silence=nan", "feed_silent=stop"}) {
      const std::string name = std::string(wrong).substr(0, std::string(wrong).find('='));
      QVERIFY2(says("rows.nc", wrong, "is no value of the setting " + name), wrong);
    }
    QVERIFY(says("rows.nc", "feed_from=tcp:4002", "feed_from needs the bounds of the factor"));
    QVERIFY(says("rows.nc", "feed_factor_least=0.2;feed_factor_most=1.2", "need a source"));
    QCOMPARE(refusal("rows.nc", "feed_from=tcp:4002;feed_factor_least=0.2;feed_factor_most=0.9"),
             "accepted");
    std::string why;
    QTRY_VERIFY2_WITH_TIMEOUT(
        (why = service->call("Preflight").message).find("choose bounds from") != std::string::npos,
        why.c_str(), tests::kSoonMs);
    QVERIFY(says("rows.nc", "fast", "Settings are written as name=value"));
  }

  /// What a client may load is named; what leads out of the folder, or is hidden, is not.
  void namesItsPrograms() {
    const QTemporaryDir folder;
    const auto write = [&folder](const char* name) {
      QFile file(folder.filePath(QString::fromUtf8(name)));
      QVERIFY(file.open(QIODevice::WriteOnly));
    };
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("parts/.kept")));
    for (const char* name : {"b.mpf", "parts/a.mpf", ".hidden", "parts/.kept/c.mpf"}) {
      write(name);
    }
    QVERIFY(QFile::link(QStringLiteral("/etc/passwd"), folder.filePath(QStringLiteral("link"))));
    QVERIFY(QFile::link(QStringLiteral("/etc"), folder.filePath(QStringLiteral("way"))));
    QStringList names = QString::fromStdString(service::filesIn(folder.path().toStdString()))
                            .split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    names.sort();
    QCOMPARE(names, (QStringList{QStringLiteral("b.mpf"), QStringLiteral("parts/a.mpf")}));
    QCOMPARE(service::filesIn("/none"), std::string());
  }

  /// Without --jobs clients reach a folder of its own, for this user only, and nothing outside it.
  void readsOnlyItsOwnFolder() {
    ServiceProcess service(QStringLiteral(RIVULET_SERVICE), m_scene.endpoint(),
                           m_scene.environment());
    QVERIFY(service.await("Monitoring/IsConnected", "true"));
    const QFileInfo jobs(m_scene.path("data/rivulet/jobs"));
    QVERIFY(jobs.isDir());
    QCOMPARE(jobs.permissions() & (QFile::ReadGroup | QFile::ExeGroup | QFile::WriteGroup |
                                   QFile::ReadOther | QFile::ExeOther | QFile::WriteOther),
             QFile::Permissions());
    const auto refusal = [&](const std::string& name) {
      return service.call("LoadJob", {name, kSettings}).message;
    };
    const std::string outside = file();
    const QDir folder(jobs.filePath());
    QVERIFY(QFile::link(m_scene.programFile(), folder.filePath(QStringLiteral("link.nc"))));
    QVERIFY(QFile::link(m_scene.path(""), folder.filePath(QStringLiteral("below"))));
    // The same sentence whether there is such a file or not.
    for (const std::string& name : {outside, std::string("/none/such.nc"), std::string("link.nc"),
                                    std::string("below/rows.nc"), std::string("/etc/shadow")}) {
      const std::string said = refusal(name);
      QVERIFY2(said.find(": Only files in the folder of jobs can be loaded.") != std::string::npos,
               said.c_str());
    }
    // Nor by a subprogram that is a link.
    QVERIFY(QFile::copy(m_scene.programFile(), folder.filePath(QStringLiteral("rows.nc"))));
    const std::string said = refusal("rows.nc");
    QVERIFY2(said.find("This link leads out of the folder of jobs.") != std::string::npos,
             said.c_str());
    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("link.nc"))));
    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("below"))));
    const service::Answer loaded = service.call("LoadJob", {"rows.nc", kSettings});
    QVERIFY2(loaded.accepted, loaded.message.c_str());
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
    QVERIFY(service->awaitPoints(10));
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
    QVERIFY(service->awaitPoints(6));
    follower.kill();
    QVERIFY(follower.waitForFinished());
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
  }

  void waitsForAMachineThatIsGone() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(start(*service));
    QVERIFY(service->awaitPoints(10));
    m_scene.switchOff();
    QVERIFY(service->await("Monitoring/State", "disconnected"));
    QVERIFY(!service->value("Notification/Alarm").empty());
    QCOMPARE(service->value("Session/LastOutcome"), "failed");
    m_scene.switchOn();
    QVERIFY(resume(*service));
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QVERIFY(m_scene.isWhole(before));
  }

  /// Name and PIN over the network, encrypted; as the board of the window does it.
  void takesOrdersFromWhoHasLoggedIn() {
    const QString users = m_scene.path("users.json");
    tests::writeUsers(users, {{"anna", permission::Role::Engineer, "4711"},
                              {"otto", permission::Role::Operator, "1234"}});
    const auto service = this->service({QStringLiteral("--users"), users});
    service::ServiceWatch watch(service->endpoint().toStdString(), [] {});
    using State = service::ServiceSeen::State;
    const auto isConnectedAs = [&](const std::string& user) {
      const service::ServiceSeen seen = watch.seen();
      return seen.state == State::Connected && seen.user == user && seen.snapshot.isConnected;
    };
    const auto answerOf = [&](const std::string& method, const std::vector<std::string>& inputs) {
      watch.call(method, inputs);
      std::optional<service::ServiceAnswer> answer;
      (void)QTest::qWaitFor([&] { return (answer = watch.takeAnswer()).has_value(); },
                            tests::kSoonMs);
      return answer ? answer->answer : service::Answer{};
    };
    QTRY_VERIFY_WITH_TIMEOUT(isConnectedAs(""), tests::kSoonMs);
    QVERIFY(answerOf("LoadJob", {file(), ""}).message.starts_with("This service has users"));
    {
      // Who has not logged in sees the state, and neither programs nor files.
      const service::Snapshot seen = watch.seen().snapshot;
      QVERIFY(!seen.state.empty() && !seen.machine.empty());
      for (const service::VariableRow& row : service::variableRows()) {
        const bool isHidden = row.readers == service::Readers::LoggedIn;
        QCOMPARE(service->value(std::string(row.identifier)) == service::kHidden, isHidden);
      }
    }
    watch.connectWith({"otto", "1234", {}, {}, false});
    QTRY_VERIFY_WITH_TIMEOUT(watch.seen().state == State::Asked, tests::kSoonMs);
    const auto question = watch.seen().question;
    QVERIFY(question && question->kind == opcua::TrustQuestion::Kind::NewServer);
    watch.connectWith({{}, {}, question->shown.fingerprint, {}, true});
    QTRY_VERIFY_WITH_TIMEOUT(isConnectedAs("otto"), tests::kSoonMs);
    QCOMPARE(answerOf("LoadJob", {file(), kSettings}).message,
             std::string("Only an engineer may do this. Log in as one."));
    watch.connectWith({"anna", "4711", {}, {}, false});
    QTRY_VERIFY_WITH_TIMEOUT(isConnectedAs("anna"), tests::kSoonMs);
    QVERIFY(answerOf("LoadJob", {file(), kSettings}).accepted);
    QVERIFY(!answerOf("Preflight", {}).confirmation.empty());
    QTRY_COMPARE_WITH_TIMEOUT(watch.seen().snapshot.program, std::string("rows.nc"),
                              tests::kSoonMs);
    QCOMPARE(service->value("Production/ActiveProgram/Name"), std::string(service::kHidden));
    watch.connectWith({"anna", "1234", {}, {}, false});
    QTRY_VERIFY_WITH_TIMEOUT(
        watch.seen().error.code == opcua::LinkError::LoginRefused && isConnectedAs(""),
        tests::kSoonMs);
    QVERIFY(!answerOf("Preflight", {}).accepted);
    // The trail names who has logged in, and who has failed to.
    const auto trail =
        journal::readAudit(journal::auditFileIn(m_scene.path("state/rivulet").toStdString()));
    QVERIFY(trail);
    const auto isNamed = [&](const char* act, const std::string& who) {
      return std::any_of(trail->lines.begin(), trail->lines.end(), [&](const auto& line) {
        return line.entry.act == act && line.entry.who == who;
      });
    };
    QVERIFY(isNamed("log-in", "otto") && isNamed("log-in", "anna"));
    QVERIFY(isNamed("log-in-failed", "anna"));
    QVERIFY(!isNamed("log-in-failed", "otto"));
  }

  void isFoundThroughADiscoveryServer() {
    const tests::PlainServer discovery({}, {}, {}, {}, {},
                                       tests::PlainServer::Kind::DiscoveryServer);
    const auto isFound = [&discovery](const std::string& endpoint) {
      const auto servers = opcua::findServers(discovery.endpoint(), std::chrono::seconds(5));
      return servers && std::any_of(servers->begin(), servers->end(), [&](const auto& server) {
               return server.productUri == service::kNamespaceUri && !server.addresses.empty() &&
                      server.addresses.front() == endpoint;
             });
    };
    const auto service = this->service(
        {QStringLiteral("--discovery"), QString::fromStdString(discovery.endpoint())});
    const std::string endpoint = service->endpoint().toStdString();
    QTRY_VERIFY_WITH_TIMEOUT(isFound(endpoint), tests::kSoonMs);
    QCOMPARE(service->end(SIGTERM), 0);
    QTRY_VERIFY_WITH_TIMEOUT(!isFound(endpoint), tests::kSoonMs);
  }

  /// The tools of a virtual machine are known: a pocket of plain text gets their radius.
  void knowsTheToolsOfTheMachine() {
    m_scene.switchOff();
    tests::KillScene mill{QStringLiteral(RIVULET_MACHINE), QStringLiteral("dmu75-mill")};
    mill.switchOn();
    QFile pocket(mill.path("pocket.h"));
    QVERIFY(pocket.open(QIODevice::WriteOnly));
    pocket.write(
        "BEGIN PGM POCKET MM\nTOOL CALL 3 Z S1000 F500\nL X+0 Y+0 Z+50 R0 FMAX M3\n"
        "CYCL DEF 252 CIRCULAR POCKET Q215=+0 Q223=+60 Q368=+0 Q207=+500 Q351=+1 Q201=-2 Q202=+2 "
        "Q369=+0 Q206=+150 Q338=+0 Q200=+2 Q203=+0 Q204=+50 Q370=+1 Q366=+0 Q385=+500\n"
        "CYCL CALL POS X+0 Y+0 Z+0 FMAX\nEND PGM POCKET MM\n");
    pocket.close();
    {
      ServiceProcess service(QStringLiteral(RIVULET_SERVICE), mill.endpoint(), mill.environment(),
                             {QStringLiteral("--jobs"), mill.path("")});
      QVERIFY(service.await("Monitoring/IsConnected", "true"));
      const service::Answer loaded = service.call("LoadJob", {"pocket.h", ""});
      QVERIFY2(loaded.accepted, loaded.message.c_str());
    }
    mill.switchOff();
    m_scene.switchOn();
  }

  /// Two stretches, and between them what only the control can do; each is a program on it.
  void runsAWholeJob() {
    QFile job(m_scene.path("part.mpf"));
    QVERIFY(job.open(QIODevice::WriteOnly));
    job.write(
        "G17 G90 G71\nT1 D1 M6\nG0 X0 Y0 Z45\nG1 Z44 F3000\nX10\nY10\nS500 M3\nG4 F0.5\n"
        "G1 X20 F3000\nX30 Y0\nM5\nM30\n");
    job.close();
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service({QStringLiteral("--jobs"), m_scene.path("")});
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    const service::Answer loaded = service->call("LoadJob", {"part.mpf", ""});
    QVERIFY2(loaded.accepted, loaded.message.c_str());
    QVERIFY2(loaded.message.find("a whole job") != std::string::npos, loaded.message.c_str());
    const std::string confirmation = service->confirmation("Preflight");
    QVERIFY2(!confirmation.empty(), service->refusal().c_str());
    const service::Answer started = service->call("Start", {confirmation});
    QVERIFY2(started.accepted, started.message.c_str());
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QCOMPARE(service->value("Notification/Alarm"), "");
    QCOMPARE(service->value("Production/ActiveProgram/PointsDone"),
             service->value("Production/ActiveProgram/Points"));
    const auto text = base::readFile(service->value("Session/LastReport"));
    QVERIFY(text);
    const auto report = nlohmann::json::parse(*text);
    const auto& judged = report.contains("report") ? report["report"] : report;
    QVERIFY(judged["judged"].get<bool>());
    for (const char* fault : {"repeated", "skipped", "foreign", "out_of_order"}) {
      QCOMPARE(judged[fault].get<int>(), 0);
    }
    std::vector<double> xMm;
    for (const trace::ExecutedBlock& block : m_scene.executed(before)) {
      xMm.push_back(block.targetMm.x);
    }
    QVERIFY(xMm.size() >= 6);
    QVERIFY(std::is_sorted(xMm.end() - 5, xMm.end()));
    QCOMPARE(xMm.back(), 30.0);
  }

  /// What the control does first is shown, and then nothing of the stretches before is done.
  void beginsAWholeJobWithAStretch() {
    const std::size_t before = m_scene.executed().size();
    const auto service = this->service();
    QVERIFY(service->await("Monitoring/IsConnected", "true"));
    QVERIFY(!service->call("PreflightStretch", {"1"}).accepted);  // nothing is loaded
    QVERIFY(service->call("LoadJob", {file(), kSettings}).accepted);
    QCOMPARE(service->call("PreflightStretch", {"1"}).message,
             "Only a whole job begins with a stretch. Call Preflight.");
    QFile job(m_scene.path("halves.mpf"));
    QVERIFY(job.open(QIODevice::WriteOnly));
    job.write(
        "G17 G90 G71\nT1 D1 M6\nG0 X0 Y0 Z45\nG1 Z44 F3000\nX10\nY10\nS500 M3\nG4 F0.5\n"
        "G1 X20 F3000\nX30 Y0\nM5\nM30\n");
    job.close();
    const service::Answer loaded = service->call("LoadJob", {"halves.mpf", ""});
    QVERIFY2(loaded.message.ends_with("a whole job of 2 stretches."), loaded.message.c_str());
    QCOMPARE(service->value("Production/ActiveProgram/Stretches"), "2");
    for (const char* wrong : {"0", "-1", "two", "", "1.5"}) {
      const std::string said = service->call("PreflightStretch", {wrong}).message;
      QVERIFY2(said.ends_with("is no stretch: choose 1 to 2."), said.c_str());
    }
    const auto preflight = [&](const std::string& stretch) {
      service::Answer answer;
      service->awaitThat([&](const ServiceProcess::Values&) {
        answer = service->call("PreflightStretch", {stretch});
        return !service::isNotYet(answer);
      });
      return answer;
    };
    QVERIFY(preflight("3").message.find("There is no stretch 3") != std::string::npos);
    const service::Answer shown = preflight("2");
    QVERIFY2(shown.accepted, shown.message.c_str());
    for (const char* part : {"with stretch 2 of 2. Before that the control does:", "M3", "M6"}) {
      QVERIFY2(shown.message.find(part) != std::string::npos, shown.message.c_str());
    }
    // What was shown last counts.
    const std::string whole = service->confirmation("Preflight");
    QVERIFY(!service->call("Start", {shown.confirmation}).accepted);
    const service::Answer again = preflight("2");
    QVERIFY(!service->call("Start", {whole}).accepted);
    QVERIFY(!service->call("ResumeRun", {again.confirmation}).accepted);
    const service::Answer started = service->call("Start", {again.confirmation});
    QVERIFY2(started.accepted, started.message.c_str());
    QVERIFY(service->await("Session/LastOutcome", "completed"));
    QCOMPARE(service->value("Notification/Alarm"), "");
    std::vector<base::Vec3> cut;
    for (const trace::ExecutedBlock& block : m_scene.executed(before)) {
      QVERIFY(block.targetMm != (base::Vec3{10.0, 0.0, 44.0}));  // of the first stretch
      cut.push_back(block.targetMm);
    }
    QVERIFY(cut.size() >= 2);
    QVERIFY(cut[cut.size() - 2] == (base::Vec3{20.0, 10.0, 44.0}));
    QVERIFY(cut.back() == (base::Vec3{30.0, 0.0, 44.0}));
  }

  /// The rules of the window: an operator starts what is released, with the released settings.
  void asksWhoMayStart() {
    const std::filesystem::path folder = m_scene.path("state/rivulet").toStdString();
    opcua::ConnectRequest request;
    request.endpoint = m_scene.endpoint().toStdString();
    service::ServiceSession session(
        {request, m_scene.path("").toStdString(), folder},
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
    // How the program is read belongs to what is released: in inch it is another path.
    QVERIFY(session.loadJob(engineer(), file(), std::string(kSettings) + ";units=in").accepted);
    const std::string inInch = session.snapshot().settings;
    QVERIFY(session.loadJob(engineer(), file(), kSettings).accepted);
    QVERIFY(session.preflight(engineer()).accepted);
    QCOMPARE(inInch, session.snapshot().settings + ";units=in");
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
    QCOMPARE(session.preflightStretch(operatorAt(), "1").message,
             "Only an engineer may do this. Log in as one.");
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
