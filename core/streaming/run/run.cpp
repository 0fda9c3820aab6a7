// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/run.h"

#include <fmt/format.h>

namespace rivulet::streaming {

std::error_code make_error_code(StreamError code) {
  static const base::NamedCategory category("streaming");
  return {static_cast<int>(code), category};
}

int runNumberFrom(std::uint64_t entropy) {
  constexpr std::uint64_t kNumbers = 999'983;  // a prime
  static_assert(kNumbers <= kRunNumberMax);
  std::uint64_t mixed = entropy ^ (entropy >> 29U);
  mixed *= 0x9E3779B97F4A7C15ULL;
  return static_cast<int>((mixed >> 20U) % kNumbers) + 1;
}

base::Error channelBusy() {
  return base::makeError(StreamError::ChannelBusy,
                         "A program is running on the control. Wait until it has ended, or reset "
                         "the control, then start again.");
}

std::string_view runStateName(RunState state) {
  switch (state) {
    case RunState::Idle:
      return "idle";
    case RunState::Armed:
      return "armed";
    case RunState::Running:
      return "running";
    case RunState::Holding:
      return "holding";
    case RunState::Stopping:
      return "stopping";
    case RunState::Done:
      return "done";
    case RunState::Stopped:
      return "stopped";
    case RunState::Aborted:
      return "aborted";
  }
  return "";
}

RunState endState(Outcome outcome) {
  switch (outcome) {
    case Outcome::Completed:
      return RunState::Done;
    case Outcome::Stopped:
      return RunState::Stopped;
    case Outcome::Failed:
      break;
  }
  return RunState::Aborted;
}

std::string_view outcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::Completed:
      return "completed";
    case Outcome::Stopped:
      return "stopped";
    case Outcome::Failed:
      return "failed";
  }
  return "";
}

std::string_view passedByName(PassedBy passedBy) {
  return passedBy == PassedBy::Position ? "position" : "distance-to-go";
}

std::optional<PassedBy> passedByFromName(std::string_view name) {
  for (const PassedBy passedBy : {PassedBy::Position, PassedBy::DistanceToGo}) {
    if (passedByName(passedBy) == name) {
      return passedBy;
    }
  }
  return std::nullopt;
}

int windowsAfterStop(const templates::TemplateParameters& parameters) {
  return base::goesOn(parameters.method) ? std::max(1, parameters.windowsAhead) : 1;
}

WindowCut windowCut(const RunSettings& settings) {
  const templates::TemplateParameters& parameters = settings.parameters;
  return {settings.placePauses, parameters.feedPerPoint || base::sendsBlocks(parameters.method),
          settings.windowSMax / windowsAfterStop(parameters), settings.feedMmPerS,
          templates::packingOf(parameters) ? templates::axisCount(parameters) : 0};
}

std::string_view runFindingName(RunFinding finding) {
  switch (finding) {
    case RunFinding::Faultless:
      return "faultless";
    case RunFinding::NotJudged:
      return "not judged";
    case RunFinding::Faulty:
      return "faulty";
  }
  return "";
}

std::string describe(const WrongMotion& wrong) {
  return wrong.kind == WrongMotion::Kind::OffPath
             ? fmt::format("after point {} the tool is {:.3f} mm off the path", wrong.point,
                           wrong.offMm)
             : fmt::format("points were repeated after point {}", wrong.point);
}

RunFinding RunReport::finding() const {
  if (integrity.judged ? !integrity.isFaultless() : wrong.has_value()) {
    return RunFinding::Faulty;
  }
  // Nobody knows how far the control has come since.
  const bool isCutOff =
      error.code == opcua::LinkError::ConnectionLost || error.code == StreamError::ClientSilent;
  if (!integrity.judged || isCutOff) {
    return RunFinding::NotJudged;
  }
  const bool isWhole = outcome == Outcome::Stopped || integrity.executed == counters.total;
  return isWhole && outcome != Outcome::Failed ? RunFinding::Faultless : RunFinding::Faulty;
}

}  // namespace rivulet::streaming
