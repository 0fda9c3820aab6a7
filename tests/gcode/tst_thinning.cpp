// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fewer points on the same path: the fewest there are, by trying all of them; and a measure of how
// far they are off that finds what wrong ways to leave points out do.

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "gcode/interpreter.h"
#include "gcode/path_deviation.h"
#include "gcode/program.h"
#include "gcode/thinning.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;
using base::AxisPosition;
using base::Vec3;
using gcode::Trajectory;

namespace {

constexpr double kToleranceMm = 0.005;

Trajectory pathOf(const std::vector<Vec3>& places) {
  Trajectory path;
  for (const Vec3& place : places) {
    path.points.push_back({place, 10.0, {}, gcode::MoveKind::Feed});
    path.points.back().line.value = static_cast<std::uint32_t>(path.points.size());
  }
  return path;
}

/// Short steps that go on in a direction which changes little: the tolerance allows some of them.
std::vector<Vec3> drawCurve(base::Random& random, std::size_t count, bool inSpace) {
  std::vector<Vec3> places{{1.0, -2.0, 0.5}};
  double course = 6.0 * random.uniform();
  double slope = 0.0;
  const double turn = 0.3 * random.uniform();
  while (places.size() < count) {
    const double step = 0.001 * std::round(1.0 + 100.0 * random.uniform());
    course += turn * random.normal();
    slope = inSpace ? 0.9 * slope + 0.1 * random.normal() : 0.0;
    const Vec3 next = places.back() + step * Vec3{std::cos(course), std::sin(course), slope};
    places.push_back({0.001 * std::round(1000.0 * next.x), 0.001 * std::round(1000.0 * next.y),
                      0.001 * std::round(1000.0 * next.z)});
  }
  return places;
}

std::vector<AxisPosition> placesOf(const std::vector<Vec3>& path) {
  return gcode::placesOf(pathOf(path));
}

/// The rules of `gcode::thin` in other words, for one move in place of some.
bool isAllowed(const std::vector<Vec3>& path, std::size_t from, std::size_t to, double tolerance) {
  if (to == from + 1) {
    return true;
  }
  const Vec3 way = path[to] - path[from];
  if (way == Vec3{}) {
    return false;
  }
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (base::dot(path[i] - path[i - 1], way) < 0.0) {
      return false;
    }
    constexpr double kCosCorner = 0.8660254037844386;  // of 30 degrees
    const Vec3 before = path[i] - path[i - 1];
    if (i < to && base::dot(before, path[i + 1] - path[i]) <
                      kCosCorner * base::norm(before) * base::distance(path[i], path[i + 1])) {
      return false;
    }
  }
  const std::vector<AxisPosition> places = placesOf(path);
  const std::vector<AxisPosition> chord{places[from], places[to]};
  return gcode::isAlong(std::span(places).subspan(from, to - from + 1), chord, tolerance);
}

/// All choices of points are tried.
std::size_t fewestPoints(const std::vector<Vec3>& path, double tolerance) {
  std::size_t fewest = path.size();
  const std::size_t inner = path.size() - 2;
  for (std::size_t choice = 0; choice < (std::size_t{1} << inner); ++choice) {
    std::size_t last = 0;
    std::size_t count = 1;
    bool isRight = true;
    for (std::size_t i = 1; isRight && i < path.size(); ++i) {
      if (i + 1 == path.size() || ((choice >> (i - 1)) & 1U) != 0) {
        isRight = isAllowed(path, last, i, tolerance);
        last = i;
        ++count;
      }
    }
    if (isRight) {
      fewest = std::min(fewest, count);
    }
  }
  return fewest;
}

/// As Eiter and Mannila (1994) have it, over places that lie closely along both paths: from above,
/// never more than the distance of those places too large.
double closely(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double stepMm) {
  const auto along = [stepMm](const std::vector<Vec3>& path) {
    std::vector<Vec3> places{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const int parts =
          std::max(1, static_cast<int>(base::distance(path[i - 1], path[i]) / stepMm));
      for (int part = 1; part <= parts; ++part) {
        places.push_back(path[i - 1] +
                         (static_cast<double>(part) / parts) * (path[i] - path[i - 1]));
      }
    }
    return places;
  };
  const std::vector<Vec3> from = along(a);
  const std::vector<Vec3> to = along(b);
  std::vector<double> row(to.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < from.size(); ++i) {
    double before = i == 0 ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < to.size(); ++j) {
      const double aside = j == 0 ? std::numeric_limits<double>::infinity() : row[j - 1];
      const double least = std::min({before, row[j], aside});
      before = row[j];
      row[j] = std::max(least, base::distance(from[i], to[j]));
    }
  }
  return row.back();
}

