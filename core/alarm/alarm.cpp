// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "alarm/alarm.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/contract.h"
#include "base/sentence.h"

namespace rivulet::alarm {

namespace {

constexpr std::array<Facts, 17> kFacts{{
    {Code::ControlAlarm, "control-alarm", Priority::High, Source::Control,
     RIVULET_SENTENCE("AlarmTexts", "The control reports alarm %1."),
     RIVULET_SENTENCE("AlarmTexts",
                      "The control has stopped or limits the machine; the number says why."),
     RIVULET_SENTENCE(
         "AlarmTexts",
         "Look up alarm %1 at the control, remove its cause, then press reset there.")},
    {Code::ConnectionLost, "connection-lost", Priority::High, Source::Connection,
     RIVULET_SENTENCE("AlarmTexts", "The connection to %1 is lost."), "",
     RIVULET_SENTENCE("AlarmTexts",
                      "Look at the machine: it may still move. Check cable and control, then "
                      "connect again.")},
    {Code::NotConnected, "not-connected", Priority::Low, Source::Connection,
     RIVULET_SENTENCE("AlarmTexts", "No connection to %1."), "", ""},
    {Code::WrongMotion, "wrong-motion", Priority::High, Source::Run,
     RIVULET_SENTENCE("AlarmTexts",
                      "Wrong motion in %1 (points repeated: %2, skipped: %3). The workpiece may be "
                      "spoilt."),
     RIVULET_SENTENCE("AlarmTexts", "Points came too late for this feed with these settings."),
     RIVULET_SENTENCE("AlarmTexts",
                      "Check workpiece and tool. Choose a smaller feed, or method window.")},
    {Code::MovesWrong, "moves-wrong", Priority::High, Source::Run,
     RIVULET_SENTENCE(
         "AlarmTexts",
         "Wrong motion in %1 after point %2: points are repeated, or the tool has left "
         "the path."),
     RIVULET_SENTENCE("AlarmTexts",
                      "Points came too late for this feed with these settings, or something else "
                      "moves the axes."),
     RIVULET_SENTENCE("AlarmTexts", "Stop the run, then check workpiece and tool.")},
    {Code::RunFailed, "run-failed", Priority::High, Source::Run,
     RIVULET_SENTENCE("AlarmTexts", "The run of %1 was ended by a fault."), "",
     RIVULET_SENTENCE("AlarmTexts",
                      "Check tool and workpiece, remove the cause, then resume or start again.")},
    {Code::RunIncomplete, "run-incomplete", Priority::High, Source::Run,
     RIVULET_SENTENCE("AlarmTexts", "%1 ended before its end: %2 of %3 points were executed."),
     RIVULET_SENTENCE("AlarmTexts", "The control's trace lacks the last points."),
     RIVULET_SENTENCE("AlarmTexts", "Check tool and workpiece before you go on.")},
    {Code::NotJudged, "not-judged", Priority::Low, Source::Run,
     RIVULET_SENTENCE("AlarmTexts", "It is not known whether %1 was executed without a fault."),
     RIVULET_SENTENCE("AlarmTexts",
                      "The control's trace could not be read, or is shorter than the run."),
     RIVULET_SENTENCE("AlarmTexts", "Check the workpiece.")},
    {Code::NotRecorded, "not-recorded", Priority::Low, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts", "The run is not recorded."),
     RIVULET_SENTENCE("AlarmTexts", "Nothing can be written to the folder %1."),
     RIVULET_SENTENCE("AlarmTexts", "Check the folder, its permissions and the free space.")},
    {Code::RecordingCut, "recording-cut", Priority::Medium, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts",
                      "The recording of %1 was cut off: the first %2 s of the run are in it."),
     RIVULET_SENTENCE("AlarmTexts",
                      "Nothing more can be written to the folder %3: its disk is full, or too "
                      "slow."),
     RIVULET_SENTENCE("AlarmTexts",
                      "Make room on the disk. A run in progress goes on without its recording; the "
                      "next one is recorded.")},
    {Code::FileChanged, "file-changed", Priority::Medium, Source::Program,
     RIVULET_SENTENCE("AlarmTexts", "The program file %1 has changed since it was read."),
     RIVULET_SENTENCE("AlarmTexts", "Another program has written the file."),
     RIVULET_SENTENCE("AlarmTexts", "Reload the file before you start.")},
    {Code::FileGone, "file-gone", Priority::Low, Source::Program,
     RIVULET_SENTENCE("AlarmTexts", "The program file %1 is no longer there."),
     RIVULET_SENTENCE("AlarmTexts", "It was deleted or moved, or its drive is not connected."),
     RIVULET_SENTENCE("AlarmTexts",
                      "Bring the file back, or go on with what was read before it disappeared.")},
    {Code::CalibrationFailed, "calibration-failed", Priority::Medium, Source::Control,
     RIVULET_SENTENCE("AlarmTexts", "The calibration of %1 has failed."), "",
     RIVULET_SENTENCE("AlarmTexts", "Remove the cause, then measure again.")},
    {Code::CalibrationNotSaved, "calibration-not-saved", Priority::Low, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts", "The calibration of %1 is not saved."), "",
     RIVULET_SENTENCE("AlarmTexts", "Check the folder and the free space, then measure again.")},
    {Code::AlarmHistoryUnwritten, "alarm-history-unwritten", Priority::Low, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts", "The history of alarms is not written to %1."), "",
     RIVULET_SENTENCE("AlarmTexts", "Check the folder, its permissions and the free space.")},
    {Code::AuditUnwritten, "audit-unwritten", Priority::Medium, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts", "The audit trail is not written to %1."), "",
     RIVULET_SENTENCE("AlarmTexts", "Check the folder, its permissions and the free space.")},
    {Code::AuditChanged, "audit-changed", Priority::Medium, Source::Computer,
     RIVULET_SENTENCE("AlarmTexts", "The audit trail %1 was changed: see line %2."),
     RIVULET_SENTENCE("AlarmTexts", "A line was edited, inserted or removed after it was written."),
     RIVULET_SENTENCE("AlarmTexts", "Keep a copy of the file and find out who changed it.")},
}};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kFacts.size(); ++i) {
    if (kFacts[i].code != static_cast<Code>(i)) {
      return false;
    }
  }
  return true;
}
static_assert(isInOrder(), "factsOf takes the code as an index");

