// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "trace/formula.h"
#include "trace/import/import_error.h"

namespace rivulet::trace {

namespace {

constexpr std::array<std::string_view, kSignalRoleCount> kRoleNames{
    "time",    "x_set",   "y_set",   "z_set",      "x_act",           "y_act", "z_act",
    "x_speed", "y_speed", "z_speed", "path_speed", "programmed_feed", "line",  "override"};

/// A file may begin that much before or after another one.
constexpr double kOffsetSMax = 1e8;

struct Unit {
  std::string_view name;
  double factor;
};
constexpr std::array<Unit, 10> kTimeUnits{{{"s", 1.0},
                                           {"sec", 1.0},
                                           {"ms", 1e-3},
                                           {"us", 1e-6},
                                           {"µs", 1e-6},
                                           {"μs", 1e-6},
                                           {"ns", 1e-9},
                                           {"100ns", 1e-7},
                                           {"min", 60.0},
                                           {"h", 3600.0}}};
constexpr std::array<Unit, 9> kLengthUnits{{{"mm", 1.0},
                                            {"um", 1e-3},
                                            {"µm", 1e-3},
                                            {"μm", 1e-3},
                                            {"nm", 1e-6},
                                            {"cm", 10.0},
                                            {"m", 1000.0},
                                            {"in", 25.4},
                                            {"inch", 25.4}}};
constexpr std::array<Unit, 7> kSpeedUnits{{{"mm/s", 1.0},
                                           {"mm/min", 1.0 / 60.0},
                                           {"m/s", 1000.0},
                                           {"m/min", 1000.0 / 60.0},
                                           {"um/s", 1e-3},
                                           {"in/min", 25.4 / 60.0},
                                           {"in/s", 25.4}}};

template <std::size_t N>
std::optional<double> factorIn(const std::array<Unit, N>& units, std::string_view name) {
  const auto found = std::find_if(units.begin(), units.end(),
                                  [name](const Unit& unit) { return unit.name == name; });
  return found == units.end() ? std::nullopt : std::optional(found->factor);
}

bool isSpeed(SignalRole role) {
  return role >= SignalRole::XSpeed && role <= SignalRole::ProgrammedFeed;
}

bool isAnyUnit(std::string_view name) {
  return factorIn(kTimeUnits, name) || factorIn(kLengthUnits, name) ||
         factorIn(kSpeedUnits, name) || name == "deg" || name == "°" || name == "%" ||
         name == "rpm" || name == "A" || name == "V" || name == "Nm" || name == "mm/s²" ||
         name == "mm/s^2" || name == "m/s^2" || name == "1" || name == "-";
}

/// The words of a name: letters and digits apart, capitals begin a word.
std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  char before = ' ';
  for (const char c : name) {
    const bool isLetter = base::isNameLetter(c) && c != '_';
    const bool isUpper = c >= 'A' && c <= 'Z';
    const bool wasLetter = base::isNameLetter(before) && before != '_';
    const bool wasLower = wasLetter && !(before >= 'A' && before <= 'Z');
    if (isLetter || base::isDigit(c) || static_cast<unsigned char>(c) >= 0x80) {
      const bool begins = words.empty() || before == ' ' || (isUpper && wasLower) ||
                          base::isDigit(c) != base::isDigit(before);
      if (begins) {
        words.emplace_back();
      }
      words.back() += isUpper ? static_cast<char>(c - 'A' + 'a') : c;
      before = c;
    } else {
      before = ' ';
    }
  }
  return words;
}

using Words = std::vector<std::string>;

bool holdsOne(const Words& words, std::initializer_list<std::string_view> of) {
  return std::any_of(words.begin(), words.end(), [&of](const std::string& word) {
    return std::find(of.begin(), of.end(), word) != of.end();
  });
}

/// 0, 1, 2 for X, Y, Z.
std::optional<std::size_t> axisOf(const Words& words) {
  static constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  static constexpr std::array<std::string_view, 9> kPrefixed{"posx", "posy", "posz", "vx",  "vy",
                                                             "vz",   "xact", "yact", "zact"};
  static constexpr std::array<std::string_view, 3> kNumbered{"1", "2", "3"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      const bool isNumberOfAxis =
          word == kNumbered[axis] && i > 0 &&
          (words[i - 1] == "axis" || words[i - 1] == "achse" || words[i - 1] == "ax");
      // The joints of LinuxCNC count from 0.
      const bool isJoint = i > 0 && words[i - 1] == "joint" && word == std::to_string(axis);
      // "… [u1, 2]": the second axis of unit 1.
      const bool isIndex = i + 1 == words.size() && i >= 2 && words[i - 2] == "u" &&
                           words[i - 1] == "1" && word == kNumbered[axis];
      if (word == kAxes[axis] || word == kPrefixed[axis] || word == kPrefixed[axis + 3] ||
          word == kPrefixed[axis + 6] || isNumberOfAxis || isJoint || isIndex) {
        return axis;
      }
    }
  }
  return std::nullopt;
}

