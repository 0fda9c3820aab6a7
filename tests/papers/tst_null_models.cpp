// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Models that have learned nothing, and the machine that they fail.

#include <QtTest>
#include <cmath>
#include <map>

#include "base/executor.h"
#include "emulator/paper/staircase.h"
#include "papers/null_models.h"
#include "support/test_program.h"

using namespace rivulet;
using emulator::paper::Course;
using emulator::paper::Misfit;

namespace {

double rootMm(const Misfit& misfit) {
  return std::sqrt(misfit.positionMm2());
}

double rootMm(const Course& course, const emulator::paper::Parameters& values) {
  return rootMm(emulator::paper::misfitOf(course, emulator::paper::emulate(course, values, {})));
}

Course courseOf(const emulator::TrainingRun& run) {
  return *emulator::paper::makeCourse(emulator::paper::atChangesOfCourse(run), 0.001);
}

}  // namespace

class TestNullModels : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void setPointsAreFarOffByWhatTheMachineIs() {
    emulator::TrainingRun run = tests::staircase(6, 12.0, 6.0);
    for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
      const auto at = std::min(static_cast<std::size_t>(std::lround(run.observedAt[i] * 1000.0)),
                               run.axes[0].reference.size() - 1);
      run.axes[0].observed[i] = run.axes[0].reference[at] + 0.3;
      run.axes[1].observed[i] = run.axes[1].reference[at] - 0.4;
    }
    const auto course = emulator::paper::makeCourse(run, 0.001);
    QVERIFY(course.has_value());
    QVERIFY(std::abs(rootMm(papers::setPointMisfit(*course)) - 0.5) < 0.01);
  }

  /// On a steady ramp the lag is known: gain, friction and late position, each by hand.
  void theMachineLagsAsItsEquationsSay() {
    const papers::LaggingAxis axis;
    const double mmPerS = 6.0;
    emulator::TrainingRun run = tests::staircase(1, 60.0, mmPerS);  // X only
    run = papers::observedOfMachine(run, {axis, axis});
    const double lagMm = (mmPerS + axis.frictionMmPerS2 * axis.speedLagS) / axis.positionGainPerS -
                         mmPerS * axis.positionDelayS;
    const std::size_t late = 90;  // 9 s: settled
    QVERIFY(std::abs(mmPerS * run.observedAt[late] - run.axes[0].observed[late] - lagMm) < 0.01);
    QVERIFY(std::abs(run.axes[0].observedMmPerS[late] - mmPerS) < 0.05);
    QCOMPARE(run.axes[1].observed[late], 0.0);  // friction holds what is not moved
  }

  /// The check of the page (at most a fifth of the better null model's error), on learning and on
  /// methods that have not learned or learned something else.
  void onlyLearningPassesOnTheMachineWithLag() {
    const papers::LaggingAxis x;
    papers::LaggingAxis y;
    y.resonanceHz = 4.0;
    const emulator::TrainingRun run =
        papers::observedOfMachine(tests::staircase(12, 12.0, 6.0), {x, y});
    const Course course = courseOf(run);
    emulator::paper::LearnSettings settings;
    settings.genetic.generations = 40;
    base::SerialExecutor executor;
    const auto learned = emulator::paper::learn(course, settings, executor);
    QVERIFY(learned.has_value());
    // The same machine, seen half a second late.
    emulator::TrainingRun shifted = run;
    for (double& at : shifted.observedAt) {
      at += 0.5;
    }
    const auto ofShifted = emulator::paper::learn(courseOf(shifted), settings, executor);
    QVERIFY(ofShifted.has_value());
    const double nullMm = std::min(rootMm(papers::setPointMisfit(course)),
                                   rootMm(papers::nominalMisfit(course, settings.plant)));
    const std::map<std::string, double> wrong{
        {"position = set point", rootMm(papers::setPointMisfit(course))},
        {"nominal parameters", rootMm(papers::nominalMisfit(course, settings.plant))},
        {"one generation", rootMm(course, papers::afterOneGeneration(*learned))},
        {"a clock half a second late", rootMm(course, ofShifted->values)},
    };
    constexpr double kLearnedShare = 0.2;
    for (const auto& [method, mm] : wrong) {
      qInfo("%s: %.3f mm, %.2f of the better null model", method.c_str(), mm, mm / nullMm);
      QVERIFY2(mm > kLearnedShare * nullMm, method.c_str());
    }
    const double learnedMm = rootMm(course, learned->values);
    qInfo("learned: %.3f mm, %.2f of the better null model", learnedMm, learnedMm / nullMm);
    QVERIFY(learnedMm <= kLearnedShare * nullMm);
  }
};

RIVULET_TEST(TestNullModels)
#include "tst_null_models.moc"
