// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <vector>

#include "gcode/sketch.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::MoveKind;
using gcode::sketchOf;

namespace {

/// A rapid to the begin, then a long arc.
std::vector<gcode::StreamPoint> arc(int pieces) {
  std::vector<gcode::StreamPoint> points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 3.0 * i / pieces;
    points.push_back({{100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0},
                      base::LineNumber{1},
                      i == 0 ? MoveKind::Rapid : MoveKind::Feed,
                      {}});
  }
  return points;
}

}  // namespace

class TestSketch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keepsBothEnds() {
    const auto points = arc(100'000);
    for (const std::size_t most : {std::size_t{2}, std::size_t{50}, std::size_t{4000}}) {
      const auto sketch = sketchOf(points, most);
      QVERIFY(sketch.size() >= 2 && sketch.size() <= most);
      QVERIFY(sketch.front().positionMm == points.front().positionMm);
      QVERIFY(sketch.back().positionMm == points.back().positionMm);
      QVERIFY(sketch.front().isRapid && !sketch.back().isRapid);
    }
  }

  /// What is left out lies too close to what is kept to be seen.
  void leavesOutOnlyWhatIsNotSeen() {
    const auto points = arc(20'000);
    const auto sketch = sketchOf(points, 4000);
    for (const gcode::StreamPoint& point : points) {
      double nearestMm = 1e9;
      for (std::size_t i = 1; i < sketch.size() && nearestMm > 1.0; ++i) {
        nearestMm =
            std::min(nearestMm, base::distanceToSegment(point.positionMm, sketch[i - 1].positionMm,
                                                        sketch[i].positionMm));
      }
      QVERIFY(nearestMm < 1.0);  // of a path 200 mm wide
    }
  }

  void fewPointsStayAsTheyAre() {
    QCOMPARE(sketchOf(arc(20), 4000).size(), std::size_t{21});
    QVERIFY(sketchOf({}, 4000).empty());
  }
};

RIVULET_TEST(TestSketch)
#include "tst_sketch.moc"
