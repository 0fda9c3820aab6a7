// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Measuring the cost of access to the control: cells, expected time, progress, and the result,
/// present or earlier. @threadsafety GUI thread.
#pragma once

#include <memory>
#include <optional>

#include "streaming/setup/calibration_record.h"
#include "widgets/calibration/access_source.h"
#include "widgets/common/page.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QTabWidget;

namespace rivulet::widgets {

class FitModel;
class HistogramChart;
class LegendStrip;
class LinesChart;
class SeriesModel;
class WholeNumberField;

class CalibrationPage final : public Page {
  Q_OBJECT

 public:
  explicit CalibrationPage(QWidget* parent = nullptr);

  /// @param reason  why no calibration is possible now; empty: it is
  void setBlocked(const QString& reason);
  /// The measurement on this machine, present or earlier; null: none.
  void setRecord(std::shared_ptr<const streaming::CalibrationRecord> record, bool outdated);
  /// @param progress  of the calibration in progress; none: there is none
  void setProgress(const std::optional<streaming::CalibrationProgress>& progress);
  /// The operator's settings. The cells are confirmed only with the signal.
  [[nodiscard]] streaming::CalibrationPlan plan() const;
  void setPlan(const streaming::CalibrationPlan& plan);
  /// Shows the distribution of a kind instead of the lines. @param row  of the table
  void showSpread(int row);

 Q_SIGNALS:
  /// The cells were named and confirmed.
  void calibrationRequested(const rivulet::streaming::CalibrationPlan& plan);
  void cancelRequested();

 protected:
  void retranslate() override;

 private:
  void buildTabs();
  void connectFields();
  void cellsChanged();
  void showSelected();
  void refresh();
  void showState();
  void showLegends();

  QString m_blocked;
  std::shared_ptr<const streaming::CalibrationRecord> m_record;
  bool m_outdated = false;
  std::optional<streaming::CalibrationProgress> m_progressShown;

  QLabel* m_cellsName = label({.text = QT_TR_NOOP("R-parameters")});
  WholeNumberField* m_firstCell;
  WholeNumberField* m_lastCell;
  WholeNumberField* m_shots;
  WholeNumberField* m_budget;
  QCheckBox* m_arrays = checkBox(
      {.text = QT_TR_NOOP("Arrays too: for the test, they hold other values for a moment")});
  QCheckBox* m_confirm = checkBox({});
  QPushButton* m_start = button({.text = QT_TR_NOOP("Calibrate")});
  QProgressBar* m_progress;
  QPushButton* m_cancel = button({.text = QT_TR_NOOP("Cancel")}, &CalibrationPage::cancelRequested);
  StatusLabel* m_hint = status({.wraps = true});
  StatusLabel* m_state = status({.wraps = true});
  QTabWidget* m_tabs;
  LinesChart* m_lines;
  LegendStrip* m_linesLegend;
  QTableView* m_fitTable;
  FitModel* m_fits;
  QTableView* m_seriesTable;
  SeriesModel* m_series;
  HistogramChart* m_histogram;
  LegendStrip* m_histogramLegend;
};

}  // namespace rivulet::widgets
