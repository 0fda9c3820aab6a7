// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/clock_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "base/text.h"

namespace rivulet::trace {

namespace {

struct Digits {
  int value = 0;
  std::size_t count = 0;
};

/// Takes the digits off the beginning. @return nothing: none, or more than `most`
std::optional<Digits> takeDigits(std::string_view& text, std::size_t most) {
  Digits digits;
  while (digits.count < text.size() && base::isDigit(text[digits.count])) {
    if (digits.count == most) {
      return std::nullopt;
    }
    digits.value = 10 * digits.value + (text[digits.count++] - '0');
  }
  text.remove_prefix(digits.count);
  return digits.count == 0 ? std::nullopt : std::optional(digits);
}

bool takeSign(std::string_view& text, char sign) {
  const bool is = !text.empty() && text.front() == sign;
  text.remove_prefix(is ? 1 : 0);
  return is;
}

struct Date {
  char separator = '-';
  std::array<Digits, 3> parts{};

  [[nodiscard]] bool hasYearFirst() const { return parts[0].count == 4; }
};

/// Takes three numbers with the same sign between them off the beginning, one of them a year.
std::optional<Date> takeDate(std::string_view& text) {
  std::string_view rest = text;
  Date date;
  for (std::size_t i = 0; i < date.parts.size(); ++i) {
    if (i == 1) {
      date.separator = rest.empty() ? ' ' : rest.front();
      if (date.separator != '-' && date.separator != '/' && date.separator != '.') {
        return std::nullopt;
      }
    }
    if (i > 0 && !takeSign(rest, date.separator)) {
      return std::nullopt;
    }
    const auto digits = takeDigits(rest, 4);
    if (!digits) {
      return std::nullopt;
    }
    date.parts[i] = *digits;
  }
  const bool isYear = date.hasYearFirst() != (date.parts[2].count == 4);
  if (!isYear || date.parts[1].count > 2 ||
      (date.hasYearFirst() ? date.parts[2] : date.parts[0]).count > 2) {
    return std::nullopt;
  }
  text = rest;
  return date;
}

std::optional<double> midnightOf(const Date& date, DateOrder slashes) {
  const bool isMonthFirst =
      !date.hasYearFirst() && date.separator == '/' && slashes == DateOrder::MonthFirst;
  const auto partOf = [&date](std::size_t part) { return date.parts[part].value; };
  const std::chrono::year_month_day day{
      std::chrono::year(partOf(date.hasYearFirst() ? 0 : 2)),
      std::chrono::month(static_cast<unsigned>(partOf(isMonthFirst ? 0 : 1))),
      std::chrono::day(static_cast<unsigned>(partOf(date.hasYearFirst() ? 2
                                                    : isMonthFirst      ? 1
                                                                        : 0)))};
  if (!day.ok()) {
    return std::nullopt;
  }
  return kDayS * static_cast<double>(std::chrono::sys_days(day).time_since_epoch().count());
}

/// "h:mm:ss", "h:mm:ss.fff", "h:mm:ss,fff", "h:mm:ss:fff". @return seconds, below a day
std::optional<double> takeTime(std::string_view& text) {
  const auto hours = takeDigits(text, 2);
  const auto minutes = hours && takeSign(text, ':') ? takeDigits(text, 2) : std::nullopt;
  const auto seconds = minutes && takeSign(text, ':') ? takeDigits(text, 2) : std::nullopt;
  if (!seconds || hours->value > 23 || minutes->value > 59 || seconds->value > 60) {
    return std::nullopt;
  }
  double fraction = 0.0;
  if (takeSign(text, '.') || takeSign(text, ',') || takeSign(text, ':')) {
    std::size_t count = 0;
    while (count < text.size() && base::isDigit(text[count])) {
      ++count;
    }
    const auto read = base::parseNumber("0." + std::string(text.substr(0, count)));
    if (count == 0 || !read) {
      return std::nullopt;
    }
    fraction = *read;
    text.remove_prefix(count);
  }
  return 3600.0 * hours->value + 60.0 * minutes->value + seconds->value + fraction;
}

/// "AM", "p.m.". @return 'A' or 'P'; nothing: it is neither
std::optional<char> takeHalfOfDay(std::string_view& text) {
  for (const std::string_view word : {"AM", "PM", "A.M.", "P.M."}) {
    if (base::toUpper(text.substr(0, word.size())) == word) {
      text.remove_prefix(word.size());
      return word.front();
    }
  }
  return std::nullopt;
}

/// "Z", "+02:00", "-0530", "+01", or nothing. @return seconds ahead of UTC
std::optional<double> takeOffset(std::string_view& text) {
  if (text.empty() || takeSign(text, 'Z') || takeSign(text, 'z')) {
    return 0.0;
  }
  const bool isBehind = text.front() == '-';
  if (!takeSign(text, '+') && !takeSign(text, '-')) {
    return std::nullopt;
  }
  const auto hours = takeDigits(text, 4);
  if (!hours) {
    return std::nullopt;
  }
  int minutes = hours->count > 2 ? hours->value / 100 * 60 + hours->value % 100 : 60 * hours->value;
  if (takeSign(text, ':')) {
    const auto more = takeDigits(text, 2);
    if (!more || hours->count > 2) {
      return std::nullopt;
    }
    minutes += more->value;
  }
  return (isBehind ? -60.0 : 60.0) * minutes;
}

}  // namespace

std::optional<ClockValue> parseClock(std::string_view text, DateOrder slashes) {
  text = base::trim(text);
  if (text.empty() || !base::isDigit(text.front())) {
    return std::nullopt;
  }
  const auto date = takeDate(text);
  const auto midnight = date ? midnightOf(*date, slashes) : std::optional(0.0);
  if (!midnight) {
    return std::nullopt;
  }
  if (date && text.empty()) {
    return ClockValue{ClockKind::Date, *midnight};
  }
  if (date && !takeSign(text, 'T') && !takeSign(text, ' ')) {
    return std::nullopt;
  }
  text = base::trim(text);
  auto seconds = takeTime(text);
  if (!seconds) {
    return std::nullopt;
  }
  text = base::trim(text);
  if (const auto half = takeHalfOfDay(text)) {
    const bool isTwelve = *seconds >= 12.0 * 3600.0;
    if (*seconds >= 13.0 * 3600.0) {
      return std::nullopt;
    }
    *seconds += 12.0 * 3600.0 * ((*half == 'P' ? 1.0 : 0.0) - (isTwelve ? 1.0 : 0.0));
  }
  text = base::trim(text);
  const auto ahead = takeOffset(text);
  if (!ahead || !text.empty()) {
    return std::nullopt;
  }
  return ClockValue{date ? ClockKind::Timestamp : ClockKind::TimeOfDay,
                    *midnight + *seconds - *ahead};
}

bool hasSlashDate(std::string_view text) {
  text = base::trim(text);
  const auto date = takeDate(text);
  return date && date->separator == '/' && !date->hasYearFirst();
}

std::optional<DateOrder> dateOrderOf(std::string_view text) {
  text = base::trim(text);
  const auto date = takeDate(text);
  if (!date || date->separator != '/' || date->hasYearFirst()) {
    return std::nullopt;
  }
  if (date->parts[0].value > 12) {
    return DateOrder::DayFirst;
  }
  const std::string rest = base::toUpper(text);
  const bool hasHalf = rest.ends_with("M") || rest.ends_with("M.");
  return date->parts[1].value > 12 || hasHalf ? std::optional(DateOrder::MonthFirst) : std::nullopt;
}

}  // namespace rivulet::trace
