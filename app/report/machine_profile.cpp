// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/machine_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/json_members.h"
#include "streaming/control/machine_facts.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;
using streaming::AxisProfile;
using streaming::MachineProfile;

constexpr double kMost = 1e9;
constexpr int kToolsMax = 1000;

ordered_json axisJson(const AxisProfile& axis) {
  return {{"position_min", axis.positionMin},
          {"position_max", axis.positionMax},
          {"speed_per_s_max", axis.speedPerSMax},
          {"acceleration_per_s2_max", axis.accelerationPerS2Max},
          {"jerk_per_s3_max", axis.jerkPerS3Max}};
}

AxisProfile axisOf(Members& members, const std::string& at) {
  const auto number = [&](const char* name, double min) {
    return members.number((at + "/" + name).c_str(), min, kMost);
  };
  return {number("position_min", -kMost), number("position_max", -kMost),
          number("speed_per_s_max", 0.0), number("acceleration_per_s2_max", 0.0),
          number("jerk_per_s3_max", 0.0)};
}

}  // namespace

ordered_json profileJson(const MachineProfile& profile) {
  ordered_json axes = ordered_json::object();
  for (std::size_t axis = 0; axis < profile.axes.size(); ++axis) {
    axes[std::string(1, base::kAxisNames[axis])] = axisJson(profile.axes[axis]);
  }
  for (std::size_t axis = 0; axis < profile.rotaryAxes.size(); ++axis) {
    if (profile.rotaryAxes[axis]) {
      axes[std::string(1, base::kRotaryAxisNames[axis])] = axisJson(*profile.rotaryAxes[axis]);
    }
  }
  ordered_json tools = ordered_json::array();
  for (const streaming::ToolProfile& tool : profile.tools) {
    tools.push_back({{"number", tool.number},
                     {"name", tool.name},
                     {"length_mm", tool.lengthMm},
                     {"radius_mm", tool.radiusMm}});
  }
  return {{"endpoint", profile.endpoint},
          {"server",
           {{"application_uri", profile.server.applicationUri},
            {"product", profile.server.productName},
            {"version", profile.server.softwareVersion},
            {"build", profile.server.buildNumber}}},
          {"entered_at_utc", profile.enteredAtUtc},
          {"entered_by", profile.enteredBy},
          {"name", profile.name},
          {"preset", profile.preset},
          {"axes", std::move(axes)},
          {"rapid_mm_per_s", profile.rapidMmPerS},
          {"spindle_per_min_max", profile.spindlePerMinMax},
          {"tools", std::move(tools)}};
}

base::Result<MachineProfile> profileOf(const ordered_json& from, const std::string& origin) {
  const nlohmann::json json = from;
  Members members(json);
  MachineProfile profile;
  profile.endpoint = members.text("/endpoint");
  profile.server = {members.text("/server/application_uri"), members.text("/server/product"),
                    members.text("/server/version"), members.text("/server/build")};
  profile.enteredAtUtc = members.text("/entered_at_utc");
  profile.enteredBy = members.text("/entered_by");
  profile.name = members.text("/name");
  profile.preset = members.text("/preset");
  for (std::size_t axis = 0; axis < profile.axes.size(); ++axis) {
    profile.axes[axis] = axisOf(members, fmt::format("/axes/{}", base::kAxisNames[axis]));
  }
  for (std::size_t axis = 0; axis < profile.rotaryAxes.size(); ++axis) {
    const std::string at = fmt::format("/axes/{}", base::kRotaryAxisNames[axis]);
    if (members.has(at.c_str())) {
      profile.rotaryAxes[axis] = axisOf(members, at);
    }
  }
  profile.rapidMmPerS = members.number("/rapid_mm_per_s", 0.0, kMost);
  profile.spindlePerMinMax = members.number("/spindle_per_min_max", 0.0, kMost);
  const nlohmann::json* tools = members.find("/tools");
  if (tools == nullptr || !tools->is_array() || tools->size() > kToolsMax) {
    members.refuse("/tools");
  } else {
    for (std::size_t i = 0; i < tools->size(); ++i) {
      const std::string at = fmt::format("/tools/{}", i);
      profile.tools.push_back(
          {members.integer<int>((at + "/number").c_str(), 0.0, std::numeric_limits<int>::max()),
           members.text((at + "/name").c_str()),
           members.number((at + "/length_mm").c_str(), -kMost, kMost),
           members.number((at + "/radius_mm").c_str(), -kMost, kMost)});
    }
  }
  if (!members.bad().empty() || problemOf(profile)) {
    return base::fail(streaming::MachineFileError::Damaged,
                      fmt::format("The limits of the machine are damaged at {}. Enter them again.",
                                  members.bad().empty() ? "a value" : members.bad()),
                      origin);
  }
  return profile;
}

