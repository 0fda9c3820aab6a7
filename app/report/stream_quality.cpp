// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/stream_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/method_kind.h"
#include "base/units.h"
#include "feasibility/verdict.h"
#include "streaming/run/driver.h"
#include "templates/cells.h"

namespace rivulet::report {

namespace {

constexpr std::size_t kPeriods = 10;
/// N that are tried.
constexpr int kPointsMax = 60;
/// Advice that gains less is none.
constexpr double kGainMin = 1.05;

using nlohmann::ordered_json;

std::vector<AccessKindTimes> kindsOf(const std::vector<trace::Access>& accesses) {
  std::map<std::pair<bool, int>, std::vector<base::Duration>> durations;
  for (const trace::Access& access : accesses) {
    durations[{access.write, access.nodes}].push_back(access.took);
  }
  std::vector<AccessKindTimes> kinds;
  for (auto& [kind, times] : durations) {
    kinds.push_back({kind.first, kind.second, trace::durationStatistics(std::move(times))});
  }
  return kinds;
}

trace::DurationStatistics statisticsOf(const std::vector<trace::Access>& accesses,
                                       std::optional<bool> write) {
  std::vector<base::Duration> durations;
  for (const trace::Access& access : accesses) {
    if (!write || access.write == *write) {
      durations.push_back(access.took);
    }
  }
  return trace::durationStatistics(std::move(durations));
}

/// The accesses of `count` parts of the run, which are equally long.
struct AccessParts {
  base::Duration length{};
  std::vector<std::vector<trace::Access>> parts;
};

AccessParts partsOf(const std::vector<trace::Access>& accesses, std::size_t count) {
  AccessParts all;
  if (accesses.empty()) {
    return all;
  }
  const base::Instant first = accesses.front().sent;
  const base::Duration whole = accesses.back().sent - first + base::Duration{1};
  all.length = whole / static_cast<base::Duration::rep>(count);
  all.parts.resize(count);
  for (const trace::Access& access : accesses) {
    const double share = base::toSeconds(access.sent - first) / base::toSeconds(whole);
    const auto part = static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(count));
    all.parts[std::min(part, count - 1)].push_back(access);
  }
  return all;
}

/// The line through the mean durations of all sizes, weighted by their number, without negative
/// figures. @param figure  the mean, or a quantile instead
feasibility::AccessLine lineOf(const std::vector<AccessKindTimes>& kinds, bool write,
                               base::Duration trace::DurationStatistics::*figure) {
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
    const double seconds = base::toSeconds(kind.times.*figure);
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

feasibility::AccessModel modelOf(const std::vector<AccessKindTimes>& kinds,
                                 base::Duration trace::DurationStatistics::*figure) {
  feasibility::AccessModel model;
  model.measured =
      feasibility::MeasuredAccess{lineOf(kinds, false, figure), lineOf(kinds, true, figure)};
  return model;
}

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
  question.access = modelOf(kinds, &trace::DurationStatistics::mean);
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
    const double feed =
        templates::requireProgram(other.parameters) ? largestFeed(other, points) : 0.0;
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

/// Needs the feed of the run and `quality.periods`.
void findMargins(StreamQuality& quality, Question question, const trace::Recording& recording) {
  const auto perLoop = static_cast<std::size_t>(recording.start.pointsPerLoop);
  quality.loops = (recording.points.points.size() + perLoop - 1) / perLoop;
  if (recording.start.feedMmPerS <= 0.0) {
    return;
  }
  const auto margin = [&](const std::vector<AccessKindTimes>& kinds,
                          base::Duration trace::DurationStatistics::*figure) {
    question.access = modelOf(kinds, figure);
    return largestFeed(question, recording.points.points) / recording.start.feedMmPerS;
  };
  quality.margin = margin(quality.kinds, &trace::DurationStatistics::mean);
  quality.marginOfSlowest = margin(quality.kinds, &trace::DurationStatistics::p99);
  const AccessParts all = partsOf(recording.accesses, quality.periods.size());
  for (std::size_t i = 0; i < all.parts.size(); ++i) {
    // A part without both kinds says nothing of a turn of the client.
    if (quality.periods[i].reads.count > 0 && quality.periods[i].writes.count > 0) {
      quality.periods[i].margin = margin(kindsOf(all.parts[i]), &trace::DurationStatistics::mean);
    }
  }
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
  const AccessParts all = partsOf(recording.accesses, count);
  std::vector<AccessPeriod> periods;
  for (const std::vector<trace::Access>& part : all.parts) {
    AccessPeriod period;
    period.from = all.length * static_cast<base::Duration::rep>(periods.size());
    period.times = statisticsOf(part, std::nullopt);
    period.reads = statisticsOf(part, false);
    period.writes = statisticsOf(part, true);
    periods.push_back(period);
  }
  return periods;
}

StreamQuality judgeStream(const trace::Recording& recording, const trace::TraceAnalysis& analysis) {
  StreamQuality quality;
  quality.kinds = kindsOf(recording.accesses);
  quality.periods = accessPeriods(recording, kPeriods);
  const auto count = [&recording](std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(recording.notes.begin(), recording.notes.end(),
                      [text](const trace::Note& note) { return note.text == text; }));
  };
  quality.lostRequests = count(streaming::kLostNote);
  quality.refusedRequests = count(streaming::kRefusedNote);
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
      findMargins(quality, *question, recording);
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
  const auto optionalJson = [](const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
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
    one["reads"] = timesJson(period.reads);
    one["writes"] = timesJson(period.writes);
    one["margin"] = optionalJson(period.margin);
    periods.push_back(std::move(one));
  }
  ordered_json advice = ordered_json::array();
  for (const StreamAdvice& one : quality.advice) {
    advice.push_back({{"change", streamChangeText(one)},
                      {"feed_mm_per_min_max", base::mmPerMinFromMmPerS(one.feedMmPerSMax)}});
  }
  return {{"kinds", std::move(kinds)},
          {"periods", std::move(periods)},
          {"margin", optionalJson(quality.margin)},
          {"margin_of_slowest", optionalJson(quality.marginOfSlowest)},
          {"lost_requests", quality.lostRequests},
          {"refused_requests", quality.refusedRequests},
          {"loops", quality.loops},
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
  if (quality.margin && quality.marginOfSlowest) {
    text +=
        fmt::format("  margin: {:.2f} with the mean durations, {:.2f} with the slowest of 100\n",
                    *quality.margin, *quality.marginOfSlowest);
  }
  text += fmt::format("  requests made again: {} lost, {} refused; late windows: {} of {}\n",
                      quality.lostRequests, quality.refusedRequests, quality.lateWindows,
                      quality.loops);
  text += fmt::format("  what limited the run: {}\n", streamLimitText(quality));
  for (const StreamAdvice& advice : quality.advice) {
    text += fmt::format("  with {}: up to {:.0f} mm/min\n", streamChangeText(advice),
                        base::mmPerMinFromMmPerS(advice.feedMmPerSMax));
  }
  return text;
}

}  // namespace rivulet::report
