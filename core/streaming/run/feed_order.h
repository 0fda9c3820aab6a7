// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What an operator wants of the feed while anything moves, and what is known of it. See
/// `templates::FeedCell`. @threadsafety plain values.
#pragma once

#include <optional>
#include <vector>

#include "base/instant.h"
#include "templates/window_protocol.h"

namespace rivulet::streaming {

struct FeedOrder {
  bool holds = false;  ///< the axes are to stand at once, on the path
  /// Path override while they are not, 0 to `FeedCell::kMax`; anything else is refused.
  double percent = templates::FeedCell::kProgrammed;

  friend bool operator==(const FeedOrder&, const FeedOrder&) = default;
};

/// The state of the feed cell.
struct FeedSeen {
  double wantedPercent = templates::FeedCell::kProgrammed;  ///< in the cell; 0: hold
  std::optional<double> actsPercent;                        ///< in force, as the control told last
  bool holds = false;                                       ///< by an order of this client
  /// From the order to hold until the axes were seen to stand; nothing: they have not been yet.
  std::optional<base::Duration> stoodAfter;
  bool isForeign = false;  ///< another client has written the cell since the last order
  bool isIgnored = false;  ///< held, but the axes move: what moves does not obey the override

  friend bool operator==(const FeedSeen&, const FeedSeen&) = default;
};

/// One order, as a report has it.
struct FeedEvent {
  base::Instant at{};
  double percent = 0.0;                      ///< 0: hold
  bool isForeign = false;                    ///< of another client
  std::optional<base::Duration> stoodAfter;  ///< a hold: until the axes were seen to stand
  base::Duration lasted{};                   ///< until the next one, or the end

  [[nodiscard]] bool isHold() const { return percent == templates::FeedCell::kHold; }
};

}  // namespace rivulet::streaming
