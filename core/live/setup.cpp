// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "live/error.h"

namespace rivulet::live {

namespace {

base::Result<void> notAgreed(std::string message) {
  return base::fail(LiveError::NotAgreed, std::move(message));
}

base::Result<void> requireBox(const Agreement& agreed) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    // Also false for what is not a number.
    if (!(agreed.lowestMm[axis] <= agreed.highestMm[axis]) ||
        !std::isfinite(agreed.lowestMm[axis]) || !std::isfinite(agreed.highestMm[axis])) {
      return notAgreed(
          fmt::format("The box has no room in {}: {} to {} mm. Give the least value "
                      "first.",
                      base::kAxisNames[axis], agreed.lowestMm[axis], agreed.highestMm[axis]));
    }
  }
  return {};
}

}  // namespace

base::Result<void> requireSound(const Setup& setup) {
  const Agreement& agreed = setup.agreement;
  if (base::Result<void> box = requireBox(agreed); !box) {
    return box;
  }
  const std::array<double, 4> positive{agreed.stepMmMax, agreed.turnDegMax, agreed.feedMmPerMinMax,
                                       base::toSeconds(setup.limits.fullWithin)};
  if (!std::all_of(positive.begin(), positive.end(),
                   [](double value) { return std::isfinite(value) && value > 0.0; })) {
    return notAgreed("Step, turn, feed and the time for a window have to be above 0.");
  }
  if (!(agreed.distanceMmMin >= 0.0 && agreed.distanceMmMin < agreed.stepMmMax)) {
    return notAgreed(
        fmt::format("Points closer than {} mm would be merged, but a step has {} mm at "
                    "most. Merge less.",
                    agreed.distanceMmMin, agreed.stepMmMax));
  }
  if (!(agreed.startMmMax >= 0.0 && std::isfinite(agreed.startMmMax))) {
    return notAgreed("The distance of the first point has to be 0 or more.");
  }
  if (setup.limits.holdAfter <= base::Duration{0} ||
      setup.limits.endAfter < setup.limits.holdAfter) {
    return notAgreed(
        "A silent source first holds the run, then ends it: give times above 0, the "
        "one for the end not below the other.");
  }
  return {};
}

std::string textOf(const Setup& setup) {
  const Agreement& agreed = setup.agreement;
  const auto box = [&agreed](std::size_t axis) {
    return fmt::format("{}={}..{}", base::kAxisNames[axis], agreed.lowestMm[axis],
                       agreed.highestMm[axis]);
  };
  return fmt::format(
      "{} {} {} {} step={} turn={} feed={} merge={} start={} full={} hold={} end={} axes={}",
      setup.address, box(0), box(1), box(2), agreed.stepMmMax, agreed.turnDegMax,
      agreed.feedMmPerMinMax, agreed.distanceMmMin, agreed.startMmMax,
      base::toSeconds(setup.limits.fullWithin), base::toSeconds(setup.limits.holdAfter),
      base::toSeconds(setup.limits.endAfter), base::rotaryNames(setup.rotaryAxes));
}

}  // namespace rivulet::live
