// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What is wrong with an NC text, and where. Reading a program for its path makes findings of
/// faults; the virtual machine makes an alarm of a fault when it interprets the block. Both take
/// the words from here. @threadsafety plain values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "base/id.h"

namespace rivulet::nc {

enum class Severity {
  Note,     ///< understood, worth knowing (a word that has no effect on the path)
  Warning,  ///< the path is known, something else may differ from the control
  Error,    ///< the path is not known from here on: the program cannot be streamed
};

enum class FaultCode : std::uint8_t {
  // Findings of a program, each with a sentence for the user: see gcode/diagnostic.
  UnexpectedCharacter,          ///< argument: the character
  NumberMissing,                ///< argument: the address letter
  NumberMalformed,              ///< argument: the text
  BlankInNumber,                ///< argument: the text
  InvisibleCharacter,           ///< argument: its code, "U+00A0"
  CommentNotClosed,             ///< no argument
  CommentNested,                ///< argument: the comment
  UnknownGCode,                 ///< argument: the word, e.g. "G87"
  UnknownMFunction,             ///< of the builder of the machine: argument the word
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
  WordMissing,                  ///< argument: a word, and the words it needs: "G4 P"
  FeedMissing,                  ///< G1/G2/G3 before any F
  FeedLost,                     ///< its unit was chosen behind the last F
  FeedNotPositive,              ///< argument: the value
  ValueOutOfRange,              ///< argument: the word
  NeverExecuted,                ///< argument: the lines of the blocks
  NeverCalled,                  ///< argument: the subprogram and its lines
  AnotherMainProgram,           ///< argument: its name and lines
  RunsAgain,                    ///< M99 of a main program: no argument
  MotionModeAssumed,            ///< an axis before any G0..G3: G1, as SINUMERIK after reset
  CentreOutsidePlane,           ///< I, J or K across the plane of the arc: argument the word
  TooManyPoints,                ///< argument: the limit; the program was not read further
  TooManyNativeBlocks,          ///< argument: the limit; the program was not read further
  EndlessLoop,                  ///< argument: the blocks run again; the program was not run further
  ExpressionFault,              ///< argument: what is wrong with the calculation
  FlowFault,                    ///< argument: what is wrong with the jump, loop or subprogram
  SubprogramMissing,            ///< argument: its name; the points it would give are missing
  CycleNotRun,                  ///< argument: the cycle; the motions it would make are missing
  MachineCoordinates,           ///< argument: the word (SUPA, G53); the move is left out
  RotaryAxes,                   ///< argument: an axis that turns on the path
  ToolTip,                      ///< argument: the word; X Y Z stay the tool's tip while axes turn
  ToolDirections,   ///< argument: the words; the points carry them, no method sends them
  NotAnyDialect,    ///< argument: what was found; the text is of no known dialect
  CentreReading,    ///< argument: the reading under which all arcs fit
  NoMotion,         ///< no argument: no axis moves
  OtherToolLength,  ///< argument: H of a tool that is not in the spindle
  LatheAssumed,     ///< argument: the words that show it; X is read as a diameter, the plane is Z X
  UnitsNotSaid,     ///< argument: the size in mm and, read as inch, in mm
  NoDecimalPoint,   ///< argument: the size in mm and, read as counts, in mm
  ControlSettingOpen,  ///< argument: a word, and what it takes from settings
  SizeUnlikely,        ///< argument: the size in mm, beyond what machines have
  SemicolonEndsBlock,  ///< no argument: words follow ";"
  DialectUnclear,      ///< argument: where the tool goes in each dialect; the load asks
  TwoDialects,         ///< argument: a word of each
  CornerMalformed,     ///< RND or CHF that has no room, or no element beside it
  StopsWithError,      ///< argument: FN 14 and its number
  Accepted,            ///< accepted by the user: argument the name; the word is left out
  MoreFindings,        ///< the list was cut here: argument how many are not in it
  // Expressions as text.
  ValueMissing,
  NotAValue,          ///< argument: the character
  NotANumber,         ///< argument: the text
  ConstantMalformed,  ///< 'H1F', 'B101'
  TextNotClosed,      ///< a text in quotes
  BracketNotClosed,
  OperandMissing,
  NestedTooDeeply,
  RestNotUnderstood,  ///< argument: the text after the expression
  NameUnknown,        ///< argument: what is neither a variable nor a function
  ArgumentsMissing,   ///< argument: the function
  TooFewArguments,    ///< argument: the function
  AtanMalformed,
  ExistsMalformed,
  RNumberMissing,
  VariableNumberMissing,
  VariableNameNotClosed,
  NoSuchHash,    ///< argument: "#ABC"
  IndexMissing,  ///< argument: the system variable
  // Assignments and definitions as text.
  EqualsMissing,
  NotAssignable,  ///< argument: the text before '='
  ListMalformed,  ///< SET, REP
  NameMissing,
  NoSuchType,  ///< argument: the word after DEF
  SizeMalformed,
  ParametersMalformed,
  // Blocks and control structures.
  SyntaxCharacter,  ///< argument: the character
  NoTarget,         ///< of a jump
  IfMalformed,
  ForMalformed,
  CaseMalformed,
  NotClosed,    ///< argument: IF, WHILE, ...
  NoBeginning,  ///< argument: ENDIF, ENDWHILE, ...
  StructuresTooDeep,
  ThenExpected,  ///< after a condition of ISO
  WhileMalformed,
  ONameMissing,
  OWordUnknown,      ///< argument: the O word
  NotInLoop,         ///< argument: the O word
  NotCalled,         ///< argument: the O word
  SubprogramInside,  ///< argument: the subprogram another one is defined in
  ActionNumber,      ///< of a synchronized action
  ActionMalformed,
  ActionTarget,
  // Flow.
  TargetMissing,          ///< argument: the label
  NeitherNameNorProgram,  ///< argument: the name
  CallsTooDeep,
  // Evaluation.
  DivisionByZero,
  OutOfDomain,  ///< argument: "SQRT(-1)"
  NotFinite,
  ValueUnknown,  ///< an earlier fault left the variable without a value
  RUnset,        ///< argument: the number
  NoSuchR,       ///< argument: the number
  NotDefined,    ///< argument: the name
  ArrayIndexMissing,
  ArrayTooManyIndices,
  ArrayTooFewIndices,
  IndexOutsideArray,
  TextCalculated,
  TypeMismatch,  ///< argument: the type that is needed
  OutOfRange,    ///< argument: the type
  TooManyValues,
  TooManyVariables,  ///< argument: the limit
  OnlyOnControl,     ///< argument: the variable
  ControlWritten,
  NumberNotWritable,       ///< argument: "#2001"
  AlarmRaised,             ///< by the program: argument its number and text; it ends there
  ProgramTooLarge,         ///< for the memory that it may take: no argument
  ProgramTwice,            ///< argument: the name of two programs of the file
  TooManyArguments,        ///< argument: how many the subprogram takes
  ReferenceNeedsVariable,  ///< argument: the parameter
  ReferenceTypeDiffers,    ///< argument: the parameter
  IndexFromMainRun,        ///< in a synchronized action
};

/// Where a node of the syntax tree begins in its text.
struct Place {
  base::LineNumber line;
  std::uint16_t file = 0;  ///< 0: the program itself; others: subprograms in the order of loading
  int column = 1;          ///< from 1, in bytes
};

struct Fault {
  FaultCode code = FaultCode::ValueMissing;
  std::string argument;
  Place place;
};

/// A value, or why there is none.
template <class T>
using Expected = tl::expected<T, Fault>;

[[nodiscard]] inline tl::unexpected<Fault> fail(FaultCode code, std::string argument = {},
                                                Place place = {}) {
  return tl::unexpected<Fault>(Fault{code, std::move(argument), place});
}
[[nodiscard]] inline tl::unexpected<Fault> fail(Fault fault) {
  return tl::unexpected<Fault>(std::move(fault));
}

/// True if the fault is about which block comes next, not about a value.
[[nodiscard]] constexpr bool isAboutOrder(FaultCode code) {
  return code == FaultCode::SubprogramMissing || code == FaultCode::ProgramTwice ||
         code == FaultCode::AlarmRaised ||
         (code >= FaultCode::NoTarget && code <= FaultCode::CallsTooDeep);
}

/// True if it is a finding with a sentence of its own, not a cause of one.
[[nodiscard]] constexpr bool isFinding(FaultCode code) {
  return code < FaultCode::ValueMissing;
}

/// The sentence with its parameter in it.
[[nodiscard]] std::string filled(std::string_view sentence, std::string_view parameter);

/// One English clause without full stop, "a bracket is not closed", with "%1" in place of the
/// argument: the source of its translation, context "FaultTexts".
[[nodiscard]] const char* clausePattern(FaultCode code);
[[nodiscard]] std::string describe(const Fault& fault);

}  // namespace rivulet::nc
