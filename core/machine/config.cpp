// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/config.h"

#include <fmt/format.h>
#include <presets_texts.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "base/file.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/units.h"
#include "emulator/emulator.h"

namespace rivulet::machine {

namespace {

using base::Result;

template <class Value, std::size_t count>
using Choices = std::array<std::pair<std::string_view, Value>, count>;

/// Reads keys of a preset and remembers the first problem; unknown keys are found at the end.
class Reader {
 public:
  Reader(const toml::table& root, std::string origin) : m_root(root), m_origin(std::move(origin)) {}

  /// Number at a dotted path, within [min, max].
  double number(const std::string& path, double min, double max) {
    const toml::node* node = find(path);
    if (node == nullptr) {
      return min;
    }
    const std::optional<double> value = node->value<double>();
    if (!value || !node->is_number()) {
      problem(path, "must be a number", node);
      return min;
    }
    if (!(*value >= min && *value <= max)) {
      problem(path, fmt::format("is {} but must be between {} and {}", *value, min, max), node);
      return min;
    }
    return *value;
  }

  bool flag(const std::string& path) {
    const toml::node* node = find(path);
    if (node == nullptr) {
      return false;
    }
    if (!node->is_boolean()) {
      problem(path, "must be true or false", node);
      return false;
    }
    return node->value<bool>().value_or(false);
  }

  /// No problem if it is missing.
  [[nodiscard]] bool has(const std::string& path) const {
    return m_root.at_path(path).node() != nullptr;
  }

  /// One of a few words. @return its value; the first one's if the word is unknown
  template <class Value, std::size_t count>
  Value choice(const std::string& path, const Choices<Value, count>& choices) {
    const toml::node* node = find(path);
    const std::string word = node == nullptr ? "" : node->value<std::string>().value_or("");
    std::string allowed;
    for (const auto& [name, value] : choices) {
      if (word == name) {
        return value;
      }
      allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : " or ", name);
    }
    problem(path, "must be " + allowed, node);
    return choices.front().second;
  }

  std::array<double, 2> range(const std::string& path) {
    const toml::node* node = find(path);
    if (node == nullptr) {
      return {0.0, 1.0};
    }
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != 2 || !(*array)[0].is_number() ||
        !(*array)[1].is_number()) {
      problem(path, "must be a list of two numbers", node);
      return {0.0, 1.0};
    }
    const std::array<double, 2> values{(*array)[0].value<double>().value_or(0.0),
                                       (*array)[1].value<double>().value_or(0.0)};
    if (!(values[0] < values[1])) {
      problem(path, "must ascend", node);
    }
    return values;
  }

