// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/contract.h"
#include "base/text.h"

namespace rivulet::gcode {

namespace {

struct CodeText {
  std::string_view name;
  std::string_view sentence;  ///< {} is the argument
};

CodeText textOf(DiagnosticCode code) {
  switch (code) {
    case DiagnosticCode::UnexpectedCharacter:
      return {"unexpected-character",
              "The character \"{}\" has no meaning here: remove it or put it into a comment."};
    case DiagnosticCode::NumberMissing:
      return {"number-missing", "The word {} has no number behind it."};
    case DiagnosticCode::NumberMalformed:
      return {"number-malformed",
              "\"{}\" is not a number: write digits with a point for the decimals."};
    case DiagnosticCode::CommentNotClosed:
      return {"comment-not-closed",
              "A bracket is opened and not closed on this line: the rest of the line is not read."};
    case DiagnosticCode::UnknownGCode:
      return {"unknown-g-code",
              "{} is not a G function Rivulet knows: what it does to the path is unknown."};
    case DiagnosticCode::UnknownWord:
      return {"unknown-word",
              "The word {} is not understood here: what it does to the path is unknown."};
    case DiagnosticCode::UnsupportedGCode:
      return {"unsupported-g-code",
              "{} changes the path or the feed in a way Rivulet does not support: post-process the "
              "program without it."};
    case DiagnosticCode::UnsupportedExpression:
      return {"unsupported-expression",
              "\"{}\" is not run by Rivulet: what it does to the path is unknown."};
    case DiagnosticCode::IgnoredCode:
      return {"ignored-code", "{} is not sent to the control: it does not change the path."};
    case DiagnosticCode::ConflictingGCodes:
      return {"conflicting-g-codes", "{} contradict each other in one block: keep one of them."};
    case DiagnosticCode::RepeatedWord:
      return {"repeated-word", "The word {} appears twice in one block: keep one of them."};
    case DiagnosticCode::ArcWithoutCentre:
      return {"arc-without-centre",
              "The arc has no centre: give I, J, K, or a radius with an end point away from the "
              "start."};
    case DiagnosticCode::ArcRadiusMismatch:
      return {"arc-radius-mismatch",
              "The arc's radius differs by {} mm between start and end: check the centre, which is "
              "read as an increment from the start."};
    case DiagnosticCode::ArcRadiusTooSmall:
      return {
          "arc-radius-too-small",
          "The arc's radius is too small to reach its end point (radius < half chord, mm: {})."};
    case DiagnosticCode::ArcFromUnknownPosition:
      return {"arc-from-unknown-position",
              "The arc starts at an unknown place: program {} with G0 or G1 before it."};
    case DiagnosticCode::RelativeFromUnknownPosition:
      return {"relative-from-unknown-position",
              "The increment of {} starts at an unknown place: program {} with G90 before it."};
    case DiagnosticCode::FeedMissing:
      return {"feed-missing",
              "A block moves with G1, G2 or G3 before any feed F: the feed of the run is used."};
    case DiagnosticCode::FeedNotPositive:
      return {"feed-not-positive", "The feed F{} is not greater than 0."};
    case DiagnosticCode::ValueOutOfRange:
      return {"value-out-of-range", "The value of {} is outside of what Rivulet accepts."};
    case DiagnosticCode::TextAfterProgramEnd:
      return {"text-after-program-end",
              "The blocks from here on stand behind the end of the "
              "program (M30, M2, M17 or %): they are not read."};
    case DiagnosticCode::MotionModeAssumed:
      return {
          "motion-mode-assumed",
          "An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset of the "
          "control."};
    case DiagnosticCode::CentreOutsidePlane:
      return {"centre-outside-plane",
              "The centre word {} does not lie in the plane of the arc: check G17, G18, G19."};
    case DiagnosticCode::TooManyPoints:
      return {"too-many-points",
              "The program has more than {} points: it is not read further. Split it."};
    case DiagnosticCode::EndlessLoop:
      return {"endless-loop",
              "The loop that ends here does not come to an end: {} blocks were run again, then "
              "reading stopped. Check its condition."};
    case DiagnosticCode::ExpressionFault:
      return {"expression-fault", "The calculation has no result: {}."};
    case DiagnosticCode::FlowFault:
      return {"flow-fault", "The order of the blocks is not known from here on: {}."};
    case DiagnosticCode::SubprogramMissing:
      return {
          "subprogram-missing",
          "The subprogram {} is not in this file and not beside it: the points it would give are "
          "missing."};
    case DiagnosticCode::CycleNotRun:
      return {"cycle-not-run",
              "{} is a cycle of the control: the motions it makes are missing here."};
    case DiagnosticCode::MachineCoordinates:
      return {
          "machine-coordinates",
          "{} moves in machine coordinates, whose place in the workpiece is not known: the move "
          "is left out."};
    case DiagnosticCode::RotaryAxes:
      return {"rotary-axes",
              "{} turns on the path: only method window streams it, with this axis among those "
              "chosen."};
    case DiagnosticCode::ToolTip:
      return {"tool-tip",
              "{} makes X, Y and Z those of the tool's tip while rotary axes turn, and no method "
              "switches it on at the control. Have the program written for the axes."};
    case DiagnosticCode::ToolDirections:
      return {"tool-directions",
              "{} give the direction of the tool: the points carry it, but only the control could "
              "make rotary axes of it. Have the program written with A, B or C."};
    case DiagnosticCode::NotAnyDialect:
      return {"not-any-dialect",
              "The file holds bytes that no NC text has: choose a text file, not an archive or a "
              "picture."};
    case DiagnosticCode::CentreReading:
      return {"centre-reading",
              "All arcs of the program fit if I, J and K are read as {}: check how the "
              "post-processor writes them, and load the program that way."};
    case DiagnosticCode::NoMotion:
      return {
          "no-motion",
          "The program moves no axis: there is nothing to stream. Choose a program with G0, G1, "
          "G2 or G3 and X, Y or Z."};
    case DiagnosticCode::LatheAssumed:
      return {"lathe-assumed",
              "{} is a turning cycle, so this is a program for a lathe: X is read as a diameter, U "
              "and W as increments, the plane is Z X."};
    case DiagnosticCode::Accepted:
      return {"accepted",
              "{} is left out, as you have accepted: the path may differ from the "
              "control's."};
    case DiagnosticCode::MoreFindings:
      return {"more-findings", "{} more findings from here on are not listed."};
  }
  base::contractViolated("every code has a text", __FILE__, __LINE__);
}

}  // namespace

std::string_view diagnosticName(DiagnosticCode code) {
  return textOf(code).name;
}

std::string_view severityName(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      break;
  }
  return "error";
}

