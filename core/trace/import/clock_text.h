// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Dates and times of day as programs write them into tables. @threadsafety pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rivulet::trace {

inline constexpr double kDayS = 86400.0;
/// Beyond that many seconds an `Instant` overflows: clocks count from 1970 or 1601 at most.
inline constexpr double kSecondsMax = 9e9;

enum class ClockKind : std::uint8_t {
  None,
  Date,       ///< alone: seconds of its midnight since 1970
  TimeOfDay,  ///< alone: seconds since midnight
  Timestamp,  ///< both: seconds since 1970, of UTC if the text says its offset
};

/// What the numbers of a date with slashes are.
enum class DateOrder : std::uint8_t { DayFirst, MonthFirst };

struct ClockValue {
  ClockKind kind = ClockKind::None;
  double seconds = 0.0;
};

/// "2026-01-02T03:04:05.678+02:00", "2.1.2026 03:04:05,678", "01/02/2026 03:04:05 PM",
/// "03:04:05:678", "02.01.2026". @param slashes  for a date such as 01/02/2026
[[nodiscard]] std::optional<ClockValue> parseClock(std::string_view text, DateOrder slashes);

/// What the text says itself of the order of its date with slashes: a number beyond 12, or "PM".
[[nodiscard]] std::optional<DateOrder> dateOrderOf(std::string_view text);
/// A date with slashes.
[[nodiscard]] bool hasSlashDate(std::string_view text);

}  // namespace rivulet::trace
