// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Messages: what happened in this session, newest last, with date, severity, source and text; to
/// be filtered and searched. Keeps the last 5000 lines. Nothing is ever removed by hand: the file
/// of the log has the same lines. @threadsafety GUI thread.
#pragma once

#include <QDateTime>
#include <QPalette>
#include <QTimer>
#include <functional>

#include "alarm/alarm.h"
#include "gcode/diagnostic.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

struct LogLine {
  QDateTime at;
  gcode::Severity severity = gcode::Severity::Note;
  alarm::Source source = alarm::Source::Computer;
  std::function<QString()> text;  ///< in the present language
};

class LogModel final : public TableModel<LogLine> {
  Q_OBJECT

 public:
  enum Column { Time, SeverityColumn, SourceColumn, Text };
  static constexpr std::size_t kCapacity = 5000;

  explicit LogModel(QObject* parent = nullptr);

  /// Icons are drawn in the colours of this palette.
  void setColors(const QPalette& palette);

 private:
  QPalette m_palette;
};

class LogFilter;

class LogView final : public Page {
  Q_OBJECT

 public:
  explicit LogView(QWidget* parent = nullptr);

  void append(const LogLine& line);
  /// The lines that are shown, tab separated.
  [[nodiscard]] QString toText() const;

 Q_SIGNALS:
  void saveRequested(const QString& path);

 protected:
  void retranslate() override;

 private:
  [[nodiscard]] QWidget* makeFilters();
  void connectFilters();
  void showCount();
  void wrapRows();

  LogModel* m_model;
  LogFilter* m_filter;
  QTableView* m_table;
  QComboBox* m_severity = list({.name = QT_TR_NOOP("Severity")});
  QComboBox* m_source = list({.name = QT_TR_NOOP("Source")});
  QLineEdit* m_search =
      lineEdit({.name = QT_TR_NOOP("Search"), .placeholder = QT_TR_NOOP("Search")});
  QCheckBox* m_wrap = checkBox({.text = QT_TR_NOOP("Wrap lines")});
  QLabel* m_count = label({});
  QPushButton* m_copy = button({.text = QT_TR_NOOP("Copy"), .icon = "copy"});
  QPushButton* m_save = button({.text = QT_TR_NOOP("Save…"), .icon = "save"});
  QTimer m_wrapTimer;  ///< the height of rows follows the width of the table after a rest
};

}  // namespace rivulet::widgets
