// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Tools, spindle, coolant, offsets and stops of the virtual machine.

#include <QtTest>
#include <cmath>

#include "machine/machine.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::ChannelStatus;
using machine::Machine;
using machine::MachineState;
using machine::ProgramStatus;
using trace::ControlEvent;
using Kind = trace::ControlEvent::Kind;

namespace {

constexpr double kSameMm = 1e-9;

class Bench {
 public:
  explicit Bench(const std::string& text, const char* preset = "dmu75-mill")
      : Bench(text, *machine::loadPreset(preset)) {}
  Bench(const std::string& text, machine::MachineConfig config) : m_machine(std::move(config), 1) {
    start(text);
  }
  void start(const std::string& text) {
    const bool ready = m_machine.storeProgram("T.MPF", text, true).has_value() &&
                       m_machine.selectProgram("T.MPF").has_value() &&
                       m_machine.cycleStart().has_value();
    if (!ready) {
      qFatal("the bench could not start its program");
    }
  }
  Machine* operator->() { return &m_machine; }
  void runS(double seconds) { m_machine.advance(m_machine.now() + base::fromSeconds(seconds)); }
  /// Until the program has ended or stands. @return s
  double finish() {
    const base::Instant begin = m_machine.now();
    for (int i = 0; i < 100000 && m_machine.state().channel == ChannelStatus::Active; ++i) {
      runS(0.004);
    }
    return base::toSeconds(m_machine.now() - begin);
  }
  /// Where the axes stand, in machine coordinates.
  base::Vec3 machineMm() const {
    const MachineState state = m_machine.state();
    return state.commandMm + state.zeroMm;
  }
  std::vector<ControlEvent> events(Kind kind) const {
    std::vector<ControlEvent> found;
    for (const ControlEvent& event : m_machine.trace().events) {
      if (event.kind == kind) {
        found.push_back(event);
      }
    }
    return found;
  }

 private:
  Machine m_machine;
};

double secondsOf(const ControlEvent& event) {
  return base::toSeconds(event.to - event.from);
}

bool isAt(base::Vec3 place, base::Vec3 expected) {
  if (base::distance(place, expected) < kSameMm) {
    return true;
  }
  qWarning("at %g %g %g", place.x, place.y, place.z);
  return false;
}

}  // namespace

