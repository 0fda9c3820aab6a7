// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What plain text of a TNC moves. The points are worked out by hand from the TNC 640 User's Manuals
// Conversational Programming and Cycle Programming; each case names the chapter it follows.

#include <QtTest>
#include <string>

#include "gcode/interpreter.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

/// A whole program around the blocks. The first of them is line 3.
std::string program(const std::string& blocks) {
  return "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\n" + blocks + "END PGM A MM\n";
}

gcode::Interpretation interpret(const std::string& text) {
  gcode::LoadOptions options;
  options.keepArcs = true;
  options.dialect = gcode::Dialect::Heidenhain;
  return gcode::interpret(text, options);
}

/// A cycle with all the parameters of Cycle 200.
const char* const kDrilling =
    "CYCL DEF 200 DRILLING ~\n Q200=2 ;SET-UP CLEARANCE ~\n Q201=-20 ;DEPTH ~\n Q206=150 ;FEED ~\n"
    " Q202=8 ;PECK ~\n Q210=0 ;DWELL TIME ~\n Q203=+0 ;SURFACE ~\n Q204=50 ;2ND CLEARANCE ~\n"
    " Q211=0 ;DWELL\n";
/// One stroke, so that the order of the holes shows.
const char* const kOneStroke =
    "CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=+0 Q204=20 Q211=0\n";

}  // namespace

#define COMPARE_TEXT(actual, expected) \
  QCOMPARE(QByteArray::fromStdString(actual), QByteArray(expected))

