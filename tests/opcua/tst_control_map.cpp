// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>

#include "base/file.h"
#include "opcua/control_map.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::opcua;

namespace {

const std::string kWhole = R"([cells]
node = "nsu=urn:cell;s=Cells.{}"
first = 10
last = 19
offset = 1000

[position]
x = "ns=2;i=5"
y = "/Cell/Axes/Y"
z = "nsu=urn:cell;s=Axes.Z"
c = "ns=2;i=6"
unit = "inch"

[feed]
path = "ns=2;s=Feed"
unit = "mm/s"

[channel]
status = "ns=2;s=Mode"
reset = ["idle", "ready"]
active = ["run"]
interrupted = [3]

[alarm]
number = "ns=2;s=Healthy"
none = [true]

[methods]
object = "ns=2;s=Files"
write = "ns=2;s=Files.Put"
main = "nc/{}"
)";

ControlMap parsed(const std::string& text) {
  auto map = parseControlMap(text, "cell.toml");
  return map ? *map : ControlMap();
}

QStringList gapKeys(const ControlMap& map) {
  QStringList keys;
  for (const MapGap& gap : gapsOf(map)) {
    keys << QString::fromStdString(std::string(gap.key));
  }
  return keys;
}

}  // namespace

class TestControlMap : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFileIsRead() {
    const ControlMap map = parsed(kWhole);
    QCOMPARE(cellAddress(map.cells, 12), std::string("nsu=urn:cell;s=Cells.1012"));
    QVERIFY(!map.cells.has(9));
    QVERIFY(!map.cells.has(20));
    QCOMPARE(map.nodes.at({VariableKind::ActualPosition, 1}), std::string("/Cell/Axes/Y"));
    QCOMPARE(mappedProgramPath(map.methods, "A.MPF"), std::string("nc/A.MPF"));
    QCOMPARE(mappedProgramPath(map.methods, "A.SPF"), std::string("A.SPF"));
    QVERIFY(blockAddress(map.cells, {10, 2, Grouping::ArrayCount}).empty());
  }

  void aWrittenMapIsReadAsTheSame() {
    const ControlMap map = parsed(kWhole);
    QVERIFY(parseControlMap(controlMapText(map), "written") == map);
    ControlMap odd = map;
    odd.nodes[{VariableKind::Message, 0}] = "ns=2;s=with \"quotes\", \\ and \n a new line";
    QVERIFY(parseControlMap(controlMapText(odd), "written") == odd);
  }

  /// The names of a SINUMERIK are a map like any other.
  void aSinumerikIsAMap() {
    const ControlMap map = sinumerikMap(999, 6);
    QVERIFY(parseControlMap(controlMapText(map), "written") == map);
    const std::string uri = "nsu=SinumerikVarProvider;s=";
    for (int number : {0, 7, 11, 999}) {
      QCOMPARE(cellAddress(map.cells, number), uri + nodeIdentifier(rParameter(number)));
    }
    for (const ParameterArray& block :
         {ParameterArray{10, 5, Grouping::ArrayCount}, ParameterArray{10, 5, Grouping::ArrayRange},
          ParameterArray{0, 1000, Grouping::ArrayCount}}) {
      QCOMPARE(blockAddress(map.cells, block), uri + arrayIdentifier(block));
    }
    for (const auto& [variable, address] : map.nodes) {
      QCOMPARE(address, uri + nodeIdentifier(variable));
    }
    QCOMPARE(mappedProgramPath(map.methods, "A.MPF"), programPath("A.MPF"));
    QCOMPARE(mappedProgramPath(map.methods, "A.SPF"), programPath("A.SPF"));
    QVERIFY(gapsOf(map).empty());
  }

  void cellsMayHaveNumericNodeIds() {
    const ControlMap map = parsed(
        "[cells]\nnode = \"ns=2;i={}\"\nfirst = 0\nlast = 9\noffset = 5000\n"
        "block_by_last = \"ns=3;i=1{first}0{last}\"\n");
    QCOMPARE(map.cells.last, 9);
    QCOMPARE(cellAddress(map.cells, 7), std::string("ns=2;i=5007"));
  }

  void valuesHaveTheMeaningOfTheMap() {
    const ControlMap map = parsed(kWhole);
    const Variable status{VariableKind::ChannelStatus, 0};
    QVERIFY(meaningOf(map, status, std::string("ready")) == 0.0);
    QVERIFY(meaningOf(map, status, std::string("run")) == 1.0);
    QVERIFY(meaningOf(map, status, 3.0) == 2.0);
    // What the map does not know is not assumed.
    QVERIFY(!meaningOf(map, status, 0.0));
    QVERIFY(!meaningOf(map, status, std::string("Idle")));
    QVERIFY(!meaningOf(map, {VariableKind::ProgramStatus, 0}, std::string("run")));
    QVERIFY(meaningOf(map, {VariableKind::ProgramStatus, 0}, 3.0) == 3.0);
    // Whatever does not say that there is no alarm is one.
    const Variable alarm{VariableKind::Alarm, 0};
    QVERIFY(meaningOf(map, alarm, 1.0) == 0.0);
    QVERIFY(meaningOf(map, alarm, 0.0) == 1.0);
    QVERIFY(meaningOf(map, alarm, std::string("door")) == 1.0);
    QVERIFY(meaningOf(map, alarm, 700.0) == 700.0);
    // Lengths have units, angles are degrees.
    QVERIFY(meaningOf(map, {VariableKind::ActualPosition, 0}, 2.0) == 50.8);
    QVERIFY(meaningOf(map, {VariableKind::ActualPosition, 5}, 2.0) == 2.0);
    QVERIFY(meaningOf(map, {VariableKind::PathFeed, 0}, 2.0) == 120.0);
    QVERIFY(meaningOf(map, {VariableKind::DistanceToGo, 0}, 2.0) == 2.0);
  }

  void axesHaveTheLettersOfTheMap() {
    const ControlMap map = parsed(kWhole);
    QVERIFY(axisLetterOf(map, {VariableKind::AxisName, 5}) == std::string("C"));
    QVERIFY(!axisLetterOf(map, {VariableKind::AxisName, 3}));
    QVERIFY(!axisLetterOf(map, {VariableKind::ActualPosition, 5}));
  }

  void aMapSaysWhatItLacks() {
    QCOMPARE(gapKeys(parsed(kWhole)),
             QStringList({QStringLiteral("distance_to_go.x"), QStringLiteral("program.name"),
                          QStringLiteral("methods")}));
    ControlMap map = parsed(kWhole);
    map.cells = {};
    map.nodes.erase({VariableKind::ChannelStatus, 0});
    map.nodes.erase({VariableKind::ActualPosition, 2});
    const std::vector<MapGap> gaps = gapsOf(map);
    const auto stopping =
        std::count_if(gaps.begin(), gaps.end(), [](const MapGap& gap) { return gap.stopsRuns; });
    QCOMPARE(stopping, 3);
    QVERIFY(gapKeys(map).contains(QStringLiteral("channel.status")));
  }

  void wrongFilesAreRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("place");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* text, const char* place, const char* says) {
      QTest::newRow(says) << QByteArray(text) << QByteArray(place) << QByteArray(says);
    };
    const char* const kCells = "[cells]\nnode = \"ns=2;s=R{}\"\nfirst = 0\n";
    const auto cells = [&](const char* more, const char* place, const char* says) {
      QTest::newRow(says) << QByteArray(kCells) + more << QByteArray(place) << QByteArray(says);
    };
    row("", "cell.toml", "The map is empty");
    row("[cells\n", "line 1", "This is no TOML");
    row("[axes]\n", "line 1", "axes is not known here");
    row("position = 3\n", "line 1", "position must be a section: [position]");
    row("[position]\nw = \"ns=2;s=X\"\n", "line 2", "w is not known in [position]");
    row("[position]\nx = 3\n", "line 2", "x must be a text in quotes");
    row("[position]\nx = \"X1\"\n", "line 2", "x is no node");
    row("[position]\nx = \"ns=2;X1\"\n", "line 2", "nsu=urn:cell;i=5 or /Cell/Axes/X, not ns=2;X1");
    row("[position]\nx = \"ns=a;s=X\"\n", "line 2", "not ns=a;s=X");
    row("[position]\nx = \"ns=2;i=X\"\n", "line 2", "not ns=2;i=X");
    row("[position]\nx = \"/Cell//X\"\n", "line 2", "not /Cell//X");
    row("[position]\nx = \"ns=2;s=X\"\nunit = \"ell\"\n", "line 3",
        "unit of [position] must be one of mm, um, m, inch");
    row("[channel]\nunit = \"mm\"\n", "line 2", "unit is not known in [channel]");
    row("[channel]\nreset = 0\n", "line 2", "reset must be a list of values");
    row("[channel]\nreset = []\n", "line 2", "like [0] or [\"idle\"]");
    row("[channel]\nreset = [0.5]\n", "line 2", "A value of reset must be a whole number");
    row("[channel]\nreset = [0]\nactive = [1, 0]\n", "line", "is in [channel] twice");
    row("[channel]\nreset = [0]\n", "line 1", "[channel] must say which values mean active");
    row("[channel]\nstatus = \"ns=2;s=M\"\n", "line 1", "which values mean reset");
    row("[cells]\nfirst = 0\nlast = 9\n", "line 1", "[cells] must have node or array");
    row("[cells]\nnode = \"ns=2;s=R\"\n", "line 2", "node must contain {}");
    row("[cells]\nnode = \"ns=2;s=R{}\"\narray = \"ns=2;s=R\"\n", "line", "not both");
    cells("", "line 1", "[cells] must have first and last");
    cells("last = 10000\n", "line 1", "at most 10000 cells");
    cells("last = 9.5\n", "line 4", "last must be a whole number from 0");
    cells("last = 9\noffset = -1\n", "line 1", "offset of [cells] makes the first number negative");
    cells("last = 9\ncount = 3\n", "line 5", "count is not known in [cells]");
    cells("last = 9\nblock_by_count = \"ns=2;s=R{first}\"\n", "line 5", "must contain {count}");
    cells("last = 9\nblock_by_last = \"/R{first}{last}\"\n", "line 1", "must be node ids");
    row("[cells]\narray = \"ns=2;s=R\"\nfirst = 0\nlast = 9\n"
        "block_by_last = \"ns=2;s=R{first}{last}\"\n",
        "line 1", "needs no blocks");
    row("[methods]\nwrite = \"ns=2;s=W\"\n", "line 1", "[methods] must have object");
    row("[methods]\nmain = \"nc\"\n", "line 2", "main must contain {}");
  }

  void wrongFilesAreRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, place);
    QFETCH(QByteArray, says);
    const auto map = parseControlMap(text.toStdString(), "cell.toml");
    QVERIFY(!map);
    QCOMPARE(map.error().code, make_error_code(MapError::BadFile));
    const std::string said = map.error().text();
    QVERIFY2(said.starts_with("cell.toml"), said.c_str());
    QVERIFY2(QByteArray::fromStdString(map.error().context).contains(place), said.c_str());
    QVERIFY2(QByteArray::fromStdString(said).contains(says), said.c_str());
  }

  void aFileThatIsMissingIsAnError() {
    const auto map = readControlMap("/nowhere/cell.toml");
    QVERIFY(!map);
    QCOMPARE(map.error().code, base::make_error_code(base::FileError::Unreadable));
  }

  void pathsHaveSteps() {
    const auto steps = browseSteps("/Cell 1/2:Axes/A&/B/3&:C");
    QCOMPARE(steps.size(), std::size_t{4});
    QCOMPARE(steps[0].name, std::string("Cell 1"));
    QVERIFY(!steps[0].nameSpace);
    QCOMPARE(steps[1].name, std::string("Axes"));
    QVERIFY(steps[1].nameSpace == 2);
    QCOMPARE(steps[2].name, std::string("A/B"));
    QCOMPARE(steps[3].name, std::string("3:C"));
    QCOMPARE(browseSteps("/" + escapedStep("3:C/&"))[0].name, std::string("3:C/&"));
    QVERIFY(browseSteps("Cell").empty());
    QVERIFY(browseSteps("/").empty());
  }
};

RIVULET_TEST(TestControlMap)
#include "tst_control_map.moc"
