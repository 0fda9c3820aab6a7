// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The operator's settings for a run. @threadsafety plain values.
#pragma once

#include "live/feed_factor.h"
#include "streaming/control/access_policy.h"
#include "templates/cells.h"

namespace rivulet::streaming {

struct StreamSettings {
  templates::TemplateParameters parameters;  ///< method, N, layout, axes
  double deltaMm = 0.3;                      ///< δ, > 0; used by method position
  double feedMmPerS = 500.0 / 60.0;          ///< > 0; of all moves, unless `usesProgramFeeds`
  bool programFeeds = false;                 ///< each move has the feed of its own block
  double overrideFactor = 1.0;               ///< on those feeds
  double tolerance = 0.0;                    ///< see `RunSettings::tolerance`
  AccessPreference access = AccessPreference::Automatic;
  /// A program with blocks that only the control can execute is run with them, where the connected
  /// machine can; false: its motion alone.
  bool wholeJob = false;
  /// > 0: a whole job runs dry, so much higher; not remembered.
  double dryRunMm = 0.0;
  live::FactorSource factor;    ///< with the bounds of `parameters`
  bool transferByHand = false;  ///< a person brings the template to the control; not remembered

  /// The methods of [P1] have one feed, as published.
  [[nodiscard]] bool usesProgramFeeds() const {
    return programFeeds && !base::isPublished(parameters.method);
  }
};

}  // namespace rivulet::streaming
