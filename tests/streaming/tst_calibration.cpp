// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "machine/machine.h"
#include "streaming/calibration.h"
#include "streaming/simulation/simulated_link.h"

using namespace rivulet;
using streaming::CalibrationError;
using streaming::CalibrationPlan;

class TestCalibration : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// In virtual time the figures of the preset come out again.
  void recoversThePreset() {
    const machine::MachineConfig config = *machine::loadPreset("dmu75");
    machine::Machine machine(config, 3);
    streaming::SimulatedLink link(machine);
    CalibrationPlan plan;
    plan.firstCell = 0;
    plan.lastCell = 99;
    plan.shots = 400;
    plan.arrays = false;
    double last = 0.0;
    const auto result = streaming::calibrate(link, plan, [&](double share, base::Duration) {
      const bool rises = share > last && share <= 1.0 + 1e-9;
      last = share;
      return rises;
    });
    QVERIFY2(result, result ? "" : result.error().text().c_str());
    QVERIFY(std::abs(last - 1.0) < 1e-9);
    QCOMPARE(result->series.size(), std::size_t{28});
    const double node = base::toMilliseconds(config.access.nodeTimeMean);
    const double deviation = base::toMilliseconds(config.access.nodeTimeDeviation);
    for (const auto& [fit, overhead] : {std::pair(result->read, config.access.readOverhead),
                                        std::pair(result->write, config.access.writeOverhead)}) {
      QVERIFY2(std::abs(fit.nodeMs / node - 1.0) < 0.02, std::to_string(fit.nodeMs).c_str());
      QVERIFY2(std::abs(fit.overheadMs - base::toMilliseconds(overhead)) < 0.3,
               std::to_string(fit.overheadMs).c_str());
      QVERIFY2(std::abs(fit.nodeDeviationMs / deviation - 1.0) < 0.15,
               std::to_string(fit.nodeDeviationMs).c_str());
    }
  }

  /// Whether a control charges arrays per node or per element comes out, whichever it is.
  void tellsWhatAnArrayCosts() {
    for (const char* preset : {"dmu75", "dmu75-arrays"}) {
      const machine::MachineConfig config = *machine::loadPreset(preset);
      machine::Machine machine(config, 5);
      streaming::SimulatedLink link(machine);
      CalibrationPlan plan;
      plan.firstCell = 0;
      plan.lastCell = 99;
      plan.shots = 200;
      const auto result = streaming::calibrate(link, plan);
      QVERIFY2(result, result ? "" : result.error().text().c_str());
      QVERIFY(result->forms.has_value());
      QVERIFY(result->forms->best() == opcua::Grouping::ArrayCount);
      const bool perNode = config.access.arrays.charge == machine::ArrayCharge::Node;
      const double expected = perNode ? 0.0 : base::toMilliseconds(config.access.nodeTimeMean);
      for (const auto& fit : {result->arrayRead, result->arrayWrite}) {
        QVERIFY(fit.has_value());
        QVERIFY2(std::abs(fit->nodeMs - expected) < 0.05, std::to_string(fit->nodeMs).c_str());
      }
    }
  }

  void measuresNoArraysWhereThereAreNone() {
    machine::MachineConfig config = *machine::loadPreset("ideal");
    config.access.arrays.write = machine::ArrayWrite::FirstOnly;
    machine::Machine machine(config, 5);
    streaming::SimulatedLink link(machine);
    CalibrationPlan plan;
    plan.firstCell = 10;
    plan.lastCell = 19;
    const auto result = streaming::calibrate(link, plan);
    QVERIFY(result.has_value());
    QVERIFY(result->forms && result->forms->best() == opcua::Grouping::List);
    QVERIFY(!result->arrayRead && !result->arrayWrite);
    QCOMPARE(result->series.size(), std::size_t{16});
    plan.arrays = false;
    QVERIFY(!streaming::calibrate(link, plan)->forms);
  }

  void leavesTheCellsAsTheyWere() {
    machine::Machine machine(*machine::loadPreset("ideal"), 1);
    streaming::SimulatedLink link(machine);
    for (int cell = 0; cell < 100; ++cell) {
      machine.writeRParameter(cell, 0.5 * cell);
    }
    CalibrationPlan plan;
    plan.firstCell = 20;
    plan.lastCell = 59;
    int calls = 0;
    const auto cancelled =
        streaming::calibrate(link, plan, [&](double, base::Duration) { return ++calls < 500; });
    QVERIFY(!cancelled);
    QVERIFY(cancelled.error().code == CalibrationError::Cancelled);
    QVERIFY(streaming::calibrate(link, plan));
    machine.advance(machine.now() + std::chrono::seconds(1));
    for (int cell = 0; cell < 100; ++cell) {
      QCOMPARE(machine.ncRParameter(cell), 0.5 * cell);
    }
  }

  void refusesWhatWouldDoHarm() {
    machine::Machine machine(*machine::loadPreset("ideal"), 1);
    streaming::SimulatedLink link(machine);
    CalibrationPlan plan;
    plan.firstCell = 10;
    plan.lastCell = 9;
    QVERIFY(streaming::calibrate(link, plan).error().code == CalibrationError::NoCells);
    plan.lastCell = 200;
    QVERIFY(!streaming::calibrate(link, plan));
    plan.lastCell = 20;
    QVERIFY(machine.storeProgram("A.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(machine.selectProgram("A.MPF"));
    QVERIFY(machine.cycleStart());
    QVERIFY(streaming::calibrate(link, plan).error().code == CalibrationError::ChannelBusy);
  }
};

QTEST_APPLESS_MAIN(TestCalibration)
#include "tst_calibration.moc"
