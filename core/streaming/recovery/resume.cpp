// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/recovery/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "base/contract.h"
#include "base/hash.h"
#include "opcua/await.h"
#include "streaming/control/control_axes.h"
#include "streaming/methods/method.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/recovery/run_on_control.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using base::Vec3;
using opcua::Variable;
using opcua::VariableKind;

/// A tool farther from the path than this has been moved since: roundings of the control are
/// smaller by far.
constexpr double kBesideMm = 0.05;
/// A point this close ahead counts as reached.
constexpr double kReachedMm = 1e-3;
/// A path that leaves the tool farther than this and comes back has passed it twice.
constexpr double kSpotMm = 0.06;

/// The positions of all axes as a space in which a move between two points is a straight line.
double dot(const base::AxisPosition& a, const base::AxisPosition& b) {
  return base::dot(a.mm, b.mm) + a.deg[0] * b.deg[0] + a.deg[1] * b.deg[1] + a.deg[2] * b.deg[2];
}
/// a + k (b - a)
base::AxisPosition between(const base::AxisPosition& a, const base::AxisPosition& b, double k) {
  base::AxisPosition place{a.mm + k * (b.mm - a.mm), a.deg};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    place.deg[axis] += k * (b.deg[axis] - a.deg[axis]);
  }
  return place;
}
base::AxisPosition difference(const base::AxisPosition& from, const base::AxisPosition& to) {
  return {to.mm - from.mm,
          {to.deg[0] - from.deg[0], to.deg[1] - from.deg[1], to.deg[2] - from.deg[2]}};
}
double distance(const base::AxisPosition& a, const base::AxisPosition& b) {
  const base::AxisPosition way = difference(a, b);
  return std::sqrt(dot(way, way));
}

constexpr const char* kMoved =
    "The tool is not where the run was left. Move it back to the last executed point, or start "
    "from the beginning.";

constexpr const char* kOverlayLeft =
    "The correction of the interrupted run is still active on the axes. Remove it at the control "
    "(press reset, wait, and check that $AA_OFF is 0), then resume.";

/// The last correction requested by the client of the run. After a regular end no overlay is left;
/// after a reset this depends on the control (MD36750) and on the moment.
struct LastCorrection {
  Vec3 mm;
  bool isKnown = true;  ///< false: the value was not accepted, so an earlier one may be active
};

LastCorrection lastCorrection(const RunSettings& settings, const templates::CellMap& cells,
                              std::span<const double> numbers) {
  constexpr double kSameMm = 1e-9;
  const double limitMm = templates::correctionSteps(settings.parameters) / 1000.0;
  LastCorrection last;
  std::size_t next = 0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.correction[axis] >= 0) {
      const double valueMm = numbers[next++];
      last.isKnown = last.isKnown && std::abs(valueMm) <= limitMm + kSameMm;
      last.mm.set(axis, valueMm);
    }
  }
  return last;
}

/// 0 for the axes that are not streamed.
base::AxisPosition onlyRotary(base::AxisPosition place, const base::RotarySet& rotaryAxes) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    place.deg[axis] = rotaryAxes[axis] ? place.deg[axis] : 0.0;
  }
  return place;
}

/// Positions of the run's rotary axes.
Result<base::RotaryDeg> anglesOf(opcua::Link& link, const RunSettings& settings) {
  const base::RotarySet wanted = settings.parameters.rotaryAxes;
  if (!base::any(wanted)) {
    return base::RotaryDeg{};
  }
  const Result<ControlAxes> axes = readControlAxes(link, settings.setupDeadline);
  if (!axes) {
    return base::fail(axes.error());
  }
  return readAngles(link, *axes, wanted, settings.setupDeadline);
}

constexpr std::string_view kAnotherProgram =
    "Another program is running on the control. Wait until it has ended, or reset the control.";

/// The program on the control is that of this run. @param numbers  its layout, whom it obeys
bool isOurs(std::span<const double> numbers, const templates::FlexibleProgram& program,
            const Checkpoint& last) {
  // A program that was started for this run but has not granted it yet obeys nobody.
  const double owner = numbers[1];
  return numbers[0] == static_cast<double>(program.layoutNumber) &&
         (owner == static_cast<double>(last.runNumber) || (owner == 0.0 && !last.granted));
}

