// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <numbers>

#include "nc/geometry/arc.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Vec3;

namespace {

constexpr double kPi = std::numbers::pi;

/// An arc known by its angles: what the flattened one is measured against.
struct KnownArc {
  nc::Arc arc;
  double radiusMm = 1.0;
  double startAngle = 0.0;
  double sweep = 0.0;  ///< > 0
  double riseMm = 0.0;
};

double uniform(int thousandths, double min, double max) {
  return min + (max - min) * thousandths / 1000.0;
}

KnownArc drawArc() {
  const auto share = [] { return *rc::gen::inRange(0, 1001); };
  KnownArc known;
  known.radiusMm = std::pow(10.0, uniform(share(), -1.0, 3.0));
  known.startAngle = uniform(share(), -kPi, kPi);
  known.sweep = uniform(share(), 0.01, 2.0 * kPi - 0.01);
  known.riseMm = uniform(share(), -5.0, 5.0);
  known.arc.firstAxis = *rc::gen::element<std::size_t>(0, 1, 2);
  known.arc.clockwise = *rc::gen::arbitrary<bool>();
  const std::size_t second = (known.arc.firstAxis + 1) % 3;
  const std::size_t third = (known.arc.firstAxis + 2) % 3;
  const double direction = known.arc.clockwise ? -1.0 : 1.0;
  known.arc.centreMm = {uniform(share(), -500, 500), uniform(share(), -500, 500),
                        uniform(share(), -500, 500)};
  const auto at = [&](double angle, double heightMm) {
    Vec3 point;
    point.set(known.arc.firstAxis,
              known.arc.centreMm[known.arc.firstAxis] + known.radiusMm * std::cos(angle));
    point.set(second, known.arc.centreMm[second] + known.radiusMm * std::sin(angle));
    point.set(third, heightMm);
    return point;
  };
  known.arc.startMm = at(known.startAngle, 7.0);
  known.arc.endMm = at(known.startAngle + direction * known.sweep, 7.0 + known.riseMm);
  return known;
}

}  // namespace

