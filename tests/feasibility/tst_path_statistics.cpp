// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "feasibility/path_statistics.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::feasibility;

namespace {

gcode::PointList along(const std::vector<base::Vec3>& positions) {
  gcode::PointList list;
  for (const base::Vec3 position : positions) {
    list.points.push_back({position, {static_cast<std::uint32_t>(list.points.size() + 1)}});
  }
  return list;
}

std::size_t total(const std::vector<std::size_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

}  // namespace

class TestPathStatistics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!qEnvironmentVariableIsSet("RC_PARAMS")) {
      qputenv("RC_PARAMS", "seed=20260101 max_success=200");
    }
  }

  void figuresOfASquare() {
    gcode::PointList list = along({{0, 0, 0}, {10, 0, 0}, {10, 2, 0}, {11, 2, 0}, {10, 2, 0}});
    list.merged = 3;
    const PathStatistics statistics = pathStatistics(list);
    QCOMPARE(statistics.points, std::size_t{5});
    QCOMPARE(statistics.duplicates, std::size_t{3});
    QCOMPARE(statistics.distanceMmMin, 1.0);
    QCOMPARE(statistics.distanceMmMedian, 1.5);
    QCOMPARE(statistics.distanceMmMax, 10.0);
    // Five classes from 1 to 10: 1 and 1 in the first, 2 in the second, 10 in the last.
    QCOMPARE(statistics.distances.counts, (std::vector<std::size_t>{2, 1, 0, 0, 1}));
    QCOMPARE(statistics.distances.bordersMm.size(), std::size_t{6});
    QVERIFY(std::abs(statistics.distances.bordersMm[1] - std::pow(10.0, 0.2)) < 1e-12);
    // Two right angles and a turn back, which is the sharpest; it ends block 4.
    QCOMPARE(statistics.angles.counts,
             (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}));
    QCOMPARE(statistics.angles.degreesMax, 180.0);
    QCOMPARE(statistics.angles.line.value, 4U);
  }

  void anglesAreExactWhereTheyAreSmall() {
    const double tiny = 1e-7;
    const PathStatistics statistics =
        pathStatistics(along({{0, 0, 0}, {1, 0, 0}, {1 + std::cos(tiny), std::sin(tiny), 0}}));
    QVERIFY(std::abs(statistics.angles.degreesMax * M_PI / 180.0 - tiny) < 1e-12);
    QCOMPARE(statistics.angles.counts.front(), std::size_t{1});
  }

  void equalDistancesAreOneClass() {
    const PathStatistics statistics =
        pathStatistics(along({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
    QCOMPARE(statistics.distances.counts, (std::vector<std::size_t>{3}));
    QCOMPARE(statistics.distances.bordersMm, (std::vector<double>{1.0, 1.0}));
    QCOMPARE(statistics.angles.degreesMax, 0.0);
    QCOMPARE(pathStatistics(along({{0, 0, 0}, {0, 0, 4}})).distanceMmMedian, 4.0);
  }

  /// Against the definition: every step is in exactly the class its borders name.
  void everyStepIsCountedInItsClass() {
    QVERIFY(rc::check([] {
      const auto steps =
          *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 2'000'000)));
      std::vector<base::Vec3> positions{{0, 0, 0}};
      for (std::size_t i = 0; i < steps.size(); ++i) {
        positions.push_back({i % 2 == 0 ? steps[i] * 1e-3 : 0.0, 0.0, 0.0});
      }
      const gcode::PointList list = along(positions);
      const PathStatistics statistics = pathStatistics(list);
      const auto& borders = statistics.distances.bordersMm;
      RC_ASSERT(std::is_sorted(borders.begin(), borders.end()));
      RC_ASSERT(total(statistics.distances.counts) == steps.size());
      RC_ASSERT(total(statistics.angles.counts) == steps.size() - 1);
      std::vector<std::size_t> counted(borders.size() - 1);
      for (std::size_t i = 1; i < positions.size(); ++i) {
        const double distance = base::distance(positions[i - 1], positions[i]);
        std::size_t at = 0;
        while (at + 1 < counted.size() && distance >= borders[at + 1]) {
          ++at;
        }
        RC_ASSERT(distance >= borders[at]);
        ++counted[at];
      }
      RC_ASSERT(counted == statistics.distances.counts);
    }));
  }
};

RIVULET_TEST(TestPathStatistics)
#include "tst_path_statistics.moc"
