// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which blocks of a text are executed, whatever stands before, between and behind its programs, and
// which of them are named because they are not.

#include <QtTest>

#include "base/text.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::Dialect;

namespace {

gcode::Interpretation read(const std::string& text, Dialect dialect) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  return gcode::interpret(text, options);
}

/// X of every point.
std::string pathOf(const gcode::Interpretation& result) {
  std::string out;
  for (const gcode::TrajectoryPoint& point : result.trajectory.points) {
    out += (out.empty() ? "" : " ") + base::formatFixed(point.positionMm.x, 3);
  }
  return out;
}

std::string errorsOf(const gcode::Interpretation& result) {
  std::vector<gcode::Diagnostic> errors;
  std::copy_if(
      result.diagnostics.begin(), result.diagnostics.end(), std::back_inserter(errors),
      [](const gcode::Diagnostic& each) { return each.severity == gcode::Severity::Error; });
  return test::printFindings(errors);
}

/// What was not executed, with its severity.
std::string unreachedOf(const gcode::Interpretation& result) {
  using Code = gcode::DiagnosticCode;
  std::vector<gcode::Diagnostic> found;
  std::copy_if(result.diagnostics.begin(), result.diagnostics.end(), std::back_inserter(found),
               [](const gcode::Diagnostic& each) {
                 return each.code == Code::NeverExecuted || each.code == Code::NeverCalled ||
                        each.code == Code::AnotherMainProgram;
               });
  return test::printFindings(found);
}

struct Manner {
  Dialect dialect;
  std::vector<std::string> beginnings;
  /// Something that needs the tree of the program, and what follows M30.
  std::vector<std::pair<std::string, std::string>> steering;
  std::vector<std::string> ends;
};

const std::vector<Manner>& manners() {
  static const std::string sub = "O2\nG91 G1 X5 F100\nG90\nM99\n";
  static const std::vector<std::pair<std::string, std::string>> ofHash{
      {"M98 P2\n", sub},
      {"G65 P2 A1\n", sub},
      {"IF [1 EQ 1] GOTO 10\nG0 X77\nN10 G1 X15 F100\n", ""},
      {"GOTO 20\nG0 X77\nN20 G1 X15 F100\n", ""},
      {"#1=0\nWHILE [#1 LT 1] DO1\n#1=#1+1\nG1 X15 F100\nEND1\n", ""},
      {"IF [1 EQ 1] THEN #1=15\nG1 X#1 F100\n", ""}};
  static const std::vector<std::pair<std::string, std::string>> ofNgc{
      {"M98 P2\n", sub},
      {"o5 if [1 EQ 1]\nG1 X15 F100\no5 endif\n", ""},
      {"#1=0\no5 while [#1 LT 1]\n#1=[#1+1]\nG1 X15 F100\no5 endwhile\n", ""},
      {"o7 sub\nG1 X15 F100\no7 endsub\no7 call\n", ""}};
  static const std::vector<std::string> ofTape{
      "",         "%\n",     "%\n\n\n",        "\n%\nO1\n",   "%\nO0001 (MAIN)\n",
      "O1 (A)\n", "%\n:1\n", "%\n(COMMENT)\n", "\n\n(A)\n\n", "%\nO1 G17\n\n(B)\n",
      "N1\n%\n",  "O1\n%\n", "%\r\nO1\r\n",    "%%\nO1\n",    "%O1\n"};
  static const std::vector<std::string> tapeEnds{"", "%", "%\n", "\n\n%\n\n", "%\n\x1A"};
  static const std::vector<Manner> all{
      {Dialect::Fanuc, ofTape, ofHash, tapeEnds},
      {Dialect::LinuxCnc, ofTape, ofNgc, tapeEnds},
      {Dialect::Sinumerik,
       {"", "%_N_MAIN_MPF\n", "%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\n", "%\n", "; A\n\n", "PROC MAIN\n",
        "%_N_MAIN_MPF\nPROC MAIN\n", "N5 PROC MAIN SAVE\n"},
       {{"PART\n", "%_N_PART_SPF\nG91 G1 X5 F100\nG90\nM17\n"},
        {"PART(5)\n",
         "%_N_PART_SPF\n;$PATH=/_N_SPF_DIR\nPROC PART(REAL A)\nG1 X=IC(A) F100\nRET\n"},
        {"CALL \"PART\"\n", "PROC PART\nG91 G1 X5 F100\nG90\nM17\n"},
        {"IF 1==1 GOTOF NEXT\nX77\nNEXT: G1 X15 F100\n", ""},
        {"R1=0\nWHILE R1<1\nR1=R1+1\nG1 X15 F100\nENDWHILE\n", ""},
        {"AA: G91 G1 X2.5 F100\nG90\nREPEAT AA P=1\n", ""}},
       {"", "\n"}}};
  return all;
}

}  // namespace

