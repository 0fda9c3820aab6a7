// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Why the control executes a block itself, and what is known after it. @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "nc/fault.h"
#include "nc/syntax/dialect.h"

namespace rivulet::job {

/// If a block has several, the first in this order counts.
enum class NativeReason : unsigned char {
  Transformation,      ///< CYCLE800, TRAORI and what they enclose
  RadiusCompensation,  ///< G41, G42 and what they enclose
  Cycle,               ///< and the positions at which a modal one is called
  Subprogram,          ///< one that is not at hand
  Probing,             ///< measures, or asks the control for a value
  Retract,             ///< machine coordinates, fixed points
  OtherMotion,         ///< threads, splines and positioning axes
  Corner,              ///< RND, CHF: between two motions, both of which it takes
  UnknownPosition,     ///< an increment or arc from where only the control knows the tool to be
  Tool,                ///< T, M6, D, H, tool length
  WorkOffset,          ///< G54 and the like
  Spindle,
  Coolant,
  Stop,  ///< M0, M1
  Dwell,
  Message,
  Mode,   ///< dynamics, compressor, look-ahead
  Other,  ///< other M functions, variables of the control
  End,    ///< M30, M2, M17
};
inline constexpr std::size_t kNativeReasonCount = 19;

/// Where the tool stands after such a block.
enum class PositionAfter : unsigned char {
  Known,        ///< where the program says
  ControlOnly,  ///< it is read from the control
};

struct NativeReasonRow {
  NativeReason reason = NativeReason::Other;
  std::string_view name;      ///< for files, e.g. "radius-compensation"
  std::string_view sentence;  ///< for the user
  PositionAfter after = PositionAfter::Known;
};

[[nodiscard]] const NativeReasonRow& rowOf(NativeReason reason);
[[nodiscard]] inline std::string_view nativeReasonName(NativeReason reason) {
  return rowOf(reason).name;
}

/// Inverse of `nativeReasonName`; nothing for an unknown name.
[[nodiscard]] std::optional<NativeReason> nativeReasonFromName(std::string_view name);

// What a word without effect on the path is for. Nothing: Rivulet carries it, or the loop does not
// need it.
/// @param key  as in `nc::gTable`
[[nodiscard]] std::optional<NativeReason> reasonOfG(nc::Dialect dialect, int key);
[[nodiscard]] NativeReason reasonOfM(int number);
/// @param name  upper case
[[nodiscard]] std::optional<NativeReason> reasonOfName(std::string_view name);

/// What Rivulet does not execute, but the control does. Nothing: nobody knows.
/// @param word  the argument of the fault
[[nodiscard]] std::optional<NativeReason> reasonOfFault(nc::Dialect dialect, nc::FaultCode code,
                                                        std::string_view word);

}  // namespace rivulet::job
