// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/fitted_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "base/units.h"

namespace rivulet::streaming {

namespace {

using machine::MachineConfig;
using nc::MachineWord;

/// The servo overshoots nothing, but a path that ends exactly at a limit may be rounded beyond it.
constexpr double kMarginMm = 0.5;
/// A rotary axis that the job needs: not bounded for its angles.
constexpr double kTurnsDeg = 36000.0;
/// Five axes need more cells than a control has as delivered.
constexpr int kCellsOfFiveAxes = 200;
constexpr int kEdgesMax = 12;

std::vector<double> valuesOf(const job::Plan& plan, MachineWord kind) {
  std::vector<double> values;
  for (const gcode::PathEvent& event : plan.program.trajectory.events) {
    if (event.kind == kind) {
      values.push_back(event.value);
    }
  }
  return values;
}

void loadTools(FittedMachine& made, const job::Plan& plan) {
  if (!made.config.tools) {
    return;  // T has no effect
  }
  machine::ToolTable& table = *made.config.tools;
  std::set<std::string> missing;
  std::set<std::string> extended;
  const auto edgeCount = static_cast<std::size_t>(std::clamp(plan.lastEdge, 1, kEdgesMax));
  const auto load = [&](int number, const std::string& name) {
    const auto found = std::find_if(table.tools.begin(), table.tools.end(), [&](const auto& tool) {
      return name.empty() ? tool.number == number : base::toUpper(tool.name) == base::toUpper(name);
    });
    const std::string word = name.empty() ? fmt::format("T{}", number) : name;
    if (found == table.tools.end()) {
      missing.insert(word);
      table.tools.push_back({number, name, std::vector<machine::ToolEdge>(edgeCount), false});
    } else if (!found->edges.empty() && found->edges.size() < edgeCount) {
      extended.insert(word);
      found->edges.resize(edgeCount, found->edges.front());
    }
  };
  for (const double value : valuesOf(plan, MachineWord::Tool)) {
    if (const int number = static_cast<int>(std::lround(value)); number > 0) {
      load(number, "");
    }
  }
  for (const std::string& name : plan.program.trajectory.toolNames) {
    load(0, name);
  }
  if (!missing.empty()) {
    made.notes.push_back(fmt::format("Not in the tool table, taken with length 0 and radius 0: {}.",
                                     fmt::join(missing, ", ")));
  }
  if (!extended.empty()) {
    made.notes.push_back(fmt::format("Cutting edges up to D{} have the values of D1: {}.",
                                     edgeCount, fmt::join(extended, ", ")));
  }
}

/// A tilting axis is taken for a turning one where the job goes beyond its limits.
void turnFreely(FittedMachine& made, const job::Plan& plan, std::size_t axis) {
  machine::RotaryLimits& limits = *made.config.rotaryAxes[axis];
  const auto& places = plan.program.trajectory.rotary;
  const bool fits = std::none_of(places.begin(), places.end(), [&](const auto& place) {
    return place.degrees[axis] < limits.positionDegMin ||
           place.degrees[axis] > limits.positionDegMax;
  });
  if (!fits) {
    limits.positionDegMin = -kTurnsDeg;
    limits.positionDegMax = kTurnsDeg;
    made.notes.push_back(fmt::format("Rotary axis {} has been given the range of ±{:.0f} degrees.",
                                     base::kRotaryAxisNames[axis], kTurnsDeg));
  }
}

/// An axis that the program places once, and never turns, is not streamed: it stands there.
void placeAxis(FittedMachine& made, const job::Plan& plan, std::size_t axis) {
  const auto& places = plan.program.trajectory.rotary;
  const auto placed = std::find_if(places.begin(), places.end(), [axis](const auto& place) {
    return !std::isnan(place.degrees[axis]);
  });
  auto& limits = made.config.rotaryAxes[axis];
  if (!limits || placed == places.end() || placed->degrees[axis] == limits->startDeg) {
    return;
  }
  limits->startDeg = placed->degrees[axis];
  made.notes.push_back(
      fmt::format("Rotary axis {} stands at {:g} degrees, where the program has it.",
                  base::kRotaryAxisNames[axis], limits->startDeg));
}

void addAxes(FittedMachine& made, const job::Plan& plan) {
  const base::RotarySet turned = gcode::turnedAxes(plan.program.trajectory);
  auto& axes = made.config.rotaryAxes;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (!turned[axis]) {
      placeAxis(made, plan, axis);
      continue;
    }
    if (axes[axis]) {
      turnFreely(made, plan, axis);
      continue;
    }
    const auto other =
        std::find_if(axes.begin(), axes.end(), [](const auto& each) { return each.has_value(); });
    // As axis C of preset dmu75-5axis.
    machine::RotaryLimits limits{-kTurnsDeg, kTurnsDeg, 240.0, 1000.0, 40000.0, 0.01, 0.0};
    if (other != axes.end()) {
      limits = **other;
      limits.positionDegMin = -kTurnsDeg;
      limits.positionDegMax = kTurnsDeg;
    }
    axes[axis] = limits;
    made.config.rParameterCount = std::max(made.config.rParameterCount, kCellsOfFiveAxes);
    made.notes.push_back(
        fmt::format("The machine has been given a rotary axis {}.", base::kRotaryAxisNames[axis]));
  }
}

/// Of the tools in the table; the program may select any of them.
double lengthMmMax(const MachineConfig& config, const job::Plan& plan) {
  double longest = 0.0;
  const auto take = [&longest](const std::optional<machine::Tool>& tool) {
    for (std::size_t edge = 0; tool && edge < tool->edges.size(); ++edge) {
      longest = std::max(longest, tool->edges[edge].lengthMm);
    }
  };
  if (config.tools) {
    for (const double value : valuesOf(plan, MachineWord::Tool)) {
      take(config.tools->find(static_cast<int>(std::lround(value))));
    }
    for (const std::string& name : plan.program.trajectory.toolNames) {
      take(config.tools->find(name));
    }
    take(config.tools->inSpindle);
  }
  return longest;
}

void placeWorkpiece(FittedMachine& made, const job::Plan& plan) {
  MachineConfig& config = made.config;
  constexpr std::size_t kZ = 2;
  std::set<int> keys{machine::kNoWorkOffsetKey, 540, 550, 560, 570, 5050, 5060, 5070, 5080, 5090};
  for (const auto& [key, offsetMm] : config.workOffsetsMm) {
    keys.insert(key);
  }
  const double lengthMm = lengthMmMax(config, plan);
  base::Vec3 middleMm;
  bool isMoved = false;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double tool = axis == kZ ? lengthMm : 0.0;
    const double from = plan.minMm[axis];
    const double to = plan.maxMm[axis] + tool;
    const machine::AxisLimits& limits = config.axes[axis];
    const double room = limits.positionMmMax - limits.positionMmMin - 2.0 * kMarginMm;
    if (std::isnan(from) || to - from > room) {
      continue;  // too long for this machine wherever it is: the run says so
    }
    middleMm.set(axis, std::round((limits.positionMmMin + limits.positionMmMax - from - to) / 2.0));
    for (const int key : keys) {
      base::Vec3 offsetMm = config.workOffsetMm(key);
      const bool fits = from + offsetMm[axis] >= limits.positionMmMin + kMarginMm &&
                        to + offsetMm[axis] <= limits.positionMmMax - kMarginMm;
      if (!fits) {
        offsetMm.set(axis, middleMm[axis]);
        config.workOffsetsMm[key] = offsetMm;
        isMoved = true;
      }
    }
  }
  if (isMoved) {
    made.notes.push_back(fmt::format(
        "The workpiece lies in the middle of the travel where the program does not fit at the work "
        "offset of the machine: X {} Y {} Z {}.",
        base::formatNumber(middleMm.x), base::formatNumber(middleMm.y),
        base::formatNumber(middleMm.z)));
  }
}

