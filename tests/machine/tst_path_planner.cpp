// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "machine/path_planner.h"
#include "support/test_program.h"

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

/// A machine whose limits differ from axis to axis and bind at ordinary feeds.
machine::MachineConfig weakMachine(base::Random& random) {
  machine::MachineConfig machine = config();
  for (machine::AxisLimits& axis : machine.axes) {
    axis.speedMmPerSMax = 100.0 + 200.0 * random.uniform();
    axis.accelerationMmPerS2Max = 200.0 + 2000.0 * random.uniform();
    axis.jerkMmPerS3Max = 5000.0 + 40000.0 * random.uniform();
  }
  return machine;
}

/// A program as a person or a CAM system might write it, and worse: dense and coarse, tangential
/// and kinked, with arcs in all planes, exact stops, corners rounded either way.
class RandomProgram {
 public:
  RandomProgram(base::Random& random, machine::Dynamics dynamics)
      : m_random(random), m_dynamics(dynamics) {}

  machine::PreparedMotion next() {
    machine::PreparedMotion motion;
    motion.line = {++m_line};
    motion.dynamics = m_dynamics;
    if (m_line % 17 == 1) {
      m_feedMmPerS = 2.0 + 150.0 * m_random.uniform() * m_random.uniform();
      m_stepMm = std::pow(10.0, -1.5 + 3.0 * m_random.uniform());
      m_wildness = m_random.uniform() < 0.5 ? 0.05 : 1.5;
      m_roundingMm = m_random.uniform() < 0.2 ? 0.0 : 0.3 * m_random.uniform();
      m_kind = m_random.below(2) == 0 ? machine::RoundingKind::Deviation
                                      : machine::RoundingKind::Distance;
    }
    motion.feedMmPerS = m_feedMmPerS;
    motion.end = m_random.below(8) == 0 ? machine::BlockEnd::ExactStop : machine::BlockEnd::Rounded;
    motion.rounding = m_kind;
    motion.roundingMm = m_roundingMm;
    m_course = m_course + m_wildness * base::Vec3{m_random.normal(), m_random.normal(),
                                                  0.3 * m_random.normal()};
    m_course = (1.0 / base::norm(m_course)) * m_course;
    const double stepMm = m_stepMm * (0.1 + m_random.uniform());
    if (m_random.below(4) == 0) {
      arc(motion, stepMm);
    } else {
      motion.targetMm = m_at + stepMm * m_course;
    }
    m_at = motion.targetMm;
    return motion;
  }

 private:
  /// Half of them leave in the direction of the block before, as CAM systems write them.
  void arc(machine::PreparedMotion& motion, double stepMm) {
    machine::ArcPath arc;
    base::Vec3 away{m_random.normal(), m_random.normal(), m_random.normal()};
    arc.axis = base::cross(m_course, away);
    arc.axis = (1.0 / base::norm(arc.axis)) * arc.axis;
    const double radiusMm = stepMm * (0.3 + 3.0 * m_random.uniform());
    const bool tangential = m_random.below(2) == 0;
    const base::Vec3 course = tangential ? m_course : (1.0 / base::norm(away)) * away;
    base::Vec3 radial = base::cross(course, arc.axis);
    radial = (1.0 / base::norm(radial)) * radial;
    const base::Vec3 normal = base::cross(arc.axis, radial);
    arc.centreMm = m_at - radiusMm * radial;
    arc.sweepRad = 0.05 + 6.0 * m_random.uniform();
    const double riseMm = m_random.below(2) == 0 ? 0.0 : stepMm * m_random.normal();
    const double endMm = radiusMm * (1.0 + 1e-4 * m_random.normal());
    motion.targetMm = arc.centreMm + (endMm * std::cos(arc.sweepRad)) * radial +
                      (endMm * std::sin(arc.sweepRad)) * normal + riseMm * arc.axis;
    motion.arc = arc;
    m_course = std::cos(arc.sweepRad) * normal - std::sin(arc.sweepRad) * radial;
  }

  base::Random& m_random;
  machine::Dynamics m_dynamics;
  unsigned m_line = 0;
  base::Vec3 m_at;
  base::Vec3 m_course{1.0, 0.0, 0.0};
  double m_feedMmPerS = 10.0;
  double m_stepMm = 1.0;
  double m_wildness = 0.1;
  double m_roundingMm = 0.0;
  machine::RoundingKind m_kind = machine::RoundingKind::Deviation;
};

