// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "base/random.h"
#include "emulator/paper/cascade.h"
#include "support/test_program.h"

using namespace rivulet::emulator::paper;

namespace {

/// The equations of the paper, integrated numerically in small steps: slow and without any algebra
/// that the model could share.
class SlowAxis {
 public:
  SlowAxis(std::vector<OscillatorParameters> elements, const Parameters& values,
           const PlantSettings& plant)
      : m_elements(std::move(elements)),
        m_values(values),
        m_plant(plant),
        m_gains(controllerGains(values, plant)),
        m_state(2 * m_elements.size() + 6, 0.0) {}

  void step(double reference) {
    // This is instant k; fed back is what was at k - δt.
    const std::size_t n = m_state.size();
    m_past.push_back({m_state[n - 1], m_state[n - 2], m_state[n - 3], m_state[n - 4]});
    const auto k = static_cast<int>(m_past.size()) - 1;
    const int sampled = k - m_plant.feedbackDelaySteps;
    const Late late = sampled < 0 ? Late{} : m_past[static_cast<std::size_t>(sampled)];
    constexpr int kParts = 20;
    const double h = m_plant.stepS / kParts;
    for (int i = 0; i < kParts; ++i) {
      const auto k1 = rates(m_state, reference, late);
      const auto k2 = rates(moved(m_state, k1, 0.5 * h), reference, late);
      const auto k3 = rates(moved(m_state, k2, 0.5 * h), reference, late);
      const auto k4 = rates(moved(m_state, k3, h), reference, late);
      for (std::size_t s = 0; s < m_state.size(); ++s) {
        m_state[s] += h / 6.0 * (k1[s] + 2.0 * k2[s] + 2.0 * k3[s] + k4[s]);
      }
    }
  }
  [[nodiscard]] double positionMm() const { return m_state.back(); }

 private:
  struct Late {
    double x = 0.0;
    double v = 0.0;
    double i = 0.0;
    double w = 0.0;
  };
  using State = std::vector<double>;

  static State moved(State state, const State& rate, double h) {
    for (std::size_t s = 0; s < state.size(); ++s) {
      state[s] += h * rate[s];
    }
    return state;
  }

  [[nodiscard]] double p(int index) const { return parameter(m_values, index); }

  [[nodiscard]] State rates(const State& state, double reference, const Late& late) const {
    State rate(state.size(), 0.0);
    const std::size_t tail = 2 * m_elements.size();
    const double error = reference - late.x;
    double setPoint = p(23) * error;
    for (std::size_t k = 0; k < m_elements.size(); ++k) {
      // y'' + 2 ζ ω y' + ω² y = ω e; the element's output is its gain times y'.
      const auto [omega, zeta, gain] = m_elements[k];
      const double y = state[2 * k];
      const double dy = state[2 * k + 1];
      rate[2 * k] = dy;
      rate[2 * k + 1] = omega * error - 2.0 * zeta * omega * dy - omega * omega * y;
      setPoint += gain * dy;
    }
    setPoint *= p(24);
    const double speedError = setPoint - m_plant.speedFeedback * late.v;
    const double u =
        p(25) * (m_gains.speedProportional * speedError + m_gains.speedIntegral * state[tail]);
    const double powerError =
        u - m_plant.currentFeedback * (late.i + m_plant.currentDisturbance * p(27));
    const double power =
        p(26) * (m_gains.powerProportional * powerError + m_gains.powerIntegral * state[tail + 1]);
    rate[tail] = speedError;
    rate[tail + 1] = powerError;
    rate[tail + 2] = (power - late.w) / m_plant.powerDelayS;
    rate[tail + 3] = m_plant.electronicsGain * (state[tail + 2] - m_plant.backEmf * late.v) -
                     m_plant.electronicsDecay * late.i;
    rate[tail + 4] = m_plant.motorGain * state[tail + 3] - m_plant.motorDecay * late.v;
    rate[tail + 5] = state[tail + 4];
    return rate;
  }