/// Ends a program that waits for windows of this run; nothing else is changed.
Result<void> endOurProgram(opcua::Link& link, const RunSettings& settings,
                           const templates::FlexibleProgram& program, const Checkpoint& last) {
  const templates::CellMap& cells = program.cells;
  const auto isMeant = [&](std::span<const double> numbers) {
    return isOurs(numbers, program, last);
  };
  return endProgram(
      link,
      {{opcua::rParameter(cells.endCell), static_cast<double>(cells.endValue)},
       {opcua::rParameter(cells.layout), opcua::rParameter(cells.owner)},
       cells.windows > 0 ? std::optional(opcua::rParameter(cells.heartbeat)) : std::nullopt,
       isMeant,
       kAnotherProgram,
       "The program on the control did not end. Reset the control, then resume.",
       {},
       cells.hasFeedCell() ? std::optional(opcua::rParameter(cells.overrideWanted)) : std::nullopt},
      settings);
}

}  // namespace

std::optional<std::size_t> pointAhead(const std::vector<Vec3>& path, Vec3 toolMm) {
  std::vector<base::AxisPosition> places;
  for (const Vec3 mm : path) {
    places.push_back({mm, {}});
  }
  return pointAhead(places, {toolMm, {}});
}

std::optional<std::size_t> pointAhead(const std::vector<base::AxisPosition>& path,
                                      const base::AxisPosition& tool) {
  RIVULET_ASSERT(path.size() >= 2);
  struct Foot {
    double distanceMm;
    double arcMm;
  };
  std::vector<Foot> feet;  // one per block, in their order
  std::vector<double> arcMm{0.0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const base::AxisPosition way = difference(path[i - 1], path[i]);
    const double lengthMm = std::sqrt(dot(way, way));
    const double share =
        lengthMm > 0.0
            ? std::clamp(dot(difference(path[i - 1], tool), way) / (lengthMm * lengthMm), 0.0, 1.0)
            : 0.0;
    feet.push_back(
        {distance(tool, between(path[i - 1], path[i], share)), arcMm.back() + share * lengthMm});
    arcMm.push_back(arcMm.back() + lengthMm);
  }
  const auto nearest = std::min_element(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) {
    return a.distanceMm < b.distanceMm;
  });
  if (nearest->distanceMm > kBesideMm) {
    return std::nullopt;
  }
  const auto passesAgain = [&](std::size_t from, std::size_t to) {
    bool hasLeft = false;  // between two blocks the path is farthest from the tool at a point
    for (std::size_t block = from; block < to; ++block) {
      hasLeft = hasLeft || distance(path[block + 1], tool) > kSpotMm;
    }
    return hasLeft;
  };
  const auto nearestBlock = static_cast<std::size_t>(nearest - feet.begin());
  for (std::size_t block = 0; block < feet.size(); ++block) {
    if (feet[block].distanceMm <= kBesideMm &&
        passesAgain(std::min(block, nearestBlock), std::max(block, nearestBlock))) {
      return std::nullopt;
    }
  }
  std::size_t next = 1;
  while (next < path.size() && arcMm[next] <= nearest->arcMm + kReachedMm) {
    ++next;
  }
  return next;
}

MotionAhead motionAhead(const base::AxisPosition& before,
                        std::span<const gcode::StreamPoint> windows, const base::AxisPosition& tool,
                        double feedMmPerS) {
  if (windows.empty()) {
    return {};
  }
  std::vector<base::AxisPosition> path{before};
  for (const gcode::StreamPoint& point : windows) {
    path.push_back({point.positionMm, point.rotaryDeg});
  }
  const std::optional<std::size_t> ahead = pointAhead(path, tool);
  const std::size_t first = ahead.value_or(1);
  MotionAhead motion;
  for (std::size_t i = first; i < path.size(); ++i) {
    const base::AxisPosition& from = ahead && i == first ? tool : path[i - 1];
    const double lengthMm = base::distance(from.mm, path[i].mm);
    const double ownMmPerS = windows[i - 1].feedMmPerS;
    motion.lengthMm += lengthMm;
    motion.seconds += lengthMm / (ownMmPerS > 0.0 ? ownMmPerS : feedMmPerS);
  }
  return motion;
}

