// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Plants of known parameters, solved by another method (Runge-Kutta in steps of 0.1 ms), are
// learned from what was seen of them.

#include <QtTest>

#include "base/random.h"
#include "emulator/emulator_error.h"
#include "emulator/identification.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using rivulet::base::Random;
using P = AxisParameter;

namespace {

constexpr double kPeriodS = 0.001;

/// Moves of different speeds with constant acceleration between them, and slow turns, which show
/// how the friction is built up.
std::vector<double> setPoints(double seconds) {
  constexpr double kMmPerS2 = 600.0;
  const std::vector<double> speeds{0.0, 40.0, 5.0, -25.0, -3.0, 0.0, 15.0, -50.0, 2.0};
  std::vector<double> mm{0.0};
  double speed = 0.0;
  for (double t = 0.0; t < seconds; t += kPeriodS) {
    const double wanted = std::fmod(t, 1.0) < 0.3
                              ? 2.0 * std::sin(2.0 * M_PI * t / 0.1)
                              : speeds[static_cast<std::size_t>(t / 0.28) % speeds.size()];
    speed += std::clamp(wanted - speed, -kMmPerS2 * kPeriodS, kMmPerS2 * kPeriodS);
    mm.push_back(mm.back() + speed * kPeriodS);
  }
  return mm;
}

/// The equations of axis_model.h, as they stand there.
std::vector<double> solve(const AxisParameters& p, const std::vector<double>& mm) {
  constexpr int kParts = 10;
  constexpr double kStepS = kPeriodS / kParts;
  struct State {
    std::array<double, 5> of{};  // x, v, integral, effort, filtered set point
  };
  const auto slopes = [&](const State& s, double r, double slope) {
    const double forward = p[P::FeedForwardLag] > 0.0
                               ? p[P::FeedForward] * (r - s.of[4]) / p[P::FeedForwardLag]
                               : p[P::FeedForward] * slope;
    const double error = p[P::PositionGain] * (r - s.of[0]) + forward - s.of[1];
    const double asked = p[P::SpeedGain] * error + s.of[2];
    const bool lags = p[P::EffortLag] > 0.0;
    const double effort = lags ? s.of[3] : asked;
    return State{
        {s.of[1],
         effort - p[P::Viscous] * s.of[1] - p[P::Coulomb] * std::tanh(s.of[1] / p[P::CoulombSpeed]),
         p[P::SpeedGain] / p[P::ResetTime] * error,
         lags ? (asked - s.of[3]) / p[P::EffortLag] : 0.0,
         p[P::FeedForwardLag] > 0.0 ? (r - s.of[4]) / p[P::FeedForwardLag] : 0.0}};
  };
  const auto moved = [](State s, const State& by, double seconds) {
    for (std::size_t i = 0; i < s.of.size(); ++i) {
      s.of[i] += seconds * by.of[i];
    }
    return s;
  };
  State s;
  std::vector<double> seen{0.0};
  for (std::size_t i = 1; i < mm.size(); ++i) {
    const double slope = (mm[i] - mm[i - 1]) / kPeriodS;
    for (int part = 0; part < kParts; ++part) {
      const double r = mm[i - 1] + slope * kStepS * part;
      const State a = slopes(s, r, slope);
      const State b = slopes(moved(s, a, kStepS / 2), r + slope * kStepS / 2, slope);
      const State c = slopes(moved(s, b, kStepS / 2), r + slope * kStepS / 2, slope);
      const State d = slopes(moved(s, c, kStepS), r + slope * kStepS, slope);
      for (std::size_t k = 0; k < s.of.size(); ++k) {
        s.of[k] += kStepS / 6.0 * (a.of[k] + 2.0 * b.of[k] + 2.0 * c.of[k] + d.of[k]);
      }
    }
    seen.push_back(s.of[0]);
  }
  return seen;
}

TrainingRun runOf(const AxisParameters& plant, const std::vector<double>& mm, double noiseMm,
                  std::uint64_t seed) {
  Random random(seed);
  TrainingRun run{"synthetic", kPeriodS, {{'X', mm, {}}}, {}};
  const std::vector<double> seen = solve(plant, mm);
  for (std::size_t i = 0; i < seen.size(); i += 4) {
    run.observedAt.push_back(static_cast<double>(i) * kPeriodS);
    run.axes[0].observed.push_back(seen[i] + noiseMm * random.normal());
  }
  return run;
}

AxisParameters plantWithFeedForward(Random& random) {
  AxisParameters p;
  p[P::PositionGain] = 30.0 + 40.0 * random.uniform();
  p[P::FeedForward] = 0.3 + 0.6 * random.uniform();
  p[P::SpeedGain] = 80.0 + 60.0 * random.uniform();
  p[P::ResetTime] = 0.01 + 0.02 * random.uniform();
  p[P::Coulomb] = 40.0 + 60.0 * random.uniform();
  p[P::CoulombSpeed] = 0.3 + 0.7 * random.uniform();
  return p;
}

AxisParameters plantWithLag(Random& random) {
  AxisParameters p = plantWithFeedForward(random);
  p[P::FeedForward] = 0.0;
  p[P::EffortLag] = 0.001 + 0.003 * random.uniform();
  return p;
}

double rmsOf(const AxisParameters& model, const std::vector<double>& mm,
             const std::vector<double>& seen) {
  const std::vector<AxisState> states = simulateAxis(model, kPeriodS, mm);
  double squares = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    squares += (states[i].mm - seen[i]) * (states[i].mm - seen[i]);
  }
  return std::sqrt(squares / static_cast<double>(seen.size()));
}

}  // namespace

