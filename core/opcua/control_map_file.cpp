// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "opcua/control_map.h"
#include "opcua/map_keys.h"
#include "opcua/table_reader.h"

namespace rivulet::opcua {

namespace {

/// A control has fewer; the addresses of all cells are resolved when a connection is opened.
constexpr int kCellsMax = 10'000;
/// No axis of a machine moves in larger steps, mm or degrees.
constexpr double kResolutionMax = 1.0;
constexpr int kNumberMax = 1'000'000;

constexpr std::string_view kCellsSection = "cells";
constexpr std::string_view kMethodsSection = "methods";
constexpr std::string_view kUnitKey = "unit";

constexpr std::array<std::pair<std::string_view, std::string MethodNodes::*>, 4> kMethodKeys{
    {{"object", &MethodNodes::object},
     {"write", &MethodNodes::write},
     {"read", &MethodNodes::read},
     {"select", &MethodNodes::select}}};
constexpr std::array<std::pair<std::string_view, std::string MethodNodes::*>, 2> kPathKeys{
    {{"main", &MethodNodes::mainPath}, {"sub", &MethodNodes::subPath}}};

template <class Table, class Is>
auto findIn(const Table& table, Is is) -> decltype(&table[0]) {
  const auto found = std::find_if(table.begin(), table.end(), is);
  return found == table.end() ? nullptr : &*found;
}

/// A pattern with a number in each place: "ns=2;i={}" is an address for every number.
std::string withNumbers(std::string text) {
  for (const std::string_view place : {"{}", "{first}", "{count}", "{last}"}) {
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at)) {
      text.replace(at, place.size(), "0");
    }
  }
  return text;
}

class MapFileReader {
 public:
  explicit MapFileReader(const std::string& path)
      : m_reader(path, MapError::BadFile, "docs/mapping.md shows what a map has to have.") {}

  base::Result<ControlMap> read(std::string_view text) {
    const toml::table root = m_reader.parse(text);
    for (const auto& [key, node] : root) {
      const std::string name(key.str());
      if (name == kCellsSection) {
        takeCells(node);
      } else if (name == kMethodsSection) {
        takeMethods(node);
      } else if (findIn(kMapKeys, [&](const MapKey& one) { return one.section == name; })) {
        takeSection(name, node);
      } else {
        m_reader.unknown(node, name);
      }
    }
    if (root.empty()) {
      m_reader.problem("The map is empty");
    }
    // The order of keys in a file does not matter.
    for (auto& [kind, meanings] : m_map.states) {
      std::stable_sort(
          meanings.begin(), meanings.end(),
          [](const StateMeaning& a, const StateMeaning& b) { return a.state < b.state; });
    }
    const base::Error& problem = m_reader.firstProblem();
    return problem.code ? base::Result<ControlMap>(base::fail(problem))
                        : base::Result<ControlMap>(std::move(m_map));
  }

 private:
  void takeAddress(std::string_view key, const toml::node& node, std::string& into) {
    m_reader.takeText(key, node, into);
    if (!into.empty() && !isAddress(withNumbers(into))) {
      m_reader.problem(node, fmt::format("{} is no node: write it like ns=2;s=Cell.X, "
                                         "nsu=urn:cell;i=5 or /Cell/Axes/X, not {}",
                                         key, into));
    }
  }

  void takeInteger(std::string_view key, const toml::node& node, int from, int& into) {
    const auto number = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
    if (!number || *number < from || *number > kNumberMax) {
      m_reader.problem(
          node, fmt::format("{} must be a whole number from {} to {}", key, from, kNumberMax));
    } else {
      into = static_cast<int>(*number);
    }
  }

  void requirePlaces(const toml::node& node, std::string_view key, const std::string& text,
                     std::initializer_list<std::string_view> places) {
    for (const std::string_view place : places) {
      if (text.find(place) == std::string::npos) {
        m_reader.problem(node,
                         fmt::format("{} must contain {}, which stands for a number", key, place));
      }
    }
  }

