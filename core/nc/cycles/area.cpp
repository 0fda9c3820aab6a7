// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/cycles/area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rivulet::nc {

namespace {

using base::Vec3;

constexpr double kAreaRadPerDeg = std::numbers::pi / 180.0;
constexpr double kPiecesMax = 2000.0;
constexpr double kAreaRounding = 1e-9;
/// Rings with corners leave nothing between them up to 1/√2 of the diameter.
constexpr double kRingsWidest = 0.7;
/// Slope of a helix or ramp, about 3 degrees.
constexpr double kSlope = 0.05;
/// Of the radius of the tool: a helix of at least this radius, and of at most its own.
constexpr double kHelixLeast = 0.1;

}  // namespace

void AreaMill::place(double first, double second, double degrees) {
  m_originFirst = first;
  m_originSecond = second;
  m_cos = std::cos(degrees * kAreaRadPerDeg);
  m_sin = std::sin(degrees * kAreaRadPerDeg);
}

void AreaMill::approach(double u, double v) {
  rapid(u, v, m_planes.retraction);
  rapid(u, v, safetyHeight());
}

void AreaMill::retract(double u, double v) {
  rapid(u, v, safetyHeight());
  rapid(u, v, m_planes.retraction);
}

void AreaMill::rapid(double u, double v, double height) {
  add({.kind = CycleStep::Kind::Rapid, .toMm = at(u, v, height)});
}

void AreaMill::cut(double u, double v, double height, double feed) {
  add({.kind = CycleStep::Kind::Feed, .toMm = at(u, v, height), .feedMmPerS = feed});
}

void AreaMill::add(CycleStep step) {
  m_isFull = m_isFull || m_steps.size() >= m_stepsMax;
  if (!m_isFull) {
    m_steps.push_back(step);
  }
}

Vec3 AreaMill::at(double u, double v, double height) const {
  v *= m_side;
  Vec3 place;
  place.set(m_first, m_originFirst + u * m_cos - v * m_sin);
  place.set((m_first + 1) % base::kAxisCount, m_originSecond + u * m_sin + v * m_cos);
  place.set((m_first + 2) % base::kAxisCount, height);
  return place;
}

std::vector<double> AreaMill::levels(double infeed) const {
  const double wanted = infeed > 0.0 ? std::ceil(m_planes.depth / infeed - kAreaRounding) : 1.0;
  const double count = std::clamp(wanted, 1.0, kAreaLinesMax);
  std::vector<double> heights;
  for (double level = 1.0; level <= count; ++level) {
    heights.push_back(m_planes.reference - m_planes.up * m_planes.depth * level / count);
  }
  return heights;
}

double AreaMill::lines(double width, double apart, double widest) const {
  const double most = widest * 2.0 * m_radius;
  const double step = apart > 0.0 && (most == 0.0 || apart < most) ? apart : most;
  return step > 0.0 ? std::clamp(std::ceil(width / step - kAreaRounding), 1.0, kAreaLinesMax) : 1.0;
}

