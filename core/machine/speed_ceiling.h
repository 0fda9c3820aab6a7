// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The speed along a path of many sections, each with its own limits of speed, acceleration and
/// jerk. One jerk-limited motion covers them all: the acceleration is continuous across the joints.
/// Units mm, s. @threadsafety one object, one thread.
///
/// The ceiling. Going backwards from the end of the path, where it must be able to stop, the speed
/// climbs through each section as fast as its limits allow: the acceleration (backwards in time)
/// grows with the jerk limit, holds, and fades so that it is zero at the section's speed limit. The
/// result is a braking motion that keeps every limit: a motion that is on the ceiling can stay on
/// it up to the end. If the climb would exceed the limits of the preceding section, the ceiling is
/// cut: the joint gets its own state (speed and acceleration), and the climb starts again from
/// there. In forward direction the ceiling jumps up at such a joint, and the motion below it may
/// climb again.
///
/// Safe states. A motion with a share of the ceiling's speed at some place, and with the square of
/// that share of its acceleration, can continue as the ceiling does in slower time: with less
/// speed, acceleration and jerk everywhere. So a state is safe if the motion gets there within all
/// limits: by letting the acceleration fall with the jerk limit if it loses less speed in
/// proportion than the ceiling does at the same place, otherwise by letting it rise. (The ratio of
/// the two speeds is smallest where both lose speed alike, so only these places and the joints are
/// checked.) The states at the joints are chosen safe. So from a safe state there is always a
/// motion to a standstill that keeps all limits.
///
/// The motion. In each section it climbs as fast as it can for as long as its state is safe, then
/// lets the acceleration fall until it meets the ceiling tangentially, and follows it.
///
/// The states of the joints decide how close this comes to the shortest time. A joint that limits
/// both the motion before it and the motion after it is passed with the smaller of the slopes on
/// both sides, and with none if they differ in sign: as a bend of the speed limit is followed, and
/// the bottom of a dip is touched.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "machine/speed_profile.h"

namespace rivulet::machine {

/// Limits of one section of the path.
struct SpeedSection {
  double lengthMm = 0.0;                  ///< > 0
  double feedMmPerS = 0.0;                ///< > 0; scaled by the override
  double fastestMmPerS = 0.0;             ///< whatever the feed; > 0
  SpeedLimits limits;                     ///< both > 0 and finite
  double jointMmPerS = 0.0;               ///< highest speed at its start; 0: a stop
  double jointAccelerationMmPerS2 = 0.0;  ///< largest there, of either sign; >= 0
};

class SpeedCeiling {
 public:
  [[nodiscard]] std::size_t size() const { return m_sections.size(); }
  [[nodiscard]] const SpeedSection& section(std::size_t index) const {
    return m_sections[index].given;
  }
  /// Speed limit within a section, at the present override.
  [[nodiscard]] double capMmPerS(std::size_t index) const { return cap(m_sections[index]); }

  /// Replaces what lies behind the first `keep` sections, and plans anew.
  /// @return the first section whose ceiling has changed; size() if none has
  std::size_t replaceTail(std::size_t keep, const std::deque<SpeedSection>& tail);
  void popFront() { m_sections.pop_front(); }
  void clear() { m_sections.clear(); }
  /// @param factor  > 0
  void setOverride(double factor);
  [[nodiscard]] double override() const { return m_override; }

  /// Whether the path can be finished within all limits from here.
  /// @param reach  gets the last section the answer depends on, if that is further than before
  [[nodiscard]] bool isSafe(std::size_t index, double mm, const SpeedState& state,
                            std::size_t* reach = nullptr) const;
  /// The same at the end of the first section.
  [[nodiscard]] bool isSafeAtJoint(const SpeedState& state, std::size_t* reach = nullptr) const;
  /// A state at the end of the first section without what rounding has added to that of the joint.
  [[nodiscard]] SpeedState passJoint(const SpeedState& state) const;
  /// The fastest motion in the first section, to its end or to a place where to ask again.
  /// @param state  safe; what rounding has left of a violation is tolerated
  [[nodiscard]] SpeedProfile profile(double mm, const SpeedState& state, std::size_t* reach) const;

 private:
  struct Section {
    SpeedSection given;
    SpeedState reached;                ///< at its start, by climbing from the start of the path
    double forwardMmPerS2 = 0.0;       ///< acceleration allowed at its start, by what lies before
    double accelerationMmPerS2 = 0.0;  ///< the same by all
    SpeedState joint;                  ///< at its start
    SpeedProfile ceiling;              ///< over its whole length
  };
  /// Where a motion whose acceleration falls from a state on has got below the ceiling.
  struct Meeting {
    double marginMmPerS = 0.0;  ///< smallest one on the way; negative: the state is not safe
    std::size_t index = 0;
    double mm = 0.0;
    double gapMmPerS = 0.0;  ///< there
  };

  [[nodiscard]] double cap(const Section& section) const;
  [[nodiscard]] SpeedState jointAfter(std::size_t index) const;
  [[nodiscard]] double accelerationAfter(std::size_t index) const;
  void reachForward(std::size_t from);
  std::size_t planBackwards(std::size_t from, bool everything);
  [[nodiscard]] SpeedState chooseJoint(std::size_t index) const;
  [[nodiscard]] Meeting meet(std::size_t index, double mm, const SpeedState& state) const;

  std::deque<Section> m_sections;
  double m_override = 1.0;
};

}  // namespace rivulet::machine
