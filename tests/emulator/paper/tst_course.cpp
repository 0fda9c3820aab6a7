// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "emulator/emulator_error.h"
#include "emulator/paper/course.h"
#include "emulator/paper/emulation.h"
#include "staircase.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using namespace rivulet::emulator::paper;
using rivulet::tests::observedOf;
using rivulet::tests::staircase;

namespace {

EmulatorError errorOf(const TrainingRun& run) {
  const auto course = makeCourse(run, 0.001);
  return course ? EmulatorError{} : static_cast<EmulatorError>(course.error().code.value());
}

}  // namespace

class TestCourse : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void samplesAtChangesOfCourseOnly() {
    // Corners each 2 s, seen with 100 Hz.
    const TrainingRun run =
        observedOf(staircase(4, 12.0, 6.0, 0.01), nominalParameters(), PlantSettings{});
    const TrainingRun kept = atChangesOfCourse(run);
    QCOMPARE(kept.observedAt.front(), 0.0);
    QVERIFY(kept.observedAt.size() > 10);
    QVERIFY(kept.observedAt.size() < 30);
    for (std::size_t i = 1; i < kept.observedAt.size(); ++i) {
      QVERIFY(kept.observedAt[i] - kept.observedAt[i - 1] > 0.0999);
      const double afterCorner = std::fmod(kept.observedAt[i] + 0.15, 2.0);
      QVERIFY2(afterCorner < 0.8 || i + 1 == kept.observedAt.size(),
               qPrintable(QString::number(kept.observedAt[i])));
    }
    QCOMPARE(kept.axes[0].observed.size(), kept.observedAt.size());
    QCOMPARE(kept.axes[1].observedMmPerS.size(), kept.observedAt.size());
    QCOMPARE(kept.axes[0].reference, run.axes[0].reference);
  }

  void takesSpeedFromPositionsWhereNoneWasSeen() {
    TrainingRun run =
        observedOf(staircase(4, 12.0, 6.0, 0.1), nominalParameters(), PlantSettings{});
    run.axes[0].observedMmPerS.clear();
    run.axes[1].observedMmPerS.clear();
    const TrainingRun kept = atChangesOfCourse(run);
    QVERIFY(kept.observedAt.size() > 10);
    QVERIFY(kept.observedAt.size() < 35);
    QVERIFY(kept.axes[0].observedMmPerS.empty());
  }

  void setPointsInStepsOfTheModel() {
    TrainingRun run = staircase(2, 12.0, 6.0);
    run.period = 0.004;  // the same set points, four times as slow
    const auto course = makeCourse(run, 0.001);
    QVERIFY(course);
    QCOMPARE(course->referenceMm[kAxisX].size(), 4 * (run.axes[0].reference.size() - 1) + 1);
    QCOMPARE(course->referenceMm[kAxisX][400], run.axes[0].reference[100]);
    QCOMPARE(course->referenceMm[kAxisX][402],
             0.5 * (run.axes[0].reference[100] + run.axes[0].reference[101]));
  }

  void leavesTheFirstTwoSecondsOut() {
    TrainingRun run = staircase(4, 12.0, 6.0);
    auto course = makeCourse(run, 0.001);
    QVERIFY(course);
    const Emulation emulation = emulate(*course, nominalParameters(), {});
    course->observedMm = emulation.mm;
    course->observedMmPerS = emulation.mmPerS;
    for (std::size_t i = 0; i < course->points.size(); ++i) {
      if (course->points[i].atS < 2.0 - 1e-9) {
        course->observedMm[kAxisX][i] += 100.0;
      }
    }
    QCOMPARE(misfitOf(*course, emulation).objective(0.8), 0.0);
    course->observedMm[kAxisY][25] += 3.0;
    const auto counted = static_cast<double>(course->points.size() - course->firstScored);
    QCOMPARE(misfitOf(*course, emulation).objective(0.0), 9.0 / counted);
  }

  void weighsSpeedsWithLambda() {
    Misfit misfit;
    misfit.mm2 = {1.0, 2.0};
    misfit.mm2PerS2 = {10.0, 20.0};
    QCOMPARE(misfit.objective(0.0), 3.0);
    QCOMPARE(misfit.objective(0.8), 27.0);
  }

  void aCandidateThatRunsAwayIsWorseThanAnyOther() {
    const auto course = makeCourse(staircase(4, 12.0, 6.0), 0.001);
    QVERIFY(course);
    Parameters values = nominalParameters();
    values[22] = 1e4;  // p23: a gain that no such loop can have
    const Emulation emulation = emulate(*course, values, {});
    QVERIFY(emulation.diverged());
    QVERIFY(misfitOf(*course, emulation).objective(0.0) > kDivergedObjective);
    Misfit sooner;
    sooner.stableShare = 0.1;
    Misfit later;
    later.stableShare = 0.5;
    QVERIFY(sooner.objective(0.0) > later.objective(0.0));
  }

  void givesANumberForAnyParameters() {
    const auto course = makeCourse(staircase(4, 12.0, 6.0), 0.001);
    QVERIFY(course);
    for (const double huge : {1e30, 1e200}) {
      Parameters values = nominalParameters();
      values[0] = huge;
      values[24] = huge;
      QVERIFY(std::isfinite(misfitOf(*course, emulate(*course, values, {})).objective(0.8)));
    }
  }

  void refusesRunsItCannotLearnFrom() {
    const TrainingRun sound = staircase(4, 12.0, 6.0);
    QCOMPARE(errorOf(sound), EmulatorError{});
    TrainingRun oneAxis = sound;
    oneAxis.axes.pop_back();
    QVERIFY(errorOf(oneAxis) == EmulatorError::NoMotion);
    TrainingRun standing = sound;
    std::ranges::fill(standing.axes[0].reference, 3.0);
    QVERIFY(errorOf(standing) == EmulatorError::NoMotion);
    TrainingRun brief = staircase(1, 6.0, 6.0);
    brief.axes[1].reference = brief.axes[0].reference;
    QVERIFY(errorOf(brief) == EmulatorError::TooShort);
    TrainingRun wrong = sound;
    wrong.axes[1].observed[7] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(errorOf(wrong) == EmulatorError::BadNumbers);
  }
};

RIVULET_TEST(TestCourse)
#include "tst_course.moc"