  std::vector<OscillatorParameters> m_elements;
  Parameters m_values;
  PlantSettings m_plant;
  ControllerGains m_gains;
  State m_state;
  std::vector<Late> m_past;  ///< at each instant from 0 on
};

/// A corner: up a ramp of 6 mm/s, then stop.
double referenceAt(int step) {
  return 0.006 * std::min(step, 300);
}

double farthestApart(const Parameters& values, const PlantSettings& plant) {
  const auto elementsX = oscillatorsOfX(values);
  const auto elementsY = oscillatorsOfY(values);
  Cascade<4> x(elementsX, values, plant);
  Cascade<2> y(elementsY, values, plant);
  SlowAxis slowX({elementsX.begin(), elementsX.end()}, values, plant);
  SlowAxis slowY({elementsY.begin(), elementsY.end()}, values, plant);
  double apart = 0.0;
  for (int step = 0; step < 500; ++step) {
    x.step(referenceAt(step));
    y.step(referenceAt(step));
    slowX.step(referenceAt(step));
    slowY.step(referenceAt(step));
    apart = std::max({apart, std::abs(x.positionMm() - slowX.positionMm()),
                      std::abs(y.positionMm() - slowY.positionMm())});
  }
  return apart;
}

Parameters withRandom(std::vector<int> indices, std::uint64_t seed) {
  rivulet::base::Random random(seed);
  Parameters values = nominalParameters();
  for (const int index : indices) {
    const ParameterInfo& info = parameterTable()[static_cast<std::size_t>(index - 1)];
    values[static_cast<std::size_t>(index - 1)] =
        info.startLow + random.uniform() * (info.startHigh - info.startLow);
  }
  return values;
}

std::pair<std::vector<double>, std::vector<double>> paths(const Parameters& values) {
  Cascade<4> x(oscillatorsOfX(values), values, {});
  Cascade<2> y(oscillatorsOfY(values), values, {});
  std::pair<std::vector<double>, std::vector<double>> both;
  for (int step = 0; step < 500; ++step) {
    x.step(referenceAt(step));
    y.step(referenceAt(step));
    both.first.push_back(x.positionMm());
    both.second.push_back(y.positionMm());
  }
  return both;
}

/// The numerical integration is of fourth order in steps of 50 µs: its own error is far below.
constexpr double kToleranceMm = 1e-9;

}  // namespace

