// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The XML that an MTConnect agent answers with: observations (MTConnectStreams) of all versions,
/// several documents after another, and before them the description of the machine
/// (MTConnectDevices), which has the names and units. @threadsafety pure.
/// @source MTConnect Standard, Part 1 (requests, sequence numbers, errors) and Part 3
/// (observations)
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "trace/import/columns.h"
#include "trace/signals.h"

namespace rivulet::trace {

/// Until when a value holds that the agent does not repeat.
enum class HeldUntil : std::uint8_t {
  NotHeld,     ///< what lies between two values is not known
  StepBefore,  ///< one sampling step before the next one
  NextValue,
};

struct MtconnectSignal {
  std::optional<SignalRole> role{};  ///< by its type, component and subtype; each role once
  HeldUntil held = HeldUntil::NotHeld;
};

struct MtconnectTrace {
  SignalTrace trace;
  std::vector<MtconnectSignal> kinds;  ///< one per signal
  base::Instant last{};                ///< of all observations
  std::size_t bytes = 0;               ///< what it takes, with its analysis
};

[[nodiscard]] bool isMtconnect(std::string_view text);

/// What an agent says of its buffer in front of an answer; 0: it does not say.
struct MtconnectHeader {
  std::string document;  ///< "MTConnectStreams", "MTConnectDevices", "MTConnectError", ...
  std::uint64_t instanceId = 0;
  std::uint64_t bufferSize = 0;  ///< observations
  std::uint64_t firstSequence = 0;
  std::uint64_t lastSequence = 0;
  std::uint64_t nextSequence = 0;  ///< of the first observation after the answer
};
/// A sequence number, or a count of observations; nothing: the text is no whole number.
[[nodiscard]] std::optional<std::uint64_t> mtconnectNumber(std::string_view text);
/// Of the first document; nothing: the text is of no agent.
[[nodiscard]] std::optional<MtconnectHeader> readMtconnectHeader(std::string_view text);

/// One time base for each signal; its values are in MTConnect's units. Numbers become signals, the
/// words of events and conditions become events of the trace. What the agent calls UNAVAILABLE is
/// no value. @param budget  without the text; of the signals and their analysis
/// @return error ImportError::AgentRefused: an MTConnectError, its text in the message; NotATable:
/// another document, or no values; BudgetError::Exceeded
[[nodiscard]] base::Result<MtconnectTrace> readMtconnect(std::string_view text,
                                                         const base::Budget& budget);

/// Adds the values that an agent does not repeat: between two values that are more than three
/// sampling steps apart, the first one holds until one step before the second; the last one holds
/// to the end. Positions also get them at the times of the other positions, so that each is known
/// where another one moves.
/// @param isPosition  one per signal
/// @param budget      that of `readMtconnect`
/// @return error BudgetError::Exceeded
[[nodiscard]] base::Result<void> addHeldValues(MtconnectTrace& read,
                                               const std::vector<bool>& isPosition,
                                               const base::Budget& budget);

}  // namespace rivulet::trace
