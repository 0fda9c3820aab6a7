// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/diagnostic.h"

#include <algorithm>
#include <array>

#include "base/sentence.h"
#include "base/text.h"

namespace rivulet::gcode {

namespace {

struct CodeText {
  DiagnosticCode code;
  std::string_view name;
  const char* sentence;
};

constexpr std::array kTexts{
    CodeText{DiagnosticCode::UnexpectedCharacter, "unexpected-character",
             RIVULET_SENTENCE(
                 "DiagnosticTexts",
                 "The character \"%1\" has no meaning here: remove it or put it into a comment.")},
    CodeText{DiagnosticCode::NumberMissing, "number-missing",
             RIVULET_SENTENCE("DiagnosticTexts", "The word %1 has no number.")},
    CodeText{DiagnosticCode::NumberMalformed, "number-malformed",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "\"%1\" is not a number: write digits with a decimal point.")},
    CodeText{DiagnosticCode::BlankInNumber, "blank-in-number",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "A blank is inside the number \"%1\": this control does not put the "
                              "parts together. Write the number without blanks.")},
    CodeText{DiagnosticCode::InvisibleCharacter, "invisible-character",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "An invisible character stands here (%1), as office programs and web "
                              "pages insert it: replace it by an ordinary blank.")},
    CodeText{
        DiagnosticCode::CommentNotClosed, "comment-not-closed",
        RIVULET_SENTENCE(
            "DiagnosticTexts",
            "A bracket is opened but not closed in this line: the rest of the line is not read.")},
    CodeText{DiagnosticCode::CommentNested, "comment-nested",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "A bracket is opened within the comment %1, which ends at the first "
                              "closing bracket. Write it without inner brackets.")},
    CodeText{DiagnosticCode::UnknownGCode, "unknown-g-code",
             RIVULET_SENTENCE(
                 "DiagnosticTexts",
                 "Rivulet does not know the G function %1: its effect on the path is unknown.")},
    CodeText{DiagnosticCode::UnknownMFunction, "unknown-m-function",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 is a function of the builder of the machine: whether it moves an "
                              "axis or changes the feed is not known. Accept it if it does not.")},
    CodeText{
        DiagnosticCode::UnknownWord, "unknown-word",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "The word %1 is not understood here: its effect on the path is unknown.")},
    CodeText{DiagnosticCode::UnsupportedGCode, "unsupported-g-code",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 changes the path or the feed in a way that Rivulet does not "
                              "support: post-process the program without it.")},
    CodeText{
        DiagnosticCode::UnsupportedExpression, "unsupported-expression",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "Rivulet does not execute \"%1\": its effect on the path is unknown.")},
    CodeText{DiagnosticCode::IgnoredCode, "ignored-code",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 is not sent to the control: it does not change the path.")},
    CodeText{DiagnosticCode::ConflictingGCodes, "conflicting-g-codes",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 contradict each other in one block: keep one of them.")},
    CodeText{DiagnosticCode::RepeatedWord, "repeated-word",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The word %1 appears twice in one block: keep one of them.")},
    CodeText{DiagnosticCode::ArcWithoutCentre, "arc-without-centre",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The arc has no centre: give I, J, K, or a radius with an end point "
                              "that differs from the start.")},
    CodeText{DiagnosticCode::ArcRadiusMismatch, "arc-radius-mismatch",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The arc's radius differs by %1 mm between start and end: check the "
                              "centre, which is read as an increment from the start.")},
    CodeText{
        DiagnosticCode::ArcRadiusTooSmall, "arc-radius-too-small",
        RIVULET_SENTENCE(
            "DiagnosticTexts",
            "The arc's radius is too small to reach its end point (radius < half chord, mm: %1).")},
    CodeText{DiagnosticCode::ArcFromUnknownPosition, "arc-from-unknown-position",
             RIVULET_SENTENCE(
                 "DiagnosticTexts",
                 "The arc starts at an unknown position: program %1 with G0 or G1 before it.")},
    CodeText{
        DiagnosticCode::RelativeFromUnknownPosition, "relative-from-unknown-position",
        RIVULET_SENTENCE(
            "DiagnosticTexts",
            "The increment of %1 starts at an unknown position: program %1 with G90 before it.")},
    CodeText{DiagnosticCode::WordMissing, "word-missing",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The block lacks a word that the control needs (%1): add it.")},
    CodeText{DiagnosticCode::FeedMissing, "feed-missing",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "A block moves with G1, G2 or G3 before a feed F is programmed: only "
                              "a fixed feed can be used.")},
    CodeText{
        DiagnosticCode::FeedLost, "feed-lost",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "The number of the last F may mean another feed here, because mm, inch, "
                         "G94 or G95 was chosen behind it: program F again.")},
    CodeText{DiagnosticCode::FeedNotPositive, "feed-not-positive",
             RIVULET_SENTENCE("DiagnosticTexts", "The feed F%1 is not greater than 0.")},
    CodeText{DiagnosticCode::ValueOutOfRange, "value-out-of-range",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The value of %1 is outside the range that Rivulet accepts.")},
    CodeText{DiagnosticCode::NeverExecuted, "never-executed",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The blocks of %1 are never executed: check the end of the program "
                              "and the jumps before them, or remove them.")},
    CodeText{DiagnosticCode::NeverCalled, "never-called",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "No block calls the subprogram %1: check the calls, or remove it.")},
    CodeText{DiagnosticCode::AnotherMainProgram, "another-main-program",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The file holds another main program, %1: which one is to run is not "
                              "known. Give each main program a file of its own.")},
    CodeText{DiagnosticCode::RunsAgain, "runs-again",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "With M99, a main program begins again at the control, without end: "
                              "it is executed once here. Write M30 if it is to end.")},
    CodeText{DiagnosticCode::MotionModeAssumed, "motion-mode-assumed",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "An axis is programmed before any of G0 to G3: G1 is assumed, as "
                              "after a reset of the control.")},
    CodeText{DiagnosticCode::CentreOutsidePlane, "centre-outside-plane",
             RIVULET_SENTENCE(
                 "DiagnosticTexts",
                 "The centre word %1 is not in the plane of the arc: check G17, G18, G19.")},
    CodeText{
        DiagnosticCode::TooManyPoints, "too-many-points",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "The program has more than %1 points: it is not read further. Split it.")},
    CodeText{DiagnosticCode::TooManyNativeBlocks, "too-many-native-blocks",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "Loops and calls repeat more than %1 blocks for the control: the "
                              "program is not read further. Check the condition of the loop.")},
    CodeText{DiagnosticCode::EndlessLoop, "endless-loop",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The loop that ends here does not terminate: reading stopped after "
                              "%1 repeated blocks. Check its condition.")},
    CodeText{DiagnosticCode::ExpressionFault, "expression-fault",
             RIVULET_SENTENCE("DiagnosticTexts", "The calculation has no result: %1.")},
    CodeText{DiagnosticCode::FlowFault, "flow-fault",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The sequence of the blocks is not known from here on: %1.")},
    CodeText{DiagnosticCode::SubprogramMissing, "subprogram-missing",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The subprogram %1 is neither in this file nor in a file beside it: "
                              "its points are missing.")},
    CodeText{DiagnosticCode::CycleNotRun, "cycle-not-run",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 is a cycle of the control: its motions are missing here.")},
    CodeText{DiagnosticCode::MachineCoordinates, "machine-coordinates",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 moves in machine coordinates, whose position in the workpiece is "
                              "not known: the move is left out.")},
    CodeText{DiagnosticCode::RotaryAxes, "rotary-axes",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 moves on the path: only method window streams it, and only if "
                              "this axis is selected.")},
    CodeText{DiagnosticCode::ToolTip, "tool-tip",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "With %1, X, Y and Z are those of the tool tip while rotary axes "
                              "turn, and no method switches it on at the control. Post-process the "
                              "program for the axes of the machine.")},
    CodeText{DiagnosticCode::ToolDirections, "tool-directions",
             RIVULET_SENTENCE(
                 "DiagnosticTexts",
                 "%1 give the tool direction. The points keep it, but only the control could "
                 "convert it to rotary axes. Post-process the program with A, B or C.")},
    CodeText{DiagnosticCode::NotAnyDialect, "not-any-dialect",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The file holds bytes that do not occur in NC text: choose a text "
                              "file, not an archive or a picture.")},
    CodeText{DiagnosticCode::CentreReading, "centre-reading",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "All arcs of the program fit if I, J and K are read as %1: check how "
                              "the post-processor writes them, and load the program that way.")},
    CodeText{DiagnosticCode::NoMotion, "no-motion",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The program moves no axis: there is nothing to stream. Choose a "
                              "program with G0, G1, G2 or G3 and X, Y or Z.")},
    CodeText{DiagnosticCode::OtherToolLength, "other-tool-length",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 is not the number of the tool in the spindle: check which length "
                              "it stands for.")},
    CodeText{DiagnosticCode::LatheAssumed, "lathe-assumed",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The program is for a lathe (%1): X is read as a diameter, U and W "
                              "as increments, the plane is Z X, and with G99 F is per "
                              "revolution.")},
    CodeText{
        DiagnosticCode::UnitsNotSaid, "units-not-said",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "No block says mm or inch (G21, G20) before the first move: the size is "
                         "%1, read as mm or as inch. Load it with its unit (--units).")},
    CodeText{
        DiagnosticCode::NoDecimalPoint, "no-decimal-point",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "Coordinates have no decimal point: the size is %1, read as whole units "
                         "or as least increments. Load it as the control is set "
                         "(--no-point).")},
    CodeText{DiagnosticCode::ControlSettingOpen, "control-setting-open",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "What the program leaves out is taken from the settings of a virtual "
                              "machine: %1. Load it as the control is set (--setting).")},
    CodeText{DiagnosticCode::SizeUnlikely, "size-unlikely",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The program is larger than a machine (%1): check its unit (G20, "
                              "G21, --units) and its decimal points.")},
    CodeText{DiagnosticCode::SemicolonEndsBlock, "semicolon-ends-block",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The words after \";\" are read as a block of their own, as on the "
                              "control. If \";\" begins comments here, choose another dialect "
                              "(--dialect).")},
    CodeText{
        DiagnosticCode::DialectUnclear, "dialect-unclear",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "The text does not show which control it is for, and they differ from "
                         "here on: %1. Choose the dialect (--dialect).")},
    CodeText{DiagnosticCode::TwoDialects, "two-dialects",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The file has words of two controls (%1): split it, or choose the "
                              "dialect (--dialect).")},
    CodeText{DiagnosticCode::CornerMalformed, "corner-malformed",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The corner cannot be rounded or chamfered: there must be an element "
                              "of the contour before and behind it, both long enough.")},
    CodeText{DiagnosticCode::StopsWithError, "stops-with-error",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "The program ends here with its own error (%1): check the values it "
                              "has been given.")},
    CodeText{DiagnosticCode::Accepted, "accepted",
             RIVULET_SENTENCE("DiagnosticTexts",
                              "%1 is left out because you accepted it: the path may differ from "
                              "the path at the control.")},
    CodeText{DiagnosticCode::MoreFindings, "more-findings",
             RIVULET_SENTENCE("DiagnosticTexts", "%1 more findings from here on are not listed.")},
};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kTexts.size(); ++i) {
    if (kTexts[i].code != static_cast<DiagnosticCode>(i)) {
      return false;
    }
  }
  return kTexts.back().code == DiagnosticCode::MoreFindings;
}
static_assert(isInOrder(), "one text for each code, in the order of the codes");

