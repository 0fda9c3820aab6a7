// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Signals over time in one chart. Samples may arrive at any rate: the chart asks the envelopes for
/// the visible range and is redrawn at most 25 times a second, with one `replace` per line. Several
/// plots share a `TimeWindow` and so their time axis.
/// @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <memory>
#include <vector>

#include "trace/pause.h"
#include "widgets/common/page.h"
#include "widgets/plots/envelope_series.h"

class QChart;
class QChartView;
class QLineSeries;
class QValueAxis;

namespace rivulet::widgets {

class PauseBands;
class TimeWindow;

class TimePlot final : public Page {
  Q_OBJECT

 public:
  static constexpr int kRedrawIntervalMs = 40;

  /// @param window  shared by the plots of a page; outlives the plot
  explicit TimePlot(TimeWindow* window, QWidget* parent = nullptr);
  ~TimePlot() override;

  /// Title of the value axis, with its unit.
  void setTitle(const QString& title);
  /// Only the lowest of stacked plots shows the times.
  void setTimeLabels(bool visible, const QString& title);
  /// Least extent of the value axis, so that noise is not magnified.
  void setLeastSpan(double span) { m_leastSpan = span; }
  /// The value axis begins at 0 (a feed is never negative).
  void setFromZero(bool fromZero) { m_fromZero = fromZero; }
  void append(double atS, double value);
  /// Shows a whole recording at once.
  void setSeries(std::unique_ptr<EnvelopeSeries> series);
  void clear();
  void setPauses(const std::vector<trace::Pause>* pauses, bool labels);
  void scheduleRedraw();
  /// Draws pending changes at once: for pictures and tests.
  void redrawNow();

 Q_SIGNALS:
  void redrawn();

 protected:
  void retranslate() override;
  void restyle() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void layOut(QSizeF size);
  void redraw();
  [[nodiscard]] QLineSeries* lineSeries(std::size_t index);
  [[nodiscard]] double secondsAt(double x) const;

  TimeWindow* m_window;
  std::unique_ptr<EnvelopeSeries> m_series;
  QChart* m_chart;
  QChartView* m_view;
  QValueAxis* m_timeAxis;
  QValueAxis* m_valueAxis;
  std::vector<QLineSeries*> m_lines;  ///< one per section without a gap
  PauseBands* m_bands;
  QTimer m_redraw{this};
  double m_leastSpan = 1.0;
  bool m_fromZero = false;
  bool m_timeLabels = false;
  std::optional<double> m_dragX;
};

}  // namespace rivulet::widgets