namespace {

/// What the control reports about the interrupted run, and the machine's position.
struct Remains {
  bool isActive = false;  ///< its program stands, with what it has copied before it
  double owner = 0.0;
  double latched = 0.0;
  double executed = 0.0;
  base::AxisPosition tool;
  LastCorrection correction;
};

Result<Remains> readRemains(opcua::Link& link, const RunSettings& settings,
                            const templates::CellMap& cells) {
  std::vector<Variable> watched{
      opcua::rParameter(cells.owner),    opcua::rParameter(cells.latched),
      opcua::rParameter(cells.executed), {VariableKind::ActualPosition, 0},
      {VariableKind::ActualPosition, 1}, {VariableKind::ActualPosition, 2},
      {VariableKind::ChannelStatus, 0}};
  const std::size_t corrections = watched.size();
  for (const int cell : cells.correction) {
    if (cell >= 0) {
      watched.push_back(opcua::rParameter(cell));
    }
  }
  const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  const Result<base::RotaryDeg> angles = anglesOf(link, settings);
  if (!angles) {
    return base::fail(angles.error());
  }
  return Remains{(*numbers)[6] != opcua::kChannelReset,
                 (*numbers)[0],
                 (*numbers)[1],
                 (*numbers)[2],
                 {{(*numbers)[3], (*numbers)[4], (*numbers)[5]}, *angles},
                 lastCorrection(settings, cells, std::span(*numbers).subspan(corrections))};
}

/// The program of this run, if it is active, is left as it is. Only axes that stand have a place:
/// held, without their client, waiting for a window, or after a reset when they have braked.
Result<Remains> remainsAtStandstill(opcua::Link& link, const RunSettings& settings,
                                    const templates::FlexibleProgram& program,
                                    const Checkpoint& last) {
  constexpr Duration kLook = std::chrono::milliseconds{100};
  constexpr double kStillMm = 0.01;  // more than a measuring system is off from look to look
  const templates::CellMap& cells = program.cells;
  std::vector<Variable> watched{{VariableKind::ChannelStatus, 0},
                                opcua::rParameter(cells.layout),
                                opcua::rParameter(cells.owner)};
  if (cells.hasFeedCell()) {
    watched.push_back(opcua::rParameter(cells.overrideActs));
  }
  std::optional<Remains> before;
  const Instant until = link.now() + kStandsMax;
  for (;;) {
    const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    const bool isActive = (*numbers)[0] != opcua::kChannelReset;
    if (isActive && !isOurs(std::span(*numbers).subspan(1, 2), program, last)) {
      return base::fail(StreamError::ChannelBusy, std::string(kAnotherProgram));
    }
    const bool isHeld = cells.hasFeedCell() && (*numbers)[3] == templates::FeedCell::kHold;
    Result<Remains> remains = readRemains(link, settings, cells);
    if (!remains) {
      return remains;
    }
    const bool mayStand = !remains->isActive || isHeld || remains->latched == remains->executed;
    const bool stands = before && mayStand && before->isActive == remains->isActive &&
                        before->latched == remains->latched &&
                        before->executed == remains->executed &&
                        distance(before->tool, remains->tool) <= kStillMm;
    if (stands) {
      return remains;
    }
    if (link.now() >= until) {
      return base::fail(StreamError::ChannelBusy,
                        "The axes still move. Stop the run, then resume.");
    }
    before = *remains;
    if (Result<void> slept = opcua::sleepUntil(link, link.now() + kLook); !slept) {
      return base::fail(slept.error());
    }
  }
}

/// Finds the next point of the interrupted run. Makes no requests.
class Resumption {
 public:
  /// @param points  of the whole program, as the run had them
  Resumption(const RunSettings& settings, const Checkpoint& last, const Remains& remains,
             std::vector<gcode::StreamPoint> points)
      : m_settings(settings), m_last(last), m_remains(remains), m_points(std::move(points)) {
    m_uncorrected = remains.tool;
    m_uncorrected.mm = remains.tool.mm - remains.correction.mm;
  }