base::Result<MachineProfile> profileOfPreset(const std::string& preset) {
  const auto config = machine::loadPreset(preset);
  if (!config) {
    return base::fail(config.error());
  }
  MachineProfile profile;
  profile.preset = preset;
  for (std::size_t axis = 0; axis < profile.axes.size(); ++axis) {
    const machine::AxisLimits& limits = config->axes[axis];
    profile.axes[axis] = {limits.positionMmMin, limits.positionMmMax, limits.speedMmPerSMax,
                          limits.accelerationMmPerS2Max, limits.jerkMmPerS3Max};
  }
  for (std::size_t axis = 0; axis < profile.rotaryAxes.size(); ++axis) {
    if (const auto& limits = config->rotaryAxes[axis]) {
      profile.rotaryAxes[axis] = {limits->positionDegMin, limits->positionDegMax,
                                  limits->speedDegPerSMax, limits->accelerationDegPerS2Max,
                                  limits->jerkDegPerS3Max};
    }
  }
  profile.rapidMmPerS = config->rapidMmPerS;
  profile.spindlePerMinMax = config->spindle ? config->spindle->speedPerMinMax : 0.0;
  if (config->tools) {
    for (const machine::Tool& tool : config->tools->tools) {
      if (tool.number > 0 && tool.hasEdge(1)) {
        profile.tools.push_back(
            {tool.number, tool.name, tool.edges.front().lengthMm, tool.edges.front().radiusMm});
      }
    }
  }
  return profile;
}

machine::MachineConfig configOf(const MachineProfile* profile) {
  const auto assumed = machine::loadPreset(kAssumedPreset);
  if (profile == nullptr) {
    return *assumed;
  }
  machine::MachineConfig config = machine::loadPreset(profile->preset).value_or(*assumed);
  for (std::size_t axis = 0; axis < profile->axes.size(); ++axis) {
    const AxisProfile& entered = profile->axes[axis];
    machine::AxisLimits& limits = config.axes[axis];
    limits.positionMmMin = entered.positionMin;
    limits.positionMmMax = entered.positionMax;
    limits.speedMmPerSMax = entered.speedPerSMax;
    limits.accelerationMmPerS2Max = entered.accelerationPerS2Max;
    limits.jerkMmPerS3Max = entered.jerkPerS3Max;
    limits.startMm = std::clamp(limits.startMm, entered.positionMin, entered.positionMax);
  }
  for (std::size_t axis = 0; axis < profile->rotaryAxes.size(); ++axis) {
    const auto& entered = profile->rotaryAxes[axis];
    auto& limits = config.rotaryAxes[axis];
    if (!entered) {
      limits.reset();
      continue;
    }
    machine::RotaryLimits rotary = limits.value_or(machine::RotaryLimits{});
    rotary.positionDegMin = entered->positionMin;
    rotary.positionDegMax = entered->positionMax;
    rotary.speedDegPerSMax = entered->speedPerSMax;
    rotary.accelerationDegPerS2Max = entered->accelerationPerS2Max;
    rotary.jerkDegPerS3Max = entered->jerkPerS3Max;
    rotary.startDeg = std::clamp(rotary.startDeg, entered->positionMin, entered->positionMax);
    if (!limits) {
      rotary.servoTimeConstantS = config.axes[0].servoTimeConstantS;
    }
    limits = rotary;
  }
  config.rapidMmPerS = profile->rapidMmPerS;
  if (profile->spindlePerMinMax > 0.0) {
    machine::SpindleConfig spindle = config.spindle.value_or(machine::SpindleConfig{});
    spindle.speedPerMinMax = profile->spindlePerMinMax;
    config.spindle = spindle;
  } else {
    config.spindle.reset();
  }
  if (!profile->tools.empty()) {
    machine::ToolTable table = config.tools.value_or(machine::ToolTable{});
    table.tools.clear();
    for (const streaming::ToolProfile& tool : profile->tools) {
      table.tools.push_back({tool.number, tool.name, {{tool.lengthMm, tool.radiusMm}}, false});
    }
    config.tools = std::move(table);
  }
  return config;
}

std::optional<machine::MachineConfig> knownMachine(const opcua::ServerIdentity& server,
                                                   const MachineProfile* profile) {
  if (profile != nullptr) {
    return configOf(profile);
  }
  const std::vector<std::string> known = machine::presetNames();
  if (std::find(known.begin(), known.end(), server.buildNumber) == known.end()) {
    return std::nullopt;
  }
  const auto preset = machine::loadPreset(server.buildNumber);
  return preset ? std::optional(*preset) : std::nullopt;
}

}  // namespace rivulet::report