std::optional<SignalRole> roleNamed(std::string_view name) {
  const auto found = std::find(kRoleNames.begin(), kRoleNames.end(), name);
  return found == kRoleNames.end()
             ? std::nullopt
             : std::optional(static_cast<SignalRole>(found - kRoleNames.begin()));
}

/// "x_set - x_act": signals that were calculated are saved under their formula.
bool isCalculated(std::string_view name) {
  const auto formula = Formula::parse(name);
  return formula && !formula->isName() && !formula->names().empty() &&
         std::all_of(formula->names().begin(), formula->names().end(),
                     [](const std::string& one) { return roleNamed(one).has_value(); });
}

}  // namespace

std::string_view signalRoleName(SignalRole role) {
  return kRoleNames[static_cast<std::size_t>(role)];
}

base::Result<TableMapping> parseTableMapping(std::string_view text) {
  TableMapping mapping;
  while (!text.empty()) {
    const std::string_view item = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), item.size() + 1));
    const std::size_t equal = item.find('=');
    const std::string_view key = base::trim(item.substr(0, equal));
    std::string_view value =
        equal == std::string_view::npos ? std::string_view() : base::trim(item.substr(equal + 1));
    const auto number = base::parseNumber(value);
    const auto named = roleNamed(key);
    if (key == "rate" && number && *number > 0.0) {
      mapping.rateHz = *number;
    } else if (key == "offset" && number && std::abs(*number) <= kOffsetSMax) {
      mapping.offsetS = *number;
    } else if (key == "guess" && value == "no") {
      mapping.isComplete = true;
    } else if (!named || value.empty()) {
      return base::fail(ImportError::BadMapping,
                        fmt::format("\"{}\" maps no column. Write ROLE=COLUMN or ROLE=COLUMN:UNIT "
                                    "with one of the roles {}; or rate=HZ, offset=SECONDS, "
                                    "guess=no.",
                                    item, fmt::join(kRoleNames, ", ")));
    } else {
      ColumnRole role;
      role.role = *named;
      const std::size_t colon = value.rfind(':');
      if (colon != std::string_view::npos && unitFactor(value.substr(colon + 1), role.role)) {
        role.unit = value.substr(colon + 1);
        value = value.substr(0, colon);
      }
      role.column = value;
      const bool isTaken =
          std::any_of(mapping.columns.begin(), mapping.columns.end(),
                      [&role](const ColumnRole& one) { return one.role == role.role; });
      if (isTaken && role.role != SignalRole::Time) {
        return base::fail(ImportError::RoleTwice,
                          fmt::format("Two columns are to be {}. Choose one of them.", key),
                          std::string(key));
      }
      mapping.columns.push_back(std::move(role));
    }
  }
  return mapping;
}

std::string printTableMapping(const TableMapping& mapping) {
  std::string text = printColumnRoles(mapping.columns);
  const auto add = [&text](const std::string& item) { text += text.empty() ? item : "," + item; };
  if (mapping.rateHz) {
    add(fmt::format("rate={}", *mapping.rateHz));
  }
  if (mapping.offsetS != 0.0) {
    add(fmt::format("offset={}", mapping.offsetS));
  }
  if (mapping.isComplete) {
    add("guess=no");
  }
  return text;
}

std::string columnReference(std::string_view name, std::size_t index) {
  const bool isPlain = !name.empty() && name.front() != '#' && base::trim(name) == name &&
                       name.find_first_of(",:=") == std::string_view::npos;
  return isPlain ? std::string(name) : fmt::format("#{}", index + 1);
}

std::vector<std::string_view> unitsOf(SignalRole role) {
  std::vector<std::string_view> names;
  const auto add = [&names](const auto& units) {
    for (const Unit& unit : units) {
      // One spelling of each.
      const bool isKnown = std::any_of(units.begin(), units.end(), [&](const Unit& other) {
        return &other < &unit && other.factor == unit.factor;
      });
      if (!isKnown) {
        names.push_back(unit.name);
      }
    }
  };
  if (role == SignalRole::Time) {
    add(kTimeUnits);
  } else if (isPosition(role)) {
    add(kLengthUnits);
  } else if (isSpeed(role)) {
    add(kSpeedUnits);
  } else if (role == SignalRole::Override) {
    names.emplace_back("%");
  }
  return names;
}

std::string printColumnRoles(const std::vector<ColumnRole>& roles) {
  std::string text;
  for (const ColumnRole& role : roles) {
    text += fmt::format("{}{}={}{}{}", text.empty() ? "" : ",", signalRoleName(role.role),
                        role.column, role.unit.empty() ? "" : ":", role.unit);
  }
  return text;
}

