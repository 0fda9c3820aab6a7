// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "emulator/emulator_error.h"
#include "emulator/monitor.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using rivulet::base::Random;
using P = AxisParameter;

namespace {

constexpr double kPeriodS = 0.004;
constexpr double kNoiseMm = 0.001;

Emulator oneAxis() {
  LearnedAxis axis;
  axis.parameters[P::PositionGain] = 50.0;
  axis.estimates.push_back({P::PositionGain, 50.0, 49.0, 51.0});
  return {{axis}, {"a"}, "abc", "2026-11-22T08:30:05.123Z"};
}

/// The axis goes to and fro; what is seen is what the emulator answers, with noise.
TrainingRun runOf(const Emulator& emulator, double seconds, std::uint64_t seed) {
  TrainingRun run{"swing", kPeriodS, {{'X', {}, {}}}, {}};
  for (int i = 0; kPeriodS * i < seconds; ++i) {
    run.axes[0].reference.push_back(10.0 * std::sin(1.3 * kPeriodS * i));
    run.observedAt.push_back(kPeriodS * i);
  }
  Random random(seed);
  const LearnedAxis& axis = emulator.axes[0];
  for (const AxisState& state :
       predict(axis.parameters, setPointGrid(run.axes[0], run.period, axis.goesStraight),
               run.observedAt)) {
    run.axes[0].observed.push_back(state.mm + kNoiseMm * random.normal());
  }
  return run;
}

Emulator withPeaks() {
  Emulator emulator = oneAxis();
  const TrainingRun run = runOf(emulator, 200.0, 1);
  if (!measurePeaks(emulator, {&run, 1})) {
    qFatal("peaks cannot be measured");
  }
  return emulator;
}

}  // namespace

