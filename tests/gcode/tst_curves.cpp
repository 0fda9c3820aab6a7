// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Frames, splines, arcs in space and divided moves: what must hold for any of them.

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>
#include <numbers>

#include "gcode/interpreter.h"
#include "gcode/thinning.h"
#include "gcode_text.h"
#include "nc/geometry/arc.h"
#include "nc/geometry/spline.h"
#include "nc/modal/frame.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Vec3;

namespace {

double coordinate() {
  return *rc::gen::inRange(-100'000, 100'001) / 1000.0;
}

Vec3 point() {
  return {coordinate(), coordinate(), coordinate()};
}

double segmentDistance(Vec3 at, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double squares = base::dot(along, along);
  const double share =
      squares == 0.0 ? 0.0 : std::clamp(base::dot(at - a, along) / squares, 0.0, 1.0);
  return base::distance(at, a + share * along);
}

double distanceToPath(Vec3 at, const std::vector<Vec3>& path) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    nearest = std::min(nearest, segmentDistance(at, path[i - 1], path[i]));
  }
  return nearest;
}

gcode::Trajectory drawPath() {
  gcode::Trajectory path;
  const int count = *rc::gen::inRange(2, 200);
  Vec3 at = point();
  for (int i = 0; i < count; ++i) {
    gcode::TrajectoryPoint next;
    at = at + Vec3{*rc::gen::inRange(-50, 51) / 100.0, *rc::gen::inRange(-50, 51) / 100.0, 0.0};
    next.positionMm = at;
    next.feedMmPerS = *rc::gen::inRange(0, 20) == 0 ? 5.0 : 10.0;
    next.kind = *rc::gen::inRange(0, 15) == 0 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
    next.line.value = static_cast<std::uint32_t>(i + 1);
    path.points.push_back(next);
  }
  path.events.push_back({static_cast<std::size_t>(*rc::gen::inRange(0, count + 1)),
                         3.0,
                         {1},
                         gcode::PathEvent::Kind::M});
  return path;
}

}  // namespace

