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

  StatusLabel* m_state;
  QLabel* m_nameLabel;
  QLineEdit* m_name;
  QLabel* m_presetLabel;
  QComboBox* m_preset;
  QPushButton* m_takeOver;
  QLabel* m_axesTitle;
  std::array<QLabel*, LimitCount> m_heads{};
  std::array<QLabel*, base::kAxisCount> m_linear{};
  std::array<QCheckBox*, base::kRotaryAxisCount> m_rotary{};
  std::array<std::array<NumberField*, LimitCount>, kAxes> m_limits{};
  QLabel* m_rapidLabel;
  NumberField* m_rapid;
  QLabel* m_spindleLabel;
  NumberField* m_spindle;
  QLabel* m_functionsLabel;
  QLineEdit* m_functions;
  job::Functions m_savedFunctions;
  QLabel* m_toolsTitle;
  QGridLayout* m_toolGrid;
  std::array<QLabel*, 4> m_toolHeads{};
  std::vector<ToolRow> m_tools;
  QPushButton* m_addTool;
  QPushButton* m_save;
  QPushButton* m_discard;
  StatusLabel* m_problem;
};

}  // namespace rivulet::widgets
