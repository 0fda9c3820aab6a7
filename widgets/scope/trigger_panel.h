// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The trigger of the live view: what it waits for, how much is shown before and after it. When it
/// fires, the panes stop following and show the stretch around it, with cursor A at the trigger.
/// The rules are those of `trace::Trigger`. @threadsafety GUI thread.
#pragma once

#include <array>
#include <optional>

#include "trace/trigger.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class TimeWindow;

class TriggerPanel final : public Page {
  Q_OBJECT

 public:
  TriggerPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
               QWidget* parent = nullptr);

  /// A run begins: times start again. An armed trigger waits for it.
  void restart();
  /// A live value of a signal. @param atS  from the beginning of the run
  void sample(const QString& formula, double atS, double value);
  /// Something happened. @param atS  when  @param nowS  until when samples are there
  void happened(trace::TriggerEvent event, double atS, double nowS);
  /// No more samples will come.
  void finish();
  [[nodiscard]] bool isArmed() const { return m_trigger.has_value(); }

 private:
  enum Row { Signal, Condition, Level, Low, High, Hysteresis, Before, After, Mode, kRows };

  void arm(bool wanted);
  void listSignals();
  void showFields();
  void showState();
  void takeShot(const std::optional<trace::TriggerShot>& shot);
  [[nodiscard]] trace::TriggerSettings settings() const;
  [[nodiscard]] QString formula() const;

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  std::array<QLabel*, kRows> m_names{};
  QComboBox* m_signal =
      list({.tip = QT_TR_NOOP("The signal that is watched during a run"), .id = "triggerSignal"});
  QComboBox* m_condition = list(
      {.tip = QT_TR_NOOP("What the trigger waits for"),
       .items = {QT_TR_NOOP("it rises through the level"), QT_TR_NOOP("it falls through the level"),
                 QT_TR_NOOP("it is at the level or above"),
                 QT_TR_NOOP("it is at the level or below"), QT_TR_NOOP("it is within the range"),
                 QT_TR_NOOP("it is outside the range"), QT_TR_NOOP("a pause begins"),
                 QT_TR_NOOP("an alarm comes")},
       .id = "triggerCondition"});
  NumberField* m_level;
  NumberField* m_low;
  NumberField* m_high;
  NumberField* m_hysteresis;
  NumberField* m_before;
  NumberField* m_after;
  QComboBox* m_mode = list(
      {.tip = QT_TR_NOOP("Once: what was caught stays. Every time: the next one takes its place."),
       .items = {QT_TR_NOOP("once (single)"), QT_TR_NOOP("every time (normal)")},
       .id = "triggerMode"});
  QPushButton* m_arm = button({.tip = QT_TR_NOOP("An armed trigger stops the live view when it "
                                                 "fires and shows what was before and after"),
                               .id = "triggerArm"});
  StatusLabel* m_state = status({.id = "triggerState", .wraps = true});
  std::optional<trace::Trigger> m_trigger;  ///< nothing: not armed
  QString m_formula;                        ///< that it was armed for
  std::optional<double> m_firedAtS;         ///< the last shot that is shown
};

}  // namespace rivulet::widgets
