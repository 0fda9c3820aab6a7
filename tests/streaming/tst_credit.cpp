// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Method credit compared with method window: whole runs in virtual time, and the cells during the
/// run. What a run may do at worst is in tst_window_faults.

#include <QtTest>
#include <algorithm>
#include <functional>

#include "base/random.h"
#include "base/units.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::StreamError;

namespace {

constexpr std::size_t kPoints = 140;
constexpr std::size_t kPerWindow = 7;

std::shared_ptr<const gcode::Program> contour(std::uint64_t seed) {
  base::Random random(seed);
  return streaming::programOf(streaming::drawContour({kPoints, 0.15, 0.15}, random));
}

RunSettings settings(MethodKind method, double feedMmPerMin) {
  RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = static_cast<int>(kPerWindow);
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  settings.isCommissioned = true;
  settings.monitor = false;
  return settings;
}

/// The machine of [P1] without what keeps it slow on short blocks: it reaches the feed.
machine::MachineConfig quickMachine() {
  machine::MachineConfig config = *machine::loadPreset("dmu75");
  config.blocksPerCycleMax = 0.0;
  config.resetDynamics = machine::Dynamics::Brisk;
  return config;
}

/// Several runs; all must be faultless.
struct Sum {
  std::size_t pauses = 0;
  double standingS = 0.0;
  double totalS = 0.0;
  double fastestMmPerS = 0.0;
};

Sum runAll(const machine::MachineConfig& machine, const RunSettings& settings,
           std::uint64_t seeds = 5) {
  Sum sum;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const RunReport report = streaming::simulate({machine, contour(seed), settings, seed});
    if (!report.isFaultless() || report.outcome != Outcome::Completed || !report.controlTrace) {
      qFatal("seed %d: %s", static_cast<int>(seed), report.error.text().c_str());
    }
    for (const trace::Pause& pause : trace::findPauses(*report.controlTrace)) {
      ++sum.pauses;
      sum.standingS += base::toSeconds(pause.duration);
    }
    sum.totalS += base::toSeconds(report.duration);
    for (const trace::ControlSample& sample : report.controlTrace->samples) {
      sum.fastestMmPerS = std::max(sum.fastestMmPerS, sample.feedMmPerS);
    }
  }
  return sum;
}

/// A run that can be looked at and interfered with while it is in progress.
class World final : public streaming::RunSink, public streaming::RunOrders {
 public:
  explicit World(machine::MachineConfig config = *machine::loadPreset("dmu75"))
      : machine(std::move(config), 1), link(machine) {}

  RunReport run(const gcode::Program& program, const RunSettings& settings) {
    return streaming::runJob(link, link, program, settings, *this, *this);
  }
  void update(const streaming::LiveUpdate& update) override {
    executed = update.counters.executed;
    if (onUpdate) {
      onUpdate(update);
    }
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(base::Instant) override { return executed >= stopAt; }
  bool holdRequested(base::Instant now) override {
    if (executed >= holdAt && !heldSince) {
      heldSince = now;
    }
    return heldSince && now < *heldSince + 20s;
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
  std::size_t executed = 0;
  std::size_t stopAt = SIZE_MAX;
  std::size_t holdAt = SIZE_MAX;
  std::optional<base::Instant> heldSince;
  std::function<void(const streaming::LiveUpdate&)> onUpdate;
};

/// How often the axes slowed down by a twentieth and went on, and the largest change of speed and
/// of acceleration from one interpolation cycle to the next, as a share of what the axis allows.
struct Slowing {
  std::size_t count = 0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

/// @param axis  the only one that moves
Slowing slowingOf(const trace::ControlTrace& trace, const machine::AxisLimits& axis,
                  double cycleS) {
  constexpr double kShare = 0.05;
  Slowing result;
  double speed = 0.0;
  double acceleration = 0.0;
  double extreme = 0.0;
  bool slows = false;
  for (const trace::ControlSample& sample : trace.samples) {
    const double now = (sample.feedMmPerS - speed) / cycleS;
    result.acceleration =
        std::max(result.acceleration, std::abs(now) / axis.accelerationMmPerS2Max);
    result.jerk =
        std::max(result.jerk, std::abs(now - acceleration) / (axis.jerkMmPerS3Max * cycleS));
    speed = sample.feedMmPerS;
    acceleration = now;
    extreme = slows ? std::min(extreme, speed) : std::max(extreme, speed);
    const bool turns = slows ? speed > (1.0 + kShare) * extreme : speed < (1.0 - kShare) * extreme;
    if (turns) {
      result.count += slows ? 1 : 0;
      slows = !slows;
      extreme = speed;
    }
  }
  return result;
}

/// Points along X, from where the machine stands, at distances as `contour` has them.
std::shared_ptr<const gcode::Program> straightWay(const machine::MachineConfig& machine,
                                                  base::Random& random) {
  std::vector<base::Vec3> points;
  base::Vec3 place;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    place.set(axis, machine.axes[axis].startMm);
  }
  for (std::size_t i = 0; i < kPoints; ++i) {
    place.x += 0.15 * (1.0 + random.exponential());
    points.push_back(place);
  }
  return streaming::programOf(points);
}

std::size_t blocksMoved(const machine::Machine& machine) {
  return static_cast<std::size_t>(
      std::count_if(machine.trace().blocks.begin(), machine.trace().blocks.end(),
                    [](const trace::ExecutedBlock& block) { return block.lengthMm > 0.0; }));
}

}  // namespace

class TestCredit : public QObject {
  Q_OBJECT

