// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "forecast/region.h"
#include "support/hard_machine.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::forecast;
using base::MethodKind;
using feasibility::SweepAxis;

namespace {

/// The last job first: the result must not depend on the order, nor then on threads.
class Backwards final : public base::Executor {
 public:
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    for (std::size_t index = count; index-- > 0;) {
      job(index);
    }
  }
};

RegionRequest request(SweepAxis axis, std::vector<double> abscissas,
                      std::vector<double> feedsMmPerMin) {
  base::Random random(5);
  RegionRequest request;
  for (const base::Vec3& point : streaming::drawContour({60, 0.3, 0.15}, random)) {
    request.points.push_back({point, base::LineNumber{}});
  }
  request.machine = tests::hardMachine();
  request.settings.parameters.method = MethodKind::Position;
  request.settings.deltaMm = 0.3;
  request.axis = axis;
  request.abscissas = std::move(abscissas);
  for (const double feed : feedsMmPerMin) {
    request.feedsMmPerS.push_back(base::mmPerSFromMmPerMin(feed));
  }
  request.seedsPerPoint = 4;
  return request;
}

}  // namespace

class TestRegion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A window of five axes has more cells than one of three: the same feed that is right for
  /// method window takes longer, and the machine has the axes.
  void rotaryAxesAreStreamed() {
    base::SerialExecutor executor;
    RegionRequest wanted = request(SweepAxis::PointDistance, {0.3}, {500.0});
    wanted.settings.parameters.method = MethodKind::Window;
    wanted.settings.parameters.rotaryAxes = {true, false, true};
    for (std::size_t i = 0; i < wanted.points.size(); ++i) {
      wanted.points[i].rotaryDeg = {0.01 * static_cast<double>(i), 0.0, 0.0};
    }
    const RegionResult result = simulateRegion(wanted, executor);
    QVERIFY2(!result.error.code, result.error.message.c_str());
    QCOMPARE(result.points[0].runs, std::size_t{4});
    QCOMPARE(result.points[0].failures(), std::size_t{0});
  }

  void slowRunsAndFastFails() {
    base::SerialExecutor executor;
    for (const SweepAxis axis :
         {SweepAxis::PointDistance, SweepAxis::PointsPerLoop, SweepAxis::Delta}) {
      const double abscissa = axis == SweepAxis::PointsPerLoop ? 7.0 : 0.3;
      const RegionResult result =
          simulateRegion(request(axis, {abscissa}, {300.0, 3000.0}), executor);
      QVERIFY(!result.cancelled);
      QCOMPARE(result.points.size(), std::size_t{2});
      QCOMPARE(result.points[0].runs, std::size_t{4});
      QCOMPARE(result.points[0].failures(), std::size_t{0});
      QCOMPARE(result.points[1].failures(), std::size_t{4});
      for (const RegionPoint& point : result.points) {
        QCOMPARE(point.pointsPerLoop, 7);
        QCOMPARE(point.deltaMm, 0.3);
        QVERIFY(std::abs(point.pointDistanceMmMin - 0.3) < 0.01);
      }
    }
  }

  void programIsScaledToItsDistance() {
    base::SerialExecutor executor;
    const RegionResult result =
        simulateRegion(request(SweepAxis::PointDistance, {0.1, 1.0}, {700.0}), executor);
    QCOMPARE(result.points[0].pointDistanceMmMin, 0.1);
    QCOMPARE(result.points[0].failures(), std::size_t{4});
    QCOMPARE(result.points[1].failures(), std::size_t{0});
  }

  void orderOfTheRunsDoesNotMatter() {
    const RegionRequest wanted = request(SweepAxis::Delta, {0.15, 0.3}, {700.0, 800.0});
    base::SerialExecutor forwards;
    Backwards backwards;
    const RegionResult first = simulateRegion(wanted, forwards);
    const RegionResult second = simulateRegion(wanted, backwards);
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      QCOMPARE(first.points[i].faulty, second.points[i].faulty);
      QCOMPARE(first.points[i].stalled, second.points[i].stalled);
    }
  }

  void canBeCancelled() {
    base::SerialExecutor executor;
    std::size_t told = 0;
    const RegionResult result =
        simulateRegion(request(SweepAxis::Delta, {0.3}, {300.0, 400.0, 500.0}), executor,
                       [&](std::size_t done, std::size_t total) {
                         ++told;
                         return total == 12 && done < 5;
                       });
    QVERIFY(result.cancelled);
    QCOMPARE(told, std::size_t{5});
    QCOMPARE(result.points[0].runs, std::size_t{4});
    QCOMPARE(result.points[1].runs, std::size_t{1});
    QCOMPARE(result.points[2].runs, std::size_t{0});
  }

  void whatCannotRunIsNoFailure() {
    base::SerialExecutor executor;
    const RegionResult result =
        simulateRegion(request(SweepAxis::PointsPerLoop, {50.0}, {300.0}), executor);
    QCOMPARE(result.points[0].runs, std::size_t{0});
    QVERIFY(result.error.code);
  }

  /// A stop that comes too early is no wrong motion, but no run either.
  void aStandstillIsTold() {
    streaming::Scenario scenario;
    const RegionRequest one = request(SweepAxis::Delta, {0.3}, {300.0});
    scenario.machine = one.machine;
    std::vector<base::Vec3> positions;
    for (const gcode::StreamPoint& point : one.points) {
      positions.push_back(point.positionMm);
    }
    scenario.program = streaming::programOf(positions);
    scenario.settings = one.settings;
    scenario.settings.feedMmPerS = 5.0;
    QCOMPARE(fateOf(scenario), RunFate::Ran);
    // A contour that leaves the machine's range ends with an alarm.
    for (base::Vec3& position : positions) {
      position.x += 370.0;
      position.x *= 2.0;
    }
    scenario.program = streaming::programOf(positions);
    base::Error error;
    QCOMPARE(fateOf(scenario, &error), RunFate::Refused);
    QVERIFY(error.code);
  }

  void stretchesLieAround() {
    std::vector<gcode::StreamPoint> points(100);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].positionMm.x = static_cast<double>(i);
    }
    const auto first = [&](std::size_t around) {
      const auto stretch = stretchOf(points, around, 20);
      return stretch.size() == 20 ? stretch.front().positionMm.x : -1.0;
    };
    QCOMPARE(first(0), 0.0);
    QCOMPARE(first(50), 40.0);
    QCOMPARE(first(99), 80.0);
    QCOMPARE(stretchOf(points, 50, 200).size(), std::size_t{100});
  }
};

RIVULET_TEST(TestRegion)
#include "tst_region.moc"
