// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "feasibility/verdict.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::feasibility;

namespace {

/// Points that leave x = 0 by each amount in turn and return to it: no coordinate grows, so every
/// step is exact. Point i comes from line 10·(i+1).
std::vector<gcode::StreamPoint> thereAndBack(const std::vector<double>& amountsMm) {
  std::vector<gcode::StreamPoint> points{{{0, 0, 0}, {10}}};
  const auto add = [&](double x) {
    points.push_back({{x, 0, 0}, {static_cast<std::uint32_t>(10 * (points.size() + 1))}});
  };
  for (const double amountMm : amountsMm) {
    add(amountMm);
    add(0.0);
  }
  return points;
}

}  // namespace

class TestDistances : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!qEnvironmentVariableIsSet("RC_PARAMS")) {
      qputenv("RC_PARAMS", "seed=20260101 max_success=300");
    }
  }

  void namesTheClosestPoints() {
    const std::vector<gcode::StreamPoint> points{
        {{0, 0, 0}, {3}}, {{3, 4, 0}, {5}}, {{3, 4, 1}, {8}}, {{3, 4, 5}, {9}}};
    const ProgramDistances distances = programDistances(points, 4);
    QCOMPARE(distances.pointDistanceMmMin, 1.0);
    QCOMPARE(distances.pointDistancePlace.point.value, 1U);
    QCOMPARE(distances.pointDistancePlace.firstLine.value, 5U);
    QCOMPARE(distances.pointDistancePlace.lastLine.value, 8U);
    QCOMPARE(distances.windowSteps, 2);
    QCOMPARE(distances.windowLengthMmMin, 5.0);
    QCOMPARE(distances.windowPlace.point.value, 1U);
    QCOMPARE(distances.windowPlace.firstLine.value, 5U);
    QCOMPARE(distances.windowPlace.lastLine.value, 9U);
  }

  void tiesTakeTheFirstPlace() {
    // Every window of four or eight steps is as long as the others, but for the rounding of the
    // order in which 0.1 and 0.3 are added.
    const auto points = thereAndBack({0.1, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1, 0.3});
    for (const int n : {8, 9, 16, 17}) {
      const ProgramDistances distances = programDistances(points, n);
      QCOMPARE(distances.pointDistancePlace.point.value, 0U);
      QCOMPARE(distances.windowPlace.point.value, 0U);
    }
    const auto uniform = thereAndBack(std::vector<double>(50, 0.1));
    for (int n = 2; n < 60; ++n) {
      QCOMPARE(programDistances(uniform, n).windowPlace.point.value, 0U);
    }
  }

  void shortListCountsAsAWhole() {
    const auto points = thereAndBack({1.0, 2.0});
    const ProgramDistances distances = programDistances(points, 40);
    QCOMPARE(distances.windowSteps, 20);
    QCOMPARE(distances.windowLengthMmMin, 6.0);
    QCOMPARE(distances.windowPlace.lastLine, points.back().line);
  }

  void twoPointsAreEnough() {
    const ProgramDistances distances = programDistances({{{0, 0, 0}, {1}}, {{0, 0, 2}, {2}}}, 7);
    QCOMPARE(distances.pointDistanceMmMin, 2.0);
    QCOMPARE(distances.windowLengthMmMin, 2.0);
  }

  /// A sum that is carried along loses the small steps after the large ones.
  void smallStepsBehindLargeOnesKeepTheirDigits() {
    std::vector<double> pairs(20000, 1.0e6);
    pairs.insert(pairs.end(), 100, 1.0e-6);
    const ProgramDistances distances = programDistances(thereAndBack(pairs), 20);
    QVERIFY(std::abs(distances.windowLengthMmMin - 1.0e-5) < 1e-18);
    QCOMPARE(distances.windowPlace.point.value, 40000U);
  }

  void agreesWithTheDefinition() {
    QVERIFY(rc::check("window and place are those of trying every window", [] {
      const auto raw =
          *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 50)));
      std::vector<double> steps;
      for (const int value : raw) {
        steps.push_back(value / 8.0);  // exact, so that ties are real ties
      }
      const int n = *rc::gen::inRange(2, 30);
      const auto points = thereAndBack(steps);
      std::vector<double> real;
      for (std::size_t i = 1; i < points.size(); ++i) {
        real.push_back(base::distance(points[i - 1].positionMm, points[i].positionMm));
      }
      const auto width = std::min(static_cast<std::size_t>(n / 2), real.size());
      std::size_t best = 0;
      double bestMm = INFINITY;
      for (std::size_t first = 0; first + width <= real.size(); ++first) {
        double sumMm = 0.0;
        for (std::size_t i = first; i < first + width; ++i) {
          sumMm += real[i];
        }
        if (sumMm < bestMm) {
          bestMm = sumMm;
          best = first;
        }
      }
      const ProgramDistances distances = programDistances(points, n);
      RC_ASSERT(distances.windowLengthMmMin == bestMm);
      RC_ASSERT(distances.windowPlace.point.value == best);
      RC_ASSERT(distances.windowPlace.firstLine == points[best].line);
      RC_ASSERT(distances.windowPlace.lastLine == points[best + width].line);
      RC_ASSERT(distances.pointDistanceMmMin == *std::min_element(real.begin(), real.end()));
    }));
  }
};

RIVULET_TEST(TestDistances)
#include "tst_distances.moc"