 private slots:
  void nothingStartsWithoutTheTest() {
    World world;
    RunSettings unproven = settings(MethodKind::Credit, 500.0);
    unproven.isCommissioned = false;
    const RunReport report = world.run(*contour(1), unproven);
    QCOMPARE(report.outcome, Outcome::Failed);
    QVERIFY(report.error.code == StreamError::NotCommissioned);
    QVERIFY(report.error.message.find("rivulet-cli commission") != std::string::npos);
    QVERIFY(world.machine.programNames().empty());
    QVERIFY(world.machine.trace().samples.empty());
  }

  /// On time: up to the reach of the client, on the machine as it is and on a quick one.
  void onTimeThereIsNoPause_data() {
    QTest::addColumn<bool>("isQuick");
    QTest::addColumn<double>("feedMmPerMin");
    for (const double feed : {100.0, 300.0, 500.0}) {
      QTest::addRow("dmu75, F %.0f", feed) << false << feed;
      QTest::addRow("quick, F %.0f", feed) << true << feed;
    }
  }
  void onTimeThereIsNoPause() {
    QFETCH(bool, isQuick);
    QFETCH(double, feedMmPerMin);
    const machine::MachineConfig machine = isQuick ? quickMachine() : *machine::loadPreset("dmu75");
    const Sum credit = runAll(machine, settings(MethodKind::Credit, feedMmPerMin));
    RunSettings even = settings(MethodKind::Window, feedMmPerMin);
    even.placePauses = false;
    const Sum window = runAll(machine, even);
    qInfo("F %.0f: credit %zu pauses, %.2f s; window %zu pauses, %.2f s standing, %.2f s",
          feedMmPerMin, credit.pauses, credit.totalS, window.pauses, window.standingS,
          window.totalS);
    QCOMPARE(credit.pauses, std::size_t{0});
    QCOMPARE(window.pauses, 5 * (kPoints / kPerWindow - 1));
    QVERIFY(credit.totalS < window.totalS);
    const double programmed = base::mmPerSFromMmPerMin(feedMmPerMin);
    QVERIFY(credit.fastestMmPerS <= programmed * (1.0 + 1e-9));
    QVERIFY(!isQuick || credit.fastestMmPerS > 0.999 * programmed);
  }

  /// Beyond the reach of the client the axes slow down where they would stand otherwise. On time
  /// that costs nothing but a gentle start.
  void slowingDownTakesThePlaceOfStanding() {
    for (const double feed : {500.0, 1000.0, 1300.0, 1600.0, 2000.0, 3000.0}) {
      RunSettings slow = settings(MethodKind::Credit, feed);
      RunSettings fast = slow;
      fast.parameters.slowDown = false;
      const Sum slowing = runAll(quickMachine(), slow);
      const Sum standing = runAll(quickMachine(), fast);
      qInfo(
          "F %.0f: slowing %zu pauses, %.1f %% standing, %.2f s; not slowing %zu, %.1f %%, %.2f s",
          feed, slowing.pauses, 100.0 * slowing.standingS / slowing.totalS, slowing.totalS,
          standing.pauses, 100.0 * standing.standingS / standing.totalS, standing.totalS);
      QVERIFY(slowing.totalS < 1.02 * standing.totalS);
      QVERIFY(feed > 1000.0 ? standing.pauses > 20 : standing.pauses == 0);
      QVERIFY(feed > 1600.0 ? slowing.pauses < standing.pauses : slowing.pauses == 0);
      QVERIFY(standing.pauses == 0 || slowing.standingS < 0.4 * standing.standingS);
    }
  }

