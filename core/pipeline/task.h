// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The six tasks of the pipeline and what they tell the scheduler. @threadsafety plain values.
/// @source [P3] Fig. 4
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/result.h"

namespace rivulet::pipeline {

/// In the order of the data; task n fills ring buffer Bn and empties B(n-1), counted from 1.
enum class Task : std::uint8_t { Receive, Interpret, Discrete, LookAhead, Interpolate, Position };

inline constexpr std::size_t kTaskCount = 6;
inline constexpr std::size_t kBufferCount = kTaskCount - 1;

/// As [P3] and its net name them.
inline constexpr std::array<std::string_view, kTaskCount> kTaskNames{
    "G code receiving", "interpreter",   "discrete",
    "forward-looking",  "interpolation", "position control"};

[[nodiscard]] constexpr std::size_t indexOf(Task task) {
  return static_cast<std::size_t>(task);
}
[[nodiscard]] constexpr std::string_view nameOf(Task task) {
  return kTaskNames[indexOf(task)];
}

/// What a task needs for its next step.
enum class Need : std::uint8_t {
  Data,     ///< an item of the buffer before it
  Nothing,  ///< it goes on with what it has
  Input,    ///< something from outside the pipeline
  Ended,    ///< there is no next step
};

/// What a step has done. It takes an item exactly if it needed one, and makes one at most.
struct StepDone {
  bool made = false;
  Need next = Need::Ended;
};

/// A task as a function that is called step by step.
class Stage {
 public:
  virtual ~Stage() = default;
  [[nodiscard]] virtual Need need() const = 0;
  /// To be called only if what it needs is there, and room for one item in the buffer after it.
  /// @return RingRubbish, SetPointMissing, BudgetError::Exceeded
  [[nodiscard]] virtual base::Result<StepDone> step() = 0;
};

}  // namespace rivulet::pipeline
