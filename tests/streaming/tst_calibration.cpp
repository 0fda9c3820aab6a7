// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "machine/machine.h"
#include "opcua/error.h"
#include "streaming/setup/calibration.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Duration;
using opcua::Grouping;
using streaming::Calibration;
using streaming::CalibrationError;
using streaming::CalibrationHooks;
using streaming::CalibrationPlan;
using streaming::CalibrationProgress;

namespace {

CalibrationPlan planOf(int first, int last, int shots) {
  CalibrationPlan plan;
  plan.firstCell = first;
  plan.lastCell = last;
  plan.shots = shots;
  return plan;
}

base::Result<Calibration> measure(const machine::MachineConfig& config,
                                  const CalibrationPlan& plan) {
  machine::Machine machine(config, 5);
  streaming::SimulatedLink link(machine);
  return streaming::calibrate(link, plan);
}

std::string textOf(const base::Result<Calibration>& result) {
  return result ? "" : result.error().text();
}

void fill(machine::Machine& machine) {
  for (int cell = 0; cell < 100; ++cell) {
    machine.writeRParameter(cell, 0.5 * cell + 0.25);
  }
}

void requireFilled(machine::Machine& machine) {
  machine.advance(machine.now() + std::chrono::seconds(1));
  for (int cell = 0; cell < 100; ++cell) {
    QCOMPARE(machine.ncRParameter(cell), 0.5 * cell + 0.25);
  }
}

}  // namespace