class TestMonitor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void marksNothingInARunInGoodOrder() {
    const Emulator emulator = withPeaks();
    for (std::uint64_t seed = 10; seed < 20; ++seed) {
      const auto found = findDeviations(emulator, runOf(emulator, 60.0, seed));
      QVERIFY2(found, found ? "" : found.error().text().c_str());
      QVERIFY(found->empty());
    }
  }

  /// The rate that is asked for is the rate that is seen, at a rate that can be counted.
  void raisesFalseAlarmsAsOftenAsItSays() {
    const Emulator emulator = withPeaks();
    const MonitorOptions often{.falseAlarmsPerHour = 100.0};
    const double thresholdMm = peakThresholdMm(emulator.axes[0], 1, often);
    int above = 0;
    constexpr int kSeconds = 3600;
    for (int part = 0; part < 12; ++part) {
      const TrainingRun run = runOf(emulator, kSeconds / 12.0, 100 + static_cast<unsigned>(part));
      const auto residuals = residualsOf(emulator, run);
      QVERIFY(residuals);
      double peakMm = 0.0;
      for (std::size_t i = 0; i < residuals->front().mm.size(); ++i) {
        peakMm = std::max(peakMm, std::abs(residuals->front().mm[i]));
        if ((i + 1) % 250 == 0) {
          above += peakMm > thresholdMm ? 1 : 0;
          peakMm = 0.0;
        }
      }
    }
    qInfo("%d marks in an hour", above);
    QVERIFY(above > 30 && above < 300);
  }

  void marksWhereAnAxisIsShifted() {
    const Emulator emulator = withPeaks();
    TrainingRun run = runOf(emulator, 60.0, 30);
    for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
      run.axes[0].observed[i] += run.observedAt[i] > 20.5 && run.observedAt[i] < 31.5 ? 0.05 : 0.0;
    }
    const auto found = findDeviations(emulator, run);
    QVERIFY(found);
    QCOMPARE(found->size(), std::size_t{1});
    QCOMPARE(found->front().axis, 'X');
    QVERIFY(found->front().fromS > 19.5 && found->front().fromS < 21.0);
    QVERIFY(found->front().toS > 31.0 && found->front().toS < 32.5);
    QVERIFY(std::abs(found->front().largestMm - 0.05) < 0.01);
    QVERIFY(found->front().thresholdMm < 0.01);
  }

  /// An axis of another structure than its model, four times as fast as it was learned: what the
  /// model leaves is four times as large, and no alarm. A shift is still noticed there.
  void doesNotCallMoreSpeedADeviation() {
    const auto swing = [](double factor, std::uint64_t seed) {
      TrainingRun run{"swing", kPeriodS, {{'X', {}, {}}}, {}};
      AxisParameters plant;
      plant[P::PositionGain] = 52.0;  // the emulator says 50
      for (int i = 0; kPeriodS * i < 60.0; ++i) {
        run.axes[0].reference.push_back(10.0 * std::sin(1.3 * factor * kPeriodS * i));
        run.observedAt.push_back(kPeriodS * i);
      }
      Random random(seed);
      for (const AxisState& state :
           predict(plant, setPointGrid(run.axes[0], run.period, false), run.observedAt)) {
        run.axes[0].observed.push_back(state.mm + kNoiseMm * random.normal());
      }
      return run;
    };
    Emulator emulator = oneAxis();
    const TrainingRun slow = swing(1.0, 1);
    QVERIFY(measurePeaks(emulator, {&slow, 1}));
    QVERIFY(std::abs(emulator.axes[0].peaks.mmPerSMost - 13.0) < 0.1);
    QCOMPARE(secondsBeyondPeaks(emulator, swing(1.0, 2)), 0.0);
    const TrainingRun fast = swing(4.0, 3);
    QVERIFY(secondsBeyondPeaks(emulator, fast) > 30.0);
    QVERIFY(findDeviations(emulator, fast)->empty());
    // Without what it was learned at, it is called one.
    Emulator older = emulator;
    older.axes[0].peaks.mmPerSMost = 0.0;
    QVERIFY(!findDeviations(older, fast)->empty());
    TrainingRun shifted = fast;
    for (std::size_t i = 0; i < shifted.observedAt.size(); ++i) {
      shifted.axes[0].observed[i] +=
          shifted.observedAt[i] > 20.0 && shifted.observedAt[i] < 30.0 ? 0.2 : 0.0;
    }
    QCOMPARE(findDeviations(emulator, shifted)->size(), std::size_t{1});
  }

  /// What a model of another structure leaves depends on the program: no rate is promised.
  void promisesNothingWhereTheStructureIsAnother() {
    Emulator emulator = withPeaks();
    QVERIFY(promisesRate(emulator.axes[0]));
    const double knownMm = peakThresholdMm(emulator.axes[0], 1, {});
    emulator.axes[0].estimates[0].high = emulator.axes[0].estimates[0].low;
    QVERIFY(!promisesRate(emulator.axes[0]));
    QCOMPARE(peakThresholdMm(emulator.axes[0], 1, {}), kOtherStructure * knownMm);
    // It is the same when it was read from its file.
    const auto again = parseEmulator(printEmulator(emulator), "test");
    QVERIFY(again && !promisesRate(again->axes[0]));
    QVERIFY(std::abs(again->axes[0].peaks.mmPerSMost - emulator.axes[0].peaks.mmPerSMost) < 1e-5);
  }

  /// What the axis did before the trace began is not a deviation.
  void forgivesWhatIsLeftOfTheTimeBefore() {
    const Emulator emulator = withPeaks();
    TrainingRun run = runOf(emulator, 60.0, 40);
    for (std::size_t i = 0; i < run.observedAt.size(); ++i) {
      run.axes[0].observed[i] += 0.05 * std::exp(-50.0 * run.observedAt[i]);
    }
    const auto found = findDeviations(emulator, run);
    QVERIFY2(found, found ? "" : found.error().text().c_str());
    QVERIFY(found->empty());
    const auto fit = testRun(emulator, run);
    QVERIFY2(fit, fit ? "" : fit.error().text().c_str());
    QVERIFY2(fit->positionMaxMm < 0.01, qPrintable(QString::number(fit->positionMaxMm)));
  }

  void keepsItsPeaksInTheFile() {
    const Emulator emulator = withPeaks();
    const auto read = parseEmulator(printEmulator(emulator), "mine.toml");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->axes[0].peaks.windows, 200);
    QVERIFY(std::abs(read->axes[0].peaks.scaleMm - emulator.axes[0].peaks.scaleMm) < 1e-9);
  }

  void refusesWhatItCannotJudge() {
    Emulator emulator = oneAxis();
    const TrainingRun brief = runOf(emulator, 10.0, 1);
    const auto measured = measurePeaks(emulator, {&brief, 1});
    QVERIFY(!measured);
    QVERIFY(measured.error().code == EmulatorError::TooShort);
    const auto unmeasured = findDeviations(emulator, brief);
    QVERIFY(!unmeasured);
    QVERIFY(unmeasured.error().code == EmulatorError::BadFile);
    emulator = withPeaks();
    TrainingRun other = runOf(emulator, 30.0, 1);
    other.axes[0].axis = 'Y';
    QVERIFY(findDeviations(emulator, other).error().code == EmulatorError::NoMotion);
    TrainingRun backwards = runOf(emulator, 30.0, 1);
    std::swap(backwards.observedAt[5], backwards.observedAt[6]);
    QVERIFY(findDeviations(emulator, backwards).error().code == EmulatorError::BadTimes);
  }

  void findsThatAWatermarkIsMissing() {
    int falseAlarms = 0;
    constexpr int kDraws = 500;
    for (int draw = 0; draw < kDraws; ++draw) {
      Random random(1000 + static_cast<unsigned>(draw));
      std::vector<double> atS;
      std::vector<double> answer;
      std::vector<double> honest;
      std::vector<double> made;
      for (int i = 0; i < 5000; ++i) {
        atS.push_back(kPeriodS * i);
        answer.push_back(0.0005 * random.normal());
        honest.push_back(kNoiseMm * random.normal());
        made.push_back(kNoiseMm * random.normal() - answer.back());
      }
      const MissingShare ofHonest = missingWatermark(honest, answer, atS);
      const double threshold = watermarkThreshold(ofHonest.windows, 0.01);
      falseAlarms += ofHonest.statistic() > threshold ? 1 : 0;
      const MissingShare ofMade = missingWatermark(made, answer, atS);
      QVERIFY(std::abs(ofMade.share - 1.0) < 6.0 * ofMade.standardError);
      QVERIFY(ofMade.statistic() > threshold);
    }
    qInfo("%d false alarms in %d", falseAlarms, kDraws);
    QVERIFY(falseAlarms <= 14);  // 5 expected; exceeded with probability 2e-4
  }

  void knowsTheTDistribution() {
    // Tables of Student's t.
    QVERIFY(std::abs(watermarkThreshold(6, 0.05) - 2.0150) < 1e-3);
    QVERIFY(std::abs(watermarkThreshold(21, 0.01) - 2.5280) < 1e-3);
    QVERIFY(std::abs(watermarkThreshold(31, 0.001) - 3.3852) < 1e-3);
  }
};

RIVULET_TEST(TestMonitor)
#include "tst_monitor.moc"