  /// Late windows leave no mark of a dwell: along a straight line, whose limits are those of X,
  /// speed and acceleration change in no interpolation cycle by more than these allow. With BRISK,
  /// which has no limit of jerk, they do. RIVULET_STARVATIONS is how often the axes slow down at
  /// least.
  void starvationIsSmooth_data() {
    QTest::addColumn<bool>("isSoft");
    QTest::addRow("SOFT") << true;
    QTest::addRow("BRISK") << false;
  }
  void starvationIsSmooth() {
    QFETCH(bool, isSoft);
    const auto wanted = static_cast<std::size_t>(tests::setting("RIVULET_STARVATIONS", 1000));
    machine::MachineConfig machine = *machine::loadPreset("dmu75");
    machine.resetDynamics = isSoft ? machine::Dynamics::Soft : machine::Dynamics::Brisk;
    machine.blocksPerCycleMax = 0.0;
    base::Random random(1);
    Slowing sum;
    std::size_t pauses = 0;
    std::uint64_t seed = 0;
    while (sum.count < wanted) {
      const double feed = 700.0 + 2300.0 * random.uniform();
      const RunReport report = streaming::simulate(
          {machine, straightWay(machine, random), settings(MethodKind::Credit, feed), ++seed});
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      const Slowing slowing = slowingOf(*report.controlTrace, machine.axes[0],
                                        base::toSeconds(machine.interpolationCycle));
      sum.count += slowing.count;
      sum.acceleration = std::max(sum.acceleration, slowing.acceleration);
      sum.jerk = std::max(sum.jerk, slowing.jerk);
      pauses += trace::findPauses(*report.controlTrace).size();
      QVERIFY(seed < 10 * wanted + 10);
    }
    qInfo(
        "%zu slowed down in %d runs, %zu of them to a standstill: acceleration %.3f, jerk %.3f of "
        "what X allows",
        sum.count, static_cast<int>(seed), pauses, sum.acceleration, sum.jerk);
    QVERIFY(sum.acceleration <= 1.0 + 1e-6);
    QCOMPARE(sum.jerk <= 1.0 + 1e-6, isSoft);
  }

  /// A control that shows new values only after a STOPRE, or whose jumps stop: never started
  /// there, but if it were, the axes would wait, and go nowhere they should not.
  void whereTheControlDoesNotFitTheAxesWait() {
    for (const bool jumps : {false, true}) {
      machine::MachineConfig config = *machine::loadPreset("dmu75");
      config.jumpStops = jumps;
      config.rRead = jumps ? machine::RParameterReading::AtInterpretation
                           : machine::RParameterReading::CachedUntilStopre;
      const Sum sum = runAll(config, settings(MethodKind::Credit, 500.0));
      QVERIFY(sum.pauses > 0);
    }
  }

  /// What the control says has been executed has been, at every moment; and it does not take more
  /// than it may.
  void theCountersAreHonest() {
    for (const bool monitor : {false, true}) {
      World world;
      RunSettings run = settings(MethodKind::Credit, 400.0);
      run.monitor = monitor;
      const auto cells = templates::makeProgram(run.parameters)->cells;
      std::size_t looks = 0;
      double mostAhead = 0.0;
      QString wrong;
      world.onUpdate = [&](const streaming::LiveUpdate& update) {
        if (update.state != streaming::RunState::Running) {
          return;
        }
        ++looks;
        const double latched = world.machine.ncRParameter(cells.latched);
        const double executed = world.machine.ncRParameter(cells.executed);
        const std::size_t moved = blocksMoved(world.machine);
        if (executed * kPerWindow > static_cast<double>(moved) ||
            update.counters.executed > moved) {
          wrong = QStringLiteral("%1 windows, %2 points said to be executed; %3 are")
                      .arg(executed)
                      .arg(update.counters.executed)
                      .arg(moved);
        }
        mostAhead = std::max(mostAhead, latched - executed);
      };
      const RunReport report = world.run(*contour(2), run);
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
      QVERIFY(looks > 100);
      QCOMPARE(mostAhead, static_cast<double>(run.parameters.windowsAhead));
      QCOMPARE(world.machine.ncRParameter(cells.executed),
               static_cast<double>(kPoints / kPerWindow));
    }
  }

