// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Asks what a program leaves open and controls answer differently: for which control it was made,
/// whether it is in mm or inch, what a coordinate without a decimal point is, and which settings it
/// needs. Each answer says what would follow from it. Hidden while there is nothing to ask.
/// @threadsafety GUI thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gcode/program.h"
#include "widgets/common/page.h"

class QHBoxLayout;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rivulet::widgets {

/// As its maker writes it.
[[nodiscard]] QString controlName(gcode::Dialect dialect);

class ReadingBar final : public Page {
  Q_OBJECT

 public:
  explicit ReadingBar(QWidget* parent = nullptr);

  /// @param program  null: none
  void setProgram(std::shared_ptr<const gcode::Program> program);
  /// A run keeps its program as it was read.
  void setAnswerable(bool answerable);

 Q_SIGNALS:
  void dialectChosen(rivulet::gcode::Dialect dialect);
  void unitsChosen(rivulet::gcode::FileUnits units);
  void noPointChosen(rivulet::gcode::NoPoint meaning);
  void settingsChosen(const rivulet::gcode::ControlSettings& settings);

 protected:
  void retranslate() override;
  void restyle() override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// The next question that is open; empty: none.
  [[nodiscard]] QString question() const;
  void makeAnswers();
  void addAnswer(const QString& text, std::function<void()> choose);
  void addValue(gcode::ControlSetting setting, double value);
  void takeValues();

  std::shared_ptr<const gcode::Program> m_program;
  bool m_isAnswerable = true;
  QLabel* m_icon = label({});
  QLabel* m_text = value({.wraps = true});
  QHBoxLayout* m_row;
  std::vector<QPushButton*> m_answers;
  struct Value {
    gcode::ControlSetting setting;
    QLabel* name;
    QLineEdit* field;
  };
  QGridLayout* m_values;
  std::vector<Value> m_fields;  ///< of the settings that are open
};

}  // namespace rivulet::widgets
