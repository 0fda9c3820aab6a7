// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/machine_profile.h"

#include <set>

#include "templates/feed_cell.h"

namespace rivulet::streaming {

namespace {

using What = ProfileProblem::What;

std::optional<ProfileProblem> problemOfAxis(const AxisProfile& axis, std::size_t index) {
  if (!(axis.positionMax > axis.positionMin)) {
    return ProfileProblem{What::Travel, index, 0};
  }
  if (!(axis.speedPerSMax > 0.0)) {
    return ProfileProblem{What::Speed, index, 0};
  }
  if (!(axis.accelerationPerS2Max > 0.0)) {
    return ProfileProblem{What::Acceleration, index, 0};
  }
  if (!(axis.jerkPerS3Max > 0.0)) {
    return ProfileProblem{What::Jerk, index, 0};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ProfileProblem> problemOf(const MachineProfile& profile) {
  for (std::size_t axis = 0; axis < profile.axes.size(); ++axis) {
    if (const auto problem = problemOfAxis(profile.axes[axis], axis)) {
      return problem;
    }
  }
  for (std::size_t axis = 0; axis < profile.rotaryAxes.size(); ++axis) {
    if (const auto& rotary = profile.rotaryAxes[axis]) {
      if (const auto problem = problemOfAxis(*rotary, base::kAxisCount + axis)) {
        return problem;
      }
    }
  }
  if (!(profile.rapidMmPerS > 0.0)) {
    return ProfileProblem{What::Rapid, 0, 0};
  }
  if (!templates::isSilenceLimit(profile.silenceLimitS)) {
    return ProfileProblem{What::Silence, 0, 0};
  }
  if (!(profile.stopLimitS >= kStopLimitSMin) || profile.stopLimitS > kStopLimitSMax) {
    return ProfileProblem{What::Stop, 0, 0};
  }
  std::set<int> numbers;
  for (const ToolProfile& tool : profile.tools) {
    if (tool.number <= 0 || !numbers.insert(tool.number).second) {
      return ProfileProblem{What::ToolNumber, 0, tool.number};
    }
  }
  return std::nullopt;
}

double silenceLimitS(const MachineProfile* profile) {
  return profile != nullptr ? profile->silenceLimitS : templates::kSilenceLimitS;
}

double stopLimitS(const MachineProfile* profile) {
  return profile != nullptr ? profile->stopLimitS : MachineProfile().stopLimitS;
}

}  // namespace rivulet::streaming
