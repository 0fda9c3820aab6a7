// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How well the client of a recorded run kept up: its access times per kind and over time, what
/// limited the run, and which N, feed or form of access would have helped, by the equations with
/// the access times that were recorded. @threadsafety pure.
#pragma once

#include <nlohmann/json.hpp>
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
  base::Duration from{};  ///< since the first access
  trace::DurationStatistics times;
};

/// A change that would have allowed another feed.
struct StreamAdvice {
  std::string change;          ///< "N 12", "arrays", "feed"
  double feedMmPerSMax = 0.0;  ///< by the equations
};

struct StreamQuality {
  std::vector<AccessKindTimes> kinds;
  std::vector<AccessPeriod> periods;  ///< ten of equal length
  std::size_t lateWindows = 0;        ///< times the machine waited for the client
  double waitedS = 0.0;
  std::optional<double> feedMmPerSMax;  ///< as it was run
  std::string limitedBy;                ///< one sentence, in English
  std::vector<StreamAdvice> advice;     ///< the largest gain first
};

/// @param recording  with accesses
[[nodiscard]] StreamQuality judgeStream(const trace::Recording& recording,
                                        const trace::TraceAnalysis& analysis);

[[nodiscard]] nlohmann::ordered_json streamQualityJson(const StreamQuality& quality);
[[nodiscard]] std::string streamQualityText(const StreamQuality& quality);

}  // namespace rivulet::report
