// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/nice_step.h"

#include <algorithm>
#include <cmath>

#include "base/contract.h"

namespace rivulet::base {

namespace {

/// What arithmetic leaves of a number that was meant to be round.
constexpr double kRounding = 1e-9;

double powerOfTenBelow(double value) {
  RIVULET_ASSERT(value > 0.0);
  return std::pow(10.0, std::floor(std::log10(value)));
}

}  // namespace

double niceStepAbove(double value) {
  const double power = powerOfTenBelow(value);
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * (1.0 - kRounding)) {
      return step * power;
    }
  }
  return 10.0 * power;
}

double niceStepBelow(double value) {
  const double power = powerOfTenBelow(value);
  for (const double step : {5.0, 2.0}) {
    if (step * power <= value * (1.0 + kRounding)) {
      return step * power;
    }
  }
  return power;
}

double niceCeil(double value) {
  const double step = niceStepAbove(value / 10.0);
  return std::ceil(value / step - kRounding) * step;
}

int decimalsOfStep(double step) {
  RIVULET_ASSERT(step > 0.0);
  return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - kRounding)));
}

}  // namespace rivulet::base
