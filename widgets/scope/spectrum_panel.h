// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which frequencies a curve has between the cursors, or in the time that is seen, and a table of
/// the peaks. @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <vector>

#include "trace/spectrum.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QChartView;
class QComboBox;
class QLabel;
class QLineSeries;
class QScatterSeries;
class QTableWidget;
class QValueAxis;

namespace rivulet::widgets {

class ScopeView;
class TimeWindow;

class SpectrumPanel final : public Page {
  Q_OBJECT

 public:
  SpectrumPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, ScopeView* view,
                QWidget* parent = nullptr);

  /// Calculates a pending spectrum at once: for pictures and tests.
  void refreshNow();
  [[nodiscard]] const trace::Spectrum& spectrum() const { return m_spectrum; }

 protected:
  void retranslate() override;
  void restyle() override;
  void showEvent(QShowEvent* event) override;

 private:
  void schedule();
  void listSignals();
  void refresh();
  void showSpectrum(const base::Result<trace::Spectrum>& spectrum);
  void showNote();
  void draw();
  [[nodiscard]] bool isBetweenCursors() const;
  /// Small lengths are shown in micrometres.
  [[nodiscard]] double scale() const;
  [[nodiscard]] QString amplitudeTitle() const;
  [[nodiscard]] double shownHz() const;

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  ScopeView* m_view;
  QComboBox* m_signal = list({.name = QT_TR_NOOP("Curve whose frequencies are shown"),
                              .id = "spectrumSignal",
                              .isTouch = true});
  QLabel* m_note = label({.id = "spectrumNote", .wraps = true});
  QChartView* m_chart;
  QLineSeries* m_line;
  QScatterSeries* m_marks;
  QValueAxis* m_hz;
  QValueAxis* m_amplitude;
  QTableWidget* m_table;
  QTimer m_delay;
  std::vector<ScopeCurves::Curve> m_shown;
  QString m_unit;
  QString m_problem;
  trace::Spectrum m_spectrum;
  int m_request = 0;
};

}  // namespace rivulet::widgets
