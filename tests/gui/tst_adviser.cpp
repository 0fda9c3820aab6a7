// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Advice that has been simulated, and verdicts on settings that are being turned, off the thread
/// of the window.

#include <fmt/format.h>

#include <QSignalSpy>
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "gcode/program.h"
#include "report/operating_point.h"
#include "session/adviser.h"
#include "session/background.h"
#include "streaming/methods/feed_plan.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using AdvicePtr = std::shared_ptr<const std::vector<feasibility::Advice>>;

namespace {

using rivulet::tests::kSoonMs;

/// With the feeds of the program, of which one block is difficult.
session::AdviceJob jobWithProgramFeeds(double overrideFactor) {
  std::string text = "G0 X0 Y0 Z0\nG1 X1 F3000\n";
  for (int i = 1; i <= 120; ++i) {
    text += fmt::format("G1 X{:.2f} Y{}\n", 1.0 + 0.5 * i, i % 2);
  }
  text += "G1 X62 Y1 F300\nG0 Z50\n";
  const auto program = std::make_shared<gcode::Program>(*gcode::interpretProgram("feeds", text));
  const gcode::ProgramFeeds limits{1.0, base::mmPerSFromMmPerMin(40000.0),
                                   base::mmPerSFromMmPerMin(40000.0)};
  session::AdviceJob job;
  job.view = overview::makeProgramView(program, {}, 7, {}, limits);
  job.settings.parameters.method = base::MethodKind::Window;
  job.settings.programFeeds = limits;
  job.settings.programFeeds->overrideFactor = overrideFactor;
  job.settings.feedMmPerS = overrideFactor * job.view->fastestMmPerS;
  job.question.operatingPoint = report::operatingPointOf(job.settings);
  job.question.pointsPerLoopMax = 12;
  job.question.fullFeedMmPerS = job.view->fastestMmPerS;
  return job;
}

session::AdviceJob adviceJob(base::MethodKind method, double feedMmPerMin, double deltaMm) {
  const auto program = std::make_shared<gcode::Program>(
      *gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap"));
  session::AdviceJob job;
  job.view = overview::makeProgramView(program, {}, 7);
  job.settings.parameters.method = method;
  job.question.operatingPoint.method = method;
  job.question.operatingPoint.deltaMm = deltaMm;
  job.question.operatingPoint.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  job.question.pointsPerLoopMax = 9;
  job.question.methods = {base::MethodKind::Window, base::MethodKind::Signal};
  return job;
}

}  // namespace

class TestAdviser : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// What is advised runs: no feed that the simulation does not confirm.
  void adviceRunsInTheSimulation() {
    const session::AdviceJob asked = adviceJob(base::MethodKind::Position, 4000.0, 0.3);
    const std::atomic<bool> stop{false};
    const auto list = session::simulatedAdvice(asked, stop);
    QVERIFY(!list.empty());
    for (const feasibility::Advice& advice : list) {
      session::RehearsalJob rehearsal;
      rehearsal.points = {asked.view, &asked.view->points.points};
      rehearsal.settings = asked.settings;
      rehearsal.settings.parameters.method = advice.after.method;
      rehearsal.settings.parameters.pointsPerLoop = advice.after.pointsPerLoop;
      rehearsal.settings.deltaMm = advice.after.deltaMm;
      rehearsal.settings.feedMmPerS = advice.kind == feasibility::AdviceKind::Feed
                                          ? advice.after.feedMmPerS
                                          : advice.feedMmPerSMaxAfter;
      const auto outcome = session::rehearse(rehearsal, stop);
      QVERIFY2(outcome.runs > 0 && outcome.faulty == 0,
               qPrintable(QString::number(static_cast<int>(advice.kind))));
    }
  }

  /// With the feeds of the program, feeds are overrides on them: the same verdict as the settings
  /// get when the advice is taken, and never more than can be set.
  void adviceOnTheFeedsOfTheProgramIsAnOverride() {
    const session::AdviceJob asked = jobWithProgramFeeds(2.0);
    const double full = asked.question.fullFeedMmPerS;
    QCOMPARE(full, base::mmPerSFromMmPerMin(40000.0));
    const std::atomic<bool> stop{false};
    const auto list = session::simulatedAdvice(asked, stop);
    QVERIFY(!list.empty());
    bool hasPoints = false;
    for (const feasibility::Advice& advice : list) {
      QVERIFY(advice.feedMmPerSMaxAfter <= gcode::kOverrideMax * full * (1.0 + 1e-9));
      QVERIFY(advice.after.method == base::MethodKind::Window);
      if (advice.kind == feasibility::AdviceKind::Feed) {
        const double percent = 100.0 * advice.after.feedMmPerS / full;
        QVERIFY2(std::abs(percent - std::round(percent)) < 1e-6,
                 qPrintable(QString::number(percent)));
      }
      if (advice.kind == feasibility::AdviceKind::PointsPerLoop) {
        hasPoints = true;
        streaming::RunSettings then = asked.settings;
        then.parameters.pointsPerLoop = advice.after.pointsPerLoop;
        streaming::planFeeds(then, asked.view->points.points, {});
        then.feedMmPerS = 2.0 * full;
        const auto verdict =
            feasibility::judge(report::operatingPointOf(then),
                               feasibility::programDistances(asked.view->points.points,
                                                             then.parameters.pointsPerLoop, full));
        QVERIFY(verdict.has_value());
        QVERIFY(advice.feedMmPerSMaxAfter <= verdict->feedMmPerSMax * (1.0 + 1e-9));
        QVERIFY(advice.feedMmPerSMaxAfter > advice.feedMmPerSMaxBefore);
      }
    }
    QVERIFY(hasPoints);
  }

  void onlyTheLastQuestionIsAnswered() {
    session::Adviser adviser;
    QSignalSpy advised(&adviser, &session::Adviser::advised);
    QSignalSpy turned(&adviser, &session::Adviser::turned);
    const session::AdviceJob asked = adviceJob(base::MethodKind::Signal, 200.0, 0.3);
    for (int n = 2; n <= 9; ++n) {
      session::AdviceJob turn = asked;
      turn.question.operatingPoint.pointsPerLoop = n;
      adviser.judge(std::move(turn));
    }
    adviser.advise(asked);
    adviser.advise(asked);
    QVERIFY(advised.wait(kSoonMs));
    QTRY_VERIFY_WITH_TIMEOUT(!turned.isEmpty(), kSoonMs);
    QCOMPARE(advised.count(), 1);
    QCOMPARE(turned.count(), 1);
    const auto verdict = turned[0][0].value<session::TurnedVerdict>();
    QCOMPARE(verdict.point.pointsPerLoop, 9);
    QVERIFY(verdict.verdict.has_value());
    adviser.advise(asked);
    adviser.cancel();
    session::awaitPool();
    QCoreApplication::processEvents();
    QCOMPARE(advised.count(), 1);
  }
};

RIVULET_TEST(TestAdviser)
#include "tst_adviser.moc"
