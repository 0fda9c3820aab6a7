// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A SINUMERIK program takes the same path where it is read for a preview and where the virtual
/// machine executes it. Where the two disagreed once, the row names the manual that settles it:
/// JP06, JP10 and PG19 as in tst_eval.cpp; "no page found" where no page of a manual was at hand.

#include <QtTest>
#include <cmath>
#include <map>

#include "base/text.h"
#include "gcode/program.h"
#include "machine/interpreter.h"
#include "nc/syntax/programs.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using Programs = std::map<std::string, std::string>;

std::string printed(base::Vec3 target) {
  std::string text;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    text += (axis > 0 ? "," : "") + base::formatNumber(std::round(target[axis] * 1e6) / 1e6);
  }
  return text;
}

/// "1,2,3 4,5,6", and "!" where the program cannot be read or executed on.
std::string preview(const std::string& text, const Programs& library) {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  options.keepArcs = true;
  options.repeatedLinesMax = 5000;
  options.subprogram = [&library](std::string_view name) -> std::optional<nc::LoadedText> {
    const auto found = library.find(std::string(name));
    return found == library.end() ? std::nullopt : std::optional(nc::LoadedText{found->second, {}});
  };
  const auto program = gcode::interpretProgram("A", text, options);
  if (!program) {
    return "!";
  }
  std::string path;
  for (const gcode::TrajectoryPoint& point : program->trajectory.points) {
    path += (path.empty() ? "" : " ") + printed(point.positionMm);
  }
  return path + (program->isUnderstood() ? "" : " !");
}

std::string executed(const std::string& text, const Programs& library) {
  machine::RParameters parameters{100};
  machine::InterpreterOptions options;
  options.rapidMmPerS = 100.0;
  options.feedMmPerS = 10.0;
  options.library = [&library](const std::string& name) -> std::shared_ptr<const nc::Tree> {
    const auto found = library.find(name);
    return found == library.end() ? nullptr : nc::parseSinumerik(found->second);
  };
  machine::Interpreter interpreter(nc::parseSinumerik(text), parameters, options);
  std::string path;
  for (int block = 0; block < 5000; ++block) {
    const machine::Prepared prepared = interpreter.next();
    if (const auto* motion = std::get_if<machine::PreparedMotion>(&prepared)) {
      path += (path.empty() ? "" : " ") + printed(motion->targetMm);
    } else if (std::holds_alternative<machine::PreparedStopre>(prepared)) {
      interpreter.refresh();
    } else if (std::holds_alternative<machine::PreparedEnd>(prepared)) {
      return path;
    } else if (std::holds_alternative<machine::Alarm>(prepared)) {
      return path + " !";
    }
  }
  return path + " !";
}

}  // namespace