/// Largest use of the axes' limits seen over a run, 1 for all of it.
struct Usage {
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

Usage usageOf(const std::vector<base::Vec3>& commandsMm, const machine::MachineConfig& machine) {
  const double h = base::toSeconds(machine.interpolationCycle);
  Usage usage;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const machine::AxisLimits& limits = machine.axes[axis];
    const auto at = [&](std::size_t i) { return commandsMm[i][axis]; };
    for (std::size_t i = 3; i < commandsMm.size(); ++i) {
      const double v = (at(i) - at(i - 1)) / h;
      const double a = (at(i) - 2.0 * at(i - 1) + at(i - 2)) / (h * h);
      const double j = (at(i) - 3.0 * at(i - 1) + 3.0 * at(i - 2) - at(i - 3)) / (h * h * h);
      usage.speed = std::max(usage.speed, std::abs(v) / limits.speedMmPerSMax);
      usage.acceleration =
          std::max(usage.acceleration, std::abs(a) / limits.accelerationMmPerS2Max);
      usage.jerk = std::max(usage.jerk, std::abs(j) / limits.jerkMmPerS3Max);
    }
  }
  return usage;
}

/// Points on a sine, 0.5 mm apart along X, as many as 100 blocks ahead.
double sineSeconds(const machine::MachineConfig& machine, double feedMmPerMin,
                   machine::Dynamics dynamics, double waveMm = 20.0, int ahead = 100) {
  constexpr int kPoints = 400;
  const double pi = std::acos(-1.0);
  PathPlanner planner(machine, {});
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  int appended = 0;
  do {
    for (; appended < kPoints && planner.blockCount() < ahead; ++appended) {
      const double x = 0.5 * (appended + 1);
      machine::PreparedMotion motion =
          straight(static_cast<unsigned>(appended + 1),
                   {x, 5.0 * std::sin(2.0 * pi * x / waveMm), 0.0}, feedMmPerMin / 60.0);
      motion.dynamics = dynamics;
      planner.append(motion);
    }
    planner.step(now += machine.interpolationCycle, executed);
  } while (appended < kPoints || planner.blockCount() > 0);
  return base::toSeconds(executed.back().to - executed.front().from);
}

/// A random program from the first to the last block. @param ahead  blocks known to the look-ahead
double programSeconds(std::uint64_t seed, const machine::MachineConfig& machine, double feedFactor,
                      int ahead) {
  base::Random random(seed);
  RandomProgram program(random, machine::Dynamics::Soft);
  constexpr int kBlocks = 60;
  PathPlanner planner(machine, {});
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  int appended = 0;
  do {
    for (; appended < kBlocks && planner.blockCount() < ahead; ++appended) {
      machine::PreparedMotion motion = program.next();
      motion.feedMmPerS *= feedFactor;
      planner.append(motion);
    }
    planner.step(now += machine.interpolationCycle, executed);
  } while (appended < kBlocks || planner.blockCount() > 0);
  return base::toSeconds(executed.back().to - executed.front().from);
}

/// Differences of set points are only as good as their last bits: 1e-13 mm over the cycle's cube.
constexpr double kUsageMax = 1.0 + 1e-4;

}  // namespace

class TestPathPlanner : public QObject {
  Q_OBJECT

  static constexpr std::uint64_t kSeeds = 300;

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

