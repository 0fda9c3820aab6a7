// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Tool radius compensation (G41, G42): the centre of the tool goes beside the programmed path, by
/// its radius. Where a block ends depends on the next one, so a motion is held back until the next
/// motion in the plane is known; what the program does in between waits with it.
/// Alarms as on the control: 10751 danger of a collision, 10753 and 10754 selected and deselected
/// in a straight line only, 10757 the plane must not change. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "base/vec3.h"
#include "machine/alarm.h"
#include "machine/prepared.h"

namespace rivulet::machine {

struct Compensation {
  int side = 0;  ///< 1 left of the path (G41), -1 right (G42), 0 none (G40)
  double radiusMm = 0.0;
  std::size_t firstAxis = 0;  ///< of the plane
  bool goesAround = false;    ///< KONT: not made where it differs from NORM
  bool intersects = false;    ///< G451: outer corners end at the intersection; else with a circle

  friend bool operator==(const Compensation&, const Compensation&) = default;
};

class RadiusCompensation {
 public:
  /// @param startMm  where the axes stand
  explicit RadiusCompensation(base::Vec3 startMm) : m_programmedMm(startMm), m_atMm(startMm) {}

  /// Takes the next of what a program does; what is ready is appended to `ready`.
  /// @param wanted  in effect in its block
  [[nodiscard]] std::optional<Alarm> add(Prepared next, const Compensation& wanted,
                                         std::deque<Prepared>& ready);
  /// Outside a compensation: only notes where the axes go.
  void pass(const Prepared& next) {
    if (const auto* const motion = std::get_if<PreparedMotion>(&next)) {
      m_programmedMm = motion->targetMm;
      m_atMm = motion->targetMm;
    }
  }
  /// What has been held back ends at right angles to the path: nothing is known of the next block.
  void finish(std::deque<Prepared>& ready);
  /// True if motions are changed or held back.
  [[nodiscard]] bool isActive() const { return m_active.has_value(); }

 private:
  /// A place or direction in the plane.
  struct Point {
    double u = 0.0;
    double v = 0.0;
  };
  /// A motion in the plane.
  struct Element {
    PreparedMotion motion;
    Point from;         ///< programmed
    Point to;           ///< programmed
    Point centre;       ///< of an arc
    double turn = 0.0;  ///< 1 counterclockwise, -1 clockwise, 0 a line
    double radiusMm = 0.0;
    Point start;              ///< of the tool's centre
    bool approaches = false;  ///< G41 or G42 is selected with it
  };
  struct Corner {
    Point end;                      ///< of the element before
    Point start;                    ///< of the next one
    std::optional<Point> arcAbout;  ///< between them
    std::optional<Point> waypoint;  ///< straight over it
  };

  [[nodiscard]] std::optional<Alarm> addMotion(PreparedMotion motion, const Compensation& wanted,
                                               std::deque<Prepared>& ready);
  [[nodiscard]] std::optional<Alarm> select(Element element, const Compensation& wanted);
  [[nodiscard]] std::optional<Alarm> follow(Element element, std::deque<Prepared>& ready);
  [[nodiscard]] std::optional<Element> elementOf(PreparedMotion motion,
                                                 std::size_t firstAxis) const;
  [[nodiscard]] std::optional<Corner> cornerTo(const Element& next) const;
  [[nodiscard]] std::optional<Point> innerCorner(const Element& next) const;
  [[nodiscard]] Point beside(Point place, Point direction) const;
  [[nodiscard]] static Point startDirection(const Element& element);
  [[nodiscard]] static Point endDirection(const Element& element);
  [[nodiscard]] static bool isBehind(Point place, const Element& element, double way);
  [[nodiscard]] double offsetRadiusMm(const Element& element) const;
  void passOn(Point end, std::deque<Prepared>& ready);
  void passOver(const Corner& corner, const Element& next, std::deque<Prepared>& ready);
  void release(std::deque<Prepared>& ready);
  [[nodiscard]] base::Vec3 placed(base::Vec3 place, Point at) const;
  [[nodiscard]] Point inPlane(base::Vec3 place) const;

  std::optional<Compensation> m_active;
  std::optional<Element> m_held;
  std::deque<Prepared> m_behind;  ///< what waits behind the motion that is held back
  base::Vec3 m_programmedMm;      ///< end of the last motion, as programmed
  base::Vec3 m_atMm;              ///< where the tool's centre is after what is ready
};

}  // namespace rivulet::machine
