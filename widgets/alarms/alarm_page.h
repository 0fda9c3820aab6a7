// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All alarms with state, cause and remedy, to be acknowledged and shelved; and their history.
/// @threadsafety GUI thread.
#pragma once

#include <QPalette>
#include <vector>

#include "alarm/alarm_list.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QLabel;
class QMenu;
class QPushButton;
class QTableView;
class QTabBar;

namespace rivulet::widgets {

class AlarmModel final : public TableModel<alarm::Alarm> {
  Q_OBJECT

 public:
  enum Column { Text, StateColumn, Time, Count };
  explicit AlarmModel(QObject* parent = nullptr);
  void setColors(const QPalette& palette);

 private:
  QPalette m_palette;
};

class AlarmHistoryModel final : public TableModel<alarm::Transition> {
  Q_OBJECT

 public:
  enum Column { Time, EventColumn, Text, By };
  static constexpr std::size_t kCapacity = 5000;
  explicit AlarmHistoryModel(QObject* parent = nullptr);
};

class AlarmPage final : public Page {
  Q_OBJECT

 public:
  explicit AlarmPage(QWidget* parent = nullptr);

  void setAlarms(const std::vector<alarm::Alarm>& alarms);
  /// @param transitions  the newest first
  void setHistory(const std::vector<alarm::Transition>& transitions);
  /// Shows the alarms, not the history, with the most important one selected.
  void showAlarms();

 Q_SIGNALS:
  void acknowledgeRequested(int number);
  void acknowledgeAllRequested();
  void shelveRequested(int number, int minutes);
  void unshelveRequested(int number);

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  /// The alarm that is selected; null: none.
  [[nodiscard]] const alarm::Alarm* selected() const;
  [[nodiscard]] QWidget* makeDetails();
  void showSelected();
  void showTable();

  AlarmModel* m_model;
  AlarmHistoryModel* m_historyModel;
  QTabBar* m_tabs;
  QTableView* m_table;
  QTableView* m_history;
  QWidget* m_details;
  QLabel* m_text;
  QLabel* m_causeTitle;
  QLabel* m_cause;
  QLabel* m_remedyTitle;
  QLabel* m_remedy;
  QLabel* m_facts;
  QPushButton* m_acknowledge;
  QPushButton* m_acknowledgeAll;
  QPushButton* m_shelve;
  QMenu* m_shelveMenu;
  int m_selected = 0;  ///< number of the alarm that was chosen; 0: none
};

}  // namespace rivulet::widgets