class TestArc : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    // The same arcs in every run; a seed from outside replays another.
    if (!qEnvironmentVariableIsSet("RC_PARAMS")) {
      qputenv("RC_PARAMS", "seed=20260101 max_success=300");
    }
  }

  void chordsStayWithinTheTolerance() {
    QVERIFY(rc::check("every point of every chord is within the tolerance of the arc", [] {
      const KnownArc known = drawArc();
      const double toleranceMm = std::pow(10.0, uniform(*rc::gen::inRange(0, 1001), -4.0, 0.0));
      std::vector<Vec3> points;
      nc::flattenArc(known.arc, toleranceMm, points);
      RC_ASSERT(!points.empty());
      RC_ASSERT(points.back() == known.arc.endMm);
      const std::size_t first = known.arc.firstAxis;
      const std::size_t second = (first + 1) % 3;
      // Rounding of coordinates up to 1500 mm.
      constexpr double kRoundingMm = 1e-9;
      Vec3 from = known.arc.startMm;
      for (const Vec3& to : points) {
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const Vec3 point = from + share * (to - from);
          const double radiusMm = std::hypot(point[first] - known.arc.centreMm[first],
                                             point[second] - known.arc.centreMm[second]);
          RC_ASSERT(radiusMm <= known.radiusMm + kRoundingMm);
          RC_ASSERT(radiusMm >= known.radiusMm - toleranceMm - kRoundingMm);
        }
        from = to;
      }
    }));
  }

  void cornersRunAlongTheArc() {
    QVERIFY(rc::check("corners follow the direction, the rise and the sweep", [] {
      const KnownArc known = drawArc();
      std::vector<Vec3> points;
      const double lengthMm = nc::flattenArc(known.arc, 0.01, points);
      const double exactMm = std::hypot(known.radiusMm * known.sweep, known.riseMm);
      RC_ASSERT(std::abs(lengthMm - exactMm) < 1e-6 * (1.0 + exactMm));
      const std::size_t first = known.arc.firstAxis;
      const std::size_t second = (first + 1) % 3;
      const std::size_t third = (first + 2) % 3;
      const double direction = known.arc.clockwise ? -1.0 : 1.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(points.size());
        const double angle = known.startAngle + direction * known.sweep * share;
        const double x = known.arc.centreMm[first] + known.radiusMm * std::cos(angle);
        const double y = known.arc.centreMm[second] + known.radiusMm * std::sin(angle);
        RC_ASSERT(std::hypot(points[i][first] - x, points[i][second] - y) < 1e-6);
        RC_ASSERT(std::abs(points[i][third] - (7.0 + known.riseMm * share)) < 1e-9);
      }
    }));
  }

  void radiusGivesTheSameArcAsItsCentre() {
    QVERIFY(rc::check("CR= is positive up to a half circle, negative beyond", [] {
      const KnownArc known = drawArc();
      RC_PRE(std::abs(known.sweep - kPi) > 1e-2);
      const double radiusMm = known.sweep > kPi ? -known.radiusMm : known.radiusMm;
      const Vec3 centreMm = nc::arcCentre(known.arc, radiusMm);
      for (const std::size_t axis : {known.arc.firstAxis, (known.arc.firstAxis + 1) % 3}) {
        // Near a full circle the chord is short and the centre ill-conditioned.
        RC_ASSERT(std::abs(centreMm[axis] - known.arc.centreMm[axis]) < 1e-6 * known.radiusMm);
      }
    }));
  }

  void fullCircleReturnsToItsStart() {
    nc::Arc arc{{10, 0, 5}, {10, 0, 5}, {0, 0, 0}, 0, true};
    std::vector<Vec3> points;
    const double lengthMm = nc::flattenArc(arc, 0.005, points);
    QVERIFY(std::abs(lengthMm - 20.0 * kPi) < 1e-9);
    QVERIFY(points.size() > 50);
    QVERIFY(points.front().y < 0.0);  // clockwise
    QCOMPARE(points.back(), arc.endMm);
    double lowest = 0.0;
    for (const Vec3& point : points) {
      lowest = std::min(lowest, point.x);
    }
    QVERIFY(lowest < -9.99);
  }

  void smallCircleKeepsItsShape() {
    nc::Arc arc{{0.001, 0, 0}, {0.001, 0, 0}, {0, 0, 0}, 0, false};
    std::vector<Vec3> points;
    nc::flattenArc(arc, 1.0, points);
    QCOMPARE(points.size(), std::size_t{4});
  }

  void smallMismatchSpirals() {
    nc::Arc arc{{10, 0, 0}, {0, 10.02, 0}, {0, 0, 0}, 0, false};
    std::vector<Vec3> points;
    nc::flattenArc(arc, 0.005, points);
    double radiusMm = 10.0;
    for (const Vec3& point : points) {
      const double next = std::hypot(point.x, point.y);
      QVERIFY(next > radiusMm);
      QVERIFY(next < radiusMm + 0.01);
      radiusMm = next;
    }
    QCOMPARE(points.back(), (Vec3{0, 10.02, 0}));
  }

  void shortRadiusBecomesAHalfCircle() {
    const nc::Arc arc{{0, 0, 0}, {10, 0, 0}, {}, 0, true};
    const Vec3 centreMm = nc::arcCentre(arc, 4.995);
    QCOMPARE(centreMm.x, 5.0);
    QCOMPARE(centreMm.y, 0.0);
  }

  void unknownHeightStaysUnknown() {
    const double unknown = std::nan("");
    nc::Arc arc{{10, 0, unknown}, {0, 10, unknown}, {0, 0, unknown}, 0, false};
    std::vector<Vec3> points;
    const double lengthMm = nc::flattenArc(arc, 0.005, points);
    QVERIFY(std::abs(lengthMm - 5.0 * kPi) < 1e-9);
    QVERIFY(std::isnan(points.front().z));
    QVERIFY(std::isfinite(points.front().x));
  }
};

RIVULET_TEST(TestArc)
#include "tst_arc.moc"