  /// A list of texts; one that is not allowed is a problem.
  std::set<std::string> words(const std::string& path, const std::set<std::string>& allowed) {
    const toml::node* node = find(path);
    if (node == nullptr) {
      return {};
    }
    const std::string expected =
        fmt::format("must be a list of \"{}\"", fmt::join(allowed, "\", \""));
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      problem(path, expected, node);
      return {};
    }
    std::set<std::string> words;
    for (const toml::node& element : *array) {
      const std::string word = element.value<std::string>().value_or("");
      if (!allowed.contains(word)) {
        problem(path, expected, node);
      }
      words.insert(word);
    }
    return words;
  }

  /// Names of the keys of a table; none if it is missing.
  [[nodiscard]] std::vector<std::string> keys(const std::string& path) const {
    std::vector<std::string> names;
    if (const toml::table* table = m_root.at_path(path).as_table()) {
      for (const auto& [key, node] : *table) {
        names.emplace_back(key.str());
      }
    }
    return names;
  }

  /// Numbers within [min, max]. @param count  how many there must be; 0: one at least
  std::vector<double> numbers(const std::string& path, std::size_t count, double min, double max) {
    const toml::node* node = find(path);
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    std::vector<double> values;
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
      const std::optional<double> value = (*array)[i].value<double>();
      if (!(*array)[i].is_number() || !(*value >= min && *value <= max)) {
        break;
      }
      values.push_back(*value);
    }
    const bool isWhole = array != nullptr && values.size() == array->size() &&
                         (count == 0 ? !values.empty() : values.size() == count);
    if (!isWhole && node != nullptr) {
      problem(path,
              fmt::format("must be a list of {} between {} and {}",
                          count == 0 ? "numbers" : fmt::format("{} numbers", count), min, max),
              node);
    }
    values.resize(isWhole ? values.size() : std::max<std::size_t>(count, 1));
    return values;
  }

  /// How many tables a list of tables has; none if it is missing.
  [[nodiscard]] std::size_t tables(const std::string& path) {
    const toml::node* node = find(path);
    const toml::array* array = node == nullptr ? nullptr : node->as_array();
    const bool isWhole = array != nullptr &&
                         std::all_of(array->begin(), array->end(),
                                     [](const toml::node& element) { return element.is_table(); });
    if (node != nullptr && !isWhole) {
      problem(path, "must be a list of tables", node);
    }
    return isWhole ? array->size() : 0;
  }

  std::string text(const std::string& path) {
    const toml::node* node = find(path);
    if (node != nullptr && !node->is_string()) {
      problem(path, "must be a text", node);
    }
    return node == nullptr ? "" : node->value<std::string>().value_or("");
  }

  void problem(const std::string& path, const std::string& what, const toml::node* node) {
    if (!m_problem.empty()) {
      return;
    }
    m_problem = node == nullptr
                    ? fmt::format("{} {}", path, what)
                    : fmt::format("line {}: {} {}", node->source().begin.line, path, what);
  }

  /// The first problem, an unknown key included; empty if there is none.
  std::string finish() {
    checkUnknown(m_root, "");
    return m_problem;
  }

 private:
  const toml::node* find(const std::string& path) {
    m_known.insert(path);
    const toml::node* node = m_root.at_path(path).node();
    if (node == nullptr) {
      problem(path, "is missing", nullptr);
    }
    return node;
  }

  void checkUnknown(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string path =
          prefix.empty() ? std::string(key.str()) : prefix + "." + std::string(key.str());
      const toml::array* const array = node.as_array();
      for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
        if (const toml::table* element = (*array)[i].as_table()) {
          checkUnknown(*element, fmt::format("{}[{}]", path, i));
        }
      }
      if (m_known.contains(path)) {
        continue;
      }
      if (const toml::table* inner = node.as_table()) {
        checkUnknown(*inner, path);
      } else {
        problem(path, "is not a known setting", &node);
      }
    }
  }

  const toml::table& m_root;
  std::string m_origin;
  std::string m_problem;
  std::set<std::string> m_known;
};

base::Duration milliseconds(Reader& reader, const std::string& path, double min, double max) {
  return base::fromMilliseconds(reader.number(path, min, max));
}

void readAxes(Reader& reader, MachineConfig& config) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const std::string prefix = fmt::format("axes.{}.", base::kAxisNames[axis]);
    AxisLimits& limits = config.axes[axis];
    const std::array<double, 2> position = reader.range(prefix + "positionMm");
    limits.positionMmMin = position[0];
    limits.positionMmMax = position[1];
    limits.speedMmPerSMax =
        base::mmPerSFromMmPerMin(reader.number(prefix + "speedMmPerMin", 1.0, 1e6));
    limits.accelerationMmPerS2Max = reader.number(prefix + "accelerationMmPerS2", 1.0, 1e6);
    limits.jerkMmPerS3Max = reader.number(prefix + "jerkMmPerS3", 1.0, 1e9);
    limits.servoTimeConstantS = reader.number(prefix + "servoTimeConstantMs", 0.0, 1000.0) * 1e-3;
    limits.startMm = reader.number(prefix + "startMm", position[0], position[1]);
  }
}

/// A machine has the rotary axes that its preset names.
void readRotaryAxes(Reader& reader, MachineConfig& config) {
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const std::string table = fmt::format("axes.{}", base::kRotaryAxisNames[axis]);
    if (!reader.has(table)) {
      continue;
    }
    const std::string prefix = table + ".";
    RotaryLimits& limits = config.rotaryAxes[axis].emplace();
    const std::array<double, 2> position = reader.range(prefix + "positionDeg");
    limits.positionDegMin = position[0];
    limits.positionDegMax = position[1];
    limits.speedDegPerSMax = reader.number(prefix + "speedDegPerS", 0.1, 1e5);
    limits.accelerationDegPerS2Max = reader.number(prefix + "accelerationDegPerS2", 1.0, 1e6);
    limits.jerkDegPerS3Max = reader.number(prefix + "jerkDegPerS3", 1.0, 1e9);
    limits.servoTimeConstantS = reader.number(prefix + "servoTimeConstantMs", 0.0, 1000.0) * 1e-3;
    limits.startDeg = reader.number(prefix + "startDeg", position[0], position[1]);
  }
}

