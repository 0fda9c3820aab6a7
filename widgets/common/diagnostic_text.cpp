// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/diagnostic_text.h"

#include <QCoreApplication>

namespace rivulet::widgets {

namespace {

struct DiagnosticTexts {
  Q_DECLARE_TR_FUNCTIONS(DiagnosticTexts)

 public:
  static QString severity(gcode::Severity severity) {
    switch (severity) {
      case gcode::Severity::Note:
        return tr("Note");
      case gcode::Severity::Warning:
        return tr("Warning");
      case gcode::Severity::Error:
        return tr("Error");
    }
    return {};
  }

  /// Words that are no path but an order to the machine deserve to be said as such.
  static QString ignored(const gcode::Diagnostic& diagnostic) {
    const QString word = QString::fromStdString(diagnostic.argument);
    if (diagnostic.severity == gcode::Severity::Warning) {
      return tr(
          "%1 is not sent to the control: the run does not wait here, and no tool is "
          "changed.");
    }
    if (word == QStringLiteral("/")) {
      return tr("A block with \"/\" is executed: Rivulet reads the program with block skip off.");
    }
    const bool isOrder = !word.isEmpty() && QStringLiteral("MST").contains(word.front()) &&
                         (word.size() == 1 || word[1].isDigit());
    return isOrder ? tr("%1 is not sent to the control: set spindle, tool and coolant there.")
                   : pattern(gcode::DiagnosticCode::IgnoredCode);
  }

