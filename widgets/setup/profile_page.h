// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The limits of the connected machine, typed by an engineer. @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <array>
#include <vector>

#include "job/functions.h"
#include "streaming/control/machine_profile.h"
#include "widgets/common/page.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class WholeNumberField;

/// What is wrong with typed limits, as a sentence.
[[nodiscard]] QString profileProblemText(const streaming::ProfileProblem& problem);

class ProfilePage final : public Page {
  Q_OBJECT

 public:
  explicit ProfilePage(QWidget* parent = nullptr);

  /// Limits to begin with, and those of which machines.
  void setPresets(const QStringList& names);
  /// @param isEntered  somebody has entered them; else they are assumed
  void setProfile(const streaming::MachineProfile& profile, bool isEntered);
  /// Fills the fields with other limits; nothing is saved.
  void takeOver(const streaming::MachineProfile& profile);
  /// What the machine does for M functions of other machines.
  void setFunctions(const job::Functions& functions);
  /// @param why  they cannot be saved; empty: they can
  void setBlocked(const QString& why);

 Q_SIGNALS:
  /// Without endpoint, server, time and user.
  void saveRequested(const rivulet::streaming::MachineProfile& profile);
  void functionsSaveRequested(const rivulet::job::Functions& functions);
  void presetRequested(const QString& name);

 protected:
  void retranslate() override;

 private:
  enum Limit { From, To, Speed, Acceleration, Jerk, LimitCount };
  static constexpr std::size_t kAxes = base::kAxisCount + base::kRotaryAxisCount;
  struct ToolRow {
    WholeNumberField* number = nullptr;
    QLineEdit* name = nullptr;
    NumberField* length = nullptr;
    NumberField* radius = nullptr;
    QPushButton* remove = nullptr;
  };

  void buildAxes(QGridLayout* grid);
  void addTool(const streaming::ToolProfile& tool);
  void removeTool(const QPushButton* button);
  void nameTools();
  /// Tab goes from above to below; tools come and go.
  void orderFocus();
  [[nodiscard]] streaming::AxisProfile axis(std::size_t index) const;
  void showAxis(std::size_t index, const streaming::AxisProfile& axis);
  [[nodiscard]] streaming::MachineProfile typed() const;
  [[nodiscard]] base::Result<job::Functions> typedFunctions() const;
  void edited();
  void showState();

  streaming::MachineProfile m_profile;
  streaming::MachineProfile m_asSaved;  ///< as the fields showed it, with their decimals
  bool m_isEntered = false;
  bool m_isFilling = false;
  QString m_blocked;

  StatusLabel* m_state = status({.wraps = true});
  QLineEdit* m_name = lineEdit({.name = QT_TR_NOOP("Name of the machine"), .isTouch = true});
  QComboBox* m_preset = list({.name = QT_TR_NOOP("Simulated as"), .isTouch = true});
  QPushButton* m_takeOver = button({.text = QT_TR_NOOP("Take over its limits")});
  std::array<QLabel*, LimitCount> m_heads{};
  std::array<QLabel*, base::kAxisCount> m_linear{};
  std::array<QCheckBox*, base::kRotaryAxisCount> m_rotary{};
  std::array<std::array<NumberField*, LimitCount>, kAxes> m_limits{};
  NumberField* m_rapid;
  NumberField* m_spindle;
  NumberField* m_silence;
  NumberField* m_stop;
  QLineEdit* m_functions = lineEdit(
      {.tip = QT_TR_NOOP(
           "What this machine does for the M functions of programs made for another: ignore leaves "
           "the function out, pass gives it to the control, anything else is a line for it."),
       .name = QT_TR_NOOP("M functions of other machines"),
       .isTouch = true});
  job::Functions m_savedFunctions;
  QGridLayout* m_toolGrid;
  std::vector<QLabel*> m_toolHeads;
  std::vector<ToolRow> m_tools;
  QPushButton* m_addTool = button({.text = QT_TR_NOOP("Add a tool")});
  QPushButton* m_save = button({.text = QT_TR_NOOP("Save the limits")});
  QPushButton* m_discard = button({.text = QT_TR_NOOP("Discard changes")});
  StatusLabel* m_problem = status({.wraps = true});
};

}  // namespace rivulet::widgets