  /// Behind a stop what has been taken over is still executed, and nothing else; then the run is
  /// taken up where it was left.
  void stopAndResume() {
    for (const int ahead : {1, 3, 8}) {
      World world;
      world.stopAt = 50;
      RunSettings run = settings(MethodKind::Credit, 400.0);
      run.parameters.windowsAhead = ahead;
      const auto program = contour(3);
      std::size_t movedAtStop = 0;
      world.link.onWrite = [&](base::RequestId, int cell, double value) {
        if (cell == 0 && value == 2.0 && movedAtStop == 0) {
          movedAtStop = blocksMoved(world.machine);
        }
      };
      const RunReport stopped = world.run(*program, run);
      QCOMPARE(stopped.outcome, Outcome::Stopped);
      QVERIFY2(stopped.isFaultless(), stopped.error.text().c_str());
      QVERIFY(stopped.stopConfirmedAfter.has_value());
      const std::size_t moved = blocksMoved(world.machine);
      QCOMPARE(stopped.counters.executed, moved);
      QVERIFY(movedAtStop >= 50 && moved < kPoints);
      QVERIFY(moved - movedAtStop <= static_cast<std::size_t>(ahead + 1) * kPerWindow);
      QCOMPARE(moved % kPerWindow, std::size_t{0});
      // Only by order, and from there.
      const auto resume = streaming::resumeFrom(world.link, *program, run, *stopped.checkpoint);
      QVERIFY2(resume.has_value(), resume ? "" : resume.error().text().c_str());
      QCOMPARE(resume->point, moved);
      world.stopAt = SIZE_MAX;
      run.resume = *resume;
      const RunReport rest = world.run(*program, run);
      QVERIFY2(rest.isFaultless() && rest.outcome == Outcome::Completed, rest.error.text().c_str());
      QCOMPARE(rest.counters.executed, kPoints - moved);
    }
  }

  /// The control drops into reset while several windows are on their way: where the tool stands on
  /// the path of all of them decides.
  void resetAndResume() {
    std::size_t resumed = 0;
    for (int ms = 1000; ms <= 3000; ms += 170) {
      World world;
      const RunSettings run = settings(MethodKind::Credit, 400.0);
      const auto program = contour(4);
      std::optional<base::Instant> started;
      bool isReset = false;
      world.onUpdate = [&](const streaming::LiveUpdate& update) {
        started = started ? *started : update.at;
        if (!isReset && update.counters.executed > 0 &&
            update.at - *started > std::chrono::milliseconds{ms}) {
          isReset = true;
          world.machine.reset();
        }
      };
      const RunReport broken = world.run(*program, run);
      QVERIFY(isReset);
      QCOMPARE(broken.outcome, Outcome::Failed);
      QVERIFY(broken.integrity.isFaultless());
      const std::size_t moved = blocksMoved(world.machine);
      const auto resume = streaming::resumeFrom(world.link, *program, run, *broken.checkpoint);
      if (!resume) {
        QVERIFY(resume.error().code == StreamError::CannotResume);
        continue;
      }
      ++resumed;
      // In a rounding the point that is being rounded counts as either.
      QVERIFY(resume->point >= moved - 1 && resume->point <= moved + 1);
      RunSettings rest = run;
      rest.resume = *resume;
      world.onUpdate = {};
      const RunReport report = world.run(*program, rest);
      QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
               report.error.text().c_str());
    }
    QVERIFY(resumed >= 8);
  }

  void holdAndGoOn() {
    World world;
    world.holdAt = 40;
    const RunReport report = world.run(*contour(5), settings(MethodKind::Credit, 400.0));
    QVERIFY2(report.isFaultless() && report.outcome == Outcome::Completed,
             report.error.text().c_str());
    QVERIFY(world.heldSince.has_value());
    const auto pauses = trace::findPauses(*report.controlTrace);
    QCOMPARE(pauses.size(), std::size_t{1});
    QVERIFY(pauses.front().duration > 15s);
  }
};

RIVULET_TEST(TestCredit)
#include "tst_credit.moc"