  /// @param takenMax  windows that the program may have copied but not executed
  [[nodiscard]] Result<std::size_t> nextPoint(int takenMax) const {
    const bool isOurs = m_remains.owner == static_cast<double>(m_last.runNumber);
    if (!isOurs && !m_last.granted) {
      return ofRunNeverObeyed();
    }
    if (m_remains.owner == 0.0) {
      return base::fail(StreamError::CannotResume,
                        "The control does not know this run: it was switched off since then, or "
                        "its program was started again. Start from the beginning.");
    }
    const double latched = m_remains.latched;
    const double executed = m_remains.executed;
    const bool fits = latched >= executed && latched <= executed + takenMax &&
                      latched == std::floor(latched) && executed == std::floor(executed);
    if (!isOurs || !(executed >= 0.0) || !fits || latched > static_cast<double>(m_points.size())) {
      return base::fail(StreamError::CannotResume,
                        "The control has run another program since then: it is not known where "
                        "this run was left. Start from the beginning.");
    }
    const std::vector<std::size_t> ends = windowEnds(m_points, m_settings, m_last);
    const auto pointOf = [&](double windows) {
      return ends[std::min(static_cast<std::size_t>(windows), ends.size() - 1)];
    };
    const std::size_t next = pointOf(executed);
    if (m_remains.isActive && latched > executed) {
      return pointOf(latched);  // the control goes on to there by itself
    }
    if (latched > executed) {
      return withinWindows(next, pointOf(latched));
    }
    // Cells can be written by others; the place of the tool cannot.
    return standsBefore(next) || isOnlyCorrected(next) ? Result<std::size_t>(next)
                                                       : beside(placeBefore(next));
  }

  /// Where the run is left before this point once its program has ended.
  [[nodiscard]] LeftAt leftBefore(std::size_t next) const {
    LeftAt left{Resume{next, m_last.startMm, m_last.startDeg, {}, {}}, {}, m_remains.tool.mm};
    if (m_remains.isActive) {
      left.restMm = restMm(next);
      // Without a copied window the program stands: a resumed one perhaps within its first move.
      left.toolMm = hasCopied() ? placeBefore(next).mm : m_uncorrected.mm;
      left.resume->restMm = left.restMm;
    }
    if (next >= m_points.size()) {
      left.resume.reset();
    }
    return left;
  }

 private:
  /// Windows that the program executes by itself.
  [[nodiscard]] bool hasCopied() const { return m_remains.latched > m_remains.executed; }
  /// Of the windows that have been copied, up to this point.
  [[nodiscard]] double restMm(std::size_t next) const {
    if (!hasCopied()) {
      return 0.0;
    }
    const std::vector<std::size_t> ends = windowEnds(m_points, m_settings, m_last);
    const std::size_t from =
        ends[std::min(static_cast<std::size_t>(m_remains.executed), ends.size() - 1)];
    std::vector<gcode::StreamPoint> windows;
    for (std::size_t i = from; i < next; ++i) {
      windows.push_back(m_points[i]);
      windows.back().rotaryDeg = placeOf(i).deg;
    }
    return motionAhead(placeBefore(from), windows, m_remains.tool, m_settings.feedMmPerS).lengthMm;
  }
  /// The tool is there but for a correction, which a program takes back when it ends.
  [[nodiscard]] bool isOnlyCorrected(std::size_t next) const {
    return m_remains.isActive && m_remains.correction.isKnown &&
           distance(placeBefore(next), m_uncorrected) <= kBesideMm;
  }
  /// Axes that are not streamed may be anywhere.
  [[nodiscard]] base::AxisPosition placeOf(std::size_t point) const {
    return onlyRotary({m_points[point].positionMm, m_points[point].rotaryDeg},
                      m_settings.parameters.rotaryAxes);
  }
  [[nodiscard]] base::AxisPosition placeBefore(std::size_t point) const {
    return point > 0
               ? placeOf(point - 1)
               : onlyRotary({m_last.startMm, m_last.startDeg}, m_settings.parameters.rotaryAxes);
  }
  [[nodiscard]] bool stands(const base::AxisPosition& expected) const {
    return distance(expected, m_remains.tool) <= kBesideMm;
  }
  /// The tool is where the run has to be before this point. One that was resumed may begin within
  /// the move to its first point: there the run before it was interrupted.
  [[nodiscard]] bool standsBefore(std::size_t point) const {
    if (stands(placeBefore(point))) {
      return true;
    }
    return point > 0 && point == m_last.firstPoint && point < m_points.size() &&
           pointAhead({placeBefore(point), placeOf(point)}, m_remains.tool) == 1;
  }
  [[nodiscard]] bool isCorrected() const { return m_remains.correction.mm != Vec3{}; }

