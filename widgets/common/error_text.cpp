// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/error_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "base/budget.h"
#include "base/file.h"
#include "emulator/emulator_error.h"
#include "feasibility/verdict.h"
#include "gcode/error.h"
#include "live/error.h"
#include "opcua/connection.h"
#include "opcua/control_map.h"
#include "opcua/error.h"
#include "streaming/control/machine_facts.h"
#include "streaming/run/run.h"
#include "streaming/setup/calibration.h"
#include "templates/cells.h"
#include "trace/comparison.h"
#include "trace/control_trace.h"
#include "trace/formula.h"
#include "trace/import/import_error.h"
#include "trace/spectrum.h"

namespace rivulet::widgets {

namespace {

/// True if a code belongs to the folder whose enum is `Code`.
template <class Code>
bool belongsTo(const std::error_code& code) {
  return code.category() == make_error_code(static_cast<Code>(1)).category();
}

struct ErrorTexts {
  Q_DECLARE_TR_FUNCTIONS(ErrorTexts)

 public:
  static QString text(gcode::GcodeError code) {
    using gcode::GcodeError;
    switch (code) {
      case GcodeError::FileUnreadable:
        return tr("The file cannot be read. Check that it exists and that you may read it.");
      case GcodeError::EmptyProgram:
        return tr("The program is empty. Choose a file with NC blocks.");
      case GcodeError::NoMotion:
        return tr("The program moves no axis. Choose a program with G0, G1, G2 or G3.");
      case GcodeError::NotUnderstood:
        return tr("Parts of the program are not understood. See the list of findings.");
      case GcodeError::Cancelled:
        return tr("Loading was cancelled.");
      case GcodeError::Ambiguous:
        return tr(
            "The text leaves open what it means. Choose the dialect, the unit or the reading of "
            "numbers without a decimal point.");
      case GcodeError::BadTolerance:
        return tr(
            "The path cannot be kept within this tolerance. Allow more of it, or none; packed "
            "points are moved by up to 0.001 mm.");
    }
    return {};
  }

  static QString text(emulator::EmulatorError code) {
    using emulator::EmulatorError;
    switch (code) {
      case EmulatorError::BadTimes:
        return tr("Times and positions do not fit together. Record the run again.");
      case EmulatorError::BadNumbers:
        return tr("A value is not a number. Leave its row out of the file.");
      case EmulatorError::NoMotion:
        return tr("An axis does not move in these recordings. Add one that moves it.");
      case EmulatorError::TooShort:
        return tr(
            "There are too few samples to learn from. Record a longer program, with set "
            "points and actual positions.");
      case EmulatorError::BadUnits:
        return tr("Set points and actual positions differ by a factor. Check their units.");
      case EmulatorError::WrongProgram:
        return tr(
            "Recording and program do not fit together. Check the program, and that the "
            "preset has the machine's limits.");
      case EmulatorError::Diverged:
        return tr(
            "No model follows this recording. Check that set points and positions belong "
            "together.");
      case EmulatorError::Cancelled:
        return tr("Learning was cancelled. What was learned before stays.");
      case EmulatorError::BadFile:
        return tr("The file is not an emulator, or one of a later version.");
    }
    return {};
  }

  static QString text(feasibility::FeasibilityError code) {
    using feasibility::FeasibilityError;
    switch (code) {
      case FeasibilityError::FeedNotPositive:
        return tr("The feed F must be between 0.001 and 1 000 000 mm/min.");
      case FeasibilityError::DeltaNotPositive:
        return tr("The distance δ must be greater than zero.");
      case FeasibilityError::NothingKnown:
        return tr("No prediction is possible for this method.");
      case FeasibilityError::TooFewPointsPerLoop:
        return tr("N is too small. Choose at least 2 points per loop.");
    }
    return {};
  }

