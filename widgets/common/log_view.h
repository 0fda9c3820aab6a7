// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What happened in this session, newest last: time, severity, text. Keeps the last 5000 lines.
/// @threadsafety GUI thread.
#pragma once

#include <QDateTime>
#include <QPalette>

#include "gcode/diagnostic.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QPushButton;
class QTableView;

namespace rivulet::widgets {

struct LogLine {
  QDateTime at;
  gcode::Severity severity = gcode::Severity::Note;
  QString text;
};

class LogModel final : public TableModel<LogLine> {
  Q_OBJECT

 public:
  enum Column { Time, SeverityColumn, Text };
  static constexpr std::size_t kCapacity = 5000;

  explicit LogModel(QObject* parent = nullptr);

  /// Icons are drawn in the colours of this palette.
  void setColors(const QPalette& palette);
  /// Every line as text, tab separated.
  [[nodiscard]] QString toText() const;

 private:
  QPalette m_palette;
};

class LogView final : public Page {
  Q_OBJECT

 public:
  explicit LogView(QWidget* parent = nullptr);

  void append(const LogLine& line);
  void clear();
  [[nodiscard]] QString toText() const { return m_model->toText(); }

 Q_SIGNALS:
  void saveRequested(const QString& path);

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  LogModel* m_model;
  QTableView* m_table;
  QPushButton* m_copy;
  QPushButton* m_save;
  QPushButton* m_clear;
};

}  // namespace rivulet::widgets
