// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What variables, operators and calls mean on each control. F30 is FANUC, Series 30i Operator's
/// Manual B-63944EN, chapter "Custom macro"; H is Haas, Mill Operator's Manual 96-8000, chapter
/// "Macros"; NGC is LinuxCNC, "G-code overview", whose rows were read off `rs274 -g` as well.

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::Dialect;

namespace {

/// X Y Z of every point, and the first error.
std::string course(
    const std::string& text, Dialect dialect,
    const std::function<std::optional<nc::LoadedText>(std::string_view)>& files = {}) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  options.chordToleranceMm = 1000.0;
  options.subprogram = files;
  const gcode::Interpretation result = gcode::interpret(text, options);
  std::string out;
  for (const gcode::TrajectoryPoint& point : result.trajectory.points) {
    out += out.empty() ? "" : " | ";
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double value = point.positionMm[axis];
      out += (axis == 0 ? "" : " ") + (std::isnan(value) ? "?" : base::formatFixed(value, 4));
    }
  }
  for (const gcode::Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.severity == gcode::Severity::Error) {
      return out + " ! " + test::printFindings({diagnostic});
    }
  }
  return out;
}

}  // namespace

class TestMacros : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void means_data() {
    QTest::addColumn<int>("dialect");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](Dialect dialect, const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << static_cast<int>(dialect) << QByteArray(text) << QByteArray(expected);
    };
    const Dialect fanuc = Dialect::Fanuc;
    const Dialect haas = Dialect::Haas;
    const Dialect ngc = Dialect::LinuxCnc;

    // F30 "Undefined variable": an address with one is left out.
    add(fanuc, "vacant arguments",
        "O1\nG0 X0 Y0 Z5\nG65 P2 X20. F300\nG65 P2 Y15. Z40. F300\nM30\nO2\nG1 X#24 Y#25 Z#26 F#9\n"
        "M99",
        "0 0 5 | 20 0 5 | 20 15 40");
    add(fanuc, "vacant common variable", "G0 X5 Y5 Z20\nG1 Z#101 F200", "5 5 20");
    add(fanuc, "vacant with a sign and in brackets", "G0 X5 Y5 Z20\nX-#1 Y[#2] Z7",
        "5 5 20 | 5 5 7");
    add(fanuc, "vacant is 0 in a calculation", "G0 X5 Y5 Z5\nX[#1+1] Y[#2*5] Z[ABS[#3]]",
        "5 5 5 | 1 0 0");
    add(fanuc, "vacant is handed on", "#1=7\n#1=#0\n#2=#1\nG0 X5 Y5 Z5\nX#2 Y3", "5 5 5 | 5 3 5");
    add(fanuc, "vacant as a G function", "G0 X5 Y5 Z5\nG#1 X6", "5 5 5 | 6 5 5");
    add(fanuc, "vacant argument is none", "O1\nG0 X0 Y0 Z0\nG65 P2 X#5 Y6\nM30\nO2\nX#24 Y#25\nM99",
        "0 0 0 | 0 6 0");
    add(fanuc, "0 is not vacant", "#1=0\nG0 X5 Y5 Z5\nIF [#1 EQ #0] GOTO 9\nX6\nN9 Y7",
        "5 5 5 | 6 5 5 | 6 7 5");
    add(fanuc, "vacant is vacant", "G0 X5 Y5 Z5\nIF [#1 EQ #0] GOTO 9\nX6\nN9 Y7", "5 5 5 | 5 7 5");
    add(fanuc, "vacant is not 0", "G0 X5 Y5 Z5\nIF [#1 EQ 0] GOTO 9\nX6\nN9 Y7",
        "5 5 5 | 6 5 5 | 6 7 5");
    add(fanuc, "vacant differs from 0", "G0 X5 Y5 Z5\nIF [#1 NE 0] GOTO 9\nX6\nN9 Y7",
        "5 5 5 | 5 7 5");
    add(fanuc, "vacant is as great as 0", "G0 X5 Y5 Z5\nIF [#1 GE 0] GOTO 9\nX6\nN9 Y7",
        "5 5 5 | 5 7 5");
    add(fanuc, "vacant is not greater than 0", "G0 X5 Y5 Z5\nIF [#1 GT 0] GOTO 9\nX6\nN9 Y7",
        "5 5 5 | 6 5 5 | 6 7 5");
    add(fanuc, "#0 written", "G0 X5 Y5 Z5\n#0=5",
        "5 5 5 ! 2:1 error expression-fault #0 cannot be written by a program here");
    add(haas, "vacant on Haas", "G0 X5 Y5 Z5\nG1 X#1 Y6 F100", "5 5 5 | 5 6 5");

    // F30 "Arithmetic and logic operation".
    add(fanuc, "FIX and FUP", "G0 X[FIX[-1.2]] Y[FUP[-1.2]] Z[FUP[1.2]]", "-1 -2 2");
    add(fanuc, "ROUND in a variable",
        "#1=ROUND[-2.5]\n#2=ROUND[2.4]\n#3=ROUND[2.5]\nG0 X#1 Y#2 Z#3", "-3 2 3");
    // "When the ROUND function is used in an address, it rounds to its least input increment."
    add(fanuc, "ROUND in an address", "#1=1.23456\nG0 X[ROUND[#1]] Y[ROUND[-2.5]] Z0",
        "1.235 -2.5 0");
    add(fanuc, "ROUND in an address in inches", "G20\n#1=1.23456\nG0 X[ROUND[#1]] Y0 Z0",
        "31.3588 0 0");
    add(fanuc, "bits", "G0 X[6 AND 3] Y[6 OR 3] Z[6 XOR 3]", "2 7 5");
    add(fanuc, "ranks", "G0 X[2+3*4] Y[1 OR 2 AND 4] Z[8-4 XOR 1]", "14 1 5");
    add(fanuc, "comparisons rank last", "G0 X0 Y0 Z0\nIF [1+1 EQ 2] GOTO 9\nX5\nN9 Y1",
        "0 0 0 | 0 1 0");
    add(fanuc, "two conditions",
        "#1=1\nG0 X0 Y0 Z0\nIF [[#1 EQ 1] AND [#2 EQ #0]] GOTO 9\nX5\nN9 Y1", "0 0 0 | 0 1 0");
    add(fanuc, "MOD", "G0 X[7 MOD 3] Y[-7 MOD 3] Z[7.4 MOD 2.6]", "1 -1 1");
    add(fanuc, "ATAN", "G0 X[ATAN[1]/[-1]] Y[ATAN[-1]] Z[ATAN[1,1]]", "135 -45 45");
    add(fanuc, "ATAN over a number", "G0 X[ATAN[1]/3] Y0 Z0", "15 0 0");
    add(fanuc, "ASIN and ACOS", "G0 X[ASIN[-0.5]] Y[ACOS[-0.5]] Z[ASIN[0.5]]", "330 120 30");
    add(fanuc, "other functions", "G0 X[POW[2,3]] Y[LN[EXP[2]]] Z[SQRT[16]]", "8 2 4");
    add(fanuc, "BCD", "G0 X[BIN[18]] Y[BCD[12]] Z[RND[1.0004]]", "12 18 1");
    add(fanuc, "indirect", "#1=4\n#5=9\nG0 X#[#1+1] Y[#[#1+1]+1] Z0", "9 10 0");
    add(haas, "Haas", "G0 X[FIX[-1.7]] Y[5 XOR 3] Z[-7 MOD 3]", "-1 6 -1");
    add(haas, "Haas has no FUP", "#1=FUP[1.2]",
        " ! 1:1 error expression-fault FUP is neither a variable nor a function");
    add(ngc, "LinuxCNC", "G0 X[FIX[-1.2]] Y[FUP[-1.2]] Z[ROUND[-2.5]]", "-2 -1 -3");
    add(ngc, "LinuxCNC's logic", "G0 X[6 AND 3] Y[0 OR 3] Z[-7 MOD 3]", "1 1 2");
    add(ngc, "nothing is vacant on LinuxCNC", "G0 X5 Y5 Z5\nX#7", "5 5 5 | 0 5 5");

    // F30 "System variables": not the program's to know.
    add(fanuc, "offset of a tool", "G0 X0 Y0 Z10\nG1 Z[#2001+5.] F100",
        "0 0 10 | 0 0 10 ! 2:4 error expression-fault only the control knows the value of #2001");
    add(fanuc, "machine coordinates", "G0 X0 Y0 Z10\nG1 X#5021 F100",
        "0 0 10 | 0 0 10 ! 2:4 error expression-fault only the control knows the value of #5021");
    add(fanuc, "kept from before", "G0 X0 Y0 Z10\nG1 X#500 F100",
        "0 0 10 | 0 0 10 ! 2:4 error expression-fault only the control knows the value of #500");
    add(fanuc, "kept, but written here", "#500=4\nG0 X#500 Y0 Z0", "4 0 0");
    add(fanuc, "no such variable", "#50=4\nG0 X0 Y0 Z0",
        "0 0 0 ! 1:1 error expression-fault #50 is not a variable");
    add(fanuc, "output", "G0 X0 Y0 Z0\n#1132=1",
        "0 0 0 ! 2:1 error expression-fault #1132 cannot be written by a program here");
    add(fanuc, "modal functions",
        "G90 G0 X1 Y1 Z1\nG91 G1 X1 F100\n#1=#4001\n#3=#4003\nG90 G0 X1\nG#3 G#1 X1 Y1 Z1",
        "1 1 1 | 2 1 1 | 1 1 1 | 2 2 2");
    add(fanuc, "present position", "G0 X3 Y4 Z5\nX[#5001+1] Y[#5002*2] Z#5003", "3 4 5 | 4 8 5");
    add(fanuc, "alarm", "G0 X1 Y1 Z1\n#3000=1(TOOL TOO SHORT)\nX9",
        "1 1 1 ! 2:1 error flow-fault the program stops here with its alarm #3000=1 (TOOL TOO "
        "SHORT)");
    add(fanuc, "alarm on a condition", "G0 X1 Y1 Z1\nIF [1 EQ 1] THEN #3000=7 (NO TOOL)\nX9",
        "1 1 1 ! 2:1 error flow-fault the program stops here with its alarm #3000=7 (NO TOOL)");
    add(fanuc, "alarm not reached", "G0 X1 Y1 Z1\nIF [1 EQ 2] THEN #3000=7 (NO TOOL)\nX9",
        "1 1 1 | 9 1 1");
    add(haas, "saved by Haas", "G0 X0 Y0 Z10\nG1 X#101 F100",
        "0 0 10 | 0 0 10 ! 2:4 error expression-fault only the control knows the value of #101");
    add(haas, "two numbers of one variable", "#100=5\nG0 X#10000 Y0 Z0\n#10500=6\nX#500",
        "5 0 0 | 6 0 0");

    // F30 "Simple call (G65)".
    add(fanuc, "sets of arguments",
        "O1\nG0 X0 Y0 Z0\nG65 P2 A1. I10. J20. K30. I40. J50. K60.\nM30\nO2\nX#4 Y#5 Z#6\nX#7 Y#8 "
        "Z#9\n"
        "M99",
        "0 0 0 | 10 20 30 | 40 50 60");
    add(fanuc, "sets with gaps",
        "O1\nG0 X0 Y0 Z0\nG65 P2 I1 K3 J5\nM30\nO2\nX#4 Y#5 Z#6\nX#7 Y#8\nM99",
        "0 0 0 | 1 0 3 | 1 5 3");
    add(fanuc, "the later one holds",
        "O1\nG0 X0 Y0 Z0\nG65 P2 A1 B2 I-3 I4 D5\nM30\nO2\nX#4 Y#7\nM99", "0 0 0 | -3 5 0");
    add(fanuc, "M is an argument", "O1\nG0 X0 Y0 Z0\nG65 P2 M5\nM30\nO2\nX#13\nM99",
        "0 0 0 | 5 0 0");
    add(fanuc, "levels of local variables",
        "O1\n#1=3\nG0 X0 Y0 Z0\nG65 P2 A7\nX#1\nM98 "
        "P3\nX#1\nM30\nO2\nX#1\n#1=8\nM99\nO3\nY#1\n#1=4\nM99",
        "0 0 0 | 7 0 0 | 3 0 0 | 3 3 0 | 4 3 0");
    add(fanuc, "rounds begin anew", "O1\nG0 X0 Y0 Z0\nG65 P2 L2 A1\nM30\nO2\nX#1\n#1=#1+1\nM99",
        "0 0 0 | 1 0 0 | 1 0 0");
    add(haas, "rounds go on on Haas", "O1\nG0 X0 Y0 Z0\nG65 P2 L2 A1\nM30\nO2\nX#1\n#1=#1+1\nM99",
        "0 0 0 | 1 0 0 | 2 0 0");
    add(fanuc, "arguments before the call", "O1\nG0 X0 Y0 Z0\nX5 G65 P2\nM30\nO2\nX1\nM99",
        "0 0 0 | 1 0 0 ! 3:4 error unsupported-g-code G65");
    add(fanuc, "macro A", "O1\nG0 X0 Y0 Z0\n#101=5\nG65 H2 P#101 Q1 R2\nM30",
        "0 0 0 ! 4:1 error unsupported-g-code G65 H2");
    add(fanuc, "modal call",
        "O1\nG0 X0 Y0 Z9\nG66 P2 Z1.\nX5\nM8\nY5\nG67\nX7\nM30\nO2\nG90 Z#26\nG0 Z9\nM99",
        "0 0 9 | 5 0 9 | 5 0 1 | 5 0 9 | 5 5 9 | 5 5 1 | 5 5 9 | 7 5 9");
    add(fanuc, "modal call within another",
        "O1\nG0 X0 Y0 Z9\nG66 P2\nG66 P3\nM30\nO2\nM99\nO3\nM99",
        "0 0 9 ! 4:1 error unsupported-g-code G66");
    add(fanuc, "each block", "O1\nG0 X0 Y0 Z9\nG66.1 P2\nM30\nO2\nM99",
        "0 0 9 ! 3:1 error unknown-g-code G66.1");

    // Calls and returns.
    add(fanuc, "eight digits", "O1\nG0 X0 Y0 Z0\nM98 P20003\nM30\nO3\nG91 X1\nG90\nM99",
        "0 0 0 | 1 0 0 | 2 0 0");
    add(haas, "five digits of Haas", "O1\nG0 X0 Y0 Z0\nM98 P20003\nM30\nO20003\nX5\nM99",
        "0 0 0 | 5 0 0");
    add(fanuc, "M99 P", "O1\nG0 X0 Y0 Z0\nM98 P2\nX88\nN50 Y5\nM30\nO2\nX1\nM99 P50",
        "0 0 0 | 1 0 0 | 1 5 0");
    add(fanuc, "M99 P ends the rounds",
        "O1\nG0 X0 Y0 Z0\nM98 P2 L3\nX88\nN50 Y5\nM30\nO2\nX1\nM99 P50", "0 0 0 | 1 0 0 | 1 5 0");
    add(fanuc, "M99 P of the main program", "O1\nG0 X0 Y0 Z0\nM99 P50\nX88\nN50 Y5\nM30",
        "0 0 0 | 0 5 0");
    add(haas, "M99 P of Haas",
        "O1\nG0 X0 Y0 Z0\nM98 P2\nX88\nM30\nO2\nX1\nM99 P50\nX2\nN50 Y5\nM99",
        "0 0 0 | 1 0 0 | 1 5 0 | 88 5 0");
    add(haas, "M97", "O1\nG0 X0 Y0 Z0\nM97 P50 L2\nX9\nM30\nN50 G91 X1\nG90\nM99",
        "0 0 0 | 1 0 0 | 2 0 0 | 9 0 0");
    add(fanuc, "M97 is of Haas", "O1\nG0 X0 Y0 Z0\nM97 P50\nM30\nN50 X1\nM99",
        "0 0 0 ! 3:1 error unsupported-g-code M97");
    add(fanuc, "M99 P without its block", "O1\nG0 X0 Y0 Z0\nM98 P2\nX8\nM30\nO2\nX1\nM99 P50",
        "0 0 0 | 1 0 0 | 8 0 0 ! 8:1 error flow-fault the target N50 is missing");
    add(fanuc, "GOTO by a value", "#1=20\nG0 X0 Y0 Z0\nGOTO #1\nX5\nN20 Y1", "0 0 0 | 0 1 0");
    add(fanuc, "GOTO goes forward first",
        "G0 X0 Y0 Z0\nN10 X1\nIF [#2 EQ 1] GOTO 99\n#2=1\nGOTO 10\nX5\nN10 X7\nN99 Z9",
        "0 0 0 | 1 0 0 | 7 0 0 | 7 0 9");

    // NGC "Numbered Parameters": after all values of the line have been found.
    add(ngc, "assignment in a block", "#3=15\nG0 X0 Y0 Z0\n#3=6 G1 X#3 F100\nX#3",
        "0 0 0 | 15 0 0 | 6 0 0");
    add(ngc, "assignments of a block", "#1=1 #2=2\n#1=#2 #2=#1\nG0 X#1 Y#2 Z0", "2 1 0");
    add(ngc, "index of an assignment", "#1=5\n#1=6 #[#1]=7\nG0 X#5 Y#6 Z0", "7 0 0");
    add(ngc, "named", "#<a>=1\n#<a>=2 G0 X#<a> Y0 Z0\nX#<a>", "1 0 0 | 2 0 0");
    add(ngc, "locals", "o1 sub\n#31=5\n#30=6\no1 endsub\n#30=1\no1 call\nG0 X#30 Y#31 Z0\nM2",
        "1 5 0");
    // What a call brings back: NC Programming (6FC5398-2EP40-0BA0), "SAVE"; LinuxCNC, M70 to M73.
    const Dialect sinumerik = Dialect::Sinumerik;
    add(sinumerik, "PROC SAVE",
        "%_N_MAIN_MPF\nG90 G17 G710 G94\nG0 X0 Y0 Z0\nG1 X10 F500\nSTEPS\nG1 X20\nY5\nM30\n"
        "%_N_STEPS_SPF\nPROC STEPS SAVE\nG91 G19\nTRANS X100\nG1 Y1\nM17",
        "0 0 0 | 10 0 0 | 10 1 0 | 20 1 0 | 20 5 0");
    add(sinumerik, "PROC SAVE with parameters, left by its end",
        "%_N_MAIN_MPF\nG90 G0 X0 Y0 Z0\nSTEPS(3)\nX20\nM30\n"
        "%_N_STEPS_SPF\nPROC STEPS(REAL A) SAVE DISPLOF\nG91 X=A\n",
        "0 0 0 | 3 0 0 | 20 0 0");
    add(sinumerik, "PROC without SAVE",
        "%_N_MAIN_MPF\nG90 G0 X0 Y0 Z0\nSTEPS\nX20\nM30\n%_N_STEPS_SPF\nPROC STEPS\nG91 X3\nM17",
        "0 0 0 | 3 0 0 | 23 0 0");
    add(sinumerik, "SAVE within a call without it",
        "%_N_MAIN_MPF\nG90 G0 X0 Y0 Z0\nAA\nX20\nM30\n%_N_AA_SPF\nG91\nBB\nX1\nM17\n"
        "%_N_BB_SPF\nPROC BB SAVE\nG90 X5\nM17",
        "0 0 0 | 5 0 0 | 6 0 0 | 26 0 0");
    add(ngc, "M70 and M72",
        "G21 G90 G17\nG0 X10 Y0 Z5\no100 call\nG1 X20 F300\nM2\no100 sub\nM70\nG91 G20\nG1 Y1 F10\n"
        "M72\no100 endsub",
        "10 0 5 | 10 25.4 5 | 20 25.4 5");
    add(ngc, "M73",
        "G21 G90 G17\nG0 X10 Y0 Z5\no100 call\nG0 X20\nM2\no100 sub\nM73\nG91\nG0 Y1\no100 endsub",
        "10 0 5 | 10 1 5 | 20 1 5");
    add(fanuc, "nothing modal is brought back",
        "O1\nG90 G0 X0 Y0 Z0\nM98 P2\nX5\nM30\nO2\nG91 X1\nM99", "0 0 0 | 1 0 0 | 6 0 0");
    add(fanuc, "assignments one after another", "#1=1\n#2=2\n#1=#2\n#2=#1\nG0 X#1 Y#2 Z0", "2 2 0");
  }

  void means() {
    QFETCH(const int, dialect);
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(course(text.toStdString(), static_cast<Dialect>(dialect))),
             expected);
  }

  /// A macro in a file of its own is found by its number, whatever the file is called.
  void filesBeside() {
    for (const char* name : {"3001.nc", "O3001", "o3001.NC", "O03001.tap", "3001"}) {
      const QTemporaryDir folder;
      const auto write = [&folder](const char* file, const char* text) {
        std::ofstream(folder.filePath(QLatin1String(file)).toStdString()) << text;
      };
      write("main.nc", "%\nO1\nG0 X0 Y0 Z0\nG65 P3001 X5\nX9\nM30\n%");
      write(name, "%\nO3001 (MACRO)\nG0 X#24\nM99\n%");
      write("3002.nc", "G0 X77");
      gcode::LoadOptions options;
      options.dialect = Dialect::Fanuc;
      const auto program =
          gcode::loadProgram(folder.filePath(QStringLiteral("main.nc")).toStdString(), options);
      QVERIFY2(program && program->isUnderstood(), name);
      QCOMPARE(program->trajectory.points.size(), std::size_t{3});
      QCOMPARE(program->trajectory.points[1].positionMm.x, 5.0);
    }
  }

  /// What would take memory or time without end is one sentence.
  void limits_data() {
    QTest::addColumn<int>("dialect");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("code");
    const auto add = [](const char* name, Dialect dialect, const std::string& text,
                        const char* code) {
      QTest::newRow(name) << static_cast<int>(dialect) << QByteArray::fromStdString(text)
                          << QByteArray(code);
    };
    add("counts for ever", Dialect::Fanuc, "G0 X0\n#1=0\nWHILE [1 EQ 1] DO1\n#1=#1+1\nM8\nEND1",
        "endless-loop");
    add("moves for ever", Dialect::Fanuc, "G0 X0 Y0 Z0\n#1=0\nN1 #1=#1+1\nG91 X0.001\nGOTO 1",
        "endless-loop");
    add("calls itself", Dialect::Fanuc, "O1\nG0 X0\nM98 P1\nM30", "flow-fault");
    add("calls each other", Dialect::LinuxCnc,
        "o1 sub\no2 call\no1 endsub\no2 sub\no1 call\no2 endsub\no1 call\nM2", "flow-fault");
    add("calls each other often", Dialect::Fanuc,
        "O1\nG0 X0\nM98 P2 L9999\nM30\nO2\nM98 P3 L9999\nM99\nO3\nM98 P4 L9999\nM99\nO4\nM8\nM99",
        "endless-loop");
    add("variables by number", Dialect::LinuxCnc,
        "#1=100\no1 while [1]\n#[#1]=#1\n#1=[#1+1]\no1 endwhile", "expression-fault");
    add("variables of an array", Dialect::Sinumerik,
        "DEF REAL A[1000,99]\nDEF REAL B[1000,99]\nG0 X1", "expression-fault");
    std::string names;
    for (int i = 0; i < 100'001; ++i) {
      names += "#<v" + std::to_string(i) + ">=1\n";
    }
    add("variables by name", Dialect::LinuxCnc, names, "expression-fault");
  }
  void limits() {
    QFETCH(const int, dialect);
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, code);
    gcode::LoadOptions options;
    options.dialect = static_cast<Dialect>(dialect);
    options.repeatedLinesMax = 200'000;
    const auto result = gcode::interpret(text.toStdString(), options);
    const auto first =
        std::find_if(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const auto& each) { return each.severity == gcode::Severity::Error; });
    QVERIFY(first != result.diagnostics.end());
    QCOMPARE(QByteArray::fromStdString(std::string(gcode::diagnosticName(first->code))), code);
  }
};

RIVULET_TEST(TestMacros)
#include "tst_macros.moc"
