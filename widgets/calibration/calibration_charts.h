// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The two pictures of a calibration: averages and fitted lines over the number of cells, and the
/// distribution of the shots of one kind. @threadsafety GUI thread.
#pragma once

#include <QChartView>
#include <memory>
#include <vector>

#include "streaming/setup/calibration.h"
#include "widgets/plots/legend_strip.h"

class QValueAxis;

namespace rivulet::widgets {

/// Common to both: two axes with round numbers, margins that hold their labels.
class CalibrationChart : public QChartView {
  Q_OBJECT

 public:
  /// Sets titles and numbers in the present language.
  virtual void retranslate() = 0;
  /// @param palette  of the page, which gets a new theme before its children
  void restyle(const QPalette& palette);
  [[nodiscard]] virtual std::vector<LegendEntry> legend() const = 0;

 protected:
  explicit CalibrationChart(QWidget* parent);
  void resizeEvent(QResizeEvent* event) override;
  /// Redraws everything.
  virtual void redraw() = 0;
  /// Removes the drawing.
  void clear();
  void add(QAbstractSeries* series);
  void setRange(double xMin, double xMax, double yMax);
  void setTitles(const QString& x, const QString& y);
  [[nodiscard]] const QPalette& colours() const { return m_palette; }

 private:
  QValueAxis* m_x;
  QValueAxis* m_y;
  QPalette m_palette;
};

class LinesChart final : public CalibrationChart {
  Q_OBJECT

 public:
  explicit LinesChart(QWidget* parent = nullptr);
  /// Null: nothing to show.
  void setCalibration(const streaming::Calibration* calibration);
  void retranslate() override;
  [[nodiscard]] std::vector<LegendEntry> legend() const override;

 protected:
  void redraw() override;

 private:
  std::vector<streaming::AccessSeries> m_series;
  std::vector<streaming::AccessFit> m_fits;
};

class HistogramChart final : public CalibrationChart {
  Q_OBJECT

 public:
  explicit HistogramChart(QWidget* parent = nullptr);
  /// Nothing: an empty picture.
  void setSeries(const std::optional<streaming::AccessSeries>& series);
  [[nodiscard]] const std::optional<streaming::AccessSeries>& series() const { return m_series; }
  void retranslate() override;
  [[nodiscard]] std::vector<LegendEntry> legend() const override;

 protected:
  void redraw() override;

 private:
  std::optional<streaming::AccessSeries> m_series;
};

}  // namespace rivulet::widgets
