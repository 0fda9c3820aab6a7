// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An axis as control engineers draw it: its answer to sines of every frequency (Bode plot) and to
/// a step of the set point. From set point to actual position of the load. @threadsafety pure.
#pragma once

#include <complex>
#include <vector>

#include "emulator/axis_model.h"

namespace rivulet::emulator {

/// Actual position per set point, of the linear part: without Coulomb friction.
/// @param hz  >= 0
[[nodiscard]] std::complex<double> responseAt(const AxisParameters& parameters, double hz);

struct ResponsePoint {
  double hz = 0.0;
  double decibel = 0.0;
  double phaseDeg = 0.0;  ///< runs on below -180°, does not jump
};
/// At frequencies with equal ratios. @param fromHz > 0 @param toHz > fromHz @param count > 1
[[nodiscard]] std::vector<ResponsePoint> frequencyResponse(const AxisParameters& parameters,
                                                           double fromHz, double toHz, int count);

/// Where the response has fallen by 3 dB for the first time; 0: nowhere up to 1 kHz.
[[nodiscard]] double bandwidthHz(const AxisParameters& parameters);

/// The set point is 0 mm, and `stepMm` from 0 s on; positions every `periodS`, with friction.
[[nodiscard]] std::vector<double> stepResponse(const AxisParameters& parameters, double stepMm,
                                               double periodS, int count);

}  // namespace rivulet::emulator