  /// The tool is not at the expected place: because of a correction, or for another reason.
  [[nodiscard]] tl::unexpected<base::Error> beside(const base::AxisPosition& expected) const {
    const bool explains = m_remains.correction.isKnown && isCorrected() &&
                          distance(expected, m_uncorrected) <= kBesideMm;
    return explains ? base::fail(StreamError::OverlayLeft, kOverlayLeft)
                    : base::fail(StreamError::CannotResume, kMoved);
  }

  /// The control never obeyed this run, so nothing has moved for it.
  [[nodiscard]] Result<std::size_t> ofRunNeverObeyed() const {
    const std::size_t first = m_last.firstPoint;
    if (first >= m_points.size()) {
      return base::fail(StreamError::CannotResume, kMoved);
    }
    if (first > 0 && !standsBefore(first)) {
      return beside(placeBefore(first));
    }
    return first;
  }

  /// Reset within copied windows: the tool is on their path, or at its end.
  [[nodiscard]] Result<std::size_t> withinWindows(std::size_t next, std::size_t end) const {
    std::vector<base::AxisPosition> path{placeBefore(next)};
    for (std::size_t i = next; i < end; ++i) {
      path.push_back(placeOf(i));
    }
    const bool isPath = path.size() >= 2;
    const std::optional<std::size_t> ahead =
        isPath ? pointAhead(path, m_remains.tool) : std::nullopt;
    if (isPath && isCorrected()) {
      // The correction may still be active or not. Resume only if both give the same point, or if
      // the tool is on the path only without it.
      const bool isKnown = m_remains.correction.isKnown;
      const std::optional<std::size_t> corrected =
          isKnown ? pointAhead(path, m_uncorrected) : std::nullopt;
      if (!ahead && corrected) {
        return base::fail(StreamError::OverlayLeft, kOverlayLeft);
      }
      if (!isKnown || (corrected && corrected != ahead)) {
        return base::fail(StreamError::CannotResume,
                          "A correction was active when the run was interrupted, and the tool's "
                          "place without it is not known. Start from the beginning.");
      }
    }
    if (!ahead) {
      return base::fail(StreamError::CannotResume,
                        "The tool is not on the path of the interrupted windows, or the path "
                        "passes its place twice. Start from the beginning.");
    }
    return next + *ahead - 1;
  }