class TestHeidenhain : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void paths_data() {
    QTest::addColumn<QByteArray>("blocks");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const std::string& blocks, const char* expected) {
      QTest::newRow(name) << QByteArray::fromStdString(blocks) << QByteArray(expected);
    };

    // "Programming contours"
    add("a comma or a point, increments, FMAX of one block",
        "L X+1,5 Y+2.5 Z+3 R0 FMAX\nL X+10 F500\nL IX-2 Y+0 FMAX\nL X0\n",
        "3 R X1.5 Y2.5 Z3 | 4 L X10 Y2.5 Z3 F500 | 5 R X8 Y0 Z3 | 6 L X0 Y0 Z3 F500");
    add("FAUTO is the feed of the tool call",
        "TOOL CALL 2 Z S1000 F300\nL X+0 Y+0 FMAX\nL X+1 F100\nL X+2 FAUTO\n",
        "4 R X0 Y0 Z? | 5 L X1 Y0 Z? F100 | 6 L X2 Y0 Z? F300");
    add("an arc about the centre",
        "L X+5 Y+0 Z+0 FMAX\nCC X+0 Y+0\nC X+0 Y+5 DR+ F100\nCC IX+0 IY-5\nC X+5 Y+0 DR-\n",
        "3 R X5 Y0 Z0 | 5 A X0 Y5 Z0 F100 | 7 A X5 Y0 Z0 F100");
    add("a line and an arc in polar coordinates",
        "L X+0 Y+0 Z+0 FMAX\nCC X+10 Y+0\nLP PR+5 PA+90 F100\nLP IPA+90\nCP PA-90 DR+\n"
        "CP IPA-90 DR-\n",
        "3 R X0 Y0 Z0 | 5 L X10 Y5 Z0 F100 | 6 L X5 Y0 Z0 F100 | 7 A X10 Y-5 Z0 F100 | "
        "8 A X5 Y0 Z0 F100");
    add("a helix of a turn and a half",
        "L X+10 Y+0 Z+0 FMAX\nCC X+0 Y+0\nCP IPA+540 IZ-3 DR+ F100\n",
        "3 R X10 Y0 Z0 | 5 A X-10 Y0 Z-3 F100");
    add("an arc in the plane of its centre",
        "L X+0 Y+0 Z+0 FMAX\nCC Y+0 Z+5\nCP IPA+90 DR+ F100\nL X+10\nCC Z+5 X+15\n"
        "C Z+10 X+15 DR+\n",
        "3 R X0 Y0 Z0 | 5 A X0 Y5 Z5 F100 | 6 L X10 Y5 Z5 F100 | 8 A X15 Y5 Z10 F100");
    add("a tangential arc", "L X+0 Y+0 Z+0 FMAX\nL X+10 F100\nCT X+20 Y+10\nCT X+10 Y+20\n",
        "3 R X0 Y0 Z0 | 4 L X10 Y0 Z0 F100 | 5 A X20 Y10 Z0 F100 | 6 A X10 Y20 Z0 F100");
    // Corners: the round one begins and ends its radius away from a right angle.
    add("a rounded corner with its own feed",
        "L X+0 Y+0 Z+0 FMAX\nL X+20 F500\nRND R5 F200\nL Y+30\nL X+0\n",
        "3 R X0 Y0 Z0 | 4 L X15 Y0 Z0 F500 | 5 A X20 Y5 Z0 F200 | 6 L X20 Y30 Z0 F500 | "
        "7 L X0 Y30 Z0 F500");
    add("a chamfer", "L X+0 Y+0 Z+0 FMAX\nL X+20 F500\nCHF 4\nL Y+30\n",
        "3 R X0 Y0 Z0 | 4 L X16 Y0 Z0 F500 | 5 L X20 Y4 Z0 F500 | 6 L X20 Y30 Z0 F500");
    // The rounding lies to the left of both: its centre is 5 above the line and 25 from (40, 0).
    add("a corner between a line and an arc",
        "L X+0 Y+0 Z+0 FMAX\nL X+20 F100\nRND R5\nCC X+40 Y+0\nC X+40 Y+20 DR-\n",
        "3 R X0 Y0 Z0 | 4 L X15.505103 Y0 Z0 F100 | 5 A X20.404082 Y4 Z0 F100 | "
        "7 A X40 Y20 Z0 F100");

    // "Programming Q parameters"
    add("a formula with functions",
        "Q1 = 10\nQ2 = SIN 30 * ( Q1 + 1,5 )\nQL3 = SQRT 16 - 2 ^ 3\nQR4 = INT 2,9 + FRAC 2,5\n"
        "L X+Q2 Y-QL3 Z+QR4 FMAX\n",
        "7 R X5.75 Y4 Z2.5");
    add("the first functions",
        "FN 0: Q1 = +60\nFN 1: Q2 = -Q1 + -5\nFN 2: Q3 = +10 - +4\nFN 3: Q4 = +3 * +3\n"
        "FN 4: Q5 = +8 DIV +2\nFN 5: Q6 = SQRT 49\nFN 6: Q7 = SIN -90\nFN 7: Q8 = COS +180\n"
        "FN 8: Q9 = +3 LEN +4\nFN 13: Q10 = +1 ANG -1\nL X+Q2 Y+Q3 Z+Q4 FMAX\n"
        "L X+Q5 Y+Q6 Z+Q7\nL X+Q8 Y+Q9 Z+Q10\n",
        "13 R X-65 Y6 Z9 | 14 L X4 Y7 Z-1 | 15 L X-1 Y5 Z135");
    add("jumps by comparison",
        "Q1 = 0\nLBL \"AGAIN\"\nQ1 = Q1 + 1\nL X+Q1 Y+0 Z+0 FMAX\n"
        "FN 12: IF +Q1 LT +3 GOTO LBL \"AGAIN\"\nFN 9: IF +Q1 EQU +3 GOTO LBL 7\nL X+99 FMAX\n"
        "LBL 7\nFN 10: IF +Q1 NE +3 GOTO LBL 8\nL Y+1 FMAX\nLBL 8\n"
        "FN 11: IF +Q1 GT +2 GOTO LBL 9\nL X+99 FMAX\nLBL 9\n",
        "6 R X1 Y0 Z0 | 6 R X2 Y0 Z0 | 6 R X3 Y0 Z0 | 12 R X3 Y1 Z0");

    // "Programming: Subprograms and program section repeats"
    add("a section is repeated so many times more",
        "L X+0 Y+0 Z+0 FMAX\nLBL 1\nL IX+1 FMAX\nCALL LBL 1 REP 2\nL Y+1 FMAX\n",
        "3 R X0 Y0 Z0 | 5 R X1 Y0 Z0 | 5 R X2 Y0 Z0 | 5 R X3 Y0 Z0 | 7 R X3 Y1 Z0");
    add("a repeat within a repeat",
        "L X+0 Y+0 Z+0 FMAX\nLBL 1\nLBL 2\nL IX+1 FMAX\nCALL LBL 2 REP 1/1\nL IY+1 FMAX\n"
        "CALL LBL 1 REP1\n",
        "3 R X0 Y0 Z0 | 6 R X1 Y0 Z0 | 6 R X2 Y0 Z0 | 8 R X2 Y1 Z0 | 6 R X3 Y1 Z0 | "
        "6 R X4 Y1 Z0 | 8 R X4 Y2 Z0");
    add("subprograms call each other, with their name",
        "L X+0 Y+0 Z+0 FMAX\nCALL LBL \"side\"\nL Z+5 FMAX\nL M30\nLBL \"side\"\nL IX+1 FMAX\n"
        "CALL LBL 3\nLBL 0\nLBL 3\nL IY+1 FMAX\nLBL 0\n",
        "3 R X0 Y0 Z0 | 8 R X1 Y0 Z0 | 12 R X1 Y1 Z0 | 5 R X1 Y1 Z5");
    add("LBL 0 without a call does nothing",
        "L X+0 Y+0 Z+0 FMAX\nLBL 1\nL X+1 FMAX\nLBL 0\nL X+2\n",
        "3 R X0 Y0 Z0 | 5 R X1 Y0 Z0 | 7 L X2 Y0 Z0");

    // "Cycles: Coordinate Transformations"
    add("a datum shift, more of it, and back",
        "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+100\nCYCL DEF 7.2 Y+50\nL X+0 Y+0 Z+0 FMAX\n"
        "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 IX+10\nL X+1 FMAX\nL IX+1 FMAX\n"
        "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nL X+0 Y+0 FMAX\n",
        "6 R X100 Y50 Z0 | 9 R X111 Y50 Z0 | 10 R X112 Y50 Z0 | 14 R X0 Y0 Z0");
    add("a mirror image turns arcs round",
        "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 X\nL X+5 Y+0 Z+0 FMAX\nCC X+0 Y+0\n"
        "C X+0 Y+5 DR+ F100\nCYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1\nL X+5\n",
        "5 R X-5 Y0 Z0 | 7 A X0 Y5 Z0 F100 | 10 L X5 Y5 Z0 F100");
    add("a rotation about the shifted datum, more of it, and back",
        "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 10.0 ROTATION\n"
        "CYCL DEF 10.1 ROT+90\nL X+5 Y+0 Z+0 FMAX\nCYCL DEF 10.0 ROTATION\n"
        "CYCL DEF 10.1 IROT+90\nL X+5 Y+0 FMAX\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0\n"
        "L X+5 Y+0 FMAX\n",
        "7 R X10 Y5 Z0 | 10 R X5 Y0 Z0 | 13 R X15 Y0 Z0");
    add("scaling", "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0,5\nL X+10 Y+4 Z+2 FMAX\n",
        "5 R X5 Y2 Z1");

    // "Fixed Cycles: Drilling"
    add("200 in three pecks, called by M99",
        kDrilling + std::string("L X+10 Y+5 Z+60 FMAX M99\nL X+0 FMAX\n"),
        "12 R X10 Y5 Z60 | 12 R X10 Y5 Z2 | 12 L X10 Y5 Z-8 F150 | 12 R X10 Y5 Z2 | "
        "12 R X10 Y5 Z-6 | 12 L X10 Y5 Z-16 F150 | 12 R X10 Y5 Z2 | 12 R X10 Y5 Z-14 | "
        "12 L X10 Y5 Z-20 F150 | 12 R X10 Y5 Z2 | 12 R X10 Y5 Z50 | 13 R X0 Y5 Z50");
    add("modal by M89, until M99",
        kOneStroke +
            std::string("L X+0 Y+0 Z+9 FMAX\nL X+1 FMAX M89\nL X+2 FMAX M99\nL X+3 FMAX\n"),
        "4 R X0 Y0 Z9 | 5 R X1 Y0 Z9 | 5 R X1 Y0 Z2 | 5 L X1 Y0 Z-5 F100 | 5 R X1 Y0 Z2 | "
        "5 R X1 Y0 Z20 | 6 R X2 Y0 Z20 | 6 R X2 Y0 Z2 | 6 L X2 Y0 Z-5 F100 | 6 R X2 Y0 Z2 | "
        "6 R X2 Y0 Z20 | 7 R X3 Y0 Z20");
    add("the place of a call shifts the surface",
        kOneStroke + std::string("L X+0 Y+0 Z+30 FMAX\nCYCL CALL POS X+5 Y+6 Z+10 FMAX\n"),
        "4 R X0 Y0 Z30 | 5 R X5 Y6 Z30 | 5 R X5 Y6 Z12 | 5 L X5 Y6 Z5 F100 | 5 R X5 Y6 Z12 | "
        "5 R X5 Y6 Z30");
    add("201 returns at its own feed",
        "CYCL DEF 201 REAMING Q200=2 Q201=-15 Q206=100 Q211=0 Q208=250 Q203=+3 Q204=10\n"
        "L X+0 Y+0 Z+20 FMAX\nCYCL CALL\n",
        "4 R X0 Y0 Z20 | 5 R X0 Y0 Z5 | 5 L X0 Y0 Z-12 F100 | 5 L X0 Y0 Z5 F250 | 5 R X0 Y0 Z13");
    add("203: smaller and smaller, with a break of the chip in between",
        "CYCL DEF 203 UNIVERSAL DRILLING Q200=2 Q201=-20 Q206=150 Q202=8 Q210=0 Q203=+0 Q204=2 "
        "Q212=2 Q213=1 Q205=3 Q211=0 Q208=500 Q256=0,2\nL X+0 Y+0 Z+2 FMAX\nCYCL CALL\n",
        "4 R X0 Y0 Z2 | 5 L X0 Y0 Z-8 F150 | 5 L X0 Y0 Z-7.8 F500 | 5 L X0 Y0 Z-14 F150 | "
        "5 L X0 Y0 Z2 F500 | 5 R X0 Y0 Z-12 | 5 L X0 Y0 Z-18 F150 | 5 L X0 Y0 Z-17.8 F500 | "
        "5 L X0 Y0 Z-20 F150 | 5 L X0 Y0 Z2 F500");
    add("205: chips are broken within a peck",
        "CYCL DEF 205 UNIVERSAL PECKING Q200=2 Q201=-12 Q206=150 Q202=8 Q203=+0 Q204=2 Q212=0 "
        "Q205=0 Q258=0,5 Q259=0,5 Q257=5 Q256=0,2 Q211=0\nL X+0 Y+0 Z+2 FMAX\nCYCL CALL\n",
        "4 R X0 Y0 Z2 | 5 L X0 Y0 Z-5 F150 | 5 R X0 Y0 Z-4.8 | 5 L X0 Y0 Z-8 F150 | 5 R X0 Y0 Z2 | "
        "5 R X0 Y0 Z-7.5 | 5 L X0 Y0 Z-12 F150 | 5 R X0 Y0 Z2");
    add("240",
        "CYCL DEF 240 CENTERING Q200=2 Q343=0 Q201=-2 Q344=-10 Q206=80 Q211=0 Q203=+0 Q204=5\n"
        "L X+0 Y+0 Z+2 FMAX\nCYCL CALL\n",
        "4 R X0 Y0 Z2 | 5 L X0 Y0 Z-2 F80 | 5 R X0 Y0 Z2 | 5 R X0 Y0 Z5");
    // The old pecking begins 0.6 mm above the last depth.
    add("1 pecking, from where the tool stands",
        "CYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\nCYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG "
        "5\n"
        "CYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F300\nL X+0 Y+0 Z+2 FMAX\nCYCL CALL M8\n",
        "9 R X0 Y0 Z2 | 10 L X0 Y0 Z-5 F300 | 10 R X0 Y0 Z2 | 10 R X0 Y0 Z-4.4 | "
        "10 L X0 Y0 Z-10 F300 | 10 R X0 Y0 Z2");
    add("a cycle in turned coordinates",
        kOneStroke +
            std::string("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+90\nL X+7 Y+0 Z+20 FMAX M99\n"),
        "6 R X0 Y7 Z20 | 6 R X0 Y7 Z2 | 6 L X0 Y7 Z-5 F100 | 6 R X0 Y7 Z2 | 6 R X0 Y7 Z20");

    // "Pattern Definitions"
    add("220: four holes on a circle, at the set-up clearance in between",
        kOneStroke +
            std::string("L X+0 Y+0 Z+20 FMAX\nCYCL DEF 220 POLAR PATTERN Q216=+50 Q217=+0 Q244=20 "
                        "Q245=+0 Q246=+360 Q247=+0 Q241=4 Q200=3 Q203=+1 Q204=10 Q301=0 Q365=0\n"),
        "4 R X0 Y0 Z20 | 5 R X0 Y0 Z11 | 5 R X60 Y0 Z11 | 5 R X60 Y0 Z4 | 5 L X60 Y0 Z-4 F100 | "
        "5 R X60 Y0 Z4 | 5 R X50 Y10 Z4 | 5 L X50 Y10 Z-4 F100 | 5 R X50 Y10 Z4 | "
        "5 R X40 Y0 Z4 | 5 L X40 Y0 Z-4 F100 | 5 R X40 Y0 Z4 | 5 R X50 Y-10 Z4 | "
        "5 L X50 Y-10 Z-4 F100 | 5 R X50 Y-10 Z4 | 5 R X50 Y-10 Z11");
    add("221: back and forth",
        kOneStroke +
            std::string("L X+0 Y+0 Z+20 FMAX\nCYCL DEF 221 CARTESIAN PATTERN Q225=+10 Q226=+10 "
                        "Q237=+5 Q238=+3 Q242=2 Q243=2 Q224=+0 Q200=2 Q203=+0 Q204=4 Q301=1\n"),
        "4 R X0 Y0 Z20 | 5 R X0 Y0 Z4 | 5 R X10 Y10 Z4 | 5 R X10 Y10 Z2 | 5 L X10 Y10 Z-5 F100 | "
        "5 R X10 Y10 Z2 | 5 R X10 Y10 Z4 | 5 R X15 Y10 Z4 | 5 R X15 Y10 Z2 | "
        "5 L X15 Y10 Z-5 F100 | 5 R X15 Y10 Z2 | 5 R X15 Y10 Z4 | 5 R X15 Y13 Z4 | "
        "5 R X15 Y13 Z2 | 5 L X15 Y13 Z-5 F100 | 5 R X15 Y13 Z2 | 5 R X15 Y13 Z4 | "
        "5 R X10 Y13 Z4 | 5 R X10 Y13 Z2 | 5 L X10 Y13 Z-5 F100 | 5 R X10 Y13 Z2 | "
        "5 R X10 Y13 Z4");

    add("a pattern that is defined by itself",
        kOneStroke +
            std::string("PATTERN DEF ~\n POS1 (X+5 Y+6 Z+0) ~\n ROW1 (X+10 Y+0 D+3 NUM2 ROT+90 "
                        "Z+1)\nL X+0 Y+0 Z+10 FMAX\nCYCL CALL PAT FMAX M3\n"),
        "7 R X0 Y0 Z10 | 8 R X0 Y0 Z20 | 8 R X5 Y6 Z20 | 8 R X5 Y6 Z2 | 8 L X5 Y6 Z-5 F100 | "
        "8 R X5 Y6 Z2 | 8 R X5 Y6 Z20 | 8 R X5 Y6 Z21 | 8 R X10 Y0 Z21 | 8 R X10 Y0 Z3 | "
        "8 L X10 Y0 Z-4 F100 | 8 R X10 Y0 Z3 | 8 R X10 Y0 Z21 | 8 R X10 Y3 Z21 | "
        "8 R X10 Y3 Z3 | 8 L X10 Y3 Z-4 F100 | 8 R X10 Y3 Z3 | 8 R X10 Y3 Z21");

    // "Approaching and departing a contour": LEN lies before the first point, in the direction of
    // the first element.
    add("on a straight line, and off on one",
        "L X-20 Y+5 Z-5 FMAX\nAPPR LT X+10 Y+0 LEN15 R0 F100\nL X+30\nDEP LT LEN5 F200\n"
        "L Z+50 FMAX\n",
        "3 R X-20 Y5 Z-5 | 4 R X-5 Y0 Z-5 | 4 L X10 Y0 Z-5 F100 | 5 L X30 Y0 Z-5 F100 | "
        "6 L X35 Y0 Z-5 F200 | 7 R X35 Y0 Z50");

    // "Tools"
    add("the working plane lies across the tool axis",
        "TOOL CALL 1 Y S100\nL X+0 Y+20 Z+0 FMAX\nCC X+0 Z+10\nC X+10 Z+10 DR+ F50\n",
        "4 R X0 Y20 Z0 | 6 A X10 Y20 Z10 F50");
    add("a longer tool stands higher", "TOOL CALL 1 Z S100 DL+0,5\nL X+0 Y+0 Z+0 FMAX\n",
        "4 R X0 Y0 Z0.5");
  }
  void paths() {
    QFETCH(const QByteArray, blocks);
    QFETCH(const QByteArray, expected);
    const gcode::Interpretation read = interpret(program(blocks.toStdString()));
    COMPARE_TEXT(test::printPoints(read.trajectory), expected);
    for (const gcode::Diagnostic& each : read.diagnostics) {
      QVERIFY2(each.severity != gcode::Severity::Error, gcode::describe(each).c_str());
    }
  }

  void feedInInches() {
    // 100 tenths of an inch per minute.
    const gcode::Interpretation read =
        interpret("BEGIN PGM A INCH\nL X+0 Y+0 Z+1 FMAX\nL X+2 F100\nEND PGM A INCH\n");
    COMPARE_TEXT(test::printPoints(read.trajectory), "2 R X0 Y0 Z25.4 | 3 L X50.8 Y0 Z25.4 F254");
  }

  /// What cannot be honoured stops by name, and what follows does not start from a wrong place.
  void refused_data() {
    QTest::addColumn<QByteArray>("blocks");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const std::string& blocks, const char* expected) {
      QTest::newRow(name) << QByteArray::fromStdString(blocks) << QByteArray(expected);
    };
    add("an unset parameter", "L X+Q7 Y+0 Z+0 FMAX\n", "3:5 error expression-fault");
    add("a value of the control", "L X+Q108 Y+0 FMAX\n", "3:5 error expression-fault");
    add("an error of the program", "FN 14: ERROR = 1005\n", "3:20 error stops-with-error");
    add("a loop without an end", "LBL 1\nL X+1 FMAX\nFN 9: IF +0 EQU +0 GOTO LBL 1\n",
        "5:1 error endless-loop");
    add("a label that is missing", "CALL LBL 9\n", "3:1 error flow-fault");
    add("a corner without room", "L X+0 Y+0 Z+0 FMAX\nL X+4 F100\nRND R5\nL Y+30\n",
        "5:1 error corner-malformed");
    add("a corner before a move of the tool axis",
        "L X+0 Y+0 Z+0 FMAX\nL X+4 F100\nRND R1\nL Z+30\n", "5:1 error corner-malformed");
    add("a datum of the table", "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #5\n",
        "4:1 error unsupported-g-code");
    add("a shift behind a rotation",
        "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30\nCYCL DEF 7.0 DATUM SHIFT\n"
        "CYCL DEF 7.1 X+10\n",
        "6:1 error unsupported-g-code");
    add("a tilted plane", "PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n",
        "3:1 error unsupported-g-code");
    add("the old tilted plane", "CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A+30\n",
        "4:1 error unsupported-g-code");
    add("a cycle that is not made", "CYCL DEF 22 ROUGH-OUT Q10=-5 Q11=100\nCYCL CALL\n",
        "4:1 error cycle-not-run");
    add("no cycle at all", "CYCL CALL\n", "3:1 error cycle-not-run");
    add("a parameter of a cycle is missing",
        "CYCL DEF 200 DRILLING Q200=2 Q201=-20\nL X+0 Y+0 Z+9 FMAX\nCYCL CALL\n",
        "5:1 error expression-fault");
    add("a feed that needs the teeth of the tool", "L X+0 Y+0 FZ0.1\n",
        "3:12 error unsupported-g-code");
    add("a word that nobody knows", "L X+0 Y+0 FMAX\nSPLINE X+1\n", "4:1 error unsupported-g-code");
    add("the tip of the tool", "M128\n", "3:1 error unsupported-g-code M128");
    add("the feed of plunging", "L X+0 Y+0 F500 M103 F20\n", "3:20 error unsupported-g-code M103");
    add("the datum of the machine's builder", "L X+0 FMAX M92\n",
        "3:3 error unsupported-g-code M92");
    add("another preset in mid-program",
        "CYCL DEF 247 PRESETTING Q339=+1\nL X+0 FMAX\nCYCL DEF 247 PRESETTING Q339=+2\n",
        "5:1 error unsupported-g-code CYCL DEF 247");
    add("an arc in rapid", "L X+5 Y+0 FMAX\nCC X+0 Y+0\nC X+0 Y+5 DR+ FMAX\n",
        "5:3 error unsupported-g-code");
    add("an increment from where only the control knows", "L IX+5 FMAX\n",
        "3:3 error expression-fault");
  }
  void refused() {
    QFETCH(const QByteArray, blocks);
    QFETCH(const QByteArray, expected);
    const gcode::Interpretation read = interpret(program(blocks.toStdString()));
    std::vector<gcode::Diagnostic> errors;
    for (const gcode::Diagnostic& each : read.diagnostics) {
      if (each.severity == gcode::Severity::Error) {
        errors.push_back(each);
      }
    }
    const std::string found = test::printProblems(errors);
    QVERIFY2(found.starts_with(expected.toStdString()), found.c_str());
  }

  /// The program file calls another one: its parameters are shared, its labels and QL are its own.
  void callsAProgram() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Heidenhain;
    options.subprogram = [](std::string_view name) -> std::optional<nc::LoadedText> {
      if (name != "HOLE") {
        return std::nullopt;
      }
      return nc::LoadedText{
          "BEGIN PGM HOLE MM\nQL1 = 7\nLBL 1\nL Z-Q5 F100\nCALL LBL 1 REP 1\nL X+QL1\n"
          "END PGM HOLE MM\n",
          "HOLE.H"};
    };
    const gcode::Interpretation read = gcode::interpret(
        program("QL1 = 3\nQ5 = 2\nL X+0 Y+0 Z+0 FMAX\nCALL PGM TNC:\\NC\\HOLE.H\nL X+QL1 FMAX\n"),
        options);
    COMPARE_TEXT(test::printProblems(read.diagnostics), "");
    COMPARE_TEXT(test::printPoints(read.trajectory),
                 "5 R X0 Y0 Z0 | 6 L X0 Y0 Z-2 F100 | 6 L X0 Y0 Z-2 F100 | 6 L X7 Y0 Z-2 F100 | "
                 "7 R X3 Y0 Z-2");
  }

  /// Plain text is read with and without block numbers, "~", structure and comments.
  void spellings() {
    const gcode::Interpretation read = interpret(
        "0  BEGIN PGM A MM\r\n1  ;A COMMENT THAT GOES ~\r\n   ON X+99\r\n2  * - HEADING\r\n"
        "3  l x+1 y+2 z+3 r0 fmax ; comment ~ not the last\r\n/4  L X+5 FMAX\r\n"
        "5  L X +6\tFMAX\r\n6  END PGM A MM \r\n\x03");
    COMPARE_TEXT(test::printProblems(read.diagnostics), "");
    COMPARE_TEXT(test::printPoints(read.trajectory), "5 R X1 Y2 Z3 | 6 R X5 Y2 Z3 | 7 R X6 Y2 Z3");
  }
};

RIVULET_TEST(TestHeidenhain)
#include "tst_heidenhain.moc"
