// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "feasibility/access_model.h"
#include "feasibility/equations.h"
#include "feasibility/verdict.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::feasibility;
using base::Duration;
using base::MethodKind;
using std::chrono::microseconds;

namespace {

AccessModel measured(AccessLine read, AccessLine write) {
  AccessModel model;
  model.measured = MeasuredAccess{read, write};
  return model;
}

/// A program of steps of 1 mm.
ProgramDistances millimetres(int steps) {
  ProgramDistances distances;
  distances.pointDistanceMmMin = 1.0;
  distances.windowSteps = steps;
  distances.windowLengthMmMin = steps;
  return distances;
}

}  // namespace

class TestAccessModel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Each cell the same and nothing per request: what [P1] assumes comes out for every method.
  void thePaperIsTheSpecialCase() {
    const AccessLine line{Duration{}, microseconds{4300}};
    for (const MethodKind method : base::kMethodKinds) {
      for (const int points : {2, 7, 14, 33}) {
        const Duration t = measured(line, line).timePerNode({method, points});
        // Method credit looks at one cell more than the equation counts.
        const bool credit = method == MethodKind::Credit;
        QVERIFY(credit ? t > microseconds{4300} : t == microseconds{4300});
        QVERIFY(AccessModel{}.timePerNode({method, points}) == microseconds{4300});
      }
    }
  }

  /// The margin is that of the measured time of a turn, term by term.
  void theReachHasTheCostOfItsRequests() {
    const AccessLine read{microseconds{850}, microseconds{4300}};
    const AccessLine write{microseconds{1300}, microseconds{4000}};
    OperatingPoint point;
    point.method = MethodKind::Window;
    point.pointsPerLoop = 10;
    point.feedMmPerS = 20.0;
    const auto verdict = judge(point, millimetres(10), measured(read, write));
    QVERIFY(verdict);
    QVERIFY(verdict->accessMeasured);
    // 33 cells of a window, its number, a look: 1.3 + 33·4 + 1.3 + 4 + 0.85 + 4.3 ms.
    const double turnS = 0.14375;
    QVERIFY(std::abs(verdict->limiting.margin - 10.0 / (20.0 * turnS)) < 1e-4);
    QVERIFY(std::abs(verdict->feedMmPerSMax - 10.0 / turnS) < 1e-2);
    // Five axes: 53 cells of a window.
    point.cellsPerPoint = 5;
    const auto five = judge(point, millimetres(10), measured(read, write));
    QVERIFY(std::abs(five->feedMmPerSMax - 10.0 / (turnS + 20 * 0.004)) < 1e-2);
  }

  /// Arrays that cost as much as one cell: the time does not depend on N, the reach grows with it.
  void arraysReachFarther() {
    const AccessLine read{microseconds{5150}, Duration{}};
    const AccessLine write{microseconds{5600}, Duration{}};
    double last = 0.0;
    for (const int points : {2, 5, 10, 20, 32}) {
      OperatingPoint point;
      point.method = MethodKind::Window;
      point.pointsPerLoop = points;
      point.feedMmPerS = 1.0;
      const auto verdict = judge(point, millimetres(points), measured(read, write));
      QVERIFY(verdict);
      const double expected = points / 0.01635;  // two writes and a look
      QVERIFY(std::abs(verdict->feedMmPerSMax / expected - 1.0) < 1e-3);
      QVERIFY(verdict->feedMmPerSMax > last);
      last = verdict->feedMmPerSMax;
    }
  }

  void theMethodsOfThePaperPayTheirOverheads() {
    const AccessLine read{microseconds{800}, microseconds{4000}};
    const AccessLine write{microseconds{1400}, microseconds{4200}};
    const AccessModel model = measured(read, write);
    // Position: 0.8 + 12 + 1.4 + 12.6 ms for six cells.
    QVERIFY(model.timePerNode({MethodKind::Position, 7}) == Duration{microseconds{26800}} / 6);
    // Signal, N = 7: a look and nine cells.
    QVERIFY(model.timePerNode({MethodKind::Signal, 7}) ==
            Duration{microseconds{4800 + 1400 + 9 * 4200}} / 10);
    OperatingPoint point;
    point.method = MethodKind::Position;
    point.feedMmPerS = 10.0;
    const auto verdict = judge(point, millimetres(3), model);
    QVERIFY(verdict);
    QVERIFY(std::abs(verdict->conditions.front().margin - 1.0 / (10.0 * 0.0268)) < 1e-3);
  }

  void noLineIsBelowNothing() {
    const AccessLine line{Duration{}, Duration{}};
    QVERIFY(measured(line, line).timePerNode({MethodKind::Window, 7}) >= Duration{});
    QVERIFY(line.of(1) > Duration{});
    OperatingPoint point;
    point.method = MethodKind::Window;
    QVERIFY(judge(point, millimetres(7), measured(line, line)));
  }
};

RIVULET_TEST(TestAccessModel)
#include "tst_access_model.moc"
