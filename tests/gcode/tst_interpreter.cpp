// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "gcode/interpreter.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

gcode::Interpretation interpret(std::string_view text, double chordToleranceMm = 0.005) {
  gcode::LoadOptions options;
  options.chordToleranceMm = chordToleranceMm;
  return gcode::interpret(text, options);
}

std::string points(std::string_view text) {
  // A metre of tolerance leaves an arc its quarters: short enough to be read.
  return test::printPoints(interpret(text, 1000.0).trajectory);
}

std::string findings(std::string_view text) {
  // That a snippet moves nothing is known.
  std::vector<gcode::Diagnostic> found = interpret(text).diagnostics;
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](const gcode::Diagnostic& diagnostic) {
                               return diagnostic.code == gcode::DiagnosticCode::NoMotion;
                             }),
              found.end());
  return test::printFindings(found);
}

std::string problems(std::string_view text) {
  return test::printProblems(interpret(text).diagnostics);
}

}  // namespace

#define COMPARE_TEXT(actual, expected) \
  QCOMPARE(QByteArray::fromStdString(actual), QByteArray(expected))

class TestInterpreter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void paths_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << QByteArray(text) << QByteArray(expected);
    };
    add("lines", "G0 X1 Y2 Z3\nG1 X4 F600\nY5\nG0 Z10",
        "1 R X1 Y2 Z3 | 2 L X4 Y2 Z3 F600 | 3 L X4 Y5 Z3 F600 | 4 R X4 Y5 Z10");
    add("unnamed axes", "G0 X1\nG1 Z2 F60", "1 R X1 Y? Z? | 2 L X1 Y? Z2 F60");
    add("word order", "X1 F60 G1", "1 L X1 Y? Z? F60");
    add("feed alone", "F60\nG1 X1\nF120\nX2", "2 L X1 Y? Z? F60 | 4 L X2 Y? Z? F120");
    add("integers are mm", "G0 X10", "1 R X10 Y? Z?");
    add("relative", "G90 G0 X1 Y1 Z1\nG91 X1\nG1 Y-2 F60\nG90 X0",
        "1 R X1 Y1 Z1 | 2 R X2 Y1 Z1 | 3 L X2 Y-1 Z1 F60 | 4 L X0 Y-1 Z1 F60");
    add("inches", "G20 G0 X1\nG1 X2 F10\nG21 X1 F5",
        "1 R X25.4 Y? Z? | 2 L X50.8 Y? Z? F254 | "
        "3 L X1 Y? Z? F5");
    add("G700", "G700 G1 X1 F10\nG710 X1 F5", "1 L X25.4 Y? Z? F254 | 2 L X1 Y? Z? F5");
    add("G70 of a SINUMERIK leaves the feed", "STOPRE\nG70 G1 X1 F10\nG71 X1",
        "2 L X25.4 Y? Z? F10 | 3 L X1 Y? Z? F10");
    add("G70 elsewhere", "G70 G1 X1 F10\nG71 X1 F5", "1 L X25.4 Y? Z? F254 | 2 L X1 Y? Z? F5");
    add("repeated position", "G0 X1 Y1 Z1\nX1", "1 R X1 Y1 Z1 | 2 R X1 Y1 Z1");
    add("G2 quarter", "G0 X0 Y10\nG2 X10 Y0 I0 J-10 F60", "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("G3 three quarters", "G0 X0 Y10\nG3 X10 Y0 J-10 F60",
        "1 R X0 Y10 Z? | 2 A X-10 Y0 Z? F60 | 2 A X0 Y-10 Z? F60 | 2 A X10 Y0 Z? F60");
    add("full circle", "G0 X10 Y0\nG2 I-10 F60",
        "1 R X10 Y0 Z? | 2 A X0 Y-10 Z? F60 | 2 A X-10 Y0 Z? F60 | 2 A X0 Y10 Z? F60 | "
        "2 A X10 Y0 Z? F60");
    add("arc stays modal", "G0 X0 Y10\nG2 X10 Y0 J-10 F60\nX0 Y-10 I-10",
        "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60 | 3 A X0 Y-10 Z? F60");
    add("helix", "G0 X10 Y0 Z4\nG3 X10 Y0 Z0 I-10 F60",
        "1 R X10 Y0 Z4 | 2 A X0 Y10 Z3 F60 | 2 A X-10 Y0 Z2 F60 | 2 A X0 Y-10 Z1 F60 | "
        "2 A X10 Y0 Z0 F60");
    add("G18 is Z to X", "G18 G0 X0 Z10\nG3 X10 Z0 K-10 F60", "1 R X0 Y? Z10 | 2 A X10 Y? Z0 F60");
    add("G19 is Y to Z", "G19 G0 Y10 Z0\nG3 Y0 Z10 J-10 F60", "1 R X? Y10 Z0 | 2 A X? Y0 Z10 F60");
    add("CR=", "G0 X0 Y10\nG2 X10 Y0 CR=10 F60", "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("CR= the long way", "G0 X0 Y10\nG3 X10 Y0 CR=-10 F60",
        "1 R X0 Y10 Z? | 2 A X-10 Y0 Z? F60 | 2 A X0 Y-10 Z? F60 | 2 A X10 Y0 Z? F60");
    add("R word", "G0 X0 Y10\nG2 X10 Y0 R10 F60", "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("relative arc", "G0 X0 Y10\nG91 G2 X10 Y-10 J-10 F60", "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("inch arc", "G20 G0 X0 Y1\nG2 X1 Y0 J-1 F10", "1 R X0 Y25.4 Z? | 2 A X25.4 Y0 Z? F254");
    add("dwell moves nothing", "G0 X1\nG4 X5\nG4 F2\nG4 P100\nG1 X2 F60",
        "1 R X1 Y? Z? | 5 L X2 Y? Z? F60");
    add("cancelled cycle", "G00 G80 X1\nG80\nX2", "1 R X1 Y? Z? | 3 R X2 Y? Z?");
    add("end", "G0 X1\nX2 M30\nX3", "1 R X1 Y? Z? | 2 R X2 Y? Z?");
    add("program names", "%\nO1234\nN1 G0 X1\n%", "3 R X1 Y? Z?");
    add("block skip", "G0 X1\n/X2", "1 R X1 Y? Z? | 2 R X2 Y? Z?");
    // SINUMERIK.
    add("AC and IC", "G0 X=AC(10) Y0\nX5 Y5\nG91 X=AC(1) Y=IC(2)\nX1 Y=AC(0)",
        "1 R X10 Y0 Z? | 2 R X5 Y5 Z? | 3 R X1 Y7 Z? | 4 R X2 Y0 Z?");
    add("AC before G91", "G0 X1 Y1\nX=AC(10) Y5 G91\nG90 X1\nX2 Y=IC(3) G91\nY=IC(1) G90",
        "1 R X1 Y1 Z? | 2 R X10 Y6 Z? | 3 R X1 Y6 Z? | 4 R X3 Y9 Z? | 5 R X3 Y10 Z?");
    add("AC centre", "G0 X0 Y10\nG2 X10 Y0 I=AC(0) J=AC(0) F60",
        "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("AR with end", "STOPRE\nG0 X0 Y10\nG2 X10 Y0 AR=90 F60",
        "2 R X0 Y10 Z? | 3 A X10 Y0 Z? F60");
    add("AR with centre", "STOPRE\nG0 X0 Y10\nG2 I0 J-10 AR=180 F60",
        "2 R X0 Y10 Z? | 3 A X10 Y0 Z? F60 | 3 A X0 Y-10 Z? F60");
    add("TURN", "STOPRE\nG0 X10 Y0 Z8\nG3 X0 Y10 Z0 I-10 J0 TURN=1 F60",
        "2 R X10 Y0 Z8 | 3 A X0 Y10 Z6.4 F60 | 3 A X-10 Y0 Z4.8 F60 | 3 A X0 Y-10 Z3.2 F60 | "
        "3 A X10 Y0 Z1.6 F60 | 3 A X0 Y10 Z0 F60");
    add("CIP", "STOPRE\nG0 X0 Y0 Z0\nCIP X10 Y0 Z0 I1=5 J1=5 K1=0 F60",
        "2 R X0 Y0 Z0 | 3 A X5 Y5 Z0 F60 | 3 A X10 Y0 Z0 F60");
    add("CT", "STOPRE\nG0 X0 Y0 Z0\nG1 X10 F60\nCT X20 Y10",
        "2 R X0 Y0 Z0 | 3 L X10 Y0 Z0 F60 | 4 A X20 Y10 Z0 F60");
    add("polar", "G111 X10 Y0\nSTOPRE\nG0 X0 Y0 Z0\nG1 AP=90 RP=5 F60\nG1 AP=0\nG2 AP=-90 RP=5",
        "3 R X0 Y0 Z0 | 4 L X10 Y5 Z0 F60 | 5 L X15 Y0 Z0 F60 | 6 A X10 Y-5 Z0 F60");
    add("TRANS", "TRANS X100 Y2\nG0 X1 Y1\nATRANS X50\nX1\nTRANS\nX1 Y=IC(1)",
        "2 R X101 Y3 Z? | 4 R X151 Y3 Z? | 6 R X1 Y2 Z?");
    add("ROT", "ROT Z90\nSTOPRE\nG0 X10 Y0 Z5\nATRANS X1\nX0\nROT\nX1",
        "3 R X0 Y10 Z5 | 5 R X0 Y1 Z5 | 7 R X1 Y1 Z5");
    add("ROT in the plane", "TRANS X10\nAROT RPL=90\nG0 X1 Y0 Z0", "3 R X10 Y1 Z0");
    add("SCALE and MIRROR", "SCALE X2\nAMIRROR Y0\nSTOPRE\nG0 X1 Y1 Z1", "4 R X2 Y-1 Z1");
    add("mirrored arc", "MIRROR X0\nSTOPRE\nG0 X0 Y10\nG2 X10 Y0 J-10 F60",
        "3 R X0 Y10 Z? | 4 A X-10 Y0 Z? F60");
    add("diameter", "DIAMON\nSTOPRE\nG18 G0 X20 Z0\nX=IC(2)\nDIAMOF\nX5",
        "3 R X10 Y? Z0 | 4 R X11 Y? Z0 | 6 R X5 Y? Z0");
    add("variables", "DEF REAL D=2\nR1=3\nG0 X=R1*D Y=D+1\nX=R1", "3 R X6 Y3 Z? | 4 R X3 Y3 Z?");
    // ISO and RS-274/NGC.
    // Where Z is with another tool length, only the control knows.
    add("tool length", "G0 X1 Y2 Z3\nG43 H1 X4\nG2 X6 I1 F100\nG1 Z5\nG49\nG91 G1 X1",
        "1 R X1 Y2 Z3 | 2 R X4 Y2 Z? | 3 A X5 Y3 Z? F100 | 3 A X6 Y2 Z? F100 | 4 L X6 Y2 Z5 F100 | "
        "6 L X7 Y2 Z? F100");
    add("G92", "G0 X10 Y0 Z0\nG92 X0\nG0 X5\nG92.1\nX5",
        "1 R X10 Y0 Z0 | 3 R X15 Y0 Z0 | 5 R X5 Y0 Z0");
    add("G52", "G0 X10 Y0 Z0\nG52 X100\nG0 X5\nG52 X0\nX5",
        "1 R X10 Y0 Z0 | 3 R X105 Y0 Z0 | 5 R X5 Y0 Z0");
    add("G90.1", "G90.1 G0 X0 Y10\nG2 X10 Y0 I0 J0 F60", "1 R X0 Y10 Z? | 2 A X10 Y0 Z? F60");
    add("G16", "G0 X0 Y0 Z0\nG16\nG1 X10 Y90 F60\nY180\nG15 X0",
        "1 R X0 Y0 Z0 | 3 L X0 Y10 Z0 F60 | 4 L X-10 Y0 Z0 F60 | 5 L X0 Y0 Z0 F60");
    add("inverse time", "G0 X0 Y0 Z0\nG93 G1 X10 F6\nG94 X20 F50",
        "1 R X0 Y0 Z0 | 2 L X10 Y0 Z0 F60 | 3 L X20 Y0 Z0 F50");
    add("per revolution", "S1000 M3\nG95 G1 X1 F0.2", "2 L X1 Y? Z? F200");
    add("lathe diameter", "STOPRE\nDIAMON\nG0 X20\nDIAMOF X20", "3 R X10 Y? Z? | 4 R X20 Y? Z?");
    add("R in brackets is a radius", "#1=10\nG0 X0 Y10\nG2 X10 Y0 R[#1] F60",
        "2 R X0 Y10 Z? | 3 A X10 Y0 Z? F60");
    // Siemens, NC programming, "Diameter or radius programming": with DIAMON and DIAM90 the values
    // of I programmed with AC() are diameters, increments of I are radii.
    add("absolute centre on the diameter",
        "DIAM90\nG18 G0 X20 Z0\nG2 X40 Z10 I=AC(20) K=AC(10) F60",
        "2 R X10 Y? Z0 | "
        "3 A X20 Y? Z10 F60");
    add("centre as an increment is a radius",
        "STOPRE\nDIAMON\nG18 G0 X20 Z0\nG3 X40 Z10 I10 K0 F60",
        "3 R X10 Y? Z0 | 4 A X20 Y? Z10 F60");
    add("G92 before any motion", "G92 X0 Y0 Z5\nG0 X1\nG1 Y2 F60",
        "2 R X1 Y0 Z5 | 3 L X1 Y2 Z5 F60");
    // SINUMERIK's indirect forms.
    add("G function by its group", "G[6]=2\nSTOPRE\nG[1]=2 X0 Z10 F60\nG[1]=4 X10 Z0 K-10",
        "3 L X0 Y? Z10 F60 | 4 A X10 Y? Z0 F60");
    add("axis by a variable", "DEF AXIS A1=(X), A2\nG0 AX[A1]=5 Y1\nA2=Y\nAX[A2]=IC(2)",
        "2 R X5 Y1 Z? | 4 R X5 Y3 Z?");
    add("lower case", "g0 x1\ng1 y2 f60", "1 R X1 Y? Z? | 2 L X1 Y2 Z? F60");
  }

  void paths() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    COMPARE_TEXT(points(text.toStdString()), expected);
    for (const gcode::Diagnostic& diagnostic : interpret(text.toStdString()).diagnostics) {
      QVERIFY2(diagnostic.severity != gcode::Severity::Error,
               test::printFindings({diagnostic}).c_str());
    }
  }

  void linuxCnc_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << QByteArray(text) << QByteArray(expected);
    };
    // LinuxCNC, G codes, "G92.1, G92.2 Reset G92 Offsets", "G92.3 Restore G92 Offsets": G92.2 keeps
    // the offset, which G92.3 brings back.
    add("G92.2 and G92.3", "G0 X10 Y0 Z0\nG92 X0\nX5\nG92.2\nX6\nG92.3\nX7",
        "1 R X10 Y0 Z0 | 3 R X15 Y0 Z0 | 5 R X6 Y0 Z0 | 7 R X17 Y0 Z0");
    add("G92.1 forgets", "G0 X10 Y0 Z0\nG92 X0\nG92.1\nG92.3\nX7", "1 R X10 Y0 Z0 | 5 R X7 Y0 Z0");
    // "G52 Local Coordinate System Offset": it shares the registers of G92.
    add("G52 is the offset of G92", "G0 X10 Y0 Z0\nG92 X0\nG52 X100\nX5\nG92.2\nX5",
        "1 R X10 Y0 Z0 | 4 R X105 Y0 Z0 | 6 R X5 Y0 Z0");
    // LinuxCNC, G code overview, "Polar Coordinates": @ is the distance from the origin, ^ the
    // angle; what is not named stays, and with G91 both are increments.
    add("polar", "G0 X2 Y0 Z0\n^90\n@3\n@1 ^180",
        "1 R X2 Y0 Z0 | 2 R X0 Y2 Z0 | 3 R X0 Y3 Z0 | 4 R X-1 Y0 Z0");
    add("polar increments", "G0 X2 Y0 Z0\nG91 ^[45*2]\n@1\n@1 ^-90",
        "1 R X2 Y0 Z0 | 2 R X0 Y2 Z0 | 3 R X0 Y3 Z0 | 4 R X4 Y0 Z0");
    // A curve of order 2 is its control points.
    add("knots",
        "G0 X0 Y0 Z0\nF60\nG6.2 X0 Y0 R1 K0 P2\nX10 Y5 R1 K0\nX20 Y0 R1 K1\nG6.2 K2\nG6.2 K2"
        "\nG1 X30",
        "1 R X0 Y0 Z0 | 5 A X2.5 Y1.25 Z0 F60 | 5 A X5 Y2.5 Z0 F60 | 5 A X7.5 Y3.75 Z0 F60 | "
        "5 A X10 Y5 Z0 F60 | 5 A X12.5 Y3.75 Z0 F60 | 5 A X15 Y2.5 Z0 F60 | 5 A X17.5 Y1.25 Z0 F60 "
        "| 5 A X20 Y0 Z0 F60 | 8 L X30 Y0 Z0 F60");
  }

  void linuxCnc() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::LinuxCnc;
    const gcode::Interpretation made = gcode::interpret(text.toStdString(), options);
    COMPARE_TEXT(test::printPoints(made.trajectory), expected);
    for (const gcode::Diagnostic& diagnostic : made.diagnostics) {
      QVERIFY2(diagnostic.severity != gcode::Severity::Error,
               test::printFindings({diagnostic}).c_str());
    }
  }

  /// What cannot be streamed, or is written wrongly.
  void linuxCncFindings() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::LinuxCnc;
    const auto found = [&](const char* text) {
      return test::printFindings(gcode::interpret(text, options).diagnostics);
    };
    COMPARE_TEXT(found("G0 X1\nG10 L2 P1 X5"), "2:11 error unsupported-g-code G10");
    COMPARE_TEXT(found("G0 X1\nG10 L20 P1 X5"), "2:12 error unsupported-g-code G10 L20");
    COMPARE_TEXT(found("G0 X1\nG10 L2 P12 X5"), "2:12 error unsupported-g-code G10 L2");
    COMPARE_TEXT(found("G50\nG0 X1"), "1:1 error unknown-g-code G50");
    COMPARE_TEXT(found("G0 X0 Y0 Z0\nF60\nG6.2 X0 Y0 K0 P2\nX10 Y5 K0\nX20 Y0 K1\nG6.2 K2\nG1 X30"),
                 "7:1 error value-out-of-range K");
  }

  void findings_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* text, const char* expected) {
      QTest::newRow(QByteArray(text).replace('\n', " | ").constData())
          << QByteArray(text) << QByteArray(expected);
    };
    add("G0 X1 Y2", "");
    add("G0 X1 &", "1:7 error unexpected-character &");
    add("G0 X", "1:4 error number-missing X");
    add("G0 X1,5", "1:5 error number-malformed 1,5");
    add("G0 X1 (a", "1:7 error comment-not-closed");
    add("G777 X1",
        "1:1 error unknown-g-code G777 | 1:6 warning motion-mode-assumed | "
        "1:6 warning feed-missing");
    add("G1.5", "1:1 error unknown-g-code G1.5");
    add("G-1", "1:1 error unknown-g-code G-1");
    add("G0 X1 A10", "");
    add("G0 X1 A10\nA20", "2:1 warning rotary-axes A");
    add("A10\nG0 X1\nA10\nX2", "1:1 warning motion-mode-assumed | 1:1 warning feed-missing");
    add("G0 X1\nA10\nX2", "2:1 warning rotary-axes A");
    add("G0 A10\nA20 X1", "2:1 warning rotary-axes A");
    add("G0 X1 E10", "1:7 error unknown-word E10");
    add("G0 X1 L5", "1:7 error unknown-word L5");
    add("G0 X1 P5", "1:7 error unknown-word P5");
    add("FOO", "1:1 error unknown-word FOO");
    add("M98 P100", "1:1 error subprogram-missing O100");
    add("M2.5", "1:1 error value-out-of-range M2.5");
    add("G41 G0 X1 D1", "1:1 error unsupported-g-code G41 | 1:11 note ignored-code D");
    add("G93", "1:1 note ignored-code G93");
    add("G95", "1:1 note ignored-code G95");
    add("G90.1", "1:1 note ignored-code G90.1");
    add("G91.1", "1:1 note ignored-code G91.1");
    add("TRANS X10", "");
    add("TRANS X10 A5", "1:7 error unsupported-g-code TRANS");
    add("STOPRE\nAROT A5", "1:1 note ignored-code STOPRE | 2:6 error unsupported-g-code AROT");
    add("G0 X1 A0\nG92 A5\nA5", "");
    add("G0 X1 A0\nG92 A5\nA0", "3:1 warning rotary-axes A");
    add("STOPRE\nM[1]=3 S[1]=500",
        "1:1 note ignored-code STOPRE | 2:1 note ignored-code M[1]=3 | 2:8 note ignored-code "
        "S[1]=500");
    add("STOPRE\nG[7]=2", "1:1 note ignored-code STOPRE | 2:1 error unsupported-g-code G[7]=2");
    add("STOPRE\nG[8]=2", "1:1 note ignored-code STOPRE | 2:1 note ignored-code G54");
    add("STOPRE\nSETINT(1) PRIO=1 LIFT\nCLRINT(1)",
        "1:1 note ignored-code STOPRE | 2:1 note ignored-code SETINT | 3:1 note ignored-code "
        "CLRINT");
    add("DEF INT E\nDELETE(E,\"A.MPF\")\nG0 X=E",
        "2:1 note ignored-code DELETE | 3:4 error expression-fault it needs a value that is not "
        "known");
    add("DEF STRING[20] TAG\nR1=5\nTAG=\"A\"<<R1\nTAG=TAG<<\"B\"\nT=\"A\"<<R1",
        "5:1 note ignored-code T");
    add("MSG(\"part \"<<R1<<\" done\")", "1:1 note ignored-code MSG");
    // The cycles of a lathe are no change of units.
    add("G20 G0 X1 Z0\nG71 P10 Q20 U0.5 W0.1 F0.2\nN10 G1 X2\nN20 Z-1\nG70 P10 Q20",
        "1:1 warning lathe-assumed G71 | 2:1 error cycle-not-run G71 | 5:1 error cycle-not-run "
        "G70");
    add("G52 X1 U5", "1:5 error unsupported-g-code G52");
    add("G54.1 P1\nG0 X1\nG54.1 P1\nX2\nG54.1 P2\nX3",
        "1:1 note ignored-code G54.1 | 5:1 error unsupported-g-code G54.1");
    add("G54.1\nG0 X1", "1:1 error number-missing P");
    add("CYCLE800(1,2)", "1:1 error unsupported-g-code CYCLE800");
    add("STOPRE CSPLINE", "1:1 note ignored-code STOPRE | 1:8 error unsupported-g-code CSPLINE");
    add("STOPRE\nG0 X1 RND=2", "1:1 note ignored-code STOPRE | 2:7 error unsupported-g-code RND");
    add("SOFT", "1:1 error unknown-word SOFT");
    add("R1=5", "");
    add("#1=5", "");
    add("G0 X=R1",
        "1:4 error expression-fault R1 is read before the program sets it: only the control knows "
        "it");
    add("DEF REAL A", "");
    add("IF A>1 GOTOF B", "1:1 error expression-fault A is not defined");
    add("IF 1>0 GOTOF B", "1:1 error flow-fault the target B is missing");
    add("STOPRE\nWHEN TRUE DO R1=1",
        "1:1 note ignored-code STOPRE | 2:1 error "
        "unsupported-expression WHEN");
    add("POCKET(1,2)", "1:1 error unsupported-expression POCKET(1,2)");
    add("G54\nG0 X1\nG54\nX2", "1:1 note ignored-code G54");
    add("G54\nG0 X1\nG55\nX2", "1:1 note ignored-code G54 | 3:1 error unsupported-g-code G55");
    add("SUPA G505", "1:6 note ignored-code G505");
    add("G505", "1:1 error unknown-g-code G505");
    add("G64 P0.01\nG0 X1", "1:1 note ignored-code G64");
    add("G43 H1 G0 Z5", "1:1 note ignored-code G43 | 1:5 note ignored-code H");
    add("S500 M3\nS600 M03\nM5",
        "1:1 note ignored-code S | 1:6 note ignored-code M3 | "
        "3:1 note ignored-code M5");
    add("T1 M6\nG0 X1\nT2 M6",
        "1:1 note ignored-code T | 1:4 note ignored-code M6 | "
        "3:4 warning ignored-code M6");
    add("M0", "1:1 warning ignored-code M0");
    add("M1=3", "1:1 note ignored-code M1=3");
    add("MSG(\"a\")", "1:1 note ignored-code MSG");
    add("STOPRE SOFT FFWON",
        "1:1 note ignored-code STOPRE | 1:8 note ignored-code SOFT | 1:13 note ignored-code FFWON");
    add("G641 ADIS=0.1", "1:1 note ignored-code G641 | 1:6 note ignored-code ADIS");
    add("/G0 X1", "1:1 note ignored-code /");
    add("G4 F2", "1:1 note ignored-code G4");
    add("G4 Y2", "1:1 note ignored-code G4 | 1:4 error unknown-word Y2");
    add("G0 G1 X1 F60", "1:4 error conflicting-g-codes G0 G1");
    add("G90 G91", "1:5 error conflicting-g-codes G90 G91");
    add("G17 G19", "1:5 error conflicting-g-codes G17 G19");
    add("G20 G21", "1:5 error conflicting-g-codes G20 G21");
    add("G1 G01 X1 F60", "");
    add("G0 X1 X2", "1:7 error repeated-word X");
    add("F60 F70", "1:5 error repeated-word F");
    add("S1 S2", "1:1 note ignored-code S | 1:4 warning repeated-word S");
    add("G0 X0 Y0\nG2 X1 F60", "2:4 warning control-setting-open G2, G3: arc=line");
    add("G92 X0\nG1 X1 F60", "1:1 warning control-setting-open G92: place=G92");
    add("G0 X0\nG92 X5\nG1 X1 F60", "");
    add("G0 X0 Y0\nG2 X0 CR=5 F60", "2:4 error arc-without-centre");
    add("G0 X0 Y0\nG2 X1 I0 J0 F60", "2:4 error arc-radius-mismatch 1");
    add("G0 X0 Y0\nG2 I0 F60", "2:4 error arc-without-centre");
    add("G0 X0 Y0\nG2 X10 I5.0105 F60", "2:4 error arc-radius-mismatch 0.021");
    add("G0 X0 Y0\nG2 X10 I5.0095 F60", "");
    add("G0 X0 Y0\nG2 X10 CR=4 F60", "2:4 error arc-radius-too-small 4 < 5");
    add("G0 X0 Y0\nG2 X10 CR=4.985 F60", "");
    add("G0 X0 Y0\nG2 X10 CR=0 F60", "2:4 error arc-radius-too-small 0 < 5");
    add("G0 X0 Y0\nG2 X10 I5 CR=5 F60", "2:4 error conflicting-g-codes I J K and CR=");
    add("G0 X0 Y0\nG2 X10 I5 K1 F60", "2:11 error centre-outside-plane K1");
    add("G0 X0 Y0\nG2 X10 I5 K0 F60", "");
    add("G0 X0\nG2 X10 I5 F60", "2:4 error arc-from-unknown-position Y");
    add("G0 X0 Y0\nG2 X10 Z5 I5 F60", "2:4 error arc-from-unknown-position Z");
    add("G91 G0 X1", "1:8 error relative-from-unknown-position X");
    // Where polar coordinates point to is as well known as a place.
    add("G0 X0 Y0 Z0\nG16\nG2 X1 R0.25 F60",
        "2:1 note ignored-code G16 | 3:4 error word-missing G16 Y | 3:4 error arc-without-centre");
    add("G16 G91\nG0 X1 Y90\nG90 G15 X0 Y0",
        "1:1 note ignored-code G16 | 2:4 error relative-from-unknown-position X | "
        "3:5 note ignored-code G15");
    add("G0 X0 Y0 Z0\nG16\nG1 X3000000. Y90 F60",
        "2:1 note ignored-code G16 | 3:4 error value-out-of-range Y");
    add("G17 G0 X900000 Y0 Z0\nSTOPRE\nG110 X0 Y0\nG1 RP=900000 AP=0 F60",
        "2:1 note ignored-code STOPRE | 4:4 error value-out-of-range X");
    add("G0 X1 I5", "1:7 error unknown-word I5");
    add("G0 X1 R5", "1:7 error unknown-word R5");
    add("G1 X1\nX2\nX3", "1:4 warning feed-missing");
    add("G1 X1 F0", "1:4 warning feed-missing | 1:7 error feed-not-positive 0");
    add("F-5", "1:1 error feed-not-positive -5");
    add("G0 X1e6\nX1000001",
        "1:5 error number-malformed 1e6 | 2:1 error value-out-of-range X1000001");
    add("X1 F60", "1:1 warning motion-mode-assumed");
    add("G0 X1\nM30\n\n(c)\nX2\nX3", "5:1 warning never-executed lines 5 to 6");
    add("G0 X1\nM2\n%\n", "");
    add("G0 X1\n%\nX2", "3:1 warning never-executed line 3");
    add("M17\nG0 X1", "1:1 error unknown-m-function M17");
    add("STOPRE\nM17\nG0 X1", "1:1 note ignored-code STOPRE | 3:1 warning never-executed line 3");
    add("G0 X1\nO5", "");
    add("G81 X1 Y2 Z-3 R1 F60\nX5\nG80\nG0 X6",
        "1:1 error cycle-not-run G81 | "
        "3:1 note ignored-code G80");
  }

  void findings() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    COMPARE_TEXT(::findings(text.toStdString()), expected);
  }

  /// The program is refused for such a feed; its points are shown all the same.
  void noPointHasANegativeFeed() {
    for (const char* motion : {"G1 X10 F-6", "G3 X10 I5 J0 F-6", "G1 A90 F-6"}) {
      const gcode::Interpretation result =
          gcode::interpret(std::string("G0 X0 Y0 Z0 A0\nG93 ") + motion + "\n", {});
      const std::vector<gcode::Diagnostic>& found = result.diagnostics;
      QVERIFY(std::any_of(found.begin(), found.end(), [](const gcode::Diagnostic& one) {
        return one.code == nc::FaultCode::FeedNotPositive;
      }));
      QVERIFY(result.trajectory.points.size() > 1);
      for (const gcode::TrajectoryPoint& point : result.trajectory.points) {
        QVERIFY(point.feedMmPerS >= 0.0);
      }
    }
  }

  /// F1e-300 would let the axes stand for ever, without a word.
  void noFeedIsNearlyNothing() {
    const auto isRefused = [](const char* feed) {
      gcode::LoadOptions options;
      options.dialect = gcode::Dialect::Sinumerik;
      const auto found = gcode::interpret(std::string("G90 G94\nG1 X10 F=") + feed + "\n", options);
      return std::any_of(
          found.diagnostics.begin(), found.diagnostics.end(),
          [](const gcode::Diagnostic& one) { return one.code == nc::FaultCode::ValueOutOfRange; });
    };
    QVERIFY(isRefused("1EX-300"));
    QVERIFY(isRefused("0.0009"));
    QVERIFY(!isRefused("0.001"));
  }

  /// An inch program stays one, X is a diameter, and U and W are increments of X and Z.
  void lathesHaveTheirMode() {
    gcode::LoadOptions options;
    options.accepted = {"G70", "G71"};
    options.chordToleranceMm = 1000.0;
    const gcode::Interpretation result = gcode::interpret(
        "G20 G0 X2 Z0\nG71 U0.1 R0.05\nG71 P10 Q20 U0.5 W0.1 F0.2\nN10 G1 X1 F10\nN20 U1 W-1\n"
        "G2 X4 Z-2 I1 K0\nG70 P10 Q20\nG0 X4",
        options);
    COMPARE_TEXT(test::printPoints(result.trajectory),
                 "1 R X25.4 Y? Z0 | 4 L X12.7 Y? Z0 F254 | 5 L X25.4 Y? Z-25.4 F254 | "
                 "6 A X50.8 Y? Z-50.8 F254 | 8 R X50.8 Y? Z-50.8");
  }

  /// M140 goes along the tool to the end of the axis: the motions around it are still counted.
  void retractToTheLimitOfHeidenhain() {
    const gcode::Interpretation result = interpret(
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+5 FMAX\n2 L X+10 F500\n3 M140 MB MAX\n"
        "4 L X+20 Z+5 F500\n5 L X+30 M140 MB+50\n6 END PGM A MM");
    COMPARE_TEXT(test::printProblems(result.diagnostics),
                 "4:3 error unsupported-g-code M140 | 6:10 error unsupported-g-code M140");
    QVERIFY(result.facts.complete);
    QCOMPARE(result.facts.motions[1], std::size_t{3});
    QCOMPARE(result.facts.otherMotions, std::size_t{2});
  }

  /// The one hint that helps must not drown in what it would mend.
  void hintsAreNotAmongTheFindingsCut() {
    std::string text = "G0 X0 Y0\n";
    for (int i = 1; i <= 1500; ++i) {
      // Centres written as places.
      text += "G2 X" + std::to_string(10 * i) + " Y0 I" + std::to_string(10 * i - 5) + " J0 F60\n";
    }
    const gcode::Interpretation result = interpret(text);
    std::size_t count = 0;
    for (const gcode::Diagnostic& each : result.diagnostics) {
      count += each.count;
    }
    QVERIFY(count >= gcode::kDiagnosticsMax);
    QVERIFY(std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                        [](const gcode::Diagnostic& diagnostic) {
                          return diagnostic.code == gcode::DiagnosticCode::CentreReading &&
                                 diagnostic.argument == "absolute";
                        }));
  }

  void unsupportedMotionAddsNoPoint() {
    COMPARE_TEXT(points("G0 X1\nG81 X2 Z-3 R1 F60\nX3\nG80\nX4\nG10 L2 P1 X9\nG28 X0\nG53 X8\nX5"),
                 "1 R X1 Y? Z? | 5 R X4 Y? Z? | 9 R X5 Y? Z?");
  }

  void oneFindingPerIgnoredWord() {
    std::string text = "STOPRE G0 X0\n";
    for (int i = 0; i < 5000; ++i) {
      text += "G1 X1 M3 S100 F60 G64 SOFT\n";
    }
    COMPARE_TEXT(::findings(text),
                 "1:1 note ignored-code STOPRE | 2:7 note ignored-code M3 | 2:10 note ignored-code "
                 "S | 2:19 note ignored-code G64 "
                 "| 2:23 note ignored-code SOFT");
  }

  void manyFindingsAreCutAndSaySo() {
    std::string text = "G0 X0\n";
    for (int i = 0; i < 1500; ++i) {
      text += "?" + std::to_string(i) + "\n";
      text += "PART" + std::to_string(i) + "\n";
    }
    text = "G21\n" + text;
    const gcode::Interpretation result = interpret(text);
    QCOMPARE(result.diagnostics.size(), gcode::kDiagnosticsMax + 1);
    QCOMPARE(result.diagnostics.back().code, gcode::DiagnosticCode::MoreFindings);
    QCOMPARE(result.diagnostics.back().severity, gcode::Severity::Error);
  }

  /// A word in each of a thousand lines is one finding with its number, and hides no other.
  void repeatedFindingsAreCounted() {
    std::string text = "G0 X0\n";
    for (int i = 0; i < 1500; ++i) {
      text += "S1 S2\n";
    }
    text += "E5\n";
    const gcode::Interpretation result = interpret(text);
    std::size_t listed = 0;
    std::size_t counted = 0;
    for (const gcode::Diagnostic& found : result.diagnostics) {
      listed += found.code == gcode::DiagnosticCode::RepeatedWord ? 1U : 0U;
      counted = std::max(counted, found.count);
    }
    QCOMPARE(listed, gcode::kRepeatsListed);
    QCOMPARE(counted, std::size_t{1500});
    QCOMPARE(result.diagnostics.back().code, gcode::DiagnosticCode::UnknownWord);
  }

  void statistics() {
    const gcode::Interpretation result = interpret(
        "%\n(name)\nG0 X0 Y0 Z5\nG0 Z0\nG1 X10 F600\nG2 X20 Y0 I5\nX20\nG3 X20 Y10 CR=5 F300\n"
        "G1 X0 F600\nM30\n%\n");
    const gcode::Statistics& statistics = result.statistics;
    QCOMPARE(statistics.lines, std::size_t{11});
    QCOMPARE(statistics.motions, (std::array<std::size_t, 4>{2, 2, 2, 1}));
    QCOMPARE(statistics.points, result.trajectory.points.size());
    QCOMPARE(statistics.minMm, (base::Vec3{0, 0, 0}));
    QCOMPARE(statistics.maxMm, (base::Vec3{20, 10, 5}));
    // The first move comes from nowhere. The block "X20" is an arc without centre: no length.
    QCOMPARE(statistics.rapidLengthMm, 5.0);
    QVERIFY(std::abs(statistics.cutLengthMm - (10.0 + 5.0 * std::numbers::pi * 2.0 + 20.0)) < 1e-9);
    QCOMPARE(statistics.feedsMmPerMin, (std::vector<double>{300, 600}));
    QCOMPARE(result.blocks, std::size_t{8});
  }

  void unnamedAxesHaveNoBounds() {
    const gcode::Statistics statistics = interpret("G0 X1\nX-2").statistics;
    QCOMPARE(statistics.minMm.x, -2.0);
    QCOMPARE(statistics.maxMm.x, 1.0);
    QVERIFY(std::isnan(statistics.minMm.y));
    QVERIFY(std::isnan(statistics.maxMm.z));
  }

  /// Each names the word, its cause, and what to do; none advises to leave out what moves an axis.
  void sentencesOfTheirOwn_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("dialect");
    QTest::addColumn<QString>("begins");
    QTest::addColumn<QString>("accepts");
    const auto row = [](const char* text, gcode::Dialect dialect, const char* begins,
                        const char* accepts) {
      QTest::newRow(text) << QByteArray(text) << static_cast<int>(dialect) << QString(begins)
                          << QString(accepts);
    };
    using gcode::Dialect;
    row("EXECSTRING(\"G1 X9\")", Dialect::Sinumerik, "EXECSTRING executes a text", "EXECSTRING");
    row("VELOLIM[X]=50", Dialect::Sinumerik, "VELOLIM limits the speed", "VELOLIM");
    row("MCALL OWN(1)", Dialect::Sinumerik, "MCALL OWN calls a subprogram behind", "MCALL OWN");
    row("MCALL CYCLE81(5,0,1,-5)", Dialect::Sinumerik, "CYCLE81 is a cycle", "CYCLE81");
    row("PRESETON(X,10)", Dialect::Sinumerik, "PRESETON changes the path", "PRESETON");
    row("G1 X5 F100\nG80\nX7", Dialect::Grbl, "The word X7 is not understood", "");
    row("G150 P2 R1. Q1.", Dialect::Haas, "Rivulet does not know the G function G150", "G150");
    row("#1=BIN[10]", Dialect::Fanuc, "The calculation has no result: BIN(10)", "");
    row("BEGIN PGM A MM\nL X+1 RR F5", Dialect::Heidenhain, "RR changes the path", "RR");
  }
  void sentencesOfTheirOwn() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, dialect);
    QFETCH(const QString, begins);
    QFETCH(const QString, accepts);
    gcode::LoadOptions options;
    options.dialect = static_cast<gcode::Dialect>(dialect);
    const auto program = gcode::interpretProgram("a", text.toStdString(), options);
    QVERIFY(program.has_value());
    std::vector<gcode::Diagnostic> errors;
    std::copy_if(program->diagnostics.begin(), program->diagnostics.end(),
                 std::back_inserter(errors),
                 [](const auto& each) { return each.severity == gcode::Severity::Error; });
    QCOMPARE(errors.size(), std::size_t{1});
    const QString sentence = QString::fromStdString(gcode::describe(errors.front()));
    QVERIFY2(sentence.startsWith(begins), qPrintable(sentence));
    QCOMPARE(QString::fromStdString(gcode::acceptableName(errors.front())), accepts);
  }

  void arcEndsExactlyWhereProgrammed() {
    const auto result = interpret("G0 X0 Y0 Z0\nG2 X9.999 Y0 I5 F60\nG3 X0.1 Y0.2 CR=100");
    COMPARE_TEXT(test::printProblems(result.diagnostics), "");
    const auto& all = result.trajectory.points;
    QCOMPARE(all.back().positionMm, (base::Vec3{0.1, 0.2, 0.0}));
    QVERIFY(all.size() > 35);
  }

  void everyFindingHasANameAndASentence() {
    std::set<std::string_view> names;
    for (int code = 0; code <= static_cast<int>(gcode::DiagnosticCode::MoreFindings); ++code) {
      gcode::Diagnostic diagnostic;
      diagnostic.code = static_cast<gcode::DiagnosticCode>(code);
      diagnostic.argument = "{}17";
      QVERIFY(names.insert(gcode::diagnosticName(diagnostic.code)).second);
      const std::string sentence = gcode::describe(diagnostic);
      QVERIFY2(sentence.size() > 20 && sentence.back() == '.', sentence.c_str());
      QVERIFY(sentence.size() < 200);
    }
    COMPARE_TEXT(gcode::describe(
                     {gcode::Severity::Error, {3}, 5, gcode::DiagnosticCode::NumberMissing, "X"}),
                 "The word X has no number.");
    QVERIFY(
        gcode::describe({gcode::Severity::Note, {1}, 1, gcode::DiagnosticCode::IgnoredCode, "M3"})
            .find("spindle") != std::string::npos);
    QVERIFY(gcode::describe(
                {gcode::Severity::Warning, {1}, 1, gcode::DiagnosticCode::IgnoredCode, "M6"})
                .find("does not wait") != std::string::npos);
  }

  void longTextIsCutBetweenCharacters() {
    const std::string text = "FOO(" + std::string(115, 'A') + "\xC3\xA4\xC3\xA4\xC3\xA4)";
    const gcode::Interpretation result = interpret(text);
    QCOMPARE(result.diagnostics.front().argument, "FOO(" + std::string(115, 'A') + "...");
  }

  void loneCarriageReturnsAreRead() {
    COMPARE_TEXT(points("G0 X1\rX2\rX3"), "1 R X1 Y? Z? | 2 R X2 Y? Z? | 3 R X3 Y? Z?");
    COMPARE_TEXT(problems("G0 X1\rX2\rX3"), "");
  }
};

RIVULET_TEST(TestInterpreter)
#include "tst_interpreter.moc"
