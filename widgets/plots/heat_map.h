// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A small matrix of positive numbers in colours, each with its number: the darker on a light
/// ground (the lighter on a dark one), the larger. Rows have names; columns have the numbers of the
/// rows.
/// @threadsafety GUI thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

namespace rivulet::widgets {

class HeatMap final : public QWidget {
  Q_OBJECT

 public:
  explicit HeatMap(QWidget* parent = nullptr);

  /// @param name  of the map, also for a screen reader
  void setTitles(const QString& name, const QString& rows, const QString& columns);
  /// @param values  [row][column], as many of both as names; NaN: not known
  void setCells(const QStringList& names, std::vector<std::vector<double>> values);
  [[nodiscard]] const std::vector<std::vector<double>>& values() const { return m_values; }
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QColor colorOf(double value) const;
  void drawCell(QPainter& painter, const QRectF& cell, double value) const;

  QString m_rowTitle;
  QString m_columnTitle;
  QStringList m_names;
  std::vector<std::vector<double>> m_values;
  double m_least = 0.0;
  double m_greatest = 0.0;
};

}  // namespace rivulet::widgets
