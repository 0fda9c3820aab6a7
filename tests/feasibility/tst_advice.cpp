// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What is advised holds what it promises, and what would not help is not advised.

#include <QtTest>
#include <algorithm>

#include "base/units.h"
#include "feasibility/advice.h"
#include "support/test_program.h"

using namespace rivulet;
using feasibility::Advice;
using feasibility::AdviceKind;
using feasibility::AdviceQuestion;

namespace {

/// Even steps, with one short step in the middle.
std::vector<gcode::StreamPoint> path(double stepMm, double shortMm) {
  std::vector<gcode::StreamPoint> points;
  double x = 0.0;
  for (int i = 0; i < 200; ++i) {
    x += i == 100 ? shortMm : stepMm;
    points.push_back({{x, 0.0, 0.0},
                      base::LineNumber{static_cast<std::uint32_t>(i + 1)},
                      gcode::MoveKind::Feed,
                      {}});
  }
  return points;
}

AdviceQuestion ask(base::MethodKind method, double feedMmPerMin, int most = 20) {
  AdviceQuestion question;
  question.operatingPoint.method = method;
  question.operatingPoint.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  question.pointsPerLoopMax = most;
  return question;
}

const Advice* find(const std::vector<Advice>& list, AdviceKind kind) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Advice& one) { return one.kind == kind; });
  return found == list.end() ? nullptr : &*found;
}

/// The verdict of the point advised, computed again.
feasibility::Verdict judged(const std::vector<gcode::StreamPoint>& points,
                            const feasibility::OperatingPoint& point) {
  return *feasibility::judge(point, feasibility::programDistances(points, point.pointsPerLoop));
}

}  // namespace

class TestAdvice : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyAdviceHoldsItsPromise() {
    const auto points = path(0.8, 0.3);
    for (const base::MethodKind method :
         {base::MethodKind::Position, base::MethodKind::Signal, base::MethodKind::Window}) {
      for (const double feed : {50.0, 500.0, 5000.0}) {
        AdviceQuestion question = ask(method, feed);
        question.operatingPoint.deltaMm = 0.02;
        question.methods = {base::MethodKind::Window, base::MethodKind::Signal};
        const auto list = feasibility::advise(points, question);
        for (const Advice& advice : list) {
          const feasibility::Verdict after = judged(points, advice.after);
          QCOMPARE(after.feedMmPerSMax, advice.feedMmPerSMaxAfter);
          QCOMPARE(judged(points, advice.before).feedMmPerSMax, advice.feedMmPerSMaxBefore);
          if (advice.kind == AdviceKind::Feed) {
            QVERIFY(after.feasible && !after.waits);
          } else {
            QVERIFY(advice.gain() >= 1.05);
          }
        }
      }
    }
  }

  void theGreatestGainComesFirst() {
    AdviceQuestion question = ask(base::MethodKind::Signal, 100.0);
    question.operatingPoint.pointsPerLoop = 3;
    question.methods = {base::MethodKind::Window, base::MethodKind::Position};
    const auto list = feasibility::advise(path(0.8, 0.3), question);
    QVERIFY(list.size() >= 2);
    QVERIFY(std::is_sorted(list.begin(), list.end(),
                           [](const Advice& a, const Advice& b) { return a.gain() > b.gain(); }));
  }

  /// More points per loop let more path pass between two writes, as far as they fit.
  void takesAsManyPointsAsHelp() {
    const auto points = path(0.8, 0.3);
    AdviceQuestion question = ask(base::MethodKind::Signal, 100.0, 9);
    question.operatingPoint.pointsPerLoop = 3;
    const auto list = feasibility::advise(points, question);
    const Advice* advice = find(list, AdviceKind::PointsPerLoop);
    QVERIFY(advice != nullptr);
    QVERIFY(advice->after.pointsPerLoop > 3 && advice->after.pointsPerLoop <= 9);
    for (int n = 2; n <= 9; ++n) {
      feasibility::OperatingPoint other = question.operatingPoint;
      other.pointsPerLoop = n;
      QVERIFY(judged(points, other).feedMmPerSMax <= advice->feedMmPerSMaxAfter * (1.0 + 1e-9));
    }
    question.pointsPerLoopMax = 0;
    QVERIFY(find(feasibility::advise(points, question), AdviceKind::PointsPerLoop) == nullptr);
  }

  void aFeedTooHighIsLoweredFirst() {
    const auto points = path(0.8, 0.3);
    AdviceQuestion question = ask(base::MethodKind::Position, 20000.0);
    question.operatingPoint.deltaMm = 0.02;
    question.methods = {base::MethodKind::Window};
    const auto list = feasibility::advise(points, question);
    QVERIFY(list.size() >= 2);
    QVERIFY(list.front().kind == AdviceKind::Feed);
    QVERIFY(list.front().gain() < 1.0);
    // As an operator types it: whole mm/min.
    const double feed = base::mmPerMinFromMmPerS(list.front().after.feedMmPerS);
    QVERIFY(qAbs(feed - qRound(feed)) < 1e-9);
  }

  /// A larger δ only as far as it helps, and never so that two points are within it at once.
  void deltaStaysBelowHalfTheSmallestDistance() {
    const auto points = path(0.8, 0.3);
    AdviceQuestion question = ask(base::MethodKind::Position, 20.0);
    question.operatingPoint.deltaMm = 0.02;
    const auto list = feasibility::advise(points, question);
    const Advice* advice = find(list, AdviceKind::Delta);
    QVERIFY(advice != nullptr);
    QVERIFY(advice->after.deltaMm > 0.02);
    QVERIFY(advice->after.deltaMm <= 0.15 + 1e-9);
    question.operatingPoint.deltaMm = 0.15;
    QVERIFY(find(feasibility::advise(points, question), AdviceKind::Delta) == nullptr);
    question = ask(base::MethodKind::Signal, 20.0);
    QVERIFY(find(feasibility::advise(points, question), AdviceKind::Delta) == nullptr);
  }

  void canBeGivenUp() {
    int asked = 0;
    const auto list = feasibility::advise(path(0.8, 0.3), ask(base::MethodKind::Signal, 20.0),
                                          [&asked] { return ++asked < 3; });
    QVERIFY(list.empty());
    QVERIFY(asked < 10);
  }

  void nothingIsKnownOfMethodFile() {
    QVERIFY(feasibility::advise(path(0.8, 0.3), ask(base::MethodKind::File, 500.0)).empty());
  }
};

RIVULET_TEST(TestAdvice)
#include "tst_advice.moc"
