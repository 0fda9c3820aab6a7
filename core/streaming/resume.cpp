// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/resume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/contract.h"
#include "opcua/await.h"
#include "streaming/control_axes.h"
#include "streaming/method.h"
#include "streaming/pause_placement.h"
#include "templates/generator.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using base::Vec3;
using opcua::Variable;
using opcua::VariableKind;

constexpr double kReset = 0.0;
constexpr Duration kPollInterval = std::chrono::milliseconds{100};

/// A tool farther from the path than this has been moved since: roundings of the control are
/// smaller by far.
constexpr double kBesideMm = 0.05;
/// A point this close ahead counts as reached.
constexpr double kReachedMm = 1e-3;
/// A path that leaves the tool farther than this and comes back has passed it twice.
constexpr double kSpotMm = 0.06;

/// The places of all axes as a space in which a way between two points is a straight line.
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

/// What the client of the run had asked for last. After a regular end nothing of it lies over the
/// axes; after a reset that depends on the control (MD36750) and on the moment.
struct LastCorrection {
  Vec3 mm;
  bool isKnown = true;  ///< false: a value that was not obeyed, so an earlier one may lie there
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

/// Where the rotary axes of the run stand.
Result<base::RotaryDeg> anglesOf(opcua::Link& link, const RunSettings& settings) {
  const base::RotarySet wanted = settings.parameters.rotaryAxes;
  if (!base::any(wanted)) {
    return base::RotaryDeg{};
  }
  const Result<ControlAxes> axes = readControlAxes(link, settings.requestDeadline);
  if (!axes) {
    return base::fail(axes.error());
  }
  return readAngles(link, *axes, wanted, settings.requestDeadline);
}

/// A program that waits for our windows ends; nothing else is touched.
Result<void> endOurProgram(opcua::Link& link, const RunSettings& settings,
                           const templates::CellMap& cells, const Checkpoint& last) {
  const std::array<Variable, 3> watched{{{VariableKind::ChannelStatus, 0},
                                         opcua::rParameter(cells.layout),
                                         opcua::rParameter(cells.owner)}};
  const Instant until = link.now() + settings.stopDeadline;
  const int layout = templates::layoutNumber(settings.parameters);
  for (bool told = false;; told = true) {
    const auto numbers = opcua::readNumbers(link, watched, settings.requestDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[0] == kReset) {
      return {};
    }
    if ((*numbers)[1] != static_cast<double>(layout) ||
        (*numbers)[2] != static_cast<double>(last.runNumber)) {
      return base::fail(StreamError::ChannelBusy,
                        "Another program is running on the control. Wait until it has ended, or "
                        "reset the control.");
    }
    if (link.now() >= until) {
      return base::fail(StreamError::StopNotConfirmed,
                        "The program on the control did not end. Reset the control, then resume.");
    }
    if (!told) {
      const opcua::Assignment end{opcua::rParameter(cells.endCell),
                                  static_cast<double>(cells.endValue)};
      if (Result<void> done = opcua::writeNow(link, {&end, 1}, settings.requestDeadline); !done) {
        return done;
      }
    }
    for (const Instant next = link.now() + kPollInterval; link.now() < next;) {
      if (const auto event = link.wait(next);
          event && event->kind == opcua::EventKind::ConnectionLost) {
        return base::fail(event->error);
      }
    }
  }
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

Result<Resume> resumeFrom(opcua::Link& link, const gcode::Program& program,
                          const RunSettings& settings, const Checkpoint& last) {
  const Result<templates::CellMap> plan = templates::planCells(settings.parameters);
  if (!plan) {
    return base::fail(plan.error());
  }
  const templates::CellMap& cells = *plan;
  const int takenMax = methodType(settings.parameters.method).windowsTakenMax(settings.parameters);
  if (takenMax == 0) {
    return base::fail(
        StreamError::CannotResume,
        "Only methods window and credit report how far a run came. Start from the beginning.");
  }
  if (Result<void> ended = endOurProgram(link, settings, cells, last); !ended) {
    return base::fail(ended.error());
  }
  std::vector<Variable> watched{
      opcua::rParameter(cells.owner),    opcua::rParameter(cells.latched),
      opcua::rParameter(cells.executed), {VariableKind::ActualPosition, 0},
      {VariableKind::ActualPosition, 1}, {VariableKind::ActualPosition, 2}};
  const std::size_t corrections = watched.size();
  for (const int cell : cells.correction) {
    if (cell >= 0) {
      watched.push_back(opcua::rParameter(cell));
    }
  }
  const auto numbers = opcua::readNumbers(link, watched, settings.requestDeadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  const Result<base::RotaryDeg> angles = anglesOf(link, settings);
  if (!angles) {
    return base::fail(angles.error());
  }
  const base::AxisPosition tool{{(*numbers)[3], (*numbers)[4], (*numbers)[5]}, *angles};
  const base::AxisPosition start{last.startMm, last.startDeg};
  Result<gcode::PointList> list = pointsOnAxes(program.trajectory, settings.parameters, start);
  if (!list) {
    return base::fail(list.error());
  }
  const std::vector<gcode::StreamPoint> points = std::move(list->points);
  // Axes that are not streamed may stand anywhere.
  const auto placeOf = [&](std::size_t point) {
    return onlyRotary({points[point].positionMm, points[point].rotaryDeg}, cells.rotaryAxes);
  };
  const auto placeBefore = [&](std::size_t point) {
    return point > 0 ? placeOf(point - 1) : onlyRotary(start, cells.rotaryAxes);
  };
  const std::size_t total = points.size();
  const double latched = (*numbers)[1];
  const double executed = (*numbers)[2];
  const bool isOurs = (*numbers)[0] == static_cast<double>(last.runNumber);
  const LastCorrection correction =
      lastCorrection(settings, cells, std::span(*numbers).subspan(corrections));
  base::AxisPosition uncorrected = tool;
  uncorrected.mm = tool.mm - correction.mm;
  // The tool is not there: why?
  const auto beside = [&](const base::AxisPosition& expected) {
    const bool isCorrected = correction.isKnown && correction.mm != Vec3{} &&
                             distance(expected, uncorrected) <= kBesideMm;
    return isCorrected ? base::fail(StreamError::OverlayLeft, kOverlayLeft)
                       : base::fail(StreamError::CannotResume, kMoved);
  };
  if (!isOurs && !last.granted) {
    // It never came to be obeyed: nothing has moved for it.
    if (last.firstPoint >= total ||
        (last.firstPoint > 0 && distance(placeBefore(last.firstPoint), tool) > kBesideMm)) {
      return last.firstPoint < total ? beside(placeBefore(last.firstPoint))
                                     : base::fail(StreamError::CannotResume, kMoved);
    }
    return Resume{last.firstPoint, last.startMm, last.startDeg};
  }
  // What the program may have taken over beyond what is executed.
  const bool fits = latched >= executed && latched <= executed + takenMax &&
                    latched == std::floor(latched) && executed == std::floor(executed);
  if (!isOurs || !(executed >= 0.0) || !fits || latched > static_cast<double>(total)) {
    return base::fail(StreamError::CannotResume,
                      "The control has run another program since then: it is not known where this "
                      "run was left. Start from the beginning.");
  }
  // The windows of the run that was left are cut again as they were then.
  const auto perWindow = static_cast<std::size_t>(settings.parameters.pointsPerLoop);
  const std::span<const gcode::StreamPoint> streamed =
      std::span(points).subspan(std::min(last.firstPoint, total));
  const PausePlacement placement =
      streamed.empty() ? PausePlacement{} : cutWindows(streamed, perWindow, last.pausesPlaced);
  const auto pointOf = [&](double windows) {
    const auto window = static_cast<std::size_t>(windows);
    return window < placement.windows() ? last.firstPoint + placement.begins[window] : total;
  };
  std::size_t next = pointOf(executed);
  if (latched > executed) {
    // Reset in the middle of what was taken over: the tool stands on its way, or at its end.
    const std::size_t end = pointOf(latched);
    std::vector<base::AxisPosition> path{placeBefore(next)};
    for (std::size_t i = next; i < end; ++i) {
      path.push_back(placeOf(i));
    }
    const std::optional<std::size_t> ahead =
        path.size() >= 2 ? pointAhead(path, tool) : std::nullopt;
    if (path.size() >= 2 && correction.mm != Vec3{}) {
      // Whether the correction still lies over the axes is not known: both must say the same, or
      // only where it does not may the path be.
      const std::optional<std::size_t> corrected =
          correction.isKnown ? pointAhead(path, uncorrected) : std::nullopt;
      if (!ahead && corrected) {
        return base::fail(StreamError::OverlayLeft, kOverlayLeft);
      }
      if (!correction.isKnown || (corrected && corrected != ahead)) {
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
    next += *ahead - 1;
  } else if (distance(placeBefore(next), tool) > kBesideMm) {
    // Cells can be written by others; where the tool stands cannot.
    return beside(placeBefore(next));
  }
  if (next >= total) {
    return base::fail(StreamError::CannotResume, "Every point has been executed already.",
                      program.name);
  }
  return Resume{next, last.startMm, last.startDeg};
}

}  // namespace rivulet::streaming