std::string acceptableName(const Diagnostic& diagnostic) {
  if (diagnostic.severity != Severity::Error) {
    return {};
  }
  switch (diagnostic.code) {
    case DiagnosticCode::UnknownGCode:
    case DiagnosticCode::UnknownWord:
    case DiagnosticCode::UnsupportedGCode:
    case DiagnosticCode::UnsupportedExpression:
    case DiagnosticCode::SubprogramMissing:
    case DiagnosticCode::CycleNotRun:
    case DiagnosticCode::MachineCoordinates:
      break;
    default:
      return {};
  }
  // E5 and E7 are one address; a calculated word goes by what stands in front of its value.
  std::string name = base::toUpper(diagnostic.argument);
  if (diagnostic.code == DiagnosticCode::UnknownWord) {
    std::size_t end = 0;
    while (end < name.size() &&
           ((name[end] >= 'A' && name[end] <= 'Z') || name[end] == '_' || name[end] == '$')) {
      ++end;
    }
    name.resize(end);
  } else {
    name.resize(std::min(name.find_first_of("(="), name.size()));
  }
  return name;
}

std::string describe(const Diagnostic& diagnostic) {
  // Words that are no path but an order to the machine deserve to be said as such.
  if (diagnostic.code == DiagnosticCode::IgnoredCode) {
    const std::string& word = diagnostic.argument;
    if (diagnostic.severity == Severity::Warning) {
      return fmt::format(
          "{} is not sent to the control: the run does not wait here, and no tool is "
          "changed.",
          word);
    }
    if (word == "/") {
      return "A block with \"/\" is executed: Rivulet reads the program with block skip off.";
    }
    if (!word.empty() && (word[0] == 'M' || word[0] == 'S' || word[0] == 'T') &&
        (word.size() == 1 || (word[1] >= '0' && word[1] <= '9'))) {
      return fmt::format("{} is not sent to the control: set spindle, tool and coolant there.",
                         word);
    }
  }
  std::string sentence(textOf(diagnostic.code).sentence);
  for (std::size_t at = sentence.find("{}"); at != std::string::npos;
       at = sentence.find("{}", at + diagnostic.argument.size())) {
    sentence.replace(at, 2, diagnostic.argument);
  }
  return sentence;
}

}  // namespace rivulet::gcode
