// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/run_trend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/utc.h"
#include "report/markup.h"
#include "report/svg_plot.h"

namespace rivulet::report {

namespace {

using Figure = double RunFigures::*;

/// @return slope of the line of least squares; 0 if all x are the same
double slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    meanX += x[i] / count;
    meanY += y[i] / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - meanX) * (x[i] - meanX);
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

Slope slopeOf(const MachineTrend& trend, Figure figure) {
  std::vector<double> numbers;
  std::vector<double> days;
  std::vector<double> values;
  bool hasDays = true;
  Slope slope;
  for (const RunFigures& run : trend.runs) {
    numbers.push_back(static_cast<double>(numbers.size()));
    values.push_back(run.*figure);
    days.push_back(run.atDay.value_or(0.0));
    hasDays = hasDays && run.atDay;
    slope.mean += run.*figure / static_cast<double>(trend.runs.size());
  }
  slope.perRun = slopeOf(numbers, values);
  // Over less than a day, the hour of the day is what changes.
  if (hasDays && trend.spanDays >= 1.0) {
    slope.perDay = slopeOf(days, values);
  }
  return slope;
}

/// Three digits, without an exponent.
std::string slopeText(double slope) {
  const double size = std::abs(slope);
  const int decimals =
      size > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 9) : 0;
  return fmt::format("{:+.{}f}", slope, decimals);
}

std::string perDayText(const Slope& slope) {
  return slope.perDay ? slopeText(*slope.perDay) : std::string("-");
}

nlohmann::ordered_json slopeJson(const Slope& slope) {
  return {{"mean", slope.mean},
          {"per_run", slope.perRun},
          {"per_day",
           slope.perDay ? nlohmann::ordered_json(*slope.perDay) : nlohmann::ordered_json(nullptr)}};
}

/// Whether the runs of all machines are shown by their dates.
bool isByDay(const std::vector<MachineTrend>& trends) {
  double spanDays = 0.0;
  for (const MachineTrend& trend : trends) {
    spanDays = std::max(spanDays, trend.spanDays);
  }
  return spanDays >= 1.0 && std::all_of(trends.begin(), trends.end(), [](const auto& trend) {
           return std::all_of(trend.runs.begin(), trend.runs.end(),
                              [](const RunFigures& run) { return run.atDay.has_value(); });
         });
}

double firstDayOf(const std::vector<MachineTrend>& trends) {
  double first = *trends.front().runs.front().atDay;
  for (const MachineTrend& trend : trends) {
    first = std::min(first, *trend.runs.front().atDay);
  }
  return std::floor(first);
}

std::string dateText(double day) {
  const std::chrono::year_month_day date{
      std::chrono::sys_days{std::chrono::days{static_cast<int>(day)}}};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

/// A text with a name or a date in its place.
std::string filled(std::string text, std::string_view value) {
  constexpr std::string_view kPlace = "%1";
  const std::size_t at = text.find(kPlace);
  return at == std::string::npos ? text : text.replace(at, kPlace.size(), value);
}

/// The runs of each machine as points, and their line of least squares.
std::string pictureOf(const std::vector<MachineTrend>& trends, const TrendTexts& texts,
                      const std::string& title, const std::string& label, Figure figure) {
  const bool isDated = isByDay(trends);
  const double firstDay = isDated ? firstDayOf(trends) : 0.0;
  base::Plot plot{
      title, isDated ? filled(texts.dayAxis, dateText(firstDay)) : texts.runAxis, label, {}};
  PlotLook look;
  look.decimalSign = texts.decimalSign;
  double largest = 0.0;
  for (std::size_t machine = 0; machine < trends.size(); ++machine) {
    const MachineTrend& trend = trends[machine];
    base::Series runs;
    runs.name = trend.machine;
    runs.style = base::SeriesStyle::Points;
    double middle = 0.0;
    for (const RunFigures& run : trend.runs) {
      runs.x.push_back(isDated ? *run.atDay - firstDay : static_cast<double>(runs.x.size() + 1));
      runs.y.push_back(run.*figure);
      middle += runs.x.back() / static_cast<double>(trend.runs.size());
      largest = std::max(largest, std::abs(run.*figure));
    }
    const Slope slope = slopeOf(trend, figure);
    base::Series line;
    line.name = filled(texts.line, trend.machine);
    for (const double x : {runs.x.front(), runs.x.back()}) {
      line.x.push_back(x);
      line.y.push_back(slope.mean +
                       (isDated ? slope.perDay.value_or(0.0) : slope.perRun) * (x - middle));
    }
    plot.series.push_back(std::move(runs));
    plot.series.push_back(std::move(line));
    look.colours.insert(look.colours.end(), {machine, machine});
  }
  // What changes by less is not worth a slope that looks steep.
  constexpr double kShareSeen = 0.2;
  look.ySpanMin = kShareSeen * largest;
  return svgPlot(plot, look);
}

}  // namespace