class TestEquipment : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void toolChangeTakesItsTime() {
    Bench bench("T3\nM6\nT=\"MILL_6\" M6\nM6\nM0\nM30\n");
    const double seconds = bench.finish();
    QVERIFY2(std::abs(seconds - 10.0) < 0.05, std::to_string(seconds).c_str());
    const std::vector<ControlEvent> changes = bench.events(Kind::ToolChange);
    QCOMPARE(changes.size(), std::size_t{3});
    QCOMPARE(changes[0].value, 3.0);
    QCOMPARE(changes[0].name, std::string("MILL_10"));
    QCOMPARE(changes[0].line.value, 2U);
    QCOMPARE(secondsOf(changes[0]), 5.0);
    QCOMPARE(changes[1].value, 4.0);
    QCOMPARE(secondsOf(changes[2]), 0.0);  // it is in the spindle already
    const machine::EquipmentState state = bench->state().equipment;
    QCOMPARE(state.tool, 4);
    QCOMPARE(state.toolName, std::string("MILL_6"));
    QCOMPARE(state.edge, 1);
  }

  /// T alone selects; the tool in the spindle stays, also beyond the end of a program.
  void selectionIsNoChange() {
    Bench bench("T3 M6\nT4\nM0\nM30\n");
    bench.finish();
    QCOMPARE(bench->state().equipment.tool, 3);
    QCOMPARE(bench->state().equipment.nextTool, 4);
    QVERIFY(bench->cycleStart());
    bench.finish();
    QCOMPARE(bench->state().equipment.edge, 0);
    bench.start("G0 D2 Z0\nM0\nM30\n");
    bench.finish();
    QVERIFY(isAt(bench.machineMm(), {0, 0, 102.45}));
  }

  void lengthCountsAlongTheTool_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::newRow("after M6") << "T3 M6\nG0 X1 Y2 Z3" << 1.0 << 2.0 << 105.5;
    QTest::newRow("in its block") << "T3 M6 D2 G0 X1 Y2 Z3" << 1.0 << 2.0 << 105.45;
    QTest::newRow("another edge") << "T3 M6\nG0 Z3\nD2 Z4" << 0.0 << 0.0 << 106.45;
    QTest::newRow("D0") << "T3 M6\nG0 Z3\nD0\nX5 Z4" << 5.0 << 0.0 << 4.0;
    // The axis moves only where it is programmed.
    QTest::newRow("D without Z") << "T3 M6\nG0 Z3\nD0\nX5" << 5.0 << 0.0 << 105.5;
    QTest::newRow("T0") << "T3 M6\nT0 M6\nG0 Z3" << 0.0 << 0.0 << 3.0;
    QTest::newRow("G18") << "G18 T3 M6\nG0 Y2 Z3" << 0.0 << 104.5 << 3.0;
    QTest::newRow("G19") << "G19 T3 M6\nG0 X1 Z3" << 103.5 << 0.0 << 3.0;
    QTest::newRow("another plane") << "T3 M6\nG0 Z3\nG18 Y0 Z3" << 0.0 << 102.5 << 3.0;
    // An increment passes the change of length as well (SD42442, as delivered).
    QTest::newRow("increment") << "T3 M6\nG0 Z3\nG91 D2 Z1" << 0.0 << 0.0 << 106.45;
    QTest::newRow("machine coordinates")
        << "T3 M6\nG54\nG0 X10 Z10\nSUPA G0 Z0" << 10.0 << 0.0 << 102.5;
    QTest::newRow("machine coordinates, D0")
        << "T3 M6\nG55\nG0 X10 Z10\nSUPA G0 X0 Z0 D0" << 0.0 << 0.0 << 0.0;
    QTest::newRow("G53") << "G55\nG0 X10\nG53 X20 Z30\nX11" << 111.0 << 0.0 << 30.0;
    QTest::newRow("G153") << "G55\nG0 X10\nG153 X20 Z30\nX11" << 111.0 << 0.0 << 30.0;
  }
  void lengthCountsAlongTheTool() {
    QFETCH(QString, text);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
    config.axes[2].startMm = 0.0;
    Bench bench(text.toStdString() + "\nM0\nM30\n", config);
    bench.finish();
    QCOMPARE(bench->state().alarm, 0);
    QVERIFY(isAt(bench.machineMm(), {x, y, z}));
  }

  void offsetsShiftTheProgram_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::newRow("G54") << "G54 G0 X1 Y2 Z3" << 1.0 << 2.0 << -197.0;
    QTest::newRow("another one") << "G54 G0 X1 Y2 Z3\nG55 X1" << 101.0 << 2.0 << -197.0;
    QTest::newRow("G505") << "G505 G0 X1 Y2 Z3" << -99.0 << -98.0 << -197.0;
    QTest::newRow("G500") << "G505 G0 X1 Y2 Z3\nG500 X1" << 1.0 << -98.0 << -197.0;
    QTest::newRow("without value") << "G599 G0 X1 Y2 Z3" << 1.0 << 2.0 << 3.0;
    QTest::newRow("with a frame") << "G55\nTRANS X10\nAROT RPL=90\nG0 X1 Y2 Z3" << 108.0 << 1.0
                                  << -197.0;
    QTest::newRow("by group") << "G[8]=3 G0 X1 Y2 Z3" << 101.0 << 2.0 << -197.0;
    QTest::newRow("arc") << "G55 G0 X10 Y0 Z0\nG3 X-10 I-10 F5000" << 90.0 << 0.0 << -200.0;
    QTest::newRow("increment") << "G54 G0 X1 Y2 Z3\nG55 G91 X1" << 102.0 << 2.0 << -197.0;
    // Siemens, list manual of the system variables, $P_UIFR: a value that is written holds with the
    // next G500 to G599.
    QTest::newRow("written offset") << "G54 G0 X1 Y2 Z3\n$P_UIFR[1,X,TR]=50 "
                                       "$P_UIFR[1,Y,TR]=-5\nG54\nG0 X1 Y2"
                                    << 51.0 << -3.0 << -197.0;
    QTest::newRow("written, not yet selected")
        << "G54 G0 X1 Y2 Z3\n$P_UIFR[1,X,TR]=50\nG0 X2" << 2.0 << 2.0 << -197.0;
    QTest::newRow("tip of the tool")
        << "G54\nTRAORI\nG0 X1 Y2 Z3 C10\nTRAFOOF\nG0 X4" << 4.0 << 2.0 << -197.0;
    QTest::newRow("fixed point") << "G54 G0 X1 Y2 Z3\nG75 X1=0 Z1=0\nG0 Y3" << 0.0 << 3.0 << 280.0;
    QTest::newRow("second fixed point")
        << "G54 T3 M6\nG0 X1\nG75 FP=2 X0 Y0 Z0" << 375.0 << 325.0 << 280.0;
  }
  void offsetsShiftTheProgram() {
    QFETCH(QString, text);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    Bench bench(text.toStdString() + "\nM0\nM30\n");
    bench.finish();
    QCOMPARE(bench->state().alarm, 0);
    QVERIFY(isAt(bench.machineMm(), {x, y, z}));
  }

  /// A program begins and ends in the frame of G500, which may have a value of its own.
  void g500HasAValue() {
    machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
    config.workOffsetsMm[machine::kNoWorkOffsetKey] = {100.0, 0.0, -10.0};
    Bench bench("G91 G0 X1\nG90 Y2 Z3\nG54 Z3\nG500 Z3\nM0\nM30\n", config);
    QVERIFY(isAt(bench->state().commandMm, {-100, 0, 60}));
    bench.finish();
    QCOMPARE(bench->state().alarm, 0);
    QVERIFY(isAt(bench.machineMm(), {1, 2, -7}));
    QVERIFY(isAt(bench->state().commandMm, {-99, 2, 3}));
  }

  /// SD42110.
  void feedBeforeAnyF() {
    machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
    Bench without("G1 X1\nM0\nM30\n", config);
    without.finish();
    QCOMPARE(without->state().alarm, 10860);
    config.defaultFeedMmPerS = 1.0;
    Bench moving("G1 X1\nM0\nM30\n", config);
    QVERIFY(moving.finish() > 1.0);
    QCOMPARE(moving->state().alarm, 0);
  }

  /// The trace and the display are in the frame of the program.
  void traceIsInTheWorkpiece() {
    Bench bench("G55\nG1 X10 Y0 Z5 F5000\nX20\nM0\nM30\n");
    bench.finish();
    const trace::ControlTrace& trace = bench->trace();
    QCOMPARE(trace.blocks.size(), std::size_t{2});
    QVERIFY(isAt(trace.blocks[0].targetMm, {10, 0, 5}));
    QVERIFY(isAt(trace.samples.back().commandMm, {20, 0, 5}));
    bench.runS(1.0);
    QVERIFY(base::distance(trace.samples.back().actualMm, {20, 0, 5}) < 1e-3);
    QVERIFY(isAt(bench->state().commandMm, {20, 0, 5}));
    QCOMPARE(bench->state().equipment.workOffset, 55);
    QCOMPARE(bench.events(Kind::WorkOffset).front().value, 55.0);
    QVERIFY(bench->cycleStart());
    bench.finish();
    QVERIFY(isAt(bench->state().commandMm, {120, 0, -195}));  // the machine's own frame
  }

  /// Travel is that of the machine.
  void limitsAreOfTheMachine() {
    Bench inside("G55\nG0 X270 Z400\nM0\nM30\n");
    inside.finish();
    QCOMPARE(inside->state().alarm, 0);
    Bench outside("G55\nG0 X280\nM0\nM30\n");
    outside.finish();
    QCOMPARE(outside->state().alarm, 10720);
    Bench tooLong("T7 M6\nG0 Z150\nM0\nM30\n");
    tooLong.finish();
    QCOMPARE(tooLong->state().alarm, 10720);
  }

  void alarms_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("alarm");
    QTest::newRow("tool") << "T11" << 17190;
    QTest::newRow("name") << "T=\"MILL\"" << 17190;
    QTest::newRow("edge") << "T3 M6\nD3" << 17180;
    QTest::newRow("edge of another tool") << "T3 M6\nD2\nT4 M6\nD2" << 17180;
    QTest::newRow("edge without a tool") << "D2" << 0;
    QTest::newRow("fixed point") << "G75 FP=3 X1=0" << 12470;
    QTest::newRow("axis of the machine") << "G0 X1=5" << 12550;
  }
  void alarms() {
    QFETCH(QString, text);
    QFETCH(int, alarm);
    Bench bench(text.toStdString() + "\nM30\n");
    bench.finish();
    QCOMPARE(bench->state().alarm, alarm);
  }

  void missingToolsCanBeAccepted() {
    machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
    config.tools->acceptsMissing = true;
    Bench bench("T99 M6\nD3 G0 Z20\nT=\"OTHER\" M6\nM0\nM30\n", config);
    bench.finish();
    QCOMPARE(bench->state().alarm, 0);
    QVERIFY(isAt(bench.machineMm(), {0, 0, 20}));
    QCOMPARE(bench->state().equipment.toolName, std::string("OTHER"));
  }

  void axesWaitForTheSpindle() {
    Bench bench("S10000 M3 G1 X1 F600\nS5000\nX2\nM5\nX3\nM0\nM30\n");
    const base::Instant begin = bench->now();
    bench.runS(0.5);
    QVERIFY(std::abs(bench->state().equipment.spindlePerMin - 5000.0) < 100.0);
    QCOMPARE(bench->state().equipment.spindleCommandPerMin, 10000.0);
    bench.finish();
    const std::vector<ControlEvent> events = bench.events(Kind::Spindle);
    QCOMPARE(events.size(), std::size_t{3});
    QCOMPARE(events[0].value, 10000.0);
    QCOMPARE(secondsOf(events[0]), 1.0);
    QCOMPARE(events[1].value, 5000.0);
    QCOMPARE(secondsOf(events[1]), 0.5);
    QCOMPARE(events[2].value, 0.0);
    QCOMPARE(secondsOf(events[2]), 0.0);  // nothing waits for the standstill
    const std::vector<trace::ExecutedBlock>& blocks = bench->trace().blocks;
    QVERIFY(blocks[0].from >= begin + base::fromSeconds(1.0));
    QVERIFY(blocks[1].from - blocks[0].to >= base::fromSeconds(0.5));
    QVERIFY(blocks[2].from - blocks[1].to < base::fromSeconds(0.01));
  }

  void spindleTurnsBothWays() {
    Bench bench("M3 S4000\nM4\nM0\nM30\n");
    bench.finish();
    QCOMPARE(secondsOf(bench.events(Kind::Spindle).back()), 0.8);
    QCOMPARE(bench->state().equipment.spindlePerMin, -4000.0);
    QVERIFY(bench->cycleStart());
    bench.finish();
    bench.runS(1.0);
    QCOMPARE(bench->state().equipment.spindlePerMin, 0.0);  // M30
  }

  /// S1= and M1= are those of the first spindle, others are none of this machine.
  void firstSpindleHasANumber() {
    Bench bench("S1=3000 M1=3\nS2=500 M2=4\nM0\nM30\n");
    bench.finish();
    QCOMPARE(bench->state().equipment.spindlePerMin, 3000.0);
  }

  /// As on the control: no alarm, but the spindle turns no faster than it can.
  void speedIsLimited() {
    Bench bench("S30000 M3\nG95 G1 X10 F0.01\nM0\nM30\n");
    bench.runS(2.5);
    QCOMPARE(bench->state().equipment.spindlePerMin, 20000.0);
    QVERIFY(bench->state().equipment.spindleLimited);
    QVERIFY(std::abs(bench->state().feedMmPerS - 20000.0 * 0.01 / 60.0) < 1e-6);
  }

  void dwellInTurns() {
    Bench bench("S600 M3\nG4 S30\nG4 F0.5\nM0\nM30\n");
    bench.finish();
    const std::vector<ControlEvent> dwells = bench.events(Kind::Dwell);
    QCOMPARE(dwells.size(), std::size_t{2});
    QCOMPARE(secondsOf(dwells[0]), 3.0);
    QCOMPARE(secondsOf(dwells[1]), 0.5);
    QCOMPARE(bench->state().equipment.spindlePerMin, 600.0);
  }

  void coolant() {
    Bench bench("M8\nM7\nM0\nM9\nM30\n");
    bench.finish();
    QVERIFY(bench->state().equipment.flood && bench->state().equipment.mist);
    QVERIFY(bench->cycleStart());
    bench.finish();
    const std::vector<ControlEvent> events = bench.events(Kind::Coolant);
    QCOMPARE(events.size(), std::size_t{3});
    QCOMPARE(events[0].value, 1.0);
    QCOMPARE(events[1].value, 3.0);
    QCOMPARE(events[2].value, 0.0);
  }

  void stopWaitsForCycleStart() {
    for (const bool optionally : {true, false}) {
      machine::MachineConfig config = *machine::loadPreset("dmu75-mill");
      config.optionalStop = optionally;
      Bench bench("G1 X1 F6000\nM0\nX2\nM1 X3\nM30\n", config);
      bench.finish();
      bench.runS(5.0);
      QVERIFY(bench->state().channel == ChannelStatus::Interrupted);
      QVERIFY(bench->state().program == ProgramStatus::Stopped);
      QVERIFY(bench->state().waitsForStart);
      QCOMPARE(bench->state().alarm, 0);
      QVERIFY(isAt(bench->state().commandMm, {1, 0, 50}));
      QVERIFY(bench->cycleStart());
      QVERIFY(bench->state().program == ProgramStatus::Running);
      bench.finish();
      QVERIFY(isAt(bench->state().commandMm, {3, 0, 50}));
      // M1 stops, after the motion of its block, if the operator has said so.
      QCOMPARE(bench->state().waitsForStart, optionally);
      QCOMPARE(bench.events(Kind::Stop).size(), optionally ? std::size_t{2} : std::size_t{1});
      QVERIFY(secondsOf(bench.events(Kind::Stop).front()) > 4.9);
    }
  }

  void resetEndsTheWait() {
    Bench bench("S1000 M3\nG1 X1 F6000\nM0\nX2\nM30\n");
    bench.finish();
    bench->reset();
    bench.runS(1.0);
    QVERIFY(bench->state().channel == ChannelStatus::Reset);
    QVERIFY(!bench->state().waitsForStart);
    QCOMPARE(bench->state().equipment.spindlePerMin, 0.0);
    bench.start("G1 X5 F6000\nM30\n");
    bench.finish();
    QVERIFY(isAt(bench->state().commandMm, {5, 0, 50}));
  }

  /// A machine without them: such words change nothing, to the last bit.
  void wordsHaveNoEffectWithoutEquipment() {
    const auto traceOf = [](const char* text) {
      Bench bench(text, "dmu75");
      bench.finish();
      return trace::printControlTrace(bench->trace());
    };
    QCOMPARE(
        traceOf(
            "T3 M6 D2 S1000 M3\nG64 G1 X1 F6000 M8\nG54\nG55 X2 Y3 M1\nD0 M0\nX3 M5\nM9\nM30\n"),
        traceOf("\nG64 G1 X1 F6000\n\nX2 Y3\n\nX3\n\nM30\n"));
  }

  void traceIsReadBack() {
    Bench bench("G55 T=\"MILL_6\" M6\nS500 M4\nG1 X1 F6000\nM30\n");
    bench.finish();
    const trace::ControlTrace& trace = bench->trace();
    const auto back = trace::parseControlTrace(trace::printControlTrace(trace));
    QVERIFY(back);
    QCOMPARE(back->events.size(), trace.events.size());
    for (std::size_t i = 0; i < trace.events.size(); ++i) {
      const ControlEvent& event = back->events[i];
      QVERIFY(event.kind == trace.events[i].kind && event.from == trace.events[i].from &&
              event.to == trace.events[i].to && event.line == trace.events[i].line);
      QCOMPARE(event.value, trace.events[i].value);
      QCOMPARE(event.name, trace.events[i].name);
    }
  }
};

RIVULET_TEST(TestEquipment)
#include "tst_equipment.moc"
