// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/units.h"
#include "feasibility/sweep.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::feasibility;
using base::MethodKind;

namespace {

ProgramDistances loaded() {
  ProgramDistances distances;
  distances.pointDistanceMmMin = 0.2;
  distances.windowSteps = 3;
  distances.windowLengthMmMin = 0.9;
  return distances;
}

const Border& find(const std::vector<Border>& borders, Equation equation, bool withSafety) {
  for (const Border& border : borders) {
    if (border.equation == equation && border.withSafety == withSafety) {
      return border;
    }
  }
  qFatal("the border is missing");
}

}  // namespace

class TestSweep : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void positionOverTheDistance() {
    OperatingPoint point;
    point.method = MethodKind::Position;
    const auto borders = sweepBorders(point, loaded(), SweepAxis::PointDistance, {0.0, 0.43, 3});
    QCOMPARE(borders.size(), std::size_t{4});
    const Border& safe = find(borders, Equation::PointDistance, true);
    QCOMPARE(safe.points.size(), std::size_t{3});
    QCOMPARE(safe.points[0].abscissa, 0.0);
    QCOMPARE(safe.points[0].feedMmPerS, 0.0);
    QCOMPARE(safe.points[1].abscissa, 0.215);
    // [P1] (1): 0.215 mm and 25.8 ms give 500 mm/min, the shorter poll time twice as much.
    QVERIFY(std::abs(base::mmPerMinFromMmPerS(safe.points[1].feedMmPerS) - 500.0) < 1e-9);
    const Border& published = find(borders, Equation::PointDistance, false);
    QVERIFY(std::abs(base::mmPerMinFromMmPerS(published.points[1].feedMmPerS) - 1000.0) < 1e-9);
    // (2) does not depend on d_min; without its factor and with the shorter time it is thrice.
    const Border& delta = find(borders, Equation::Delta, true);
    QCOMPARE(delta.points[0].feedMmPerS, delta.points[2].feedMmPerS);
    QVERIFY(std::abs(find(borders, Equation::Delta, false).points[0].feedMmPerS -
                     3.0 * delta.points[0].feedMmPerS) < 1e-9);
  }

  void positionOverDelta() {
    OperatingPoint point;
    point.method = MethodKind::Position;
    const auto borders = sweepBorders(point, loaded(), SweepAxis::Delta, {0.1, 0.5, 5});
    const Border& delta = find(borders, Equation::Delta, true);
    for (const BorderPoint& at : delta.points) {
      QVERIFY(std::abs(at.feedMmPerS - 2.0 * at.abscissa / (1.5 * 0.0258)) < 1e-9);
    }
  }

  void signalOverN() {
    OperatingPoint point;
    point.method = MethodKind::Signal;
    const auto borders = sweepBorders(point, loaded(), SweepAxis::PointsPerLoop, {0.0, 20.0, 64});
    QCOMPARE(borders.size(), std::size_t{4});
    const Border& window = find(borders, Equation::Window, true);
    QCOMPARE(window.points.size(), std::size_t{19});  // 2 to 20, each once
    for (std::size_t i = 0; i < window.points.size(); ++i) {
      const int n = static_cast<int>(i) + 2;
      QCOMPARE(window.points[i].abscissa, static_cast<double>(n));
      const double half = n / 2;
      QVERIFY(std::abs(window.points[i].feedMmPerS - half * 0.2 / (0.0043 * (3.0 * half + 1.0))) <
              1e-9);
    }
    const Border& real = find(borders, Equation::RealWindow, true);
    QVERIFY(std::abs(real.points[5].feedMmPerS - 0.9 / 0.043) < 1e-9);  // N = 7: exact
    for (std::size_t i = 0; i < real.points.size(); ++i) {
      QVERIFY(real.points[i].feedMmPerS >= window.points[i].feedMmPerS - 1e-12);
    }
  }

  void signalWithoutAProgramHasNoRealWindow() {
    ProgramDistances distances;
    distances.pointDistanceMmMin = 0.2;
    const auto borders =
        sweepBorders({MethodKind::Signal}, distances, SweepAxis::PointDistance, {0.0, 1.0, 11});
    QCOMPARE(borders.size(), std::size_t{2});
    QCOMPARE(borders[0].equation, Equation::Window);
  }

  /// A border is where the verdict changes.
  void bordersAgreeWithTheVerdict() {
    for (const MethodKind method : base::kPaperMethods) {
      for (const SweepAxis axis :
           {SweepAxis::PointDistance, SweepAxis::PointsPerLoop, SweepAxis::Delta}) {
        OperatingPoint point;
        point.method = method;
        ProgramDistances distances;
        distances.pointDistanceMmMin = 0.2;
        const double scale = axis == SweepAxis::PointsPerLoop ? 20.0 : 1.0;
        const auto borders = sweepBorders(point, distances, axis, {0.1 * scale, scale, 10});
        for (std::size_t i = 0; i < borders.front().points.size(); ++i) {
          double lowest = INFINITY;
          for (const Border& border : borders) {
            if (border.withSafety) {
              lowest = std::min(lowest, border.points[i].feedMmPerS);
            }
          }
          OperatingPoint at = point;
          ProgramDistances with = distances;
          const double value = borders.front().points[i].abscissa;
          if (axis == SweepAxis::PointDistance) {
            with.pointDistanceMmMin = value;
          } else if (axis == SweepAxis::PointsPerLoop) {
            at.pointsPerLoop = static_cast<int>(value);
          } else {
            at.deltaMm = value;
          }
          at.feedMmPerS = 0.999 * lowest;
          QVERIFY(judge(at, with)->feasible);
          at.feedMmPerS = 1.001 * lowest;
          QVERIFY(!judge(at, with)->feasible);
        }
      }
    }
  }
};

RIVULET_TEST(TestSweep)
#include "tst_sweep.moc"
