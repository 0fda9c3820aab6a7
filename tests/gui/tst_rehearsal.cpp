// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The simulation before a start: the program itself, at the point where it is to run.

#include <QtTest>
#include <cmath>

#include "base/units.h"
#include "feasibility/verdict.h"
#include "gcode/program.h"
#include "session/rehearsal.h"
#include "support/test_program.h"

using namespace rivulet;
using session::RehearsalJob;
using session::RehearsalOutcome;

namespace {

RehearsalJob jobOf(base::MethodKind method, int points, double deltaMm, double feedMmPerMin) {
  const auto program = gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
  RehearsalJob job;
  job.points = std::make_shared<const std::vector<gcode::StreamPoint>>(
      gcode::streamPoints(program->trajectory, {}).points);
  job.settings.parameters.method = method;
  job.settings.parameters.pointsPerLoop = points;
  job.settings.deltaMm = deltaMm;
  job.settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return job;
}

RehearsalOutcome outcomeOf(const RehearsalJob& job) {
  std::atomic<bool> stop{false};
  return session::rehearse(job, stop);
}

}  // namespace

class TestRehearsal : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aGoodPointRuns() {
    for (const auto& [method, feed] : {std::pair(base::MethodKind::Window, 3000.0),
                                       std::pair(base::MethodKind::Signal, 3000.0)}) {
      const RehearsalOutcome outcome = outcomeOf(jobOf(method, 7, 0.3, feed));
      QVERIFY(!outcome.error.code);
      QVERIFY(outcome.isWhole && outcome.runs == 3 && !outcome.hasFailed());
    }
  }

  /// The points are closer than δ: the client takes points for passed that the tool has yet to
  /// reach. The equations hold.
  void aBadPointFailsThoughTheEquationsHold() {
    RehearsalJob job = jobOf(base::MethodKind::Position, 7, 0.3, 150.0);
    std::vector<gcode::StreamPoint> points;
    for (int i = 0; i < 200; ++i) {
      const double angle = 0.015 * i;
      gcode::StreamPoint point;
      point.positionMm = {10.0 * std::cos(angle), 10.0 * std::sin(angle), 0.0};
      points.push_back(point);
    }
    job.points = std::make_shared<const std::vector<gcode::StreamPoint>>(points);
    feasibility::OperatingPoint point;
    point.method = base::MethodKind::Position;
    point.pointsPerLoop = 7;
    point.deltaMm = job.settings.deltaMm;
    point.feedMmPerS = job.settings.feedMmPerS;
    const auto verdict =
        feasibility::judge(point, feasibility::programDistances(*job.points, 7), {});
    QVERIFY(verdict && verdict->feasible);
    const RehearsalOutcome outcome = outcomeOf(job);
    QVERIFY(outcome.verdict && !outcome.verdict->feasible);
    QCOMPARE(outcome.faulty, outcome.runs);
    QVERIFY(outcome.runs > 0);
    // Method window executes no point twice, whatever it costs.
    job.settings.parameters.method = base::MethodKind::Window;
    QVERIFY(!outcomeOf(job).hasFailed());
  }
};

RIVULET_TEST(TestRehearsal)
#include "tst_rehearsal.moc"
