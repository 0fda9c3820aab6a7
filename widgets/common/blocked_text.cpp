// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/blocked_text.h"

#include <QCoreApplication>

#include "widgets/common/error_text.h"

namespace rivulet::widgets {

namespace {

struct BlockedTexts {
  Q_DECLARE_TR_FUNCTIONS(BlockedTexts)

 public:
  static QString text(const streaming::Blocked& blocked) {
    using streaming::BlockReason;
    switch (blocked.reason) {
      case BlockReason::RunInProgress:
        return tr("A run is in progress.");
      case BlockReason::ResumeCheckInProgress:
        return tr("Asking the control where the run was left.");
      case BlockReason::CalibrationInProgress:
        return tr("A calibration is in progress.");
      case BlockReason::CommissioningInProgress:
        return tr("A test of the control is in progress.");
      case BlockReason::NotConnected:
        return tr("Connect to a control first.");
      case BlockReason::NoProgram:
        return tr("Open a program first.");
      case BlockReason::FileChanged:
        return tr("The file of the program has changed: reload it.");
      case BlockReason::NoMotion:
        return tr("The program moves no axis.");
      case BlockReason::NeedsTransformation:
        return tr("The program needs a transformation of the control. No method can stream it.");
      case BlockReason::PathUnknown:
        return tr("Parts of the program's path are not known: see the findings.");
      case BlockReason::RotaryNotStreamed:
        return tr("The program moves rotary axes: choose method window.");
      case BlockReason::AxesMissing:
        return tr("The program moves %1, but the control does not have all of these axes.")
            .arg(QString::fromStdString(blocked.arguments.at(0)));
      case BlockReason::SettingsInvalid:
        return blocked.cause ? errorText(*blocked.cause) : QString();
      case BlockReason::Infeasible:
        return tr("Not feasible: the control would repeat points. Change F, N or δ.");
      case BlockReason::NotRehearsed:
        return tr("The program is being simulated.");
      case BlockReason::RehearsalFailed:
        return tr("The simulation of this program failed in %1 of %2 runs. Change F, N or δ.")
            .arg(QString::fromStdString(blocked.arguments.at(0)),
                 QString::fromStdString(blocked.arguments.at(1)));
      case BlockReason::MayRepeat:
        return tr("Method %1 may execute old points again: if this computer is late for a moment, "
                  "the tool goes back through the workpiece. Choose method window.")
            .arg(QString::fromStdString(blocked.arguments.at(0)));
      case BlockReason::NotCommissioned:
        return tr(
            "Method credit starts only on a control that has passed its test: choose method "
            "window.");
      case BlockReason::AlarmActive:
        return tr("The control reports an alarm.");
      case BlockReason::ChannelBusy:
        return tr("A program is running on the control.");
      case BlockReason::NothingToResume:
        return tr("There is no interrupted run of method window.");
      case BlockReason::Locked:
        return tr("The window is locked: log in.");
      case BlockReason::NeedsEngineer:
        return tr("Only an engineer may do this.");
      case BlockReason::NotReleased:
        return tr("Not released: an engineer has to release this program with these settings.");
      case BlockReason::JobNotChecked:
        return tr("The job is being compared with the machine.");
      case BlockReason::SettingOpen:
      case BlockReason::BeyondMachine:
      case BlockReason::SourceNotOpen:
        return blocked.cause ? errorText(*blocked.cause) : QString();
      case BlockReason::LiveNeedsWindows:
        return tr(
            "Live points need a machine that waits for them: choose method window or credit.");
      case BlockReason::MethodCannotResume:
        return tr("Only method window can resume an interrupted run.");
    }
    return {};
  }
};

}  // namespace

QString blockedText(const std::optional<streaming::Blocked>& blocked) {
  return blocked ? BlockedTexts::text(*blocked) : QString();
}

}  // namespace rivulet::widgets
