// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where live points come from, and what is agreed with their source. What cannot be kept is said
/// in the dialog, and nothing is opened. @threadsafety GUI thread.
#pragma once

#include <QDialog>
#include <array>
#include <optional>

#include "live/setup.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGroupBox;
class QLineEdit;

namespace rivulet::widgets {

class NumberField;
class StatusLabel;
class WholeNumberField;

class LiveDialog final : public QDialog {
  Q_OBJECT

 public:
  /// @param setup  what is shown at first
  /// @param offersInput  points may come from the standard input of this program
  /// @param toolMm       where the tool stands, workpiece frame; nothing: not known
  LiveDialog(const live::Setup& setup, bool offersInput, const std::optional<base::Vec3>& toolMm,
             QWidget* parent);

  [[nodiscard]] live::Setup setup() const;

 Q_SIGNALS:
  /// It can be kept.
  void openRequested(const rivulet::live::Setup& setup);

 private:
  enum Kind { Tcp, Udp, Unix, Server, Input };
  /// Beside the box.
  enum Value { Step, Turn, Feed, First, Merge, Full, HoldAfter, EndAfter, ValueCount };

  [[nodiscard]] QGroupBox* makeSource(bool offersInput);
  [[nodiscard]] QGroupBox* makeBox();
  [[nodiscard]] QGroupBox* makeAgreed();
  [[nodiscard]] QGroupBox* makeSilence();
  NumberField* addField(QFormLayout* form, Value value, const char* name, const QString& label,
                        const QString& unit, const QString& hint);
  void showSetup(const live::Setup& setup);
  void showKind();
  void showBox(const live::Agreement& agreed);
  /// Whether the tool can go into the box.
  void showTool();
  void chooseFile();
  void tryOpen();

  QComboBox* m_kind;
  QFormLayout* m_sourceForm = nullptr;
  WholeNumberField* m_port;
  QLineEdit* m_path;
  QWidget* m_fileRow;
  QLineEdit* m_file;  ///< names the variables of another server
  std::array<NumberField*, base::kAxisCount> m_lowest{};
  std::array<NumberField*, base::kAxisCount> m_highest{};
  std::array<QCheckBox*, base::kRotaryAxisCount> m_rotary{};
  std::array<NumberField*, ValueCount> m_values{};
  StatusLabel* m_answer;
  std::optional<base::Vec3> m_toolMm;
  StatusLabel* m_tool;
};

}  // namespace rivulet::widgets
