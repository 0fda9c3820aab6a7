// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The verdict on a program on a machine, and the experiment that draws machines, paths and
/// settings to see how far it can be trusted.

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "feasibility/probability.h"
#include "forecast/machine_verdict.h"
#include "forecast/region.h"
#include "papers/verdict_draws.h"
#include "platform/thread_executor.h"
#include "streaming/simulation/scenario.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;
using feasibility::Equation;

namespace {

std::vector<gcode::StreamPoint> contour(double restMm, double stepMm = 0.15) {
  base::Random random(7);
  std::vector<gcode::StreamPoint> points;
  for (const base::Vec3& positionMm : streaming::drawContour({100, stepMm, restMm}, random)) {
    points.push_back({positionMm, base::LineNumber{}});
  }
  return points;
}

feasibility::OperatingPoint at(MethodKind method, double feedMmPerMin, int n, double deltaMm) {
  return {method, n, deltaMm, base::mmPerSFromMmPerMin(feedMmPerMin)};
}

feasibility::Verdict judged(const std::vector<gcode::StreamPoint>& points,
                            const feasibility::OperatingPoint& point,
                            const feasibility::AccessModel& access = {}) {
  return *forecast::judgeOn(*machine::loadPreset("dmu75"), points, point,
                            feasibility::programDistances(points, point.pointsPerLoop), access);
}

const papers::Check& checkOf(const papers::Experiment& experiment, const std::string& what) {
  for (const papers::Check& check : experiment.checks) {
    if (check.what.starts_with(what)) {
      return check;
    }
  }
  qFatal("no check %s", what.c_str());
}

/// Wrong runs among the allowed ones, of both methods of [P1].
std::size_t wrongRuns(const papers::Experiment& experiment) {
  std::size_t wrong = 0;
  for (const std::vector<std::string>& row : experiment.tables[0].rows) {
    wrong += row[0] == "position" || row[0] == "signal" ? std::stoul(row[4]) : 0;
  }
  return wrong;
}

}  // namespace

