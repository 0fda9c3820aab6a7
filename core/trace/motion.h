// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the axes did, sample by sample, from whatever trace: the input of every analysis.
/// @threadsafety plain values; pure functions.
#pragma once

#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "trace/control_trace.h"
#include "trace/import/import.h"
#include "trace/motion_samples.h"
#include "trace/signals.h"

namespace rivulet::trace {

struct Motion {
  MotionSamples samples;             ///< times strictly ascending
  std::vector<ControlEvent> events;  ///< what the control recorded besides
  std::vector<SignalEvent> notes;    ///< what an imported file says besides
  base::Duration step{};             ///< median time between two samples
  bool hasSet = false;
  bool hasActual = false;
  /// The path speed was recorded. False: it comes from the positions, and the resolution of these
  /// limits it.
  bool hasSpeed = false;
  bool hasLine = false;
  bool hasFeed = false;
  bool hasOverride = false;

  /// The set point, or the actual position where no set point was recorded.
  [[nodiscard]] base::Vec3 placeMm(const MotionSample& sample) const {
    return hasSet ? sample.setMm : sample.actualMm;
  }
};

/// The signals that have a role, on the time base of the positions with the most samples. Signals
/// of another time base are interpolated; an axis that was not recorded stands at 0; samples
/// without position are left out. Of several sections, the longest. Nothing has a position:
/// `samples` is empty.
[[nodiscard]] Motion motionOf(const ImportedTrace& imported);

/// Set points, actual positions, speed and lines. The feed of the program is not known.
[[nodiscard]] Motion motionOf(const ControlTrace& trace);

}  // namespace rivulet::trace