class TestIdentification : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theModelSolvesItsEquations() {
    Random random(3);
    const std::vector<double> mm = setPoints(2.5);
    AxisParameters filtered = plantWithFeedForward(random);
    filtered[P::FeedForwardLag] = 0.002;
    for (const AxisParameters& plant :
         {plantWithFeedForward(random), plantWithLag(random), filtered}) {
      // What remains is the friction that is held over a step of 1 ms.
      const double rmsMm = rmsOf(plant, mm, solve(plant, mm));
      QVERIFY2(rmsMm < 2e-4, qPrintable(QString::number(rmsMm)));
    }
  }

  void recoversKnownParametersWithinTheirIntervals() {
    const std::vector<double> mm = setPoints(2.0);
    int recovered = 0;
    for (std::uint64_t draw = 0; draw < 100; ++draw) {
      Random random(1000 + draw);
      const AxisParameters plant =
          draw % 2 == 0 ? plantWithFeedForward(random) : plantWithLag(random);
      const TrainingRun run = runOf(plant, mm, 0.001, draw);
      AxisParameters structure = plant;
      for (const AxisParameterFacts& facts : axisParameterFacts()) {
        if (structure[facts.parameter] > 0.0) {
          structure[facts.parameter] = facts.typical;
        }
      }
      const auto learned = learnAxis({&run, 1}, 'X', {.structure = &structure});
      QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
      recovered += std::ranges::all_of(learned->estimates, [&](const ParameterEstimate& estimate) {
        const double known = plant[estimate.parameter];
        return estimate.low <= known && known <= estimate.high;
      });
    }
    qInfo("recovered %d of 100", recovered);
    QVERIFY(recovered >= 95);
  }

  /// The list has no part for the play of a screw. The fit is good to micrometres all the same.
  void anAxisOfAnotherStructureHasNoIntervals() {
    const std::vector<double> mm = setPoints(6.0);
    Random random(11);
    const AxisParameters plant = plantWithFeedForward(random);
    TrainingRun run = runOf(plant, mm, 0.0, 0);
    // The position is seen through a play of the screw, which is no part of the model.
    constexpr double kPlayMm = 0.004;
    double seenMm = 0.0;
    for (double& observed : run.axes[0].observed) {
      seenMm = std::clamp(seenMm, observed - kPlayMm, observed + kPlayMm);
      observed = seenMm + 0.0002 * random.normal();
    }
    const auto learned = learnAxis({&run, 1}, 'X');
    QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
    QVERIFY(learned->fitRmsMm < 0.004);
    QVERIFY(std::ranges::none_of(learned->estimates, &ParameterEstimate::hasInterval));
    // The same axis without play has them.
    const TrainingRun plain = runOf(plant, mm, 0.001, 1);
    const auto known = learnAxis({&plain, 1}, 'X', {.structure = &plant});
    QVERIFY(known && std::ranges::all_of(known->estimates, &ParameterEstimate::hasInterval));
  }

  /// The structure chosen, not given: an interval that is shown holds the true parameter, also the
  /// 0 of a part that the axis does not have.
  void intervalsHoldWhereTheStructureIsChosen() {
    const std::vector<double> mm = setPoints(4.0);
    int shown = 0;
    int wrong = 0;
    constexpr std::uint64_t kDraws = 10;
    for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
      Random random(3000 + draw);
      const AxisParameters plant =
          draw % 2 == 0 ? plantWithFeedForward(random) : plantWithLag(random);
      const TrainingRun run = runOf(plant, mm, 0.001, draw);
      const auto learned = learnAxis({&run, 1}, 'X');
      QVERIFY(learned);
      if (std::ranges::none_of(learned->estimates, &ParameterEstimate::hasInterval)) {
        continue;
      }
      ++shown;
      wrong += std::ranges::all_of(axisParameterFacts(),
                                   [&](const AxisParameterFacts& facts) {
                                     const auto found =
                                         std::ranges::find(learned->estimates, facts.parameter,
                                                           &ParameterEstimate::parameter);
                                     const double known = plant[facts.parameter];
                                     return found == learned->estimates.end()
                                                ? known == 0.0 || facts.parameter == P::CoulombSpeed
                                                : found->low <= known && known <= found->high;
                                   })
                   ? 0
                   : 1;
    }
    qInfo("%d of %d with intervals, %d of them wrong", shown, static_cast<int>(kDraws), wrong);
    QVERIFY(shown > 0);
    QVERIFY(wrong <= 1);
  }

  void intervalsAreNoWiderThanTheyNeedToBe() {
    Random random(5);
    const AxisParameters plant = plantWithLag(random);
    const TrainingRun run = runOf(plant, setPoints(5.0), 0.001, 5);
    const auto learned = learnAxis({&run, 1}, 'X', {.structure = &plant});
    QVERIFY(learned);
    QCOMPARE(learned->estimates[0].parameter, P::PositionGain);
    QVERIFY((learned->estimates[0].high - learned->estimates[0].low) / learned->estimates[0].value <
            0.02);
  }

  void choosesAStructureThatPredictsAnotherProgram() {
    std::vector<double> other;
    for (int i = 0; i < 3000; ++i) {
      other.push_back(8.0 * (1.0 - std::cos(0.006 * i)));
    }
    for (const std::uint64_t seed : {1U, 2U}) {
      Random random(seed);
      AxisParameters plant = seed == 1 ? plantWithFeedForward(random) : plantWithLag(random);
      if (seed == 1) {
        plant[P::FeedForwardLag] = 0.002;
      }
      const TrainingRun run = runOf(plant, setPoints(6.0), 0.0005, seed);
      const auto learned = learnAxis({&run, 1}, 'X');
      QVERIFY(learned);
      const double rmsMm = rmsOf(learned->parameters, other, solve(plant, other));
      QVERIFY2(rmsMm < 1e-3, qPrintable(QString::number(rmsMm)));
      QVERIFY(learned->heldOutRmsMm < 1e-3);
    }
  }

  void findsAFirstOrderLagToBeOne() {
    // The servo of the virtual machine: actual' = (set point - actual) / T, T = 10 ms.
    const std::vector<double> mm = setPoints(3.0);
    TrainingRun run{"lag", kPeriodS, {{'X', mm, {0.0}}}, {0.0}};
    const double decay = std::exp(-kPeriodS / 0.01);
    for (std::size_t i = 1; i < mm.size(); ++i) {
      const double step = mm[i] - mm[i - 1];
      const double before = run.axes[0].observed.back();
      run.axes[0].observed.push_back(mm[i] + (before - mm[i - 1]) * decay -
                                     step * 0.01 / kPeriodS * (1.0 - decay));
      run.observedAt.push_back(kPeriodS * static_cast<double>(i));
    }
    const auto learned = learnAxis({&run, 1}, 'X');
    QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
    QCOMPARE(learned->estimates.size(), std::size_t{1});
    QVERIFY(std::abs(learned->parameters[P::PositionGain] - 100.0) < 1e-3);
    QVERIFY(learned->fitRmsMm < 1e-6);
  }

  void findsThatAMachineGoesStraight() {
    // Set points every 4 ms, between which a control goes straight: its interpolation cycle.
    constexpr std::size_t kCycle = 4;
    std::vector<double> mm = setPoints(6.0);
    mm.resize(mm.size() / kCycle * kCycle + 1);
    for (std::size_t i = 0; i + kCycle < mm.size(); i += kCycle) {
      for (std::size_t k = 1; k < kCycle; ++k) {
        mm[i + k] = mm[i] + (mm[i + kCycle] - mm[i]) * static_cast<double>(k) / kCycle;
      }
    }
    Random random(4);
    const AxisParameters plant = plantWithFeedForward(random);
    TrainingRun run = runOf(plant, mm, 1e-5, 4);
    run.period = kCycle * kPeriodS;
    std::vector<double>& reference = run.axes[0].reference;
    for (std::size_t i = 0; kCycle * i < mm.size(); ++i) {
      reference[i] = mm[kCycle * i];
    }
    reference.resize((mm.size() - 1) / kCycle + 1);
    const auto learned = learnAxis({&run, 1}, 'X');
    QVERIFY2(learned, learned ? "" : learned.error().text().c_str());
    QVERIFY(learned->goesStraight);
    QVERIFY(learned->fitRmsMm < 1e-4);
    QVERIFY(std::abs(learned->parameters[P::PositionGain] / plant[P::PositionGain] - 1.0) < 0.01);
  }

  /// A model that began otherwise would find parameters that hide it.
  void beginsAsItsSetPointsDo() {
    constexpr double kCycleS = 0.004;
    const AxisParameters plant = firstOrderLag(0.02);
    const std::vector<double> begin{0.0};
    for (const bool goesStraight : {false, true}) {
      const auto firstOf = [&](const std::vector<double>& mm) {
        return predict(plant, setPointGrid({'X', mm, {}}, kCycleS, goesStraight), begin).front();
      };
      const AxisState rests = firstOf({0.0, 0.1, 0.4, 0.9, 1.6});  // at even acceleration
      QCOMPARE(rests.mm, 0.0);
      QCOMPARE(rests.mmPerS, 0.0);
      QCOMPARE(firstOf({-0.001, -0.008, -0.027, -0.064}).mmPerS, 0.0);  // at even jerk, just begun
      const AxisState moves = firstOf({0.0, 0.2, 0.4, 0.6, 0.8});
      QVERIFY(std::abs(moves.mmPerS - 50.0) < 1e-9);
      QVERIFY(std::abs(moves.mm + 50.0 * 0.02) < 1e-9);                          // late by its lag
      QVERIFY(std::abs(firstOf({0.0, -0.3, -0.5, -0.6}).mmPerS + 87.5) < 1e-9);  // it brakes
    }
  }

  /// Of an axis that moves already, nobody knows what it did before.
  void doesNotLookAtTheBeginOfARunThatBeginsInMotion() {
    std::vector<double> moving;
    std::vector<double> fromRest;
    for (int i = 0; i < 5000; ++i) {
      moving.push_back(8.0 * std::sin(0.006 * i));
      fromRest.push_back(8.0 * (1.0 - std::cos(0.006 * i)));
    }
    QCOMPARE(knownFromS({"rests", kPeriodS, {{'X', fromRest, {}}}, {}}), 0.0);
    const double knownS =
        knownFromS({"moves", kPeriodS, {{'X', fromRest, {}}, {'Y', moving, {}}}, {}});
    QVERIFY(knownS > 0.2 && knownS < 1.0);
    moving.resize(2000);  // there is little enough of it
    QCOMPARE(knownFromS({"short", kPeriodS, {{'X', moving, {}}}, {}}), 0.0);
  }

  void refusesWhatCannotBeLearnedFrom_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<EmulatorError>("code");
    QTest::newRow("no motion") << 0 << EmulatorError::NoMotion;
    QTest::newRow("too short") << 1 << EmulatorError::TooShort;
    QTest::newRow("inches") << 2 << EmulatorError::BadUnits;
    QTest::newRow("not a number") << 3 << EmulatorError::BadNumbers;
    QTest::newRow("time backwards") << 4 << EmulatorError::BadTimes;
    QTest::newRow("no such axis") << 5 << EmulatorError::NoMotion;
    QTest::newRow("another program") << 6 << EmulatorError::Diverged;
    QTest::newRow("nothing left to test on") << 7 << EmulatorError::TooShort;
  }
  void refusesWhatCannotBeLearnedFrom() {
    QFETCH(int, fault);
    QFETCH(EmulatorError, code);
    Random random(7);
    const AxisParameters plant = plantWithLag(random);
    TrainingRun run = runOf(plant, setPoints(2.0), 0.001, 7);
    AxisTrack& track = run.axes[0];
    if (fault == 0) {
      std::ranges::fill(track.reference, 0.0);
    } else if (fault == 1) {
      run.observedAt.resize(20);
      track.observed.resize(20);
    } else if (fault == 2) {
      for (double& value : track.observed) {
        value /= 25.4;
      }
    } else if (fault == 3) {
      track.observed[100] = std::numeric_limits<double>::quiet_NaN();
    } else if (fault == 4) {
      std::swap(run.observedAt[50], run.observedAt[51]);
    } else if (fault == 6) {
      std::ranges::reverse(track.observed);
    } else if (fault == 7) {
      // It moves for a moment, in one stretch of the run.
      std::fill(track.reference.begin() + 250, track.reference.end(), track.reference[250]);
      std::fill(track.observed.begin() + 62, track.observed.end(), track.reference[250]);
    }
    const auto learned = learnAxis({&run, 1}, fault == 5 ? 'Z' : 'X', {.structure = &plant});
    QVERIFY(!learned);
    QVERIFY2(learned.error().code == code, learned.error().text().c_str());
    QVERIFY(!learned.error().message.empty());
  }

  /// In the middle of a search, too: nothing waits for the end of a structure.
  void canBeCancelledAtAnyTime() {
    Random random(9);
    const TrainingRun run = runOf(plantWithLag(random), setPoints(2.0), 0.001, 9);
    for (const int asked : {1, 5, 300}) {
      int left = asked;
      int reportedLater = 0;
      const auto learned = learnAxes({&run, 1}, {.progress =
                                                     [&](const LearnProgress&) {
                                                       reportedLater += left <= 0 ? 1 : 0;
                                                       return true;
                                                     },
                                                 .isCancelled = [&left] { return --left <= 0; }});
      QVERIFY(!learned);
      QVERIFY(learned.error().code == EmulatorError::Cancelled);
      // Asked no more often than a few searches take that end at once.
      QVERIFY2(left > -300, qPrintable(QString::number(left)));
      QCOMPARE(reportedLater, 0);
    }
  }

  void canBeCancelled() {
    Random random(9);
    const TrainingRun run = runOf(plantWithLag(random), setPoints(2.0), 0.001, 9);
    int calls = 0;
    const auto learned = learnAxes({&run, 1}, {.progress = [&](const LearnProgress& progress) {
                                     ++calls;
                                     return progress.step < 2;
                                   }});
    QVERIFY(!learned);
    QVERIFY(learned.error().code == EmulatorError::Cancelled);
    QCOMPARE(calls, 2);
  }
};

RIVULET_TEST(TestIdentification)
#include "tst_identification.moc"
