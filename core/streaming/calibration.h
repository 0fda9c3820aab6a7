// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Measures what access to a control costs: reads and writes of 1 to 100 R-parameters, in a list
/// and one by one, and as arrays where they work. Works only on cells the user has named; while
/// measuring it writes the values that stand there, so that nothing is lost by an error or a
/// cancel. @threadsafety runs on the calling thread.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/result.h"
#include "opcua/link.h"
#include "streaming/access_forms.h"
#include "trace/analysis/statistics.h"

namespace rivulet::streaming {

enum class CalibrationError {
  NoCells = 1,  ///< the range is empty or not a range of R-parameters
  ChannelBusy,  ///< a program runs: its cells must not be touched
  Cancelled,
};

[[nodiscard]] std::error_code make_error_code(CalibrationError code);

struct CalibrationPlan {
  int firstCell = 0;  ///< scratch R-parameters, both ends included
  int lastCell = 0;
  int shots = 50;  ///< requests of each kind, >= 2
  /// Arrays too, where there are cells enough to prove that they work; the proof writes other
  /// values for a moment.
  bool arrays = true;
  base::Duration deadline = std::chrono::seconds{5};
};

/// Requests of one kind.
struct AccessSeries {
  bool write = false;
  int nodes = 1;
  opcua::Grouping grouping = opcua::Grouping::List;
  trace::DurationStatistics durations;
  double deviationMs = 0.0;  ///< standard deviation
};

/// duration = overhead + nodes · node time, fitted to the averages of the lists; with arrays an
/// element takes the place of a node.
struct AccessFit {
  double overheadMs = 0.0;
  double nodeMs = 0.0;
  double residualMs = 0.0;       ///< root mean square
  double nodeDeviationMs = 0.0;  ///< from the growth of the variance with the nodes
};

struct Calibration {
  std::vector<AccessSeries> series;
  AccessFit read;
  AccessFit write;
  std::optional<AccessForms> forms;  ///< which forms were proved; nothing: not tried
  /// Of the best array form, where one works. As much per element as a list per node: the control
  /// charges elements. Next to nothing: it charges the array as one node.
  std::optional<AccessFit> arrayRead;
  std::optional<AccessFit> arrayWrite;
};

/// @param progress  told the share done, 0 to 1, and the time still needed; false cancels
/// @return NoCells, ChannelBusy, Cancelled, or what the link says
[[nodiscard]] base::Result<Calibration> calibrate(
    opcua::Link& link, const CalibrationPlan& plan,
    const std::function<bool(double share, base::Duration left)>& progress = {});

}  // namespace rivulet::streaming

template <>
struct std::is_error_code_enum<rivulet::streaming::CalibrationError> : std::true_type {};
