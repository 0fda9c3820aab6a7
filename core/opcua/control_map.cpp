// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/control_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/axes.h"
#include "base/contract.h"
#include "base/text.h"
#include "opcua/map_keys.h"

namespace rivulet::opcua {

std::error_code make_error_code(MapError code) {
  static const base::NamedCategory category("opcua map");
  return {static_cast<int>(code), category};
}

namespace {

constexpr std::string_view kPlace = "{}";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string replaced(std::string text, std::string_view what, int by) {
  return replaced(std::move(text), what, std::to_string(by));
}

/// An alarm whose number the server does not show.
constexpr double kSomeAlarm = 1.0;

bool isOfAxis(const Variable& variable) {
  return variable.kind == VariableKind::ActualPosition ||
         variable.kind == VariableKind::DistanceToGo;
}

std::string sinumerikAddress(std::string_view identifier) {
  return fmt::format("nsu={};s={}", kNamespaceUri, identifier);
}

bool isIdentifier(std::string_view text) {
  if (text.size() < 3 || text[1] != '=') {
    return false;
  }
  const std::string_view value = text.substr(2);
  switch (text[0]) {
    case 'i':
      return std::all_of(value.begin(), value.end(), base::isDigit);
    case 's':
    case 'g':
    case 'b':
      return true;
    default:
      return false;
  }
}

}  // namespace

ControlMap sinumerikMap(int last, int axes) {
  ControlMap map;
  for (const Variable& variable : mappableVariables()) {
    if (isOfAxis(variable) && variable.index >= axes) {
      continue;
    }
    map.nodes[variable] = sinumerikAddress(nodeIdentifier(variable));
  }
  for (const MapState& state : kMapStates) {
    if (state.kind == VariableKind::ChannelStatus) {
      map.states[state.kind].push_back({static_cast<double>(state.state), state.state});
    }
  }
  // The patterns are the names of one cell and of one array, with the numbers left out.
  map.cells.last = last;
  map.cells.node =
      sinumerikAddress(replaced(nodeIdentifier(rParameter(7)), "7", std::string(kPlace)));
  const auto pattern = [](Grouping form, std::string_view second, const std::string& place) {
    const std::string name = arrayIdentifier({100, 25, form});
    return sinumerikAddress(replaced(replaced(name, "100", "{first}"), second, place));
  };
  map.cells.byCount = pattern(Grouping::ArrayCount, "25", "{count}");
  map.cells.byLast = pattern(Grouping::ArrayRange, "124", "{last}");
  MethodNodes& methods = map.methods;
  methods.object = sinumerikAddress(kMethodsObject);
  methods.write = sinumerikAddress(memberIdentifier(kMethodsObject, kCopyToServer));
  methods.read = sinumerikAddress(memberIdentifier(kMethodsObject, kCopyFromServer));
  methods.select = sinumerikAddress(memberIdentifier(kMethodsObject, kSelect));
  methods.mainPath = replaced(programPath("A.MPF"), "A.MPF", kPlace);
  methods.subPath = replaced(programPath("A.SPF"), "A.SPF", kPlace);
  return map;
}

std::string mapKeyOf(const Variable& variable) {
  if (variable.kind == VariableKind::RParameter) {
    return "cells";
  }
  for (const MapKey& key : kMapKeys) {
    if (key.variable == variable) {
      return fmt::format("{}.{}", key.section, key.key);
    }
  }
  return {};
}

std::vector<Variable> mappableVariables() {
  std::vector<Variable> variables;
  for (const MapKey& key : kMapKeys) {
    variables.push_back(key.variable);
  }
  return variables;
}

std::string cellAddress(const CellNodes& cells, int number) {
  RIVULET_ASSERT(cells.has(number));
  return cells.isArray ? cells.node : replaced(cells.node, kPlace, number + cells.offset);
}

std::string blockAddress(const CellNodes& cells, const ParameterArray& block) {
  const int last = block.first + block.count - 1;
  if (!cells.has(block.first) || !cells.has(last)) {
    return {};
  }
  if (cells.isArray) {
    return cells.node;
  }
  const std::string& pattern = block.form == Grouping::ArrayCount ? cells.byCount : cells.byLast;
  return replaced(replaced(replaced(pattern, "{first}", block.first), "{count}", block.count),
                  "{last}", last);
}

std::string mappedProgramPath(const MethodNodes& methods, std::string_view name) {
  return replaced(isSubprogramName(name) ? methods.subPath : methods.mainPath, kPlace, name);
}

std::optional<double> meaningOf(const ControlMap& map, const Variable& variable,
                                const StateValue& value) {
  const double* const number = std::get_if<double>(&value);
  const auto states = map.states.find(variable.kind);
  if (states != map.states.end()) {
    const auto& meanings = states->second;
    const auto found =
        std::find_if(meanings.begin(), meanings.end(),
                     [&](const StateMeaning& meaning) { return meaning.value == value; });
    if (found != meanings.end()) {
      return found->state;
    }
    // Whatever does not say that there is no alarm is one.
    return variable.kind != VariableKind::Alarm  ? std::nullopt
           : number != nullptr && *number != 0.0 ? std::optional(*number)
                                                 : std::optional(kSomeAlarm);
  }
  if (number == nullptr) {
    return std::nullopt;
  }
  const bool isRotary = isOfAxis(variable) && variable.index >= static_cast<int>(base::kAxisCount);
  const auto scale = map.scales.find(variable.kind);
  return isRotary || scale == map.scales.end() ? *number : *number * scale->second;
}

std::optional<std::string> axisLetterOf(const ControlMap& map, const Variable& variable) {
  constexpr std::string_view kLetters = "XYZABC";
  const auto index = static_cast<std::size_t>(variable.index);
  return variable.kind == VariableKind::AxisName && index < kLetters.size() &&
                 map.nodes.contains({VariableKind::ActualPosition, variable.index})
             ? std::optional(std::string(1, kLetters[index]))
             : std::nullopt;
}

std::optional<float> asFloat(double value, double resolution) {
  const auto carried = static_cast<float>(value);
  const double offBy = std::abs(static_cast<double>(carried) - value);
  const bool isWhole = std::trunc(value) == value;
  const bool isSame = offBy == 0.0 || (!isWhole && offBy <= resolution / 2.0);
  return std::isfinite(carried) && isSame ? std::optional(carried) : std::nullopt;
}

std::vector<MapGap> gapsOf(const ControlMap& map) {
  std::vector<MapGap> gaps;
  if (map.cells.last < map.cells.first) {
    gaps.push_back({"cells", "no point can be sent, so no run is started", true});
  }
  constexpr std::string_view kWhere =
      "where the tool is cannot be read, so no run is started and no deviation is noticed";
  const std::array<std::pair<Variable, MapGap>, 8> needed{
      {{{VariableKind::ActualPosition, 0}, {"position.x", kWhere, true}},
       {{VariableKind::ActualPosition, 1}, {"position.y", kWhere, true}},
       {{VariableKind::ActualPosition, 2}, {"position.z", kWhere, true}},
       {{VariableKind::ChannelStatus, 0},
        {"channel.status", "whether the control is in reset cannot be read, so no run is started",
         true}},
       {{VariableKind::Alarm, 0},
        {"alarm.number", "whether there is an alarm cannot be read, so no run is started", true}},
       {{VariableKind::PathFeed, 0},
        {"feed.path", "pauses cannot be measured, and a run is started only with --no-monitor",
         false}},
       {{VariableKind::DistanceToGo, 0},
        {"distance_to_go.x", "method position has to pass points by position", false}},
       {{VariableKind::ProgramName, 0},
        {"program.name", "a run that another program has left on the control is not recognised",
         false}}}};
  for (const auto& [variable, gap] : needed) {
    if (!map.nodes.contains(variable)) {
      gaps.push_back(gap);
    }
  }
  if (map.methods.write.empty() || map.methods.read.empty()) {
    gaps.push_back({"methods", "copy programs to the control by hand: --transfer by-hand", false});
  }
  return gaps;
}

bool isAddress(std::string_view text) {
  if (isBrowsePath(text)) {
    return !browseSteps(text).empty();
  }
  for (const std::string_view prefix : {"nsu=", "ns="}) {
    if (text.starts_with(prefix)) {
      const std::size_t end = text.find(';');
      const std::string_view name = text.substr(prefix.size(), end - prefix.size());
      return end != std::string_view::npos && !name.empty() &&
             (prefix == "nsu=" || std::all_of(name.begin(), name.end(), base::isDigit)) &&
             isIdentifier(text.substr(end + 1));
    }
  }
  return isIdentifier(text);
}

std::vector<BrowseStep> browseSteps(std::string_view path) {
  std::vector<BrowseStep> steps;
  if (!isBrowsePath(path)) {
    return steps;
  }
  path.remove_prefix(1);
  std::string name;
  std::optional<int> nameSpace;
  const auto finish = [&] {
    steps.push_back({nameSpace, name});
    name.clear();
    nameSpace.reset();
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] == '&' && i + 1 < path.size()) {
      name += path[++i];
    } else if (path[i] == '/') {
      finish();
    } else if (path[i] == ':' && !nameSpace && !name.empty() &&
               std::all_of(name.begin(), name.end(), base::isDigit)) {
      nameSpace = base::parseInteger(name);
      name.clear();
    } else {
      name += path[i];
    }
  }
  finish();
  const bool isWhole = std::none_of(steps.begin(), steps.end(),
                                    [](const BrowseStep& step) { return step.name.empty(); });
  return isWhole ? steps : std::vector<BrowseStep>();
}

std::string escapedStep(std::string_view name) {
  std::string step;
  for (const char c : name) {
    if (c == '/' || c == '&' || c == ':') {
      step += '&';
    }
    step += c;
  }
  return step;
}

}  // namespace rivulet::opcua
