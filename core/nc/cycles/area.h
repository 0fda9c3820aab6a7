// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a tool clears an area: pockets, slots, spigots, faces and milled threads, in a system of
/// their own that is turned about a place. The cycles of SINUMERIK and of Heidenhain give extent,
/// depth, infeeds, planes and feeds; the way in between is the same for both and is not the
/// control's, which no manual tells in full: rings from the middle outwards. One unit for all
/// lengths; a feed is a number that is passed on, 0: the programmed one. @threadsafety plain
/// values.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "base/axes.h"
#include "base/vec3.h"
#include "nc/cycles/drilling.h"

namespace rivulet::nc {

/// Infeeds, and lines beside each other: there are never more, so that each is farther than asked.
inline constexpr double kAreaLinesMax = 1000.0;

/// Heights along the tool.
struct AreaPlanes {
  double retraction = 0.0;  ///< where the tool may cross the workpiece
  double reference = 0.0;   ///< the surface
  double safety = 0.0;      ///< distance above it from which the tool is fed
  double depth = 0.0;       ///< below it, >= 0
  double up = 1.0;          ///< direction away from the workpiece: 1 or -1
};

class AreaMill {
 public:
  /// @param chord  greatest distance of chords from their arc, > 0
  AreaMill(double toolRadius, std::size_t planeFirstAxis, double chord)
      : m_radius(toolRadius), m_first(planeFirstAxis), m_chord(chord) {}

  [[nodiscard]] double radius() const { return m_radius; }
  [[nodiscard]] const AreaPlanes& planes() const { return m_planes; }
  [[nodiscard]] double safetyHeight() const {
    return m_planes.reference + m_planes.up * m_planes.safety;
  }
  void setPlanes(const AreaPlanes& planes) { m_planes = planes; }

  /// The origin of u and v, and how far u is turned from the first axis of the plane.
  void place(double first, double second, double degrees);
  /// Rings, arcs and spirals run counterclockwise about the tool, or the other way.
  void turnClockwise(bool clockwise) { m_side = clockwise ? -1.0 : 1.0; }

  /// Above the place, then down to the safety distance.
  void approach(double u, double v);
  void retract(double u, double v);
  void rapid(double u, double v, double height);
  void cut(double u, double v, double height, double feed);
  /// Around a rectangle about the place, with round corners, from (halfU, 0) and back there.
  void ring(double halfU, double halfV, double corner, double height, double feed);
  void arc(double u, double v, double radius, double fromDegrees, double sweepDegrees,
           double height, double feed) {
    spiral(u, v, radius, fromDegrees, sweepDegrees, height, height, feed);
  }
  /// An arc that rises or falls evenly.
  void spiral(double u, double v, double radius, double fromDegrees, double sweepDegrees,
              double fromHeight, double toHeight, double feed);

  /// Heights of the infeeds, evenly, the depth last. @param infeed  greatest; 0: the depth at once
  [[nodiscard]] std::vector<double> levels(double infeed) const;
  /// How many lines fill a width. @param apart  greatest distance; 0: as the tool is wide
  /// @param widest  of the diameter of the tool: how far lines may be apart at most
  [[nodiscard]] double lines(double width, double apart, double widest) const;

  /// Steps beyond these are left out: whoever sets a limit asks whether it has been reached.
  void limitSteps(std::size_t most) { m_stepsMax = most; }
  [[nodiscard]] bool isFull() const { return m_isFull; }
  [[nodiscard]] std::vector<CycleStep> take();

 private:
  void add(CycleStep step);
  [[nodiscard]] base::Vec3 at(double u, double v, double height) const;

  double m_radius;
  std::size_t m_first;
  double m_chord;
  AreaPlanes m_planes;
  double m_originFirst = 0.0;
  double m_originSecond = 0.0;
  double m_cos = 1.0;
  double m_sin = 0.0;
  double m_side = 1.0;
  std::size_t m_stepsMax = std::numeric_limits<std::size_t>::max();
  bool m_isFull = false;
  std::vector<CycleStep> m_steps;
};

/// How the tool comes down to the next infeed.
enum class AreaEntry : unsigned char { Straight, Helix, Ramp };

/// What a pocket or slot is cleared with.
struct Clearing {
  double infeed = 0.0;
  double apart = 0.0;      ///< of rings, see `AreaMill::lines`
  double allowance = 0.0;  ///< at the edge, left by roughing
  bool roughs = true;
  bool finishes = false;
  double feed = 0.0;
  double depthFeed = 0.0;  ///< downwards
  AreaEntry entry = AreaEntry::Straight;
};

/// Clears a rectangle about the place, with round corners, from the safety height on; the tool ends
/// in the middle at the depth. @return false: the tool, or its helix or ramp, does not fit
[[nodiscard]] bool clearRectangle(AreaMill& mill, double halfU, double halfV, double corner,
                                  const Clearing& how);

/// Along a circle about the place, as a slot with round ends; the tool ends at the middle of the
/// first end, at the depth. @return false: the tool does not fit
[[nodiscard]] bool clearArc(AreaMill& mill, double radius, double fromDegrees, double sweepDegrees,
                            double width, const Clearing& how);

struct Spigot {
  double halfU = 0.0;
  double halfV = 0.0;
  double corner = 0.0;
  double blankHalfU = 0.0;  ///< of the workpiece before; 0: one ring is enough
  double blankHalfV = 0.0;
  double outside = 0.0;  ///< how far the tool stays away from the blank where it comes down
};
/// Around a spigot about the place, from outside, from the safety height on.
/// @return where the tool comes down and goes up, u
[[nodiscard]] double startOf(const AreaMill& mill, const Spigot& spigot, const Clearing& how);
void clearAround(AreaMill& mill, const Spigot& spigot, const Clearing& how);

struct Face {
  double length = 0.0;  ///< with its sign
  double width = 0.0;
  double beyond = 0.0;  ///< how far outside lines begin and end
  double apart = 0.0;
  double infeed = 0.0;
  double feed = 0.0;
  bool alternates = true;
  bool alongSecond = false;
};
/// Lines beside each other, which begin and end outside the face; with approach and retraction.
void clearFace(AreaMill& mill, const Face& face);

}  // namespace rivulet::nc
