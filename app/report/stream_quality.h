// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How well the client of a recorded run kept up: its access times per kind and over time, what
/// limited the run, and which N, feed or form of access would have helped, by the equations with
/// the access times that were recorded. @threadsafety pure.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "trace/analysis/statistics.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/recording.h"

namespace rivulet::report {

/// Requests of the same direction with the same number of variables.
struct AccessKindTimes {
  bool write = false;
  int nodes = 0;
  trace::DurationStatistics times;  ///< per request
};

/// A part of the run.
struct AccessPeriod {
  base::Duration from{};            ///< since the first access
  trace::DurationStatistics times;  ///< of all requests
  trace::DurationStatistics reads;
  trace::DurationStatistics writes;
  /// By the equations, with the durations of this part. Nothing: there were none, or not known.
  std::optional<double> margin;
};

/// A change that would have allowed a larger feed, or no waiting.
struct StreamAdvice {
  enum class Change {
    PointsPerLoop,  ///< another N
    Arrays,         ///< that cost as much as one variable
    Feed,           ///< lower: the client keeps up
  };
  Change change = Change::PointsPerLoop;
  int pointsPerLoop = 0;       ///< with `PointsPerLoop`
  double feedMmPerSMax = 0.0;  ///< by the equations
};

/// What kept a run from being faster.
enum class StreamLimit {
  Client,      ///< the machine waited for its data
  AccessTime,  ///< at this feed the client is slower than the machine
  Stops,       ///< between loops or windows
  Machine,     ///< braking and accelerating
};

struct StreamQuality {
  std::vector<AccessKindTimes> kinds;
  std::vector<AccessPeriod> periods;  ///< ten of equal length
  std::size_t loops = 0;              ///< windows, or loops of points, that were sent
  std::size_t lateWindows = 0;        ///< times the machine waited for the client
  std::size_t lostRequests = 0;       ///< not answered in time, and made again
  std::size_t refusedRequests = 0;    ///< and made again
  double waitedS = 0.0;
  std::optional<double> feedMmPerSMax;  ///< as it was run
  /// How many times faster the machine could have been: below 1 the client is too slow. By the
  /// equations, with the mean durations, and with those that one request in a hundred exceeds.
  std::optional<double> margin;
  std::optional<double> marginOfSlowest;
  StreamLimit limit = StreamLimit::Machine;
  double feedMmPerS = 0.0;           ///< of the run
  double standingS = 0.0;            ///< all stops together
  std::vector<StreamAdvice> advice;  ///< the largest gain first
};

/// @param count  of parts of equal length, > 0  @return empty: there were no accesses
[[nodiscard]] std::vector<AccessPeriod> accessPeriods(const trace::Recording& recording,
                                                      std::size_t count);
/// @param recording  with accesses
[[nodiscard]] StreamQuality judgeStream(const trace::Recording& recording,
                                        const trace::TraceAnalysis& analysis);

/// One sentence in English. @param feedMmPerSMax known with `AccessTime`
[[nodiscard]] std::string streamLimitText(const StreamQuality& quality);
/// "N 12", "arrays that cost as much as one variable", "the feed".
[[nodiscard]] std::string streamChangeText(const StreamAdvice& advice);
[[nodiscard]] nlohmann::ordered_json streamQualityJson(const StreamQuality& quality);
[[nodiscard]] std::string streamQualityText(const StreamQuality& quality);

}  // namespace rivulet::report
