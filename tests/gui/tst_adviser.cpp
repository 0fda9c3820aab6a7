// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Advice that has been simulated, and verdicts on settings that are being turned, off the thread of
/// the window.

#include <QSignalSpy>
#include <QtTest>
#include <algorithm>

#include "base/units.h"
#include "gcode/program.h"
#include "session/adviser.h"
#include "support/test_program.h"

using namespace rivulet;
using AdvicePtr = std::shared_ptr<const std::vector<feasibility::Advice>>;

namespace {

constexpr int kSoonMs = 60000;

session::AdviceJob job(base::MethodKind method, double feedMmPerMin, double deltaMm) {
  const auto program = std::make_shared<gcode::Program>(
      *gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap"));
  session::AdviceJob job;
  job.view = widgets::makeProgramView(program, {}, 7);
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
    const session::AdviceJob asked = job(base::MethodKind::Position, 4000.0, 0.3);
    const std::atomic<bool> stop{false};
    const auto list = session::simulatedAdvice(asked, stop);
    QVERIFY(!list.empty());
    for (const feasibility::Advice& advice : list) {
      session::RehearsalJob rehearsal;
      rehearsal.points = asked.view->points.points;
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

  void onlyTheLastQuestionIsAnswered() {
    session::Adviser adviser;
    QSignalSpy advised(&adviser, &session::Adviser::advised);
    QSignalSpy turned(&adviser, &session::Adviser::turned);
    const session::AdviceJob asked = job(base::MethodKind::Signal, 200.0, 0.3);
    for (int n = 2; n <= 9; ++n) {
      feasibility::OperatingPoint point = asked.question.operatingPoint;
      point.pointsPerLoop = n;
      adviser.judge(asked.view, point, {});
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
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
    QCOMPARE(advised.count(), 1);
  }
};

RIVULET_TEST(TestAdviser)
#include "tst_adviser.moc"
