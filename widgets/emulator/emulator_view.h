// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the page of the emulator shows, as values. @threadsafety plain values.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "emulator/emulator.h"
#include "emulator/identification.h"
#include "emulator/limits.h"

namespace rivulet::widgets {

/// A recording that the operator has chosen.
struct RecordingView {
  enum class State {
    Reading,
    Ready,
    NeedsProgram,  ///< it has no set points of its own
  };
  QString trace;    ///< file
  QString program;  ///< file; empty: none
  bool isForTest = false;
  State state = State::Reading;
  // When it is ready:
  double lengthS = 0.0;
  double samplesPerS = 0.0;
  std::string axes;  ///< letters of those that move
  double feedMmPerSMax = 0.0;
};

/// An emulator with what it was tested on.
struct EmulatorView {
  emulator::Emulator emulator;
  std::vector<emulator::RunFit> learnedFrom;
  std::vector<emulator::RunFit> unseen;      ///< of runs that it was not learned from
  double feedMmPerSMax = 0.0;                ///< of those that it was learned from
  std::vector<emulator::AxisLimits> limits;  ///< of the machine's planner, as its set points show
};

}  // namespace rivulet::widgets
