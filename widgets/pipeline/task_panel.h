// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Executes an NC program in the six tasks of a parallel CNC on virtual axes, and shows what each
/// task does, waits for and needs, with the levels of the buffers; or shows a recording of that.
/// @threadsafety GUI thread.
#pragma once

#include "pipeline/task.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"
#include "widgets/pipeline/pipeline_view.h"

class QCheckBox;
class QComboBox;
class QTableView;

namespace rivulet::widgets {

class CurveChart;
class StatusLabel;

class TaskPanel final : public Page {
  Q_OBJECT

 public:
  explicit TaskPanel(QWidget* parent = nullptr);
  ~TaskPanel() override;

  void setView(PipelineView view);
  /// @param name  of the program that is open; empty: none is
  void setProgram(const QString& name);
  /// @param reason  why nothing can be executed now; empty: it can
  void setBlocked(const QString& reason);
  /// @param isAllowed  whether this computer gives position control real time
  void setRealTimeAllowed(bool isAllowed);

 Q_SIGNALS:
  void startRequested(const rivulet::widgets::PipelineChoice& choice);
  void stopRequested();
  void openRequested(const QString& path);
  void saveRequested(const QString& path);

 protected:
  void retranslate() override;

 private:
  /// A row of the table.
  struct TaskRow {
    pipeline::Task task = pipeline::Task::Receive;
    pipeline::TaskRecord record;
    int level = 0;     ///< of the buffer after it
    int capacity = 0;  ///< likewise; 0: there is none
  };

  void connectParts();
  void start();
  void chooseRecording();
  void chooseFileToSave();
  void showView();
  void showNote();

  PipelineView m_view;
  QString m_program;
  QString m_blocked;
  bool m_isRealTimeAllowed = true;

  QComboBox* m_source;
  QComboBox* m_policy;
  QComboBox* m_processors;
  QComboBox* m_cycle;
  QCheckBox* m_realTime =
      checkBox({.text = QT_TR_NOOP("Real time"),
                .tip = QT_TR_NOOP("Position control comes before everything else on this computer"),
                .id = "taskRealTime",
                .isTouch = true});
  QPushButton* m_start =
      button({.text = QT_TR_NOOP("Execute"),
              .tip = QT_TR_NOOP("Execute the program in six tasks, on virtual axes"),
              .id = "taskStart"},
             &TaskPanel::start);
  QPushButton* m_stop = button({.text = QT_TR_NOOP("End"),
                                .tip = QT_TR_NOOP("End the tasks; the virtual axes stand"),
                                .id = "taskStop"},
                               &TaskPanel::stopRequested);
  QPushButton* m_open = button({.text = QT_TR_NOOP("Open…"),
                                .tip = QT_TR_NOOP("Open a recording of a scheduler"),
                                .id = "taskOpen"},
                               &TaskPanel::chooseRecording);
  QPushButton* m_save = button({.text = QT_TR_NOOP("Save…"),
                                .tip = QT_TR_NOOP("Save what the scheduler did"),
                                .id = "taskSave"},
                               &TaskPanel::chooseFileToSave);
  StatusLabel* m_note;
  StatusLabel* m_remark;
  QTableView* m_table;
  TableModel<TaskRow>* m_tasks;
  CurveChart* m_levels;
};

}  // namespace rivulet::widgets
