// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All runs of this computer: a table that can be sorted and filtered, and below it what is known
/// of the selected run, with what can be done with it. @threadsafety GUI thread.
#pragma once

#include <QPalette>
#include <optional>
#include <vector>

#include "streaming/run/run_summary.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace rivulet::widgets {

class ReportPanel;
class StatusLabel;
class WholeNumberField;

class RunsModel final : public TableModel<streaming::RunSummary> {
  Q_OBJECT

 public:
  enum Column {
    Time,
    Program,
    Result,
    Machine,
    Method,
    Points,
    Feed,
    Executed,
    Repeated,
    Skipped,
    Duration,
    Pauses,
    Who,
    ColumnCount
  };
  /// Of a cell, for sorting.
  static constexpr int kSortRole = Qt::UserRole;

  explicit RunsModel(QObject* parent = nullptr);
  void setColors(const QPalette& palette);

 private:
  QPalette m_palette;
};

/// A run of the history that cannot be shown.
struct UnreadableRunView {
  QString file;
  QString reason;
};

/// How many runs are kept.
struct HistoryBounds {
  int runs = 1000;
  int gibibytes = 4;
};

class RunsPage final : public Page {
  Q_OBJECT

 public:
  explicit RunsPage(QWidget* parent = nullptr);

  /// @param runs  the newest first. The selected run stays selected if it is still there; else the
  ///              newest is
  void setRuns(const std::vector<streaming::RunSummary>& runs,
               const std::vector<UnreadableRunView>& unreadable);
  /// Selects a run, whether it passes the filter or not.
  void select(const std::string& id);
  /// What is known of the selected run. Ignored for another one.
  void setDetail(const std::string& id, const streaming::RunReport& report);
  void setDetailProblem(const std::string& id, const QString& reason);
  /// A report from a file, which is not in the history.
  void showFile(const streaming::RunSummary& summary, const streaming::RunReport& report);
  /// Number of the run that was left and can be resumed; nothing: there is none.
  void setResumable(std::optional<int> runNumber);
  /// Whether another program may be loaded and its settings be set now.
  void setRepeatEnabled(bool isEnabled);
  /// Whether who is there may change how many runs are kept.
  void setBoundsEnabled(bool isEnabled);
  void setBounds(const HistoryBounds& bounds);

  /// The run whose report is shown; null: none.
  [[nodiscard]] const streaming::RunSummary* current() const;
  [[nodiscard]] QTableView* table() const { return m_table; }
  [[nodiscard]] QLineEdit* search() const { return m_search; }
  /// Runs that pass the filter, in the order shown.
  [[nodiscard]] std::vector<streaming::RunSummary> shownRuns() const;

 Q_SIGNALS:
  void detailRequested(const QString& id);
  /// Of the run whose report is shown (`current`).
  void tracesRequested();
  void repeatRequested();
  void resumeRequested();
  void sheetRequested(const QString& path);
  void jsonRequested(const QString& path);
  /// Of the runs shown in the table.
  void csvRequested(const QString& path);
  /// A report from a file.
  void openRequested(const QString& path);
  void boundsRequested(const rivulet::widgets::HistoryBounds& bounds);

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  class Filter;

  [[nodiscard]] QWidget* makeFilterRow();
  [[nodiscard]] QWidget* makeDetail();
  void connectButtons();
  void fillMachines();
  void takeSelection();
  void showCount();
  void showActions();
  [[nodiscard]] QString suggestedFile(const QString& ending) const;

  RunsModel* m_model;
  Filter* m_filter;
  QLineEdit* m_search;
  QComboBox* m_results;
  QComboBox* m_machines;
  QLabel* m_count;
  QTableView* m_table;
  QLabel* m_unreadable = value({.wraps = true});
  QPushButton* m_csv;
  QPushButton* m_open;
  WholeNumberField* m_keepRuns;
  WholeNumberField* m_keepSize;
  StatusLabel* m_title;
  ReportPanel* m_report;
  QPushButton* m_traces;
  QPushButton* m_repeat;
  QPushButton* m_resume;
  QPushButton* m_sheet;
  QPushButton* m_json;
  std::vector<UnreadableRunView> m_unreadableRuns;
  std::optional<streaming::RunSummary> m_current;  ///< with its report shown, or asked for
  bool m_hasDetail = false;
  bool m_canRepeat = true;
  bool m_isFilling = false;
  std::optional<int> m_resumable;
};

}  // namespace rivulet::widgets
