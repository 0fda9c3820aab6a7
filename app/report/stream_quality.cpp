// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/stream_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/method_kind.h"
#include "base/units.h"
#include "feasibility/verdict.h"
#include "templates/cells.h"

namespace rivulet::report {

namespace {

constexpr std::size_t kPeriods = 10;
/// N that are tried.
constexpr int kPointsMax = 60;
/// Advice that gains less is none.
constexpr double kGainMin = 1.05;

using nlohmann::ordered_json;

/// The line through the mean durations of all sizes, weighted by their number, without negative
/// figures.
feasibility::AccessLine lineOf(const std::vector<AccessKindTimes>& kinds, bool write) {
  double weight = 0.0;
  double n = 0.0;
  double t = 0.0;
  double nn = 0.0;
  double nt = 0.0;
  for (const AccessKindTimes& kind : kinds) {
    if (kind.write != write) {
      continue;
    }
    const auto count = static_cast<double>(kind.times.count);
    const double nodes = std::max(kind.nodes, 1);
    const double seconds = base::toSeconds(kind.times.mean);
    weight += count;
    n += count * nodes;
    t += count * seconds;
    nn += count * nodes * nodes;
    nt += count * nodes * seconds;
  }
  if (weight == 0.0) {
    return {};
  }
  const double determinant = weight * nn - n * n;
  double perNode = determinant > 1e-9 * nn * weight ? (weight * nt - n * t) / determinant : t / n;
  perNode = std::clamp(perNode, 0.0, t / n);
  return {base::fromSeconds((t - perNode * n) / weight), base::fromSeconds(perNode)};
}

/// The run as the equations see it.
struct Question {
  templates::TemplateParameters parameters;
  feasibility::OperatingPoint point;
  feasibility::AccessModel access;
};

/// @return 0: not known
double largestFeed(const Question& question, const std::vector<gcode::StreamPoint>& points) {
  const auto distances = feasibility::programDistances(points, question.point.pointsPerLoop);
  const auto verdict = feasibility::judge(question.point, distances, question.access);
  return verdict ? verdict->feedMmPerSMax : 0.0;
}

std::optional<Question> questionOf(const trace::Recording& recording,
                                   const std::vector<AccessKindTimes>& kinds) {
  const auto method = base::methodFromName(recording.start.method);
  if (!method || recording.start.pointsPerLoop < 2 || recording.points.points.size() < 2) {
    return std::nullopt;
  }
  Question question;
  question.parameters.method = *method;
  question.parameters.pointsPerLoop = recording.start.pointsPerLoop;
  question.parameters.layout =
      templates::layoutFromName(recording.start.layout).value_or(question.parameters.layout);
  const std::string axes = recording.start.axes.empty() ? "XYZ" : recording.start.axes;
  static_cast<void>(templates::chooseAxes(question.parameters, axes));
  question.point.method = *method;
  question.point.pointsPerLoop = recording.start.pointsPerLoop;
  question.point.deltaMm = recording.start.deltaMm;
  question.point.feedMmPerS = recording.start.feedMmPerS;
  question.point.cellsPerPoint = templates::cellsPerPoint(question.parameters);
  question.access.measured = feasibility::MeasuredAccess{lineOf(kinds, false), lineOf(kinds, true)};
  return question;
}

/// @param presentMmPerS  largest feed of the run as it was
void findAdvice(StreamQuality& quality, const Question& question,
                const std::vector<gcode::StreamPoint>& points, double presentMmPerS) {
  double bestFeed = 0.0;
  int bestPoints = 0;
  for (int count = 2; count <= kPointsMax; ++count) {
    Question other = question;
    other.parameters.pointsPerLoop = other.point.pointsPerLoop = count;
    const double feed = templates::planCells(other.parameters) ? largestFeed(other, points) : 0.0;
    if (feed > bestFeed) {
      bestFeed = feed;
      bestPoints = count;
    }
  }
  if (bestFeed > kGainMin * presentMmPerS) {
    quality.advice.push_back({StreamAdvice::Change::PointsPerLoop, bestPoints, bestFeed});
  }
  Question arrays = question;
  if (arrays.access.measured) {
    for (feasibility::AccessLine* line :
         {&arrays.access.measured->read, &arrays.access.measured->write}) {
      line->overhead += line->perNode;
      line->perNode = {};
    }
  }
  const double feed = largestFeed(arrays, points);
  if (feed > kGainMin * presentMmPerS) {
    quality.advice.push_back({StreamAdvice::Change::Arrays, 0, feed});
  }
  std::sort(quality.advice.begin(), quality.advice.end(),
            [](const StreamAdvice& a, const StreamAdvice& b) {
              return a.feedMmPerSMax > b.feedMmPerSMax;
            });
}

StreamLimit limitOf(const StreamQuality& quality, const trace::TraceAnalysis& analysis) {
  if (quality.lateWindows > 0 && quality.waitedS >= 0.5 * quality.standingS) {
    return StreamLimit::Client;
  }
  if (quality.feedMmPerSMax && quality.feedMmPerS > *quality.feedMmPerSMax) {
    return StreamLimit::AccessTime;
  }
  return quality.standingS > analysis.quality.feed.slowS ? StreamLimit::Stops
                                                         : StreamLimit::Machine;
}

}  // namespace

std::vector<AccessPeriod> accessPeriods(const trace::Recording& recording, std::size_t count) {
  std::vector<AccessPeriod> parts;
  if (recording.accesses.empty()) {
    return parts;
  }
  const base::Instant first = recording.accesses.front().sent;
  const base::Duration all = recording.accesses.back().sent - first + base::Duration{1};
  std::vector<std::vector<base::Duration>> times(count);
  for (const trace::Access& access : recording.accesses) {
    const double share = base::toSeconds(access.sent - first) / base::toSeconds(all);
    const auto part = static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(count));
    times[std::min(part, count - 1)].push_back(access.took);
  }
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back(
        {all / static_cast<base::Duration::rep>(count) * static_cast<base::Duration::rep>(i),
         trace::durationStatistics(std::move(times[i]))});
  }
  return parts;
}

