// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What an operator wants of the feed while anything moves, and what is known of it. See
/// `templates::FeedCell`. @threadsafety plain values.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "live/feed_factor.h"
#include "templates/window_protocol.h"
#include "trace/analysis/statistics.h"

namespace rivulet::streaming {

/// A tool that is no further from its path is back on it, mm.
inline constexpr double kLoweredMm = 0.005;

struct FeedOrder {
  bool holds = false;  ///< the axes are to stand at once, on the path
  /// Path override while they are not, 0 to `FeedCell::kMax`; anything else is refused.
  double percent = templates::FeedCell::kProgrammed;
  /// What a source beside the operator makes of it, if the program has a cell for that.
  std::optional<live::FactorSeen> source = std::nullopt;
  /// While they are held and stand: the tool is lifted along Z by so much, mm, if the program has a
  /// cell for that. The axes stay held until it is back on the path.
  double liftMm = 0.0;

  friend bool operator==(const FeedOrder&, const FeedOrder&) = default;
};

/// The state of the feed cell.
struct FeedSeen {
  double wantedPercent = templates::FeedCell::kProgrammed;  ///< in the cell; 0: hold
  double factor = 1.0;                                      ///< in its cell; 0: the source holds
  std::optional<live::FactorSeen> source;                   ///< nothing: there is none
  std::optional<double> actsPercent;                        ///< in force, as the control told last
  bool holds = false;                                       ///< by one of both
  /// From the order to hold until the axes were seen to stand; nothing: they have not been yet.
  std::optional<base::Duration> stoodAfter;
  bool isForeign = false;  ///< another client has written the cell since the last order
  bool isIgnored = false;  ///< held, but the axes move: what moves does not obey the override
  /// How far Z is from where it stood first, mm, at the last look; nothing: the program does not
  /// lift, or the axes are not held.
  std::optional<double> liftedMm;

  [[nodiscard]] bool isLifted() const { return std::abs(liftedMm.value_or(0.0)) > kLoweredMm; }
  /// The source holds, and the operator does not.
  [[nodiscard]] bool isHeldBySource() const {
    return factor == 0.0 && wantedPercent > templates::FeedCell::kHold;
  }
  friend bool operator==(const FeedSeen&, const FeedSeen&) = default;
};

/// One order, as a report has it.
struct FeedEvent {
  base::Instant at{};
  double percent = 0.0;                      ///< 0: hold
  bool isForeign = false;                    ///< of another client
  bool isSource = false;                     ///< of the source of factors
  std::optional<base::Duration> stoodAfter;  ///< a hold: until the axes were seen to stand
  base::Duration lasted{};                   ///< until the next one, or the end

  [[nodiscard]] bool isHold() const { return percent == templates::FeedCell::kHold; }
};

/// What came of a source of factors in a run.
struct FactorReport {
  live::FactorCount count;
  std::size_t written = 0;  ///< factors into the cell; what comes faster is passed over
  double least = 1.0;       ///< of these, without holds
  double most = 1.0;
  /// From reading a factor to the answer that it is in the cell. The main run obeys within one more
  /// interpolation cycle.
  trace::DurationStatistics delay;
};

}  // namespace rivulet::streaming