class TestSameLanguage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The preview reads on behind a fault, the machine stops: up to there they agree.
  void samePath_data() {
    QTest::addColumn<QByteArray>("program");
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("subprogram");  // SUBA
    const auto row = [](const char* name, const char* program, const char* path,
                        const char* subprogram = "") {
      QTest::newRow(name) << QByteArray(program) << QByteArray(path) << QByteArray(subprogram);
    };
    // Comparisons and loops.
    row("while within the tolerance: JP06 1.7.1", "R1=0\nWHILE R1<0.3\nX=R1\nR1=R1+0.1\nENDWHILE",
        "0,0,0 0.1,0,0 0.2,0,0");
    row("limit reached within the tolerance", "R1=0\nREPEAT\nX=R1\nR1=R1+0.1\nUNTIL R1>0.3",
        "0,0,0 0.1,0,0 0.2,0,0 0.3,0,0");
    row("case within the tolerance",
        "R1=0.1+0.2\nCASE(R1) OF 0.3 GOTOF AA DEFAULT GOTOF BB\nAA: X1\nBB: X3", "1,0,0 3,0,0");
    row("bound: JP10 1.6", "X=BOUND(9,2,5) Y=BOUND(2,9,1)", "2,2,0");
    row("for", "DEF INT II\nFOR II=1 TO 3\nX=II\nENDFOR\nY=II", "1,0,0 2,0,0 3,0,0 3,4,0");
    row("for never", "DEF INT II\nFOR II=3 TO 1\nX9\nENDFOR\nY=II", "0,3,0");
    row("for counts an R-parameter", "FOR R1=1 TO 2\nX=R1\nENDFOR", "1,0,0 2,0,0");
    row("for computes its limit once: no page found",
        "DEF INT II\nR1=3\nFOR II=1 TO R1\nR1=2\nX=II\nENDFOR", "1,0,0 2,0,0 3,0,0");
    row("nested", "DEF INT II, JJ\nFOR II=1 TO 2\nFOR JJ=1 TO 2\nX=II Y=JJ\nENDFOR\nENDFOR",
        "1,1,0 1,2,0 2,1,0 2,2,0");
    row("loop left by a jump", "R1=0\nLOOP\nX=R1\nR1=R1+1\nIF R1>2 GOTOF OUT_\nENDLOOP\nOUT_: Y1",
        "0,0,0 1,0,0 2,0,0 2,1,0");
    row("if else", "R1=1\nIF R1==1\nX1\nELSE\nX2\nENDIF\nIF R1<>1\nY1\nELSE\nY2\nENDIF",
        "1,0,0 1,2,0");
    row("jumps in one block", "R1=2\nIF R1==1 GOTOF AA IF R1==2 GOTOF BB\nX9\nAA: X1\nBB: X2",
        "2,0,0");
    row("block number", "R1=0\nN10 X=R1\nR1=R1+1\nIF R1<3 GOTOB N10", "0,0,0 1,0,0 2,0,0");
    row("gotoc", "GOTOC NOWHERE\nX1", "1,0,0");
    row("repeat label", "R1=0\nAA: R1=R1+1\nX=R1\nREPEAT AA P=2", "1,0,0 2,0,0 3,0,0");
    // Types and arrays.
    row("int rounds: JP10 1.8", "DEF INT AB, BB, CC\nAB=2.5\nBB=-2.5\nCC=2.4\nX=AB Y=BB Z=CC",
        "3,-3,2");
    row("bool is 0 or 1: JP10 1.8", "DEF BOOL AB, BB\nAB=0.3\nBB=5\nX=AB Y=BB", "1,1,0");
    row("int in lists: JP10 1.8", "DEF INT FF[2]=SET(1.6,2.4)\nX=FF[0] Y=FF[1]", "2,2,0");
    row("set with a gap", "DEF REAL FF[3]=SET(1,,3)\nX=FF[0] Y=FF[1] Z=FF[2]", "1,0,3");
    row("set later", "DEF REAL FF[3]\nFF[1]=SET(7,8)\nX=FF[0] Y=FF[1] Z=FF[2]", "0,7,8");
    row("rep with a number", "DEF REAL FF[3]=REP(7,2)\nX=FF[0] Y=FF[1] Z=FF[2]", "7,7,0");
    row("rep later", "DEF REAL FF[3]\nFF[1]=REP(4.5)\nX=FF[0] Y=FF[1] Z=FF[2]", "0,4.5,4.5");
    row("index is rounded", "DEF REAL FF[2,2]=SET(1,2,3,4)\nX=FF[0.6,0] Y=FF[0,1]", "3,2,0");
    row("index beyond its dimension", "DEF REAL FF[2,3]\nX1\nX=FF[0,3]", "1,0,0 !");
    row("division by zero", "X1\nX=1/0", "1,0,0 !");
    row("unknown name", "X1\nX=NOWHERE", "1,0,0 !");
    row("variables of one letter",
        "DEF INT I\nDEF REAL F[2]=SET(3,4)\nI=2.5\nF[1]=F[0]+I\nX=I Y=F[1]", "3,6,0");
    // Subprograms: PG19 3.2.1.6.
    row("by value", "DEF REAL AB=1\nSUBA(AB)\nX=AB", "0,5,0 1,5,0",
        "PROC SUBA(REAL BB)\nBB=5\nY=BB\nM17");
    row("by reference", "DEF REAL AB=1\nSUBA(AB)\nX=AB", "0,5,0 5,5,0",
        "PROC SUBA(VAR REAL BB)\nBB=5\nY=BB\nM17");
    row("array by reference", "DEF REAL FF[2]=SET(1,2)\nSUBA(FF)\nX=FF[0] Y=FF[1]", "1,6,0",
        "PROC SUBA(VAR REAL GG[])\nGG[1]=GG[0]+5\nM17");
    row("int parameter", "SUBA(2.6)", "0,3,0", "PROC SUBA(INT BB)\nY=BB\nM17");
    row("parameter left out", "SUBA(1,,3)", "1,0,3",
        "PROC SUBA(REAL AB, REAL BB, REAL CC)\nX=AB Y=BB Z=CC\nM17");
    row("default of a parameter", "SUBA()", "4,0,0", "PROC SUBA(REAL AB=4)\nX=AB\nM17");
    row("text as parameter", "SUBA(\"T1\")", "1,0,0", "PROC SUBA(STRING[10] AB)\nX1\nM17");
    row("too many values", "X1\nSUBA(1,2)", "1,0,0 !", "PROC SUBA(REAL AB)\nX9\nM17");
    row("variables of its own", "DEF REAL AB=1\nSUBA\nX=AB", "0,3,0 1,3,0",
        "DEF REAL AB=3\nY=AB\nM17");
    row("several times", "SUBA P3", "1,0,0 2,0,0 3,0,0", "X=IC(1)\nM17");
    row("save brings back G functions and frames", "X10\nSUBA\nX20\nG91 X1",
        "10,0,0 111,0,0 20,0,0 21,0,0", "PROC SUBA SAVE\nG91 G19\nTRANS X100\nX1\nM17");
    row("without save they stay", "X10\nSUBA\nX20", "10,0,0 111,0,0 131,0,0",
        "PROC SUBA\nG91\nTRANS X100\nX1\nM17");
    row("save at each of several levels", "SUBA\nX1", "5,0,0 1,0,0",
        "PROC SUBA SAVE\nTRANS X5\nX0\nM17");
    row("a subprogram behind each move", "MCALL SUBA\nX5\nX10\nMCALL\nX15",
        "5,0,0 5,1,0 10,1,0 10,2,0 15,2,0", "Y=IC(1)\nM17");
    row("call by a text", "CALL \"SUBA\"\nX1", "0,2,0 1,2,0", "Y2\nRET");
    // Words.
    row("ac and ic", "X10 Y10\nX=IC(5) Y=AC(3)\nG91 X=AC(1) Y2\nG90", "10,10,0 15,3,0 1,5,0");
    row("ic of a variable", "DEF REAL AB\nX1\nAB=IC(5)\nX=AB", "1,0,0 !");
    row("function of another spindle", "R1=30\nM2=R1\nX1", "1,0,0");
    row("exponent", "DEF REAL AB\nAB=1EX1\nX=AB", "10,0,0");
    row("variable N in a loop", "DEF INT N\nFOR R1=1 TO 2\nN=R1\nN=N+1\nX=N\nENDFOR",
        "2,0,0 3,0,0");
    row("constant of N in a loop", "DEF INT N\nFOR R1=1 TO 2\nN=7\nX=N\nENDFOR", "7,0,0 7,0,0");
    row("inches", "G70 X1\nG71 X1", "25.4,0,0 1,0,0");
    row("frames", "TRANS X10\nX1 Y1\nATRANS Y5\nX1 Y1\nTRANS\nX1 Y1", "11,1,0 11,6,0 1,1,0");
    row("rotation", "TRANS X10\nAROT Z90\nX1 Y0\nAROT RPL=90\nX1 Y0\nROT", "10,1,0 9,0,0");
    row("scale and mirror", "SCALE X2\nX5 Y1\nMIRROR X0\nX5\nMIRROR", "10,1,0 -5,1,0");
    row("turned about Y", "ROT Y90\nX1 Y0 Z0\nROT", "0,0,-1");
    row("arc without an end", "G2 I5 J0 AR=90", "5,5,0");
    row("repeatb", "AA: X=IC(1)\nY1\nREPEATB AA P2", "1,0,0 1,1,0 2,1,0 3,1,0");
    row("repeat between labels", "AA: X=IC(1)\nBB: Y=IC(1)\nREPEAT AA BB P=1",
        "1,0,0 1,1,0 2,1,0 2,2,0");
    row("label in a variable", "DEF STRING[8] TT=\"BB\"\nGOTOF TT\nX1\nBB: X2", "2,0,0");
    row("texts", "DEF STRING[8] TT\nTT=\"A\"<<1\nIF TT==\"A1\"\nX1\nENDIF", "1,0,0");
    row("arcs", "G2 X10 Y0 I5 J0\nG3 X20 Y0 CR=5\nG2 X30 Y0 AR=90\nCIP X40 Y0 I1=35 J1=5",
        "10,0,0 20,0,0 30,0,0 40,0,0");
    row("polar coordinates", "G111 X10 Y0\nRP=5 AP=90\nAP=180", "10,5,0 5,0,0");
    row("diameter", "DIAMON X20\nX=IC(10)\nDIAMOF X20", "10,0,0 15,0,0 20,0,0");
    row("tangent arc", "X10\nCT X20 Y10\nG1 X21", "10,0,0 20,10,0 21,10,0");
    row("tangent after an arc", "G2 X10 Y10 I10 J0\nCT X20 Y0", "10,10,0 20,0,0");
    row("functions by group and number", "G[14]=2 X5\nX5", "5,0,0 10,0,0");
    row("assignments of one block", "R1=1 R2=R1+1 R3=R2+1\nX=R1 Y=R2 Z=R3", "1,2,3");
    row("text with a semicolon", "MSG(\"A;B\")\nX1 ; X2", "1,0,0");
    row("lower case", "r1=5\nx=r1", "5,0,0");
  }
  void samePath() {
    QFETCH(const QByteArray, program);
    QFETCH(const QByteArray, path);
    QFETCH(const QByteArray, subprogram);
    const std::string text = "G0 X0 Y0 Z0\nG1 F600\n" + program.toStdString() + "\nM30\n";
    const Programs library{{"SUBA", subprogram.toStdString() + "\n"}};
    const std::string expected = "0,0,0 " + path.toStdString();
    QCOMPARE(executed(text, library), expected);
    const std::string shown = preview(text, library);
    if (expected.ends_with("!")) {
      QVERIFY2(shown.starts_with(expected.substr(0, expected.size() - 2)) && shown.ends_with("!"),
               shown.c_str());
    } else {
      QCOMPARE(shown, expected);
    }
  }
};

RIVULET_TEST(TestSameLanguage)
#include "tst_same_language.moc"