class TestCurves : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void framesAreUndone() {
    QVERIFY(rc::check("toProgrammed undoes toWorkpiece", [] {
      nc::Frame frame;
      const int steps = *rc::gen::inRange(1, 6);
      for (int i = 0; i < steps; ++i) {
        switch (*rc::gen::inRange(0, 3)) {
          case 0:
            frame.translate(point());
            break;
          case 1:
            frame.rotate(static_cast<std::size_t>(*rc::gen::inRange(0, 3)),
                         *rc::gen::inRange(-720, 721) / 2.0);
            break;
          default:
            frame.scale({*rc::gen::inRange(1, 30) / 10.0, -1.0, *rc::gen::inRange(1, 30) / 10.0});
        }
      }
      const Vec3 there = point();
      RC_ASSERT(base::distance(frame.toProgrammed(frame.toWorkpiece(there)), there) < 1e-7);
    }));
  }

  void unknownAxesStayApart() {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    nc::Frame frame;
    frame.translate({1, 2, 3});
    frame.rotate(2, 90);
    const Vec3 turned = frame.toWorkpiece({10, 0, kUnknown});
    QCOMPARE(turned.x, 1.0);
    QCOMPARE(turned.y, 12.0);
    QVERIFY(std::isnan(turned.z));
  }

  /// G43 makes the height unknown within a curve. It was drawn as three million points without a Z.
  void curvesStayKnown() {
    gcode::LoadOptions options;
    options.dialect = nc::Dialect::LinuxCnc;
    const auto result = gcode::interpret(
        "G0 X0 Y0 Z2\nF100\nG5.2 X7 Y10 P1\nG43 H1\nX0 Y10 P1\nX10 Y0 P1\nX20 Y1 P1\nG5.3\nM2\n",
        options);
    QVERIFY(result.trajectory.points.size() < 1000);
    QVERIFY(test::printProblems(result.diagnostics).find("arc-from-unknown-position") !=
            std::string::npos);
  }

  /// Every place of the curve lies within the tolerance of its chords.
  void splinesWithinTolerance() {
    QVERIFY(rc::check("spline flattening", [] {
      nc::Spline spline;
      spline.degree = *rc::gen::inRange(1, 4);
      const int count = *rc::gen::inRange(spline.degree + 1, 9);
      for (int i = 0; i < count; ++i) {
        spline.controlMm.push_back(point());
        spline.weights.push_back(*rc::gen::inRange(1, 40) / 10.0);
      }
      spline.knots = nc::clampedKnots(spline.controlMm.size(), spline.degree);
      const double toleranceMm = *rc::gen::inRange(1, 200) / 1000.0;
      std::vector<Vec3> chords{spline.controlMm.front()};
      nc::flattenSpline(spline, toleranceMm, chords);
      RC_ASSERT(chords.back() == spline.controlMm.back());
      const double last = spline.knots.back();
      for (int i = 0; i <= 400; ++i) {
        const Vec3 at = nc::splinePoint(spline, last * i / 400.0 * (1 - 1e-12));
        RC_ASSERT(distanceToPath(at, chords) <= toleranceMm + 1e-9);
      }
    }));
  }

  void splineOfWeightsIsACircle() {
    // A quarter circle as a rational quadratic: the weight of the corner is cos 45°.
    nc::Spline spline;
    spline.degree = 2;
    spline.controlMm = {{10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    spline.weights = {1.0, std::numbers::sqrt2 / 2.0, 1.0};
    spline.knots = nc::clampedKnots(3, 2);
    for (int i = 0; i <= 20; ++i) {
      QVERIFY(std::abs(base::norm(nc::splinePoint(spline, i / 20.0)) - 10.0) < 1e-12);
    }
    std::vector<Vec3> chords;
    const double lengthMm = nc::flattenSpline(spline, 1e-4, chords);
    QVERIFY(std::abs(lengthMm - 5.0 * std::numbers::pi) < 1e-3);
  }

  /// The circle through three points passes through them, and its chords stay near it.
  void arcsInSpace() {
    QVERIFY(rc::check("CIP", [] {
      const Vec3 a = point();
      const Vec3 b = point();
      const Vec3 c = point();
      const auto arc = nc::arcThrough(a, b, c);
      RC_PRE(arc.has_value());
      const double radiusMm = base::distance(a, arc->centreMm);
      RC_PRE(radiusMm < 1e4);
      RC_ASSERT(std::abs(base::distance(b, arc->centreMm) - radiusMm) < 1e-6 * radiusMm + 1e-6);
      RC_ASSERT(std::abs(base::distance(c, arc->centreMm) - radiusMm) < 1e-6 * radiusMm + 1e-6);
      std::vector<Vec3> chords{a};
      nc::flattenSpaceArc(*arc, a, c, 0.01, chords);
      RC_ASSERT(distanceToPath(b, chords) <= 0.0101);
      for (const Vec3& chord : chords) {
        RC_ASSERT(std::abs(base::distance(chord, arc->centreMm) - radiusMm) <
                  1e-6 * radiusMm + 1e-6);
      }
    }));
  }

  void tangentArcsLeaveStraight() {
    QVERIFY(rc::check("CT", [] {
      const Vec3 from = point();
      const Vec3 direction = point();
      const Vec3 to = point();
      const auto arc = nc::tangentArc(from, direction, to);
      RC_PRE(arc.has_value());
      const Vec3 radius = from - arc->centreMm;
      const double radiusMm = base::norm(radius);
      RC_PRE(radiusMm < 1e5);
      RC_ASSERT(std::abs(base::dot(radius, direction)) < 1e-6 * radiusMm * base::norm(direction));
      RC_ASSERT(base::dot(base::cross(arc->axis, radius), direction) > 0.0);
      RC_ASSERT(std::abs(base::distance(to, arc->centreMm) - radiusMm) < 1e-6 * radiusMm + 1e-6);
    }));
  }

  void splittingKeepsThePath() {
    QVERIFY(rc::check("splitting", [] {
      const gcode::Trajectory path = drawPath();
      const double lengthMm = *rc::gen::inRange(50, 500) / 1000.0;
      const gcode::Trajectory split = gcode::split(path, lengthMm).value();
      std::vector<Vec3> whole;
      for (const gcode::TrajectoryPoint& each : path.points) {
        whole.push_back(each.positionMm);
      }
      for (std::size_t i = 1; i < split.points.size(); ++i) {
        RC_ASSERT(base::distance(split.points[i - 1].positionMm, split.points[i].positionMm) <=
                  lengthMm * (1 + 1e-9));
        RC_ASSERT(distanceToPath(split.points[i].positionMm, whole) < 1e-9);
      }
      RC_ASSERT(split.points.back().positionMm == whole.back());
    }));
  }

  /// Where an axis is named first, nobody knows from where it turns: such a move is not divided,
  /// and those after it are.
  void openAxesAreNotDivided() {
    const auto path = [](const char* text) { return gcode::interpret(text, {}).trajectory; };
    const gcode::Trajectory turns = path("G1 X0 Y0 Z0 F600\nX100 A90\nX200 A0");
    QCOMPARE(gcode::split(turns, 10.0)->points.size(), std::size_t{1 + 1 + 10});
    gcode::Trajectory timed = turns;
    QVERIFY(gcode::divideLongMoves(timed, {1.0, 10.0, {}}));
    QCOMPARE(timed.points.size(), std::size_t{1 + 1 + 10});
    QCOMPARE(timed.rotary[6].degrees[0], 45.0);
    // Z is never named: it stays where it stands.
    QCOMPARE(gcode::split(path("G1 X0 Y0 F600\nX100"), 10.0)->points.size(), std::size_t{1 + 10});
    // A move that only turns has its feed in degrees.
    gcode::Trajectory turned = path("G1 X0 Y0 Z0 A0 F600\nA90");
    QVERIFY(gcode::divideLongMoves(turned, {1.0, 10.0, {}}));
    QCOMPARE(turned.points.size(), std::size_t{1 + 9});
  }

  /// What is printed and read again is the same path, to the last bit.
  void printedProgramsReadTheSame() {
    QVERIFY(rc::check("print then parse", [] {
      std::string text = "G0 X0 Y0 Z0\n";
      std::vector<Vec3> expected{{0, 0, 0}};
      const int count = *rc::gen::inRange(1, 30);
      for (int i = 0; i < count; ++i) {
        Vec3 to{*rc::gen::arbitrary<int>() / 1048576.0, coordinate(), coordinate() / 3.0};
        // NC text has no exponents.
        for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
          if (std::abs(to[axis]) < 1e-3) {
            to.set(axis, 0.0);
          }
        }
        expected.push_back(to);
        text += "G1 X" + base::formatNumber(to.x) + "Y" + base::formatNumber(to.y) +
                " Z=" + base::formatNumber(to.z) + " F600\n";
      }
      gcode::LoadOptions options;
      options.dialect = gcode::kDialects[static_cast<std::size_t>(*rc::gen::inRange(0, 4))];
      const auto result = gcode::interpret(text, options);
      RC_ASSERT(result.trajectory.points.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        RC_ASSERT(result.trajectory.points[i].positionMm == expected[i]);
      }
    }));
  }

  void keptArcs_data() {
    QTest::addColumn<QByteArray>("text");
    const auto add = [](const char* text) { QTest::newRow(text) << QByteArray(text); };
    add("G0 X0 Y10 Z0\nG2 X10 Y0 J-10 F60");
    add("G0 X0 Y10 Z0\nG3 X10 Y0 Z5 J-10 F60");
    add("G0 X10 Y0 Z0\nG18 G3 X0 Z10 I-10 F60");
    add("STOPRE\nG0 X10 Y0 Z8\nG3 X0 Y10 Z0 I-10 J0 TURN=2 F60");
    add("MIRROR X0\nSTOPRE\nG0 X0 Y10 Z0\nG2 X10 Y0 J-10 F60");
    add("ROT X30 Y20\nSTOPRE\nG0 X0 Y10 Z0\nG2 X10 Y0 J-10 F60");
    add("STOPRE\nG0 X0 Y0 Z0\nCIP X10 Y0 Z3 I1=5 J1=5 K1=0 F60");
  }

  /// An arc kept whole turns through the same points as its chords.
  void keptArcs() {
    QFETCH(const QByteArray, text);
    gcode::LoadOptions options;
    const auto chords = gcode::interpret(text.toStdString(), options);
    options.keepArcs = true;
    const auto kept = gcode::interpret(text.toStdString(), options);
    QCOMPARE(kept.trajectory.arcs.size(), std::size_t{1});
    const gcode::KeptArc& arc = kept.trajectory.arcs[0];
    QCOMPARE(arc.point, kept.trajectory.points.size() - 1);
    const Vec3 start = kept.trajectory.points[arc.point - 1].positionMm;
    const Vec3 end = kept.trajectory.points[arc.point].positionMm;
    const double rise = base::dot(end - start, arc.axis);
    const std::size_t first = arc.point;
    const auto& points = chords.trajectory.points;
    for (std::size_t i = first; i < points.size(); ++i) {
      const double share =
          static_cast<double>(i - first + 1) / static_cast<double>(points.size() - first);
      const Vec3 from = start - arc.centreMm;
      const Vec3 along = base::dot(from, arc.axis) * arc.axis;
      const Vec3 radius = from - along;
      const double angle = arc.sweepRad * share;
      const Vec3 at = arc.centreMm + along + std::cos(angle) * radius +
                      std::sin(angle) * base::cross(arc.axis, radius) + (rise * share) * arc.axis;
      QVERIFY2(base::distance(at, points[i].positionMm) < 1e-6,
               qPrintable(QString::number(base::distance(at, points[i].positionMm))));
    }
    QCOMPARE(kept.statistics.cutLengthMm, chords.statistics.cutLengthMm);
  }

  /// The tolerance holds where the tool goes, and lengths are those of its way.
  void scaledArcs() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Sinumerik;
    const auto big = gcode::interpret("SCALE X10 Y10 Z10\nG0 X10 Y0 Z0\nG3 X-10 I-10 F60", options);
    const auto& points = big.trajectory.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 middle = 0.5 * (points[i - 1].positionMm + points[i].positionMm);
      QVERIFY(100.0 - std::hypot(middle.x, middle.y) <= options.chordToleranceMm + 1e-9);
    }
    QVERIFY(std::abs(big.statistics.cutLengthMm - 100.0 * std::numbers::pi) < 1e-9);
    // Half an ellipse with half axes 20 and 10; its length after Ramanujan, exact to 1e-8 here.
    const auto ellipse = gcode::interpret("SCALE X2\nG0 X10 Y0 Z0\nG3 X-10 I-10 F60", options);
    const double h = (10.0 * 10.0) / (30.0 * 30.0);
    const double halfMm =
        0.5 * std::numbers::pi * 30.0 * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
    QVERIFY(std::abs(ellipse.statistics.cutLengthMm - halfMm) < 0.05);
    // Evenly long columns that are not at right angles make an ellipse of a circle, too.
    gcode::LoadOptions keeping;
    keeping.keepArcs = true;
    const char* const arc = "STOPRE\nG0 X10 Y0 Z0\nG3 X-10 I-10 F60";
    const auto turned = [&](const char* frame) {
      return gcode::interpret(std::string(frame) + arc, keeping).trajectory.arcs.size();
    };
    QCOMPARE(turned("ROT Z45\nASCALE X3 Y3 Z3\n"), std::size_t{1});
    QCOMPARE(turned("SCALE X3\nAROT Z45\n"), std::size_t{0});
    nc::Frame skewed;
    skewed.scale({3.0, 1.0, std::sqrt(5.0)});
    skewed.rotate(2, 45.0);
    QVERIFY(!skewed.keepsCircles());
    QVERIFY(skewed.stretchMax() >= 3.0);
    nc::Frame aligned;
    aligned.rotate(0, 30.0);
    aligned.scale({2.0, 0.5, -4.0});
    QVERIFY(std::abs(aligned.stretchMax() - 4.0) < 1e-12);
  }

  void eventsAreInOrder() {
    const auto result =
        gcode::interpret("T1 M6\nS500 M3\nG0 X1\nG4 F2\nG1 X2 F60\nM8\nT=\"DRILL\"\nM30", {});
    std::string text;
    for (const gcode::PathEvent& event : result.trajectory.events) {
      text += std::to_string(event.line.value) + ":" + std::to_string(event.point) + ":" +
              std::to_string(static_cast<int>(event.kind)) + "=" + base::formatNumber(event.value) +
              " ";
    }
    QCOMPARE(QByteArray::fromStdString(text),
             QByteArray("1:0:2=1 1:0:1=6 2:0:0=500 2:0:1=3 4:1:4=2 6:2:1=8 7:2:3=0 "));
    QCOMPARE(result.trajectory.toolNames, std::vector<std::string>{"DRILL"});
  }

  void rotaryAxesAndDirections() {
    const auto result = gcode::interpret(
        "TRAORI\nG0 X0 Y0 Z0\nG1 X1 A10 C=DC(90) F60\nG91 A5\nG90 X2 A3=0 B3=3 C3=4\n", {});
    const gcode::Trajectory& path = result.trajectory;
    QCOMPARE(path.rotary.size(), path.points.size());
    QCOMPARE(path.toolDirections.size(), path.points.size());
    QVERIFY(std::isnan(path.rotary[0].degrees[0]));
    QCOMPARE(path.rotary[1].degrees[0], 10.0);
    QCOMPARE(path.rotary[2].degrees[0], 15.0);
    QCOMPARE(path.rotary[3].degrees[2], 90.0);
    QCOMPARE(path.toolDirections[2], (Vec3{0, 0, 1}));
    QVERIFY(base::distance(path.toolDirections[3], {0, 0.6, 0.8}) < 1e-15);
  }

  void klartext() {
    gcode::LoadOptions options;
    options.chordToleranceMm = 1000.0;
    const auto result = gcode::interpret(
        "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X-1 Y-1 Z-1\n2 TOOL CALL 1 Z S900\n"
        "3 L X+0 Y+10 Z+0 R0 FMAX M3\n4 CC X+0 Y+0\n5 C X+10 Y+0 DR- F600\n"
        "6 L IX+5 Y-2.5 ;comment\n7 CR X+20 Y-2.5 R+2.5 DR+\n8 CP IPA+0.5 DR+\n9 END PGM A MM\n",
        options);
    QCOMPARE(QByteArray::fromStdString(test::printProblems(result.diagnostics)), QByteArray());
    QCOMPARE(result.trajectory.points.size(), std::size_t{6});
    const QByteArray points = QByteArray::fromStdString(test::printPoints(result.trajectory));
    QVERIFY2(points.startsWith("4 R X0 Y10 Z0 | 6 A X10 Y0 Z0 F600 | 7 L X15 Y-2.5 Z0 F600 | "
                               "8 A X17.5 Y-5 Z0 F600 | 8 A X20 Y-2.5 Z0 F600 | "),
             points.constData());
  }

  void latin1AndUtf8AreText() {
    const auto latin = gcode::interpret("(Fr\xE4sen)\nG21 G0 X1 ; \xFC\n", {});
    const auto utf = gcode::interpret("\xEF\xBB\xBF(Fr\xC3\xA4sen)\nG21 G0 X1\n", {});
    QVERIFY(latin.diagnostics.empty());
    QVERIFY(utf.diagnostics.empty());
    const auto binary = gcode::interpret(std::string("G0 X1\0\0\n", 8), {});
    QCOMPARE(binary.diagnostics.front().code, gcode::DiagnosticCode::NotAnyDialect);
  }
};

RIVULET_TEST(TestCurves)
#include "tst_curves.moc"
