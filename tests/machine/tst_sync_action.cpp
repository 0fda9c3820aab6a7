// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Synchronized actions on the running machine.

#include <QtTest>
#include <cmath>

#include "machine/machine.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using machine::Machine;

namespace {

machine::MachineConfig config() {
  machine::MachineConfig machine = *machine::loadPreset("ideal");
  machine.resetDynamics = machine::Dynamics::Brisk;
  return machine;
}

void start(Machine& machine, const std::string& text) {
  QVERIFY(machine.storeProgram("A.MPF", text, true));
  QVERIFY(machine.selectProgram("A.MPF"));
  QVERIFY(machine.cycleStart());
}

/// Runs until the channel is in reset. @return the time it took
double finish(Machine& machine) {
  const base::Instant from = machine.now();
  while (machine.state().channel != machine::ChannelStatus::Reset && machine.now() - from < 10min) {
    machine.advance(machine.now() + 4ms);
  }
  return base::toSeconds(machine.now() - from);
}

}  // namespace

class TestSyncAction : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A counter set in the main run tells what has been reached; one set in the pre-run is early.
  void mainRunWritesWhenTheBlockRuns() {
    Machine machine(config(), 1);
    start(machine,
          "G64 F600\nG1 X10\nR1=1\nWHEN TRUE DO $R2=1\nX20\nWHEN TRUE DO $R2=2\nX30\nM30\n");
    machine.advance(machine.now() + 500ms);  // on the way to X10, which takes a second
    QCOMPARE(machine.ncRParameter(1), 1.0);
    QCOMPARE(machine.ncRParameter(2), 0.0);
    machine.advance(machine.now() + 7s);  // X has to come down from Z 50? it does not move
    finish(machine);
    QCOMPARE(machine.ncRParameter(2), 2.0);
  }

  void overrideSlowsThePath() {
    const auto timeWith = [](const char* action) {
      Machine machine(config(), 1);
      start(machine, std::string(action) + "G1 X60 F600\nM30\n");
      return finish(machine);
    };
    const double plain = timeWith("");
    const double halved = timeWith("ID=1 DO $AC_OVR=50\n");
    QVERIFY2(std::abs(halved / plain - 2.0) < 0.02, std::to_string(halved / plain).c_str());
    // From the middle of the block on.
    const double late = timeWith("ID=1 WHENEVER $AC_PATHN>0.5 DO $AC_OVR=50\n");
    QVERIFY2(std::abs(late / plain - 1.5) < 0.02, std::to_string(late / plain).c_str());
  }

  /// The client's hand on the feed: R5 is written from outside while the axes move.
  void clientControlsTheOverride() {
    Machine machine(config(), 1);
    machine.writeRParameter(5, 100.0);
    start(machine, "IDS=1 DO $AC_OVR=$R5\nG1 X300 F6000\nM30\n");
    machine.advance(machine.now() + 1s);
    QVERIFY(std::abs(machine.state().feedMmPerS - 100.0) < 1e-6);
    machine.writeRParameter(5, 20.0);
    machine.advance(machine.now() + 500ms);
    QVERIFY(std::abs(machine.state().feedMmPerS - 20.0) < 1e-6);
    machine.writeRParameter(5, 0.0);
    machine.advance(machine.now() + 500ms);
    QCOMPARE(machine.state().feedMmPerS, 0.0);
    machine.writeRParameter(5, 100.0);
    finish(machine);
    QVERIFY(std::abs(machine.state().commandMm.x - 300.0) < 1e-6);
  }

  void plainRIsTheValueAtInterpretation() {
    Machine machine(config(), 1);
    start(machine, "R1=7\nID=1 DO $R2=R1 $R3=$R1\nR1=8\nG1 X5 F600\nM30\n");
    finish(machine);
    QCOMPARE(machine.ncRParameter(2), 7.0);
    QCOMPARE(machine.ncRParameter(3), 8.0);
  }

  void triggers() {
    Machine machine(config(), 1);
    // X passes 10 mm once there and once back.
    start(machine,
          "G60 F6000\n"
          "ID=1 WHEN $AA_IM[X]>10 DO $R1=$R1+1\n"
          "ID=2 EVERY $AA_IM[X]>10 DO $R2=$R2+1\n"
          "ID=3 WHENEVER $AA_IM[X]>10 DO $R3=$R3+1\n"
          "ID=4 FROM $AA_IM[X]>10 DO $R4=$R4+1\n"
          "ID=5 DO $R5=$R5+1\n"
          "G1 X20\nX0\nX20\nX0\nM30\n");
    finish(machine);
    QCOMPARE(machine.ncRParameter(1), 1.0);
    QCOMPARE(machine.ncRParameter(2), 2.0);
    QVERIFY(machine.ncRParameter(3) > 50.0);
    QVERIFY(machine.ncRParameter(4) > machine.ncRParameter(3));
    QVERIFY(machine.ncRParameter(5) > machine.ncRParameter(4));
  }

  void overlayMovesTheAxisBesideThePath() {
    Machine machine(config(), 1);
    start(machine, "IDS=1 DO $AA_OFF[Y]=$R1\nG1 X60 F600\nM30\n");
    machine.writeRParameter(1, 2.0);
    machine.advance(machine.now() + 1s);
    QVERIFY(std::abs(machine.state().commandMm.y - 2.0) < 1e-9);
    machine.writeRParameter(1, 1000.0);  // stops at the limit
    machine.advance(machine.now() + 1s);
    QVERIFY(std::abs(machine.state().commandMm.y - 10.0) < 1e-9);
    machine.reset();
    machine.advance(machine.now() + 2s);
    QVERIFY(std::abs(machine.state().commandMm.y) < 1e-9);
  }

  /// MD36750: bit 0 adds up what is written in each cycle, bit 1 keeps the overlay over a reset and
  /// the end of a program.
  void overlayModeOfTheControl() {
    machine::MachineConfig adding = config();
    adding.overlay.mode = 1;
    Machine sum(adding, 1);
    start(sum, "ID=1 DO $AA_OFF[Y]=$R1\nR3=$MA_AA_OFF_MODE[Y]\nG4 F100\nM30\n");
    sum.writeRParameter(1, 0.001);
    sum.advance(sum.now() + 1s);
    QVERIFY(sum.state().overlayMm.y > 0.2);
    QCOMPARE(sum.ncRParameter(3), 1.0);
    for (const int mode : {0, 2}) {
      machine::MachineConfig control = config();
      control.overlay.mode = mode;
      const double stays = mode == 2 ? 0.5 : 0.0;
      for (const bool byReset : {true, false}) {
        Machine machine(control, 1);
        start(machine, "ID=1 DO $AA_OFF[Y]=0.5\nG1 X60 F6000\nR1=$AA_OFF_VAL[Y]\nM30\n");
        machine.advance(machine.now() + 200ms);
        QCOMPARE(machine.state().overlayMm.y, 0.5);
        if (byReset) {
          machine.reset();
        }
        finish(machine);
        machine.advance(machine.now() + 1s);
        QCOMPARE(machine.state().overlayMm.y, stays);
        QCOMPARE(machine.ncRParameter(1), byReset ? 0.0 : 0.5);
      }
    }
  }

  void actionsWithoutANumberHoldForOneBlock() {
    Machine machine(config(), 1);
    start(machine, "G60 F600\nG1 X1\nDO $R1=$R1+1\nX2\nG4 F1\nX3\nM30\n");
    finish(machine);
    // A millimetre at 10 mm/s takes 0.1 s, 25 cycles; not the second of the dwell.
    QVERIFY2(machine.ncRParameter(1) > 20.0 && machine.ncRParameter(1) < 40.0,
             std::to_string(machine.ncRParameter(1)).c_str());
  }

  void readingTheMainRunStopsThePreRun() {
    Machine machine(config(), 1);
    start(machine, "G64 F600\nG1 X10\nR1=$AA_IM[X]\nX20\nM30\n");
    finish(machine);
    QVERIFY(std::abs(machine.ncRParameter(1) - 10.0) < 1e-9);
  }

  void cancelledAndFaultyActionsEnd() {
    Machine machine(config(), 1);
    start(machine, "ID=1 DO $R1=$R1+1\nG60 F600\nG1 X1\nCANCEL(1)\nX2\nM30\n");
    finish(machine);
    QVERIFY(machine.ncRParameter(1) < 60.0);
    Machine faulty(config(), 1);
    start(faulty, "ID=1 DO $R[5000]=1\nG1 X50 F600\nM30\n");
    faulty.advance(faulty.now() + 1s);
    QCOMPARE(faulty.state().alarm, 17020);
  }
};

RIVULET_TEST(TestSyncAction)
#include "tst_sync_action.moc"