constexpr std::array<std::pair<State, std::string_view>, 5> kStates{{
    {State::Normal, "normal"},
    {State::Unacknowledged, "unacknowledged"},
    {State::Acknowledged, "acknowledged"},
    {State::ReturnedUnacknowledged, "returned-unacknowledged"},
    {State::Shelved, "shelved"},
}};

std::string filled(const char* pattern, const std::vector<std::string>& arguments) {
  std::string text(pattern);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string place = "%" + std::to_string(i + 1);
    if (const auto at = text.find(place); at != std::string::npos) {
      text.replace(at, place.size(), arguments[i]);
    }
  }
  return text;
}

}  // namespace

std::span<const Facts> allFacts() {
  return kFacts;
}

const Facts& factsOf(Code code) {
  const auto index = static_cast<std::size_t>(code);
  RIVULET_ASSERT(index < kFacts.size());
  return kFacts[index];
}

std::optional<Code> codeOfName(std::string_view name) {
  const auto* found =
      std::find_if(kFacts.begin(), kFacts.end(), [&](const Facts& f) { return name == f.name; });
  return found == kFacts.end() ? std::nullopt : std::optional(found->code);
}

std::string_view sourceName(Source source) {
  switch (source) {
    case Source::Control:
      return "control";
    case Source::Connection:
      return "connection";
    case Source::Run:
      return "run";
    case Source::Program:
      return "program";
    case Source::Computer:
      break;
  }
  return "computer";
}

std::string_view stateName(State state) {
  return kStates[static_cast<std::size_t>(state)].second;
}

std::optional<State> stateOfName(std::string_view name) {
  for (const auto& [state, text] : kStates) {
    if (text == name) {
      return state;
    }
  }
  return std::nullopt;
}

State Alarm::state() const {
  if (!isActive && isAcknowledged) {
    return State::Normal;
  }
  if (shelving) {
    return State::Shelved;
  }
  if (!isActive) {
    return State::ReturnedUnacknowledged;
  }
  return isAcknowledged ? State::Acknowledged : State::Unacknowledged;
}

std::string describe(const Alarm& alarm) {
  const Facts& facts = factsOf(alarm.code);
  std::string text = filled(facts.text, alarm.arguments);
  const std::string cause =
      *facts.cause == '\0' ? alarm.error.text() : filled(facts.cause, alarm.arguments);
  return cause.empty() ? text : text + " " + cause;
}

}  // namespace rivulet::alarm