  static QString text(live::LiveError code) {
    using live::LiveError;
    switch (code) {
      case LiveError::NotALine:
        return tr("The line is neither a point nor end, hold or comment.");
      case LiveError::NotFinite:
        return tr("A word of the line has no number.");
      case LiveError::TooLong:
        return tr("The line is too long.");
      case LiveError::Incomplete:
        return tr("The source was closed in the middle of the line.");
      case LiveError::OutsideBox:
        return tr("The point is outside the agreed box.");
      case LiveError::StepTooLong:
        return tr("The step to the point is longer than agreed.");
      case LiveError::TurnTooLarge:
        return tr("A rotary axis would turn farther in one step than agreed.");
      case LiveError::FeedTooLarge:
        return tr("F is larger than agreed, or not above 0.");
      case LiveError::TooFarAway:
        return tr(
            "The first point is farther from the tool than agreed. Move the tool there, or begin "
            "where it is.");
      case LiveError::AxisNotChosen:
        return tr("The point names an axis that is not one of this run.");
      case LiveError::NumberMissing:
        return tr("This source can lose points, so it has to number them: N1 X0.5, then N2.");
      case LiveError::NumberWrong:
        return tr("A point is missing or came twice: the numbers are not in order.");
      case LiveError::SourceClosed:
        return tr("The source was closed without end.");
      case LiveError::SourceSilent:
        return tr("The source was silent for longer than agreed.");
      case LiveError::Overrun:
        return tr(
            "The source was faster than the machine and cannot wait. Send fewer points, or use "
            "TCP.");
      case LiveError::NoPoint:
        return tr("The source ended before its first point. Nothing has moved.");
      case LiveError::NotOpened:
        return tr("The source cannot be opened. Choose another port or path.");
      case LiveError::BadSourceFile:
        return tr("The file of the source is not as the manual shows it (Live points).");
      case LiveError::NotAgreed:
        return tr("These values cannot be kept together. Check box, step and times.");
      case LiveError::FactorAmongPoints:
        return tr(
            "A factor of the feed would wait here behind points that are not read yet. Send "
            "factors over a source of their own.");
    }
    return {};
  }

  /// "tcp:4001, line 17" as core writes it.
  static QString place(const std::string& context) {
    const QString text = QString::fromStdString(context);
    const qsizetype at = text.lastIndexOf(QStringLiteral(", line "));
    return at < 0 ? text : tr("%1, line %2").arg(text.left(at), text.mid(at + 7));
  }

  static QString text(templates::TemplateError code) {
    using templates::TemplateError;
    switch (code) {
      case TemplateError::TooFewPointsPerLoop:
        return tr("N is too small for this method. Choose more points per loop.");
      case TemplateError::DoesNotFit:
        return tr(
            "N points do not fit the R-parameters of the control. Choose a smaller N, the "
            "contiguous layout, or enlarge MD28050.");
      case TemplateError::NoAxis:
        return tr("No axis is chosen. Choose at least one axis.");
      case TemplateError::BadCells:
        return tr(
            "The R-parameters of method window are out of range. Check base, stride and number of "
            "windows.");
      case TemplateError::FileNotWritable:
        return tr("The file cannot be written. Choose another folder.");
      case TemplateError::BadCorrection:
        return tr("Online correction is possible with method window, for X, Y and Z, up to 1 mm.");
      case TemplateError::BadFactor:
        return tr(
            "A factor of the override is possible with methods window and credit, from 0.01 to 2, "
            "with 1 between its bounds.");
      case TemplateError::RotaryNeedsWindow:
        return tr("Only method window streams rotary axes. Choose it.");
      case TemplateError::TooManyAxes:
        return tr("Too many axes. Choose at most five.");
      case TemplateError::BadAxes:
        return tr("These are not axes. Choose from X, Y, Z, A, B and C.");
      case TemplateError::NotOnTarget:
        return tr("This make of control cannot do that. Choose another method or setting.");
    }
    return {};
  }

  static QString text(trace::TraceError code) {
    using trace::TraceError;
    switch (code) {
      case TraceError::NotATrace:
        return tr("This file is not a Rivulet recording.");
      case TraceError::NewerVersion:
        return tr("The recording was written by a newer Rivulet. Update this program to read it.");
      case TraceError::Damaged:
        return tr("The recording is damaged. Everything before the damage was kept.");
    }
    return {};
  }

