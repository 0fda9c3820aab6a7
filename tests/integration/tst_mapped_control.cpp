// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Controls whose variables have other names than a SINUMERIK's: the link by a map, and the command
/// line against `rivulet-machine` as if its names were those of anybody.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "opcua/await.h"
#include "opcua/control_map.h"
#include "opcua/open62541/ua_link.h"
#include "streaming/recovery/run_on_control.h"
#include "support/arc_program.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/plain_server.h"
#include "support/private_folders.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::opcua;
using namespace std::chrono_literals;
using nlohmann::json;

namespace {

using rivulet::base::Instant;
using rivulet::tests::kRunMs;
constexpr int kPoints = 20;
constexpr auto kDeadline = 10s;

base::Result<std::unique_ptr<UaLink>> connectTo(const tests::PlainServer& server,
                                                const std::string& mapText) {
  const auto map = parseControlMap(mapText, "test.toml");
  RIVULET_ASSERT(map.has_value());
  ConnectOptions options;
  options.endpoint = server.endpoint();
  options.security = unencrypted();
  options.connectDeadline = 20s;
  options.map = std::make_shared<const ControlMap>(*map);
  return UaLink::connect(options);
}

/// The names of `rivulet-machine` with its usual preset, which does not show its equipment.
ControlMap machineMap() {
  ControlMap map = sinumerikMap(99, 3);
  std::erase_if(map.nodes,
                [](const auto& node) { return node.first.kind >= VariableKind::ToolNumber; });
  return map;
}

struct Outcome {
  int exit = -1;
  json result;
  QByteArray errors;
};

}  // namespace

class TestMappedControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { write("arc.mpf", tests::arcProgram(kPoints)); }

  // --- the link ---------------------------------------------------------------------------------

  void statesAndUnitsAreThoseOfTheMap() {
    const tests::PlainServer server({{"X", 2.0}, {"Speed", 10.0}, {"Fault", 0.0}},
                                    {{"Mode", "ready"}, {"Program", "A.MPF"}});
    auto link = connectTo(server, R"([position]
x = "/X"
unit = "inch"
[feed]
path = "ns=1;s=Speed"
unit = "mm/s"
[channel]
status = "ns=1;s=Mode"
reset = ["ready"]
active = ["busy"]
[alarm]
number = "ns=1;s=Fault"
[program]
name = "/Program"
)");
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const std::array<Variable, 6> asked{{{VariableKind::ActualPosition, 0},
                                         {VariableKind::PathFeed, 0},
                                         {VariableKind::ChannelStatus, 0},
                                         {VariableKind::Alarm, 0},
                                         {VariableKind::ActualPosition, 1},
                                         {VariableKind::ProgramName, 0}}};
    const auto readings = readNow(**link, asked, kDeadline);
    QVERIFY(readings.has_value());
    QCOMPARE((*readings)[0].number, 50.8);
    QCOMPARE((*readings)[1].number, 600.0);
    QCOMPARE((*readings)[2].number, 0.0);
    QVERIFY(!(*readings)[2].status);
    QCOMPARE((*readings)[3].number, 0.0);
    QCOMPARE((*readings)[4].status, make_error_code(LinkError::VariableMissing));
    QCOMPARE((*readings)[5].text, std::string("A.MPF"));
    // No method of a map resets it: its keys do.
    const auto refused = streaming::stopByReset(**link, **link, [] { return false; });
    QVERIFY(!refused && refused.error().code == LinkError::MethodMissing);
    QVERIFY2(refused.error().message.find("Press NC STOP") != std::string::npos,
             refused.error().text().c_str());
  }

  /// The connection is there, and the network is not to blame.
  void anEndedSessionIsSaidSo() {
    std::atomic<bool> closes{false};
    const tests::PlainServer server({{"X", 2.0}}, {}, [&closes](tests::PlainServer& own) {
      if (closes.exchange(false)) {
        own.closeSessions();
      }
    });
    auto link = connectTo(server, "[position]\nx = \"/X\"\n");
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const std::array<Variable, 1> asked{{{VariableKind::ActualPosition, 0}}};
    QVERIFY(readNow(**link, asked, kDeadline).has_value());
    closes = true;
    const Instant limit = (*link)->now() + kDeadline;
    auto readings = readNow(**link, asked, kDeadline);
    while (readings && (*link)->now() < limit) {
      readings = readNow(**link, asked, kDeadline);
    }
    QVERIFY(!readings);
    QCOMPARE(readings.error().code, make_error_code(LinkError::ConnectionLost));
    for (int again = 0; again < 2; ++again) {
      const std::string said = readings.error().text();
      QVERIFY2(said.find("The server has ended the session") != std::string::npos, said.c_str());
      QVERIFY2(said.find("Check network") == std::string::npos, said.c_str());
      readings = readNow(**link, asked, kDeadline);
      QVERIFY(!readings);
    }
  }

  void aStateThatTheMapDoesNotKnowCannotBeRead() {
    const tests::PlainServer server({}, {{"Mode", "homing"}});
    auto link = connectTo(
        server, "[channel]\nstatus = \"/Mode\"\nreset = [\"ready\"]\nactive = [\"busy\"]\n");
    QVERIFY(link.has_value());
    const std::array<Variable, 1> status{{{VariableKind::ChannelStatus, 0}}};
    const auto readings = readNow(**link, status, kDeadline);
    QVERIFY(readings.has_value());
    QCOMPARE(readings->front().status, make_error_code(LinkError::BadValue));
  }

  void cellsMayBeElementsOfAnArray() {
    const tests::PlainServer server({}, {}, {}, {{"Cells", {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}}});
    auto link =
        connectTo(server, "[cells]\narray = \"/Cells\"\nfirst = 101\nlast = 105\noffset = -100\n");
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const std::array<Variable, 5> cells{
        {rParameter(101), rParameter(102), rParameter(103), rParameter(104), rParameter(105)}};
    for (const Grouping form :
         {Grouping::List, Grouping::Single, Grouping::ArrayCount, Grouping::ArrayRange}) {
      std::vector<Assignment> values;
      const double base = 100.0 * (static_cast<int>(form) + 1);
      for (std::size_t i = 1; i < 4; ++i) {
        values.push_back({cells[i], base + static_cast<double>(i)});
      }
      const auto written = awaitAnswer(**link, (*link)->write(values, kDeadline, form), kDeadline);
      QVERIFY(written.has_value());
      QVERIFY(!written->statuses[0] && !written->statuses[2]);
      const auto read = awaitAnswer(**link, (*link)->read(cells, kDeadline, form), kDeadline);
      QVERIFY(read.has_value());
      QCOMPARE(read->readings.size(), cells.size());
      QCOMPARE(read->readings[0].number, 1.0);
      QCOMPARE(read->readings[1].number, base + 1.0);
      QCOMPARE(read->readings[3].number, base + 3.0);
      QCOMPARE(read->readings[4].number, 5.0);
    }
    const std::array<Variable, 1> outside{{rParameter(106)}};
    const auto refused = readNow(**link, outside, kDeadline);
    QVERIFY(refused.has_value());
    QCOMPARE(refused->front().status, make_error_code(LinkError::VariableMissing));
    const std::array<Assignment, 1> assignment{{{rParameter(106), 1.0}}};
    QVERIFY(!writeNow(**link, assignment, kDeadline));
  }

  void cellsMayBeFloats_data() {
    QTest::addColumn<QByteArray>("cells");
    QTest::newRow("nodes") << QByteArray("node = \"ns=1;s=F{}\"\n");
    QTest::newRow("an array") << QByteArray("array = \"ns=1;s=Floats\"\n");
  }
  void cellsMayBeFloats() {
    QFETCH(QByteArray, cells);
    const tests::PlainServer server(
        {}, {}, {}, {},
        {{"F0", {0.0F}}, {"F1", {0.0F}}, {"F2", {7.5F}}, {"Floats", {0.0F, 0.0F, 7.5F}}});
    const std::string map = "[cells]\n" + cells.toStdString() + "first = 0\nlast = 2\n";
    const auto refused = connectTo(server, map);
    QVERIFY(!refused);
    QVERIFY2(refused.error().text().find("resolution = 0.001") != std::string::npos,
             refused.error().text().c_str());

    auto link = connectTo(server, map + "resolution = 0.001\n");
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const std::array<Variable, 3> all{{rParameter(0), rParameter(1), rParameter(2)}};
    const auto write = [&](double first, double second, Grouping form) {
      const std::array<Assignment, 2> values{{{rParameter(0), first}, {rParameter(1), second}}};
      return awaitAnswer(**link, (*link)->write(values, kDeadline, form), kDeadline);
    };
    double meant = 122.4567;
    for (const Grouping form : {Grouping::List, Grouping::Single, Grouping::ArrayCount}) {
      if (opcua::isArray(form) && !cells.startsWith("array")) {
        continue;  // the map names no blocks of nodes
      }
      // None of these fractions is a Float: what is read back is what was meant.
      meant += 1.0;
      const auto written = write(meant, 16'777'216.0, form);
      QVERIFY2(written && written->kind == EventKind::WriteDone, "");
      QVERIFY(!written->statuses[0] && !written->statuses[1]);
      const auto read = awaitAnswer(**link, (*link)->read(all, kDeadline, form), kDeadline);
      QVERIFY(read.has_value());
      QCOMPARE(read->readings[0].number, meant);
      QCOMPARE(read->readings[1].number, 16'777'216.0);
      QCOMPARE(read->readings[2].number, 7.5);
    }
    // Another client does not know what was meant: it sees the Float, which is near enough.
    auto other = connectTo(server, map + "resolution = 0.001\n");
    QVERIFY(other.has_value());
    const auto seen = readNow(**other, all, kDeadline);
    QVERIFY(seen.has_value());
    QVERIFY(seen->front().number != meant);
    QVERIFY(std::abs(seen->front().number - meant) <= 0.0005);

    // Off by 0.01, and off by 1.
    for (const auto& [first, second] : {std::pair(123'456.77, 1.0), {1.0, 16'777'217.0}}) {
      const auto answer = write(first, second, Grouping::List);
      QVERIFY(!answer);
      QCOMPARE(answer.error().code, make_error_code(LinkError::BadValue));
      QVERIFY2(answer.error().text().find("of type Float") != std::string::npos,
               answer.error().text().c_str());
    }
    const auto kept = readNow(**other, all, kDeadline);
    QVERIFY(kept.has_value());
    QCOMPARE(kept->front().number, seen->front().number);  // nothing of them was sent
  }

  void wrongAddressesAreSaidWhenConnecting_data() {
    QTest::addColumn<QByteArray>("map");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* map, const char* says) {
      QTest::newRow(says) << QByteArray(map) << QByteArray(says);
    };
    row("[position]\nx = \"ns=1;s=Y\"\n", "position.x of the map: the server has no variable");
    row("[feed]\npath = \"nsu=urn:nobody;s=X\"\n", "namespace that the server does not have");
    row("[alarm]\nnumber = \"/Panel/Alarm\"\n", "ends at Panel: there is no such node");
    row("[cells]\nnode = \"ns=1;s=C{}\"\nfirst = 1\nlast = 3\n", "no variable ns=1;s=C3");
    row("[cells]\nnode = \"ns=1;s=T{}\"\nfirst = 1\nlast = 1\n", "R1 is ns=1;s=T1, which is no");
    row("[cells]\narray = \"ns=1;s=A\"\nfirst = 0\nlast = 3\n", "no array of Double with this");
    row("[methods]\nobject = \"/Files\"\nwrite = \"/Files/Put\"\n", "methods.object of the map");
  }
  void wrongAddressesAreSaidWhenConnecting() {
    QFETCH(QByteArray, map);
    QFETCH(QByteArray, says);
    const tests::PlainServer server({{"X", 0.0}, {"C1", 0.0}, {"C2", 0.0}}, {{"T1", "text"}}, {},
                                    {{"A", {0.0, 0.0, 0.0}}});
    const auto link = connectTo(server, map.toStdString());
    QVERIFY(!link.has_value());
    QCOMPARE(link.error().code, make_error_code(MapError::WrongAddress));
    const std::string said = link.error().text();
    QVERIFY2(QByteArray::fromStdString(said).contains(says), said.c_str());
  }

  void aServerIsBrowsedAndExamined() {
    const tests::PlainServer server({{"X", 2.5}}, {{"Mode", "ready"}}, {}, {{"Cells", {1.0, 2.0}}});
    auto link = connectTo(server, "[position]\nx = \"/X\"\n");
    QVERIFY(link.has_value());
    const auto nodes = (*link)->children(kObjectsFolder);
    QVERIFY(nodes.has_value());
    std::vector<std::string> addresses;
    for (const BrowsedNode& node : *nodes) {
      if (node.name == "X" || node.name == "Mode" || node.name == "Cells") {
        QCOMPARE(node.kind, NodeKind::Variable);
        addresses.push_back(node.address);
      }
    }
    QCOMPARE(addresses.size(), std::size_t{3});
    addresses.emplace_back("ns=1;s=Nowhere");
    const auto facts = (*link)->examine(addresses);
    QVERIFY(facts.has_value());
    QCOMPARE(facts->back().status, make_error_code(LinkError::VariableMissing));
    for (const NodeFacts& one : *facts) {
      if (one.value == "2.5") {
        QVERIFY(one.isNumber && !one.isArray && one.mayWrite && one.mayRead);
        QCOMPARE(one.type, std::string("Double"));
      } else if (one.isArray) {
        QCOMPARE(one.length, std::size_t{2});
        QCOMPARE(one.value, std::string("1, 2"));
      } else if (!one.status) {
        QVERIFY(one.isText);
        QCOMPARE(one.value, std::string("ready"));
      }
    }
    QVERIFY(!(*link)->children("ns=1;s=Nowhere").has_value());
  }

  // --- the programs as their users start them ---------------------------------------------------

  void everyPointIsExecutedOnceThroughAMap() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM));
    ControlMap map = machineMap();
    // One by its path: "Sinumerik" is an object of this server.
    map.nodes[{VariableKind::ChannelStatus, 0}] = "/Sinumerik/Channel/State/chanStatus";
    write("own.toml", QByteArray::fromStdString(controlMapText(map)));
    const Outcome run = stream(machine, "own.toml");
    QVERIFY2(run.exit == 0, run.result.dump().c_str());
    QCOMPARE(run.result["executed"].get<int>(), kPoints);
    QVERIFY(run.result["judged"].get<bool>());
    for (const char* wrong : {"repeated", "skipped", "foreign", "out_of_order"}) {
      QCOMPARE(run.result[wrong].get<int>(), 0);
    }
  }

  void whatIsNotMappedIsNotAssumed_data() {
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no channel status")
        << QByteArray("status") << QByteArray("has no channel.status");
    QTest::newRow("no alarm") << QByteArray("alarm") << QByteArray("has no alarm.number");
    QTest::newRow("unknown state")
        << QByteArray("unknown") << QByteArray("cannot be read (channel.status)");
  }
  void whatIsNotMappedIsNotAssumed() {
    QFETCH(QByteArray, what);
    QFETCH(QByteArray, says);
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM));
    ControlMap map = machineMap();
    if (what == "status") {
      map.nodes.erase({VariableKind::ChannelStatus, 0});
    } else if (what == "alarm") {
      map.nodes.erase({VariableKind::Alarm, 0});
    } else {
      map.states[VariableKind::ChannelStatus] = {{7.0, kChannelReset}, {1.0, 1}};
    }
    write("poor.toml", QByteArray::fromStdString(controlMapText(map)));
    const Outcome run = stream(machine, "poor.toml");
    QVERIFY(run.exit != 0);
    QVERIFY(run.result.contains("error") || run.result.value("executed", 0) == 0);
    const QByteArray said = run.errors + QByteArray::fromStdString(run.result.dump());
    QVERIFY2(said.contains(says), said.constData());
    QVERIFY2(!said.contains("opcua map"), said.constData());  // the map itself is right
  }

  /// The program is the operator's business: the map names no methods.
  void withoutMethodsTheProgramIsCopiedByHand() {
    ControlMap map = machineMap();
    map.methods = {};
    write("bare.toml", QByteArray::fromStdString(controlMapText(map)));
    {
      const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM));
      const Outcome refused = stream(machine, "bare.toml");
      QVERIFY(refused.exit != 0);
      const std::string said = refused.result["error"]["message"].get<std::string>();
      QVERIFY2(said.find("by hand") != std::string::npos, said.c_str());
      QVERIFY(refused.errors.contains("has no methods"));
    }
    const QStringList byHand{QStringLiteral("--transfer"), QStringLiteral("by-hand"),
                             QStringLiteral("--program-file"),
                             QStringLiteral("RIVULET_WINDOW_7X2.MPF")};
    {
      const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM));
      QVERIFY(stream(machine, "bare.toml", byHand).exit != 0);  // it is not there yet
    }
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE_PROGRAM),
        {QStringLiteral("--program"), m_folder.filePath(QStringLiteral("RIVULET_WINDOW_7X2.MPF"))});
    const Outcome run = stream(machine, "bare.toml", byHand);
    QVERIFY2(run.exit == 0, run.result.dump().c_str());
    QCOMPARE(run.result["executed"].get<int>(), kPoints);
    QVERIFY(run.result["judged"].get<bool>());
  }

  void calibrationAndRightsTakeTheMap() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM));
    ControlMap map = machineMap();
    map.cells.first = 60;
    write("cells.toml", QByteArray::fromStdString(controlMapText(map)));
    const QStringList where{QStringLiteral("--json"), QStringLiteral("--endpoint"),
                            machine.endpoint(), QStringLiteral("--map"),
                            m_folder.filePath(QStringLiteral("cells.toml"))};
    const Outcome rights = cli(QStringList{QStringLiteral("rights")} + where);
    QVERIFY2(rights.exit == 0, rights.result.dump().c_str());
    const QStringList calibrate{QStringLiteral("calibrate"), QStringLiteral("--first-cell"),
                                QStringLiteral("60"),        QStringLiteral("--last-cell"),
                                QStringLiteral("99"),        QStringLiteral("--shots"),
                                QStringLiteral("20")};
    const Outcome measured = cli(calibrate + where);
    QVERIFY2(measured.exit == 0, measured.result.dump().c_str());
    QVERIFY(measured.result.is_object() && !measured.result.contains("error"));
  }

  void aWrongMapEndsTheCommand() {
    write("wrong.toml", "[position]\nx = 3\n");
    const Outcome run = cli({QStringLiteral("rights"), QStringLiteral("--endpoint"),
                             QStringLiteral("opc.tcp://127.0.0.1:9"), QStringLiteral("--map"),
                             m_folder.filePath(QStringLiteral("wrong.toml"))});
    QCOMPARE(run.exit, 2);
    QVERIFY2(run.errors.contains("wrong.toml, line 2: x must be a text"), run.errors.constData());
  }

 private:
  void write(const char* name, const QByteArray& text) {
    QFile file(m_folder.filePath(QString::fromUtf8(name)));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  }
  [[nodiscard]] Outcome cli(const QStringList& arguments) const {
    QProcess process;
    process.setProcessEnvironment(tests::environmentIn(m_folder.path()));
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    Outcome outcome;
    if (process.waitForFinished(kRunMs) && process.exitStatus() == QProcess::NormalExit) {
      outcome.exit = process.exitCode();
    }
    outcome.result =
        json::parse(process.readAllStandardOutput().toStdString(), nullptr, /*exceptions=*/false);
    outcome.errors = process.readAllStandardError();
    return outcome;
  }
  [[nodiscard]] Outcome stream(const tests::MachineProcess& machine, const char* map,
                               const QStringList& more = {}) const {
    return cli(QStringList{QStringLiteral("stream"), QStringLiteral("arc.mpf"),
                           QStringLiteral("--motion-only"), QStringLiteral("--method"),
                           QStringLiteral("window"), QStringLiteral("--feed"),
                           QStringLiteral("300"), QStringLiteral("--json"),
                           QStringLiteral("--endpoint"), machine.endpoint(),
                           QStringLiteral("--map"), m_folder.filePath(QString::fromUtf8(map))} +
               more);
  }

  QTemporaryDir m_folder;
};

RIVULET_TEST(TestMappedControl)
#include "tst_mapped_control.moc"