  const RunSettings& m_settings;
  const Checkpoint& m_last;
  const Remains& m_remains;
  std::vector<gcode::StreamPoint> m_points;
  base::AxisPosition m_uncorrected;
};

/// Windows are cut at rapids and, if they have feeds of their own, where these change; other kinds
/// of moves are streamed alike.
bool isRapid(const gcode::StreamPoint& point) {
  return point.kind == gcode::MoveKind::Rapid;
}

bool isSamePoint(const gcode::StreamPoint& a, const gcode::StreamPoint& b) {
  return a.positionMm == b.positionMm && a.rotaryDeg == b.rotaryDeg && isRapid(a) == isRapid(b) &&
         a.feedMmPerS == b.feedMmPerS;
}

/// Compares the program with the points of the interrupted run.
/// @param next  where it is resumed, counted in the earlier points
/// @return first point that differs; nothing: none. ProgramChanged if it may not
Result<std::optional<std::size_t>> findChange(std::span<const gcode::StreamPoint> now,
                                              std::span<const gcode::StreamPoint> earlier,
                                              std::size_t next) {
  const auto [a, b] =
      std::mismatch(now.begin(), now.end(), earlier.begin(), earlier.end(), isSamePoint);
  if (a == now.end() && b == earlier.end()) {
    return std::nullopt;
  }
  const auto point = static_cast<std::size_t>(a - now.begin());
  if (point < next) {
    const auto line = (a != now.end() ? *a : *b).line.value;
    return base::fail(
        StreamError::ProgramChanged,
        fmt::format("The program has been changed since the run: it differs from point {} (line "
                    "{}) on, but {} points have been executed. Restore it, or start from the "
                    "beginning.",
                    point + 1, line, next));
  }
  if (now.size() <= next) {
    return base::fail(StreamError::ProgramChanged,
                      "The program has been shortened since the run: all points that are left in "
                      "it have been executed.");
  }
  return point;
}

}  // namespace

std::vector<std::size_t> windowEnds(std::span<const gcode::StreamPoint> points,
                                    const RunSettings& settings, const Checkpoint& last) {
  const std::size_t first = std::min(last.firstPoint, points.size());
  std::vector<std::size_t> ends;
  if (const auto streamed = points.subspan(first); !streamed.empty()) {
    WindowCut cut = windowCut(settings);
    cut.place = last.pausesPlaced;
    cut.secondsMax = last.windowSMax;
    cut.feedMmPerS = last.windowFeedMmPerS;
    const auto perWindow = static_cast<std::size_t>(settings.parameters.pointsPerLoop);
    for (const std::size_t begin : cutWindows(streamed, perWindow, cut).begins) {
      ends.push_back(first + begin);
    }
  }
  ends.push_back(points.size());
  return ends;
}

std::uint64_t hashOfPoints(std::span<const gcode::StreamPoint> points) {
  std::uint64_t hash = base::kHashBasis;
  const auto mix = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * base::kHashPrime;
    hash ^= hash >> 32U;
  };
  // -0 and 0 are the same place.
  const auto mixNumber = [&mix](double value) { mix(std::bit_cast<std::uint64_t>(value + 0.0)); };
  mix(points.size());
  for (const gcode::StreamPoint& point : points) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      mixNumber(point.positionMm[axis]);
    }
    for (const double angle : point.rotaryDeg) {
      mixNumber(angle);
    }
    mix(isRapid(point) ? 1 : 0);
    if (point.feedMmPerS > 0.0) {  // windows end where it changes
      mixNumber(point.feedMmPerS);
    }
  }
  return hash != 0 ? hash : 1;
}

Result<LeftAt> leftAt(opcua::Link& link, const gcode::Program& program, const RunSettings& settings,
                      const Checkpoint& last, std::span<const gcode::StreamPoint> earlier,
                      ActiveProgram active) {
  const Result<templates::FlexibleProgram> flexible = templates::makeProgram(settings.parameters);
  if (!flexible) {
    return base::fail(flexible.error());
  }
  const int takenMax = methodType(settings.parameters.method).windowsTakenMax(settings.parameters);
  if (takenMax == 0) {
    return base::fail(
        StreamError::CannotResume,
        "Only methods window and credit report how far a run came. Start from the beginning.");
  }
  Result<gcode::PointList> list =
      pointsOnAxes(program.trajectory, settings.parameters, {last.startMm, last.startDeg},
                   settings.programFeeds);
  if (!list) {
    return base::fail(list.error());
  }
  const bool isSame = last.pointsHash == 0 || hashOfPoints(list->points) == last.pointsHash;
  const bool isKept = last.pointsHash != 0 && hashOfPoints(earlier) == last.pointsHash;
  if (!isSame && !isKept) {
    return base::fail(
        StreamError::ProgramChanged,
        fmt::format(
            "The program or the options that change its points are not those of the run: "
            "it had {} points, now there are {}. Restore them, or start from the beginning.",
            last.pointCount, list->points.size()),
        program.name);
  }
  if (active == ActiveProgram::IsEnded) {
    if (Result<void> ended = endOurProgram(link, settings, *flexible, last); !ended) {
      return base::fail(ended.error());
    }
  }
  const Result<Remains> remains = remainsAtStandstill(link, settings, *flexible, last);
  if (!remains) {
    return base::fail(remains.error());
  }
  std::vector<gcode::StreamPoint> run =
      isSame ? list->points : std::vector(earlier.begin(), earlier.end());
  const Resumption resumption(settings, last, *remains, std::move(run));
  const Result<std::size_t> next = resumption.nextPoint(takenMax);
  if (!next) {
    return base::fail(next.error());
  }
  LeftAt left = resumption.leftBefore(*next);
  if (!left.resume) {
    return left;
  }
  Result<std::optional<std::size_t>> change =
      isSame ? std::optional<std::size_t>() : findChange(list->points, earlier, *next);
  if (!change) {
    change.error().context = program.name;
    return base::fail(change.error());
  }
  left.resume->changedFrom = *change;
  return left;
}