  static QString text(trace::FormulaError code) {
    using trace::FormulaError;
    switch (code) {
      case FormulaError::NotUnderstood:
        return tr("The formula is not understood from here on.");
      case FormulaError::NotComplete:
        return tr("The formula is not complete.");
      case FormulaError::UnknownFunction:
        return tr("There is no such function. Press F1 for those there are.");
      case FormulaError::UnknownSignal:
        return tr("The trace has no such signal. The tool tips of the signals have their names.");
    }
    return {};
  }

  static QString text(trace::ComparisonError code) {
    using trace::ComparisonError;
    switch (code) {
      case ComparisonError::NoPositions:
        return tr("The trace has no positions: compare it by time.");
      case ComparisonError::NoProgram:
        return tr("To compare by points, open the NC program that the traces show.");
      case ComparisonError::DifferentPrograms:
        return tr("The runs are of different programs: compare them by time or path.");
    }
    return {};
  }

  static QString text(trace::SpectrumError code) {
    return code == trace::SpectrumError::TooFewSamples
               ? tr("A spectrum needs 16 samples or more between the cursors.")
               : QString();
  }

  static QString text(trace::ImportError code) {
    switch (code) {
      case trace::ImportError::NotATable:
        return tr("This is no trace that can be read: there are no rows of numbers in it.");
      case trace::ImportError::BadMapping:
        return tr("The table has no such column.");
      case trace::ImportError::RoleTwice:
        return tr("Two columns have the same meaning. Choose one of them.");
      case trace::ImportError::NoHdf5:
        return tr("This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.");
      case trace::ImportError::AgentRefused:
        return tr("This is no trace, but the refusal of an MTConnect agent. Ask it for /sample.");
    }
    return {};
  }

  static QString text(base::FileError code) {
    switch (code) {
      case base::FileError::Unreadable:
        return tr("The file cannot be read. Check that it exists and that you may read it.");
      case base::FileError::NotWritable:
        return tr("The file cannot be written. Check the folder and the free space.");
    }
    return {};
  }

  static QString text(base::BudgetError code) {
    switch (code) {
      case base::BudgetError::Exceeded:
        return tr("This would take more memory than a file may. Choose a smaller one.");
    }
    return {};
  }

  static QString text(streaming::MachineFileError code) {
    using streaming::MachineFileError;
    switch (code) {
      case MachineFileError::NotAMachineFile:
        return tr("This is not a machine file of Rivulet. Move the file away.");
      case MachineFileError::OtherVersion:
        return tr("This was written by another version of Rivulet. Measure again.");
      case MachineFileError::Damaged:
        return tr("The calibration is damaged. Measure again.");
    }
    return {};
  }

  static QString text(opcua::LinkError code) {
    using opcua::LinkError;
    switch (code) {
      case LinkError::NotReachable:
        return tr("No OPC UA server answers at this endpoint. Check address, port and network.");
      case LinkError::ConnectionLost:
        return tr("The connection to the control is lost. Check the machine, then connect again.");
      case LinkError::DeadlineExceeded:
        return tr("The control did not answer in time. Check the network and its load.");
      case LinkError::VariableMissing:
        return tr(
            "The control does not have a variable that Rivulet needs. Check the configuration of "
            "the server.");
      case LinkError::NotWritable:
        return tr("A variable is write-protected. Give this user write access on the control.");
      case LinkError::BadValue:
        return tr("A value cannot be used; nothing was sent.");
      case LinkError::Rejected:
        return tr("The control rejected the request.");
      case LinkError::NamespaceMissing:
        return tr("The server is not a SINUMERIK (no SinumerikVarProvider). Check the endpoint.");
      case LinkError::MethodMissing:
        return tr("The server does not offer this function.");
      case LinkError::ProgramMissing:
        return tr("There is no such program on the control. Send the template first.");
      case LinkError::ChannelNotInReset:
        return tr("The channel is not in reset. Press reset at the control, then try again.");
      case LinkError::FileExists:
        return tr("A program of this name is already on the control.");
      case LinkError::TooManyItems:
        return tr("The request is larger than the server accepts. Choose a smaller N.");
      case LinkError::EncryptionMissing:
        return tr(
            "The server does not offer the encryption that is required. Set it up on the control, "
            "or allow this machine to be reached without it.");
      case LinkError::CertificateUnknown:
        return tr(
            "The server's certificate is not known yet. Compare its fingerprint with the one at "
            "the control, then accept it.");
      case LinkError::CertificateChanged:
        return tr(
            "The server shows another certificate than the one that was accepted. Find out why "
            "before you accept it.");
      case LinkError::CertificateInvalid:
        return tr("A certificate cannot be used: it is damaged or has ended. Create a new one.");
      case LinkError::ClientNotTrusted:
        return tr(
            "The server does not trust the certificate of this computer. Accept it at the "
            "control, then connect again.");
      case LinkError::LoginRefused:
        return tr("The server refuses user name or password. Check both.");
      case LinkError::HostUnknown:
        return tr(
            "No computer of this name is known on the network. Check the name, or give the IP "
            "address of the control.");
      case LinkError::NoHandles:
        return tr(
            "Too many files and connections are open on this computer. Close other programs, then "
            "try again.");
      case LinkError::NoHistory:
        return tr("The server keeps no history of this node. Have it recorded at the server.");
    }
    return {};
  }

