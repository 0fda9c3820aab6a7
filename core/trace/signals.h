// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Named signals over time, as they come from the trace of any control: any columns, several time
/// bases, irregular samples. @threadsafety plain values.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "base/instant.h"
#include "trace/packed_points.h"
#include "trace/remark.h"

namespace rivulet::trace {

/// In place of a value that is not there.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// When the samples of one or more signals were taken: strictly ascending.
struct TimeBase {
  std::string name;  ///< of the column of time; empty: the file has none
  PackedTimes at;
};

struct Signal {
  std::string name;  ///< as in the file; unique in its trace
  std::string unit;  ///< as in the file; empty: not given
  std::size_t timeBase = 0;
  PackedValues values;  ///< one per instant of the time base; NaN: no value there
};

/// What a trace says of a span of time, in words.
struct SignalEvent {
  base::Instant from{};
  base::Instant to{};  ///< not before `from`
  std::string kind;    ///< that of a stop is its `stopCauseName`
  std::string text;    ///< one English sentence or less

  friend bool operator==(const SignalEvent&, const SignalEvent&) = default;
};

struct SignalTrace {
  std::string format;  ///< "CSV", "TwinCAT Scope", ...
  std::vector<TimeBase> timeBases;
  std::vector<Signal> signalList;
  std::vector<SignalEvent> events;
  /// Where the time of the file went back: sections follow each other on one time axis, and what is
  /// between them is not known. Empty: there is one.
  std::vector<base::Instant> sections;
  std::vector<Remark> remarks;  ///< what could not be read or had to be assumed
};

}  // namespace rivulet::trace