class TestTextPrograms : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The main program goes on behind what calls, jumps or repeats, wherever the text begins.
  void mainProgramGoesOn() {
    for (const Manner& manner : manners()) {
      for (const std::string& beginning : manner.beginnings) {
        for (const auto& [steering, behind] : manner.steering) {
          for (const std::string& end : manner.ends) {
            const std::string text = beginning + "G90\nG0 X0 Y0 Z10\nX10\n" + steering +
                                     "G0 X50\nZ20\nM30\n" + behind + end;
            const gcode::Interpretation result = read(text, manner.dialect);
            const std::string path = pathOf(result);
            // In steps of 2.5 where a REPEAT makes two of them.
            const bool isRight = path == "0 10 15 50 50" || path == "0 10 12.5 15 50 50";
            QVERIFY2(isRight && errorsOf(result).empty(),
                     (text + "\n-> " + path + "\n" + errorsOf(result)).c_str());
          }
        }
      }
    }
  }

  /// What needs the tree may stand in any block: before it the text is read line by line.
  void anyBlockMaySteer() {
    const std::vector<std::string> blocks{"G0 X1", "X2", "X3", "G1 X4 F50", "X5", "G0 X6"};
    for (const char* beginning : {"", "%\nO1\n", "%\n\n:7\n", "(A)\nO1 (B)\n"}) {
      for (std::size_t at = 0; at <= blocks.size(); ++at) {
        std::string text = beginning;
        for (std::size_t i = 0; i <= blocks.size(); ++i) {
          text += i == at ? "IF [1 EQ 2] GOTO 9999\n" : "";
          text += i < blocks.size() ? blocks[i] + "\n" : "";
        }
        text += "M30\n%\n";
        QCOMPARE(pathOf(read(text, Dialect::Fanuc)), std::string("1 2 3 4 5 6"));
      }
    }
  }

  void programs_data() {
    QTest::addColumn<int>("dialect");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("unreached");
    const auto add = [](const char* name, Dialect dialect, const char* text, const char* path,
                        const char* unreached) {
      QTest::newRow(name) << static_cast<int>(dialect) << QByteArray(text) << QByteArray(path)
                          << QByteArray(unreached);
    };
    const Dialect iso = Dialect::Fanuc;
    const Dialect ngc = Dialect::LinuxCnc;
    const Dialect sinumerik = Dialect::Sinumerik;
    add("behind M30", iso, "G0 X1\nM30\n\n(c)\nX2\nX3", "1",
        "5:1 warning never-executed lines 5 to 6");
    add("behind %", iso, "G0 X1\n%\nX2", "1", "3:1 warning never-executed line 3");
    add("behind % with a tape begun", iso, "%\nG0 X1\nM30\n%\nX2\n", "1",
        "5:1 warning never-executed line 5");
    add("behind GOTO", iso, "G0 X1\nGOTO 5\nX2\nX3\nN5 X4\nM30", "1 4",
        "3:1 warning never-executed lines 3 to 4");
    add("not with these values", iso, "G0 X1\nIF [1 EQ 1] GOTO 5\nX2\nN5 X4\nM30", "1 4",
        "3:1 note never-executed line 3");
    add("subprogram never called", iso, "O1\nG0 X1\nM30\nO2\nX2\nM99\n", "1",
        "5:1 warning never-called O2 (lines 5 to 6)");
    add("one of two called", iso, "O1\nG0 X1\nM98 P3\nM30\nO2\nX2\nM99\nO3\nX3\nM99\n", "1 3",
        "6:1 warning never-called O2 (lines 6 to 7)");
    // Fanuc: what stands before the first % is no part of the program.
    add("text before the tape begins", iso, "(A (PART) )\n%\nO1\nG0 X1\nM30\n%\n", "1", "");
    add("blocks before %", iso, "G0 X1\n%\nO1\nG0 X2\nM30\n", "1",
        "4:1 error another-main-program O1 (lines 4 to 5)");
    add("two main programs", iso, "%\nO1\nG0 X1\nM30\n%\nO2\nG0 X2\nM30\n%\n", "1",
        "7:1 error another-main-program O2 (lines 7 to 8)");
    add("two main programs without %", iso, "O1\nG0 X1\nM30\nO2\nG0 X2\nM30", "1",
        "5:1 error another-main-program O2 (lines 5 to 6)");
    add("two tapes without numbers", iso, "%\nG0 X1\nM30\n%\nG0 X2\nM30\n%", "1",
        "5:1 error another-main-program lines 5 to 6");
    add("second program called", iso, "O1\nG0 X1\nM98 P2\nM30\nO2\nG0 X2\nM30", "1 2",
        "4:1 warning never-executed line 4");
    add("subprogram first", iso, "%\nO2\nG91 G0 X1\nG90\nM99\nO1\nG0 X5\nM98 P2\nX9\nM30\n%",
        "5 6 9", "");
    add("main program without end", iso, "O1\nG0 X1\nO2\nG0 X2\nM99", "1",
        "4:1 warning never-called O2 (lines 4 to 5)");
    add("blocks before the number", iso, "G0 X1\nM30\nO2\nX2\nM30", "1",
        "4:1 error another-main-program O2 (lines 4 to 5)");
    add("sub never called", ngc, "o1 sub\nG0 X1\no1 endsub\nG0 X5\nM2", "5",
        "2:1 warning never-called O1 (line 2)");
    add("sub behind the end", ngc, "G0 X5\no1 call\nM2\no1 sub\nG0 X1\no1 endsub\n", "5 1", "");
    add("branch not taken", ngc, "o1 if [0]\nG0 X1\no1 else\nG0 X2\no1 endif\nM2", "2",
        "2:1 note never-executed line 2");
    add("archive", sinumerik,
        "%_N_SUBB_SPF\nG0 X1\nM17\n%_N_MAIN_MPF\nG0 X5\nSUBB\nX9\nM30\n%_N_REST_SPF\nX2\nM17\n",
        "5 1 9", "10:1 warning never-called REST (lines 10 to 11)");
    add("archive with two main programs", sinumerik,
        "%_N_A_MPF\nG0 X5\nM30\n%_N_B_MPF\nG0 X6\nM30\n", "5",
        "5:1 error another-main-program B (lines 5 to 6)");
    add("procedure behind the end", sinumerik, "G0 X5\nM30\nPROC PART\nX1\nM17", "5",
        "4:1 warning never-called PART (lines 4 to 5)");
    add("procedure without an end before it", sinumerik, "G0 X5\nPROC PART\nX1\nM17", "5",
        "3:1 warning never-called PART (lines 3 to 4)");
    // A file of a TNC holds one program.
    add("two programs of a TNC", Dialect::Heidenhain,
        "BEGIN PGM A MM\nL X+1 F100\nEND PGM A MM\nBEGIN PGM B MM\nL X+2 F100\nEND PGM B MM\n", "1",
        "4:1 error another-main-program B (lines 4 to 5)");
    add("two programs of a TNC, one without an end", Dialect::Heidenhain,
        "BEGIN PGM A MM\nL X+1 F100\nBEGIN PGM B MM\nL X+2 F100\nEND PGM B MM\n", "1",
        "3:1 error another-main-program B (lines 3 to 4)");
    add("two programs of a TNC with labels", Dialect::Heidenhain,
        "BEGIN PGM A MM\nLBL 1\nL IX+1 F100\nCALL LBL 1 REP 1\nEND PGM A MM\nBEGIN PGM B MM\nLBL "
        "1\nL X+2 F100\nCALL LBL 1 REP 1\nEND PGM B MM\n",
        "", "6:1 error another-main-program B (lines 6 to 9)");
    add("a subprogram alone", sinumerik, "%_N_A_SPF\nG0 X5\nM17\n", "5", "");
  }

  void programs() {
    QFETCH(const int, dialect);
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, path);
    QFETCH(const QByteArray, unreached);
    const gcode::Interpretation result = read(text.toStdString(), static_cast<Dialect>(dialect));
    QCOMPARE(QByteArray::fromStdString(pathOf(result)), path);
    QCOMPARE(QByteArray::fromStdString(unreachedOf(result)), unreached);
  }

  /// Which of the two the control would call is not known.
  void nameOfTwo() {
    const auto result = read("O1\nG0 X1\nM98 P2\nM30\nO2\nX2\nM99\nO2\nX3\nM99\n", Dialect::Fanuc);
    QCOMPARE(
        QByteArray::fromStdString(errorsOf(result)).split('|').front().trimmed(),
        QByteArray("8:1 error flow-fault the file holds two programs of the name O2: rename or "
                   "remove one of them"));
  }

  /// A loop that changes nothing never ends: it is found at its second round.
  void loopsThatNeverEnd() {
    for (const char* text : {"G0 X0\nN1 M8\nM9\nGOTO 1", "G0 X0\nWHILE [1 EQ 1] DO1\nM8\nEND1",
                             "G0 X0\n#1=5\nN1 #2=#1*2\nIF [#2 GT 5] GOTO 1"}) {
      const auto result = read(text, Dialect::Fanuc);
      QVERIFY(errorsOf(result).find("endless-loop") != std::string::npos);
      QVERIFY(result.trajectory.points.size() < 10);
    }
  }

  /// One that waits for its own position, or repeats and calls in between, does end.
  void loopsThatEnd() {
    QCOMPARE(pathOf(read("G0 X0\nAA: G91 X1\nREPEAT AA P=2\nG90 X9", Dialect::Sinumerik)),
             std::string("0 1 2 3 9"));
    QCOMPARE(
        pathOf(read("G0 X0\nAA: G91 X1\nG90\nIF $AA_IW[X]<3 GOTOB AA\nX9", Dialect::Sinumerik)),
        std::string("0 1 2 3 9"));
  }

  /// $AA_IM is known where the whole chain is: offset and frame, and no tool whose length counts.
  void positionInTheMachine() {
    const auto resultOf = [](const char* text, bool isVirtual) {
      gcode::LoadOptions options;
      options.dialect = Dialect::Sinumerik;
      if (isVirtual) {
        options.workOffsetMm = [](int key) {
          return key == 540 ? std::nullopt : std::optional(base::Vec3{0, 0, key < 0 ? 7.0 : 0.0});
        };
      }
      const gcode::Program program = gcode::interpretProgram("A.MPF", text, options).value();
      return program.isUnderstood()
                 ? base::formatNumber(program.trajectory.points.back().positionMm.y)
                 : std::string("refused");
    };
    const char* const program = "G1 X0 Y0 Z10 F100\nTRANS Z100\nY=$AA_IM[Z]\nM30\n";
    QCOMPARE(resultOf(program, true), std::string("17"));
    QCOMPARE(resultOf(program, false), std::string("refused"));
    QCOMPARE(resultOf("G1 X0 Y0 Z10 F100\nTRANS Z100\nG1 Z10\nY=$AA_IM[Z]\nM30\n", true),
             std::string("117"));
    for (const char* const unknown :
         {"G1 X0 Y0 F100\nY=$AA_IM[Z]\nM30\n", "G54\nG1 X0 Y0 Z10 F100\nY=$AA_IM[Z]\nM30\n",
          "T1 D1\nG1 X0 Y0 Z10 F100\nY=$AA_IM[Z]\nM30\n",
          "G700\nG1 X0 Y0 Z10 F100\nY=$AA_IM[Z]\nM30\n",
          "TRAORI\nG1 X0 Y0 Z10 F100\nY=$AA_IM[Z]\nM30\n"}) {
      QCOMPARE(resultOf(unknown, true), std::string("refused"));
    }
  }
};

RIVULET_TEST(TestTextPrograms)
#include "tst_text_programs.moc"
