// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "machine/path_planner.h"

using namespace rivulet;
using machine::PathPlanner;

namespace {

machine::MachineConfig config() {
  return *machine::loadPreset("dmu75");
}

struct Run {
  std::vector<base::Vec3> commandsMm;
  std::vector<trace::ExecutedBlock> executed;
  double speedMmPerSMax = 0.0;
};

Run drive(PathPlanner& planner, base::Duration cycle, int cyclesMax = 200000) {
  Run run;
  run.commandsMm.push_back(planner.commandMm());
  base::Instant now{};
  while (planner.blockCount() > 0 && cyclesMax-- > 0) {
    now += cycle;
    planner.step(now, run.executed);
    run.commandsMm.push_back(planner.commandMm());
    run.speedMmPerSMax = std::max(run.speedMmPerSMax, planner.speedMmPerS());
  }
  return run;
}

/// A straight block that goes on in the next one.
machine::PreparedMotion straight(unsigned line, base::Vec3 targetMm, double feedMmPerS) {
  machine::PreparedMotion motion;
  motion.line = {line};
  motion.targetMm = targetMm;
  motion.feedMmPerS = feedMmPerS;
  motion.end = machine::BlockEnd::Rounded;
  motion.roundingMm = 0.01;
  return motion;
}

}  // namespace

class TestPathPlanner : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A straight line: the time is that of accelerate, cruise, brake, to the cycle.
  void straightLineTakesTheTextbookTime() {
    const machine::MachineConfig machine = config();
    PathPlanner planner(machine, {});
    planner.append(straight(1, {100.0, 0.0, 0.0}, 50.0));
    const Run run = drive(planner, machine.interpolationCycle);
    const double a = machine.axes[0].accelerationMmPerS2Max;
    const double expectedS = 100.0 / 50.0 + 50.0 / a;
    QCOMPARE(run.executed.size(), std::size_t{1});
    const double tookS = base::toSeconds(run.executed[0].to - run.executed[0].from);
    QVERIFY2(std::abs(tookS - expectedS) < 1e-6, "closed form: only rounding to nanoseconds");
    QVERIFY(run.speedMmPerSMax <= 50.0 + 1e-9);
  }

  /// Random contours: every block in order, the path ends at rest at the last target, no axis
  /// exceeds its speed, and the axis speed never changes by more in a cycle than braking, a
  /// corner step and acceleration together allow.
  void keepsTheLimitsOnRandomContours() {
    const machine::MachineConfig machine = config();
    const double cycleS = base::toSeconds(machine.interpolationCycle);
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      base::Random random(seed);
      PathPlanner planner(machine, {});
      base::Vec3 at;
      std::vector<base::Vec3> targets;
      const double feed = 1.0 + 600.0 * random.uniform();
      for (int i = 0; i < 80; ++i) {
        const double step = i % 3 == 0 ? 20.0 * random.uniform() : 0.5 + random.uniform();
        at = at + step * base::Vec3{random.normal(), random.normal(), 0.2 * random.normal()};
        targets.push_back(at);
        planner.append(straight(static_cast<unsigned>(i + 1), at, feed));
      }
      const Run run = drive(planner, machine.interpolationCycle);
      QCOMPARE(run.executed.size(), targets.size());
      for (std::size_t i = 0; i < targets.size(); ++i) {
        QVERIFY(run.executed[i].targetMm == targets[i]);
        QVERIFY(i == 0 || run.executed[i].from >= run.executed[i - 1].to);
      }
      QVERIFY(base::distance(planner.commandMm(), at) < 1e-9);
      QVERIFY(planner.isStanding());
      QVERIFY(run.speedMmPerSMax <= feed + 1e-9);
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        for (std::size_t i = 1; i < run.commandsMm.size(); ++i) {
          const double speed = (run.commandsMm[i][axis] - run.commandsMm[i - 1][axis]) / cycleS;
          QVERIFY(std::abs(speed) <= machine.axes[axis].speedMmPerSMax + 1e-6);
        }
      }
    }
  }

  void exactStopStandsAtEveryCorner() {
    machine::MachineConfig machine = config();
    const auto timeOf = [&](bool exactStop) {
      PathPlanner planner(machine, {});
      for (int i = 1; i <= 10; ++i) {
        auto motion = straight(static_cast<unsigned>(i), {static_cast<double>(i), 0.0, 0.0}, 50.0);
        motion.end = exactStop ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
        planner.append(motion);
      }
      return base::toSeconds(drive(planner, machine.interpolationCycle).executed.back().to);
    };
    // On a straight line G64 runs through; every stop in between costs v/a.
    const double a = machine.axes[0].accelerationMmPerS2Max;
    QVERIFY(std::abs(timeOf(true) - timeOf(false) - 9.0 * 50.0 / a) < 1e-6);
  }

  void abortBrakesAndForgets() {
    const machine::MachineConfig machine = config();
    PathPlanner planner(machine, {});
    planner.append(straight(1, {100.0, 0.0, 0.0}, 50.0));
    planner.append(straight(2, {200.0, 0.0, 0.0}, 50.0));
    std::vector<trace::ExecutedBlock> executed;
    base::Instant now{};
    for (int i = 0; i < 100; ++i) {
      planner.step(now += machine.interpolationCycle, executed);
    }
    const double atMm = planner.commandMm().x;
    planner.abort();
    for (int i = 0; i < 100; ++i) {
      planner.step(now += machine.interpolationCycle, executed);
    }
    QCOMPARE(planner.blockCount(), 0);
    QVERIFY(planner.isStanding());
    QVERIFY(executed.empty());
    const double brakeMm = 50.0 * 50.0 / (2.0 * machine.axes[0].accelerationMmPerS2Max);
    QVERIFY(std::abs(planner.commandMm().x - atMm - brakeMm) < 1e-6);
    QVERIFY(planner.endMm() == planner.commandMm());
  }
};

QTEST_APPLESS_MAIN(TestPathPlanner)
#include "tst_path_planner.moc"
