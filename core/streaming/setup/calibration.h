// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Measures the cost of access to a control: reads and writes of 1 to 100 R-parameters, one by one,
/// in a list, and in each array form that has been proved. It works only on cells that the user has
/// named. While it measures, it writes their present values, so that an error or a cancel loses
/// nothing; at the end it restores the values and reads them back.
/// @threadsafety runs on the calling thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/result.h"
#include "opcua/link.h"
#include "streaming/control/access_forms.h"
#include "trace/analysis/histogram.h"

namespace rivulet::streaming {

enum class CalibrationError {
  NoCells = 1,  ///< the range is empty or not a range of R-parameters
  ChannelBusy,  ///< a program runs: its cells must not be touched
  Cancelled,
  NotRestored,  ///< the cells do not have their old values
};

[[nodiscard]] std::error_code make_error_code(CalibrationError code);

struct CalibrationPlan {
  int firstCell = 0;  ///< scratch R-parameters, both ends included
  int lastCell = 0;
  int shots = 500;  ///< requests of each kind, >= 2
  /// Time limit; zero: none. If it is too short, the kinds that take longest get fewer shots
  /// (`AccessSeries::shotsMade`), but never fewer than the first ones of each.
  base::Duration budget{};
  /// Arrays too, if there are enough cells to prove that they work; the proof writes other values
  /// for a moment.
  bool arrays = true;
  std::uint64_t seed = 1;  ///< of the order in which the kinds take turns
  base::Duration deadline = std::chrono::seconds{5};
};

/// Requests of one kind.
struct AccessSeries {
  bool write = false;
  int nodes = 1;
  opcua::Grouping grouping = opcua::Grouping::List;
  int shotsMade = 0;     ///< 0: refused by the control
  bool refused = false;  ///< a form that works with fewer cells, but not with so many
  base::Duration min{};
  base::Duration mean{};
  base::Duration max{};
  double deviationMs = 0.0;                    ///< standard deviation
  std::vector<trace::Percentile> percentiles;  ///< those that the number of shots allows
  trace::Histogram histogram;

  /// Nothing if there were too few shots. @param perMille  500, 900, 950, 990 or 999
  [[nodiscard]] std::optional<base::Duration> percentile(int perMille) const;
  /// The 99th percentile, or the longest if there were too few shots for one.
  [[nodiscard]] base::Duration tail() const;
};

/// duration = overhead + cells · time per cell: a least-squares line through the averages of one
/// form and direction, with neither figure below zero. Each average is weighted by its certainty:
/// its variance is that of the mean plus half a per cent of itself, which allows for deviations
/// from a straight line.
struct AccessFit {
  bool write = false;
  opcua::Grouping grouping = opcua::Grouping::List;
  double overheadMs = 0.0;       ///< a
  double nodeMs = 0.0;           ///< b
  double residualMs = 0.0;       ///< root mean square over the sizes
  double residualShare = 0.0;    ///< largest distance of an average from the line, over the average
  double nodeDeviationMs = 0.0;  ///< of one cell, from the growth of the variance with the cells

  /// a + b·n, never below zero.
  [[nodiscard]] base::Duration at(double nodes) const;
};

struct Calibration {
  CalibrationPlan plan;
  base::Duration took{};
  std::vector<AccessSeries> series;  ///< by form, direction and size
  std::vector<AccessFit> fits;       ///< of every form that was measured, reads and writes
  std::optional<AccessForms> forms;  ///< which forms were proved; nothing: not tried

  /// Null if the form was not measured.
  [[nodiscard]] const AccessFit* fit(bool write, opcua::Grouping grouping) const;
  /// The 99th percentile of a request: interpolated linearly between the measured sizes, and along
  /// the fit beyond them. @param nodes >= 1 @return nothing if the form was not measured
  [[nodiscard]] std::optional<base::Duration> tail(bool write, opcua::Grouping grouping,
                                                   int nodes) const;
  /// The best form that works: what a run with free choice of access will use.
  [[nodiscard]] opcua::Grouping best() const;
  /// Some kind got fewer shots than requested.
  [[nodiscard]] bool isCut() const;
};

/// Progress of a calibration.
struct CalibrationProgress {
  enum class Phase {
    Forms,  ///< which forms of access work
    First,  ///< a few shots of each kind, which show how long the rest takes
    Shots,
    Restore,
  };
  Phase phase = Phase::Forms;
  double share = 0.0;     ///< of the time, 0 to 1; never falls
  base::Duration left{};  ///< estimate
  int shotsMade = 0;
  int shotsPlanned = 0;
};

/// Callbacks during a calibration. Both may be empty.
struct CalibrationHooks {
  /// False cancels.
  std::function<bool(const CalibrationProgress&)> progress;
  /// Called once if the connection has broken: a new one, only to restore the cells; null if there
  /// is none.
  std::function<opcua::Link*()> reconnect;
};

/// The expected time of a calibration, including its proof and its end.
/// @param earlier  of the same control, for its costs; null: 4.3 ms per cell ([P1] Table I)
[[nodiscard]] base::Duration expectedDuration(const CalibrationPlan& plan,
                                              const Calibration* earlier = nullptr);

/// The channel must be in reset. It is checked repeatedly, and a program that is started meanwhile
/// ends the calibration at once.
/// @return NoCells, ChannelBusy, Cancelled, NotRestored, or the error of the link. In every case
///         the message says what the cells hold
[[nodiscard]] base::Result<Calibration> calibrate(opcua::Link& link, const CalibrationPlan& plan,
                                                  const CalibrationHooks& hooks = {});

/// The values of the cells, to be shown before they are confirmed. @return NoCells, link errors
[[nodiscard]] base::Result<std::vector<opcua::Assignment>> readScratchCells(
    opcua::Link& link, const CalibrationPlan& plan);

}  // namespace rivulet::streaming

template <>
struct std::is_error_code_enum<rivulet::streaming::CalibrationError> : std::true_type {};