std::optional<double> daysOf(std::string_view utc) {
  constexpr double kMsPerDay = 86'400'000.0;
  const std::optional<base::UtcMs> at = base::utcOfText(utc);
  return at ? std::optional(static_cast<double>(*at) / kMsPerDay) : std::nullopt;
}

std::vector<MachineTrend> trendsOf(std::vector<RunFigures> runs) {
  std::map<std::string, MachineTrend> byMachine;
  for (RunFigures& run : runs) {
    MachineTrend& trend = byMachine[run.machine];
    trend.machine = run.machine;
    trend.runs.push_back(std::move(run));
  }
  std::vector<MachineTrend> trends;
  for (auto& [machine, trend] : byMachine) {
    const bool hasDays = std::all_of(trend.runs.begin(), trend.runs.end(),
                                     [](const RunFigures& run) { return run.atDay.has_value(); });
    if (hasDays) {
      std::stable_sort(
          trend.runs.begin(), trend.runs.end(),
          [](const RunFigures& a, const RunFigures& b) { return *a.atDay < *b.atDay; });
      trend.spanDays = *trend.runs.back().atDay - *trend.runs.front().atDay;
    }
    trend.accessMs = slopeOf(trend, &RunFigures::accessMs);
    trend.pausedS = slopeOf(trend, &RunFigures::pausedS);
    trends.push_back(std::move(trend));
  }
  return trends;
}

std::string trendText(const std::vector<MachineTrend>& trends) {
  std::string text = fmt::format("{:40} {:>6} {:>8} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12}\n",
                                 "machine", "runs", "days", "access_ms", "per_run", "per_day",
                                 "paused_s", "per_run", "per_day");
  for (const MachineTrend& trend : trends) {
    text +=
        fmt::format("{:40} {:>6} {:>8.1f} {:>12.4g} {:>12} {:>12} {:>12.4g} {:>12} {:>12}\n",
                    trend.machine, trend.runs.size(), trend.spanDays, trend.accessMs.mean,
                    slopeText(trend.accessMs.perRun), perDayText(trend.accessMs),
                    trend.pausedS.mean, slopeText(trend.pausedS.perRun), perDayText(trend.pausedS));
  }
  return text;
}

nlohmann::ordered_json trendJson(const std::vector<MachineTrend>& trends) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MachineTrend& trend : trends) {
    json.push_back({{"machine", trend.machine},
                    {"runs", trend.runs.size()},
                    {"span_days", trend.spanDays},
                    {"access_ms", slopeJson(trend.accessMs)},
                    {"paused_s", slopeJson(trend.pausedS)}});
  }
  return json;
}

std::string trendPicture(const std::vector<MachineTrend>& trends, bool isHtml,
                         const TrendTexts& texts) {
  const std::string access =
      pictureOf(trends, texts, texts.accessPicture, texts.accessAxis, &RunFigures::accessMs);
  if (!isHtml) {
    return access;
  }
  const auto row = [](std::string_view tag, const std::vector<std::string>& cells) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) {
      text += fmt::format("<{0}>{1}</{0}>", tag, markupText(cell));
    }
    return text + "</tr>\n";
  };
  const auto number = [&texts](std::string text) {
    std::replace(text.begin(), text.end(), '.', texts.decimalSign);
    return text;
  };
  std::string table = row("th", {texts.machine, texts.runs, texts.days, texts.access, texts.perRun,
                                 texts.perDay, texts.paused, texts.perRun, texts.perDay});
  for (const MachineTrend& trend : trends) {
    table +=
        row("td", {trend.machine, std::to_string(trend.runs.size()),
                   number(fmt::format("{:.1f}", trend.spanDays)),
                   number(fmt::format("{:.4g}", trend.accessMs.mean)),
                   number(slopeText(trend.accessMs.perRun)), number(perDayText(trend.accessMs)),
                   number(fmt::format("{:.4g}", trend.pausedS.mean)),
                   number(slopeText(trend.pausedS.perRun)), number(perDayText(trend.pausedS))});
  }
  // On a narrow screen, the table scrolls and the pictures become smaller.
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{0}\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{1}</title><style>body{{font-family:sans-serif;"
      "margin:2em}}div{{overflow-x:auto;margin-bottom:2em}}table{{border-collapse:collapse}}"
      "td,th{{border-bottom:1px solid #bbb;padding:4px 12px;text-align:right;white-space:nowrap}}"
      "td:first-child,th:first-child{{text-align:left}}svg{{max-width:100%;height:auto}}"
      "@media(max-width:600px){{body{{margin:1em}}}}</style></head><body>\n"
      "<h1>{1}</h1>\n<div><table>\n{2}</table></div>\n{3}\n{4}\n</body></html>\n",
      markupText(texts.language), markupText(texts.title), table, access,
      pictureOf(trends, texts, texts.pausedPicture, texts.pausedAxis, &RunFigures::pausedS));
}

}  // namespace rivulet::report
