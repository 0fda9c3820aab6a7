// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How far a live run is, as its source is told. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/vec3.h"

namespace rivulet::live {

struct Progress {
  std::size_t accepted = 0;  ///< points
  std::size_t executed = 0;  ///< points
  std::size_t line = 0;      ///< of the last point that was executed; 0: none
  std::size_t merged = 0;    ///< points that were too close to the one before
  base::Vec3 positionMm;     ///< of the last point that was executed; at first that of the tool

  /// What becomes of a factor, for the source that sends it: accepted factors are counted above.
  struct Feed {
    double percent = 0.0;                ///< override in force, as it was read last
    std::optional<double> feedMmPerMin;  ///< of the path, measured
  };
  std::optional<Feed> feed = std::nullopt;

  struct End {
    std::string outcome;  ///< "completed", "stopped", ...
    std::string error;    ///< empty: none
  };
  std::optional<End> end = std::nullopt;  ///< nothing: the run is in progress
};

/// As one line of JSON with its end.
[[nodiscard]] std::string progressLine(const Progress& progress);

}  // namespace rivulet::live
