// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/feasibility/feed_scale.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "gcode/feeds.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

constexpr double kOverridePercent = 100.0;
constexpr double kFeedScaleMsPerS = 1000.0;

}  // namespace

double FeedScale::shown(double feedMmPerS) const {
  return isOverride() ? kOverridePercent * feedMmPerS / fullFeedMmPerS
                      : base::mmPerMinFromMmPerS(feedMmPerS);
}

double FeedScale::feedMmPerS(double shown) const {
  return isOverride() ? shown / kOverridePercent * fullFeedMmPerS : base::mmPerSFromMmPerMin(shown);
}

double FeedScale::typed(double shown) const {
  if (isOverride()) {
    return std::clamp(std::round(shown), kOverridePercent * gcode::kOverrideMin,
                      kOverridePercent * gcode::kOverrideMax);
  }
  constexpr double kFine = 0.1;
  return shown >= 10.0 ? std::round(shown) : std::max(std::round(shown / kFine), 1.0) * kFine;
}

QString FeedScale::text(double feedMmPerS) const {
  return isOverride() ? QStringLiteral("%1\u00A0%").arg(numberText(shown(feedMmPerS), 0))
                      : feedText(feedMmPerS);
}

QString FeedScale::changeText(double fromMmPerS, double toMmPerS) const {
  return QStringLiteral("%1 → %2").arg(numberText(shown(fromMmPerS), 0), text(toMmPerS));
}

double FeedScale::shownDistance(double distanceMm) const {
  return isOverride() ? kFeedScaleMsPerS * distanceMm / fullFeedMmPerS : distanceMm;
}

double FeedScale::distanceMm(double shownDistance) const {
  return isOverride() ? shownDistance * fullFeedMmPerS / kFeedScaleMsPerS : shownDistance;
}

QString FeedScale::distanceText(double distanceMm) const {
  return isOverride() ? QStringLiteral("%1\u00A0ms").arg(numberText(shownDistance(distanceMm), 1))
                      : lengthText(distanceMm);
}

}  // namespace rivulet::widgets
