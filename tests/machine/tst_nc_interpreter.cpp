// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The language of the control, program by program: what the main run is given.

#include <QtTest>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "base/random.h"
#include "base/text.h"
#include "machine/interpreter.h"
#include "nc/syntax/programs.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::Alarm;
using machine::BlockEnd;
using machine::Interpreter;
using machine::PreparedMotion;

namespace {

struct Outcome {
  std::vector<PreparedMotion> motions;
  std::vector<std::string> messages;
  int stops = 0;
  int alarm = 0;
  std::string alarmText;
  bool ended = false;
  machine::RParameters parameters{100};

  /// "1,2,3 4,5,6"
  [[nodiscard]] std::string targets() const {
    std::string text;
    for (const PreparedMotion& motion : motions) {
      text += text.empty() ? "" : " ";
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        text += (axis > 0 ? "," : "") +
                base::formatNumber(std::round(motion.targetMm[axis] * 1e6) / 1e6);
      }
    }
    return text;
  }
};

Outcome runProgram(const std::string& text, const std::map<std::string, std::string>& library = {},
                   double feedMmPerS = 10.0) {
  Outcome outcome;
  machine::InterpreterOptions options;
  options.rapidMmPerS = 100.0;
  options.feedMmPerS = feedMmPerS;
  options.roundingMm = 0.01;
  options.library = [&library](const std::string& name) -> std::shared_ptr<const nc::Tree> {
    const auto found = library.find(name);
    return found == library.end() ? nullptr : nc::parseSinumerik(found->second);
  };
  Interpreter interpreter(nc::parseSinumerik(text), outcome.parameters, options);
  for (int block = 0; block < 20000; ++block) {
    const machine::Prepared prepared = interpreter.next();
    if (const auto* motion = std::get_if<PreparedMotion>(&prepared)) {
      outcome.motions.push_back(*motion);
    } else if (const auto* message = std::get_if<machine::PreparedMessage>(&prepared)) {
      outcome.messages.push_back(message->text);
    } else if (std::holds_alternative<machine::PreparedStopre>(prepared)) {
      ++outcome.stops;
      interpreter.refresh();
    } else if (const auto* alarm = std::get_if<Alarm>(&prepared)) {
      outcome.alarm = alarm->number;
      outcome.alarmText = alarm->text;
      break;
    } else if (std::holds_alternative<machine::PreparedEnd>(prepared)) {
      outcome.ended = true;
      break;
    }
  }
  return outcome;
}

