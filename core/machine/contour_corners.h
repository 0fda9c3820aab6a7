// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Corners of the contour that a program rounds or chamfers (RND, RNDM, CHF, CHR): Programming
/// Manual Fundamentals of the 840D sl, chapter Chamfer and rounding. The motion before the corner
/// is held back until the next one is known; what the program does in between waits with it.
/// @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "base/vec3.h"
#include "machine/alarm.h"
#include "machine/prepared.h"

namespace rivulet::machine {

struct ContourCorner {
  enum class Kind {
    Radius,   ///< RND, RNDM: `mm` is the radius
    Chamfer,  ///< CHF: its length
    Cut,      ///< CHR: how much of each side it takes
  };
  Kind kind = Kind::Radius;
  double mm = 0.0;  ///< > 0
};

class ContourCorners {
 public:
  /// @param startMm  where the axes stand
  explicit ContourCorners(base::Vec3 startMm) : m_atMm(startMm) {}

  /// Takes the next of what a program does; what is ready is appended to `ready`. A corner is made
  /// smaller where a straight side is too short for it, as the control does.
  /// @param corner  at the end of this motion @param firstAxis  of the plane
  /// @return alarm for a corner that is not made: a chamfer or too great a radius at an arc
  [[nodiscard]] std::optional<Alarm> add(Prepared next, std::optional<ContourCorner> corner,
                                         std::size_t firstAxis, std::deque<Prepared>& ready);
  /// Outside a corner: only notes where the axes go.
  void pass(const Prepared& next) {
    if (const auto* const motion = std::get_if<PreparedMotion>(&next)) {
      m_atMm = motion->targetMm;
    }
  }
  /// No motion follows: the contour ends without a corner.
  void finish(std::deque<Prepared>& ready);
  /// True if a motion is held back.
  [[nodiscard]] bool isActive() const { return m_held.has_value(); }

 private:
  struct Held {
    PreparedMotion motion;
    base::Vec3 fromMm;
    ContourCorner corner;
    std::size_t firstAxis = 0;
  };
  [[nodiscard]] std::optional<Alarm> join(PreparedMotion& next, std::deque<Prepared>& ready);

  base::Vec3 m_atMm;  ///< end of the last motion, as programmed
  std::optional<Held> m_held;
  std::deque<Prepared> m_behind;
};

}  // namespace rivulet::machine
