// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Numbers as the operator reads them: in the language of the application, with their unit. The
/// language is the default `QLocale`: the application sets it before it installs a translator.
/// Positions and times come in mm and s, feeds in mm/s and are shown in mm/min.
/// @threadsafety GUI thread.
#pragma once

#include <QString>
#include <cstddef>

#include "base/instant.h"

namespace rivulet::widgets {

/// Shown if a number is not known.
[[nodiscard]] QString noValue();

/// A number without unit. Not finite: `noValue()`. @param decimals >= 0
[[nodiscard]] QString numberText(double value, int decimals);

/// A whole number with the language's grouping.
[[nodiscard]] QString countText(std::size_t value);

/// "12.345 mm".
[[nodiscard]] QString lengthText(double lengthMm, int decimals = 3);

/// "500 mm/min", with decimals according to the size of the value.
[[nodiscard]] QString feedText(double feedMmPerS);

/// "12.3 s".
[[nodiscard]] QString secondsText(double seconds, int decimals = 1);

/// "12.3 s", "2:05 min" or "1:02:05 h": how long something takes.
[[nodiscard]] QString durationText(double seconds);

/// "0.7 s" or "12 s" or "3:20 min": how old something is.
[[nodiscard]] QString ageText(double seconds);

/// "41.2 ms".
[[nodiscard]] QString millisecondsText(double milliseconds, int decimals = 1);
[[nodiscard]] QString millisecondsText(base::Duration duration, int decimals = 1);

/// "1.23" with three significant digits: how many times a limit is kept. Very large: "> 1000".
[[nodiscard]] QString factorText(double factor);

}  // namespace rivulet::widgets
