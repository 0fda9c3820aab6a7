// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/control_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/contract.h"
#include "gcode/packed_points.h"
#include "opcua/await.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

namespace {

using base::Result;
using base::RotarySet;
using opcua::Variable;
using opcua::VariableKind;

/// An axis that is to stay may differ from the programmed position by this much: the control rounds
/// the values it shows.
constexpr double kStandsMm = 0.01;
constexpr double kStandsDeg = 0.01;

/// "A", "A and C".
std::string inWords(const RotarySet& set) {
  std::string words;
  for (const char name : base::rotaryNames(set)) {
    words += words.empty() ? std::string(1, name) : std::string(" and ") + name;
  }
  return words;
}

/// Those of the first that are not in the second.
RotarySet without(const RotarySet& set, const RotarySet& taken) {
  return {set[0] && !taken[0], set[1] && !taken[1], set[2] && !taken[2]};
}

RotarySet both(const RotarySet& a, const RotarySet& b) {
  return {a[0] || b[0], a[1] || b[1], a[2] || b[2]};
}

base::Error missing(const RotarySet& axes, const RotarySet& there) {
  const std::string has =
      base::any(there) ? "X, Y, Z, " + inWords(there) : std::string("X, Y and Z");
  return base::makeError(
      StreamError::AxisMissing,
      fmt::format("The control has no axis {}; it has {}. Choose axes that it has.", inWords(axes),
                  has));
}

}  // namespace

Result<ControlAxes> readControlAxes(opcua::Link& link, base::Duration deadline) {
  std::vector<Variable> names;
  for (std::size_t i = 0; i < base::kRotaryAxisCount; ++i) {
    names.push_back({VariableKind::AxisName, static_cast<int>(base::kAxisCount + i)});
  }
  const auto readings = opcua::readNow(link, names, deadline);
  if (!readings) {
    return base::fail(readings.error());
  }
  ControlAxes axes;
  for (std::size_t i = 0; i < readings->size(); ++i) {
    const opcua::Reading& reading = (*readings)[i];
    for (std::size_t axis = 0; !reading.status && axis < base::kRotaryAxisCount; ++axis) {
      if (reading.text == std::string(1, base::kRotaryAxisNames[axis])) {
        axes.index[axis] = names[i].index;
      }
    }
  }
  return axes;
}

Result<base::RotaryDeg> readAngles(opcua::Link& link, const ControlAxes& axes,
                                   const RotarySet& wanted, base::Duration deadline) {
  if (!base::contains(axes.set(), wanted)) {
    return base::fail(missing(without(wanted, axes.set()), axes.set()));
  }
  base::RotaryDeg angles{};
  if (!base::any(wanted)) {
    return angles;
  }
  std::vector<Variable> positions;
  std::vector<std::size_t> order;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (wanted[axis]) {
      positions.push_back({VariableKind::ActualPosition, axes.index[axis]});
      order.push_back(axis);
    }
  }
  const auto numbers = opcua::readNumbers(link, positions, deadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    angles[order[i]] = (*numbers)[i];
  }
  return angles;
}

namespace {

/// No more points in a window than have room beside the axes.
templates::TemplateParameters fitted(templates::TemplateParameters parameters) {
  const int most = templates::pointsPerLoopMax(parameters);
  if (base::any(parameters.rotaryAxes) && most > 0) {
    parameters.pointsPerLoop = std::min(parameters.pointsPerLoop, most);
  }
  return parameters;
}

}  // namespace

templates::TemplateParameters withTurnedAxes(templates::TemplateParameters parameters,
                                             const gcode::Trajectory& trajectory) {
  if (base::streamsRotary(parameters.method)) {
    parameters.rotaryAxes = gcode::turnedAxes(trajectory);
  }
  return fitted(std::move(parameters));
}