const CodeText& textOf(DiagnosticCode code) {
  return kTexts[static_cast<std::size_t>(code)];
}

/// Words that command the machine and leave the path alone deserve a sentence of their own.
const char* ignoredPattern(const Diagnostic& diagnostic) {
  const std::string& word = diagnostic.argument;
  if (diagnostic.severity == Severity::Warning) {
    return RIVULET_SENTENCE(
        "DiagnosticTexts",
        "%1 is not sent to the control: the run does not wait here, and no tool is changed.");
  }
  if (word == "/") {
    return RIVULET_SENTENCE(
        "DiagnosticTexts",
        "A block with \"/\" is executed: Rivulet reads the program with block skip off.");
  }
  const bool isCommand = !word.empty() &&
                         std::string_view("MST").find(word[0]) != std::string::npos &&
                         (word.size() == 1 || base::isDigit(word[1]));
  return isCommand ? RIVULET_SENTENCE(
                         "DiagnosticTexts",
                         "%1 is not sent to the control: set spindle, tool and coolant there.")
                   : textOf(DiagnosticCode::IgnoredCode).sentence;
}

/// Words for which the sentence of their code says too little.
struct OwnText {
  DiagnosticCode code;
  std::string_view begins;  ///< the argument, or its first word
  const char* sentence;
};
constexpr std::array kOwnTexts{
    OwnText{DiagnosticCode::UnsupportedGCode, "EXECSTRING",
            RIVULET_SENTENCE("DiagnosticTexts",
                             "%1 executes a text that is put together while the program runs: what "
                             "it does is not known here. Write the block itself.")},
    OwnText{DiagnosticCode::UnsupportedGCode, "VELOLIM",
            RIVULET_SENTENCE("DiagnosticTexts",
                             "%1 limits the speed of an axis, and a stream does not keep the "
                             "limit: program a feed that keeps it, and remove the word.")},
    OwnText{
        DiagnosticCode::CycleNotRun, "MCALL",
        RIVULET_SENTENCE("DiagnosticTexts",
                         "%1 calls a subprogram behind each block that moves, and it is neither "
                         "in this file nor in a file beside it: its motions are missing. Put "
                         "its file beside the program.")}};

