// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The control's own recording of a run: one sample per interpolation cycle, and every block
/// the main run executed. The judge of a stream works from this, never from the client's view.
/// @threadsafety plain values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/axes.h"
#include "base/budget.h"
#include "base/id.h"
#include "base/instant.h"
#include "base/result.h"
#include "base/vec3.h"

namespace rivulet::trace {

struct ControlSample {
  base::Instant at{};
  base::Vec3 commandMm;   ///< set point, workpiece frame
  base::Vec3 actualMm;    ///< after the servo
  double feedMmPerS = 0;  ///< path speed of the set point; deg/s if only rotary axes turn
  base::LineNumber line;  ///< block in motion, line of the NC program on the control
  base::RotaryDeg commandDeg{};
  base::RotaryDeg actualDeg{};
};

/// One motion block, from the moment the main run started it to its end.
struct ExecutedBlock {
  base::Instant from{};
  base::Instant to{};
  base::LineNumber line;
  base::Vec3 targetMm;    ///< programmed end point
  double lengthMm = 0.0;  ///< path length of X Y Z
  base::RotaryDeg targetDeg{};
  double turnDeg = 0.0;  ///< how far the rotary axes turn, as `base::turnDeg` says

  /// False if the block moves nothing.
  [[nodiscard]] bool moves() const { return lengthMm > 0.0 || turnDeg > 0.0; }
};

/// What the machine did besides moving.
struct ControlEvent {
  enum class Kind {
    ToolChange,  ///< `value`: T number; `name`
    Edge,        ///< D: `value`
    WorkOffset,  ///< `value`: number of the G function, 500: none
    Spindle,     ///< `value`: speed commanded, 1/min, negative for M4; 0: it stops
    Coolant,     ///< `value`: sum of 1 for M8 and 2 for M7; 0: off
    Dwell,       ///< G4
    Stop,        ///< `value`: 0 for M0, 1 for M1
  };
  base::Instant from{};
  base::Instant to{};  ///< when the next block could begin
  base::LineNumber line;
  Kind kind = Kind::Stop;
  double value = 0.0;
  std::string name;
};

struct ControlTrace {
  base::Duration cycle{};        ///< interpolation cycle
  base::RotarySet rotaryAxes{};  ///< those the machine has; angles of others are 0 and not written
  std::vector<ControlSample> samples;
  std::vector<ExecutedBlock> blocks;
  std::vector<ControlEvent> events;  ///< in the order of their beginning
  bool truncated = false;            ///< the control's trace memory was full before the run ended
  /// Blocks that are not of the run were left out: the samples show more than the blocks say.
  bool hasOwnBlocksOnly = false;
};

enum class TraceError {
  NotATrace = 1,  ///< another kind of file
  NewerVersion,   ///< written by a later Rivulet
  Damaged,        ///< a line cannot be read; everything before it is kept where possible
};

[[nodiscard]] std::error_code make_error_code(TraceError code);

/// Versioned line format (docs/formats.md). `parse(print(t))` equals `t`. A trace without events is
/// written in format 2, one without rotary axes too in format 1.
[[nodiscard]] std::string printControlTrace(const ControlTrace& trace);
/// @param budget  without the text
/// @return error `TraceError`, BudgetError::Exceeded
[[nodiscard]] base::Result<ControlTrace> parseControlTrace(std::string_view text,
                                                           const base::Budget& budget = {});

/// What the analysis of a trace takes for each sample, beside the sample itself, bytes: a
/// `MotionSample`, its speeds and what is drawn of it.
inline constexpr std::size_t kAnalysedSampleBytes = 200;
/// The same of a table, whose columns are those of the motion: speeds, extremes, and what is drawn
/// of a program.
inline constexpr std::size_t kAnalysedRowBytes = 80;
/// What the trace takes with its analysis, bytes, without the names of its events.
[[nodiscard]] std::size_t memoryBytes(const ControlTrace& trace);
/// Lines that are read before somebody asks the budget again: they hold less than a megabyte.
inline constexpr std::size_t kLinesUnasked = 4096;

}  // namespace rivulet::trace

template <>
struct std::is_error_code_enum<rivulet::trace::TraceError> : std::true_type {};
