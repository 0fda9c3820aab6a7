// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How access time and pauses of a machine develop over its runs. @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rivulet::report {

/// What a trend needs of one recording.
struct RunFigures {
  std::string machine;          ///< address of the control
  std::string file;             ///< of the recording
  std::optional<double> atDay;  ///< days since 1970-01-01 UTC; nothing: the start is not known
  double accessMs = 0.0;        ///< mean of the requests, per node
  double pausedS = 0.0;
};

/// "2026-11-22T06:00:12Z" as days since 1970; nothing: not such a time.
[[nodiscard]] std::optional<double> daysOf(std::string_view utc);

/// The straight line of least squares through a figure.
struct Slope {
  double mean = 0.0;
  double perRun = 0.0;
  std::optional<double> perDay;  ///< the runs are spread over a day or more
};

struct MachineTrend {
  std::string machine;
  std::vector<RunFigures> runs;  ///< by start; those whose start is not known stay in their order
  double spanDays = 0.0;
  Slope accessMs;
  Slope pausedS;
};

/// Machines by address.
[[nodiscard]] std::vector<MachineTrend> trendsOf(std::vector<RunFigures> runs);

[[nodiscard]] std::string trendText(const std::vector<MachineTrend>& trends);
[[nodiscard]] nlohmann::ordered_json trendJson(const std::vector<MachineTrend>& trends);

/// The words of the pictures and their page, in the language of the reader.
struct TrendTexts {
  std::string language = "en";
  char decimalSign = '.';
  std::string title = "Trend of the runs";
  std::string machine = "Machine";
  std::string runs = "Runs";
  std::string days = "Days";
  std::string access = "Access, ms";
  std::string paused = "Paused, s";
  std::string perRun = "per run";
  std::string perDay = "per day";
  std::string accessPicture = "Access time per run";
  std::string accessAxis = "Mean access time, ms";
  std::string pausedPicture = "Pauses per run";
  std::string pausedAxis = "Time in pauses, s";
  std::string runAxis = "Run of the machine";
  std::string dayAxis = "Days since %1";  ///< a date
  std::string line = "%1, trend";         ///< a machine
};

/// Access time and pauses over the runs of each machine as two pictures.
/// @param isHtml  with the table, as a file that needs no other; else one SVG
[[nodiscard]] std::string trendPicture(const std::vector<MachineTrend>& trends, bool isHtml,
                                       const TrendTexts& texts = {});

}  // namespace rivulet::report
