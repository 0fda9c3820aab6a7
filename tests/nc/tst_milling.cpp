// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The milling cycles keep to what their parameters say: extent, depth, infeeds and planes.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "nc/cycles/milling.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::CycleStep;

namespace {

using Arguments = std::vector<std::optional<double>>;
constexpr std::nullopt_t kNone = std::nullopt;
/// Radius of the tool: 4 mm.
constexpr nc::CycleStart kStart{{0.0, 0.0, 50.0}, 0, 1.0, 600.0, 4.0};

struct Extent {
  base::Vec3 minMm{1e9, 1e9, 1e9};
  base::Vec3 maxMm{-1e9, -1e9, -1e9};
  std::set<double> depths;  ///< where the tool cuts across
  bool dives = false;       ///< a rapid below the reference plane
};
Extent extentOf(const std::vector<CycleStep>& steps) {
  Extent extent;
  base::Vec3 from = kStart.positionMm;
  for (const CycleStep& step : steps) {
    const bool cuts = step.kind == CycleStep::Kind::Feed;
    for (std::size_t axis = 0; axis < base::kAxisCount && cuts; ++axis) {
      extent.minMm.set(axis, std::min(extent.minMm[axis], step.toMm[axis]));
      extent.maxMm.set(axis, std::max(extent.maxMm[axis], step.toMm[axis]));
    }
    if (cuts && from.z == step.toMm.z) {
      extent.depths.insert(std::round(step.toMm.z * 1e6) / 1e6);
    }
    extent.dives = extent.dives || (!cuts && step.toMm.z < 0.0);
    from = step.toMm;
  }
  return extent;
}
bool isNear(double a, double b) {
  return std::abs(a - b) < 0.011;  // chords
}

}  // namespace

