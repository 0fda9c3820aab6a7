// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A calibration as tables: every kind of request, and the fitted lines. Times in ms.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "streaming/calibration.h"

namespace rivulet::widgets {

class SeriesModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Form, Access, Cells, Shots, Mean, P50, P90, P95, P99, P999, Max, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  /// @param shots  ordered of each kind: fewer stand out
  void setSeries(std::vector<streaming::AccessSeries> series, int shots);
  void retranslate();
  [[nodiscard]] const streaming::AccessSeries& series(int row) const {
    return m_series[static_cast<std::size_t>(row)];
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::vector<streaming::AccessSeries> m_series;
  int m_shots = 0;
};

class FitModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Form, Access, Overhead, PerCell, Deviation, Apart, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setFits(std::vector<streaming::AccessFit> fits);
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::vector<streaming::AccessFit> m_fits;
};

}  // namespace rivulet::widgets
