// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Rotary axes of the virtual machine: their limits in every cycle, how the feed counts, what the
/// trace says. The judge works from set points alone.

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "machine/machine.h"
#include "machine/path_planner.h"
#include "support/test_program.h"

using namespace rivulet;
using machine::PathPlanner;

namespace {

/// Differences of set points are only as good as their last bits.
constexpr double kUsageMax = 1.0 + 1e-4;

machine::MachineConfig fiveAxes() {
  return *machine::loadPreset("dmu75-5axis");
}

/// Limits that bind at ordinary feeds, different from axis to axis.
machine::MachineConfig weakMachine(base::Random& random) {
  machine::MachineConfig config = fiveAxes();
  for (machine::AxisLimits& axis : config.axes) {
    axis.speedMmPerSMax = 100.0 + 200.0 * random.uniform();
    axis.accelerationMmPerS2Max = 200.0 + 2000.0 * random.uniform();
    axis.jerkMmPerS3Max = 5000.0 + 40000.0 * random.uniform();
  }
  for (auto& axis : config.rotaryAxes) {
    if (axis) {
      axis->speedDegPerSMax = 10.0 + 200.0 * random.uniform();
      axis->accelerationDegPerS2Max = 200.0 + 1000.0 * random.uniform();
      axis->jerkDegPerS3Max = 1000.0 + 20000.0 * random.uniform();
    }
  }
  return config;
}

/// Set points of five axes, X Y Z A C.
using SetPoint = std::array<double, 5>;

SetPoint setPointOf(const PathPlanner& planner) {
  const base::Vec3 mm = planner.commandMm();
  return {mm.x, mm.y, mm.z, planner.commandDeg()[0], planner.commandDeg()[2]};
}

struct Usage {
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

Usage usageOf(const std::vector<SetPoint>& points, const machine::MachineConfig& config) {
  const double h = base::toSeconds(config.interpolationCycle);
  Usage usage;
  for (std::size_t axis = 0; axis < 5; ++axis) {
    const auto* rotary = axis < 3 ? nullptr : &*config.rotaryAxes[axis == 3 ? 0 : 2];
    const double speed = rotary ? rotary->speedDegPerSMax : config.axes[axis].speedMmPerSMax;
    const double acceleration =
        rotary ? rotary->accelerationDegPerS2Max : config.axes[axis].accelerationMmPerS2Max;
    const double jerk = rotary ? rotary->jerkDegPerS3Max : config.axes[axis].jerkMmPerS3Max;
    const auto at = [&](std::size_t i) { return points[i][axis]; };
    for (std::size_t i = 3; i < points.size(); ++i) {
      const double v = (at(i) - at(i - 1)) / h;
      const double a = (at(i) - 2.0 * at(i - 1) + at(i - 2)) / (h * h);
      const double j = (at(i) - 3.0 * at(i - 1) + 3.0 * at(i - 2) - at(i - 3)) / (h * h * h);
      usage.speed = std::max(usage.speed, std::abs(v) / speed);
      usage.acceleration = std::max(usage.acceleration, std::abs(a) / acceleration);
      usage.jerk = std::max(usage.jerk, std::abs(j) / jerk);
    }
  }
  return usage;
}

/// Lines and arcs, with and without a turn, some of them nothing but a turn.
class RandomProgram {
 public:
  RandomProgram(base::Random& random, machine::Dynamics dynamics)
      : m_random(random), m_dynamics(dynamics) {}

  machine::PreparedMotion next() {
    machine::PreparedMotion motion;
    motion.line = {++m_line};
    motion.dynamics = m_dynamics;
    if (m_line % 13 == 1) {
      m_feed = 2.0 + 100.0 * m_random.uniform();
      m_stepMm = std::pow(10.0, -1.5 + 3.0 * m_random.uniform());
      m_stepDeg = std::pow(10.0, -2.0 + 3.5 * m_random.uniform());
      m_wildness = m_random.below(2) == 0 ? 0.0 : 1.0;
      m_evenly = m_random.below(2) == 0;
    }
    motion.feedMmPerS = m_feed;
    motion.feedDegPerS = m_feed;
    motion.end = m_random.below(9) == 0 ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
    motion.roundingMm = 0.05;
    const std::uint64_t kind = m_random.below(6);
    motion.targetMm = m_at;
    if (kind != 0) {
      m_course =
          m_course + m_wildness * base::Vec3{0.3 * m_random.normal(), m_random.normal(), 0.1};
      m_course = (1.0 / base::norm(m_course)) * m_course;
      motion.targetMm = m_at + (m_stepMm * (0.2 + m_random.uniform())) * m_course;
    }
    if (kind == 1) {
      halfCircle(motion);
    }
    for (const std::size_t axis : {0U, 2U}) {
      // As CAM systems write it: degrees per mm that change from block to block, or hardly.
      const double turn = m_evenly ? m_stepDeg : m_stepDeg * m_random.normal();
      m_deg[axis] += kind == 2 ? 0.0 : turn;
    }
    motion.targetDeg = m_deg;
    m_at = motion.targetMm;
    return motion;
  }

