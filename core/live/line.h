// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The language of live sources, one line at a time:
///
///     X10.5 Y2 Z-0.3 A0 F1200      a point; what a line does not name keeps its value
///     {"x": 10.5, "y": 2, "f": 1200}
///     N17 X10.6                    numbered: the next one is N18
///     hold                         the machine stops there and waits for the next point
///     feed 0.85                    factor of the operator's override, see `FeedFactor`
///     {"feed": 0.85}
///     end                          after the last point
///     comment, # or ;              says nothing, but shows that the source lives
///
/// X, Y, Z in mm, A, B, C in degrees, F in mm/min. Upper and lower case are the same.
/// @threadsafety pure.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/axes.h"
#include "base/result.h"

namespace rivulet::live {

struct Line {
  enum class Kind { Nothing, Point, Hold, End, Feed } kind = Kind::Nothing;
  std::array<std::optional<double>, base::kAxisCount> mm{};
  std::array<std::optional<double>, base::kRotaryAxisCount> deg{};
  std::optional<double> feedMmPerMin;
  std::optional<double> number;  ///< N
  std::optional<double> factor;  ///< of Feed; what is no number is NaN
};

/// @param text  without its end @return NotALine, NotFinite
[[nodiscard]] base::Result<Line> parseLine(std::string_view text);

}  // namespace rivulet::live
