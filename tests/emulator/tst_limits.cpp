// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The limits of a planner, from its set points.

#include <QtTest>
#include <cmath>
#include <numbers>

#include "emulator/limits.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::emulator;

namespace {

/// X goes back and forth, with speeds up to `feeds` in turn; jerk 0: none is kept.
TrainingRun strokes(const std::vector<double>& feeds, double acceleration, double jerk,
                    double periodS) {
  constexpr double kFineS = 1e-5;
  TrainingRun run{"strokes", periodS, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
  double mm = 0.0;
  double speed = 0.0;
  double now = 0.0;  // acceleration
  double sinceS = periodS;
  const auto step = [&](double wanted) {
    const double change = jerk > 0.0 ? jerk * kFineS : 2.0 * acceleration;
    now += std::clamp(wanted - now, -change, change);
    mm += speed * kFineS;
    speed += now * kFineS;
    if ((sinceS += kFineS) >= periodS - 0.5 * kFineS) {
      run.axes[0].reference.push_back(mm);
      run.axes[1].reference.push_back(0.0);
      sinceS = 0.0;
    }
  };
  const auto rest = [&](double seconds) {
    for (int i = 0; i < seconds / kFineS; ++i) {
      step(0.0);
    }
  };
  rest(0.02);
  for (const double feed : feeds) {
    for (const double sign : {1.0, -1.0, -1.0, 1.0}) {
      // What the acceleration gives while it is brought back to 0 counts already.
      const double before = speed;
      const auto left = [&] { return std::abs(speed - before) + now * now / 2.0 / jerk; };
      while ((jerk > 0.0 ? left() : std::abs(speed - before)) < feed) {
        step(sign * acceleration);
      }
      rest(0.05);
    }
  }
  return run;
}

}  // namespace

class TestLimits : public QObject {
  Q_OBJECT
 private slots:
  void theAccelerationThatIsKeptIsFound_data() {
    QTest::addColumn<double>("periodS");
    QTest::newRow("1 kHz") << 0.001;
    QTest::newRow("250 Hz") << 0.004;
  }
  void theAccelerationThatIsKeptIsFound() {
    QFETCH(const double, periodS);
    const auto found = limitsSeen(std::vector{strokes({10.0, 25.0, 40.0}, 540.0, 0.0, periodS)});
    QCOMPARE(found.size(), std::size_t{1});  // Y does not move
    QCOMPARE(found[0].axis, 'X');
    const SeenLimit& acceleration = found[0].accelerationMmPerS2;
    QVERIFY(isReached(acceleration));
    QVERIFY2(std::abs(acceleration.value / 540.0 - 1.0) < 0.01,
             qPrintable(QString::number(acceleration.value)));
    QVERIFY(std::abs(found[0].speedMmPerS / 40.0 - 1.0) < 0.02);
    QVERIFY2(!found[0].showsJerk, "The acceleration jumps: no jerk can be seen.");
  }

  void aJerkThatIsKeptIsFound() {
    const auto found = limitsSeen(std::vector{strokes({60.0, 80.0, 100.0}, 800.0, 2e4, 0.004)});
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(isReached(found[0].accelerationMmPerS2));
    QVERIFY(std::abs(found[0].accelerationMmPerS2.value / 800.0 - 1.0) < 0.01);
    QVERIFY(found[0].showsJerk);
    QVERIFY(isReached(found[0].jerkMmPerS3));
    QVERIFY(std::abs(found[0].jerkMmPerS3.value / 2e4 - 1.0) < 0.02);
  }

  /// Speeds so small that the acceleration turns round before it has reached its limit.
  void whatIsNotReachedIsNoLimit() {
    const auto found = limitsSeen(std::vector{strokes({5.0, 8.0, 11.0}, 800.0, 2e4, 0.001)});
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(!isReached(found[0].accelerationMmPerS2));
    QVERIFY(found[0].accelerationMmPerS2.value < 500.0);
  }

  /// Twenty turns have forty largest accelerations of the same value, and none of them is a limit.
  void aCircleReachesNoLimit() {
    TrainingRun run{"circle", 0.004, {{'X', {}, {}}, {'Y', {}, {}}}, {}};
    constexpr double kRadiusMm = 10.0;
    constexpr double kTurnsPerS = 0.8;
    for (int i = 0; i < 6250; ++i) {
      const double turn = 2.0 * std::numbers::pi * kTurnsPerS * 0.004 * i;
      run.axes[0].reference.push_back(kRadiusMm * std::cos(turn));
      run.axes[1].reference.push_back(kRadiusMm * std::sin(turn));
    }
    const auto found = limitsSeen(std::vector{run});
    QCOMPARE(found.size(), std::size_t{2});
    for (const AxisLimits& axis : found) {
      QVERIFY(!isReached(axis.accelerationMmPerS2));
      QVERIFY(axis.showsJerk);
      QVERIFY(!isReached(axis.jerkMmPerS3));
    }
  }

  /// One larger value anywhere shows that the smaller ones were not the limit.
  void theLargestOfAllRunsCounts() {
    const TrainingRun slow = strokes({10.0, 20.0}, 300.0, 0.0, 0.004);
    const TrainingRun fast = strokes({10.0}, 540.0, 0.0, 0.004);
    const auto found = limitsSeen(std::vector{slow, fast});
    QVERIFY(std::abs(found[0].accelerationMmPerS2.value / 540.0 - 1.0) < 0.01);
    QCOMPARE(found[0].accelerationMmPerS2.places, 4);
    QVERIFY(!isReached(found[0].accelerationMmPerS2));
  }
};

RIVULET_TEST(TestLimits)
#include "tst_limits.moc"
