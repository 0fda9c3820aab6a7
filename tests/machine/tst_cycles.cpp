// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Drilling cycles and patterns of holes on the virtual machine.

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "machine/machine.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::ChannelStatus;
using machine::Machine;

namespace {

struct Outcome {
  std::string path;  ///< "10,0,50 10,0,2": end points in programmed coordinates
  int alarm = 0;
  trace::ControlTrace trace;
};

Outcome runProgram(const std::string& text, const std::string& subprogram = {}) {
  Machine machine(*machine::loadPreset("dmu75-mill"), 1);
  const bool ready = machine.storeProgram("T.MPF", text + "\nM30\n", true).has_value() &&
                     machine.storeProgram("HOLE.SPF", subprogram, true).has_value() &&
                     machine.selectProgram("T.MPF").has_value() && machine.cycleStart().has_value();
  if (!ready) {
    qFatal("the program could not be started");
  }
  for (int i = 0; i < 100000 && machine.state().channel == ChannelStatus::Active; ++i) {
    machine.advance(machine.now() + base::fromMilliseconds(4.0));
  }
  Outcome outcome;
  outcome.alarm = machine.state().alarm;
  outcome.trace = machine.trace();
  for (const trace::ExecutedBlock& block : outcome.trace.blocks) {
    outcome.path += outcome.path.empty() ? "" : " ";
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      outcome.path +=
          (axis == 0 ? "" : ",") + base::formatNumber(std::round(block.targetMm[axis] * 1e6) / 1e6);
    }
  }
  return outcome;
}

}  // namespace