void readControl(Reader& reader, MachineConfig& config) {
  config.interpolationCycle = milliseconds(reader, "control.interpolationCycleMs", 0.1, 100.0);
  config.positionCycle = milliseconds(reader, "control.positionCycleMs", 0.01, 100.0);
  config.blockPreparation = milliseconds(reader, "control.blockPreparationMs", 0.01, 1000.0);
  config.bufferedBlocksMax =
      static_cast<int>(reader.number("control.bufferedBlocks", 1.0, 100000.0));
  config.standstillMean = milliseconds(reader, "control.standstillMs.mean", 0.0, 10000.0);
  config.standstillDeviation = milliseconds(reader, "control.standstillMs.deviation", 0.0, 1000.0);
  config.relatch = milliseconds(reader, "control.relatchMs", 0.0, 10000.0);
  config.rRead = reader.choice(
      "control.rRead",
      Choices<RParameterReading, 2>{{{"atInterpretation", RParameterReading::AtInterpretation},
                                     {"cachedUntilStopre", RParameterReading::CachedUntilStopre}}});
  config.jumpStops = reader.flag("control.jumpStops");
  config.access.keepsFrame = reader.has("access.keepsFrame") && reader.flag("access.keepsFrame");
  config.resetDynamics =
      reader.choice("control.resetDynamics",
                    Choices<Dynamics, 2>{{{"BRISK", Dynamics::Brisk}, {"SOFT", Dynamics::Soft}}});
  config.blocksPerCycleMax = reader.number("control.blocksPerCycleMax", 0.0, 1000.0);
  if (reader.has("control.overlayMm")) {
    config.overlay.mostMm = reader.number("control.overlayMm", 0.0, 1e8);
  }
  if (reader.has("control.overlayMode")) {
    config.overlay.mode = static_cast<int>(reader.number("control.overlayMode", 0.0, 3.0));
  }
  config.roundingMm = reader.number("control.roundingMm", 0.0, 10.0);
  config.rParameterCount = static_cast<int>(reader.number("control.rParameters", 1.0, 32535.0));
  config.rapidMmPerS = base::mmPerSFromMmPerMin(reader.number("control.rapidMmPerMin", 1.0, 1e6));
  if (reader.has("control.defaultFeedMmPerMin")) {
    config.defaultFeedMmPerS =
        base::mmPerSFromMmPerMin(reader.number("control.defaultFeedMmPerMin", 0.0, 1e6));
  }
  config.traceLimit = base::fromSeconds(reader.number("control.traceMinutes", 0.0, 1440.0) * 60.0);
}

void readAccess(Reader& reader, AccessCost& access) {
  access.readOverhead = milliseconds(reader, "access.readOverheadMs", 0.0, 10000.0);
  access.writeOverhead = milliseconds(reader, "access.writeOverheadMs", 0.0, 10000.0);
  access.nodeTimeMean = milliseconds(reader, "access.nodeTimeMs.mean", 0.0, 10000.0);
  access.nodeTimeDeviation = milliseconds(reader, "access.nodeTimeMs.deviation", 0.0, 10000.0);
  access.samplingMin = milliseconds(reader, "access.minimumSamplingMs", 1.0, 10000.0);
  access.nodeTimeMin = milliseconds(reader, "access.nodeTimeMs.min", 0.0, 10000.0);
  const std::set<std::string> forms = reader.words("access.arrayForms", {"count", "range"});
  access.arrays.count = forms.contains("count");
  access.arrays.range = forms.contains("range");
  access.arrays.write = reader.choice(
      "access.arrayWrite", Choices<ArrayWrite, 3>{{{"all", ArrayWrite::All},
                                                   {"refused", ArrayWrite::Refused},
                                                   {"firstOnly", ArrayWrite::FirstOnly}}});
  access.arrays.charge = reader.choice(
      "access.arrayCharge",
      Choices<ArrayCharge, 2>{{{"element", ArrayCharge::Element}, {"node", ArrayCharge::Node}}});
  access.programOverhead = milliseconds(reader, "access.programOverheadMs", 0.0, 60000.0);
  access.programBytesPerS = 1e3 * reader.number("access.programKilobytesPerS", 1e-3, 1e9);
}

