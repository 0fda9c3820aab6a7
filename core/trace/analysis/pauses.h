// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Standstills of the path: the feed goes to zero and back. Found after the run in the control's
/// own trace, or live in the feed values that the stream reads anyway.
/// @threadsafety pure functions and plain values; one detector, one thread.
#pragma once

#include <optional>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "trace/control_trace.h"
#include "trace/pause.h"

namespace rivulet::trace {

struct PauseOptions {
  /// The path is at standstill at this speed or below. No axis passes a hundredth of a mm/s slowly
  /// enough to be sampled there: at 1 m/s² it takes 10 µs.
  double standstillMmPerSMax = 0.01;
  /// Shorter ones are ignored: at a reversal the speed may be zero for one cycle without a stop.
  base::Duration durationMin = std::chrono::milliseconds{8};
};

/// Finds the pauses between the first and the last motion of a trace, sample by sample; origin
/// Measured.
///
/// A sample's feed is the speed of the cycle that ends at the sample. So the set point is at
/// standstill from the last moving sample, at which it arrives, to the last standing sample, after
/// which it leaves. `start` is the instant of the former; `duration` is the time between the two,
/// which is the number of standing samples times the cycle. A sample whose feed is not a number
/// counts as moving.
class PauseFinder {
 public:
  explicit PauseFinder(const PauseOptions& options = {}) : m_options(options) {}

  /// @param sample  the next one in time order
  /// @return the pause that this sample ended
  [[nodiscard]] std::optional<Pause> add(const ControlSample& sample);

 private:
  PauseOptions m_options;
  std::optional<base::Instant> m_lastMoving;
  std::optional<base::Instant> m_lastStanding;
};

/// The pauses of a whole trace, in time order.
[[nodiscard]] std::vector<Pause> findPauses(const ControlTrace& trace,
                                            const PauseOptions& options = {});

/// A pause found in samples that are far apart.
struct MeasuredPause {
  Pause pause;
  base::Duration uncertainty{};  ///< the true duration differs by at most this much
};

/// Finds pauses in feed samples at irregular times during a run. The moment at which the feed
/// becomes zero is known only to be between two samples: the middle is used, and half the time
/// between them is the uncertainty. The same applies to the end.
class LivePauseDetector {
 public:
  explicit LivePauseDetector(const PauseOptions& options = {}) : m_options(options) {}

  /// @param at  later than the sample before; an older or equal one is ignored
  /// @param feedMmPerS  path speed; a value that is not a number is ignored
  /// @return the pause that this sample ended, if it lasted long enough
  [[nodiscard]] std::optional<MeasuredPause> add(base::Instant at, double feedMmPerS);

  /// Estimated begin of the present standstill; nothing while the path moves or before the first
  /// motion.
  [[nodiscard]] std::optional<base::Instant> standingSince() const;

 private:
  PauseOptions m_options;
  std::optional<base::Instant> m_latest;
  std::optional<base::Instant> m_lastMoving;
  std::optional<base::Instant> m_firstStanding;
};

/// The feed as positions show it, where they are read more often than the feed: 0 while the tool
/// stands, and a feed again when it leaves.
class StandstillByPosition {
 public:
  /// @param at  not before the position before it  @param feedMmPerS  that is programmed, > 0
  /// @return feed in mm/s at a change between standing and moving, and while it stands; nothing:
  ///         it moves on, or the positions are too close in time to tell
  [[nodiscard]] std::optional<double> add(base::Instant at, base::Vec3 positionMm,
                                          double feedMmPerS);

 private:
  struct Sample {
    base::Instant at{};
    base::Vec3 positionMm;
  };
  std::optional<Sample> m_before;
  bool m_stands = false;
};

}  // namespace rivulet::trace