class TestCalibration : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// In virtual time the figures of the preset come out again, form by form.
  void recoversThePreset() {
    for (const char* preset : {"dmu75", "dmu75-arrays"}) {
      const machine::MachineConfig config = *machine::loadPreset(preset);
      machine::Machine machine(config, 3);
      streaming::SimulatedLink link(machine);
      double last = 0.0;
      int planned = 0;
      CalibrationHooks hooks;
      bool rises = true;
      hooks.progress = [&](const CalibrationProgress& progress) {
        rises = rises && progress.share >= last && progress.share <= 1.0;
        last = progress.share;
        planned = progress.shotsPlanned;
        return true;
      };
      const auto result = streaming::calibrate(link, planOf(0, 99, 500), hooks);
      QVERIFY2(result, textOf(result).c_str());
      QVERIFY(rises);
      QCOMPARE(last, 1.0);
      QCOMPARE(planned, 7 * 8 * 500);
      QCOMPARE(result->series.size(), std::size_t{7 * 8});
      QVERIFY(!result->isCut());
      for (const streaming::AccessSeries& series : result->series) {
        QCOMPARE(series.shotsMade, 500);
        QCOMPARE(series.percentiles.back().perMille, 990);
        QVERIFY(!series.histogram.counts.empty());
        QVERIFY(series.min <= series.mean && series.mean <= series.tail());
        QVERIFY(series.tail() <= series.max);
      }
      QVERIFY(result->best() == Grouping::ArrayCount);

      const bool perNode = config.access.arrays.charge == machine::ArrayCharge::Node;
      const double node = base::toMilliseconds(config.access.nodeTimeMean);
      const double deviation = base::toMilliseconds(config.access.nodeTimeDeviation);
      for (const bool write : {false, true}) {
        const double overhead =
            base::toMilliseconds(write ? config.access.writeOverhead : config.access.readOverhead);
        const auto near = [&](Grouping grouping, double a, double b) {
          const streaming::AccessFit* fit = result->fit(write, grouping);
          QVERIFY(fit != nullptr);
          const std::string text = std::string(opcua::groupingName(grouping)) + " " +
                                   std::to_string(fit->overheadMs) + " + n * " +
                                   std::to_string(fit->nodeMs);
          QVERIFY2(std::abs(fit->overheadMs - a) < 0.2, text.c_str());
          QVERIFY2(std::abs(fit->nodeMs - b) < 0.02 * (b + overhead), text.c_str());
          QVERIFY2(fit->residualShare < 0.05, std::to_string(fit->residualShare).c_str());
        };
        near(Grouping::List, overhead, node);
        near(Grouping::Single, 0.0, overhead + node);
        for (const Grouping array : {Grouping::ArrayCount, Grouping::ArrayRange}) {
          near(array, perNode ? overhead + node : overhead, perNode ? 0.0 : node);
        }
        const double found = result->fit(write, Grouping::List)->nodeDeviationMs;
        QVERIFY2(std::abs(found / deviation - 1.0) < 0.15, std::to_string(found).c_str());
      }
    }
  }

  /// The long kinds are cut, for all to see; the whole stays within the time, and the fit holds.
  void fitsTheBudget() {
    const machine::MachineConfig config = *machine::loadPreset("dmu75");
    CalibrationPlan plan = planOf(0, 99, 500);
    plan.budget = std::chrono::minutes{4};
    const auto result = measure(config, plan);
    QVERIFY2(result, textOf(result).c_str());
    QVERIFY(result->isCut());
    QVERIFY2(result->took < plan.budget * 11 / 10,
             std::to_string(base::toSeconds(result->took)).c_str());
    QVERIFY(result->took > plan.budget * 8 / 10);
    int least = plan.shots;
    for (const streaming::AccessSeries& series : result->series) {
      least = std::min(least, series.shotsMade);
      QVERIFY(series.shotsMade >= 5);
      if (series.nodes == 1) {
        QCOMPARE(series.shotsMade, plan.shots);
      }
      QCOMPARE(series.percentile(990).has_value(), series.shotsMade >= 100);
      QVERIFY(series.tail() >= series.mean);
    }
    QVERIFY(least < 30);
    const streaming::AccessFit* fit = result->fit(true, Grouping::List);
    QVERIFY(std::abs(fit->nodeMs / base::toMilliseconds(config.access.nodeTimeMean) - 1.0) < 0.02);
    QVERIFY(std::abs(fit->overheadMs - base::toMilliseconds(config.access.writeOverhead)) < 0.3);

    // The estimate before the start, and the one that knows an earlier calibration.
    for (const Calibration* earlier : {static_cast<const Calibration*>(nullptr), &*result}) {
      const Duration expected = streaming::expectedDuration(plan, earlier);
      QVERIFY(expected > plan.budget * 9 / 10 && expected < plan.budget * 11 / 10);
    }
    plan.budget = {};
    const double exact = base::toSeconds(measure(config, planOf(0, 19, 500))->took);
    const double expected =
        base::toSeconds(streaming::expectedDuration(planOf(0, 19, 500), &*result));
    QVERIFY2(std::abs(expected / exact - 1.0) < 0.05, std::to_string(expected / exact).c_str());
  }

  /// A budget that is too short for anything still gives the first shots of each kind.
  void looksAtEachKindInAnyCase() {
    CalibrationPlan plan = planOf(0, 9, 500);
    plan.budget = std::chrono::milliseconds{1};
    const auto result = measure(*machine::loadPreset("dmu75"), plan);
    QVERIFY2(result, textOf(result).c_str());
    for (const streaming::AccessSeries& series : result->series) {
      QCOMPARE(series.shotsMade, 5);
      QVERIFY(series.tail() == series.max);
    }
  }

  /// A control that gets slower meanwhile is slower for all kinds alike: the line stays straight.
  void spreadsADriftOverAllKinds() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.access.nodeTimeDeviation = {};
    machine::Machine machine(config, 5);
    streaming::SimulatedLink link(machine);
    std::vector<int> order;
    link.onWrite = [&order](base::RequestId, int cell, double) { order.push_back(cell); };
    CalibrationPlan plan = planOf(0, 9, 20);
    plan.arrays = false;
    QVERIFY(streaming::calibrate(link, plan));
    // Each tenth of the writes has the same mixture: cell 9 is written by the largest kind only.
    const std::size_t restored = 10;
    const std::size_t all = order.size() - restored;
    for (std::size_t part = 0; part < 5; ++part) {
      const auto from = order.begin() + static_cast<std::ptrdiff_t>(all * part / 5);
      const auto to = order.begin() + static_cast<std::ptrdiff_t>(all * (part + 1) / 5);
      const auto large = std::count(from, to, 9);
      QVERIFY2(large >= 7 && large <= 10, std::to_string(large).c_str());
    }
  }

  void interpolatesTheTail() {
    const auto result = measure(*machine::loadPreset("dmu75"), planOf(0, 49, 200));
    QVERIFY2(result, textOf(result).c_str());
    const auto tail = [&](int nodes) { return *result->tail(true, Grouping::List, nodes); };
    Duration last{};
    for (int nodes = 1; nodes <= 120; ++nodes) {
      QVERIFY(tail(nodes) > last);
      QVERIFY(tail(nodes) >= result->fit(true, Grouping::List)->at(nodes));
      last = tail(nodes);
    }
    for (const streaming::AccessSeries& series : result->series) {
      QVERIFY(*result->tail(series.write, series.grouping, series.nodes) == series.tail());
    }
    CalibrationPlan plan = planOf(0, 49, 20);
    plan.arrays = false;
    QVERIFY(!measure(*machine::loadPreset("dmu75"), plan)->tail(true, Grouping::ArrayCount, 3));
  }

  void measuresNoArraysWhereThereAreNone() {
    machine::MachineConfig config = *machine::loadPreset("ideal");
    config.access.arrays.write = machine::ArrayWrite::FirstOnly;
    CalibrationPlan plan = planOf(10, 19, 50);
    const auto result = measure(config, plan);
    QVERIFY2(result, textOf(result).c_str());
    QVERIFY(result->best() == Grouping::List);
    QVERIFY(result->fit(false, Grouping::ArrayCount) == nullptr);
    QCOMPARE(result->series.size(), std::size_t{16});
    QCOMPARE(result->fits.size(), std::size_t{4});
    plan.arrays = false;
    QVERIFY(!measure(config, plan)->forms);
  }

  /// Whenever it is cancelled, and at the end: every cell has its value.
  void leavesTheCellsAsTheyWere() {
    for (const int limit : {1, 2, 50, 500, 1'000'000}) {
      machine::Machine machine(*machine::loadPreset("dmu75"), 1);
      streaming::SimulatedLink link(machine);
      fill(machine);
      int calls = 0;
      CalibrationHooks hooks;
      hooks.progress = [&](const CalibrationProgress&) { return ++calls < limit; };
      const auto result = streaming::calibrate(link, planOf(20, 59, 20), hooks);
      QCOMPARE(result.has_value(), limit == 1'000'000);
      if (!result) {
        QVERIFY(result.error().code == CalibrationError::Cancelled);
        QVERIFY(result.error().message.find("have their old values") != std::string::npos);
      }
      requireFilled(machine);
    }
  }

  /// The connection breaks at any request, also while the forms are tried: a clear error, and the
  /// cells are put back over the next connection.
  void putsTheCellsBackAfterALostLink() {
    int inTheProof = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      machine::Machine machine(*machine::loadPreset("dmu75"), seed);
      fill(machine);
      streaming::LinkFaults faults;
      faults.disconnectProbability = seed % 2 == 0 ? 0.1 : 0.01;
      streaming::FaultyLink link(machine, faults, seed);
      CalibrationHooks hooks;
      bool measuring = false;
      bool asked = false;
      hooks.progress = [&](const CalibrationProgress& progress) {
        measuring = measuring || progress.phase != CalibrationProgress::Phase::Forms;
        return true;
      };
      hooks.reconnect = [&]() -> opcua::Link* {
        asked = true;
        link.setFaults({});
        link.reconnect();
        return &link;
      };
      const auto result = streaming::calibrate(link, planOf(20, 39, 20), hooks);
      QVERIFY(!result);
      QVERIFY2(result.error().code == opcua::LinkError::ConnectionLost, textOf(result).c_str());
      if (asked) {
        QVERIFY2(result.error().message.find("restore") != std::string::npos,
                 textOf(result).c_str());
        inTheProof += measuring ? 0 : 1;
      }
      requireFilled(machine);
    }
    QVERIFY(inTheProof >= 3);
  }

  /// Without another connection the message says whether anything can be wrong.
  void saysWhatTheCellsHold() {
    for (const bool proving : {false, true}) {
      machine::Machine machine(*machine::loadPreset("dmu75"), 1);
      fill(machine);
      streaming::FaultyLink link(machine, {}, 1);
      streaming::LinkFaults broken;
      broken.disconnectProbability = 1.0;
      CalibrationHooks hooks;
      hooks.progress = [&](const CalibrationProgress& progress) {
        if (proving || progress.shotsMade == 30) {
          link.setFaults(broken);
        }
        return true;
      };
      const auto result = streaming::calibrate(link, planOf(20, 39, 20), hooks);
      QVERIFY(!result);
      const std::string text = textOf(result);
      QVERIFY2((text.find("have their old values") != std::string::npos) == !proving, text.c_str());
      QVERIFY2((text.find("test values") != std::string::npos) == proving, text.c_str());
    }
  }

  /// A program that is started meanwhile ends it: from then on nothing is written.
  void givesWayToAProgram() {
    machine::Machine machine(*machine::loadPreset("dmu75"), 1);
    streaming::SimulatedLink link(machine);
    fill(machine);
    QVERIFY(machine.storeProgram("A.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(machine.selectProgram("A.MPF"));
    bool started = false;
    std::size_t after = 0;
    link.onWrite = [&](base::RequestId, int, double) { after += started ? 1 : 0; };
    CalibrationHooks hooks;
    hooks.progress = [&](const CalibrationProgress& progress) {
      if (!started && progress.shotsMade == 100) {
        started = machine.cycleStart().has_value();
      }
      return true;
    };
    const auto result = streaming::calibrate(link, planOf(20, 29, 100), hooks);
    QVERIFY(!result);
    QVERIFY(result.error().code == CalibrationError::ChannelBusy);
    QVERIFY(started);
    // The turn that was in progress: each kind once, 1 to 10 cells of four forms.
    QVERIFY2(after <= 4 * (1 + 2 + 5 + 10), std::to_string(after).c_str());
    requireFilled(machine);
  }

  void refusesWhatWouldDoHarm() {
    machine::Machine machine(*machine::loadPreset("ideal"), 1);
    streaming::SimulatedLink link(machine);
    const auto refused = [&link](int first, int last) {
      return streaming::calibrate(link, planOf(first, last, 50)).error().code;
    };
    QVERIFY(refused(10, 9) == CalibrationError::NoCells);
    QVERIFY(refused(-1, 9) == CalibrationError::NoCells);
    QVERIFY(refused(10, 200) == CalibrationError::NoCells);
    QVERIFY(machine.storeProgram("A.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(machine.selectProgram("A.MPF"));
    QVERIFY(machine.cycleStart());
    QVERIFY(refused(10, 20) == CalibrationError::ChannelBusy);
  }
};

RIVULET_TEST(TestCalibration)
#include "tst_calibration.moc"
