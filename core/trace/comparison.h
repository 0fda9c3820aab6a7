// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs side by side: each sample gets a place on an axis that all runs share (time, length of
/// path, points of the program), so that the difference of two runs has a meaning at every place.
/// On such an axis, an `Instant` counts places instead of time: 1 s stands for 1 mm or one point.
/// @threadsafety pure.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "trace/envelope.h"
#include "trace/signal_set.h"

namespace rivulet::trace {

enum class RunAxis {
  Time,   ///< s from the first sample
  Path,   ///< mm of path
  Point,  ///< points of the program, counted from 1; between them in proportion to the length
};

/// "time", "path", "point".
[[nodiscard]] std::string_view runAxisName(RunAxis axis);
[[nodiscard]] std::optional<RunAxis> runAxisFrom(std::string_view name);
/// "s", "mm", "".
[[nodiscard]] std::string_view runAxisUnit(RunAxis axis);

enum class ComparisonError {
  NoPositions = 1,    ///< the context is the name of the trace
  NoProgram,          ///< points need a program that the trace is compared with; context as above
  DifferentPrograms,  ///< points of different programs do not correspond
};
[[nodiscard]] std::error_code make_error_code(ComparisonError code);

/// Where runs are on a common axis.
struct RunAlignment {
  RunAxis axis = RunAxis::Time;
  /// The lengths are those of one program. False: each run has the length that it moved itself, so
  /// what one of them cuts off adds up along the path.
  bool isOfProgram = false;
  /// Per run the place (mm or points) at each instant, not falling. Null: time.
  std::vector<std::shared_ptr<const Envelope>> places;
};

/// @param runs  none null
/// @return error `ComparisonError`
[[nodiscard]] base::Result<RunAlignment> alignRuns(
    const std::vector<std::shared_ptr<const ShownTrace>>& runs, RunAxis axis);

/// Moves samples from their instants to the places of their run. Samples before the first and after
/// the last place are left out. A run that goes back stays where it was until it gets further.
/// @param places  null: time, the samples stay as they are
[[nodiscard]] std::shared_ptr<const Envelope> onAxis(const std::shared_ptr<const Envelope>& samples,
                                                     const Envelope* places);

/// `run` minus `reference`, at the places of `run` that the reference has, too.
[[nodiscard]] std::shared_ptr<const Envelope> differenceOf(const Envelope& reference,
                                                           const Envelope& run);

/// Figures of a difference.
struct DifferenceFigures {
  std::size_t count = 0;  ///< values; 0: all others are 0
  double max = 0.0;       ///< the one with the largest amount, with its sign
  double atAxis = 0.0;    ///< where: s, mm or points
  double mean = 0.0;      ///< over the axis: places where samples are dense count no more
  double rms = 0.0;       ///< over the axis
};
[[nodiscard]] DifferenceFigures differenceFigures(const Envelope& difference, base::Instant from,
                                                  base::Instant to);

/// Difference of one signal.
struct SignalDifference {
  SignalOffer offer;
  DifferenceFigures figures;
};

/// Signals that both have, in the order of the reference's offers. Without `formulas`: positions,
/// lag, path speed, contour error, times of requests, columns of the files; on another axis than
/// time also the time.
/// @param reference, run  indices into `runs` and `alignment`
/// @return error as `Formula::parse`, or of a formula that one of the runs cannot calculate
[[nodiscard]] base::Result<std::vector<SignalDifference>> compareRuns(
    const std::vector<std::shared_ptr<const ShownTrace>>& runs, const RunAlignment& alignment,
    std::size_t reference, std::size_t run, const std::vector<std::string>& formulas);

}  // namespace rivulet::trace

template <>
struct std::is_error_code_enum<rivulet::trace::ComparisonError> : std::true_type {};