  void takeCells(const toml::node& node) {
    const toml::table* const section = m_reader.section(kCellsSection, node);
    if (section == nullptr) {
      return;
    }
    CellNodes& cells = m_map.cells;
    cells = {};
    bool hasNode = false;
    for (const auto& [key, value] : *section) {
      if (key == "node" || key == "array") {
        if (hasNode) {
          m_reader.problem(value, "[cells] must have either node or array, not both");
        }
        hasNode = true;
        cells.isArray = key == "array";
        takeAddress(key.str(), value, cells.node);
        if (!cells.isArray) {
          requirePlaces(value, key.str(), cells.node, {"{}"});
        }
      } else if (key == "first") {
        takeInteger(key.str(), value, 0, cells.first);
      } else if (key == "last") {
        takeInteger(key.str(), value, 0, cells.last);
      } else if (key == "offset") {
        takeInteger(key.str(), value, -kNumberMax, cells.offset);
      } else if (key == "resolution") {
        takeResolution(value, cells.resolution);
      } else if (key == "block_by_count") {
        takeAddress(key.str(), value, cells.byCount);
        requirePlaces(value, key.str(), cells.byCount, {"{first}", "{count}"});
      } else if (key == "block_by_last") {
        takeAddress(key.str(), value, cells.byLast);
        requirePlaces(value, key.str(), cells.byLast, {"{first}", "{last}"});
      } else {
        m_reader.unknown(value, key.str(), kCellsSection);
      }
    }
    if (!hasNode) {
      m_reader.problem(node, "[cells] must have node or array");
    } else if (cells.last < cells.first || cells.last - cells.first >= kCellsMax) {
      m_reader.problem(node, fmt::format("[cells] must have first and last, R numbers of at most "
                                         "{} cells",
                                         kCellsMax));
    } else if (cells.first + cells.offset < 0) {
      m_reader.problem(node, "offset of [cells] makes the first number negative");
    } else if (cells.isArray && !(cells.byCount + cells.byLast).empty()) {
      m_reader.problem(node,
                       "[cells] with array needs no blocks: leave out block_by_count and "
                       "block_by_last");
    } else if (isBrowsePath(cells.byCount) || isBrowsePath(cells.byLast)) {
      m_reader.problem(node,
                       "block_by_count and block_by_last of [cells] must be node ids, not "
                       "paths");
    }
  }

  void takeResolution(const toml::node& node, double& resolution) {
    const auto number = node.value<double>();
    if (!number || *number <= 0.0 || *number > kResolutionMax) {
      m_reader.problem(node, fmt::format("resolution of [cells] must be the smallest increment of "
                                         "the axes, above 0 and at most {}",
                                         kResolutionMax));
      return;
    }
    resolution = *number;
  }

  void takeMethods(const toml::node& node) {
    const toml::table* const section = m_reader.section(kMethodsSection, node);
    if (section == nullptr) {
      return;
    }
    MethodNodes& methods = m_map.methods;
    for (const auto& [key, value] : *section) {
      const auto is = [name = key.str()](const auto& one) { return one.first == name; };
      if (const auto* const method = findIn(kMethodKeys, is)) {
        takeAddress(key.str(), value, methods.*method->second);
      } else if (const auto* const path = findIn(kPathKeys, is)) {
        m_reader.takeText(key.str(), value, methods.*path->second);
        requirePlaces(value, key.str(), methods.*path->second, {"{}"});
      } else {
        m_reader.unknown(value, key.str(), kMethodsSection);
      }
    }
    if (methods.object.empty()) {
      m_reader.problem(node, "[methods] must have object: the node whose methods they are");
    }
  }

  void takeSection(const std::string& name, const toml::node& node) {
    const toml::table* const section = m_reader.section(name, node);
    if (section == nullptr) {
      return;
    }
    for (const auto& [key, value] : *section) {
      const std::string_view word = key.str();
      const auto is = [&](const auto& one) { return one.section == name && one.key == word; };
      if (const MapKey* const variable = findIn(kMapKeys, is)) {
        takeAddress(word, value, m_map.nodes[variable->variable]);
      } else if (const MapState* const state = findIn(kMapStates, is)) {
        takeState(*state, value);
      } else if (word == kUnitKey &&
                 findIn(kMapUnits, [&](const MapUnit& one) { return one.section == name; })) {
        takeUnit(name, value);
      } else {
        m_reader.unknown(value, word, name);
      }
    }
    requireStates(name, node, *section);
  }

  void takeState(const MapState& state, const toml::node& node) {
    const toml::array* const list = node.as_array();
    if (list == nullptr || list->empty()) {
      m_reader.problem(
          node, fmt::format("{} must be a list of values, like [0] or [\"idle\"]", state.key));
      return;
    }
    for (const toml::node& one : *list) {
      std::optional<StateValue> value;
      if (one.is_string()) {
        value = *one.value<std::string>();
      } else if (one.is_boolean()) {
        value = *one.value<bool>() ? 1.0 : 0.0;
      } else if (one.is_integer()) {
        value = static_cast<double>(*one.value<std::int64_t>());
      }
      if (!value) {
        m_reader.problem(one, fmt::format("A value of {} must be a whole number, a text, true or "
                                          "false",
                                          state.key));
        return;
      }
      std::vector<StateMeaning>& meanings = m_map.states[state.kind];
      if (findIn(meanings, [&](const StateMeaning& known) { return known.value == *value; })) {
        m_reader.problem(one, fmt::format("A value of {} is in [{}] twice: it can mean one state "
                                          "only",
                                          state.key, state.section));
        return;
      }
      meanings.push_back({*value, state.state});
    }
  }

