// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Positions ten times a second and their program: what is learned from them, and when they are
// refused.

#include <QtTest>

#include "base/random.h"
#include "emulator/emulator_error.h"
#include "emulator/identification.h"
#include "support/test_program.h"
#include "training/sparse_learning.h"

using namespace rivulet;
using namespace rivulet::training;
using P = emulator::AxisParameter;

namespace {

constexpr double kXGain = 40.0;
constexpr double kYGain = 30.0;
constexpr double kYDelayS = 0.004;

/// A staircase with different feeds, and back.
std::string program() {
  std::string text = "G61\nG90 G17\n";
  double x = 0.0;
  double y = 0.0;
  for (int step = 0; step < 24; ++step) {
    const int feed = 300 + 60 * (step * 7 % 24);
    (step % 2 == 0 ? x : y) += (step < 12 ? 5.0 : -5.0) + 0.3 * (step % 3);
    text +=
        "F" + std::to_string(feed) + "\nG1 X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  return text;
}

emulator::Emulator knownMachine() {
  emulator::Emulator known;
  for (const char letter : {'X', 'Y'}) {
    emulator::LearnedAxis axis;
    axis.axis = letter;
    axis.parameters = emulator::firstOrderLag(1.0 / (letter == 'X' ? kXGain : kYGain));
    axis.parameters[P::CoulombSpeed] = 1.0;
    axis.parameters[P::Delay] = letter == 'Y' ? kYDelayS : 0.0;
    known.axes.push_back(axis);
  }
  return known;
}

/// What a client sees of the machine: every 0.1 s, nearly, on a clock that is off by `clockS`.
trace::Motion seen(const TrapezoidRules& rules, double clockS) {
  trace::Motion nothing;
  nothing.hasActual = true;
  std::vector<trace::MotionSample> two(2);
  two[1].at = two[0].at + base::fromSeconds(0.1);
  nothing.samples = trace::MotionSamples(two);
  auto run = runOfProgram(nothing, program(), "planned", rules);
  if (!run) {
    qFatal("%s", run.error().text().c_str());
  }
  base::Random random(5);
  std::vector<double> atS;
  const double endS = run->period * static_cast<double>(run->axes[0].reference.size()) - 0.1;
  for (double at = 0.3; at < endS; at += 0.1 + 0.01 * random.normal()) {
    atS.push_back(at);
  }
  trace::Motion motion;
  motion.hasActual = true;
  std::vector<trace::MotionSample> samples(atS.size());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto states =
        emulator::predict(knownMachine().axes[axis].parameters,
                          emulator::setPointGrid(run->axes[axis], run->period, false), atS);
    for (std::size_t i = 0; i < atS.size(); ++i) {
      samples[i].actualMm.set(axis, states[i].mm);
      samples[i].at = base::Instant{base::fromSeconds(atS[i] + clockS)};
    }
  }
  motion.samples = trace::MotionSamples(samples);
  return motion;
}

emulator::TrainingRun runOf(const trace::Motion& motion, const TrapezoidRules& rules) {
  auto run = runOfProgram(motion, program(), "stairs", rules);
  if (!run) {
    qFatal("%s", run.error().text().c_str());
  }
  return std::move(*run);
}

TrapezoidRules scaled(double factor) {
  TrapezoidRules rules;
  for (double& limit : rules.accelerationMmPerS2) {
    limit *= factor;
  }
  return rules;
}

}  // namespace

class TestSparseLearning : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aClockThatKeepsItsShiftIsSteady() {
    emulator::TrainingRun run = runOf(seen({}, 0.17), {});
    alignClock(run, knownMachine());
    const auto steady = requireSteadyClock(run, knownMachine());
    QVERIFY2(steady, steady ? "" : steady.error().text().c_str());
  }

  /// Times that a client notes are not those at which the control has read the positions.
  void theJitterOfSamplesIsEstimated() {
    trace::Motion motion = seen({}, 0.17);
    emulator::TrainingRun exact = runOf(motion, {});
    alignClock(exact, knownMachine());
    const auto none = sampleJitterS(exact, knownMachine());
    QVERIFY(none && *none < 2e-4);
    constexpr double kJitterS = 0.004;
    base::Random random(7);
    trace::MotionSamples jittered;
    for (trace::MotionSample sample : motion.samples) {
      sample.at += base::fromSeconds(kJitterS * random.normal());
      jittered.push_back(sample);
    }
    motion.samples = jittered;
    emulator::TrainingRun run = runOf(motion, {});
    alignClock(run, knownMachine());
    const auto found = sampleJitterS(run, knownMachine());
    QVERIFY(found);
    QVERIFY2(std::abs(*found / kJitterS - 1.0) < 0.2, qPrintable(QString::number(*found)));
  }

  void limitsOfAnotherMachineAreRefused_data() {
    QTest::addColumn<double>("factor");
    QTest::addColumn<QString>("named");
    QTest::newRow("slower than thought") << 4.0 << "falls";
    QTest::newRow("a little slower") << 1.3 << "falls";
    QTest::newRow("faster than thought") << 0.5 << "gets";
  }
  void limitsOfAnotherMachineAreRefused() {
    QFETCH(double, factor);
    QFETCH(QString, named);
    emulator::TrainingRun run = runOf(seen({}, 0.17), scaled(factor));
    alignClock(run, knownMachine());
    const auto steady = requireSteadyClock(run, knownMachine());
    QVERIFY(!steady);
    QVERIFY(steady.error().code == emulator::EmulatorError::WrongProgram);
    const QString text = QString::fromStdString(steady.error().text());
    QVERIFY2(text.contains(named) && text.contains(QStringLiteral("limits")), qPrintable(text));
  }

  /// A delay that both axes have cannot be told from the clock; what one has more can.
  void learnsAxesAndClock() {
    double share = 0.0;
    bool runsForward = true;
    const auto learned = learnWithClocks({runOf(seen({}, 0.17), {})},
                                         {.progress = [&](const emulator::LearnProgress& progress) {
                                           runsForward = runsForward && progress.share >= share;
                                           share = progress.share;
                                           return true;
                                         }});
    QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
    QVERIFY(runsForward && share > 0.8 && share <= 1.0);
    for (const emulator::LearnedAxis& axis : learned->axes) {
      // The lag at constant speed, whichever parts it is put down to.
      const double lagS = emulator::followingLagS(axis.parameters);
      const double trueS = axis.axis == 'X' ? 1.0 / kXGain : 1.0 / kYGain + kYDelayS;
      QVERIFY2(std::abs(lagS - trueS) < 0.001, qPrintable(QString::number(lagS)));
      // What is written to the file is what is simulated.
      for (const emulator::ParameterEstimate& estimate : axis.estimates) {
        QCOMPARE(estimate.value, axis.parameters[estimate.parameter]);
        QVERIFY(estimate.low <= estimate.value && estimate.value <= estimate.high);
      }
    }
  }

  void canBeCancelled() {
    int asked = 0;
    const auto learned = learnWithClocks({runOf(seen({}, 0.17), {})},
                                         {.isCancelled = [&asked] { return ++asked > 20; }});
    QVERIFY(!learned);
    QVERIFY(learned.error().code == emulator::EmulatorError::Cancelled);
  }
};

RIVULET_TEST(TestSparseLearning)
#include "tst_sparse_learning.moc"
