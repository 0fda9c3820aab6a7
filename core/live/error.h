// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What can be wrong with a live source. @threadsafety plain values.
#pragma once

#include <system_error>

#include "base/error.h"

namespace rivulet::live {

enum class LiveError {
  NotALine = 1,       ///< neither a point nor `end`, `hold` or `comment`
  NotFinite,          ///< a word without a finite number
  TooLong,            ///< a line without an end
  Incomplete,         ///< the source was closed in the middle of a line
  OutsideBox,         ///< of the agreement
  StepTooLong,        ///< between two points
  TurnTooLarge,       ///< of a rotary axis between two points
  FeedTooLarge,       ///< larger than agreed, or not greater than 0
  TooFarAway,         ///< the first point, from the tool
  AxisNotChosen,      ///< a point names an axis that is not streamed
  NumberMissing,      ///< a source that can lose points has to number them
  NumberWrong,        ///< a point is missing or came twice
  SourceClosed,       ///< without `end`
  SourceSilent,       ///< for longer than agreed
  Overrun,            ///< a source that cannot wait was faster than the machine
  NoPoint,            ///< the source ended before its first point
  NotOpened,          ///< the source cannot be opened
  BadSourceFile,      ///< the file that names the variables of a server
  NotAgreed,          ///< nothing can keep what is to be agreed
  FactorAmongPoints,  ///< factors of the feed have a source of their own
};

[[nodiscard]] std::error_code make_error_code(LiveError code);

}  // namespace rivulet::live

template <>
struct std::is_error_code_enum<rivulet::live::LiveError> : std::true_type {};
