// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/utc.h"

#include <fmt/format.h>

#include <chrono>

#include "base/text.h"

namespace rivulet::base {

namespace {

using Days = std::chrono::sys_days;
using Ms = std::chrono::milliseconds;

/// The number of `count` digits at a place; nothing if something else is there.
std::optional<int> digitsAt(std::string_view text, std::size_t at, std::size_t count) {
  int value = 0;
  for (const char c : text.substr(at, count)) {
    if (!isDigit(c)) {
      return std::nullopt;
    }
    constexpr int kBase = 10;
    value = value * kBase + (c - '0');
  }
  return value;
}

}  // namespace

std::string utcText(UtcMs at) {
  const std::chrono::sys_time<Ms> time{Ms{at}};
  const Days day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

std::optional<UtcMs> utcOfText(std::string_view text) {
  constexpr std::string_view kForm = "dddd-dd-ddTdd:dd:dd.dddZ";
  constexpr std::string_view kWithoutMs = "dddd-dd-ddTdd:dd:ddZ";
  const bool hasMs = text.size() == kForm.size();
  const std::string_view form = hasMs ? kForm : kWithoutMs;
  if (text.size() != form.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (form[i] == 'd' ? !isDigit(text[i]) : text[i] != form[i]) {
      return std::nullopt;
    }
  }
  const auto number = [text](std::size_t at, std::size_t count) {
    return *digitsAt(text, at, count);
  };
  const std::chrono::year_month_day date{std::chrono::year(number(0, 4)),
                                         std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                         std::chrono::day(static_cast<unsigned>(number(8, 2)))};
  const int hour = number(11, 2);
  const int minute = number(14, 2);
  const int second = number(17, 2);
  if (!date.ok() || hour > 23 || minute > 59 || second > 59) {
    return std::nullopt;
  }
  const std::chrono::sys_time<Ms> time =
      Days(date) + std::chrono::hours(hour) + std::chrono::minutes(minute) +
      std::chrono::seconds(second) + Ms(hasMs ? number(20, 3) : 0);
  return time.time_since_epoch().count();
}

}  // namespace rivulet::base
