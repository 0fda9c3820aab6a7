// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/executor.h"
#include "emulator/emulator_error.h"
#include "emulator/paper/learning.h"
#include "platform/thread_executor.h"
#include "staircase.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::emulator;
using namespace rivulet::emulator::paper;

namespace {

/// A machine that is an emulator with other parameters than the nominal ones.
Course trueCourse() {
  Parameters truth = nominalParameters();
  truth[22] = 24.0;  // p23
  truth[13] = 0.6;   // p14
  const auto run = tests::observedOf(tests::staircase(6, 6.0, 6.0), truth, PlantSettings{});
  return *makeCourse(atChangesOfCourse(run), 0.001);
}

LearnSettings quick() {
  LearnSettings settings;
  settings.genetic.populationSize = 20;
  settings.genetic.generations = 8;
  return settings;
}

bool same(const Learning& one, const Learning& other) {
  return one.values == other.values && one.bestEach == other.bestEach &&
         one.trials.size() == other.trials.size() && one.state.stepSize == other.state.stepSize &&
         one.state.population.back().genes == other.state.population.back().genes;
}

}  // namespace

class TestPaperLearning : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void improvesOnTheFirstPopulation() {
    LearnSettings settings = quick();
    settings.genetic.generations = 25;
    base::SerialExecutor executor;
    const Course course = trueCourse();
    const auto learned = learn(course, settings, executor);
    QVERIFY(learned);
    QCOMPARE_LT(learned->objective(), 0.7 * learned->bestEach.front());
    QCOMPARE(learned->bestEach.size(), std::size_t{26});
    QCOMPARE(learned->trials.size(), std::size_t{20 + 25 * 19});
    // What is reported is what the parameters give.
    const Emulation emulation = emulate(course, learned->values, settings.plant);
    QCOMPARE(misfitOf(course, emulation).objective(0.0), learned->objective());
  }

  void sameResultOnAnyNumberOfThreads() {
    base::SerialExecutor one;
    parallel::ThreadExecutor three(3);
    const Course course = trueCourse();
    const auto serial = learn(course, quick(), one);
    const auto threaded = learn(course, quick(), three);
    QVERIFY(serial && threaded);
    QVERIFY(same(*serial, *threaded));
  }

  void continuesASavedRun() {
    base::SerialExecutor executor;
    const Course course = trueCourse();
    const auto whole = learn(course, quick(), executor);
    const auto part = learn(course, quick(), executor,
                            [](const Learning& learning) { return learning.state.generation < 3; });
    QVERIFY(whole && part);
    QCOMPARE(part->state.generation, 3);
    const auto saved = parseLearning(learningText(*part));
    QVERIFY2(saved, saved ? "" : saved.error().text().c_str());
    const auto rest = learn(course, quick(), executor, {}, *saved);
    QVERIFY2(rest, rest ? "" : rest.error().text().c_str());
    QVERIFY(same(*rest, *whole));
  }

  void continuesOnlyWithTheSameDataAndSettings() {
    base::SerialExecutor executor;
    Course course = trueCourse();
    const auto part = learn(course, quick(), executor, [](const Learning&) { return false; });
    QVERIFY(part);
    LearnSettings otherSeed = quick();
    otherSeed.genetic.seed = 2;
    const auto refused = learn(course, otherSeed, executor, {}, *part);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == EmulatorError::BadFile);
    course.observedMm[kAxisX].back() += 0.001;
    QVERIFY(!learn(course, quick(), executor, {}, *part));
  }

  void refusesTextThatIsNoLearningRun_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("heading") << "# rivulet emulator learning 1"
                             << "# something else";
    QTest::newRow("no number") << "\n0,"
                               << "\n0,x";
    QTest::newRow("generation far off") << "\n0,"
                                        << "\n2000000000,";
    QTest::newRow("varied") << "varied = 1 2"
                            << "varied = 2 1";
    QTest::newRow("step") << "step = "
                          << "step = -";
  }
  void refusesTextThatIsNoLearningRun() {
    QFETCH(const QString, from);
    QFETCH(const QString, to);
    base::SerialExecutor executor;
    const auto part = learn(trueCourse(), quick(), executor, [](const Learning&) { return false; });
    QVERIFY(part);
    QString text = QString::fromStdString(learningText(*part));
    QVERIFY(parseLearning(text.toStdString()));
    text.replace(text.indexOf(from), from.size(), to);
    const auto parsed = parseLearning(text.toStdString());
    QVERIFY(!parsed);
    QVERIFY(parsed.error().code == EmulatorError::BadFile);
  }
  void refusesAnEmptyFile() { QVERIFY(!parseLearning("")); }

  void needsSpeedsWhereTheyCount() {
    Course course = trueCourse();
    course.observedMmPerS = {};
    LearnSettings settings = quick();
    base::SerialExecutor executor;
    settings.lambda = 0.8;
    const auto refused = learn(course, settings, executor);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == EmulatorError::BadNumbers);
    settings.lambda = 0.0;
    settings.genetic.generations = 1;
    QVERIFY(learn(course, settings, executor));
  }

  void saysIfNoCandidateIsStable() {
    LearnSettings settings = quick();
    settings.genetic.generations = 2;
    // κ7 far from what sampled feedback can hold.
    settings.plant.electronicsDecay = 5e3;
    base::SerialExecutor executor;
    const auto refused = learn(trueCourse(), settings, executor);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == EmulatorError::Diverged);
  }

  void refinesSomeParametersOnly() {
    base::SerialExecutor executor;
    const Course course = trueCourse();
    const auto learned = learn(course, quick(), executor);
    QVERIFY(learned);
    const auto refined = refine(course, quick(), executor, *learned, {23, 14});
    QVERIFY(refined);
    QCOMPARE(refined->varied, (std::vector<int>{14, 23}));
    QVERIFY(refined->objective() <= learned->objective());
    for (const ParameterInfo& info : parameterTable()) {
      if (info.index != 14 && info.index != 23) {
        QCOMPARE(parameter(refined->values, info.index), parameter(learned->values, info.index));
      }
    }
  }
};

RIVULET_TEST(TestPaperLearning)
#include "tst_paper_learning.moc"
