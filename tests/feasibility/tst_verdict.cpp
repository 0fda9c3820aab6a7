// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "feasibility/verdict.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::feasibility;
using base::MethodKind;

namespace {

/// d_min alone: no program is loaded.
ProgramDistances only(double pointDistanceMmMin) {
  ProgramDistances distances;
  distances.pointDistanceMmMin = pointDistanceMmMin;
  return distances;
}

/// A loaded program whose smallest distances lie at known places.
ProgramDistances loaded(double pointDistanceMmMin, int windowSteps, double windowLengthMmMin) {
  ProgramDistances distances;
  distances.pointDistanceMmMin = pointDistanceMmMin;
  distances.pointDistancePlace = {{4}, {40}, {41}};
  distances.windowSteps = windowSteps;
  distances.windowLengthMmMin = windowLengthMmMin;
  distances.windowPlace = {{7}, {70}, {73}};
  return distances;
}

OperatingPoint at(MethodKind method, double feedMmPerMin, double deltaMm = 0.3, int n = 7) {
  return {method, n, deltaMm, base::mmPerSFromMmPerMin(feedMmPerMin)};
}

constexpr SafetyFactors kAsPublished{1.0, 1.0, 1.0};

}  // namespace

class TestVerdict : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Method window never moves wrongly; the verdict says up to which feed nobody waits.
  void windowIsAlwaysFeasibleAndSaysItsReach() {
    // 3·7 + 5 accesses of 4.3 ms for 7 steps of 0.15 mm: 563.5 mm/min.
    const auto slow = judge(at(MethodKind::Window, 563), only(0.15));
    QVERIFY(slow->feasible && !slow->waits);
    QCOMPARE(slow->limiting.equation, Equation::Reach);
    QVERIFY(std::abs(base::mmPerMinFromMmPerS(slow->feedMmPerSMax) - 563.506) < 1e-2);
    const auto fast = judge(at(MethodKind::Window, 564), only(0.15));
    QVERIFY(fast->feasible && fast->waits);
    QVERIFY(judge(at(MethodKind::Window, 1e6), only(0.0))->feasible);
    // A loaded program: 7 steps are twice d_min^N of 3 steps and one single step.
    const auto program = judge(at(MethodKind::Window, 100), loaded(0.1, 3, 0.9));
    const double mmPerS = (2 * 0.9 + 0.1) / (26 * 0.0043);
    QVERIFY(std::abs(program->feedMmPerSMax - mmPerS) < 1e-9);
    // δ has no part in it.
    QVERIFY(judge(at(MethodKind::Window, 100, -1.0), only(1)).has_value());
  }

  /// A window of five axes: 5·7 cells, its count, feed, check and number, and one look at the
  /// control.
  void everyStreamedAxisIsWritten() {
    OperatingPoint point = at(MethodKind::Window, 60);
    point.cellsPerPoint = 5;
    const auto window = judge(point, only(1.0));
    QVERIFY(std::abs(window->feedMmPerSMax - 7.0 / (40 * 0.0043)) < 1e-9);
    point.cellsPerPoint = 2;
    QVERIFY(std::abs(judge(point, only(1.0))->feedMmPerSMax - 7.0 / (19 * 0.0043)) < 1e-9);
    // Methods of [P1] with fewer axes: the position is read of all three.
    point.method = MethodKind::Signal;
    QVERIFY(std::abs(judge(point, only(1.0))->feedMmPerSMax - 3.0 / (7 * 0.0043)) < 1e-9);
    point.method = MethodKind::Position;
    point.deltaMm = 100.0;
    QVERIFY(std::abs(judge(point, only(1.0))->feedMmPerSMax - 1.0 / (5 * 0.0043)) < 1e-9);
  }

  void initTestCase() {
    if (!qEnvironmentVariableIsSet("RC_PARAMS")) {
      qputenv("RC_PARAMS", "seed=20260101 max_success=500");
    }
  }

  void positionTakesTheLongerPollTime() {
    // Between the bounds of Δt, 0.1075 and 0.215 mm at F 500, the verdict is no.
    QVERIFY(!judge(at(MethodKind::Position, 500), only(0.15))->feasible);
    QVERIFY(!judge(at(MethodKind::Position, 500), only(0.2149))->feasible);
    QVERIFY(judge(at(MethodKind::Position, 500), only(0.2151))->feasible);
  }

  void positionNamesTheLimitingEquation() {
    const auto tooClose = judge(at(MethodKind::Position, 500, 1.0), loaded(0.1, 3, 0.4));
    QVERIFY(tooClose.has_value());
    QVERIFY(!tooClose->feasible);
    QCOMPARE(tooClose->limiting.equation, Equation::PointDistance);
    QCOMPARE(tooClose->limiting.place->firstLine.value, 40U);
    QCOMPARE(tooClose->conditions.size(), std::size_t{2});
    const auto deltaTooSmall = judge(at(MethodKind::Position, 500, 0.1), loaded(5.0, 3, 20.0));
    QVERIFY(!deltaTooSmall->feasible);
    QCOMPARE(deltaTooSmall->limiting.equation, Equation::Delta);
    QVERIFY(!deltaTooSmall->limiting.place.has_value());
    // 0.215 mm of way, factor 1.5, over 2.
    QVERIFY(std::abs(deltaTooSmall->deltaMmMin - 0.16125) < 1e-12);
    QVERIFY(judge(at(MethodKind::Position, 500, 0.1613), loaded(5.0, 3, 20.0))->feasible);
  }

  void signalIsDecidedByTheRealWindowOfALoadedProgram() {
    const auto verdict = judge(at(MethodKind::Signal, 600), loaded(0.001, 3, 0.5));
    QVERIFY(verdict->feasible);
    QCOMPARE(verdict->limiting.equation, Equation::RealWindow);
    QCOMPARE(verdict->limiting.place->firstLine.value, 70U);
    QCOMPARE(verdict->limiting.place->lastLine.value, 73U);
    QCOMPARE(verdict->conditions.size(), std::size_t{2});
    QCOMPARE(verdict->conditions[1].equation, Equation::Window);
    QVERIFY(!verdict->conditions[1].decides);
    QVERIFY(verdict->conditions[1].margin < 1.0);
    QCOMPARE(verdict->deltaMmMin, 0.0);
  }

  void signalIsDecidedByTheDistanceAloneWithoutAProgram() {
    const auto verdict = judge(at(MethodKind::Signal, 600), only(0.2));
    QVERIFY(verdict->feasible);
    QCOMPARE(verdict->limiting.equation, Equation::Window);
    QCOMPARE(verdict->conditions.size(), std::size_t{1});
    QVERIFY(!verdict->limiting.place.has_value());
    QVERIFY(!judge(at(MethodKind::Signal, 600), only(0.14))->feasible);
  }

  /// The case of [P1] VI.A, which ran thanks to the standstill: the verdict is on the safe side.
  void casesOfThePaperAreJudgedConservatively() {
    const auto verdict = judge(at(MethodKind::Signal, 600), loaded(0.001, 3, 0.1));
    QVERIFY(!verdict->feasible);
    QVERIFY(std::abs(verdict->feedMmPerSMax - 0.1 / 0.043) < 1e-9);
  }

  void theBorderItselfIsNotFeasible() {
    QVERIFY(!judge(at(MethodKind::Position, 500, 9.0), only(0.215))->feasible);
    QVERIFY(!judge(at(MethodKind::Position, 400, 0.129), only(9.0))->feasible);
    QVERIFY(!judge(at(MethodKind::Position, 400, 0.086), only(9.0), {}, kAsPublished)->feasible);
    QVERIFY(!judge(at(MethodKind::Signal, 600), loaded(0.1, 3, 0.43))->feasible);
    QVERIFY(!judge(at(MethodKind::Signal, 600), only(0.43 / 3.0))->feasible);
    QVERIFY(judge(at(MethodKind::Signal, 600), loaded(0.1, 3, 0.43 * (1 + 1e-9)))->feasible);
  }

  void nothingIsFeasibleWithoutDistance() {
    for (const MethodKind method : base::kPaperMethods) {
      const auto verdict = judge(at(method, 1), only(0.0));
      QVERIFY(!verdict->feasible);
      QCOMPARE(verdict->feedMmPerSMax, 0.0);
    }
  }

  /// Distances made for one N are still a safe bound for another.
  void anotherNNeverLooksBetterThanItIs() {
    const ProgramDistances distances = loaded(0.01, 3, 0.5);
    // Two steps: all that is known of them is 2·d_min.
    const auto fewer = judge(at(MethodKind::Signal, 600, 0.3, 5), distances);
    QVERIFY(std::abs(fewer->limiting.margin - 0.02 / (10.0 * 0.0043 * 7)) < 1e-12);
    // Seven steps: two windows of three and one step.
    const auto more = judge(at(MethodKind::Signal, 600, 0.3, 14), distances);
    QVERIFY(std::abs(more->limiting.margin - 1.01 / (10.0 * 0.0043 * 22)) < 1e-12);
  }

  void refusesWhatCannotBe() {
    const auto code = [](const base::Result<Verdict>& verdict) {
      return verdict ? std::error_code() : verdict.error().code;
    };
    for (const double feed : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(),
                              1e308, 1e-300, 1.01e6, 0.0009}) {
      QVERIFY(code(judge(at(MethodKind::Signal, feed), only(1))) ==
              FeasibilityError::FeedNotPositive);
    }
    for (const double delta : {0.0, -1.0, std::nan("")}) {
      QVERIFY(code(judge(at(MethodKind::Position, 100, delta), only(1))) ==
              FeasibilityError::DeltaNotPositive);
      QVERIFY(judge(at(MethodKind::Signal, 100, delta), only(1)).has_value());  // has no δ
    }
    for (const int n : {1, 0, -5}) {
      const auto verdict = judge(at(MethodKind::Signal, 100, 0.3, n), only(1));
      QVERIFY(code(verdict) == FeasibilityError::TooFewPointsPerLoop);
      QVERIFY(verdict.error().message.find("choose at least 2") != std::string::npos);
    }
    QCOMPARE(judge(at(MethodKind::Signal, -60), only(1)).error().message,
             std::string("The feed is -60 mm/min: choose one from 0.001 to 1000000."));
  }

  void largestFeedAndSmallestDeltaAreTheBorders() {
    QVERIFY(rc::check("just below is feasible, just above is not", [] {
      const auto share = [] { return *rc::gen::inRange(1, 1001) / 100.0; };
      const MethodKind method = *rc::gen::element(MethodKind::Position, MethodKind::Signal);
      const int n = *rc::gen::inRange(2, 60);
      OperatingPoint point{method, n, share(), share() * 10.0};
      const double distanceMm = share() / 10.0;
      const bool known = *rc::gen::arbitrary<bool>();
      const ProgramDistances distances =
          known ? loaded(distanceMm, n / 2, n / 2 * distanceMm * (1.0 + share()))
                : only(distanceMm);
      const AccessModel access{std::chrono::microseconds{*rc::gen::inRange(100, 20000)}};
      const SafetyFactors safety{1.0 + share() / 10.0, 1.0 + share() / 10.0, 1.0 + share() / 10.0};

      const auto verdict = judge(point, distances, access, safety);
      RC_ASSERT(verdict.has_value());
      RC_ASSERT(verdict->feasible == (verdict->limiting.margin > 1.0 + 1e-12));
      OperatingPoint other = point;
      other.feedMmPerS = 0.999 * verdict->feedMmPerSMax;
      RC_ASSERT(judge(other, distances, access, safety)->feasible);
      other.feedMmPerS = 1.001 * verdict->feedMmPerSMax;
      RC_ASSERT(!judge(other, distances, access, safety)->feasible);
      if (method == MethodKind::Position) {
        const auto holds = [&](double deltaMm) {
          other = point;
          other.deltaMm = deltaMm;
          const auto conditions = judge(other, distances, access, safety)->conditions;
          return conditions[1].equation == Equation::Delta && conditions[1].margin > 1.0;
        };
        RC_ASSERT(holds(1.001 * verdict->deltaMmMin));
        RC_ASSERT(!holds(0.999 * verdict->deltaMmMin));
      }
    }));
  }

  void labels() {
    QCOMPARE(equationLabel(Equation::PointDistance), std::string_view("(1)"));
    QCOMPARE(equationLabel(Equation::Delta), std::string_view("(2)"));
    QCOMPARE(equationLabel(Equation::Window), std::string_view("(3)"));
    QCOMPARE(equationLabel(Equation::RealWindow), std::string_view("(3) with d_min^N"));
  }
};

RIVULET_TEST(TestVerdict)
#include "tst_verdict.moc"
