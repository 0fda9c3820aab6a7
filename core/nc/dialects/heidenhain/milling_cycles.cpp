// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/dialects/heidenhain/milling_cycles.h"

#include <cmath>
#include <limits>
#include <utility>

#include "nc/cycles/area.h"
#include "nc/dialects/heidenhain/contour.h"

namespace rivulet::nc::heidenhain {

namespace {

constexpr double kChordMm = 0.004;
/// Of one call.
constexpr std::size_t kStepsMax = 300'000;
constexpr double kPitchesMax = 1000.0;

/// The radius of the tool, and the area that it clears about a place.
class Area {
 public:
  /// @param planes  heights of the cycle
  Area(Values& values, const AreaPlanes& planes)
      : m_values(values),
        m_start(values.situation().at),
        m_axis(values.situation().toolAxis),
        m_mill(values.q(108), first(), kChordMm * values.situation().millimetre) {
    m_mill.setPlanes(planes);
    m_mill.limitSteps(kStepsMax);
    if (m_mill.radius() < 0.0) {
      values.outOfRange(108);
    }
  }

  [[nodiscard]] AreaMill& mill() { return m_mill; }
  [[nodiscard]] double radius() const { return m_mill.radius(); }

  /// About a point beside the tool, in a system that is turned by an angle.
  void placeAt(Flat beside, double degrees) {
    placeAbout(here() + turned(beside, degrees), degrees);
  }
  void placeAbout(Flat place, double degrees) { m_mill.place(place.x, place.y, degrees); }
  /// Where the tool stands in the plane.
  [[nodiscard]] Flat here() {
    for (const std::size_t axis : {first(), second()}) {
      if (std::isnan(m_start[axis])) {
        m_values.note(
            {FaultCode::RelativeFromUnknownPosition, std::string(1, base::kAxisNames[axis]), {}});
      }
    }
    return {m_start[first()], m_start[second()]};
  }
  /// A climb cut has the workpiece on its right where the spindle turns clockwise.
  void climb(double climbs, bool isInside) { m_mill.turnClockwise((climbs < 0.0) == isInside); }

  /// Up, if the tool is too low, then across and down to the set-up clearance. What its height is
  /// behind a change of the tool, only the control knows: it goes across there.
  void approach(double u, double v) {
    const AreaPlanes& planes = m_mill.planes();
    const double from = m_start[m_axis];
    double height = from;
    if (from < planes.retraction) {
      height = planes.retraction;
      base::Vec3 risen = m_start;
      risen.set(m_axis, height);
      m_steps.push_back({.kind = CycleStep::Kind::Rapid, .to = risen});
    }
    m_mill.rapid(u, v, height);
    m_mill.rapid(u, v, m_mill.safetyHeight());
  }
  void retract(double u, double v) { m_mill.retract(u, v); }
  /// To where the tool stood in the plane.
  [[nodiscard]] Steps back() {
    take();
    base::Vec3 start = m_start;
    start.set(m_axis, m_mill.planes().retraction);
    m_steps.push_back({.kind = CycleStep::Kind::Rapid, .to = start});
    return std::move(m_steps);
  }

  /// The last steps.
  [[nodiscard]] Steps stay() {
    take();
    return std::move(m_steps);
  }

  [[nodiscard]] Steps doesNotFit() {
    m_values.refuse("tool radius");
    return {};
  }

 private:
  [[nodiscard]] std::size_t first() const { return (m_axis + 1) % base::kAxisCount; }
  [[nodiscard]] std::size_t second() const { return (m_axis + 2) % base::kAxisCount; }
  void take() {
    if (m_mill.isFull()) {
      m_values.refuse("number of moves");
    }
    for (const nc::CycleStep& each : m_mill.take()) {
      const bool isRapid = each.kind == nc::CycleStep::Kind::Rapid || each.feedMmPerS >= kFeedMax;
      m_steps.push_back({.kind = isRapid ? CycleStep::Kind::Rapid : CycleStep::Kind::Feed,
                         .to = each.toMm,
                         .feed = isRapid ? 0.0 : each.feedMmPerS});
    }
  }