class TestCycles : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void paths_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("path");
    QTest::newRow("call") << "G0 X10 Z50\nG1 F1000\nCYCLE81(20,0,2,-5)"
                          << "10,0,50 10,0,2 10,0,-5 10,0,20";
    QTest::newRow("values are calculated")
        << "R1=2 R2=10\nG0 X10 Z50 F1000\nCYCLE81(2*R2,0,R1,,R2/2)"
        << "10,0,50 10,0,2 10,0,-5 10,0,20";
    QTest::newRow("modal") << "G0 X10 Z50 F1000\nMCALL CYCLE81(20,0,2,-5)\nX20\nY5\nMCALL\nX0"
                           << "10,0,50 20,0,50 20,0,2 20,0,-5 20,0,20 20,5,20 20,5,2 20,5,-5 "
                              "20,5,20 0,5,20";
    QTest::newRow("row of holes")
        << "G0 Z50 F1000\nMCALL CYCLE81(20,0,2,-5)\nHOLES1(10,0,0,0,5,2)\nMCALL"
        << "0,0,50 10,0,50 10,0,2 10,0,-5 10,0,20 15,0,20 15,0,2 15,0,-5 15,0,20";
    QTest::newRow("circle of holes")
        << "G0 Z50 F1000\nMCALL CYCLE82(20,0,2,-5,,0.1)\nHOLES2(0,0,10,0,180,2)\nMCALL"
        << "0,0,50 10,0,50 10,0,2 10,0,-5 10,0,20 -10,0,20 -10,0,2 -10,0,-5 -10,0,20";
    // What is modal in the program neither changes the cycle nor is changed by it.
    QTest::newRow("increments") << "G0 X10 Z50\nG91 G1 F1000\nCYCLE81(20,0,2,-5)\nX1 Z1"
                                << "10,0,50 10,0,2 10,0,-5 10,0,20 11,0,21";
    QTest::newRow("inches") << "G70 G0 X1 Z2 F40\nCYCLE81(1,0,0.1,-0.5)"
                            << "25.4,0,50.8 25.4,0,2.54 25.4,0,-12.7 25.4,0,25.4";
    QTest::newRow("another plane") << "G18 G0 X10 Y50 Z0 F1000\nCYCLE81(20,0,2,-5)"
                                   << "10,50,0 10,2,0 10,-5,0 10,20,0";
    QTest::newRow("offset and frame") << "G54 G0 X10 Z50 F1000\nTRANS X5\nCYCLE81(20,0,2,-5)"
                                      << "10,0,50 10,0,2 10,0,-5 10,0,20";
    // Programs begin with these: nothing is to be ended.
    QTest::newRow("no transformation, no swivelling") << "TRAFOOF\nCYCLE800()\nG0 X10"
                                                      << "10,0,50";
    QTest::newRow("in a subprogram") << "G0 Z50 F1000\nMCALL CYCLE81(20,0,2,-5)\nHOLE\nMCALL\nX0"
                                     << "0,0,50 7,0,50 7,0,2 7,0,-5 7,0,20 0,0,20";
    QTest::newRow("modal subprogram") << "G0 Z50 F1000\nMCALL HOLE\nX5\nMCALL\nX0"
                                      << "0,0,50 5,0,50 7,0,50 0,0,50";
  }
  void paths() {
    QFETCH(QString, text);
    QFETCH(QString, path);
    const Outcome outcome = runProgram(text.toStdString(), "X7\nM17\n");
    QCOMPARE(outcome.alarm, 0);
    QCOMPARE(QString::fromStdString(outcome.path), path);
  }

  void alarms_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("alarm");
    QTest::newRow("planes") << "G1 F1000\nCYCLE81(-2,0,2,-5)" << 61101;
    QTest::newRow("planes, modal") << "G1 F1000\nMCALL CYCLE81(-2,0,2,-5)\nX10" << 61101;
    QTest::newRow("no feed") << "CYCLE81(20,0,2,-5)" << 10860;
    QTest::newRow("pattern without a cycle") << "HOLES1(10,0,0,0,5,2)" << 62100;
    QTest::newRow("no such variable") << "CYCLE81(20,0,2,DEPTH)" << 12550;
    QTest::newRow("below the travel") << "G54 G1 F1000\nCYCLE81(20,0,2,-100)" << 10720;
    QTest::newRow("another cycle") << "CYCLE899(1,2)" << 12550;
  }
  void alarms() {
    QFETCH(QString, text);
    QFETCH(int, alarm);
    QCOMPARE(runProgram(text.toStdString()).alarm, alarm);
  }

  /// A cycle of the same name on the control comes first.
  void ownProgramComesFirst() {
    Machine machine(*machine::loadPreset("dmu75-mill"), 1);
    QVERIFY(machine.storeProgram("T.MPF", "CYCLE81(20,0)\nM30\n", true));
    QVERIFY(machine.storeProgram("CYCLE81.SPF", "PROC CYCLE81(REAL A, REAL B)\nR5=A\nM17\n", true));
    QVERIFY(machine.selectProgram("T.MPF") && machine.cycleStart());
    machine.advance(machine.now() + base::fromSeconds(1.0));
    QCOMPARE(machine.rParameter(5), 20.0);
  }

  /// Depth and dwell, feed and rapid, as the program says.
  void feedsAreThoseOfTheProgram() {
    const Outcome outcome =
        runProgram("S1000 M3 G0 X10 Z50\nG1 F600\nCYCLE83(20,0,2,-8,,-4,,0,0.5,,0.5,1)\nM5");
    QCOMPARE(outcome.alarm, 0);
    const std::vector<trace::ExecutedBlock>& blocks = outcome.trace.blocks;
    QCOMPARE(blocks.size(), std::size_t{7});
    const auto secondsOf = [&](std::size_t block) {
      return base::toSeconds(blocks[block].to - blocks[block].from);
    };
    QVERIFY(secondsOf(2) > 1.2);                         // 6 mm with half of 10 mm/s
    QVERIFY(secondsOf(5) > 0.46 && secondsOf(5) < 0.8);  // 4.6 mm with 10 mm/s
    QVERIFY(secondsOf(3) < 0.2);                         // rapid
    int dwells = 0;
    for (const trace::ControlEvent& event : outcome.trace.events) {
      dwells += event.kind == trace::ControlEvent::Kind::Dwell ? 1 : 0;
    }
    QCOMPARE(dwells, 2);
    QCOMPARE(blocks[2].line.value, 3U);
  }

  void tappingTurnsTheSpindle() {
    const Outcome outcome = runProgram("G0 X10 Z50\nCYCLE84(20,0,2,-8,,,3,,1.5,0,400,800)\nM5");
    QCOMPARE(outcome.alarm, 0);
    std::vector<double> speeds;
    for (const trace::ControlEvent& event : outcome.trace.events) {
      if (event.kind == trace::ControlEvent::Kind::Spindle) {
        speeds.push_back(event.value);
      }
    }
    QCOMPARE(speeds, (std::vector<double>{0.0, 400.0, -800.0, 800.0, 0.0}));
  }
};

RIVULET_TEST(TestCycles)
#include "tst_cycles.moc"
