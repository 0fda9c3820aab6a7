// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The name of a file: typed, or chosen with a button. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <QWidget>

class QLineEdit;
class QPushButton;

namespace rivulet::widgets {

class FileField final : public QWidget {
  Q_OBJECT

 public:
  /// @param name  of the field as an object; the button is called name-choose
  explicit FileField(const QString& name, QWidget* parent = nullptr);

  /// @param what     title of the dialog, and what stands in the empty field
  /// @param toolTip  of the field
  /// @param filter   of the dialog, e.g. "Maps (*.toml)"; empty: all files
  void setTexts(const QString& what, const QString& toolTip, const QString& filter);
  void setFile(const QString& file);
  [[nodiscard]] QString file() const;
  /// Shows the dialog. What was typed stays if nothing is chosen.
  void choose();

 Q_SIGNALS:
  /// Return was pressed.
  void submitted();

 private:
  QString m_what;
  QString m_filter;
  QLineEdit* m_edit;
  QPushButton* m_choose;
};

}  // namespace rivulet::widgets