/// Where the program has the tool before its first move (G92): the operator has brought it there.
void placeTool(FittedMachine& made, const job::Plan& plan) {
  const job::Stretch* first = nullptr;
  for (const job::Part& part : plan.parts) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native != nullptr && native->moves && !native->isHalf) {
      break;
    }
    if (stretch != nullptr && stretch->number > 0) {
      first = stretch;
      break;
    }
  }
  std::string place;
  for (std::size_t axis = 0; first != nullptr && axis < base::kAxisCount; ++axis) {
    if (!std::isnan(first->startMm[axis])) {
      made.config.axes[axis].startMm =
          first->startMm[axis] + made.config.workOffsetMm(machine::kNoWorkOffsetKey)[axis];
      place +=
          fmt::format(" {}{}", base::kAxisNames[axis], base::formatNumber(first->startMm[axis]));
    }
  }
  if (!place.empty()) {
    made.notes.push_back(
        fmt::format("The tool stands at{} at the start, as the program says.", place));
  }
}

/// The first line that moves before any F. A block of the control may be a rapid all the same.
std::optional<base::LineNumber> lineBeforeFeed(const job::Plan& plan) {
  const auto& found = plan.program.diagnostics;
  const auto missing = std::find_if(found.begin(), found.end(), [](const auto& each) {
    return each.code == gcode::DiagnosticCode::FeedMissing;
  });
  if (missing != found.end()) {
    return missing->line;
  }
  for (const job::Part& part : plan.parts) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native != nullptr && native->usesDefaultFeed) {
      return native->place.line;
    }
  }
  return std::nullopt;
}

