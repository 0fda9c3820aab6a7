// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How chart and advice show a feed: one feed for all moves as F in mm/min; with the feeds of the
/// program, the override in %. Core computes with the feed of the fastest move in both cases.
/// @threadsafety pure.
#pragma once

#include <QString>

namespace rivulet::widgets {

struct FeedScale {
  /// With the feeds of the program: that of the fastest move at 100 %, mm/s. 0: one feed.
  double fullFeedMmPerS = 0.0;

  [[nodiscard]] bool isOverride() const { return fullFeedMmPerS > 0.0; }
  /// In mm/min or %.
  [[nodiscard]] double shown(double feedMmPerS) const;
  /// @param shown  in mm/min or %
  [[nodiscard]] double feedMmPerS(double shown) const;
  /// As an operator would type it; an override stays in its range.
  [[nodiscard]] double typed(double shown) const;
  /// "1,200 mm/min" or "83 %".
  [[nodiscard]] QString text(double feedMmPerS) const;
  /// "829 → 1,090 mm/min" or "83 → 109 %".
  [[nodiscard]] QString changeText(double fromMmPerS, double toMmPerS) const;
  /// A distance as the chart shows it: in mm; with the feeds of the program, distances are as long
  /// as the fastest move goes in their time, and shown as this time in ms.
  [[nodiscard]] double shownDistance(double distanceMm) const;
  /// The reverse of `shownDistance`.
  [[nodiscard]] double distanceMm(double shownDistance) const;
  /// "0.300 mm" or "12.0 ms".
  [[nodiscard]] QString distanceText(double distanceMm) const;

  friend bool operator==(const FeedScale&, const FeedScale&) = default;
};

}  // namespace rivulet::widgets