class TestMilling : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rectangularPocket() {
    // 60 x 40 about X70 Y50, 6 deep in infeeds of at most 2.5, 0.2 left at the edge.
    const Arguments arguments{20, 0, 2, -6, 60, 40, 8, 70, 50, 0, 2.5, 0.2, 0, 400, 150, 0, 11, 5};
    const auto steps = nc::expandMilling("POCKET3", arguments, kStart);
    QVERIFY(steps.has_value());
    const Extent extent = extentOf(*steps);
    QVERIFY(isNear(extent.minMm.x, 40 + 4.2) && isNear(extent.maxMm.x, 100 - 4.2));
    QVERIFY(isNear(extent.minMm.y, 30 + 4.2) && isNear(extent.maxMm.y, 70 - 4.2));
    QCOMPARE(extent.depths, (std::set<double>{-2.0, -4.0, -6.0}));
    QVERIFY(!extent.dives);
    QCOMPARE(steps->back().toMm, (base::Vec3{70.0, 50.0, 20.0}));
    const auto feedOf = [](double mmPerS) {
      return [mmPerS](const CycleStep& step) { return std::abs(step.feedMmPerS - mmPerS) < 1e-9; };
    };
    QVERIFY(std::any_of(steps->begin(), steps->end(), feedOf(400.0 / 60.0)));
    QVERIFY(std::any_of(steps->begin(), steps->end(), feedOf(150.0 / 60.0)));
  }
  /// A wall is finished from a tangent, and left on one.
  void tangentAtTheWall() {
    const Arguments arguments{20, 0, 2, -6, 60, 40, 8, 70, 50, 0, 6, 0.2, 0, 400, 150, 0, 2, 5};
    const auto steps = nc::expandMilling("POCKET3", arguments, kStart);
    QVERIFY(steps.has_value());
    // The outermost place of the path is reached along the wall, and not across it.
    const auto wall = std::find_if(steps->begin(), steps->end(), [](const CycleStep& step) {
      return std::abs(step.toMm.x - 96.0) < 1e-9;
    });
    QVERIFY(wall != steps->end() && wall != steps->begin());
    const base::Vec3 way = wall->toMm - std::prev(wall)->toMm;
    QVERIFY(way.y > 5.0 * std::abs(way.x));
    const Extent extent = extentOf(*steps);
    QVERIFY(isNear(extent.minMm.x, 44) && isNear(extent.maxMm.x, 96));
    QVERIFY(isNear(extent.minMm.y, 34) && isNear(extent.maxMm.y, 66));
  }
  void toolThatDoesNotFit() {
    const Arguments narrow{20, 0, 2, -6, 60, 7, 3, 70, 50, 0, 3, 0, 0, 400, 150, 0, 1};
    const auto steps = nc::expandMilling("POCKET3", narrow, kStart);
    QVERIFY(!steps && steps.error().alarm == nc::kToolTooLarge);
  }
  void depthAboveTheReference() {
    const Arguments arguments{20, 0, 2, 6, 15, 0, 0, 3, 0, 0, 400, 150, 0, 1};
    const auto steps = nc::expandMilling("POCKET4", arguments, kStart);
    QVERIFY(!steps && steps.error().alarm == nc::kReferencePlaneWrong);
  }
  void others_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Arguments>("arguments");
    QTest::addColumn<QVector<double>>("extent");  ///< X and Y, from and to
    QTest::newRow("circle") << "POCKET4"
                            << Arguments{20, 0, 2, -6, 15, 150, 50, 3, 0, 0, 400, 150, 0, 1}
                            << QVector<double>{139, 161, 39, 61};
    QTest::newRow("long holes") << "LONGHOLE" << Arguments{20, 0,  2, -4,  kNone, 2,   30, 100,
                                                           50, 10, 0, 180, 100,   300, 2}
                                << QVector<double>{60, 140, 50, 50};
    QTest::newRow("slot") << "SLOT1" << Arguments{20, 0, 2,  -4,  kNone, 1, 30, 12, 0, 0,
                                                  10, 0, 90, 100, 300,   2, 2,  0,  1}
                          << QVector<double>{14, 36, -2, 2};
    QTest::newRow("round slot") << "SLOT2" << Arguments{20, 0, 2,  -4,  kNone, 1, 90, 10, 0, 0,
                                                        30, 0, 90, 100, 300,   2, 2,  0,  1}
                                << QVector<double>{0, 31, 0, 31};
    QTest::newRow("face") << "CYCLE71"
                          << Arguments{50, 0, 2, -1, 0, 0, 100, 60, 0, 1, 5, 5, 0, 600, 31, 5}
                          << QVector<double>{-6, 106, 2.5, 57.5};
    QTest::newRow("spigot") << "CYCLE76" << Arguments{20, 0, 2,   -5, kNone, 60,  40,  8, 50,
                                                      40, 0, 2.5, 0,  0,     500, 200, 0, 1}
                            << QVector<double>{16, 90, 16, 64};
    QTest::newRow("thread") << "CYCLE90"
                            << Arguments{20, 0, 2, -12, kNone, 24, 21.3, 1.5, 300, 3, 0, 180, 40}
                            << QVector<double>{172, 188, 32, 48};
  }
  void others() {
    QFETCH(const QString, name);
    QFETCH(const Arguments, arguments);
    QFETCH(const QVector<double>, extent);
    const auto steps = nc::expandMilling(name.toStdString(), arguments, kStart);
    QVERIFY(steps.has_value());
    const Extent found = extentOf(*steps);
    QVERIFY2(isNear(found.minMm.x, extent[0]), qPrintable(QString::number(found.minMm.x)));
    QVERIFY2(isNear(found.maxMm.x, extent[1]), qPrintable(QString::number(found.maxMm.x)));
    QVERIFY2(isNear(found.minMm.y, extent[2]), qPrintable(QString::number(found.minMm.y)));
    QVERIFY2(isNear(found.maxMm.y, extent[3]), qPrintable(QString::number(found.maxMm.y)));
    QVERIFY(!found.dives);
    QVERIFY(steps->back().kind == CycleStep::Kind::Rapid);
    QCOMPARE(steps->back().toMm.z, *arguments[0]);
  }
};

RIVULET_TEST(TestMilling)
#include "tst_milling.moc"