class TestCascade : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void positionControllerAsInP2_eq_1() {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Parameters values =
          withRandom({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 17, 18, 19, 20, 21, 22, 23, 24}, seed);
      QCOMPARE_LT(farthestApart(values, {}), kToleranceMm);
    }
  }
  void speedControllerAsInP2_eq_2() {
    PlantSettings plant;
    plant.speedFeedback = 1.3;
    QCOMPARE_LT(farthestApart(withRandom({13, 14, 25, 28, 33, 34}, 1), plant), kToleranceMm);
  }
  void powerControllerAsInP2_eq_3() {
    PlantSettings plant;
    plant.currentFeedback = 0.8;
    plant.currentDisturbance = 2.0;
    plant.powerDelayS = 0.0014;
    QCOMPARE_LT(farthestApart(withRandom({15, 16, 26, 27, 29, 30, 31, 32}, 1), plant),
                kToleranceMm);
  }
  void electronicsAsInP2_eq_4() {
    PlantSettings plant;
    plant.backEmf = 0.1;
    plant.electronicsGain = 70.0;
    plant.electronicsDecay = 140.0;
    QCOMPARE_LT(farthestApart(nominalParameters(), plant), kToleranceMm);
  }
  void motorAsInP2_eq_5() {
    PlantSettings plant;
    plant.motorGain = 160.0;
    plant.motorDecay = 8.0;
    QCOMPARE_LT(farthestApart(nominalParameters(), plant), kToleranceMm);
  }

  void delaysLongerThanACycle() {
    PlantSettings plant;
    plant.stepS = 0.0005;
    plant.feedbackDelaySteps = 3;
    QCOMPARE_LT(farthestApart(nominalParameters(), plant), kToleranceMm);
  }

  /// What is at instant j acts first in the cycle that begins at j + δt: after one cycle the axis
  /// has moved, and the end of cycle δt + 2 is the first that a shorter delay could not give.
  void P2_eq_1_feedsBackWhatWasADelayAgo() {
    const Parameters values = nominalParameters();
    PlantSettings open;  // nothing comes back within the steps looked at
    open.feedbackDelaySteps = kFeedbackDelayStepsMax;
    for (const int delay : {1, 2, 5}) {
      PlantSettings plant;
      plant.feedbackDelaySteps = delay;
      // Gains depend on the delay: here they are those of the open one.
      Parameters same = values;
      const ControllerGains wanted = controllerGains(values, open);
      const ControllerGains ours = controllerGains(values, plant);
      same[12] *= wanted.speedProportional / ours.speedProportional;
      same[13] *= wanted.speedIntegral / ours.speedIntegral;
      same[14] *= wanted.powerProportional / ours.powerProportional;
      same[15] *= wanted.powerIntegral / ours.powerIntegral;
      Cascade<4> fed(oscillatorsOfX(same), same, plant);
      Cascade<4> unfed(oscillatorsOfX(values), values, open);
      int firstApart = 0;
      for (int cycle = 1; cycle <= 10 && firstApart == 0; ++cycle) {
        fed.step(1.0);
        unfed.step(1.0);
        const double scale = std::abs(unfed.positionMm());
        firstApart = std::abs(fed.positionMm() - unfed.positionMm()) > 1e-9 * scale ? cycle : 0;
      }
      QCOMPARE(firstApart, delay + 2);
    }
  }

  /// On a steady ramp the oscillators give nothing, and the integral parts leave no speed error: so
  /// reference(t) - x(t - δt) is the speed over p23 p24, at each instant.
  void P2_eq_1_lagsAsItsPositionGainSays() {
    const Parameters values = nominalParameters();
    for (const int delay : {1, 3}) {
      PlantSettings plant;
      plant.stepS = 0.0005;
      plant.feedbackDelaySteps = delay;
      Cascade<4> x(oscillatorsOfX(values), values, plant);
      const double mmPerS = 6.0;
      std::vector<double> atMm{0.0};
      constexpr int kSteps = 80000;
      for (int step = 0; step < kSteps; ++step) {
        x.step(mmPerS * plant.stepS * step);
        atMm.push_back(x.positionMm());
      }
      QVERIFY(std::abs(x.speedMmPerS() - mmPerS) < 1e-6);
      const double referenceMm = mmPerS * plant.stepS * kSteps;
      const double lateMm = atMm[static_cast<std::size_t>(kSteps - delay)];
      const double lagMm = mmPerS / (parameter(values, 23) * parameter(values, 24));
      QVERIFY(std::abs(referenceMm - lateMm - lagMm) < 1e-6);
    }
  }

  void nominalSetIsStable() {
    Parameters values = nominalParameters();
    values[26] = 0.0;  // no constant disturbance
    Cascade<4> x(oscillatorsOfX(values), values, {});
    Cascade<2> y(oscillatorsOfY(values), values, {});
    for (int step = 0; step < 10000; ++step) {
      x.step(step < 100 ? 1.0 : 0.0);
      y.step(step < 100 ? 1.0 : 0.0);
    }
    QVERIFY(std::abs(x.positionMm()) < 1e-6);
    QVERIFY(std::abs(y.positionMm()) < 1e-6);
  }

  void everyParameterMatters() {
    const auto [x, y] = paths(nominalParameters());
    for (const ParameterInfo& info : parameterTable()) {
      Parameters values = nominalParameters();
      values[static_cast<std::size_t>(info.index - 1)] *= 1.1;
      const auto [otherX, otherY] = paths(values);
      const bool ofX = info.index <= 8 || (info.index >= 19 && info.index <= 22);
      const bool ofY =
          (info.index >= 9 && info.index <= 12) || info.index == 17 || info.index == 18;
      QVERIFY2((otherX != x) == !ofY, qPrintable(QString::number(info.index)));
      QVERIFY2((otherY != y) == !ofX, qPrintable(QString::number(info.index)));
    }
  }

  void tableIsInOrder() {
    int index = 0;
    for (const ParameterInfo& info : parameterTable()) {
      QCOMPARE(info.index, ++index);
      QVERIFY(info.startLow > 0.0);
      QVERIFY(info.startLow <= info.nominal && info.nominal <= info.startHigh);
    }
    std::map<std::string, int> counts;
    for (const ParameterInfo& info : parameterTable()) {
      ++counts[std::string(info.group)];
    }
    QCOMPARE(counts.at("MOSC controller transfer function (axis X)"), 8);
    QCOMPARE(counts.at("MOSC controller transfer function (axis Y)"), 4);
    QCOMPARE(counts.at("PID block parameters"), 4);
    QCOMPARE(counts.at("MOSC controller gains (axis X)"), 4);
    QCOMPARE(counts.at("MOSC controller gains (axis Y)"), 2);
    QCOMPARE(counts.at("Control loop gains"), 4);
    QCOMPARE(counts.at("Feedback disturbance"), 1);
    QCOMPARE(counts.at("Identification errors"), 7);
  }
};

RIVULET_TEST(TestCascade)
#include "tst_cascade.moc"