class TestMachineVerdict : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Evenly spaced points, F at 0.99 of the limit of (1): each step is as short as the shortest.
  void evenPointsAreNotAllowedUpToTheLimitOfTheEquations() {
    const auto points = contour(0.0);
    const auto point = at(MethodKind::Position, 345, 9, 0.15);
    const auto byEquations = feasibility::judge(point, feasibility::programDistances(points, 9));
    QVERIFY(byEquations->feasible);
    const feasibility::Verdict verdict = judged(points, point);
    QVERIFY(!verdict.feasible);
    QCOMPARE(verdict.limiting.equation, Equation::Machine);
    QVERIFY(verdict.feedMmPerSMax < 0.95 * byEquations->feedMmPerSMax);
    QVERIFY(verdict.feedMmPerSMax > 0.4 * byEquations->feedMmPerSMax);
    // The equations are shown as they are.
    QCOMPARE(verdict.conditions.size(), byEquations->conditions.size() + 1);
    QCOMPARE(verdict.conditions.front().margin, byEquations->conditions.front().margin);
    // What it allows, it allows.
    feasibility::OperatingPoint slower = point;
    slower.feedMmPerS = 0.99 * verdict.feedMmPerSMax;
    QVERIFY(judged(points, slower).feasible);
  }

  /// The probability rises and falls again over the feed: between two feeds that are right, here
  /// one at which every second run is wrong, because the first point is missed.
  void theFeedThatIsAskedForIsLookedAtItself() {
    const machine::MachineConfig machine = *machine::loadPreset("plc");
    std::vector<gcode::StreamPoint> points;
    double angle = 0.0;
    base::Vec3 atMm{};
    for (int i = 0; i < 103; ++i) {
      points.push_back({atMm, base::LineNumber{}});
      angle += 0.040712;
      atMm = atMm + 0.363208 * base::Vec3{std::cos(angle), std::sin(angle), 0.0};
    }
    feasibility::AccessModel access;
    access.measured =
        feasibility::MeasuredAccess{{machine.access.readOverhead, machine.access.nodeTimeMean},
                                    {machine.access.writeOverhead, machine.access.nodeTimeMean}};
    bool wasPassedOver = false;
    for (double feed = 1500.0; feed < 3000.0; feed *= 1.03) {
      const auto point = at(MethodKind::Position, feed, 10, 0.144);
      const auto verdict = forecast::judgeOn(machine, points, point,
                                             feasibility::programDistances(points, 10), access);
      machine::MachineConfig brisk = machine;
      brisk.resetDynamics = machine::Dynamics::Brisk;
      const feasibility::StreamModel model = forecast::streamModelOf(brisk);
      const double probability = feasibility::predict(points, point, model).failureProbability;
      QVERIFY2(!verdict->feasible || probability < 1e-3, std::to_string(feed).c_str());
      wasPassedOver = wasPassedOver || (probability > 0.1 && !verdict->feasible);
    }
    QVERIFY(wasPassedOver);
  }

  /// The dynamics after a reset are not known: what a preset says of them changes nothing.
  void theWorseOfTheDynamicsCounts() {
    const auto points = contour(0.15);
    const auto point = at(MethodKind::Signal, 600, 9, 0.15);
    const auto distances = feasibility::programDistances(points, 9);
    machine::MachineConfig machine = *machine::loadPreset("dmu75");
    machine.resetDynamics = machine::Dynamics::Soft;
    const auto soft = forecast::judgeOn(machine, points, point, distances);
    machine.resetDynamics = machine::Dynamics::Brisk;
    const auto brisk = forecast::judgeOn(machine, points, point, distances);
    QCOMPARE(soft->feedMmPerSMax, brisk->feedMmPerSMax);
  }

  /// A δ above the smallest step takes points for passed that are not due; no equation forbids it.
  void aDeltaAboveTheStepsIsNotAllowedAtAnyFeed() {
    const auto points = contour(0.0);
    const auto point = at(MethodKind::Position, 60, 9, 0.19);
    QVERIFY(feasibility::judge(point, feasibility::programDistances(points, 9))->feasible);
    const feasibility::Verdict verdict = judged(points, point);
    QVERIFY(!verdict.feasible);
    QCOMPARE(verdict.feedMmPerSMax, 0.0);
  }

  /// The reach takes each window for the shortest, and the axes for infinitely quick.
  void windowsAreSaidToWaitOnlyIfTheyDo() {
    const auto points = contour(0.15);
    const auto point = at(MethodKind::Window, 700, 7, 0.15);
    QVERIFY(feasibility::judge(point, feasibility::programDistances(points, 7))->waits);
    const feasibility::Verdict verdict = judged(points, point);
    QVERIFY(verdict.feasible && !verdict.waits);
    const feasibility::Verdict fast = judged(points, at(MethodKind::Window, 20000, 7, 0.15));
    QVERIFY(fast.feasible && fast.waits);
    QCOMPARE(fast.limiting.equation, Equation::Machine);
  }

  /// Slower requests allow less.
  void measuredAccessCounts() {
    const auto points = contour(0.15);
    const auto point = at(MethodKind::Position, 100, 9, 0.15);
    using std::chrono::microseconds;
    const auto with = [&](int us) {
      feasibility::AccessModel access;
      access.measured = feasibility::MeasuredAccess{{microseconds{900}, microseconds{us}},
                                                    {microseconds{1300}, microseconds{us}}};
      return judged(points, point, access).feedMmPerSMax;
    };
    QVERIFY(with(2000) > 1.5 * with(4300));
    QVERIFY(with(4300) > 1.5 * with(8600));
  }

  /// A few draws of the experiment; docs/fidelity.md has thousands. The equations alone allow runs
  /// that go wrong, and so does a verdict that believes in access times that are half of the true
  /// ones.
  void drawnRunsThatAreAllowedAreRight() {
    parallel::ThreadExecutor executor;
    papers::ExperimentOptions options{*machine::loadPreset("dmu75"), 1, executor, {}};
    const auto right = papers::runVerdictDraws(options);
    QVERIFY(right);
    QCOMPARE(wrongRuns(*right), std::size_t{0});
    QVERIFY(checkOf(*right, "method position: share").nullModel > 0.1);
    QVERIFY(checkOf(*right, "method window: runs").passed());
    QVERIFY(checkOf(*right, "method credit: runs").passed());
    QVERIFY(checkOf(*right, "method file: runs").passed());
    options.wrong = [](streaming::Scenario& scenario) {
      scenario.machine.access.nodeTimeMean *= 2;
    };
    const auto wrong = papers::runVerdictDraws(options);
    QVERIFY(wrong);
    QVERIFY2(wrongRuns(*wrong) > 2, std::to_string(wrongRuns(*wrong)).c_str());
    QVERIFY(!checkOf(*wrong, "method position: share").passed());
  }
};

RIVULET_TEST(TestMachineVerdict)
#include "tst_machine_verdict.moc"