constexpr double kLengthMmMax = 1e4;

/// The key of G54 to G57 and G500 to G599. @return nothing for another word
std::optional<int> workOffsetKey(std::string_view word) {
  const std::optional<int> number =
      word.starts_with('G') ? base::parseInteger(word.substr(1)) : std::nullopt;
  const bool isOne =
      number && ((*number >= 54 && *number <= 57) || *number == kNoWorkOffsetKey / 10 ||
                 (*number >= 505 && *number <= 599));
  return isOne ? std::optional(*number * 10) : std::nullopt;
}

void readPlaces(Reader& reader, MachineConfig& config) {
  const auto place = [&reader](const std::string& path) {
    const std::vector<double> mm = reader.numbers(path, 3, -kLengthMmMax, kLengthMmMax);
    return base::Vec3{mm[0], mm[1], mm[2]};
  };
  for (const std::string& name : reader.keys("workOffsetsMm")) {
    if (const std::optional<int> key = workOffsetKey(name)) {
      config.workOffsetsMm[*key] = place("workOffsetsMm." + name);
    }
  }
  for (const std::string& name : reader.keys("fixedPointsMm")) {
    const std::optional<int> number = name.starts_with("FP")
                                          ? base::parseInteger(std::string_view(name).substr(2))
                                          : std::nullopt;
    if (number && *number >= 1 && *number <= 4) {
      config.fixedPointsMm[*number] = place("fixedPointsMm." + name);
    }
  }
}

void readTools(Reader& reader, ToolTable& table) {
  table.changeTime = base::fromSeconds(reader.number("tools.changeSeconds", 0.0, 1000.0));
  table.acceptsMissing =
      reader.choice("tools.missing", Choices<bool, 2>{{{"alarm", false}, {"accepted", true}}});
  const std::size_t count = reader.tables("tools.table");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string prefix = fmt::format("tools.table[{}].", i);
    Tool tool;
    tool.number = static_cast<int>(reader.number(prefix + "number", 1.0, 32000.0));
    tool.name = reader.has(prefix + "name") ? reader.text(prefix + "name") : "";
    const std::vector<double> lengths =
        reader.numbers(prefix + "lengthMm", 0, -kLengthMmMax, kLengthMmMax);
    const std::vector<double> radii =
        reader.numbers(prefix + "radiusMm", lengths.size(), 0.0, kLengthMmMax);
    for (std::size_t edge = 0; edge < lengths.size(); ++edge) {
      tool.edges.push_back({lengths[edge], radii[edge]});
    }
    if (table.find(tool.number)) {
      reader.problem(prefix + "number", fmt::format("is {} for two tools", tool.number), nullptr);
    }
    table.tools.push_back(std::move(tool));
  }
}

/// What a preset may leave out.
void readEquipment(Reader& reader, MachineConfig& config) {
  if (reader.has("spindle")) {
    SpindleConfig& spindle = config.spindle.emplace();
    spindle.speedPerMinMax = reader.number("spindle.speedPerMinMax", 1.0, 1e6);
    spindle.runUp = base::fromSeconds(reader.number("spindle.runUpSeconds", 0.0, 1000.0));
  }
  if (reader.has("tools")) {
    readTools(reader, config.tools.emplace());
  }
  if (reader.has("coolant")) {
    config.coolantTime = milliseconds(reader, "coolant.switchMs", 0.0, 60000.0);
  }
  if (reader.has("control.programStop")) {
    config.programStop = reader.flag("control.programStop");
  }
  if (reader.has("control.optionalStop")) {
    config.optionalStop = reader.flag("control.optionalStop");
  }
  readPlaces(reader, config);
}