Result<Resume> resumeFrom(opcua::Link& link, const gcode::Program& program,
                          const RunSettings& settings, const Checkpoint& last,
                          std::span<const gcode::StreamPoint> earlier, ActiveProgram active) {
  const Result<LeftAt> left = leftAt(link, program, settings, last, earlier, active);
  if (!left) {
    return base::fail(left.error());
  }
  if (left->resume) {
    return *left->resume;
  }
  return base::fail(
      StreamError::CannotResume,
      left->restMm.value_or(0.0) > 0.0
          ? fmt::format("Only the rest of the last window is left, {:.0f} mm: end the run "
                        "(rivulet-cli runs --end), and the control executes it.",
                        std::ceil(*left->restMm))
          : "Every point has been executed already.",
      program.name);
}

Result<Resume> resumeOnPart(opcua::Link& link, const gcode::Program& program,
                            const RunSettings& settings, const Checkpoint& last,
                            const BackPart& part) {
  const Result<templates::FlexibleProgram> flexible = templates::makeProgram(settings.parameters);
  if (!flexible) {
    return base::fail(flexible.error());
  }
  const Result<gcode::PointList> list =
      pointsOnAxes(program.trajectory, settings.parameters, {last.startMm, last.startDeg},
                   settings.programFeeds);
  if (!list) {
    return base::fail(list.error());
  }
  const std::vector<gcode::StreamPoint>& points = list->points;
  if (hashOfPoints(points) != last.pointsHash || part.first == 0 || part.next < part.first ||
      part.next >= points.size()) {
    return base::fail(StreamError::ProgramChanged,
                      "The tool was driven back along another path than that of this program. "
                      "Restore it, or start from the beginning.",
                      program.name);
  }
  const Result<Remains> remains = remainsAtStandstill(link, settings, *flexible, last);
  if (!remains) {
    return base::fail(remains.error());
  }
  if (remains->isActive) {
    return base::fail(StreamError::ChannelBusy, std::string(kAnotherProgram));
  }
  const base::RotarySet& turned = settings.parameters.rotaryAxes;
  std::vector<base::AxisPosition> path;
  for (std::size_t i = part.first - 1; i <= part.next; ++i) {
    path.push_back(onlyRotary({points[i].positionMm, points[i].rotaryDeg}, turned));
  }
  const std::optional<std::size_t> ahead = pointAhead(path, remains->tool);
  if (!ahead) {
    return base::fail(StreamError::CannotResume,
                      "The tool is not on the path along which it was driven back. Move it there, "
                      "or start from the beginning.");
  }
  // All reached: the run was left there.
  const std::size_t next = std::min(part.first - 1 + *ahead, part.next + 1);
  if (next >= points.size()) {
    return base::fail(StreamError::CannotResume, "Every point has been executed already.",
                      program.name);
  }
  return Resume{next, last.startMm, last.startDeg, {}, {}};
}

}  // namespace rivulet::streaming