double deviation(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double most = 10.0) {
  return gcode::pathDeviation(placesOf(a), placesOf(b), most).value();
}

/// The moves that are left are those of the program but for what lies within them.
bool keepsWhatHolds(const Trajectory& path, const Trajectory& thinned) {
  std::size_t next = 0;
  for (const gcode::TrajectoryPoint& each : path.points) {
    if (next == thinned.points.size()) {
      return false;
    }
    const gcode::TrajectoryPoint& kept = thinned.points[next];
    next += each.line == kept.line ? 1 : 0;
    // A point left out belongs to the move that ends at the next one kept.
    if (each.kind != kept.kind || each.feedMmPerS != kept.feedMmPerS) {
      return false;
    }
  }
  return next == thinned.points.size() && thinned.events.size() == path.events.size();
}

}  // namespace

class TestThinning : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hasTheFewestPoints() {
    base::Random random(1);
    std::size_t before = 0;
    std::size_t after = 0;
    for (int run = 0; run < 400; ++run) {
      const auto count = static_cast<std::size_t>(3 + run % 9);
      const std::vector<Vec3> path = drawCurve(random, count, run % 2 == 0);
      const double tolerance = 0.001 + 0.01 * random.uniform();
      const Trajectory thinned = gcode::thin(pathOf(path), {tolerance}).trajectory;
      QCOMPARE(thinned.points.size(), fewestPoints(path, tolerance));
      before += path.size();
      after += thinned.points.size();
    }
    // There was something to choose.
    QVERIFY(2 * after < 2 * before - before / 4 && 4 * after > before);
  }

  /// Nothing that is left out is farther off than allowed, on both ways, and what holds for a move
  /// stays.
  void staysWithinTheTolerance() {
    QVERIFY(rc::check("thinning", [] {
      base::Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1'000'000)));
      const std::vector<Vec3> places =
          drawCurve(random, static_cast<std::size_t>(*rc::gen::inRange(2, 300)), true);
      Trajectory path = pathOf(places);
      for (gcode::TrajectoryPoint& point : path.points) {
        point.feedMmPerS = random.uniform() < 0.05 ? 5.0 : 10.0;
        point.kind = random.uniform() < 0.05 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
      }
      path.events.push_back(
          {static_cast<std::size_t>(random.uniform() * static_cast<double>(places.size())),
           3.0,
           {1},
           gcode::PathEvent::Kind::M});
      const double tolerance = *rc::gen::inRange(1, 50) / 1000.0;
      const bool onSteps = *rc::gen::inRange(0, 2) == 1;
      const gcode::ThinnedTrajectory thinned = gcode::thin(path, {tolerance, onSteps});
      RC_ASSERT(thinned.leftOut + thinned.trajectory.points.size() == path.points.size());
      RC_ASSERT(keepsWhatHolds(path, thinned.trajectory));
      RC_ASSERT(
          gcode::isAlong(gcode::placesOf(path), gcode::placesOf(thinned.trajectory), tolerance));
    }));
  }

  /// What is to be packed is compared where it will be.
  void countsTheRoundingOfPackedPoints() {
    base::Random random(4);
    std::vector<Vec3> places = drawCurve(random, 2000, false);
    for (Vec3& place : places) {
      place = place + 0.0004 * Vec3{random.normal(), random.normal(), 0.0};
    }
    gcode::Program program;
    program.trajectory = pathOf(places);
    gcode::Program exact = program;
    gcode::MoveRules rules;
    rules.tolerance = 0.004;
    QVERIFY(gcode::applyRules(exact, rules));
    rules.onSteps = true;
    QVERIFY(gcode::applyRules(program, rules));
    QVERIFY(program.merged && program.merged->deviationMm <= 0.004);
    QVERIFY(program.merged->to >= exact.merged->to);
    std::vector<Vec3> packed;
    for (const gcode::TrajectoryPoint& point : program.trajectory.points) {
      const Vec3 at = point.positionMm;
      packed.push_back({0.001 * std::round(1000.0 * at.x), 0.001 * std::round(1000.0 * at.y),
                        0.001 * std::round(1000.0 * at.z)});
    }
    QCOMPARE(deviation(places, packed, 0.004), program.merged->deviationMm);
  }

  void straightLinesThinToTheirEnds() {
    const auto result = gcode::interpret(
        "G0 X0 Y0 Z0\nG1 F60\nX1 Y1\nX2 Y2\nX3 Y3\nM3\nX4 Y4\nX5 Y5 F90\nX6 Y6", {});
    const gcode::ThinnedTrajectory thinned = gcode::thin(result.trajectory, {1e-6});
    QCOMPARE(QByteArray::fromStdString(test::printPoints(thinned.trajectory)),
             QByteArray("1 R X0 Y0 Z0 | 5 L X3 Y3 Z0 F60 | 7 L X4 Y4 Z0 F60 | 9 L X6 Y6 Z0 F90"));
    QCOMPARE(thinned.trajectory.events.size(), std::size_t{1});
    QCOMPARE(thinned.trajectory.events[0].point, std::size_t{2});
  }

  /// One row per thing that must not be left out.
  void keepsWhatIsNotWithinTheTolerance_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("kept");
    const auto row = [](const char* name, const char* text, const char* kept) {
      QTest::newRow(name) << QByteArray(text) << QByteArray(kept);
    };
    row("a corner, however short its sides", "G1 X0 Y0 Z0 F60\nX0.002\nY0.002\nX0.004\n",
        "1 L X0 Y0 Z0 F60 | 2 L X0.002 Y0 Z0 F60 | 3 L X0.002 Y0.002 Z0 F60 | "
        "4 L X0.004 Y0.002 Z0 F60");
    row("a way to and fro", "G1 X0 Y0 Z0 F60\nX0.1\nX0.098\nX0.2\n",
        "1 L X0 Y0 Z0 F60 | 2 L X0.1 Y0 Z0 F60 | 3 L X0.098 Y0 Z0 F60 | 4 L X0.2 Y0 Z0 F60");
    row("an axis that is named first", "G1 X0 Y0 F60\nX1\nX2 Z0\nX3\nX4\n",
        "1 L X0 Y0 Z? F60 | 2 L X1 Y0 Z? F60 | 3 L X2 Y0 Z0 F60 | 5 L X4 Y0 Z0 F60");
    row("an axis that is never named", "G1 X0 Y0 F60\nX1\nX2\n",
        "1 L X0 Y0 Z? F60 | 3 L X2 Y0 Z? F60");
    row("a feed", "G1 X0 Y0 Z0 F60\nX1\nX2 F50\nX3\n",
        "1 L X0 Y0 Z0 F60 | 2 L X1 Y0 Z0 F60 | 4 L X3 Y0 Z0 F50");
    row("an event", "G1 X0 Y0 Z0 F60\nX1\nM8\nX2\n",
        "1 L X0 Y0 Z0 F60 | 2 L X1 Y0 Z0 F60 | 4 L X2 Y0 Z0 F60");
    row("rapids", "G0 X0 Y0 Z0\nX1\nX2\n", "1 R X0 Y0 Z0 | 2 R X1 Y0 Z0 | 3 R X2 Y0 Z0");
    row("a lift", "G1 X0 Y0 Z0 F60\nX1 Z0.006\nX2 Z0\n",
        "1 L X0 Y0 Z0 F60 | 2 L X1 Y0 Z0.006 F60 | 3 L X2 Y0 Z0 F60");
    row("what stands where it stood goes", "G1 X0 Y0 Z0 F60\nX1\nX1\nX2\n",
        "1 L X0 Y0 Z0 F60 | 4 L X2 Y0 Z0 F60");
  }
  void keepsWhatIsNotWithinTheTolerance() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, kept);
    const auto path = gcode::interpret(text.toStdString(), {}).trajectory;
    QCOMPARE(
        QByteArray::fromStdString(test::printPoints(gcode::thin(path, {kToleranceMm}).trajectory)),
        kept);
  }

  /// Degrees have the tolerance for themselves; a move that only turns is none that leads along.
  void turnsWithinTheTolerance() {
    const auto thinned = [](const char* text) {
      const Trajectory path = gcode::interpret(text, {}).trajectory;
      const Trajectory thin = gcode::thin(path, {kToleranceMm}).trajectory;
      if (!gcode::isAlong(gcode::placesOf(path), gcode::placesOf(thin), kToleranceMm)) {
        qFatal("%s", text);
      }
      return thin.points.size();
    };
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nX1 A1\nX2 A2\nX3 A3\n"), std::size_t{2});
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nX1 A1.004\nX2 A2\nX3 A3.004\n"), std::size_t{2});
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nX1 A1.1\nX2 A2\nX3 A3.1\n"), std::size_t{4});
    // The tool goes straight on, but the table turns at another place.
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nX1 A0\nX2 A1\nX3 A1\n"), std::size_t{4});
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nX1\nA9\nX2\n"), std::size_t{4});
    QCOMPARE(thinned("G1 X0 Y0 Z0 A0 F60\nA1\nA2\nA9\n"), std::size_t{2});
  }

  /// A tolerance that is none changes nothing, and says so.
  void refusesToleranceThatIsNone_data() {
    QTest::addColumn<double>("tolerance");
    QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("negative") << -0.005;
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
    QTest::newRow("too large") << 1.001;
  }
  void refusesToleranceThatIsNone() {
    QFETCH(double, tolerance);
    gcode::Program program = *gcode::interpretProgram("a.nc", "G1 X0 Y0 Z0 F60\nX1\nX2\n");
    gcode::MoveRules rules;
    rules.tolerance = tolerance;
    const auto applied = gcode::applyRules(program, rules);
    QVERIFY(!applied && applied.error().code == gcode::GcodeError::BadTolerance);
    QCOMPARE(program.trajectory.points.size(), std::size_t{3});
    QVERIFY(!program.merged);
  }

  void changesNothingWithoutATolerance() {
    gcode::Program program = *gcode::interpretProgram("a.nc", "G1 X0 Y0 Z0 F60\nX1\nX2\n");
    const auto applied = gcode::applyRules(program, {});
    QVERIFY(applied && !*applied && !program.merged);
    QCOMPARE(program.trajectory.points.size(), std::size_t{3});
    // Steps are coarser than the tolerance.
    program.trajectory.points[1].positionMm.y = 0.0004;
    gcode::MoveRules rules;
    rules.tolerance = 0.0003;
    rules.onSteps = true;
    const auto refused = gcode::applyRules(program, rules);
    QVERIFY(!refused && refused.error().code == gcode::GcodeError::BadTolerance);
    QCOMPARE(program.trajectory.points.size(), std::size_t{3});
  }

  /// The measure against another one, which is made of points alone.
  void measuresTheDeviation() {
    base::Random random(7);
    constexpr double kStepMm = 0.002;
    for (int run = 0; run < 200; ++run) {
      const std::vector<Vec3> path = drawCurve(random, 20, run % 2 == 0);
      std::vector<Vec3> other{path.front()};
      for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        if (random.uniform() < 0.6) {
          other.push_back(path[i] + 0.02 * Vec3{random.normal(), random.normal(), 0.0});
        }
      }
      other.push_back(path.back());
      const double measured = deviation(path, other);
      const double aboveIt = closely(path, other, kStepMm);
      QVERIFY2(
          measured <= aboveIt + gcode::kDeviationStep + 1e-9 && measured >= aboveIt - 2.0 * kStepMm,
          qPrintable(QStringLiteral("%1 %2").arg(measured).arg(aboveIt)));
      QCOMPARE(deviation(other, path), measured);
    }
    const std::vector<Vec3> same = drawCurve(random, 50, true);
    QCOMPARE(deviation(same, same), 0.0);
    QVERIFY(!gcode::pathDeviation(placesOf({{0, 0, 0}, {1, 0, 0}}),
                                  placesOf({{0, 1, 0}, {1, 1, 0}}), 0.9));
  }

  /// Ways to leave points out that a measure of points, or of one side, finds right.
  void findsWrongCompressors_data() {
    QTest::addColumn<int>("which");
    const char* const names[] = {"drops a corner",
                                 "cuts a spike off",
                                 "passes a spike the other way round",
                                 "goes straight across a slot",
                                 "leaves out a loop where the path crosses itself",
                                 "drops a lift",
                                 "drops the end"};
    int which = 0;
    for (const char* const name : names) {
      QTest::newRow(name) << which++;
    }
  }
  void findsWrongCompressors() {
    QFETCH(int, which);
    struct Case {
      std::vector<Vec3> path;
      std::vector<Vec3> wrong;
      double offMm = 0.0;
    };
    const std::vector<Case> cases{
        {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}}, std::sqrt(0.5)},
        {{{0, 0, 0}, {5, 0, 0}, {5, 2, 0}, {5, 0, 0}, {9, 0, 0}}, {{0, 0, 0}, {9, 0, 0}}, 2.0},
        // All points of each lie on the other.
        {{{0, 0, 0}, {9, 0, 0}, {3, 0, 0}, {12, 0, 0}}, {{0, 0, 0}, {12, 0, 0}}, 3.0},
        // 0.2 mm wide: every place of the shortcut is near the walls, but not in their order.
        {{{0, 0, 0}, {0, 8, 0}, {0.2, 8, 0}, {0.2, 0, 0}}, {{0, 0, 0}, {0.2, 0, 0}}, 8.0},
        {{{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {3, 3, 0}, {3, 0, 0}, {8, 0, 0}},
         {{0, 0, 0}, {8, 0, 0}},
         std::sqrt(10.0)},
        {{{0, 0, 0}, {1, 0, 0}, {1, 0, 2}, {3, 0, 2}, {3, 0, 0}, {4, 0, 0}},
         {{0, 0, 0}, {4, 0, 0}},
         2.0},
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, 1.0}};
    const Case& tried = cases[static_cast<std::size_t>(which)];
    const double measured = deviation(tried.path, tried.wrong);
    QVERIFY2(std::abs(measured - tried.offMm) < 2.0 * gcode::kDeviationStep,
             qPrintable(QString::number(measured)));
    // What is measured here never happens.
    const Trajectory thinned = gcode::thin(pathOf(tried.path), {kToleranceMm}).trajectory;
    QVERIFY(gcode::isAlong(placesOf(tried.path), gcode::placesOf(thinned), kToleranceMm));
  }

  /// A measure of places says nothing of feeds: the second judge of this file has to.
  void findsFeedThatIsLost() {
    Trajectory path = pathOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    path.points[1].feedMmPerS = 5.0;
    Trajectory lost = path;
    lost.points.erase(lost.points.begin() + 1, lost.points.begin() + 3);
    QCOMPARE(deviation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 0, 0}, {3, 0, 0}}), 0.0);
    QVERIFY(!keepsWhatHolds(path, lost));
    QVERIFY(keepsWhatHolds(path, gcode::thin(path, {kToleranceMm}).trajectory));
  }

  /// A curve of a radius: the chords are as long as the tolerance allows.
  void chordsAreAsLongAsTheyMayBe() {
    constexpr double kRadiusMm = 10.0;
    constexpr double kStepMm = 0.02;
    std::vector<Vec3> path;
    for (int i = 0; i < 3000; ++i) {
      const double angle = kStepMm * i / kRadiusMm;
      path.push_back({kRadiusMm * std::cos(angle), kRadiusMm * std::sin(angle), 0.0});
    }
    const Trajectory thinned = gcode::thin(pathOf(path), {kToleranceMm}).trajectory;
    const double longestMm = 2.0 * std::sqrt(2.0 * kRadiusMm * kToleranceMm);
    const double fewest = 1.0 + std::ceil(2999 * kStepMm / longestMm);
    QVERIFY2(static_cast<double>(thinned.points.size()) <= 1.05 * fewest &&
                 static_cast<double>(thinned.points.size()) >= fewest,
             qPrintable(QString::number(thinned.points.size())));
  }
};

RIVULET_TEST(TestThinning)
#include "tst_thinning.moc"
