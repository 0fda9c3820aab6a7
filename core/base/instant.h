// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Time as data. `Instant` is a point on a clock that cannot be asked for the time: only a
/// `Link` (real or simulated) knows "now" and hands it on. @threadsafety plain values.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace rivulet::base {

using Duration = std::chrono::nanoseconds;

/// The time line of a run. It has no `now()` on purpose: asking the time does not compile.
struct Timeline {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<Timeline>;
  static constexpr bool is_steady = true;
};

using Instant = Timeline::time_point;

/// Seconds of a duration, for display, files and formulas.
[[nodiscard]] constexpr double toSeconds(Duration duration) {
  return static_cast<double>(duration.count()) * 1e-9;
}

/// Milliseconds of a duration.
[[nodiscard]] constexpr double toMilliseconds(Duration duration) {
  return static_cast<double>(duration.count()) * 1e-6;
}

/// Seconds since the origin of the time line.
[[nodiscard]] constexpr double toSeconds(Instant instant) {
  return toSeconds(instant.time_since_epoch());
}

/// Duration of `seconds`, rounded to the nearest nanosecond. @param seconds finite, |s| < 9e9
[[nodiscard]] inline Duration fromSeconds(double seconds) {
  return Duration{std::llround(seconds * 1e9)};
}

/// Duration of `milliseconds`, rounded to the nearest nanosecond.
[[nodiscard]] inline Duration fromMilliseconds(double milliseconds) {
  return Duration{std::llround(milliseconds * 1e6)};
}

}  // namespace rivulet::base
