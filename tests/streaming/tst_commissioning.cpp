// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The test for method credit: which virtual machines pass, which fail and why, and that no axis
/// moves for it.

#include <QtTest>
#include <algorithm>

#include "machine/machine.h"
#include "streaming/run/run.h"
#include "streaming/setup/commissioning.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using streaming::Commissioning;
using streaming::CommissioningPlan;
using streaming::StreamError;

namespace {

struct World {
  explicit World(machine::MachineConfig config) : machine(std::move(config), 1), link(machine) {}
  explicit World(const char* preset = "dmu75") : World(*machine::loadPreset(preset)) {}
  base::Result<Commissioning> test(const CommissioningPlan& plan = {}) {
    return streaming::commission(link, link, plan);
  }
  machine::Machine machine;
  streaming::SimulatedLink link;
};

QStringList failedIn(const Commissioning& result) {
  QStringList names;
  for (const streaming::CommissioningCheck& check : result.checks) {
    if (!check.passed) {
      names << QString::fromStdString(check.name);
    }
  }
  return names;
}

}  // namespace

class TestCommissioning : public QObject {
  Q_OBJECT

 private slots:
  void machinesThatReadWhenTheyPassABlockPass_data() {
    QTest::addColumn<QString>("preset");
    for (const std::string& name : machine::presetNames()) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }
  void machinesThatReadWhenTheyPassABlockPass() {
    QFETCH(QString, preset);
    World world(*machine::loadPreset(preset.toStdString()));
    const base::Vec3 before = world.machine.state().commandMm;
    const auto result = world.test();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY2(result->passed(), qPrintable(failedIn(*result).join(u',')));
    QCOMPARE(result->checks.size(), std::size_t{5});
    QCOMPARE(result->answered, result->asked);
    QVERIFY(result->answered >= 5 && result->slowestAnswer < 1s);
    QVERIFY(base::distance(before, world.machine.state().commandMm) == 0.0);
    QVERIFY(world.machine.trace().blocks.empty());
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void valuesCachedUntilStopreFail() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.rRead = machine::RParameterReading::CachedUntilStopre;
    World world(config);
    const auto result = world.test();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY(!result->passed());
    QCOMPARE(result->answered, 0);
    QCOMPARE(failedIn(*result), (QStringList{QStringLiteral("answers-while-busy"),
                                             QStringLiteral("main-run-seen-by-program")}));
    // It has ended by itself.
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void jumpsThatStopFail() {
    machine::MachineConfig config = *machine::loadPreset("dmu75");
    config.jumpStops = true;
    World world(config);
    const auto result = world.test();
    QVERIFY2(result.has_value(), result ? "" : result.error().text().c_str());
    QVERIFY(!result->passed());
    QVERIFY(failedIn(*result).contains(QStringLiteral("answers-while-busy")));
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void othersCellsAreLeftAlone() {
    World world;
    for (int cell = 0; cell < 100; ++cell) {
      world.machine.writeRParameter(cell, 500.0 + cell);
    }
    world.machine.advance(world.machine.now() + 20ms);
    CommissioningPlan plan;
    plan.firstCell = 60;
    const auto result = world.test(plan);
    QVERIFY(result && result->passed());
    for (int cell = 0; cell < 100; ++cell) {
      if (cell < 60 || cell > 69) {
        QCOMPARE(world.machine.rParameter(cell), 500.0 + cell);
      }
    }
  }

  void nothingIsDoneWhileAProgramRuns() {
    World world;
    QVERIFY(world.machine.storeProgram("A.MPF", "G4 F100\nM30\n", true).has_value());
    QVERIFY(world.machine.selectProgram("A.MPF") && world.machine.cycleStart());
    const auto result = world.test();
    QVERIFY(!result && result.error().code == StreamError::ChannelBusy);
    QCOMPARE(world.machine.programNames().size(), std::size_t{1});
  }

  void itCanBeBrokenOff() {
    World world;
    int told = 0;
    const auto result = streaming::commission(
        world.link, world.link, {}, [&](streaming::CommissioningStep) { return ++told < 5; });
    QVERIFY(!result && result.error().code == StreamError::Cancelled);
    // Left alone, the program ends.
    world.machine.advance(world.machine.now() + 2min);
    QVERIFY(world.machine.state().channel == machine::ChannelStatus::Reset);
  }

  void aMissingCellIsSaid() {
    World world;
    CommissioningPlan plan;
    plan.firstCell = 95;
    const auto result = world.test(plan);
    QVERIFY(!result);
    QVERIFY(world.machine.trace().blocks.empty());
  }
};

RIVULET_TEST(TestCommissioning)
#include "tst_commissioning.moc"