  /// %1 is the argument of the finding.
  static QString pattern(gcode::DiagnosticCode code) {
    using gcode::DiagnosticCode;
    switch (code) {
      case DiagnosticCode::UnexpectedCharacter:
        return tr("The character \"%1\" has no meaning here: remove it or put it into a comment.");
      case DiagnosticCode::NumberMissing:
        return tr("The word %1 has no number behind it.");
      case DiagnosticCode::NumberMalformed:
        return tr("\"%1\" is not a number: write digits with a point for the decimals.");
      case DiagnosticCode::CommentNotClosed:
        return tr(
            "A bracket is opened and not closed on this line: the rest of the line is not "
            "read.");
      case DiagnosticCode::UnknownGCode:
        return tr("%1 is not a G function Rivulet knows: what it does to the path is unknown.");
      case DiagnosticCode::UnknownWord:
        return tr("The word %1 is not understood here: what it does to the path is unknown.");
      case DiagnosticCode::UnsupportedGCode:
        return tr(
            "%1 changes the path or the feed in a way Rivulet does not support: "
            "post-process the program without it.");
      case DiagnosticCode::UnsupportedExpression:
        return tr("\"%1\" is not run by Rivulet: what it does to the path is unknown.");
      case DiagnosticCode::IgnoredCode:
        return tr("%1 is not sent to the control: it does not change the path.");
      case DiagnosticCode::ConflictingGCodes:
        return tr("%1 contradict each other in one block: keep one of them.");
      case DiagnosticCode::RepeatedWord:
        return tr("The word %1 appears twice in one block: keep one of them.");
      case DiagnosticCode::ArcWithoutCentre:
        return tr(
            "The arc has no centre: give I, J, K, or a radius with an end point away from "
            "the start.");
      case DiagnosticCode::ArcRadiusMismatch:
        return tr(
            "The arc's radius differs by %1 mm between start and end: check the centre, "
            "which is read as an increment from the start.");
      case DiagnosticCode::ArcRadiusTooSmall:
        return tr(
            "The arc's radius is too small to reach its end point (radius < half chord, mm: "
            "%1).");
      case DiagnosticCode::ArcFromUnknownPosition:
        return tr("The arc starts at an unknown place: program %1 with G0 or G1 before it.");
      case DiagnosticCode::RelativeFromUnknownPosition:
        return tr("The increment of %1 starts at an unknown place: program %1 with G90 before it.");
      case DiagnosticCode::FeedMissing:
        return tr(
            "A block moves with G1, G2 or G3 before any feed F: the feed of the run is "
            "used.");
      case DiagnosticCode::FeedNotPositive:
        return tr("The feed F%1 is not greater than 0.");
      case DiagnosticCode::ValueOutOfRange:
        return tr("The value of %1 is outside of what Rivulet accepts.");
      case DiagnosticCode::TextAfterProgramEnd:
        return tr(
            "The blocks from here on stand behind the end of the program (M30, M2, M17 or "
            "%): they are not read.");
      case DiagnosticCode::MotionModeAssumed:
        return tr(
            "An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset "
            "of the control.");
      case DiagnosticCode::CentreOutsidePlane:
        return tr("The centre word %1 does not lie in the plane of the arc: check G17, G18, G19.");
      case DiagnosticCode::TooManyPoints:
        return tr("The program has more than %1 points: it is not read further. Split it.");
      case DiagnosticCode::EndlessLoop:
        return tr(
            "The loop that ends here does not come to an end: %1 blocks were run again, then "
            "reading stopped. Check its condition.");
      case DiagnosticCode::ExpressionFault:
        return tr("The calculation has no result: %1.");
      case DiagnosticCode::FlowFault:
        return tr("The order of the blocks is not known from here on: %1.");
      case DiagnosticCode::SubprogramMissing:
        return tr(
            "The subprogram %1 is not in this file and not beside it: the points it would give are "
            "missing.");
      case DiagnosticCode::CycleNotRun:
        return tr("%1 is a cycle of the control: the motions it makes are missing here.");
      case DiagnosticCode::MachineCoordinates:
        return tr(
            "%1 moves in machine coordinates, whose place in the workpiece is not known: the move "
            "is left out.");
      case DiagnosticCode::RotaryAxes:
        return tr(
            "%1 turns on the path: only method window streams it, with this axis among those "
            "chosen.");
      case DiagnosticCode::ToolTip:
        return tr(
            "%1 makes X, Y and Z those of the tool's tip while rotary axes turn, and no method "
            "switches it on at the control. Have the program written for the axes.");
      case DiagnosticCode::ToolDirections:
        return tr(
            "%1 give the direction of the tool: the points carry it, but only the control could "
            "make rotary axes of it. Have the program written with A, B or C.");
      case DiagnosticCode::NotAnyDialect:
        return tr(
            "The file holds bytes that no NC text has: choose a text file, not an archive or a "
            "picture.");
      case DiagnosticCode::CentreReading:
        return tr(
            "All arcs of the program fit if I, J and K are read as %1: check how the "
            "post-processor writes them, and load the program that way.");
      case DiagnosticCode::NoMotion:
        return tr(
            "The program moves no axis: there is nothing to stream. Choose a program with G0, G1, "
            "G2 or G3 and X, Y or Z.");
      case DiagnosticCode::LatheAssumed:
        return tr(
            "%1 is a turning cycle, so this is a program for a lathe: X is read as a diameter, U "
            "and W as increments, the plane is Z X.");
      case DiagnosticCode::Accepted:
        return tr("%1 is left out, as you have accepted: the path may differ from the control's.");
      case DiagnosticCode::MoreFindings:
        return tr("%1 more findings from here on are not listed.");
    }
    return {};
  }
};

}  // namespace

QString severityText(gcode::Severity severity) {
  return DiagnosticTexts::severity(severity);
}

QString severityIconName(gcode::Severity severity) {
  switch (severity) {
    case gcode::Severity::Note:
      return QStringLiteral("status-note");
    case gcode::Severity::Warning:
      return QStringLiteral("status-attention");
    case gcode::Severity::Error:
      return QStringLiteral("status-fault");
  }
  return {};
}

QString diagnosticText(const gcode::Diagnostic& diagnostic) {
  const QString pattern = diagnostic.code == gcode::DiagnosticCode::IgnoredCode
                              ? DiagnosticTexts::ignored(diagnostic)
                              : DiagnosticTexts::pattern(diagnostic.code);
  if (pattern.isEmpty()) {
    return QString::fromStdString(gcode::describe(diagnostic));
  }
  return pattern.contains(QStringLiteral("%1"))
             ? pattern.arg(QString::fromStdString(diagnostic.argument))
             : pattern;
}

}  // namespace rivulet::widgets
