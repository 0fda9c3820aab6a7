// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The levels of the buffers over time, for a picture: the lowest and the highest level of each
/// stretch of time. The stretches get longer as the run does, so that memory and picture stay
/// small, and no peak is lost. @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/instant.h"
#include "pipeline/task.h"

namespace rivulet::pipeline {

class LevelHistory {
 public:
  /// A stretch of time.
  struct Stretch {
    std::array<int, kBufferCount> least{};
    std::array<int, kBufferCount> greatest{};
  };

  /// Most stretches that are kept; even.
  static constexpr std::size_t kStretches = 400;

  /// @param at  not earlier than the last one @param levels  from then on
  void add(base::Instant at, const std::array<int, kBufferCount>& levels);
  /// In the order of time, each `length()` long.
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return m_stretches; }
  [[nodiscard]] base::Duration length() const { return m_length; }

 private:
  void halve();

  base::Duration m_length = base::fromMilliseconds(10.0);
  std::vector<Stretch> m_stretches;
  std::array<int, kBufferCount> m_levels{};
};

}  // namespace rivulet::pipeline