/// Once users are listed, nobody else is let in unless the preset says so.
void readUsers(Reader& reader, UserManagement& management) {
  if (reader.has("users.list")) {
    management.anonymous = false;
    for (std::size_t i = 0, count = reader.tables("users.list"); i < count; ++i) {
      const std::string prefix = fmt::format("users.list[{}].", i);
      User user;
      user.name = reader.text(prefix + "name");
      if (user.name.empty()) {
        reader.problem(prefix + "name", "must not be empty", nullptr);
      }
      if (reader.has(prefix + "certificate")) {
        user.certificate = base::sha256OfText(reader.text(prefix + "certificate"));
        if (user.certificate.empty()) {
          reader.problem(prefix + "certificate", "must be a fingerprint of 64 hexadecimal digits",
                         nullptr);
        }
      }
      if (user.certificate.empty() || reader.has(prefix + "password")) {
        const auto password = passwordOfText(reader.text(prefix + "password"));
        if (!password) {
          reader.problem(prefix + "password", "must be what rivulet-machine --hash-password prints",
                         nullptr);
        }
        user.password = password.value_or(HashedPassword());
      }
      user.rights = reader.words(prefix + "rights", userRights());
      management.users.push_back(std::move(user));
    }
  }
  if (reader.has("users.anonymous")) {
    management.anonymous = reader.flag("users.anonymous");
  }
}

Result<toml::table> parseTable(std::string_view text, const std::string& origin) {
  if (base::hasEndlessKey(text)) {
    return base::fail(MachineError::PresetMalformed,
                      "This is not a machine preset: a key has too many parts.", origin);
  }
  try {
    return toml::table(toml::parse(text));
  } catch (const toml::parse_error& error) {
    return base::fail(MachineError::PresetMalformed,
                      fmt::format("The preset cannot be read at line {}: {}. Correct the file.",
                                  error.source().begin.line, error.description()),
                      origin);
  }
}

Result<std::string> presetText(const std::string& nameOrPath) {
  if (!isPresetPath(nameOrPath)) {
    for (const auto& entry : presets::kEmbeddedTexts) {
      if (entry.name == nameOrPath) {
        return std::string(entry.text);
      }
    }
    return base::fail(MachineError::PresetMissing,
                      fmt::format("There is no machine preset \"{}\". Choose one of {}, or give "
                                  "the path of a .toml file.",
                                  nameOrPath, fmt::join(presetNames(), ", ")));
  }
  Result<std::string> text = base::readFile(nameOrPath, kPresetBytesMax);
  if (!text) {
    return base::fail(MachineError::PresetMissing, text.error().message, nameOrPath);
  }
  return text;
}

/// What `parseEmulator` has read is no setting of the machine.
void takeOutEmulator(toml::table& root) {
  root.erase("emulator");
  for (const char letter : base::kAxisNames) {
    if (toml::table* axis = root.at_path(fmt::format("axes.{}", letter)).as_table()) {
      axis->erase("servo");
    }
  }
}

/// Takes what a preset lacks from another one.
void addMissing(toml::table& table, const toml::table& from) {
  for (const auto& [key, node] : from) {
    toml::node* const own = table.get(key);
    if (own == nullptr) {
      table.insert(key, node);
    } else if (own->is_table() && node.is_table()) {
      addMissing(*own->as_table(), *node.as_table());
    }
  }
}

/// @param preset  name or path of the one that has what is missing; empty: nothing is
Result<void> complete(toml::table& root, const std::string& preset, const std::string& origin) {
  if (preset.empty()) {
    return {};
  }
  const std::filesystem::path path(preset);
  const bool isBeside = isPresetPath(preset) && path.is_relative();
  const std::string named =
      isBeside ? (std::filesystem::path(origin).parent_path() / path).string() : preset;
  const Result<std::string> text = presetText(named);
  if (!text) {
    return base::fail(text.error());
  }
  Result<toml::table> other = parseTable(*text, named);
  if (!other) {
    return base::fail(other.error());
  }
  if (other->contains("emulator")) {
    return base::fail(MachineError::PresetMalformed,
                      fmt::format("The preset cannot be used: emulator.preset names {}, which is "
                                  "an emulator itself. Name the preset of a machine.",
                                  preset),
                      origin);
  }
  addMissing(root, *other);
  return {};
}

}  // namespace

