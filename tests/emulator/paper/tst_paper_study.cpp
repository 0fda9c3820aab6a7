// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/executor.h"
#include "base/random.h"
#include "emulator/emulator_error.h"
#include "emulator/paper/study.h"
#include "staircase.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::emulator;
using namespace rivulet::emulator::paper;

namespace {

std::vector<Course> twoCourses() {
  Parameters truth = nominalParameters();
  truth[22] = 24.0;  // p23
  std::vector<Course> courses;
  for (const auto& [segments, mmPerS] : {std::pair{6, 6.0}, std::pair{8, 9.0}}) {
    const auto run =
        tests::observedOf(tests::staircase(segments, 6.0, mmPerS), truth, PlantSettings{});
    courses.push_back(*makeCourse(atChangesOfCourse(run), 0.001));
  }
  return courses;
}

LearnSettings quick() {
  LearnSettings settings;
  settings.genetic.populationSize = 20;
  settings.genetic.generations = 6;
  return settings;
}

}  // namespace

class TestPaperStudy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void testsEachEmulatorOnEachDesign() {
    base::SerialExecutor executor;
    const std::vector<Course> courses = twoCourses();
    std::vector<double> shares;
    const auto matrix = trainAndTest(courses, quick(), executor, [&](double share) {
      shares.push_back(share);
      return true;
    });
    QVERIFY(matrix);
    QCOMPARE(matrix->learned.size(), std::size_t{2});
    QCOMPARE(matrix->tests.size(), std::size_t{2});
    for (std::size_t design = 0; design < 2; ++design) {
      // On the diagonal is what learning reached.
      QCOMPARE(matrix->tests[design][design].objective(0.0), matrix->learned[design].objective());
      const auto learned = learn(courses[design], quick(), executor);
      QCOMPARE(matrix->learned[design].values, learned->values);
    }
    const Emulation across = emulate(courses[1], matrix->learned[0].values, PlantSettings{});
    QCOMPARE(matrix->tests[1][0].positionMm2(), misfitOf(courses[1], across).positionMm2());
    QVERIFY(std::ranges::is_sorted(shares));
    QCOMPARE(shares.size(), std::size_t{14});
    QCOMPARE(shares.back(), 1.0);
  }

  void stopsWhenToldTo() {
    base::SerialExecutor executor;
    const auto stopped =
        trainAndTest(twoCourses(), quick(), executor, [](double share) { return share < 0.2; });
    QVERIFY(!stopped);
    QVERIFY(stopped.error().code == EmulatorError::Cancelled);
  }

  void findsTheParameterThatDecides() {
    Learning learning;
    learning.design = "made";
    base::Random random(1);
    for (int i = 0; i < 400; ++i) {
      Trial trial;
      for (double& value : trial.values) {
        value = random.uniform();
      }
      const double off = parameter(trial.values, 23) - 0.3;
      trial.objective = 0.01 + off * off;
      if (parameter(trial.values, 5) > 0.9) {
        trial.objective = kDivergedObjective * 1.5;
      }
      learning.trials.push_back(trial);
    }
    const Importance importance = importanceOf(learning);
    QCOMPARE_GT(importance.share[22], 0.5);
    QCOMPARE_GT(importance.share[4], 0.1);
    QCOMPARE_GT(importance.explainedShare, 0.9);
    double sum = 0.0;
    for (const double share : importance.share) {
      sum += share;
    }
    QVERIFY(std::abs(sum - 1.0) < 1e-9);
  }

  void ranksOverDesigns() {
    std::vector<Importance> designs(3);
    designs[0].share[9] = 0.2;
    designs[1].share[9] = 0.6;
    designs[2].share[9] = 0.4;
    designs[1].share[2] = 0.3;
    const std::vector<ImportanceSpread> ranked = rankByImportance(designs);
    QCOMPARE(ranked.size(), kParameterCount);
    QCOMPARE(ranked[0].index, 10);
    QCOMPARE(ranked[0].median, 0.4);
    QVERIFY(std::abs(ranked[0].lowerQuartile - 0.3) < 1e-12);
    QCOMPARE(ranked[0].max, 0.6);
    QCOMPARE(ranked[1].index, 3);
    QCOMPARE(ranked[2].index, 1);
  }
};

RIVULET_TEST(TestPaperStudy)
#include "tst_paper_study.moc"