  void requireStates(const std::string& name, const toml::node& node, const toml::table& section) {
    // Which value of another maker means that nothing moves is never assumed.
    const bool isSafety = name == "channel" && section.contains("status");
    const bool hasAny =
        isSafety || std::any_of(kMapStates.begin(), kMapStates.end(), [&](const MapState& one) {
          return one.section == name && section.contains(one.key);
        });
    for (const MapState& state : kMapStates) {
      if (hasAny && state.isNeeded && state.section == name && !section.contains(state.key)) {
        m_reader.problem(node, fmt::format("[{}] must say which values mean {}", name, state.key));
      }
    }
  }

  void takeUnit(const std::string& name, const toml::node& node) {
    std::string text;
    m_reader.takeText(kUnitKey, node, text);
    std::vector<std::string_view> names;
    for (const MapUnit& unit : kMapUnits) {
      if (unit.section == name) {
        names.push_back(unit.name);
        if (unit.name == text) {
          m_map.scales[unit.kind] = unit.scale;
          return;
        }
      }
    }
    m_reader.problem(node,
                     fmt::format("unit of [{}] must be one of {}", name, fmt::join(names, ", ")));
  }

  TableReader m_reader;
  ControlMap m_map;
};

/// A basic string of TOML.
std::string tomlString(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string valueText(const StateValue& value) {
  const double* const number = std::get_if<double>(&value);
  return number == nullptr ? tomlString(std::get<std::string>(value)) : base::formatNumber(*number);
}

void writeLine(std::string& text, std::string_view key, const std::string& value) {
  text += fmt::format("{} = {}\n", key, value);
}
void writeText(std::string& text, std::string_view key, const std::string& value) {
  if (!value.empty()) {
    writeLine(text, key, tomlString(value));
  }
}

std::string cellsText(const CellNodes& cells) {
  std::string text;
  if (cells.last < cells.first) {
    return text;
  }
  writeText(text, cells.isArray ? "array" : "node", cells.node);
  writeLine(text, "first", std::to_string(cells.first));
  writeLine(text, "last", std::to_string(cells.last));
  if (cells.offset != 0) {
    writeLine(text, "offset", std::to_string(cells.offset));
  }
  if (cells.resolution > 0.0) {
    writeLine(text, "resolution", base::formatNumber(cells.resolution));
  }
  writeText(text, "block_by_count", cells.byCount);
  writeText(text, "block_by_last", cells.byLast);
  return text;
}

std::string sectionText(const ControlMap& map, std::string_view section) {
  std::string text;
  for (const MapKey& key : kMapKeys) {
    const auto node = map.nodes.find(key.variable);
    if (key.section == section && node != map.nodes.end()) {
      writeText(text, key.key, node->second);
    }
  }
  for (const MapUnit& unit : kMapUnits) {
    const auto scale = map.scales.find(unit.kind);
    if (unit.section == section && scale != map.scales.end() && scale->second == unit.scale) {
      writeText(text, kUnitKey, std::string(unit.name));
    }
  }
  for (const MapState& state : kMapStates) {
    const auto states = map.states.find(state.kind);
    std::vector<std::string> values;
    for (const StateMeaning& meaning :
         states == map.states.end() ? std::vector<StateMeaning>() : states->second) {
      if (meaning.state == state.state) {
        values.push_back(valueText(meaning.value));
      }
    }
    if (state.section == section && !values.empty()) {
      writeLine(text, state.key, fmt::format("[{}]", fmt::join(values, ", ")));
    }
  }
  return text;
}

std::string methodsText(const MethodNodes& methods) {
  std::string text;
  if (methods.object.empty()) {
    return text;
  }
  for (const auto& [key, member] : kMethodKeys) {
    writeText(text, key, methods.*member);
  }
  for (const auto& [key, member] : kPathKeys) {
    writeText(text, key, methods.*member);
  }
  return text;
}

}  // namespace

base::Result<ControlMap> parseControlMap(std::string_view text, const std::string& path) {
  return MapFileReader(path).read(text);
}

base::Result<ControlMap> readControlMap(const std::string& path) {
  const auto text = base::readFile(path, TableReader::kBytesMax);
  if (!text) {
    return base::fail(text.error());
  }
  return parseControlMap(*text, path);
}

std::string controlMapText(const ControlMap& map) {
  std::string text;
  const auto add = [&text](std::string_view section, const std::string& body) {
    if (!body.empty()) {
      text += fmt::format("{}[{}]\n{}", text.empty() ? "" : "\n", section, body);
    }
  };
  add(kCellsSection, cellsText(map.cells));
  std::string_view last;
  for (const MapKey& key : kMapKeys) {
    if (key.section != last) {
      last = key.section;
      add(last, sectionText(map, last));
    }
  }
  add(kMethodsSection, methodsText(map.methods));
  return text;
}

}  // namespace rivulet::opcua
