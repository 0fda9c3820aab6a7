// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a run is in its program, and what is left of it. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <optional>

namespace rivulet::widgets {

/// Estimated for the axes of one machine; what somebody turns at the control is not in it.
struct TimeLeft {
  double totalS = 0.0;
  double pausesS = 0.0;  ///< part of it that the pauses cost
};

struct RunProgress {
  /// Line of the program of the last point that is known to be executed, from 1; 0: not known.
  std::size_t line = 0;
  std::size_t lines = 0;         ///< of the program; 0: none is loaded
  std::optional<TimeLeft> left;  ///< nothing: not known
};

}  // namespace rivulet::widgets
