// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "forecast/path_time.h"
#include "forecast/planner_motion.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::forecast;

namespace {

machine::MachineConfig config() {
  return machine::loadPreset("dmu75").value();
}

gcode::Trajectory line(std::size_t points, double stepMm, double feedMmPerS) {
  gcode::Trajectory trajectory;
  for (std::size_t i = 1; i <= points; ++i) {
    gcode::TrajectoryPoint point;
    point.positionMm = {stepMm * static_cast<double>(i), 0.0, 0.0};
    point.feedMmPerS = feedMmPerS;
    point.line = {static_cast<std::uint32_t>(i)};
    trajectory.points.push_back(point);
  }
  return trajectory;
}

PathTime timeOf(const gcode::Trajectory& trajectory, const PathTimeOptions& options = {}) {
  return pathTime(trajectory, {0, 0, 0}, config(), options).value();
}

/// A pause after each so many points, after the last one too.
std::vector<std::uint32_t> every(std::uint32_t points, std::uint32_t count) {
  std::vector<std::uint32_t> behind;
  for (std::uint32_t end = points; end <= count; end += points) {
    behind.push_back(end - 1);
  }
  return behind;
}

}  // namespace

class TestPathTime : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aLineTakesLengthByFeedAndTheRamps() {
    machine::MachineConfig brisk = config();
    brisk.resetDynamics = machine::Dynamics::Brisk;
    const double feed = 20.0;
    const double acceleration = brisk.axes[0].accelerationMmPerS2Max;
    const gcode::Trajectory path = line(500, 1.0, feed);
    const PathTime time = pathTime(path, {0, 0, 0}, brisk, {}).value();
    // Ramps at both ends: each costs half of feed / acceleration.
    const double expected = 500.0 / feed + feed / acceleration;
    QVERIFY2(std::abs(time.totalS - expected) < 1e-6,
             qPrintable(QString("%1 %2").arg(time.totalS).arg(expected)));
    QCOMPARE(time.atS.size(), path.points.size());
    QVERIFY(std::is_sorted(time.atS.begin(), time.atS.end()));
    // In the middle the feed is constant.
    QVERIFY(std::abs(time.atS[300] - time.atS[200] - 100.0 / feed) < 1e-4);
    QCOMPARE(time.pauses, std::size_t{0});
    QCOMPARE(time.standingS, 0.0);
  }

  void itIsTheMotionOfThePlannerBlockByBlock() {
    gcode::Trajectory path;
    std::vector<gcode::StreamPoint> points;
    for (std::uint32_t i = 0; i < 150; ++i) {
      gcode::TrajectoryPoint point;
      point.positionMm = {10.0 * std::cos(0.1 * i), 10.0 * std::sin(0.13 * i), 0.01 * i};
      point.line = {i + 1};
      path.points.push_back(point);
      points.push_back({point.positionMm, point.line});
    }
    const PlannerMotion motion(config());
    const double stepS = base::toSeconds(config().interpolationCycle);
    PathTimeOptions options;
    options.feedMmPerS = 30.0;
    // Less blocks than the look-ahead takes: both see all of them at once.
    QCOMPARE(timeOf(path, options).totalS,
             motion.move(points, {0, 0, 0}, options.feedMmPerS, stepS).durationS);
  }

  void pausesAreCountedAndCost() {
    const gcode::Trajectory path = line(100, 1.0, 10.0);
    PathTimeOptions options;
    options.pausesBehind = every(7, 100);
    options.pauseS = 0.5;
    const PathTime with = timeOf(path, options);
    const PathTime without = timeOf(path);
    QCOMPARE(with.pauses, std::size_t{14});  // after points 7, 14 … 98
    QCOMPARE(with.standingS, 7.0);
    // Besides standing it has to brake and to accelerate.
    QVERIFY(with.totalS > without.totalS + with.standingS);
    // The point after the pause comes later by the pause at least, the one before does not.
    QVERIFY(with.atS[7] - with.atS[6] > 0.5);
    QVERIFY(with.atS[6] - with.atS[5] < 0.5);
    // None after the last point: the program ends there.
    options.pausesBehind = every(10, 100);
    QCOMPARE(timeOf(path, options).pauses, std::size_t{9});
  }

  void repeatedPointsFillNoSlot() {
    gcode::Trajectory path = line(20, 1.0, 10.0);
    const double plain = timeOf(path).totalS;
    std::vector<gcode::TrajectoryPoint> doubled;
    for (const gcode::TrajectoryPoint& point : path.points) {
      doubled.insert(doubled.end(), 2, point);
    }
    PathTimeOptions options;
    options.pausesBehind = every(5, 20);
    const std::size_t pauses = timeOf(path, options).pauses;
    path.points = doubled;
    const PathTime time = timeOf(path, options);
    QCOMPARE(time.pauses, pauses);
    QCOMPARE(time.atS.size(), std::size_t{40});
    QVERIFY(timeOf(path).totalS >= plain);
  }

  /// At a sharp corner the path has braked anyway, and creeps round it: there a pause costs less
  /// than its standstill; in the middle of a straight move, braking and accelerating are added.
  void aPauseAtACornerCostsLess() {
    gcode::Trajectory path = line(20, 5.0, 10.0);
    for (std::uint32_t i = 0; i < 20; ++i) {
      gcode::TrajectoryPoint point = path.points.back();
      point.positionMm.y += 5.0;
      ++point.line.value;
      path.points.push_back(point);
    }
    PathTimeOptions options;
    options.feedMmPerS = 2000.0 / 60.0;
    const double without = timeOf(path, options).totalS;
    options.pauseS = 0.04;
    options.pausesBehind = {19};
    const double atCorner = timeOf(path, options).totalS - without;
    options.pausesBehind = {9};
    const double inTheMiddle = timeOf(path, options).totalS - without;
    QVERIFY2(atCorner > 0.0 && atCorner <= 0.04 && inTheMiddle > 0.06,
             qPrintable(QStringLiteral("%1 and %2").arg(inTheMiddle).arg(atCorner)));
  }

  void rapidsRunAtTheMachinesSpeedUnlessStreamed() {
    gcode::Trajectory path = line(1, 300.0, 0.0);
    path.points.front().kind = gcode::MoveKind::Rapid;
    const double rapid = timeOf(path).totalS;
    PathTimeOptions options;
    options.feedMmPerS = 5.0;
    const double streamed = timeOf(path, options).totalS;
    QVERIFY(rapid < 300.0 / config().rapidMmPerS + 1.0);
    QVERIFY(streamed > 60.0 && streamed < 61.0);
  }

  void unknownCoordinatesStandWhereTheMachineDoes() {
    const double open = std::numeric_limits<double>::quiet_NaN();
    gcode::Trajectory path = line(2, 10.0, 10.0);
    for (gcode::TrajectoryPoint& point : path.points) {
      point.positionMm.y = open;
      point.positionMm.z = open;
    }
    const PathTime time = pathTime(path, {0, 40, -7}, config(), {}).value();
    QCOMPARE(time.totalS, timeOf(line(2, 10.0, 10.0)).totalS);
  }

  /// A contour with bends and straight ways, rapids among them; with pauses and without.
  void stretchesTellTheTimeOfTheWhole() {
    gcode::Trajectory path;
    base::Vec3 at{};
    for (std::uint32_t i = 0; i < 30'000; ++i) {
      const bool isRapid = i % 900 == 0;
      const double course = 0.002 * i + 0.4 * std::sin(0.05 * i);
      const double stepMm = isRapid ? 40.0 : 0.1 + 0.3 * (1.0 + std::sin(0.0007 * i));
      at = at + stepMm * base::Vec3{std::cos(course), std::sin(course), 0.0};
      gcode::TrajectoryPoint point;
      point.positionMm = at;
      point.feedMmPerS = isRapid ? 0.0 : 20.0 + 15.0 * std::sin(0.001 * i);
      point.kind = isRapid ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
      point.line = {i + 1};
      path.points.push_back(point);
    }
    for (const bool pauses : {false, true}) {
      PathTimeOptions options;
      options.pausesBehind = pauses ? every(14, 30'000) : std::vector<std::uint32_t>();
      options.pauseS = 0.04;
      const PathTime whole = timeOf(path, options);
      options.followedMax = 30'000;
      const PathTime together = timeOf(path, options);
      QVERIFY2(std::abs(together.totalS / whole.totalS - 1.0) < 1e-4,
               qPrintable(QStringLiteral("%1 %2").arg(together.totalS).arg(whole.totalS)));
      options.followedMax = 6'000;
      const PathTime stretches = timeOf(path, options);
      QVERIFY2(std::abs(stretches.totalS / whole.totalS - 1.0) < 0.03,
               qPrintable(QStringLiteral("%1 %2").arg(stretches.totalS).arg(whole.totalS)));
      QCOMPARE(stretches.pauses, whole.pauses);
      QCOMPARE(stretches.standingS, whole.standingS);
      QCOMPARE(stretches.atS.size(), path.points.size());
      QVERIFY(std::is_sorted(stretches.atS.begin(), stretches.atS.end()));
      for (std::size_t i = 5'000; i < path.points.size(); i += 5'000) {
        QVERIFY(std::abs(stretches.atS[i] - whole.atS[i]) < 0.03F * whole.atS[i]);
      }
    }
  }

  void longProgramsGoThroughAndCanBeGivenUp() {
    const gcode::Trajectory path = line(100'000, 0.05, 50.0);
    std::vector<double> shares;
    PathTimeOptions options;
    options.progress = [&](double share) {
      shares.push_back(share);
      return true;
    };
    const PathTime time = timeOf(path, options);
    QCOMPARE(time.atS.size(), path.points.size());
    QVERIFY(time.totalS >= 100.0);
    QVERIFY(!shares.empty());
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QCOMPARE(shares.back(), 1.0);
    options.progress = [](double) { return false; };
    QVERIFY(!pathTime(path, {0, 0, 0}, config(), options));
    options.followedMax = 1'000;
    QVERIFY(!pathTime(path, {0, 0, 0}, config(), options));
    QCOMPARE(timeOf(gcode::Trajectory{}).totalS, 0.0);
  }
};

RIVULET_TEST(TestPathTime)
#include "tst_path_time.moc"
