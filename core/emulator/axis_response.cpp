// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/axis_response.h"

#include <cmath>
#include <numbers>

namespace rivulet::emulator {

namespace {

using P = AxisParameter;
using Complex = std::complex<double>;

/// Continues a phase that `std::arg` has cut at ±180°.
double continued(double phaseDeg, double beforeDeg) {
  return phaseDeg - 360.0 * std::round((phaseDeg - beforeDeg) / 360.0);
}

}  // namespace

Complex responseAt(const AxisParameters& p, double hz) {
  if (hz <= 0.0) {
    return {1.0, 0.0};
  }
  const double omega = 2.0 * std::numbers::pi * hz;
  const Complex s{0.0, omega};
  // From speed command to speed.
  Complex speedLoop{1.0, 0.0};
  if (p[P::SpeedGain] > 0.0) {
    const Complex open = p[P::SpeedGain] * (1.0 + 1.0 / (s * p[P::ResetTime])) /
                         ((1.0 + s * p[P::EffortLag]) * (s + p[P::Viscous]));
    speedLoop = open / (1.0 + open);
  }
  const Complex command =
      p[P::PositionGain] + p[P::FeedForward] * s / (1.0 + s * p[P::FeedForwardLag]);
  Complex response = speedLoop * command / (s + speedLoop * p[P::PositionGain]);
  response *= std::exp(-s * p[P::Delay]);
  if (p[P::ResonanceHz] > 0.0) {
    const double own = 2.0 * std::numbers::pi * p[P::ResonanceHz];
    const Complex spring = own * own + 2.0 * p[P::ResonanceDamping] * own * s;
    response *= spring / (s * s + spring);
  }
  return response;
}

std::vector<ResponsePoint> frequencyResponse(const AxisParameters& parameters, double fromHz,
                                             double toHz, int count) {
  std::vector<ResponsePoint> points;
  double beforeDeg = 0.0;
  for (int i = 0; i < count; ++i) {
    const double hz = fromHz * std::pow(toHz / fromHz, static_cast<double>(i) / (count - 1));
    const Complex response = responseAt(parameters, hz);
    beforeDeg = continued(std::arg(response) * 180.0 / std::numbers::pi, beforeDeg);
    points.push_back({hz, 20.0 * std::log10(std::abs(response)), beforeDeg});
  }
  return points;
}

double bandwidthHz(const AxisParameters& parameters) {
  constexpr double kHzMax = 1000.0;
  constexpr double kRatio = 1.01;
  const double limit = std::sqrt(0.5);
  for (double hz = 0.1; hz <= kHzMax; hz *= kRatio) {
    if (std::abs(responseAt(parameters, hz)) < limit) {
      return hz;
    }
  }
  return 0.0;
}

std::vector<double> stepResponse(const AxisParameters& parameters, double stepMm, double periodS,
                                 int count) {
  AxisSimulator axis(parameters, periodS, {});
  std::vector<double> mm;
  for (int i = 0; i < count; ++i) {
    mm.push_back(axis.step(stepMm).mm);
  }
  return mm;
}

}  // namespace rivulet::emulator
