// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One finding in an NC program. What Rivulet does not understand becomes a finding, never silence.
/// @threadsafety plain values.
#pragma once

#include <string>
#include <string_view>

#include "base/id.h"

namespace rivulet::gcode {

enum class Severity {
  Note,     ///< understood, worth knowing (a word that has no effect on the path)
  Warning,  ///< the path is known, something else may differ from the control
  Error,    ///< the path is not known from here on: the program cannot be streamed
};

enum class DiagnosticCode {
  UnexpectedCharacter,          ///< argument: the character
  NumberMissing,                ///< argument: the address letter
  NumberMalformed,              ///< argument: the text
  CommentNotClosed,             ///< no argument
  UnknownGCode,                 ///< argument: the word, e.g. "G87"
  UnknownWord,                  ///< argument: the word
  UnsupportedGCode,             ///< known, changes the path, not supported: argument the word
  UnsupportedExpression,        ///< variables, expressions and jumps: argument the text
  IgnoredCode,                  ///< known and without effect on the path: argument the word
  ConflictingGCodes,            ///< two of one group in a block: argument both words
  RepeatedWord,                 ///< the same address twice in a block: argument the address
  ArcWithoutCentre,             ///< no I J K and no CR=
  ArcRadiusMismatch,            ///< argument: the difference in mm
  ArcRadiusTooSmall,            ///< argument: CR= and the half chord
  ArcFromUnknownPosition,       ///< the start of the arc was never programmed
  RelativeFromUnknownPosition,  ///< argument: the axis
  FeedMissing,                  ///< G1/G2/G3 before any F
  FeedNotPositive,              ///< argument: the value
  ValueOutOfRange,              ///< argument: the word
  TextAfterProgramEnd,          ///< blocks after M30/M02/M17 are not read
  MotionModeAssumed,            ///< an axis before any G0..G3: G1, as SINUMERIK after reset
  CentreOutsidePlane,           ///< I, J or K across the plane of the arc: argument the word
  TooManyPoints,                ///< argument: the limit; the program was not read further
  EndlessLoop,                  ///< argument: the blocks run again; the program was not run further
  ExpressionFault,              ///< argument: what is wrong with the calculation
  FlowFault,                    ///< argument: what is wrong with the jump, loop or subprogram
  SubprogramMissing,            ///< argument: its name; the points it would give are missing
  CycleNotRun,                  ///< argument: the cycle; the motions it would make are missing
  MachineCoordinates,           ///< argument: the word (SUPA, G53); the move is left out
  RotaryAxes,                   ///< argument: an axis that turns on the path
  ToolTip,                      ///< argument: the word; X Y Z stay the tool's tip while axes turn
  ToolDirections,  ///< argument: the words; the points carry them, no method sends them
  NotAnyDialect,   ///< argument: what was found; the text is of no known dialect
  CentreReading,   ///< argument: the reading under which all arcs fit
  NoMotion,        ///< no argument: no axis moves
  LatheAssumed,    ///< argument: the turning cycle; X is read as a diameter, the plane is Z X
  Accepted,        ///< accepted by the user: argument the name; the word is left out
  MoreFindings,    ///< the list was cut here: argument how many are not in it
};

struct Diagnostic {
  Severity severity = Severity::Error;
  base::LineNumber line;  ///< of `file`
  int column = 1;         ///< from 1, in bytes
  DiagnosticCode code = DiagnosticCode::UnknownWord;
  std::string argument;
  std::string file = {};  ///< the called file it stands in; empty: the program itself
};

/// Stable name for files and `--json`, e.g. "unknown-g-code".
[[nodiscard]] std::string_view diagnosticName(DiagnosticCode code);

/// "note", "warning", "error".
[[nodiscard]] std::string_view severityName(Severity severity);

/// The name under which the user may accept a finding that stops the load, e.g. "G41" or
/// "CYCLE83"; empty if it cannot be accepted. See `LoadOptions::accepted`.
[[nodiscard]] std::string acceptableName(const Diagnostic& diagnostic);

/// The English sentence with "%1" in place of the argument: the source of its translation, context
/// "DiagnosticTexts".
[[nodiscard]] const char* sentencePattern(const Diagnostic& diagnostic);

/// One English sentence: what was found and what Rivulet does about it.
[[nodiscard]] std::string describe(const Diagnostic& diagnostic);

}  // namespace rivulet::gcode