templates::TemplateParameters withTurnedAxes(templates::TemplateParameters parameters,
                                             const job::Plan& plan) {
  parameters = withTurnedAxes(std::move(parameters), plan.program.trajectory);
  const auto isTransformed = [](const job::Part& part) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    return native != nullptr && native->reason == job::NativeReason::Transformation;
  };
  if (base::streamsRotary(parameters.method) &&
      std::any_of(plan.parts.begin(), plan.parts.end(), isTransformed)) {
    for (const gcode::RotaryPosition& set : plan.program.trajectory.rotary) {
      for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
        parameters.rotaryAxes[axis] = parameters.rotaryAxes[axis] || !std::isnan(set.degrees[axis]);
      }
    }
  }
  return fitted(std::move(parameters));
}

Result<void> requireRotaryAxes(const gcode::Trajectory& trajectory,
                               const templates::TemplateParameters& parameters,
                               const ControlAxes& axes, const base::RotaryDeg& atDeg) {
  const RotarySet turned = gcode::turnedAxes(trajectory);
  const RotarySet chosen = parameters.rotaryAxes;
  if (base::any(turned) && !base::streamsRotary(parameters.method)) {
    return base::fail(StreamError::ProgramNotStreamable,
                      fmt::format("The program moves {}: only method window streams rotary axes.",
                                  inWords(turned)));
  }
  if (!base::contains(chosen, turned)) {
    templates::TemplateParameters right = parameters;
    right.rotaryAxes = both(chosen, turned);
    return base::fail(
        StreamError::AxesNotChosen,
        fmt::format("The program moves {}, which is not among the selected axes. Select {}.",
                    inWords(without(turned, chosen)), templates::axisLetters(right)));
  }
  if (!base::contains(axes.set(), chosen)) {
    return base::fail(missing(without(chosen, axes.set()), axes.set()));
  }
  for (const gcode::RotaryPosition& set : trajectory.rotary) {
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      const double wanted = set.degrees[axis];
      if (!std::isnan(wanted) && !chosen[axis] && axes.set()[axis] &&
          std::abs(wanted - atDeg[axis]) > kStandsDeg) {
        return base::fail(StreamError::AxesNotChosen,
                          fmt::format("The program needs {0} at {1} deg, but it is at {2:.3f}. "
                                      "Move it there first, or add {0} to the selected axes.",
                                      base::kRotaryAxisNames[axis], wanted, atDeg[axis]));
      }
    }
  }
  return {};
}

namespace {

/// Points that are packed lie on whole steps; what the program leaves open stays where it is.
Result<void> roundAll(std::vector<gcode::StreamPoint>& points, const base::AxisPosition& start) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    gcode::StreamPoint& point = points[i];
    gcode::roundToSteps(point, start);
    if (i > 0 && point.positionMm == points[i - 1].positionMm &&
        point.rotaryDeg == points[i - 1].rotaryDeg) {
      return base::fail(
          templates::TemplateError::BadCells,
          fmt::format("The moves to lines {} and {} end less than 0.001 apart: points "
                      "so close cannot be packed. Do not pack them.",
                      points[i - 1].line.value, point.line.value));
    }
  }
  return {};
}

}  // namespace

Result<gcode::PointList> pointsOnAxes(const gcode::Trajectory& trajectory,
                                      const templates::TemplateParameters& parameters,
                                      const base::AxisPosition& start,
                                      const std::optional<gcode::ProgramFeeds>& feeds) {
  gcode::PointList list =
      gcode::streamPoints(trajectory, start.mm, start.deg, feeds ? &*feeds : nullptr);
  for (gcode::StreamPoint& point : list.points) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (parameters.axes[axis]) {
        continue;
      }
      if (std::abs(point.positionMm[axis] - start.mm[axis]) > kStandsMm) {
        templates::TemplateParameters right = parameters;
        right.axes[axis] = true;
        return base::fail(
            StreamError::AxesNotChosen,
            fmt::format("The program moves {}, which is not among the selected axes. Select {}.",
                        base::kAxisNames[axis], templates::axisLetters(right)));
      }
      point.positionMm.set(axis, start.mm[axis]);
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      point.rotaryDeg[axis] = parameters.rotaryAxes[axis] ? point.rotaryDeg[axis] : start.deg[axis];
    }
  }
  if (templates::packingOf(parameters)) {
    if (Result<void> rounded = roundAll(list.points, start); !rounded) {
      return base::fail(rounded.error());
    }
  }
  return list;
}

}  // namespace rivulet::streaming