/// Words that say where the path goes or how fast: without them it is another path.
bool isOfPath(std::string_view word) {
  return word.size() == 1 && std::string_view("XYZIJKF").find(word[0]) != std::string_view::npos;
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
    case DiagnosticCode::UnknownMFunction:
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
  // E5 and E7 are one address; a calculated word is named by what precedes its value.
  std::string name = base::toUpper(diagnostic.argument);
  if (diagnostic.code == DiagnosticCode::UnknownWord) {
    std::size_t end = 0;
    while (end < name.size() &&
           ((name[end] >= 'A' && name[end] <= 'Z') || name[end] == '_' || name[end] == '$')) {
      ++end;
    }
    name.resize(isOfPath(std::string_view(name).substr(0, end)) ? 0 : end);
  } else {
    name.resize(std::min(name.find_first_of("(="), name.size()));
  }
  return name;
}

const char* sentencePattern(const Diagnostic& diagnostic) {
  const std::string_view argument = diagnostic.argument;
  const std::string_view word = argument.substr(0, argument.find_first_of(" ([="));
  const auto* const own = std::find_if(
      kOwnTexts.begin(), kOwnTexts.end(),
      [&](const OwnText& each) { return each.code == diagnostic.code && each.begins == word; });
  if (own != kOwnTexts.end()) {
    return own->sentence;
  }
  return diagnostic.code == DiagnosticCode::IgnoredCode ? ignoredPattern(diagnostic)
                                                        : textOf(diagnostic.code).sentence;
}

std::string parameterOf(const Diagnostic& diagnostic) {
  return diagnostic.cause ? nc::describe({*diagnostic.cause, diagnostic.argument, {}})
                          : diagnostic.argument;
}

std::string describe(const Diagnostic& diagnostic) {
  return nc::filled(sentencePattern(diagnostic), parameterOf(diagnostic));
}

}  // namespace rivulet::gcode
