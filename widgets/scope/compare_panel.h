// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How several traces differ: on which axis they lie, and a table of their largest and mean
/// differences from the first one. A row leads to its place. @threadsafety GUI thread.
#pragma once

#include <QTimer>
#include <vector>

#include "trace/comparison.h"
#include "widgets/common/page.h"
#include "widgets/scope/scope_pane.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QTableWidget;

namespace rivulet::widgets {

class ScopeView;
class TimeWindow;

class ComparePanel final : public Page {
  Q_OBJECT

 public:
  ComparePanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, ScopeView* view,
               QWidget* parent = nullptr);

  /// Calculates a pending table at once: for pictures and tests.
  void refreshNow();

 protected:
  void retranslate() override;
  void restyle() override;
  void showEvent(QShowEvent* event) override;

 private:
  enum Column { Signal, Largest, At, Rms, kColumns };
  struct Row {
    std::size_t trace = 0;
    trace::SignalDifference difference;
  };

  void schedule();
  void refresh();
  void showRows(std::vector<Row> rows);
  void showAxis();
  void showNote();
  void goTo(int row);

  ScopeCurves* m_curves;
  TimeWindow* m_window;
  ScopeCursors* m_cursors;
  ScopeView* m_view;
  QComboBox* m_axis = list({.name = QT_TR_NOOP("Axis of the comparison"),
                            .items = {QT_TR_NOOP("time"), QT_TR_NOOP("length of path"),
                                      QT_TR_NOOP("point of the program")},
                            .id = "compareAxis",
                            .isTouch = true});
  QCheckBox* m_differences =
      checkBox({.text = QT_TR_NOOP("Show the differences as curves"),
                .tip = QT_TR_NOOP("Each pane shows the other traces minus the first one"),
                .id = "compareDifferences",
                .isTouch = true});
  QLabel* m_note = label({.id = "compareNote", .wraps = true});
  QTableWidget* m_table;
  QTimer m_delay;
  std::vector<Row> m_rows;
  QString m_problem;
  bool m_isBusy = false;
  int m_request = 0;
};

}  // namespace rivulet::widgets
