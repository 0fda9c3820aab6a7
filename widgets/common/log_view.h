// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What happened in this session, newest last: time, severity, text. Keeps the last 5000 lines.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <deque>

#include "gcode/diagnostic.h"
#include "widgets/common/page.h"

class QPushButton;
class QTableView;

namespace rivulet::widgets {

struct LogLine {
  QDateTime at;
  gcode::Severity severity = gcode::Severity::Note;
  QString text;
};

class LogModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Time, SeverityColumn, Text, ColumnCount };
  static constexpr std::size_t kCapacity = 5000;

  explicit LogModel(QObject* parent = nullptr);

  void append(const LogLine& line);
  void clear();
  void setColors(const QPalette& palette);
  void retranslate();
  /// Every line as text, tab separated.
  [[nodiscard]] QString toText() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::deque<LogLine> m_lines;
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
