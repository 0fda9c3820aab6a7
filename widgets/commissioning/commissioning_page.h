// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A test of the control: what it is for, what to do at the control, how far it is, and its result.
/// An axis moves only if the operator types so. @threadsafety GUI thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "widgets/commissioning/control_test_texts.h"
#include "widgets/common/page.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QVBoxLayout;
class QLabel;
class QPlainTextEdit;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class WholeNumberField;

/// What is typed before an axis may move.
inline constexpr const char* kMoveWord = "MOVE";

class CommissioningPage final : public Page {
  Q_OBJECT

 public:
  /// @param texts  of the test
  explicit CommissioningPage(std::unique_ptr<ControlTestTexts> texts, QWidget* parent = nullptr);

  /// The last test of the connected machine. @param test  nothing: none
  /// @param isOutdated  it was made with another version of the server
  void setTest(const std::optional<ShownTest>& test, bool isOutdated);
  /// @param step  nothing: no test is in progress
  void setProgress(std::optional<streaming::CommissioningStep> step);
  /// Why the last test could not be made; empty: it could.
  void setProblem(const QString& reason);
  /// @param why  the test cannot be started now; empty: it can
  void setBlocked(const QString& why);

 Q_SIGNALS:
  /// @param move  that the operator agrees to; nothing: no axis moves  @param blocks  to be tried
  void testRequested(int firstCell, bool isByHand,
                     const std::optional<rivulet::streaming::AirMove>& move,
                     const std::vector<std::string>& blocks);
  /// The operator has seen this block of the shown test being executed.
  void blockConfirmed(std::size_t index);
  void cancelRequested();

 protected:
  void retranslate() override;

 private:
  void showSteps();
  void showResult();
  void showButtons();
  [[nodiscard]] QWidget* moveRow();
  /// As it is typed, whether it may be made or not; nothing: no axis is to move.
  [[nodiscard]] std::optional<streaming::AirMove> typedMove() const;
  [[nodiscard]] std::vector<std::string> typedBlocks() const;
  void showTried();
  /// Why the test cannot be made with it; empty: it can.
  [[nodiscard]] QString moveProblem() const;
  void forgetConfirmations();

  std::unique_ptr<ControlTestTexts> m_texts;
  StatusLabel* m_verdict = status({.wraps = true});
  QLabel* m_what = value({.wraps = true});
  WholeNumberField* m_cell;
  QCheckBox* m_confirmed = checkBox({});
  QCheckBox* m_byHand = checkBox({.text = QT_TR_NOOP("I bring the program to the control myself")});
  QCheckBox* m_moves = checkBox({.text = QT_TR_NOOP("An axis moves in the air")});
  QComboBox* m_axis = list({.name = QT_TR_NOOP("Axis that moves")});
  NumberField* m_lengthMm;
  NumberField* m_feed;
  NumberField* m_liftMm;
  QLineEdit* m_word = lineEdit({.name = QT_TR_NOOP("Confirm that the axis may move")});
  std::array<StatusLabel*, 4> m_steps{};
  QPlainTextEdit* m_program;
  QPlainTextEdit* m_blocks;
  QPushButton* m_start = button({.text = QT_TR_NOOP("Start the test"), .icon = "play"});
  QPushButton* m_cancel =
      button({.text = QT_TR_NOOP("Cancel")}, &CommissioningPage::cancelRequested);
  StatusLabel* m_blockedLabel;
  QVBoxLayout* m_checks;
  std::vector<QPushButton*> m_seen;  ///< of the blocks that the operator may confirm
  QLabel* m_machine = value({.isMuted = true, .wraps = true});

  std::optional<ShownTest> m_test;
  bool m_isOutdated = false;
  std::optional<streaming::CommissioningStep> m_step;
  QString m_problem;
  QString m_blocked;
};

}  // namespace rivulet::widgets
