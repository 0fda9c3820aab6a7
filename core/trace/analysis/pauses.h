// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Stand-stills of the path: feed to zero and back. Afterwards from the control's own trace, or
/// live from whatever feed values the stream happens to read.
/// @threadsafety pure functions and plain values; one detector, one thread.
#pragma once

#include <optional>
#include <vector>

#include "base/instant.h"
#include "trace/control_trace.h"
#include "trace/pause.h"

namespace rivulet::trace {

struct PauseOptions {
  /// The path stands at this speed or below. No axis crosses a hundredth of a mm/s slowly enough
  /// to be seen there: 1 m/s² passes it in 10 µs.
  double standstillMmPerSMax = 0.01;
  /// Shorter ones are left out: a reversal may touch zero for one cycle without any stop.
  base::Duration durationMin = std::chrono::milliseconds{8};
};

/// The pauses between the first and the last motion of a trace, in time order, origin Measured.
///
/// A sample's feed is the speed of the cycle that ends at the sample. So the set point stands
/// from the last moving sample, where it arrived, to the last standing sample, after which it
/// leaves: `start` is the instant of the former, `duration` the distance of the two, which is the
/// number of standing samples times the cycle. A sample whose feed is no number moves.
[[nodiscard]] std::vector<Pause> findPauses(const ControlTrace& trace,
                                            const PauseOptions& options = {});

/// A pause seen through samples that are far apart.
struct MeasuredPause {
  Pause pause;
  base::Duration uncertainty{};  ///< the true duration differs by at most this much
};

/// Finds pauses in feed samples that come at irregular times while the run lasts. Where the feed
/// went to zero is only known to lie between two samples: the middle is taken, and half the
/// distance is the uncertainty; likewise for the end.
class LivePauseDetector {
 public:
  explicit LivePauseDetector(const PauseOptions& options = {}) : m_options(options) {}

  /// @param at  later than the sample before; an older or equal one is ignored
  /// @param feedMmPerS  path speed; a value that is no number is ignored
  /// @return the pause that this sample ended, if it lasted long enough
  [[nodiscard]] std::optional<MeasuredPause> add(base::Instant at, double feedMmPerS);

  /// When the stand-still that lasts now began (estimated); nothing while the path moves and
  /// before the first motion.
  [[nodiscard]] std::optional<base::Instant> standingSince() const;

 private:
  PauseOptions m_options;
  std::optional<base::Instant> m_latest;
  std::optional<base::Instant> m_lastMoving;
  std::optional<base::Instant> m_firstStanding;
};

}  // namespace rivulet::trace