void setFeed(FittedMachine& made, const job::Plan& plan) {
  const std::optional<base::LineNumber> line = lineBeforeFeed(plan);
  if (line && !(made.config.defaultFeedMmPerS > 0.0)) {
    made.config.defaultFeedMmPerS = kFittedFeedMmPerS;
    made.notes.push_back(fmt::format(
        "Line {} comes before any F: F{:.0f} is taken, the feed that the machine begins "
        "with (SD42110).",
        line->value, base::mmPerMinFromMmPerS(kFittedFeedMmPerS)));
  }
}

void noteLengths(FittedMachine& made, const job::Plan& plan) {
  for (const job::AssumedTool& assumed : plan.assumedLengths) {
    made.notes.push_back(fmt::format(
        "Line {} has {}, the offset of another tool: the length of the tool in the spindle is "
        "taken.",
        assumed.line.value, assumed.word));
  }
}

/// A length or a radius before any tool change.
void loadSpindle(FittedMachine& made, const job::Plan& plan) {
  const job::AssumedTool& assumed = plan.assumedTool;
  if (assumed.word.empty() || !made.config.tools) {
    return;
  }
  machine::Tool tool{1, "", {{}}, false};
  std::string wanted = "a tool";
  if (const auto number = base::parseInteger(std::string_view(assumed.word).substr(1));
      assumed.word.front() == 'H' && number) {
    tool.number = *number;
    tool = made.config.tools->find(*number).value_or(tool);
    wanted = fmt::format("tool {}", *number);
  }
  made.config.tools->inSpindle = std::move(tool);
  made.notes.push_back(
      fmt::format("Line {} has {} before any tool change: {} is in the spindle at the start.",
                  assumed.line.value, assumed.word, wanted));
}

}  // namespace

FittedMachine fitMachine(machine::MachineConfig config, const job::Plan& plan) {
  FittedMachine made{std::move(config), {}};
  loadTools(made, plan);
  loadSpindle(made, plan);
  noteLengths(made, plan);
  addAxes(made, plan);
  placeWorkpiece(made, plan);
  placeTool(made, plan);
  setFeed(made, plan);
  return made;
}

nc::heidenhain::ToolRadius toolRadii(const std::optional<machine::ToolTable>& tools,
                                     bool isFitted) {
  return [tools, isFitted](int number, std::string_view name) -> std::optional<double> {
    const std::optional<machine::Tool> tool = !tools         ? std::nullopt
                                              : name.empty() ? tools->find(number)
                                                             : tools->find(name);
    if (tool && tool->hasEdge(1)) {
      return tool->edges.front().radiusMm;
    }
    return isFitted ? std::optional(0.0) : std::nullopt;
  };
}

std::function<std::optional<base::Vec3>(int)> workOffsets(const machine::MachineConfig& config,
                                                          std::shared_ptr<bool> areRead) {
  const bool hasTool = config.tools && config.tools->inSpindle.exists();
  return [offsetsMm = config.workOffsetsMm, hasTool,
          areRead = std::move(areRead)](int key) -> std::optional<base::Vec3> {
    *areRead = true;
    const auto found = offsetsMm.find(key < 0 ? machine::kNoWorkOffsetKey : key);
    return hasTool ? std::nullopt
                   : std::optional(found == offsetsMm.end() ? base::Vec3{} : found->second);
  };
}

}  // namespace rivulet::streaming