  /// Whatever the program, however its blocks arrive, whatever the override does: no axis exceeds
  /// its speed, acceleration or (SOFT) jerk in any cycle; every block is executed, in order; the
  /// path ends at rest at the last target.
  void keepsTheLimitsOnRandomPrograms_data() {
    QTest::addColumn<bool>("soft");
    QTest::addColumn<bool>("overrides");
    QTest::newRow("brisk") << false << false;
    QTest::newRow("brisk, override") << false << true;
    QTest::newRow("soft") << true << false;
    QTest::newRow("soft, override") << true << true;
  }
  void keepsTheLimitsOnRandomPrograms() {
    QFETCH(bool, soft);
    QFETCH(bool, overrides);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      base::Random random(seed);
      const machine::MachineConfig machine = weakMachine(random);
      PathPlanner planner(machine, {});
      RandomProgram program(random, soft ? machine::Dynamics::Soft : machine::Dynamics::Brisk);
      const int blocks = 60;
      const std::uint64_t hurry = 1 + random.below(20);  // how late blocks come
      std::vector<base::Vec3> targets;
      std::vector<base::Vec3> commands(3, planner.commandMm());
      std::vector<trace::ExecutedBlock> executed;
      base::Instant now{};
      for (int cycle = 0; cycle < 2000000; ++cycle) {
        while (static_cast<int>(targets.size()) < blocks &&
               (planner.blockCount() < 2 || random.below(hurry) == 0)) {
          const machine::PreparedMotion motion = program.next();
          targets.push_back(motion.targetMm);
          planner.append(motion);
        }
        if (overrides && random.below(100) == 0) {
          planner.setOverride(random.below(4) == 0 ? 0.0 : 2.0 * random.uniform());
        }
        if (planner.blockCount() == 0) {
          break;
        }
        planner.step(now += machine.interpolationCycle, executed);
        commands.push_back(planner.commandMm());
      }
      commands.insert(commands.end(), 3, planner.commandMm());
      const Usage usage = usageOf(commands, machine);
      const QString where =
          QStringLiteral("seed %1: speed %2, acceleration %3, jerk %4 of the limits")
              .arg(seed)
              .arg(usage.speed)
              .arg(usage.acceleration)
              .arg(usage.jerk);
      QVERIFY2(usage.speed <= kUsageMax, qPrintable(where));
      QVERIFY2(usage.acceleration <= kUsageMax, qPrintable(where));
      QVERIFY2(!soft || usage.jerk <= kUsageMax, qPrintable(where));
      QVERIFY2(executed.size() == targets.size(), qPrintable(where));
      for (std::size_t i = 0; i < targets.size(); ++i) {
        QVERIFY(executed[i].targetMm == targets[i]);
        QVERIFY(i == 0 || executed[i].from >= executed[i - 1].to);
      }
      QVERIFY(base::distance(planner.commandMm(), targets.back()) < 1e-9);
      QVERIFY(planner.isStanding());
    }
  }

  /// A dense smooth contour: a higher feed never takes longer. The states at the joints follow
  /// rules and are not searched for the best ones: a permille is left for that.
  void feedNeverSlowsASineDown() {
    const machine::MachineConfig machine = config();
    for (const machine::Dynamics dynamics : {machine::Dynamics::Soft, machine::Dynamics::Brisk}) {
      for (const double waveMm : {10.0, 20.0, 40.0}) {
        double before = 1e9;
        for (const double feed : {500.0, 1000.0, 2000.0, 3000.0, 4000.0, 6000.0, 12000.0}) {
          const double seconds = sineSeconds(machine, feed, dynamics, waveMm);
          QVERIFY2(seconds <= 1.001 * before,
                   qPrintable(QStringLiteral("wave %1 mm, F %2: %3 s, before %4 s")
                                  .arg(waveMm)
                                  .arg(feed)
                                  .arg(seconds)
                                  .arg(before)));
          before = seconds;
        }
      }
    }
  }

  /// The time of a program never grows with the feed, with a limit of the axes, or with the blocks
  /// that the look-ahead knows, by more than a cycle per block.
  void moreNeverTakesLonger() {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      base::Random random(seed);
      const machine::MachineConfig machine = weakMachine(random);
      const double cyclesS = 60.0 * base::toSeconds(machine.interpolationCycle);
      const double seconds = programSeconds(seed, machine, 1.0, 20);
      const auto check = [&](const char* what, double more) {
        QVERIFY2(more <= seconds + cyclesS,
                 qPrintable(QStringLiteral("seed %1, more %2: %3 s, before %4 s")
                                .arg(seed)
                                .arg(QLatin1String(what))
                                .arg(more)
                                .arg(seconds)));
      };
      check("feed", programSeconds(seed, machine, 1.5, 20));
      check("look-ahead", programSeconds(seed, machine, 1.0, 60));
      const auto scaled = [&](double machine::AxisLimits::*limit) {
        machine::MachineConfig stronger = machine;
        for (machine::AxisLimits& axis : stronger.axes) {
          axis.*limit *= 1.5;
        }
        return programSeconds(seed, stronger, 1.0, 20);
      };
      check("speed", scaled(&machine::AxisLimits::speedMmPerSMax));
      check("acceleration", scaled(&machine::AxisLimits::accelerationMmPerS2Max));
      check("jerk", scaled(&machine::AxisLimits::jerkMmPerS3Max));
    }
  }

  /// With SOFT half of the axis's jerk goes along a line; the rest is the textbook.
  void softLineTakesTheTextbookTime() {
    const machine::MachineConfig machine = config();
    PathPlanner planner(machine, {});
    machine::PreparedMotion motion = straight(1, {0.0, 300.0, 0.0}, 400.0);
    motion.dynamics = machine::Dynamics::Soft;
    planner.append(motion);
    const Run run = drive(planner, machine.interpolationCycle);
    const double a = machine.axes[1].accelerationMmPerS2Max;
    const double j = 0.5 * machine.axes[1].jerkMmPerS3Max;
    QVERIFY(400.0 < a * a / j);  // no phase of constant acceleration
    const double expectedS = 300.0 / 400.0 + 2.0 * std::sqrt(400.0 / j);
    const double tookS = base::toSeconds(run.executed[0].to - run.executed[0].from);
    QVERIFY2(std::abs(tookS - expectedS) < 1e-6, qPrintable(QString::number(tookS)));
  }

  /// A corner is passed as near as requested, without a stop, in both forms of the request.
  void roundsCornersWithinTolerance() {
    const machine::MachineConfig machine = config();
    const double pi = std::acos(-1.0);
    for (const machine::Dynamics dynamics : {machine::Dynamics::Brisk, machine::Dynamics::Soft}) {
      for (const double turnDegrees : {5.0, 30.0, 90.0, 150.0}) {
        for (const double limitMm : {0.01, 0.2}) {
          for (const machine::RoundingKind kind :
               {machine::RoundingKind::Deviation, machine::RoundingKind::Distance}) {
            const double turn = turnDegrees * pi / 180.0;
            PathPlanner planner(machine, {});
            machine::PreparedMotion first = straight(1, {50.0, 0.0, 0.0}, 20.0);
            machine::PreparedMotion second =
                straight(2, {50.0 + 50.0 * std::cos(turn), 50.0 * std::sin(turn), 0.0}, 20.0);
            first.dynamics = second.dynamics = dynamics;
            first.rounding = kind;
            first.roundingMm = limitMm;
            planner.append(first);
            planner.append(second);
            double nearestMm = 1e9;
            double slowest = 1e9;
            std::vector<trace::ExecutedBlock> executed;
            base::Instant now{};
            while (planner.blockCount() > 0) {
              planner.step(now += machine.interpolationCycle, executed);
              const double toCornerMm = base::distance(planner.commandMm(), first.targetMm);
              nearestMm = std::min(nearestMm, toCornerMm);
              if (toCornerMm < 5.0) {
                slowest = std::min(slowest, planner.speedMmPerS());
              }
            }
            // Cut = radius·tan(turn/2), deviation = cut·tan(turn/4).
            const double deviationMm =
                kind == machine::RoundingKind::Deviation ? limitMm : limitMm * std::tan(turn / 4.0);
            const double cycleMm = 20.0 * base::toSeconds(machine.interpolationCycle);
            QVERIFY(nearestMm >= deviationMm * (1.0 - 1e-9));
            QVERIFY(nearestMm <= std::hypot(deviationMm, cycleMm));
            QVERIFY(slowest > 0.0);
            QVERIFY(executed[0].to > executed[0].from && executed[1].from == executed[0].to);
          }
        }
      }
    }
  }

  void overrideScalesTheFeed() {
    const machine::MachineConfig machine = config();
    const auto timeOf = [&](double factor) {
      PathPlanner planner(machine, {});
      planner.setOverride(factor);
      planner.append(straight(1, {100.0, 0.0, 0.0}, 20.0));
      return base::toSeconds(drive(planner, machine.interpolationCycle).executed.back().to);
    };
    const double a = machine.axes[0].accelerationMmPerS2Max;
    QVERIFY(std::abs(timeOf(0.5) - (100.0 / 10.0 + 10.0 / a)) < 1e-6);
    QVERIFY(std::abs(timeOf(1.5) - (100.0 / 30.0 + 30.0 / a)) < 1e-6);
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

RIVULET_TEST(TestPathPlanner)
#include "tst_path_planner.moc"