  static QString text(opcua::LinkKindError code) {
    using opcua::LinkKindError;
    switch (code) {
      case LinkKindError::NotBuilt:
        return tr("Rivulet was built without Qt OPC UA. Connect with open62541.");
      case LinkKindError::NotAble:
        return tr("Qt OPC UA cannot encrypt, log in or use a map here. Connect with open62541.");
    }
    return {};
  }

  static QString text(opcua::MapError code) {
    using opcua::MapError;
    switch (code) {
      case MapError::BadFile:
        return tr("The map cannot be used. Correct the file at the place that is named.");
      case MapError::WrongAddress:
        return tr(
            "The map names a node that the server does not have, or one of another type. Correct "
            "the map.");
    }
    return {};
  }

  static QString text(streaming::CalibrationError code) {
    using streaming::CalibrationError;
    switch (code) {
      case CalibrationError::NoCells:
        return tr("These R-parameters cannot be used. Choose some that exist (MD28050).");
      case CalibrationError::ChannelBusy:
        return tr(
            "A program is running on the control: the measurement has ended. The R-parameters have "
            "their old values.");
      case CalibrationError::Cancelled:
        return tr("The calibration was cancelled. The R-parameters have their old values.");
      case CalibrationError::NotRestored:
        return tr(
            "The R-parameters could not be restored and may hold test values. Set them at the "
            "control.");
    }
    return {};
  }

  static QString text(streaming::StreamError code) {
    using streaming::StreamError;
    switch (code) {
      case StreamError::WrongProgram:
        return tr(
            "The control does not run the expected template. Select and start the template for "
            "these settings.");
      case StreamError::ChannelBusy:
        return tr(
            "Another program is running on the control. Wait until it has ended, or reset the "
            "channel.");
      case StreamError::NotStarted:
        return tr("Cycle start was not pressed in time. Start the run again.");
      case StreamError::StreamStalled:
        return tr(
            "The control is running, but the stream makes no progress. Check feed override and "
            "feed hold at the control.");
      case StreamError::StopNotConfirmed:
        return tr("The control did not confirm the stop in time. Check the machine.");
      case StreamError::ControlAlarm:
        return tr("The control ended the program with an alarm. Clear its cause at the control.");
      case StreamError::EndedEarly:
        return tr("The program on the control ended before all of it was executed.");
      case StreamError::OtherClient:
        return tr(
            "Another client is using the program on the control. Rivulet writes nothing more: wait "
            "until the other client has finished, or reset the control.");
      case StreamError::Claimed:
        return tr(
            "Another client has claimed the R-parameters of this run and is about to start. "
            "Nothing "
            "was changed. Wait until its run has ended.");
      case StreamError::Restarted:
        return tr(
            "The program on the control was restarted during the run. Reset the control, then "
            "resume.");
      case StreamError::WindowDamaged:
        return tr(
            "The control rejected a window that did not match its check number, and did not "
            "execute it. Something else writes these R-parameters, or a value was changed on its "
            "way: look for another client, or connect encrypted, then resume.");
      case StreamError::ClientSilent:
        return tr(
            "The control ended its program because it received nothing from Rivulet for too long. "
            "Check the network, then resume.");
      case StreamError::Cancelled:
        return tr("The test was aborted. Reset the control if its program is still running.");
      case StreamError::ProgramNotStreamable:
      case StreamError::TransferRefused:
      case StreamError::OverlayLeft:
      case StreamError::OverlayIntegrates:
      case StreamError::NotCommissioned:
      case StreamError::CannotResume:
      case StreamError::AxesNotChosen:
      case StreamError::AxisMissing:
      case StreamError::ProgramChanged:
      case StreamError::FeedUnknown:
      case StreamError::OneFeedOnly:
      case StreamError::BadOverride:
      case StreamError::CutOnTheWay:
      case StreamError::FeedCellIgnored:
      case StreamError::BadAirMove:
      case StreamError::BadTestBlock:
        return refusal(code);
    }
    return {};
  }