  Values& m_values;
  base::Vec3 m_start;
  std::size_t m_axis;
  AreaMill m_mill;
  Steps m_steps;
};

AreaPlanes planesOf(const Drilling& hole) {
  return {.retraction = hole.retraction(),
          .reference = hole.surface(),
          .safety = hole.setUp(),
          .depth = hole.whole()};
}

/// What 251 to 257 have in common.
struct Work {
  bool roughs = true;
  bool finishes = false;
  double allowance = 0.0;       ///< at the side
  double floorAllowance = 0.0;  ///< on the ground
  double infeed = 0.0;
  double finishInfeed = 0.0;
  double feed = 0.0;
  double depthFeed = 0.0;
  double finishFeed = 0.0;
  double climbs = 1.0;
  AreaEntry entry = AreaEntry::Straight;

  explicit Work(Values& values) {
    // 0 roughs and finishes, 1 roughs, 2 finishes: what has an allowance.
    const double kind = values.q(215, 0.0);
    if (kind != 0.0 && kind != 1.0 && kind != 2.0) {
      values.outOfRange(215);
    }
    roughs = kind != 2.0;
    finishes = kind != 1.0;
    allowance = values.q(368, 0.0);
    floorAllowance = values.q(369, 0.0);
    infeed = values.q(202);
    finishInfeed = values.q(338, 0.0);
    feed = values.q(207);
    depthFeed = values.q(206);
    finishFeed = feedOr(values.q(385, 0.0), feed);
    climbs = values.q(351);
    checkFeed(values, 207, feed);
    checkFeed(values, 206, depthFeed);
    if (!(infeed > 0.0)) {
      values.outOfRange(202);
    }
    if (allowance < 0.0) {
      values.outOfRange(368);
    }
    if (floorAllowance < 0.0) {
      values.outOfRange(369);
    }
    if (climbs != 1.0 && climbs != -1.0) {
      values.outOfRange(351);  // 0: what GLOBAL DEF says
    }
    if (values.q(439, 0.0) != 0.0) {
      values.outOfRange(439);  // the feed is that of the edge
    }
  }
  /// Q366. @param one  what 1 means
  void enterBy(Values& values, AreaEntry one) {
    const double plunges = values.q(366, 0.0);
    if (plunges != 0.0 && plunges != 1.0 && plunges != 2.0) {
      values.outOfRange(366);
    }
    // A tool without a radius, as virtual machines have it, has no helix.
    const bool isKnown = values.q(108) > 0.0;
    entry = !isKnown || plunges == 0.0 ? AreaEntry::Straight
            : plunges == 1.0           ? one
                                       : AreaEntry::Ramp;
  }
  /// @param apart  of lines that fill a width; 0: as the tool is wide
  void limit(Values& values, Area& area, double width, double apart) const {
    const double depth = area.mill().planes().depth;
    if (depth / infeed > kAreaLinesMax) {
      values.outOfRange(202);
    }
    if (finishInfeed > 0.0 && depth / finishInfeed > kAreaLinesMax) {
      values.outOfRange(338);
    }
    if (width > kAreaLinesMax * (apart > 0.0 ? apart : area.radius()) && area.radius() > 0.0) {
      values.outOfRange(370);
    }
  }
  /// Roughing and finishing, each with the depth it reaches. @param clears  (how) → false: the tool
  /// does not fit
  template <class Clears>
  [[nodiscard]] bool run(Area& area, double apart, Clears clears) const {
    AreaPlanes planes = area.mill().planes();
    const double whole = planes.depth;
    const auto to = [&](double depth) {
      planes.depth = std::max(depth, 0.0);
      area.mill().setPlanes(planes);
    };
    Clearing how{.infeed = infeed,
                 .apart = apart,
                 .allowance = allowance,
                 .roughs = true,
                 .feed = feed,
                 .depthFeed = depthFeed,
                 .entry = entry};
    bool fits = true;
    if (roughs) {
      to(whole - floorAllowance);
      fits = clears(how);
    }
    how.entry = AreaEntry::Straight;
    how.feed = finishFeed;
    how.infeed = finishInfeed;
    to(whole);
    if (fits && finishes && allowance > 0.0) {
      how.roughs = false;
      fits = clears(how);
    }
    if (fits && finishes && floorAllowance > 0.0) {
      how.roughs = true;
      how.allowance = 0.0;
      how.infeed = 0.0;
      fits = clears(how);
    }
    return fits;
  }
};

/// Where the middle of a rectangle is, seen from its reference point (Q367): the middle, or a
/// corner from the lower left one on, counterclockwise.
std::optional<Flat> middleOf(Values& values, double length, double width) {
  const double at = values.q(367, 0.0);
  if (at == 0.0) {
    return Flat{};
  }
  if (at != 1.0 && at != 2.0 && at != 3.0 && at != 4.0) {
    values.outOfRange(367);
    return std::nullopt;
  }
  return Flat{(at == 1.0 || at == 4.0 ? 0.5 : -0.5) * length,
              (at == 1.0 || at == 2.0 ? 0.5 : -0.5) * width};
}

double size(Values& values, int number) {
  const double length = values.q(number);
  if (!(length > 0.0)) {
    values.outOfRange(number);
  }
  return length;
}

/// Rings are apart by so much: a factor of the radius.
double overlap(Values& values, double radius) {
  const double factor = values.q(370, 1.0);
  if (!(factor > 0.0 && factor < 2.0)) {
    values.outOfRange(370);
  }
  return factor * radius;
}

Steps clearPocket(Values& values, Area& area, const Work& work, double apart, double length,
                  double width, double corner) {
  work.limit(values, area, std::min(length, width) / 2.0, apart);
  if (values.isFaulty() || area.mill().planes().depth == 0.0) {
    return {};
  }
  area.climb(work.climbs, true);
  area.approach(0.0, 0.0);
  const bool fits = work.run(area, apart, [&](const Clearing& how) {
    return clearRectangle(area.mill(), length / 2.0, width / 2.0, corner, how);
  });
  if (!fits) {
    return area.doesNotFit();
  }
  area.retract(0.0, 0.0);
  return area.back();
}

}  // namespace

Steps rectangularPocket(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  Work work(values);
  work.enterBy(values, AreaEntry::Helix);
  const double length = size(values, 218);
  const double width = size(values, 219);
  const double corner = values.q(220);
  if (corner != 0.0 && corner < area.radius() - kCycleRounding) {
    values.outOfRange(220);
  }
  const double apart = overlap(values, area.radius());
  if (const auto middle = middleOf(values, length, width)) {
    area.placeAt(*middle, values.q(224));
  }
  return clearPocket(values, area, work, apart, length, width,
                     corner != 0.0 ? corner : area.radius());
}

Steps circularPocket(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  Work work(values);
  work.enterBy(values, AreaEntry::Helix);
  const double diameter = size(values, 223);
  const double apart = overlap(values, area.radius());
  area.placeAt({}, 0.0);
  return clearPocket(values, area, work, apart, diameter, diameter, diameter / 2.0);
}

Steps slot(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  Work work(values);
  work.enterBy(values, AreaEntry::Ramp);
  const double length = size(values, 218);
  const double width = size(values, 219);
  if (length < width) {
    values.outOfRange(218);
  }
  // The tool stands in the middle, at the left end, in the middle of the left or right circle, or
  // at the right end.
  const double at = values.q(367, 0.0);
  const double circle = (length - width) / 2.0;
  const double beside = at == 1.0   ? length / 2.0
                        : at == 2.0 ? circle
                        : at == 3.0 ? -circle
                        : at == 4.0 ? -length / 2.0
                                    : 0.0;
  if (at < 0.0 || at > 4.0 || at != std::floor(at)) {
    values.outOfRange(367);
  }
  area.placeAt({beside, 0.0}, values.q(374));
  return clearPocket(values, area, work, 0.0, length, width, width / 2.0);
}

Steps circularSlot(Values& values) {
  constexpr double kSlotsMax = 1000.0;
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  Work work(values);
  work.enterBy(values, AreaEntry::Ramp);
  const double width = size(values, 219);
  const double radius = size(values, 375) / 2.0;
  const double at = values.q(367, 0.0);
  const double start = values.q(376);
  const double sweep = values.q(248);
  const double step = values.q(378, 0.0);
  const double count = values.q(377, 1.0);
  // 0: about the centre that the cycle names; 1: the tool stands in the middle of the left circle.
  // Which angle the others mean, the manual does not say.
  if (at != 0.0 && at != 1.0) {
    values.outOfRange(367);
  }
  if (!(sweep > 0.0 && sweep <= 360.0)) {
    values.outOfRange(248);
  }
  if (!(count >= 1.0 && count <= kSlotsMax)) {
    values.outOfRange(377);
  }
  const Flat centre =
      at == 0.0 ? Flat{values.q(216), values.q(217)} : area.here() - turned({radius, 0.0}, start);
  work.limit(values, area, width / 2.0, 0.0);
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  area.climb(work.climbs, true);
  for (double i = 0.0; i < std::floor(count); ++i) {
    // In a system that is turned, the slot begins on u; turned the other way, it ends there.
    const bool isTurned = work.climbs < 0.0;
    area.placeAbout(centre, start + i * step + (isTurned ? sweep : 0.0));
    if (i == 0.0) {
      area.approach(radius, 0.0);
    } else {
      area.mill().approach(radius, 0.0);
    }
    const bool fits = work.run(area, 0.0, [&](const Clearing& how) {
      return clearArc(area.mill(), radius, 0.0, sweep, width, how);
    });
    if (!fits) {
      return area.doesNotFit();
    }
    area.retract(radius, 0.0);
  }
  return area.back();
}

namespace {

Steps clearStud(Values& values, Area& area, const Work& work, double apart, Spigot spigot) {
  if (values.isFaulty() || area.mill().planes().depth == 0.0) {
    return {};
  }
  work.limit(values, area, std::max(spigot.blankHalfU, spigot.blankHalfV), apart);
  if (values.isFaulty()) {
    return {};
  }
  constexpr double kOutsideMm = 2.0;
  spigot.outside = kOutsideMm * values.situation().millimetre;
  area.climb(work.climbs, false);
  const double u = startOf(area.mill(), spigot, {.allowance = work.allowance});
  area.approach(u, 0.0);
  (void)work.run(area, apart, [&](const Clearing& how) {
    Spigot own = spigot;
    if (!how.roughs) {
      own.blankHalfU = own.halfU;
      own.blankHalfV = own.halfV;
    }
    clearAround(area.mill(), own, how);
    area.mill().cut(u, 0.0, area.mill().safetyHeight(), kFeedMax);
    return true;
  });
  area.retract(u, 0.0);
  return area.back();
}

}  // namespace

Steps rectangularStud(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  const Work work(values);
  const double length = size(values, 218);
  const double width = size(values, 219);
  const double blankLength = size(values, 424);
  const double blankWidth = size(values, 425);
  const double corner = values.q(220);
  const double apart = overlap(values, area.radius());
  if (blankLength < length) {
    values.outOfRange(424);
  }
  if (blankWidth < width) {
    values.outOfRange(425);
  }
  if (corner < 0.0) {
    values.outOfRange(220);  // a chamfer
  }
  if (values.q(437, 0.0) != 0.0) {
    values.outOfRange(437);  // from another side than the first axis
  }
  if (const auto middle = middleOf(values, length, width)) {
    area.placeAt(*middle, values.q(224));
  }
  return clearStud(values, area, work, apart,
                   {.halfU = length / 2.0,
                    .halfV = width / 2.0,
                    .corner = corner,
                    .blankHalfU = blankLength / 2.0,
                    .blankHalfV = blankWidth / 2.0});
}

Steps circularStud(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  const Work work(values);
  const double radius = size(values, 223) / 2.0;
  const double blank = size(values, 222) / 2.0;
  const double apart = overlap(values, area.radius());
  const double start = values.q(376, -1.0);
  if (blank < radius) {
    values.outOfRange(222);
  }
  area.placeAt({}, start >= 0.0 ? start : 0.0);
  return clearStud(values, area, work, apart,
                   {.halfU = radius,
                    .halfV = radius,
                    .corner = radius,
                    .blankHalfU = blank,
                    .blankHalfV = blank});
}

/// A helix from the set-up clearance on, and a circle on the ground.
Steps boreByMilling(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  const double feed = values.q(206);
  const double pitch = values.q(334);
  const double diameter = size(values, 335);
  const double rough = values.q(342);
  const double climbs = values.q(351, 1.0);
  const double radius = diameter / 2.0 - area.radius();
  checkFeed(values, 206, feed);
  const double falls = hole.clearance() - hole.below(hole.whole());
  if (!(pitch > 0.0) || falls / pitch > kPitchesMax) {
    values.outOfRange(334);
  }
  // Without a hole before, a core would be left in the middle of a bore this wide.
  if (rough < 0.0 || rough > diameter || (rough == 0.0 && radius > area.radius())) {
    values.outOfRange(342);
  }
  if (climbs != 1.0 && climbs != -1.0) {
    values.outOfRange(351);
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  if (radius < -kCycleRounding) {
    return area.doesNotFit();
  }
  area.placeAt({}, 0.0);
  area.climb(climbs, true);
  area.approach(0.0, 0.0);
  AreaMill& mill = area.mill();
  const double ground = hole.below(hole.whole());
  if (radius < kCycleRounding) {
    mill.cut(0.0, 0.0, ground, feed);  // as wide as the tool: drilled
  } else {
    const double turns = std::ceil(falls / pitch - kCycleRounding);
    mill.arc(radius / 2.0, 0.0, radius / 2.0, 180.0, 180.0, hole.clearance(), feed);
    mill.spiral(0.0, 0.0, radius, 0.0, 360.0 * turns, hole.clearance(), ground, feed);
    mill.arc(0.0, 0.0, radius, 0.0, 360.0, ground, feed);
    mill.arc(radius / 2.0, 0.0, radius / 2.0, 0.0, 180.0, ground, feed);
  }
  area.retract(0.0, 0.0);
  return area.back();
}

/// An internal thread. Whether the tool works upwards follows from the thread's hand and the way of
/// cutting; each pass begins and ends on a half circle that rises as the thread does.
Steps threadByMilling(Values& values) {
  const Drilling hole(values);
  Area area(values, planesOf(hole));
  const double diameter = size(values, 335);
  const double pitch = values.q(239);
  const double perStep = values.q(355);
  const double positioning = values.q(253);
  const double climbs = values.q(351);
  const double feed = values.q(207);
  const double approachFeed = feedOr(values.q(512, 0.0), feed);
  const double radius = diameter / 2.0 - area.radius();
  const double rise = std::abs(pitch);
  checkFeed(values, 253, positioning);
  checkFeed(values, 207, feed);
  if (!(rise > 0.0) || hole.whole() / rise > kPitchesMax) {
    values.outOfRange(239);
  }
  if (climbs != 1.0 && climbs != -1.0) {
    values.outOfRange(351);
  }
  if (perStep < 0.0 || perStep != std::floor(perStep)) {
    values.outOfRange(355);
  }
  if (values.isFaulty() || hole.whole() == 0.0) {
    return {};
  }
  if (!(radius > 0.0)) {
    return area.doesNotFit();
  }
  const double up = (pitch > 0.0) == (climbs > 0.0) ? 1.0 : -1.0;
  const double ground = hole.below(hole.whole());
  // Turns of one pass, and where the lowest ends of the passes are.
  const double pitches = std::ceil(hole.whole() / rise - kCycleRounding);
  const double turns = perStep == 1.0 ? pitches : 1.0;
  const double passes = perStep > 1.0 ? std::ceil(pitches / perStep) : 1.0;
  area.placeAt({}, 0.0);
  area.climb(climbs, true);
  area.approach(0.0, 0.0);
  AreaMill& mill = area.mill();
  for (double pass = 0.0; pass < passes; ++pass) {
    const double lowest = ground + (up > 0.0 ? pass : passes - 1.0 - pass) * perStep * rise;
    const double from = up > 0.0 ? lowest : lowest + turns * rise;
    const double to = from + up * turns * rise;
    mill.cut(0.0, 0.0, from - up * rise / 2.0, positioning);
    mill.spiral(radius / 2.0, 0.0, radius / 2.0, 180.0, 180.0, from - up * rise / 2.0, from,
                approachFeed);
    mill.spiral(0.0, 0.0, radius, 0.0, 360.0 * turns, from, to, feed);
    mill.spiral(radius / 2.0, 0.0, radius / 2.0, 0.0, 180.0, to, to + up * rise / 2.0, feed);
  }
  area.retract(0.0, 0.0);
  return area.back();
}

/// Lines beside each other; the last infeed leaves the surface at Q386.
Steps faceByMilling(Values& values) {
  const double surface = values.q(227);
  const double ground = values.q(386);
  const double second = values.q(204);
  const double strategy = values.q(389);
  const double floorAllowance = values.q(369);
  const double feed = values.q(207);
  const double finishFeed = feedOr(values.q(385), feed);
  const double factor = values.q(370);
  const double infeed = values.q(202);
  AreaPlanes planes{.retraction = surface + std::max(second, values.q(200)),
                    .reference = surface,
                    .safety = values.q(200),
                    .depth = surface - ground - floorAllowance};
  Area area(values, planes);
  Face face{.length = values.q(218),
            .width = values.q(219),
            .beyond = area.radius() + values.q(357),
            .apart = factor * area.radius(),
            .infeed = infeed,
            .feed = feed,
            .alternates = strategy == 0.0};
  checkFeed(values, 207, feed);
  if (!(factor > 0.0 && factor < 2.0)) {
    values.outOfRange(370);
  }
  if (!(infeed > 0.0)) {
    values.outOfRange(202);
  }
  // 1 stays within the surface, which may be surrounded.
  if (strategy != 0.0 && strategy != 2.0) {
    values.outOfRange(389);
  }
  if (floorAllowance < 0.0 || planes.depth < 0.0) {
    values.outOfRange(386);
  }
  if (planes.depth / infeed > kAreaLinesMax) {
    values.outOfRange(202);
  }
  const double across = std::max(std::abs(face.length), std::abs(face.width));
  if (area.radius() > 0.0 && across > kAreaLinesMax * face.apart) {
    values.outOfRange(370);
  }
  if (values.isFaulty() || face.length == 0.0 || face.width == 0.0) {
    return {};
  }
  area.placeAbout({values.q(225), values.q(226)}, 0.0);
  area.approach(-std::copysign(face.beyond, face.length), 0.0);
  if (planes.depth > 0.0) {
    clearFace(area.mill(), face);
  }
  if (floorAllowance > 0.0) {
    planes.depth += floorAllowance;
    area.mill().setPlanes(planes);
    face.infeed = 0.0;
    face.feed = finishFeed;
    clearFace(area.mill(), face);
  }
  return area.stay();
}

namespace {

/// Of 4 and 5: between the height where the tool stands and the depth.
struct OldPocket {
  explicit OldPocket(Values& values)
      : hole(values, values.situation()),
        area(values, {.retraction = hole.start,
                      .reference = hole.surface(),
                      .safety = hole.setUp,
                      .depth = -hole.depth}) {
    how.infeed = std::abs(values.old(3));
    how.depthFeed = values.oldFeed(3);
    if (!(how.infeed > 0.0) || -hole.depth / how.infeed > kAreaLinesMax) {
      values.refuse("PECKG");
    }
  }
  /// @param line  with the feed and DR
  [[nodiscard]] Steps clear(Values& values, int line, double length, double width, double corner) {
    how.feed = values.oldFeed(line);
    const bool isClockwise = values.oldClockwise(line);
    if (!(how.feed > 0.0) || !(how.depthFeed > 0.0)) {
      values.refuse("F");
    }
    if (values.isFaulty() || hole.depth == 0.0) {
      return {};
    }
    area.placeAt({}, 0.0);
    area.mill().turnClockwise(isClockwise);
    area.approach(0.0, 0.0);
    if (!clearRectangle(area.mill(), length / 2.0, width / 2.0, corner, how)) {
      return area.doesNotFit();
    }
    area.retract(0.0, 0.0);
    return area.back();
  }

  OldHole hole;
  Area area;
  Clearing how;
};

}  // namespace

Steps pocketOld(Values& values) {
  OldPocket pocket(values);
  const double corner = values.old(6, 0.0);
  if (corner != 0.0 && corner < pocket.area.radius() - kCycleRounding) {
    values.refuse("RADIUS");
  }
  return pocket.clear(values, 6, std::abs(values.old(4)), std::abs(values.old(5)),
                      corner != 0.0 ? corner : pocket.area.radius());
}

Steps circularPocketOld(Values& values) {
  OldPocket pocket(values);
  const double radius = values.old(4);
  return pocket.clear(values, 5, 2.0 * radius, 2.0 * radius, radius);
}

}  // namespace rivulet::nc::heidenhain
