// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs with loops, jumps and subprograms, executed: the points say in which order.

#include <QtTest>

#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

gcode::Interpretation interpret(std::string_view text) {
  gcode::LoadOptions options;
  options.chordToleranceMm = 1000.0;
  return gcode::interpret(text, options);
}

/// X of every point, and the first problem.
std::string course(std::string_view text) {
  const gcode::Interpretation result = interpret(text);
  std::string out;
  for (const gcode::TrajectoryPoint& point : result.trajectory.points) {
    out += out.empty() ? "" : " ";
    out += base::formatFixed(point.positionMm.x, 3);
  }
  for (const gcode::Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.severity == gcode::Severity::Error) {
      return out + " ! " + test::printFindings({diagnostic});
    }
  }
  return out;
}

}  // namespace

class TestFlow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void runs_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << QByteArray(text) << QByteArray(expected);
    };
    // SINUMERIK
    add("IF ELSE", "DEF INT A=1\nIF A==1\nG0 X1\nIF A==2\nX2\nELSE\nX3\nENDIF\nELSE\nX4\nENDIF\nX5",
        "1 3 5");
    add("WHILE", "R1=0\nG0 X0\nWHILE R1<3\nR1=R1+1\nX=R1\nENDWHILE\nX9", "0 1 2 3 9");
    add("WHILE never", "R1=5\nG0 X0\nWHILE R1<3\nWHILE R1<2\nX1\nENDWHILE\nENDWHILE\nX9", "0 9");
    add("FOR", "DEF INT I\nG0 X0\nFOR I=2 TO 4\nX=I\nENDFOR\nX=I", "0 2 3 4 5");
    add("FOR nested", "DEF INT I,K\nG0 X0\nFOR I=1 TO 2\nFOR K=1 TO 2\nX=I*10+K\nENDFOR\nENDFOR",
        "0 11 12 21 22");
    add("FOR never", "DEF INT I\nG0 X0\nFOR I=2 TO 1\nX=I\nENDFOR\nX9", "0 9");
    add("REPEAT UNTIL", "R1=0\nG0 X0\nREPEAT\nR1=R1+1\nX=R1\nUNTIL R1>=2", "0 1 2");
    add("LOOP left by a jump",
        "R1=0\nG0 X0\nLOOP\nR1=R1+1\nX=R1\nIF R1==2 GOTOF OUT\nENDLOOP\n"
        "OUT: X9",
        "0 1 2 9");
    add("jump out and loop again",
        "DEF INT I\nR1=0\nG0 X0\nAGAIN: FOR I=1 TO 3\nIF I==2 GOTOF NEXT\nX=I\nENDFOR\n"
        "NEXT: R1=R1+1\nIF R1<2 GOTOB AGAIN\nX9",
        "0 1 1 9");
    add("GOTO forms", "G0 X0\nGOTOF AA\nX1\nAA: X2\nGOTOC NOWHERE\nGOTO 90\nX3\nN90 X4", "0 2 4");
    add("backward", "R1=2\nLAB1: G0 X=R1\nR1=R1-1\nIF R1>0 GOTOB LAB1", "2 1");
    add("CASE",
        "R1=2\nCASE(R1) OF 1 GOTOF AA 2 GOTOF BB DEFAULT GOTOF CC\nAA: G0 X1\nBB: G0 X2\nCC: X3",
        "2 3");
    add("REPEAT label", "MSG(\"a\")\nG0 X0\nAA: G91 X1\nREPEAT AA P=2\nG90 X9", "0 1 2 3 9");
    add("subprogram in an archive",
        "%_N_MAIN_MPF\nG0 X0\nPART(3)\nX9\nM30\n%_N_PART_SPF\nPROC PART(REAL A)\nX=A\nX=A+1\nM17",
        "0 3 4 9");
    add("PCALL and P", "%_N_MAIN_MPF\nG0 X0\nPART P2\nX9\nM30\n%_N_PART_SPF\nG91 X1\nG90\nM17",
        "0 1 2 9");
    add("own variables",
        "%_N_MAIN_MPF\nDEF REAL A=1\nPART\nG0 X=A\nM30\n%_N_PART_SPF\nDEF REAL A=5\n"
        "G0 X=A\nM17",
        "5 1");
    // Siemens, NC programming, "Subprogram with parameter passing": VAR hands the variable itself.
    add("by reference",
        "%_N_MAIN_MPF\nDEF REAL VALUE1=1\nSUBB(VALUE1)\nG0 X=VALUE1\nM30\n%_N_SUBB_SPF\n"
        "PROC SUBB(VAR REAL RESULT)\nRESULT=5\nM17",
        "5");
    add("by value",
        "%_N_MAIN_MPF\nDEF REAL VALUE1=1\nSUBB(VALUE1)\nG0 X=VALUE1\nM30\n%_N_SUBB_SPF\n"
        "PROC SUBB(REAL RESULT)\nRESULT=5\nM17",
        "1");
    add("element by reference",
        "%_N_MAIN_MPF\nDEF REAL F[3]=SET(1,2,3)\nSUBB(F[1])\nG0 X=F[0]\nX=F[1]\nM30\n"
        "%_N_SUBB_SPF\nPROC SUBB(VAR REAL RESULT)\nRESULT=5\nM17",
        "1 5");
    add("array by reference",
        "%_N_MAIN_MPF\nDEF REAL F[3]=SET(1,2,3)\nSUBB(F)\nG0 X=F[2]\nM30\n%_N_SUBB_SPF\n"
        "PROC SUBB(VAR REAL AA[])\nAA[2]=AA[1]+AA[2]\nM17",
        "5");
    add("array by value",
        "%_N_MAIN_MPF\nDEF REAL F[3]=SET(1,2,3)\nSUBB(F)\nG0 X=F[2]\nM30\n%_N_SUBB_SPF\n"
        "PROC SUBB(REAL AA[3])\nG0 X=AA[0]\nAA[2]=9\nM17",
        "1 3");
    add("reference handed on",
        "%_N_MAIN_MPF\nDEF REAL V\nOUTER(V)\nG0 X=V\nM30\n%_N_OUTER_SPF\n"
        "PROC OUTER(VAR REAL AA)\nINNER(AA)\nM17\n%_N_INNER_SPF\nPROC INNER(VAR REAL BB)\nBB=7\n"
        "M17",
        "7");
    add("reference needs a variable",
        "%_N_MAIN_MPF\nSUBB(3)\nG0 X1\nM30\n%_N_SUBB_SPF\nPROC SUBB(VAR REAL AA)\nM17",
        "1 ! 2:1 error expression-fault the parameter AA is given by reference and needs a "
        "variable");
    add("FOR with a bound that is not known", "DEF INT I\nG0 X0\nFOR I=1 TO R1\nX5\nENDFOR\nX9",
        "0 5 9 ! 3:1 error expression-fault R1 is read before the program sets it: only the "
        "control "
        "knows it");
    add("WHILE with a condition that is not known",
        "G0 X0\nMSG(\"a\")\nWHILE R1<5\nX5\nENDWHILE\nX9",
        "0 5 9 ! 3:1 error expression-fault R1 is read before the program sets it: only the "
        "control "
        "knows it");
    add("jump into a loop",
        "R1=0\nG0 X0\nGOTOF INSIDE\nWHILE R1<2\nX5\nINSIDE: R1=R1+1\nENDWHILE\nX9", "0 5 9");
    add("INT index is rounded", "DEF INT I=1.6\nG0 X=I", "2");
    add("missing subprogram", "MSG(\"a\")\nG0 X0\nPART(3)\nX1",
        "0 1 ! 3:1 error subprogram-missing PART");
    add("ENDIF missing", "MSG(\"a\")\nIF 1==2\nG0 X1",
        "1 ! 2:1 error flow-fault the IF that begins here is not closed");
    add("stray end", "MSG(\"a\")\nG0 X1\nENDLOOP",
        "1 ! 3:1 error flow-fault ENDLOOP has no beginning");
    // ISO
    add("IF GOTO", "#1=1\nG0 X0\nN10 X#1\n#1=#1+1\nIF [#1 LE 3] GOTO 10\nX9", "0 1 2 3 9");
    add("packed", "#1=1\nN10G0X#1\n#1=#1+1\nIF[#1LE3]GOTO10", "1 2 3");
    add("IF THEN", "#1=1\nIF [#1 EQ 1] THEN #2=5\nG0 X#2", "5");
    add("WHILE DO", "#1=0\nG0 X0\nWHILE [#1 LT 2] DO1\n#1=#1+1\nX#1\nEND1\nX9", "0 1 2 9");
    add("WHILE nested",
        "#1=0\nG0 X0\nWHILE [#1 LT 2] DO 1\n#2=0\nWHILE [#2 LT 2] DO 2\n#2=#2+1\n"
        "X[#1*10+#2]\nEND 2\n#1=#1+1\nEND 1",
        "0 1 2 11 12");
    add("M98", "O1\nG0 X0\nM98 P100 L2\nX9\nM30\nO100\nG91 X1\nG90\nM99", "0 1 2 9");
    add("M98 packed", "O1\nG0 X0\nM98 P30100\nX9\nM30\nO0100\nG91 X1\nG90\nM99", "0 1 2 3 9");
    add("G65", "O1\nG0 X0\nG65 P100 A3 X4\nX9\nM30\nO100\nX#1\nX#24\nM99", "0 3 4 9");
    // RS-274/NGC
    add("o if",
        "#1=2\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\no1 else\nG0 X3\no1 endif\n"
        "X9",
        "2 9");
    add("o if first",
        "#1=1\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\no1 else\nG0 X3\n"
        "o1 endif\nX9",
        "1 9");
    add("o while",
        "#1=0\nG0 X0\no1 while [#1 LT 3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\n"
        "o2 endif\nX#1\no1 endwhile",
        "0 1 3");
    add("o do", "#1=0\nG0 X0\no1 do\n#1=[#1+1]\nX#1\no1 while [#1 LT 2]\nX9", "0 1 2 9");
    add("o repeat", "G0 X0\nG91\no1 repeat [3]\nX1\no1 endrepeat\nG90 X9", "0 1 2 3 9");
    add("o break",
        "#1=0\nG0 X0\no1 while [1]\n#1=[#1+1]\no2 if [#1 GT 2]\no1 break\no2 endif\nX#1\n"
        "o1 endwhile\nX9",
        "0 1 2 9");
    add("o call", "o<p> sub\nG0 X#1\nX#2\no<p> endsub\no<p> call [3] [4]\nX9\nM2", "3 4 9");
    add("o call recursive",
        "o1 sub\nG0 X#1\no2 if [#1 GT 0]\no1 call [#1-1]\no2 endif\no1 endsub\n"
        "o1 call [2]",
        "2 1 0");
    add("o nested definition", "o1 sub\no2 sub\no2 endsub\no1 endsub\nG0 X1",
        "1 ! 1:1 error flow-fault a subprogram is defined inside O1");
  }

  void runs() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(course(text.toStdString())), expected);
  }

  /// An endless loop is an error that names its line, and what was read before is kept.
  void endlessLoop() {
    const gcode::Interpretation result =
        interpret("G0 X0 Y0 Z0\nMSG(\"a\")\nLOOP\nR1=1\nENDLOOP\nX5");
    QCOMPARE(QByteArray::fromStdString(test::printProblems(result.diagnostics)),
             QByteArray("5:1 error endless-loop 1"));
    QCOMPARE(result.trajectory.points.size(), std::size_t{1});
    QVERIFY(!result.facts.complete);
  }

  void endlessRecursion() {
    const gcode::Interpretation result =
        interpret("o1 sub\nG21 G0 X1\no1 call\no1 endsub\no1 call\nM2");
    QVERIFY(!result.diagnostics.empty());
    QVERIFY(result.diagnostics.front().severity == gcode::Severity::Error);
  }

  /// In a file of its own a subprogram's points belong to the block that called it.
  void linesOfSubprograms() {
    gcode::LoadOptions options;
    options.subprogram = [](std::string_view name) {
      return name == "PART" ? std::optional(nc::LoadedText{"\n\n\nG0 X1\nX2\nM17\n", "part.spf"})
                            : std::nullopt;
    };
    const auto result = gcode::interpret("MSG(\"a\")\nPART\nG0 X9\n", options);
    QCOMPARE(QByteArray::fromStdString(test::printPoints(result.trajectory)),
             QByteArray("2 R X1 Y? Z? | 2 R X2 Y? Z? | 3 R X9 Y? Z?"));
  }

  /// What is wrong in a called file is found there.
  void findingsOfSubprograms() {
    gcode::LoadOptions options;
    options.subprogram = [](std::string_view name) {
      return name == "PART" ? std::optional(nc::LoadedText{"\nG0 X1 E5\nM17\n", "part.spf"})
                            : std::nullopt;
    };
    const auto result = gcode::interpret("MSG(\"a\")\nPART\nG0 X9 E6\n", options);
    const auto found =
        std::find_if(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const gcode::Diagnostic& diagnostic) {
                       return diagnostic.code == gcode::DiagnosticCode::UnknownWord &&
                              diagnostic.argument == "E5";
                     });
    QVERIFY(found != result.diagnostics.end());
    QCOMPARE(found->file, std::string("part.spf"));
    QCOMPARE(found->line.value, 2U);
    QCOMPARE(found->column, 7);
    QVERIFY(std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                        [](const gcode::Diagnostic& diagnostic) {
                          return diagnostic.argument == "E6" && diagnostic.file.empty() &&
                                 diagnostic.line.value == 3U;
                        }));
  }

  void blockSkip() {
    gcode::LoadOptions options;
    options.blockSkip = true;
    const auto result = gcode::interpret("G0 X0\n/X1\n/2 X2\nX3", options);
    QCOMPARE(QByteArray::fromStdString(test::printPoints(result.trajectory)),
             QByteArray("1 R X0 Y? Z? | 4 R X3 Y? Z?"));
  }
};

RIVULET_TEST(TestFlow)
#include "tst_flow.moc"