std::error_code make_error_code(MachineError code) {
  static const base::NamedCategory category("machine");
  return {static_cast<int>(code), category};
}

std::optional<Tool> ToolTable::find(int number) const {
  const auto found = std::find_if(tools.begin(), tools.end(),
                                  [number](const Tool& tool) { return tool.number == number; });
  return found == tools.end() ? std::nullopt : std::optional(*found);
}

std::optional<Tool> ToolTable::find(std::string_view name) const {
  const auto found = std::find_if(tools.begin(), tools.end(), [name](const Tool& tool) {
    return base::toUpper(tool.name) == base::toUpper(name);
  });
  return found == tools.end() ? std::nullopt : std::optional(*found);
}

double MachineConfig::feedMmPerSMax() const {
  double fastest = rapidMmPerS;
  for (const AxisLimits& axis : axes) {
    fastest = std::max(fastest, axis.speedMmPerSMax);
  }
  return fastest;
}

base::AxisPosition MachineConfig::start() const {
  base::AxisPosition position{{axes[0].startMm, axes[1].startMm, axes[2].startMm}, {}};
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    position.deg[axis] = rotaryAxes[axis] ? rotaryAxes[axis]->startDeg : 0.0;
  }
  return position;
}

std::optional<std::size_t> MachineConfig::rotaryAt(int index) const {
  int next = static_cast<int>(base::kAxisCount);
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (rotaryAxes[axis] && next++ == index) {
      return axis;
    }
  }
  return std::nullopt;
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  for (const auto& entry : presets::kEmbeddedTexts) {
    names.emplace_back(entry.name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<emulator::AxisParameters> MachineConfig::axisLaw(std::size_t axis) const {
  if (learnedAxes[axis]) {
    return learnedAxes[axis];
  }
  const double timeConstantS = axes[axis].servoTimeConstantS;
  return timeConstantS > 0.0 ? std::optional(emulator::firstOrderLag(timeConstantS)) : std::nullopt;
}

base::Duration MachineConfig::followingLag() const {
  double lagS = 0.0;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (const auto law = axisLaw(axis)) {
      lagS = std::max(lagS, emulator::followingLagS(*law));
    }
  }
  return base::fromSeconds(lagS);
}

bool isPresetPath(const std::string& nameOrPath) {
  return nameOrPath.find('/') != std::string::npos || nameOrPath.ends_with(".toml");
}

Result<MachineConfig> parsePreset(std::string_view text, const std::string& origin) {
  Result<toml::table> root = parseTable(text, origin);
  if (!root) {
    return base::fail(root.error());
  }
  MachineConfig config;
  if (root->contains("emulator")) {
    auto learned = emulator::parseEmulator(text, origin);
    if (!learned) {
      return base::fail(MachineError::PresetMalformed, learned.error().message, origin);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (const emulator::LearnedAxis* one = learned->find(base::kAxisNames[axis])) {
        config.learnedAxes[axis] = one->parameters;
      }
    }
    takeOutEmulator(*root);
    if (auto completed = complete(*root, learned->preset, origin); !completed) {
      return base::fail(completed.error());
    }
  }
  Reader reader(*root, origin);
  readAxes(reader, config);
  readRotaryAxes(reader, config);
  readControl(reader, config);
  readAccess(reader, config.access);
  readEquipment(reader, config);
  readUsers(reader, config.users);
  if (const std::string problem = reader.finish(); !problem.empty()) {
    return base::fail(MachineError::PresetMalformed,
                      fmt::format("The preset cannot be used: {}. Correct the file.", problem),
                      origin);
  }
  return config;
}

Result<MachineConfig> loadPreset(const std::string& nameOrPath) {
  const Result<std::string> text = presetText(nameOrPath);
  if (!text) {
    return base::fail(text.error());
  }
  Result<MachineConfig> config = parsePreset(*text, nameOrPath);
  if (config) {
    config->name =
        isPresetPath(nameOrPath) ? std::filesystem::path(nameOrPath).stem().string() : nameOrPath;
  }
  return config;
}

}  // namespace rivulet::machine
