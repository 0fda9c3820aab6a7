// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A calibration as tables: every kind of request, and the fitted lines. Times in ms.
/// @threadsafety GUI thread.
#pragma once

#include <vector>

#include "streaming/setup/calibration.h"
#include "widgets/common/table_model.h"

namespace rivulet::widgets {

class SeriesModel final : public TableModel<streaming::AccessSeries> {
  Q_OBJECT

 public:
  enum Column { Form, Access, Cells, Shots, Mean, P50, P90, P95, P99, P999, Max };

  explicit SeriesModel(QObject* parent = nullptr);

  /// @param shots  requested of each kind; series with fewer are shown in bold
  void setSeries(const std::vector<streaming::AccessSeries>& series, int shots);

 private:
  int m_shots = 0;
};

class FitModel final : public TableModel<streaming::AccessFit> {
  Q_OBJECT

 public:
  enum Column { Form, Access, Overhead, PerCell, Deviation, Apart };

  explicit FitModel(QObject* parent = nullptr);
};

}  // namespace rivulet::widgets
