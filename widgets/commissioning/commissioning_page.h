// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The test that a control must pass before method credit may run on it: what it does, what to do
/// at the control, how far it is, and its result. No axis moves. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <vector>

#include "streaming/control/machine_facts.h"
#include "widgets/common/page.h"

class QCheckBox;
class QVBoxLayout;
class QLabel;
class QPlainTextEdit;

namespace rivulet::widgets {

class StatusLabel;
class WholeNumberField;

class CommissioningPage final : public Page {
  Q_OBJECT

 public:
  explicit CommissioningPage(QWidget* parent = nullptr);

  /// The last test of the connected machine. @param test  nothing: none
  /// @param isOutdated  it was made with another version of the server
  void setTest(const std::optional<streaming::CreditTest>& test, bool isOutdated);
  /// @param step  nothing: no test is in progress
  void setProgress(std::optional<streaming::CommissioningStep> step);
  /// Why the last test could not be made; empty: it could.
  void setProblem(const QString& reason);
  /// @param why  the test cannot be started now; empty: it can
  void setBlocked(const QString& why);

 Q_SIGNALS:
  void testRequested(int firstCell, bool isByHand);
  void cancelRequested();

 protected:
  void retranslate() override;

 private:
  void showSteps();
  void showResult();
  void showButtons();
  /// What has to be seen, as a sentence; of a check that is not known here, what the test said.
  [[nodiscard]] static QString checkText(const streaming::CommissioningCheck& check);

  StatusLabel* m_verdict = status({.wraps = true});
  WholeNumberField* m_cell;
  QCheckBox* m_confirmed = checkBox({});
  QCheckBox* m_byHand = checkBox({.text = QT_TR_NOOP("I bring the program to the control myself")});
  std::array<StatusLabel*, 4> m_steps{};
  QPlainTextEdit* m_program;
  QPushButton* m_start = button({.text = QT_TR_NOOP("Start the test"), .icon = "play"});
  QPushButton* m_cancel =
      button({.text = QT_TR_NOOP("Cancel")}, &CommissioningPage::cancelRequested);
  StatusLabel* m_blockedLabel;
  QVBoxLayout* m_checks;
  QLabel* m_machine = value({.isMuted = true, .wraps = true});

  std::optional<streaming::CreditTest> m_test;
  bool m_isOutdated = false;
  std::optional<streaming::CommissioningStep> m_step;
  QString m_problem;
  QString m_blocked;
};

}  // namespace rivulet::widgets