  /// Why a run does not begin.
  static QString refusal(streaming::StreamError code) {
    using streaming::StreamError;
    switch (code) {
      case StreamError::ProgramNotStreamable:
        return tr("This program cannot be streamed. See the list of findings.");
      case StreamError::TransferRefused:
        return tr(
            "The control does not let Rivulet write and read part programs. Grant the OPC UA user "
            "these rights, or copy the template to the control by hand.");
      case StreamError::OverlayLeft:
        return tr(
            "An overlay is already active on the axes. Remove it at the control: press reset, "
            "wait, and check that $AA_OFF is 0.");
      case StreamError::OverlayIntegrates:
        return tr(
            "The control adds up overlaid values (MD36750 bit 0). Set the bit to 0, or do without "
            "online correction.");
      case StreamError::NotCommissioned:
        return tr(
            "Method credit is experimental and starts only on a control that has passed its test. "
            "Pass it on the page Credit test, or choose method window.");
      case StreamError::CannotResume:
        return tr("It is not known for certain where the run was left. Start from the beginning.");
      case StreamError::AxesNotChosen:
        return tr(
            "The program needs an axis that is not streamed. Move it to the position in the "
            "program, or stream it too.");
      case StreamError::AxisMissing:
        return tr(
            "The control lacks an axis that the program moves. Use a program for the axes of this "
            "machine.");
      case StreamError::ProgramChanged:
        return tr(
            "The program has been changed since the interrupted run. Restore it, or start from the "
            "beginning.");
      case StreamError::FeedUnknown:
        return tr(
            "A block of the program moves at a feed that is not known: F is missing, G95 has no "
            "spindle speed, or G93 no length. Choose one feed for all moves.");
      case StreamError::OneFeedOnly:
        return tr("This method has one feed for all moves, as it was published.");
      case StreamError::BadOverride:
        return tr("The override is out of range: choose 1 to 200 %.");
      case StreamError::CutOnTheWay:
        return tr(
            "The straight way to the first point passes within what the program cuts. Raise the "
            "tool first.");
      case StreamError::FeedCellIgnored:
        return tr(
            "The control does not obey the override: pause, stop and override would not act. "
            "Nothing was moved. Check that a SINUMERIK has synchronized actions, or a LinuxCNC the "
            "components of docs/linuxcnc.md.");
      case StreamError::BadAirMove:
        return tr(
            "The move of the test takes 2 to 30 s at its feed, so that it can be held on its way. "
            "Choose another length or feed.");
      case StreamError::BadTestBlock:
        return tr(
            "This block cannot be tried: the control of a job would not execute it itself, or it "
            "ends the program. Name blocks as a program has them, as in \"S500 M3\".");
      default:
        return {};
    }
  }
};

}  // namespace

QString errorCodeText(const std::error_code& code) {
  if (!code) {
    return {};
  }
  if (belongsTo<gcode::GcodeError>(code)) {
    return ErrorTexts::text(static_cast<gcode::GcodeError>(code.value()));
  }
  if (belongsTo<emulator::EmulatorError>(code)) {
    return ErrorTexts::text(static_cast<emulator::EmulatorError>(code.value()));
  }
  if (belongsTo<feasibility::FeasibilityError>(code)) {
    return ErrorTexts::text(static_cast<feasibility::FeasibilityError>(code.value()));
  }
  if (belongsTo<live::LiveError>(code)) {
    return ErrorTexts::text(static_cast<live::LiveError>(code.value()));
  }
  if (belongsTo<templates::TemplateError>(code)) {
    return ErrorTexts::text(static_cast<templates::TemplateError>(code.value()));
  }
  if (belongsTo<base::FileError>(code)) {
    return ErrorTexts::text(static_cast<base::FileError>(code.value()));
  }
  if (belongsTo<base::BudgetError>(code)) {
    return ErrorTexts::text(static_cast<base::BudgetError>(code.value()));
  }
  if (belongsTo<trace::TraceError>(code)) {
    return ErrorTexts::text(static_cast<trace::TraceError>(code.value()));
  }
  if (belongsTo<trace::FormulaError>(code)) {
    return ErrorTexts::text(static_cast<trace::FormulaError>(code.value()));
  }
  if (belongsTo<trace::ComparisonError>(code)) {
    return ErrorTexts::text(static_cast<trace::ComparisonError>(code.value()));
  }
  if (belongsTo<trace::SpectrumError>(code)) {
    return ErrorTexts::text(static_cast<trace::SpectrumError>(code.value()));
  }
  if (belongsTo<trace::ImportError>(code)) {
    return ErrorTexts::text(static_cast<trace::ImportError>(code.value()));
  }
  if (belongsTo<streaming::MachineFileError>(code)) {
    return ErrorTexts::text(static_cast<streaming::MachineFileError>(code.value()));
  }
  if (belongsTo<opcua::LinkError>(code)) {
    return ErrorTexts::text(static_cast<opcua::LinkError>(code.value()));
  }
  if (belongsTo<opcua::LinkKindError>(code)) {
    return ErrorTexts::text(static_cast<opcua::LinkKindError>(code.value()));
  }
  if (belongsTo<opcua::MapError>(code)) {
    return ErrorTexts::text(static_cast<opcua::MapError>(code.value()));
  }
  if (belongsTo<streaming::CalibrationError>(code)) {
    return ErrorTexts::text(static_cast<streaming::CalibrationError>(code.value()));
  }
  if (belongsTo<streaming::StreamError>(code)) {
    return ErrorTexts::text(static_cast<streaming::StreamError>(code.value()));
  }
  return {};
}

std::error_code errorCodeOf(std::string_view kind, int value) {
  const std::error_code known[]{
      gcode::GcodeError::FileUnreadable,    feasibility::FeasibilityError::FeedNotPositive,
      templates::TemplateError::DoesNotFit, base::FileError::Unreadable,
      trace::TraceError::NotATrace,         streaming::MachineFileError::NotAMachineFile,
      opcua::LinkError::NotReachable,       streaming::CalibrationError::NoCells,
      streaming::StreamError::WrongProgram, live::LiveError::NotALine,
      opcua::LinkKindError::NotAble,        opcua::MapError::WrongAddress,
  };
  for (const std::error_code& code : known) {
    if (kind == code.category().name()) {
      return {value, code.category()};
    }
  }
  return {};
}

QString errorText(const base::Error& error) {
  // The message of the error is English and may contain figures that the sentence of its code
  // lacks: in English, prefer the message.
  const QString message = QString::fromStdString(error.message);
  const QString known = errorCodeText(error.code);
  const bool isEnglish = QLocale().language() == QLocale::English;
  const QString sentence = known.isEmpty() || (isEnglish && !message.isEmpty()) ? message : known;
  if (error.context.empty()) {
    return sentence;
  }
  const QString place = belongsTo<live::LiveError>(error.code)
                            ? ErrorTexts::place(error.context)
                            : QString::fromStdString(error.context);
  return QStringLiteral("%1: %2").arg(place, sentence);
}

}  // namespace rivulet::widgets