std::string readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Columns X, Y, Z of the rows of a table that name a coordinate; empty cells keep their value.
std::vector<std::string> expectedTargets(const std::string& csv) {
  std::vector<std::string> rows;
  std::vector<int> columns(3, -1);
  std::array<std::string, 3> last{"0", "0", "0"};
  bool heading = true;
  std::string_view left = csv;
  while (!left.empty()) {
    const std::string_view line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(left.size(), line.size() + 1));
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        cells.emplace_back();
      } else if (c != '\r') {
        cells.back() += c;
      }
    }
    if (heading) {
      heading = false;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (cells[i] == std::string(1, base::kAxisNames[axis])) {
            columns[axis] = static_cast<int>(i);
          }
        }
      }
      continue;
    }
    bool named = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<std::size_t>(columns[axis]);
      if (columns[axis] >= 0 && column < cells.size() && !cells[column].empty()) {
        last[axis] = cells[column];
        named = true;
      }
    }
    const std::string row = last[0] + "," + last[1] + "," + last[2];
    // The table repeats the position in every row that moves nothing.
    if (named && (rows.empty() || rows.back() != row)) {
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace

class TestNcInterpreter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void targetsOf_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("targets");
    const auto row = [](const char* name, const char* program, const char* targets) {
      QTest::newRow(name) << QString::fromLatin1(program) << QString::fromLatin1(targets);
    };
    row("variables", "DEF REAL A=2, B\nDEF INT N\nB=A*3\nN=2.6\nX=B Y=N\nM30", "6,3,0");
    row("array", "DEF REAL F[2,3]=SET(1,2,3,4,5,6)\nX=F[1,0] Y=F[0,2]\nF[1,2]=9\nX=F[1,2]\nM30",
        "4,3,0 9,3,0");
    row("rep", "DEF INT F[4]=REP(7)\nX=F[3]\nM30", "7,0,0");
    row("for", "DEF INT I\nFOR I=1 TO 3\nX=I\nENDFOR\nM30", "1,0,0 2,0,0 3,0,0");
    row("for never", "DEF INT I\nFOR I=5 TO 3\nX=I\nENDFOR\nX=9\nM30", "9,0,0");
    row("nested", "DEF INT I\nDEF INT J\nFOR I=0 TO 1\nFOR J=0 TO 1\nX=I Y=J\nENDFOR\nENDFOR\nM30",
        "0,0,0 0,1,0 1,0,0 1,1,0");
    row("loop", "R1=0\nLOOP\nR1=R1+1\nIF R1>2 GOTOF OUT_\nX=R1\nENDLOOP\nOUT_: M30", "1,0,0 2,0,0");
    row("repeat until", "R1=0\nREPEAT\nR1=R1+1\nX=R1\nUNTIL R1>=3\nM30", "1,0,0 2,0,0 3,0,0");
    row("if else", "R1=2\nIF R1==1\nX1\nELSE\nX2\nENDIF\nM30", "2,0,0");
    row("case",
        "R1=7\nCASE(R1) OF 3 GOTOF AA 7 GOTOF BB DEFAULT GOTOF CC\nAA: X1\nM30\nBB: X2\n"
        "M30\nCC: X3\nM30",
        "2,0,0");
    row("case default", "CASE(1) OF 3 GOTOF AA DEFAULT GOTOF CC\nAA: X1\nM30\nCC: X3\nM30",
        "3,0,0");
    row("two jumps in a block",
        "R1=2\nIF R1==1 GOTOF AA IF R1==2 GOTOF BB\nX9\nAA: X1\nBB: X2\nM30", "2,0,0");
    row("goto number", "GOTOF N30\nN20 X1\nN30 X2\nM30", "2,0,0");
    row("gotoc", "GOTOC NOWHERE\nX1\nM30", "1,0,0");
    row("gotos", "R1=R1+1\nX=R1\nIF R1<2 GOTOS\nM30", "1,0,0 2,0,0");
    row("repeat label", "X1\nAA: X=IC(1)\nX=IC(10)\nREPEAT AA P=2\nM30",
        "1,0,0 2,0,0 12,0,0 13,0,0 23,0,0 24,0,0 34,0,0");
    row("repeat between labels", "AA: X=IC(1)\nBB: Y=IC(1)\nX=IC(10)\nREPEAT AA BB P=2\nX0\nM30",
        "1,0,0 1,1,0 11,1,0 12,1,0 12,2,0 13,2,0 13,3,0 0,3,0");
    row("repeatb", "AA: X=IC(1)\nY1\nREPEATB AA P3\nY2\nM30",
        "1,0,0 1,1,0 2,1,0 3,1,0 4,1,0 4,2,0");
    row("label in a variable", "DEF STRING[8] TT=\"BB\"\nGOTOF TT\nX1\nBB: X2\nM30", "2,0,0");
    row("text compared", "DEF STRING[8] TT\nTT=\"A\"<<1\nIF TT==\"A1\"\nX1\nENDIF\nM30", "1,0,0");
    row("arc without an end", "G2 I5 J0 AR=90\nM30", "5,5,0");
    row("machine coordinates", "TRANS X10\nG53 X1\nX1\nSUPA X2 Y1\nY2\nM30",
        "1,0,0 11,0,0 2,1,0 2,2,0");
    row("scale", "X10 Y10\nSCALE X2\nX6\nY1\nASCALE X0.5\nX3\nM30", "10,10,0 12,10,0 12,1,0 3,1,0");
    row("mirror", "MIRROR X0\nX5 Y1\nM30", "-5,1,0");
    row("turned about Y", "ROT Y90\nX1\nM30", "0,0,-1");
    row("ac and ic", "G91 X5 Y5\nX=AC(1) Y=IC(2)\nG90 X2 Y=IC(-1)\nM30", "5,5,0 1,7,0 2,6,0");
    row("inches", "G70 X1\nG71 X1\nM30", "25.4,0,0 1,0,0");
    row("trans", "X1 Y1\nTRANS X100 Y2\nX1 Y1\nATRANS X50 Y2\nX1 Y1\nTRANS\nX1\nM30",
        "1,1,0 101,3,0 151,5,0 1,5,0");
    row("rot", "TRANS X10\nAROT Z90\nX1 Y0\nROT\nX1 Y0\nM30", "10,1,0 1,0,0");
    row("constants", "X='HFF' Y='B101'\nM30", "255,5,0");
    row("block skip and numbers", "/N10 X1\n/3 X2\n:20 X3 ; comment\nM30", "1,0,0 2,0,0 3,0,0");
    row("rotary axes move nothing", "X1 A30 B=45.5\nC90\nM30", "1,0,0");
  }
  void targetsOf() {
    QFETCH(QString, program);
    QFETCH(QString, targets);
    const Outcome outcome = runProgram(program.toStdString());
    QVERIFY2(outcome.ended, outcome.alarmText.c_str());
    QCOMPARE(QString::fromStdString(outcome.targets()), targets);
  }

  void alarms_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("alarm");
    const auto row = [](const char* name, const char* program, int alarm) {
      QTest::newRow(name) << QString::fromLatin1(program) << alarm;
    };
    row("no end", "X1", 12080);
    row("syntax", "X=(1+\nM30", 12080);
    row("unknown G", "G123\nM30", 12470);
    row("unknown name", "ABC=1\nM30", 12550);
    row("cycle", "G81 Z-5\nM30", 12470);
    row("macro", "G65 P100\nM30", 12470);
    row("inches of ISO", "G20 X1\nM30", 12470);
    row("millimetres of ISO", "G21\nM30", 12470);
    row("tool length of ISO", "G0 G43 Z10 H1\nM30", 12470);
    row("position of ISO", "G92 X5\nM30", 12470);
    row("shift of ISO", "G52 X5\nM30", 12470);
    row("end of a cycle of ISO", "G80\nM30", 12470);
    row("return to the initial level of ISO", "G98\nM30", 12470);
    row("return to the R level of ISO", "G99\nM30", 12470);
    row("comment of ISO", "(ROUGHING)\nM30", 12080);
    row("transformation", "TRAORI\nM30", 12550);
    row("tool direction", "X1 A3=1\nM30", 12550);
    row("spline", "BSPLINE X1\nX2\nM30", 12550);
    row("query", "DEF INT NN\nGETT(NN,\"MILL\")\nM30", 12550);
    row("group twice", "G0 G1 X1\nM30", 12060);
    row("address twice", "X1 X2\nM30", 12010);
    row("no program", "L99\nM30", 14011);
    row("no such name", "NOWHERE\nM30", 12550);
    row("circle ends", "G2 X10 Y0 I4 J0\nM30", 14040);
    row("circle radius", "G2 X10 Y0 CR=4\nM30", 14040);
    row("line of three points", "CIP X10 Y0 I1=5 J1=0\nM30", 14040);
    row("polar angle without a radius", "AP=90\nM30", 12080);
    row("polar radius without an angle", "RP=5\nM30", 12080);
    row("M of the first spindle", "M1=277777777777\nM30", 12080);
    row("division", "R1=1/0\nM30", 14051);
    row("label", "GOTOF NOWHERE\nM30", 14080);
    row("index", "R1=R[1000]\nM30", 17020);
    row("array index", "DEF REAL A[3]\nA[3]=1\nM30", 17020);
    row("feed", "F0 X1\nM30", 14800);
    row("endif", "ENDIF\nM30", 12080);
    row("main run", "R1=$AA_IM[X]\nM30", 12550);
    row("open loop", "LOOP\nX1\nGOTOF AA\nENDWHILE\nAA: M30", 0);
  }
  void alarms() {
    QFETCH(QString, program);
    QFETCH(int, alarm);
    const Outcome outcome = runProgram(program.toStdString());
    QVERIFY2(outcome.alarm == alarm, (std::to_string(outcome.alarm) + outcome.alarmText).c_str());
  }

  void feedMustBeProgrammed() { QCOMPARE(runProgram("X1\nM30", {}, 0.0).alarm, 10860); }

  void subprograms() {
    const std::map<std::string, std::string> library{
        {"STEP", "PROC STEP(REAL DX, INT N)\nDEF REAL LOCAL=5\nX=IC(DX*N) Y=LOCAL\nM17\n"},
        {"L7", "X=IC(1)\nRET\n"},
        {"DEEP", "DEEP\nM17\n"}};
    QCOMPARE(runProgram("STEP(2,3)\nL7 P3\nX0\nM30", library).targets(),
             std::string("6,5,0 7,5,0 8,5,0 9,5,0 0,5,0"));
    QCOMPARE(runProgram("CALL \"L7\"\nM30", library).targets(), std::string("1,0,0"));
    QCOMPARE(runProgram("DEEP\nM30", library).alarm, 14011);
    QCOMPARE(runProgram("STEP(1,2,3)\nM30", library).alarm, 12150);
  }

  void arcs() {
    const double pi = std::acos(-1.0);
    const auto arcOf = [](const char* program) {
      const Outcome outcome = runProgram(program);
      return outcome.motions.empty() || !outcome.motions.back().arc ? machine::ArcPath{}
                                                                    : *outcome.motions.back().arc;
    };
    const auto half = arcOf("G1 X0 Y0\nG2 X10 Y0 I5 J0\nM30");
    QVERIFY((half.centreMm == base::Vec3{5, 0, 0}));
    QVERIFY(std::abs(half.sweepRad - pi) < 1e-12 && half.axis.z == -1.0);
    const auto full = arcOf("G3 X0 Y0 I5 J0\nM30");
    QVERIFY(std::abs(full.sweepRad - 2.0 * pi) < 1e-12 && full.axis.z == 1.0);
    const auto helix = arcOf("G3 X0 Y0 Z10 I5 J0 TURN=2\nM30");
    QVERIFY(std::abs(helix.sweepRad - 6.0 * pi) < 1e-12);
    const auto absolute = arcOf("X10 Y10\nG2 X20 Y10 I=AC(15) J=AC(10)\nM30");
    QVERIFY((absolute.centreMm == base::Vec3{15, 10, 0}));
    const auto small = arcOf("G3 X10 Y0 CR=10\nM30");
    QVERIFY(std::abs(small.sweepRad - pi / 3.0) < 1e-9 && small.centreMm.y > 0.0);
    const auto large = arcOf("G3 X10 Y0 CR=-10\nM30");
    QVERIFY(std::abs(large.sweepRad - 5.0 * pi / 3.0) < 1e-9 && large.centreMm.y < 0.0);
    const auto angle = arcOf("G2 X10 Y0 AR=90\nM30");
    QVERIFY(std::abs(angle.sweepRad - pi / 2.0) < 1e-9);
    const auto zx = arcOf("G18 G2 X10 Z0 I5 K0\nM30");
    QVERIFY(zx.axis.y == -1.0 && std::abs(zx.sweepRad - pi) < 1e-12);
    const auto mirrored = arcOf("MIRROR X0\nG2 X10 Y0 I5 J0\nM30");
    QVERIFY((mirrored.centreMm == base::Vec3{-5, 0, 0}));
    QVERIFY(mirrored.axis.z == 1.0 && std::abs(mirrored.sweepRad - pi) < 1e-12);
    QVERIFY(arcOf("SCALE X2\nG2 X10 Y0 I5 J0\nM30").sweepRad == 0.0);
    const auto through = arcOf("CIP X10 Y0 I1=5 J1=5\nM30");
    QVERIFY(base::distance(through.centreMm, {5, 0, 0}) < 1e-12);
    QVERIFY(std::abs(through.sweepRad - pi) < 1e-12 && through.axis.z < 0.0);
  }

  /// G70 speaks of lengths only, G700 of the feed as well.
  void feedOfOtherUnits_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("mmPerMin");
    QTest::newRow("inches of lengths") << QStringLiteral("G70 F600 X1") << 600.0;
    QTest::newRow("inches") << QStringLiteral("G700 F10 X1") << 254.0;
    QTest::newRow("per revolution") << QStringLiteral("S1000 M3\nG95 F0.1 X1") << 100.0;
    QTest::newRow("inverse time") << QStringLiteral("G93 F2 X30") << 60.0;
    QTest::newRow("named again") << QStringLiteral("F600 X1\nG94 X2") << 600.0;
  }
  void feedOfOtherUnits() {
    QFETCH(QString, program);
    QFETCH(double, mmPerMin);
    const Outcome outcome = runProgram(program.toStdString() + "\nM30");
    QVERIFY2(outcome.ended, outcome.alarmText.c_str());
    QVERIFY(std::abs(outcome.motions.back().feedMmPerS * 60.0 - mmPerMin) < 1e-9);
  }

  void modes() {
    const auto motions =
        runProgram("G64 X1\nG9 X2\nX3\nG641 ADIS=0.5 SOFT X4\nBRISK G642 X5\nG60 X6\nM30").motions;
    QCOMPARE(motions.size(), std::size_t{6});
    QVERIFY(motions[0].end == BlockEnd::Rounded && motions[0].roundingMm == 0.01);
    QVERIFY(motions[1].end == BlockEnd::ExactStop);
    QVERIFY(motions[2].end == BlockEnd::Rounded);
    QVERIFY(motions[3].rounding == machine::RoundingKind::Distance);
    QVERIFY(motions[3].roundingMm == 0.5 && motions[3].dynamics == machine::Dynamics::Soft);
    QVERIFY(motions[4].rounding == machine::RoundingKind::Deviation);
    QVERIFY(motions[4].dynamics == machine::Dynamics::Brisk);
    QVERIFY(motions[5].end == BlockEnd::ExactStop);
  }

  /// Hand-written programs of another project with the results it publishes. Left out: what the
  /// control refuses and that project does not (arrays and logic_operators use undefined
  /// variables, function_calls raises an alarm by SETAL, simple and edge_cases have axes this
  /// machine lacks), splines (spline, flatten_demo), what answers for another machine's position
  /// (actual_position), axis names as variables (axis_index_assignment), a tool call alone (tool);
  /// and increment, whose published result takes 0.1*9 for 900.9.
  void corpusPrograms_data() {
    QTest::addColumn<QString>("name");
    for (const char* name :
         {"arc", "basic_math", "case", "case_insensitive_variables", "def_string", "for_loop",
          "goto", "if_statement", "loop", "multiple_m_codes", "precedence", "r_param", "repeat",
          "trans", "trans2", "trans_ic", "trans_reset", "trig", "variables"}) {
      QTest::newRow(name) << QString::fromLatin1(name);
    }
  }
  void corpusPrograms() {
    const std::filesystem::path folder = RIVULET_SOURCE_DIR "/../shared/corpus/cead-nc-interpreter";
    std::error_code missing;
    if (!std::filesystem::exists(folder, missing)) {
      QSKIP("The corpus of NC programs is not here.");
    }
    QFETCH(QString, name);
    const std::string file = name.toStdString();
    std::string text = readFile(folder / (file + ".mpf"));
    QVERIFY(!text.empty());
    const std::string csv = readFile(folder / "oracle" / (file + ".csv"));
    const std::vector<std::string> expected = expectedTargets(csv);
    // Some of the programs are fragments: they end with their last line.
    const Outcome outcome = runProgram(text + "\nM30\n");
    QVERIFY2(outcome.ended, outcome.alarmText.c_str());
    std::vector<base::Vec3> targets;
    for (const PreparedMotion& motion : outcome.motions) {
      if (targets.empty() || base::distance(targets.back(), motion.targetMm) > 6e-4) {
        targets.push_back(motion.targetMm);
      }
    }
    if (expected.empty()) {
      return;  // moves none of X, Y and Z
    }
    QCOMPARE(targets.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      std::string_view row = expected[i];
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const std::size_t comma = std::min(row.find(','), row.size());
        const double value = base::parseNumber(row.substr(0, comma)).value_or(std::nan(""));
        row.remove_prefix(std::min(row.size(), comma + 1));
        QVERIFY2(std::abs(targets[i][axis] - value) <= 1.01e-3,
                 (std::to_string(i) + ": " + expected[i] + ", " + outcome.targets()).c_str());
      }
    }
  }

  /// Whatever is written, nothing crashes and nothing hangs.
  void nonsenseIsAnAlarmAtWorst() {
    static constexpr std::array<const char*, 48> kTokens{
        "G1",   "G2",       "X",      "Y=",    "R1=",    "R[",   "]",       "(",
        ")",    "=",        "IF",     "ELSE",  "ENDIF",  "FOR",  "TO",      "ENDFOR",
        "LOOP", "ENDLOOP",  "REPEAT", "UNTIL", "CASE",   "OF",   "DEFAULT", "GOTOB",
        "AA:",  "AA",       "1",      "2.5",   "-",      "*",    "DEF",     "REAL",
        "A",    "[2]",      ",",      "SET",   "\"s\"",  "ID=1", "WHEN",    "DO",
        "$R1=", "$AC_OVR=", "TRANS",  "M17",   "STOPRE", "P2",   "CR=",     "\n"};
    base::Random random(5);
    for (int program = 0; program < 3000; ++program) {
      std::string text;
      const std::uint64_t tokens = 1 + random.below(40);
      for (std::uint64_t i = 0; i < tokens; ++i) {
        text += std::string(kTokens[random.below(kTokens.size())]) +
                (random.below(4) == 0 ? "\n" : " ");
      }
      Outcome outcome = runProgram(text + "\nM30\n", {{"A", "X=IC(1)\nM17\n"}});
      QVERIFY(outcome.ended || outcome.alarm != 0 || outcome.motions.size() < 20001);
    }
  }
};

RIVULET_TEST(TestNcInterpreter)
#include "tst_nc_interpreter.moc"