StreamQuality judgeStream(const trace::Recording& recording, const trace::TraceAnalysis& analysis) {
  StreamQuality quality;
  std::map<std::pair<bool, int>, std::vector<base::Duration>> kinds;
  for (const trace::Access& access : recording.accesses) {
    kinds[{access.write, access.nodes}].push_back(access.took);
  }
  for (auto& [kind, times] : kinds) {
    quality.kinds.push_back({kind.first, kind.second, trace::durationStatistics(std::move(times))});
  }
  quality.periods = accessPeriods(recording, kPeriods);
  for (const trace::Standstill& stop : analysis.stops) {
    if (stop.cause == trace::StopCause::WaitingForData) {
      ++quality.lateWindows;
      quality.waitedS += base::toSeconds(stop.duration);
    }
  }
  if (const auto question = questionOf(recording, quality.kinds)) {
    const double feed = largestFeed(*question, recording.points.points);
    if (feed > 0.0) {
      quality.feedMmPerSMax = feed;
      findAdvice(quality, *question, recording.points.points, feed);
    }
  }
  quality.feedMmPerS = recording.start.feedMmPerS;
  for (const trace::TimeLost& lost : analysis.quality.feed.standing) {
    quality.standingS += lost.seconds;
  }
  quality.limit = limitOf(quality, analysis);
  // A run that was too fast for its client: the feed is the third thing to change.
  if (quality.limit == StreamLimit::AccessTime) {
    quality.advice.push_back({StreamAdvice::Change::Feed, 0, *quality.feedMmPerSMax});
  }
  return quality;
}

std::string streamLimitText(const StreamQuality& quality) {
  switch (quality.limit) {
    case StreamLimit::Client:
      return fmt::format("The client: the machine waited {} times for its data, {:.3f} s in total.",
                         quality.lateWindows, quality.waitedS);
    case StreamLimit::AccessTime:
      return fmt::format(
          "The access time: at the feed of {:.0f} mm/min the client is slower than the machine; it "
          "would keep up at {:.0f} mm/min.",
          base::mmPerMinFromMmPerS(quality.feedMmPerS),
          base::mmPerMinFromMmPerS(quality.feedMmPerSMax.value_or(0.0)));
    case StreamLimit::Stops:
      return fmt::format("The stops between loops or windows: {:.3f} s.", quality.standingS);
    case StreamLimit::Machine:
      break;
  }
  return "The machine: braking and accelerating, not the client.";
}

std::string streamChangeText(const StreamAdvice& advice) {
  switch (advice.change) {
    case StreamAdvice::Change::PointsPerLoop:
      return fmt::format("N {}", advice.pointsPerLoop);
    case StreamAdvice::Change::Arrays:
      return "arrays that cost as much as one variable";
    case StreamAdvice::Change::Feed:
      break;
  }
  return "a lower feed";
}

ordered_json streamQualityJson(const StreamQuality& quality) {
  const auto timesJson = [](const trace::DurationStatistics& times) {
    return ordered_json{{"requests", times.count},
                        {"mean_ms", base::toMilliseconds(times.mean)},
                        {"p50_ms", base::toMilliseconds(times.p50)},
                        {"p99_ms", base::toMilliseconds(times.p99)},
                        {"max_ms", base::toMilliseconds(times.max)}};
  };
  ordered_json kinds = ordered_json::array();
  for (const AccessKindTimes& kind : quality.kinds) {
    ordered_json one{{"write", kind.write}, {"nodes", kind.nodes}};
    one.update(timesJson(kind.times));
    kinds.push_back(std::move(one));
  }
  ordered_json periods = ordered_json::array();
  for (const AccessPeriod& period : quality.periods) {
    ordered_json one{{"from_s", base::toSeconds(period.from)}};
    one.update(timesJson(period.times));
    periods.push_back(std::move(one));
  }
  ordered_json advice = ordered_json::array();
  for (const StreamAdvice& one : quality.advice) {
    advice.push_back({{"change", streamChangeText(one)},
                      {"feed_mm_per_min_max", base::mmPerMinFromMmPerS(one.feedMmPerSMax)}});
  }
  return {{"kinds", std::move(kinds)},
          {"periods", std::move(periods)},
          {"late_windows", quality.lateWindows},
          {"waited_s", quality.waitedS},
          {"feed_mm_per_min_max",
           quality.feedMmPerSMax ? ordered_json(base::mmPerMinFromMmPerS(*quality.feedMmPerSMax))
                                 : ordered_json(nullptr)},
          {"limited_by", streamLimitText(quality)},
          {"advice", std::move(advice)}};
}

std::string streamQualityText(const StreamQuality& quality) {
  std::string text;
  for (const AccessKindTimes& kind : quality.kinds) {
    text += fmt::format("  {} of {}: {} requests, median {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
                        kind.write ? "writes" : "reads", kind.nodes, kind.times.count,
                        base::toMilliseconds(kind.times.p50), base::toMilliseconds(kind.times.p99),
                        base::toMilliseconds(kind.times.max));
  }
  text += fmt::format("  what limited the run: {}\n", streamLimitText(quality));
  for (const StreamAdvice& advice : quality.advice) {
    text += fmt::format("  with {}: up to {:.0f} mm/min\n", streamChangeText(advice),
                        base::mmPerMinFromMmPerS(advice.feedMmPerSMax));
  }
  return text;
}

}  // namespace rivulet::report
