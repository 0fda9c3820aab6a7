// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What is at the two cursors and between them, for every curve that is shown; and a line to go to
/// a time, a line or a point. @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace rivulet::widgets {

class ScopeView;
class TimeWindow;

class CursorPanel final : public Page {
  Q_OBJECT

 public:
  CursorPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, ScopeView* view,
              QWidget* parent = nullptr);

  /// Calculates pending figures at once: for pictures and tests.
  void refreshNow();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  /// A curve and what is known of it between the cursors.
  struct Column {
    QString title;
    ScopeCurves::Samples samples;
  };
  enum Row { AtA, AtB, Difference, Slope, Min, Max, Mean, Rms, Median, P95, P99, Count, kRows };
  enum GoTo { Time, Line, Point };

  void schedule();
  void refresh();
  void showFigures(std::size_t column, const trace::SampleStatistics& figures);
  void setCell(int row, std::size_t column, const QString& text);
  void go();
  [[nodiscard]] QString slopeTitle() const;
  /// First instant at which a signal has this value or a larger one.
  [[nodiscard]] std::optional<double> timeOf(const QString& formula, double value) const;

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  ScopeView* m_view;
  QLabel* m_times = value({.id = "cursorTimes", .wraps = true});
  QTableWidget* m_table;
  QComboBox* m_what = list({.name = QT_TR_NOOP("Go to"), .id = "goToWhat", .isTouch = true});
  QLineEdit* m_where = lineEdit(
      {.name = QT_TR_NOOP("Number of the place to go to"), .id = "goToWhere", .isTouch = true});
  QPushButton* m_go = button({.text = QT_TR_NOOP("Go"), .id = "goTo"}, &CursorPanel::go);
  QLabel* m_note = label({.id = "goToNote", .wraps = true});
  QTimer m_delay;
  std::vector<Column> m_columns;
  int m_request = 0;
};

}  // namespace rivulet::widgets