NameAndUnit splitUnit(std::string_view heading) {
  heading = base::trim(heading);
  const std::size_t bracket = heading.find_last_of("[(");
  if (bracket != std::string_view::npos && bracket > 0 &&
      (heading.back() == ']' || heading.back() == ')')) {
    const std::string_view unit =
        base::trim(heading.substr(bracket + 1, heading.size() - bracket - 2));
    if (isAnyUnit(unit)) {
      return {std::string(base::trim(heading.substr(0, bracket))), std::string(unit)};
    }
  }
  if (const std::size_t slash = heading.find(" in "); slash != std::string_view::npos) {
    const std::string_view unit = base::trim(heading.substr(slash + 4));
    if (isAnyUnit(unit)) {
      return {std::string(base::trim(heading.substr(0, slash))), std::string(unit)};
    }
  }
  for (const char sign : {'/', '_'}) {
    const std::size_t at = heading.find(sign);
    const std::size_t last = sign == '_' ? heading.rfind(sign) : at;
    if (last == std::string_view::npos || last == 0) {
      continue;
    }
    const std::string_view unit = heading.substr(last + 1);
    // After an underscore, most letters are no unit: "x_min", "v_s".
    const bool isClear = sign == '/' || unit == "mm" || unit == "um" || unit == "ms" ||
                         unit == "us" || unit == "ns" || (unit == "s" && heading[0] == 't');
    if (isClear && isAnyUnit(unit)) {
      return {std::string(heading.substr(0, last)), std::string(heading.substr(last + 1))};
    }
  }
  return {std::string(heading), {}};
}

bool isUnit(std::string_view text) {
  if (text.size() > 2 && ((text.front() == '[' && text.back() == ']') ||
                          (text.front() == '(' && text.back() == ')'))) {
    return true;
  }
  return isAnyUnit(text);
}

std::optional<double> unitFactor(std::string_view unit, SignalRole role) {
  if (role == SignalRole::Time) {
    return factorIn(kTimeUnits, unit);
  }
  if (isPosition(role)) {
    return factorIn(kLengthUnits, unit);
  }
  if (isSpeed(role)) {
    return factorIn(kSpeedUnits, unit);
  }
  return role == SignalRole::Override && unit == "%" ? std::optional(0.01) : std::nullopt;
}

std::optional<SignalRole> guessRole(std::string_view name) {
  if (const auto named = roleNamed(name)) {
    return named;
  }
  if (isCalculated(name)) {
    return std::nullopt;
  }
  const Words words = wordsOf(name);
  if (words.empty()) {
    return std::nullopt;
  }
  if (words[0] == "t" ||
      holdsOne(words, {"time", "timestamp", "zeit", "temps", "tiempo", "tempo"})) {
    const bool isOther = holdsOne(words, {"cycle", "access", "remaining"});
    return isOther ? std::nullopt : std::optional(SignalRole::Time);
  }
  const bool isDerived = holdsOne(
      words, {"ferror",         "err",    "error", "lag",          "following", "flw",  "schlepp",
              "schleppabstand", "acc",    "accel", "acceleration", "jerk",      "ruck", "current",
              "torque",         "moment", "strom", "limit",        "min",       "max",  "status",
              "effort"});
  const bool isFeed =
      holdsOne(words, {"v", "vx", "vy", "vz", "vel", "velo", "velocity", "speed", "feed",
                       "feedrate", "geschw", "geschwindigkeit", "vorschub"});
  const bool isCommand =
      holdsOne(words, {"cmd", "command", "commanded", "set", "setpoint", "soll", "sollwert",
                       "sollpos", "ref", "reference", "desired", "nominal", "target"});
  const bool isActual = holdsOne(words, {"fb", "act", "actual", "ist", "istwert", "istpos",
                                         "feedback", "meas", "measured", "enc", "encoder"});
  const std::optional<std::size_t> axis = axisOf(words);
  if (isDerived) {
    return std::nullopt;
  }
  if (holdsOne(words, {"override", "ovr"})) {
    return SignalRole::Override;
  }
  if (axis) {
    if (isFeed) {
      return isActual ? std::nullopt : std::optional(roleForAxis(SignalRole::XSpeed, *axis));
    }
    return roleForAxis(isCommand ? SignalRole::XSet : SignalRole::XActual, *axis);
  }
  if (isFeed) {
    if (holdsOne(words, {"req", "requested", "prog", "programmed", "f"})) {
      return SignalRole::ProgrammedFeed;
    }
    const bool isOfPath = holdsOne(words, {"path", "bahn", "tool", "feed", "feedrate", "vorschub"});
    return isOfPath || words.size() == 1 ? std::optional(SignalRole::PathSpeed) : std::nullopt;
  }
  if (holdsOne(words, {"line", "lineno", "linenumber", "zeile", "satz", "satznummer", "block",
                       "ligne", "linea"})) {
    return SignalRole::Line;
  }
  return std::nullopt;
}

}  // namespace rivulet::trace