 private:
  void halfCircle(machine::PreparedMotion& motion) {
    machine::ArcPath arc;
    arc.axis = {0.0, 0.0, 1.0};
    arc.centreMm = 0.5 * (m_at + motion.targetMm);
    arc.sweepRad = std::acos(-1.0);
    motion.targetMm.z = m_at.z;
    arc.centreMm.z = m_at.z;
    motion.arc = arc;
  }

  base::Random& m_random;
  machine::Dynamics m_dynamics;
  unsigned m_line = 0;
  base::Vec3 m_at;
  base::Vec3 m_course{1.0, 0.0, 0.0};
  base::RotaryDeg m_deg{};
  double m_feed = 10.0;
  double m_stepMm = 1.0;
  double m_stepDeg = 1.0;
  double m_wildness = 0.0;
  bool m_evenly = false;
};

/// A program run to its end.
trace::ControlTrace traceOf(const std::string& text,
                            const machine::MachineConfig& config = fiveAxes(),
                            int* alarm = nullptr) {
  machine::Machine machine(config, 1);
  if (!machine.storeProgram("T.MPF", text, true) || !machine.selectProgram("T.MPF") ||
      !machine.cycleStart()) {
    qFatal("the program could not be started");
  }
  machine.advance(machine.now() + base::fromSeconds(60.0));
  if (alarm != nullptr) {
    *alarm = machine.state().alarm;
  }
  return machine.trace();
}

double secondsOf(const trace::ExecutedBlock& block) {
  return base::toSeconds(block.to - block.from);
}

}  // namespace

class TestRotary : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keepsTheLimitsOnRandomPrograms_data() {
    QTest::addColumn<bool>("soft");
    QTest::addColumn<bool>("overrides");
    QTest::newRow("brisk") << false << false;
    QTest::newRow("brisk, override") << false << true;
    QTest::newRow("soft") << true << false;
    QTest::newRow("soft, override") << true << true;
  }
  /// However blocks arrive: no axis exceeds a limit in any cycle, and each block ends exactly where
  /// it should, its angles included.
  void keepsTheLimitsOnRandomPrograms() {
    QFETCH(bool, soft);
    QFETCH(bool, overrides);
    double used = 0.0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      base::Random random(seed);
      const machine::MachineConfig config = weakMachine(random);
      PathPlanner planner(config, {});
      RandomProgram program(random, soft ? machine::Dynamics::Soft : machine::Dynamics::Brisk);
      const std::uint64_t hurry = 1 + random.below(20);
      std::vector<machine::PreparedMotion> given;
      std::vector<SetPoint> points(3, setPointOf(planner));
      std::vector<trace::ExecutedBlock> executed;
      base::Instant now{};
      for (int cycle = 0; cycle < 2000000; ++cycle) {
        while (given.size() < 50 && (planner.blockCount() < 2 || random.below(hurry) == 0)) {
          given.push_back(program.next());
          planner.append(given.back());
        }
        if (overrides && random.below(100) == 0) {
          planner.setOverride(random.below(4) == 0 ? 0.0 : 2.0 * random.uniform());
        }
        if (planner.blockCount() == 0) {
          break;
        }
        planner.step(now += config.interpolationCycle, executed);
        points.push_back(setPointOf(planner));
      }
      points.insert(points.end(), 3, setPointOf(planner));
      const Usage usage = usageOf(points, config);
      used = std::max(used, usage.speed);
      const QString where =
          QStringLiteral("seed %1: speed %2, acceleration %3, jerk %4 of the limits")
              .arg(seed)
              .arg(usage.speed)
              .arg(usage.acceleration)
              .arg(usage.jerk);
      QVERIFY2(usage.speed <= kUsageMax, qPrintable(where));
      QVERIFY2(usage.acceleration <= kUsageMax, qPrintable(where));
      QVERIFY2(!soft || usage.jerk <= kUsageMax, qPrintable(where));
      QVERIFY2(executed.size() == given.size(), qPrintable(where));
      for (std::size_t i = 0; i < given.size(); ++i) {
        QVERIFY(executed[i].targetMm == given[i].targetMm);
        QVERIFY(executed[i].targetDeg == given[i].targetDeg);
      }
      QVERIFY(planner.commandDeg() == given.back().targetDeg);
      QVERIFY(planner.isStanding());
    }
    QVERIFY2(used > 0.99, "no axis ever came to its speed: the programs prove nothing");
  }

  /// F is the path speed of X Y Z; a rotary axis goes along, and holds the path back where it is
  /// the slower one.
  void feedIsThatOfTheGeometryAxes() {
    const auto quick = traceOf("BRISK\nG1 X100 A10 F1200\nM30\n");
    QCOMPARE(quick.blocks.size(), std::size_t{1});
    const double a = fiveAxes().axes[0].accelerationMmPerS2Max;
    const double c = fiveAxes().rotaryAxes[0]->accelerationDegPerS2Max;
    QVERIFY(a * 0.1 < c);  // X is what limits the acceleration here
    QVERIFY(std::abs(secondsOf(quick.blocks[0]) - (100.0 / 20.0 + 20.0 / a)) < 1e-6);
    const auto slow = traceOf("BRISK\nG1 X10 A100 F60000\nM30\n");
    const double speed = fiveAxes().rotaryAxes[0]->speedDegPerSMax;
    QVERIFY(std::abs(secondsOf(slow.blocks[0]) - (100.0 / speed + speed / c)) < 1e-6);
  }

  /// Where only rotary axes turn, F is in degrees per minute.
  void feedOfATurnIsInDegrees() {
    const auto trace = traceOf("BRISK\nG1 A30 C40 F600\nM30\n");
    QCOMPARE(trace.blocks.size(), std::size_t{1});
    QCOMPARE(trace.blocks[0].lengthMm, 0.0);
    QCOMPARE(trace.blocks[0].turnDeg, 50.0);
    QVERIFY(trace.blocks[0].moves());
    // A takes 0.6 of the turn, C 0.8.
    const machine::MachineConfig config = fiveAxes();
    const double a = std::min(config.rotaryAxes[0]->accelerationDegPerS2Max / 0.6,
                              config.rotaryAxes[2]->accelerationDegPerS2Max / 0.8);
    QVERIFY(std::abs(secondsOf(trace.blocks[0]) - (50.0 / 10.0 + 10.0 / a)) < 1e-6);
    const auto inches = traceOf("BRISK\nG700\nG1 A30 C40 F600\nM30\n");
    QCOMPARE(secondsOf(inches.blocks[0]), secondsOf(trace.blocks[0]));
  }

  void anglesAreReadAndRecorded() {
    const auto trace = traceOf("R1=7\nG1 X1 A=R1 F600\nG91 A3 C-5\nG90 X2 A=IC(1) C=AC(90)\nM30\n");
    QCOMPARE(trace.blocks.size(), std::size_t{3});
    QVERIFY(trace.blocks[0].targetDeg == (base::RotaryDeg{7.0, 0.0, 0.0}));
    QVERIFY(trace.blocks[1].targetDeg == (base::RotaryDeg{10.0, 0.0, -5.0}));
    QVERIFY(trace.blocks[2].targetDeg == (base::RotaryDeg{11.0, 0.0, 90.0}));
    QVERIFY(trace.rotaryAxes == (base::RotarySet{true, false, true}));
    const trace::ControlSample& last = trace.samples.back();
    QVERIFY(std::abs(last.commandDeg[2] - 90.0) < 1e-9);
    QVERIFY(last.actualDeg[2] < last.commandDeg[2] && last.actualDeg[2] > 85.0);
    const auto back = trace::parseControlTrace(trace::printControlTrace(trace));
    QVERIFY(back.has_value());
    QVERIFY(back->rotaryAxes == trace.rotaryAxes);
    QCOMPARE(back->samples.size(), trace.samples.size());
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
      QVERIFY(back->samples[i].commandDeg == trace.samples[i].commandDeg);
      QVERIFY(back->samples[i].actualDeg == trace.samples[i].actualDeg);
    }
    QVERIFY(back->blocks[2].targetDeg == trace.blocks[2].targetDeg);
    QCOMPARE(back->blocks[2].turnDeg, trace.blocks[2].turnDeg);
  }

  void limitsOfTravelHold() {
    int alarm = 0;
    const auto trace = traceOf("G1 A119 F9000\nA121\nM30\n", fiveAxes(), &alarm);
    QCOMPARE(alarm, 10720);
    QCOMPARE(trace.blocks.size(), std::size_t{1});
  }

  /// A machine without them reads their words and moves nothing, as before.
  void wordsOfMissingAxesMoveNothing() {
    const auto trace = traceOf("G1 X1 B30 F600\nB40\nX2 A5\nM30\n");
    QCOMPARE(trace.blocks.size(), std::size_t{2});
    QVERIFY(trace.blocks[1].targetDeg == (base::RotaryDeg{5.0, 0.0, 0.0}));
    const auto three = traceOf("G1 X1 A30 F600\nM30\n", *machine::loadPreset("dmu75"));
    QCOMPARE(three.blocks[0].turnDeg, 0.0);
    QVERIFY(three.rotaryAxes == base::RotarySet{});
  }

  void presetsMayLackAndMustNotInvent() {
    QVERIFY(fiveAxes().rotarySet() == (base::RotarySet{true, false, true}));
    QVERIFY(machine::loadPreset("dmu75")->rotarySet() == base::RotarySet{});
    QVERIFY(fiveAxes().rotaryAt(3) == std::optional<std::size_t>(0));
    QVERIFY(fiveAxes().rotaryAt(4) == std::optional<std::size_t>(2));
    QVERIFY(!fiveAxes().rotaryAt(2) && !fiveAxes().rotaryAt(5));
  }
};

RIVULET_TEST(TestRotary)
#include "tst_rotary.moc"