void AreaMill::ring(double halfU, double halfV, double corner, double height, double feed) {
  const double round = std::clamp(corner, 0.0, std::min(halfU, halfV));
  cut(halfU, 0.0, height, feed);
  static constexpr std::array<std::pair<double, double>, 4> kCorners{
      {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    const auto [u, v] = kCorners[i];
    arc(u * (halfU - round), v * (halfV - round), round, 90.0 * static_cast<double>(i), 90.0,
        height, feed);
  }
  cut(halfU, 0.0, height, feed);
}

void AreaMill::spiral(double u, double v, double radius, double fromDegrees, double sweepDegrees,
                      double fromHeight, double toHeight, double feed) {
  const double piece = radius > m_chord ? 2.0 * std::acos(1.0 - m_chord / radius) : 10.0;
  const double pieces =
      std::clamp(std::ceil(std::abs(sweepDegrees) * kAreaRadPerDeg / piece - kAreaRounding), 1.0,
                 std::max(kPiecesMax, std::abs(sweepDegrees)));
  for (double i = 0.0; i <= pieces; ++i) {
    const double angle = (fromDegrees + sweepDegrees * i / pieces) * kAreaRadPerDeg;
    cut(u + radius * std::cos(angle), v + radius * std::sin(angle),
        fromHeight + (toHeight - fromHeight) * i / pieces, feed);
  }
}

std::vector<CycleStep> AreaMill::take() {
  return std::exchange(m_steps, {});
}

namespace {

/// Down to a level, in the middle of a room for the centre of the tool. @return false: no room
bool enter(AreaMill& mill, double roomU, double roomV, double from, double to,
           const Clearing& how) {
  const double down = std::abs(to - from);
  if (how.entry == AreaEntry::Straight || !(down > 0.0)) {
    mill.cut(0.0, 0.0, to, how.depthFeed);
    return true;
  }
  mill.cut(0.0, 0.0, from, how.depthFeed);
  const double helix = std::min({roomU, roomV, mill.radius()});
  if (how.entry == AreaEntry::Helix && helix > kHelixLeast * mill.radius() && helix > 0.0) {
    const double turns =
        std::max(1.0, std::ceil(down / (2.0 * std::numbers::pi * helix * kSlope) - kAreaRounding));
    mill.cut(helix, 0.0, from, how.depthFeed);
    mill.spiral(0.0, 0.0, helix, 0.0, 360.0 * turns, from, to, how.depthFeed);
    mill.arc(0.0, 0.0, helix, 0.0, 360.0, to, how.depthFeed);
    mill.cut(0.0, 0.0, to, how.depthFeed);
    return true;
  }
  // To and fro, along the longer side.
  const bool alongU = roomU >= roomV;
  const double half = std::min(std::max(roomU, roomV), 2.0 * mill.radius());
  if (!(half > 0.0) || !(half > kHelixLeast * mill.radius())) {
    return false;
  }
  const double strokes = std::max(1.0, std::ceil(down / (2.0 * half * kSlope) - kAreaRounding));
  const auto go = [&](double place, double height) {
    mill.cut(alongU ? place : 0.0, alongU ? 0.0 : place, height, how.depthFeed);
  };
  double side = 1.0;
  go(half, from);
  for (double stroke = 1.0; stroke <= strokes; ++stroke) {
    side = -side;
    go(side * half, from + (to - from) * stroke / strokes);
  }
  go(-side * half, to);  // what the last stroke has left
  go(0.0, to);
  return true;
}

}  // namespace

bool clearRectangle(AreaMill& mill, double halfU, double halfV, double corner,
                    const Clearing& how) {
  const double offset = mill.radius() + (how.roughs ? how.allowance : 0.0);
  if (offset > std::min(halfU, halfV) + kAreaRounding) {
    return false;
  }
  const double outerU = std::max(halfU - offset, 0.0);
  const double outerV = std::max(halfV - offset, 0.0);
  const double round = std::max(corner - offset, 0.0);
  const double least = std::min(outerU, outerV);
  const double count = how.roughs ? mill.lines(least, how.apart, kRingsWidest) : 1.0;
  double above = mill.planes().reference;
  for (const double height : mill.levels(how.infeed)) {
    if (!enter(mill, outerU, outerV, above, height, how)) {
      return false;
    }
    // To a wall that is finished, and away from it, on quarter circles.
    const double arrival = how.roughs ? 0.0 : std::min(least, mill.radius());
    if (arrival > 0.0) {
      mill.cut(outerU - arrival, -arrival, height, how.feed);
      mill.arc(outerU - arrival, 0.0, arrival, -90.0, 90.0, height, how.feed);
    }
    // The innermost ring is closed as far as the tool reaches, or has a line within it.
    const bool isOpen = how.roughs && least / count > mill.radius() && mill.radius() > 0.0;
    for (double line = isOpen ? count : count - 1.0; line >= 0.0; --line) {
      const double inset = least * line / count;
      mill.ring(outerU - inset, outerV - inset, std::max(round - inset, 0.0), height, how.feed);
    }
    if (how.roughs && how.finishes && how.allowance > 0.0) {
      mill.ring(halfU - mill.radius(), halfV - mill.radius(), std::max(corner - mill.radius(), 0.0),
                height, how.feed);
    }
    if (arrival > 0.0) {
      mill.arc(outerU - arrival, 0.0, arrival, 0.0, 90.0, height, how.feed);
    }
    mill.cut(0.0, 0.0, height, how.feed);
    above = height;
  }
  return true;
}

bool clearArc(AreaMill& mill, double radius, double fromDegrees, double sweepDegrees, double width,
              const Clearing& how) {
  const double beside = width / 2.0 - mill.radius() - (how.roughs ? how.allowance : 0.0);
  if (beside < -kAreaRounding || beside > radius) {
    return false;
  }
  const double toDegrees = fromDegrees + sweepDegrees;
  const double cap = sweepDegrees < 0.0 ? -180.0 : 180.0;
  const auto placeAt = [radius](double degrees) {
    return std::pair(radius * std::cos(degrees * kAreaRadPerDeg),
                     radius * std::sin(degrees * kAreaRadPerDeg));
  };
  const auto [startU, startV] = placeAt(fromDegrees);
  const auto [endU, endV] = placeAt(toDegrees);
  const double rings =
      how.roughs ? mill.lines(std::max(beside, 0.0), how.apart, kRingsWidest) : 1.0;
  double above = mill.planes().reference;
  for (const double height : mill.levels(how.infeed)) {
    if (how.entry == AreaEntry::Straight) {
      mill.cut(startU, startV, height, how.depthFeed);
    } else {
      // To and fro along the slot.
      const double length = std::abs(sweepDegrees) * kAreaRadPerDeg * radius;
      if (!(length > 0.0)) {
        return false;
      }
      const double strokes =
          2.0 * std::max(1.0, std::ceil(std::abs(height - above) / (2.0 * length * kSlope)));
      mill.cut(startU, startV, above, how.depthFeed);
      for (double stroke = 0.0; stroke < strokes; ++stroke) {
        const bool isBack = std::fmod(stroke, 2.0) == 1.0;
        mill.spiral(0.0, 0.0, radius, isBack ? toDegrees : fromDegrees,
                    isBack ? -sweepDegrees : sweepDegrees,
                    above + (height - above) * stroke / strokes,
                    above + (height - above) * (stroke + 1.0) / strokes, how.depthFeed);
      }
    }
    if (how.roughs) {
      mill.arc(0.0, 0.0, radius, fromDegrees, sweepDegrees, height, how.feed);
      mill.arc(0.0, 0.0, radius, toDegrees, -sweepDegrees, height, how.feed);
    }
    for (double ring = 1.0; ring <= rings && beside > kAreaRounding; ++ring) {
      const double out = beside * ring / rings;
      mill.arc(0.0, 0.0, radius + out, fromDegrees, sweepDegrees, height, how.feed);
      mill.arc(endU, endV, out, toDegrees, cap, height, how.feed);
      mill.arc(0.0, 0.0, radius - out, toDegrees, -sweepDegrees, height, how.feed);
      mill.arc(startU, startV, out, fromDegrees + 180.0, cap, height, how.feed);
    }
    mill.cut(startU, startV, height, how.feed);
    above = height;
  }
  return true;
}

double startOf(const AreaMill& mill, const Spigot& spigot, const Clearing& how) {
  const double offset = mill.radius() + (how.roughs ? how.allowance : 0.0);
  return std::max(spigot.halfU + offset, spigot.blankHalfU) + mill.radius() + spigot.outside;
}

void clearAround(AreaMill& mill, const Spigot& spigot, const Clearing& how) {
  const double offset = mill.radius() + (how.roughs ? how.allowance : 0.0);
  const double outside = startOf(mill, spigot, how);
  // What stands outside the innermost ring.
  const double left = how.roughs ? std::max({spigot.blankHalfU - spigot.halfU - how.allowance,
                                             spigot.blankHalfV - spigot.halfV - how.allowance, 0.0})
                                 : 0.0;
  const double count = left > 0.0 ? mill.lines(left, how.apart, kRingsWidest) : 1.0;
  for (const double height : mill.levels(how.infeed)) {
    mill.cut(outside, 0.0, height, how.depthFeed);
    for (double line = count - 1.0; line >= 0.0; --line) {
      const double out = offset + left * line / count;
      mill.ring(spigot.halfU + out, spigot.halfV + out, spigot.corner + out, height, how.feed);
    }
    mill.cut(outside, 0.0, height, how.feed);
  }
}

void clearFace(AreaMill& mill, const Face& face) {
  /// Straight lines leave nothing between them up to the diameter.
  constexpr double kWidest = 0.8;
  const double along = face.alongSecond ? face.width : face.length;
  const double across = face.alongSecond ? face.length : face.width;
  const double beyond = std::copysign(face.beyond, along);
  const double count = mill.lines(std::abs(across), face.apart, kWidest);
  const auto u = [&](double a, double c) { return face.alongSecond ? c : a; };
  const auto v = [&](double a, double c) { return face.alongSecond ? a : c; };
  const auto lineAt = [&](double line) { return across * (line + 0.5) / count; };
  double from = -beyond;
  double to = along + beyond;
  double lastC = lineAt(0.0);
  mill.approach(u(from, lastC), v(from, lastC));
  for (const double height : mill.levels(face.infeed)) {
    for (double line = 0.0; line < count; ++line) {
      const double c = lineAt(line);
      if (line == 0.0 || !face.alternates) {
        mill.rapid(u(from, c), v(from, c), mill.safetyHeight());
      }
      mill.cut(u(from, c), v(from, c), height, face.feed);
      mill.cut(u(to, c), v(to, c), height, face.feed);
      lastC = c;
      if (face.alternates) {
        std::swap(from, to);
      } else {
        mill.rapid(u(to, c), v(to, c), mill.safetyHeight());
      }
    }
    const double end = face.alternates ? from : to;
    mill.rapid(u(end, lastC), v(end, lastC), mill.safetyHeight());
    from = -beyond;
    to = along + beyond;
  }
  const double end = face.alternates && std::fmod(count, 2.0) == 0.0 ? from : to;
  mill.retract(u(end, lastC), v(end, lastC));
}

}  // namespace rivulet::nc
