// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A Petri net as it is played, as the window shows it. @threadsafety plain values.
#pragma once

#include <QPointF>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "petri/marking.h"
#include "petri/net.h"

namespace rivulet::widgets {

inline constexpr std::size_t kShownBuffers = 5;  ///< B1 to B5

struct NetState {
  std::shared_ptr<const petri::Net> net;  ///< null: there is none
  petri::Marking marking;
  petri::Word now = 0;  ///< in the net's unit
  std::uint64_t firings = 0;
  std::vector<bool> enabled;         ///< by transition: could fire now
  std::optional<std::size_t> next;   ///< fires next; none: nothing can, or the time is over
  std::optional<std::size_t> fired;  ///< fired last
  bool isPlaying = false;
  /// Level of each buffer over time, s: points of a line.
  std::array<std::vector<QPointF>, kShownBuffers> levels;
};

/// What the operator can choose for the net.
struct NetChoice {
  int cycleMs = 10;  ///< of position control
  int policy = 0;    ///< 0: task dependency; 1: data flow
};

}  // namespace rivulet::widgets
