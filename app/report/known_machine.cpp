// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/known_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/run_fields.h"
#include "streaming/control/machine_facts.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;
using streaming::AxisProfile;
using streaming::MachineProfile;

constexpr double kMost = 1e9;
constexpr int kToolsMax = 1000;

constexpr auto axisFields = [](auto& io, auto& axis) {
  io.number("position_min", axis.positionMin, -kMost, kMost);
  io.number("position_max", axis.positionMax, -kMost, kMost);
  io.number("speed_per_s_max", axis.speedPerSMax, 0.0, kMost);
  io.number("acceleration_per_s2_max", axis.accelerationPerS2Max, 0.0, kMost);
  io.number("jerk_per_s3_max", axis.jerkPerS3Max, 0.0, kMost);
};

constexpr auto profileToolFields = [](auto& io, auto& tool) {
  io.number("number", tool.number, 0.0, std::numeric_limits<int>::max());
  io.text("name", tool.name);
  io.number("length_mm", tool.lengthMm, -kMost, kMost);
  io.number("radius_mm", tool.radiusMm, -kMost, kMost);
};

constexpr auto profileFields = [](auto& io, auto& profile) {
  io.text("endpoint", profile.endpoint);
  io.object("server", profile.server, serverFields);
  io.text("entered_at_utc", profile.enteredAtUtc);
  io.text("entered_by", profile.enteredBy);
  io.text("name", profile.name);
  io.text("preset", profile.preset);
  io.object("axes", profile, [](auto& inner, auto& of) {
    for (std::size_t axis = 0; axis < of.axes.size(); ++axis) {
      inner.object(std::string(1, base::kAxisNames[axis]).c_str(), of.axes[axis], axisFields);
    }
    for (std::size_t axis = 0; axis < of.rotaryAxes.size(); ++axis) {
      maybe(inner, std::string(1, base::kRotaryAxisNames[axis]).c_str(), of.rotaryAxes[axis],
            axisFields);
    }
  });
  io.number("rapid_mm_per_s", profile.rapidMmPerS, 0.0, kMost);
  io.number("spindle_per_min_max", profile.spindlePerMinMax, 0.0, kMost);
  io.ifThere().number("silence_limit_s", profile.silenceLimitS, 0.0, templates::kSilenceLimitSMax);
  io.ifThere().number("stop_limit_s", profile.stopLimitS, streaming::kStopLimitSMin,
                      streaming::kStopLimitSMax);
  io.list("tools", profile.tools, profileToolFields);
};

}  // namespace

ordered_json profileJson(const MachineProfile& profile, const ordered_json& replaced) {
  return jsonInPlaceOf(replaced, profile, profileFields);
}

base::Result<MachineProfile> profileOf(const ordered_json& from, const std::string& origin) {
  const nlohmann::json json = from;
  Members members(json);
  FieldReader io(members);
  MachineProfile profile;
  const nlohmann::json* tools = members.find("/tools");
  if (tools == nullptr || !tools->is_array() || tools->size() > kToolsMax) {
    members.refuse("/tools");
  } else {
    profileFields(io, profile);
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
