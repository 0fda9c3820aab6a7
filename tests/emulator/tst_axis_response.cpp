// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bode plot and step response against the simulation of the same axis.

#include <QtTest>
#include <numbers>

#include "emulator/axis_response.h"
#include "support/test_program.h"

using namespace rivulet::emulator;
using P = AxisParameter;

class TestAxisResponse : public QObject {
  Q_OBJECT

  static AxisParameters cascade() {
    AxisParameters p;
    p[P::PositionGain] = 40.0;
    p[P::FeedForward] = 0.7;
    p[P::FeedForwardLag] = 0.004;
    p[P::SpeedGain] = 100.0;
    p[P::ResetTime] = 0.02;
    p[P::EffortLag] = 0.002;
    p[P::Viscous] = 5.0;
    p[P::Delay] = 0.003;
    p[P::ResonanceHz] = 40.0;
    p[P::ResonanceDamping] = 0.2;
    p[P::CoulombSpeed] = 1.0;
    return p;
  }

  /// Fourier coefficient of the answer to a sine, after it has settled.
  static std::complex<double> simulated(const AxisParameters& p, double hz) {
    constexpr double kStepS = 1e-4;
    const double omega = 2.0 * std::numbers::pi * hz;
    const auto perPeriod = static_cast<std::size_t>(std::lround(1.0 / (hz * kStepS)));
    const std::size_t settled = 40'000 / perPeriod * perPeriod + perPeriod;
    std::vector<double> asked;
    for (std::size_t i = 0; i <= settled + perPeriod; ++i) {
      asked.push_back(std::sin(omega * static_cast<double>(i) * kStepS));
    }
    const std::vector<AxisState> states = simulateAxis(p, kStepS, asked);
    std::complex<double> sum;
    for (std::size_t i = settled; i < settled + perPeriod; ++i) {
      sum += states[i].mm * std::polar(1.0, -omega * static_cast<double>(i) * kStepS);
    }
    // sin = (e^jwt - e^-jwt)/2j
    return sum * std::complex<double>(0.0, 2.0) / static_cast<double>(perPeriod);
  }

 private Q_SLOTS:
  void isWhatTheSimulationDoes_data() {
    QTest::addColumn<double>("hz");
    for (const double hz : {0.5, 2.0, 5.0, 10.0, 20.0, 40.0, 50.0}) {
      QTest::addRow("%g Hz", hz) << hz;
    }
  }
  void isWhatTheSimulationDoes() {
    QFETCH(double, hz);
    AxisParameters stiff;
    stiff[P::PositionGain] = 30.0;
    stiff[P::CoulombSpeed] = 1.0;
    for (const AxisParameters& p : {cascade(), stiff}) {
      const std::complex<double> expected = simulated(p, hz);
      const std::complex<double> response = responseAt(p, hz);
      // A sine in straight pieces of 0.1 ms.
      QVERIFY2(std::abs(response - expected) < 2e-3 * std::abs(expected),
               qPrintable(QStringLiteral("%1 %2°, simulated %3 %4°")
                              .arg(std::abs(response))
                              .arg(std::arg(response))
                              .arg(std::abs(expected))
                              .arg(std::arg(expected))));
    }
  }

  void phaseRunsOn() {
    const auto points = frequencyResponse(cascade(), 0.1, 100.0, 300);
    QCOMPARE(points.size(), std::size_t{300});
    QVERIFY(std::abs(points.front().decibel) < 0.01);
    QVERIFY(points.back().phaseDeg < -360.0);
    for (std::size_t i = 1; i < points.size(); ++i) {
      QVERIFY(std::abs(points[i].phaseDeg - points[i - 1].phaseDeg) < 90.0);
    }
  }

  void aLagHasTheBandwidthOfItsTimeConstant() {
    const double hz = bandwidthHz(firstOrderLag(0.01));
    QVERIFY2(std::abs(hz - 100.0 / (2.0 * std::numbers::pi)) < 0.2,
             qPrintable(QString::number(hz)));
  }

  void aStepIsAnsweredAsBySimulation() {
    const std::vector<double> mm = stepResponse(firstOrderLag(0.02), 1.0, 0.001, 200);
    QCOMPARE(mm.size(), std::size_t{200});
    // After one time constant; the first step of the set point is a ramp of 1 ms.
    QVERIFY(std::abs(mm[19] - (1.0 - std::exp(-0.975))) < 0.002);
    QVERIFY(std::abs(mm.back() - 1.0) < 1e-3);
  }
};

RIVULET_TEST(TestAxisResponse)
#include "tst_axis_response.moc"
