// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a run is in its program, and what is left of it. @threadsafety plain values.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>

namespace rivulet::widgets {

/// Estimated for the axes of one machine; what somebody turns at the control is not in it.
struct TimeLeft {
  double totalS = 0.0;
  double pausesS = 0.0;  ///< part of it that the pauses cost
  // Of a whole job, also parts of it: what its blocks for the control take.
  double toolChangesS = 0.0;
  double nativeS = 0.0;  ///< the others, as far as they can be estimated
};

/// Where a whole job is.
struct JobProgress {
  std::size_t stretch = 0;  ///< that is streamed, or comes after the blocks in progress
  std::size_t stretches = 0;
  bool isNative = false;  ///< the control executes its own blocks
  std::size_t line = 0;   ///< of the block in progress; 0: not known
  QString block;          ///< as the program has it
  bool waitsForCycleStart = false;
  bool isDry = false;
};

/// What a control that is to stop may still execute.
struct MotionLeft {
  double lengthMm = 0.0;
  double seconds = 0.0;  ///< estimated, at an override of 100 %
};

struct RunProgress {
  /// Of the move that the tool is on, or of the last point that is known to be executed, from 1; 0:
  /// not known.
  std::size_t line = 0;
  std::size_t lines = 0;         ///< of the program; 0: none is loaded
  std::optional<TimeLeft> left;  ///< nothing: not known
  /// Of the points that the control has; nothing: not known.
  std::optional<MotionLeft> delivered = {};
  bool isLive = false;     ///< the lines are those of a live source
  std::size_t passed = 0;  ///< points that are executed, or that the tool has visibly passed
};

}  // namespace rivulet::widgets
