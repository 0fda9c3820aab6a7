// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/task_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <array>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/pipeline/choice_list.h"
#include "widgets/plots/curve_chart.h"

namespace rivulet::widgets {

namespace {

using TasksState = PipelineView::State;

constexpr std::array<double, 5> kRunCyclesMs{1.0, 2.0, 4.0, 10.0, 15.0};
constexpr int kRunCycleFirst = 2;
constexpr int kProcessorsFirst = 1;  ///< two
constexpr int kLevelChartPx = 130;
constexpr int kTaskTablePx = 215;
constexpr double kSecondsShown = 1.0;  ///< at least
constexpr double kPlacesShown = 5.0;

QString microsecondsOf(base::Duration time) {
  return numberText(1e6 * base::toSeconds(time), 1);
}

QString millisecondsOf(base::Duration time) {
  return numberText(base::toMilliseconds(time), 1);
}

}  // namespace

TaskPanel::TaskPanel(QWidget* parent)
    : Page(parent),
      m_source(say(makeChoiceList("taskProgram", this),
                   {.hint = QT_TR_NOOP("Program that the tasks execute")})),
      m_policy(say(makeChoiceList("taskPolicy", this),
                   {.hint = QT_TR_NOOP("Which task gets the processor")})),
      m_processors(say(makeChoiceList("taskProcessors", this),
                       {.hint = QT_TR_NOOP("How many tasks run at a time")})),
      m_cycle(say(makeChoiceList("taskCycle", this),
                  {.hint = QT_TR_NOOP("Cycle of position control")})),
      m_note(say(new StatusLabel(this, StatusLabel::Elided{2}), {.id = "taskNote"})),
      m_remark(say(new StatusLabel(this, StatusLabel::Elided{2}), {.id = "taskRemark"})),
      m_table(say(new QTableView(this),
                  {.hint = QT_TR_NOOP(
                       "Tasks: starts, waiting for data and for a processor, time of a step"),
                   .id = "taskTable"})),
      m_levels(say(new CurveChart(AxisScale::Even, AxisScale::Even, this), {.id = "taskLevels"})) {
  m_levels->setMinimumHeight(kLevelChartPx);
  m_levels->setShown(QRectF(0.0, 0.0, kSecondsShown, kPlacesShown));
  styleTable(m_table);
  m_tasks = new TableModel<TaskRow>(
      {{[] { return tr("Task"); },
        [](const TaskRow& row) {
          const std::array<QString, pipeline::kTaskCount> names{
              tr("G code receiving"), tr("Interpreter"),   tr("Discrete"),
              tr("Forward-looking"),  tr("Interpolation"), tr("Position control")};
          return names[indexOf(row.task)];
        }},
       {[] { return tr("Starts"); },
        [](const TaskRow& row) { return countText(static_cast<std::size_t>(row.record.count)); },
        true},
       {[] { return tr("Data, ms"); },
        [](const TaskRow& row) { return millisecondsOf(row.record.waitedData); }, true},
       {[] { return tr("Processor, ms"); },
        [](const TaskRow& row) { return millisecondsOf(row.record.waitedTurn); }, true},
       {[] { return tr("Mean, µs"); },
        [](const TaskRow& row) { return microsecondsOf(row.record.responseMean()); }, true},
       {[] { return tr("Min, µs"); },
        [](const TaskRow& row) { return microsecondsOf(row.record.responseMin); }, true},
       {[] { return tr("Max, µs"); },
        [](const TaskRow& row) { return microsecondsOf(row.record.responseMax); }, true},
       {[] { return tr("Preempted"); },
        [](const TaskRow& row) {
          return countText(static_cast<std::size_t>(row.record.preemptions));
        },
        true},
       {[] { return tr("Buffer"); },
        [](const TaskRow& row) {
          return row.capacity == 0 ? noValue()
                                   : QStringLiteral("B%1: %2/%3")
                                         .arg(indexOf(row.task) + 1)
                                         .arg(row.level)
                                         .arg(row.capacity);
        },
        true}},
      this);
  m_table->setModel(m_tasks);
  m_table->setMinimumHeight(kTaskTablePx);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);

  inColumn({inRow({m_source, m_policy, m_processors, m_cycle, m_realTime, spring()}),
            inRow({m_start, m_stop, m_open, m_save, {m_note, 1, Qt::AlignVCenter}}),
            m_remark,
            m_table,
            {m_levels, 1}},
           this, QMargins(4, 6, 4, 4));
  connectParts();
  retranslate();
  onTheme([this] { m_levels->update(); });
}

TaskPanel::~TaskPanel() = default;

void TaskPanel::connectParts() {
}

void TaskPanel::start() {
  PipelineChoice choice;
  choice.isExample = m_program.isEmpty() || m_source->currentIndex() == 1;
  choice.policy = pipeline::policies()[static_cast<std::size_t>(m_policy->currentIndex())].kind;
  choice.processors = m_processors->currentIndex() + 1;
  choice.cycleMs = kRunCyclesMs[static_cast<std::size_t>(m_cycle->currentIndex())];
  choice.isRealTime = m_isRealTimeAllowed && m_realTime->isChecked();
  Q_EMIT startRequested(choice);
}

void TaskPanel::chooseRecording() {
  askForFile(this, {tr("Open a recording of the tasks"), {}, {}},
             [this](const QString& path) { Q_EMIT openRequested(path); });
}

void TaskPanel::chooseFileToSave() {
  askWhereToSave(this, {tr("Save what the scheduler did"), {}, {}},
                 [this](const QString& path, auto) { Q_EMIT saveRequested(path); });
}

void TaskPanel::setView(PipelineView view) {
  m_view = std::move(view);
  showView();
}

void TaskPanel::setProgram(const QString& name) {
  m_program = name;
  retranslate();
}

void TaskPanel::setBlocked(const QString& reason) {
  m_blocked = reason;
  showView();
}

void TaskPanel::setRealTimeAllowed(bool isAllowed) {
  m_isRealTimeAllowed = isAllowed;
  retranslate();
}

void TaskPanel::showView() {
  const bool isRunning = m_view.state == TasksState::Running;
  m_start->setEnabled(!isRunning && m_blocked.isEmpty());
  m_stop->setEnabled(isRunning);
  m_open->setEnabled(!isRunning);
  m_save->setEnabled(!isRunning && m_view.canBeSaved);
  for (QComboBox* list : {m_source, m_policy, m_processors, m_cycle}) {
    list->setEnabled(!isRunning);
  }
  m_realTime->setEnabled(!isRunning && m_isRealTimeAllowed);
  std::vector<TaskRow> rows;
  for (std::size_t i = 0; i < pipeline::kTaskCount; ++i) {
    TaskRow row;
    row.task = static_cast<pipeline::Task>(i);
    row.record = m_view.records[i];
    if (i < pipeline::kBufferCount) {
      row.level = m_view.levels[i];
      row.capacity = m_view.dispatch.capacity;
    }
    rows.push_back(row);
  }
  m_tasks->setRows(rows);
  std::vector<ChartCurve> curves;
  for (std::size_t i = 0; i < pipeline::kBufferCount; ++i) {
    ChartCurve curve{QStringLiteral("B%1").arg(i + 1), i, false, {}};
    // Up and down within each stretch: nothing that was reached is missing.
    const double lengthS = base::toSeconds(m_view.history.length());
    double atS = 0.0;
    for (const pipeline::LevelHistory::Stretch& stretch : m_view.history.stretches()) {
      curve.points.emplace_back(atS + 0.25 * lengthS, stretch.least[i]);
      curve.points.emplace_back(atS + 0.75 * lengthS, stretch.greatest[i]);
      atS += lengthS;
    }
    curves.push_back(std::move(curve));
  }
  m_levels->setCurves(std::move(curves));
  showNote();
}

void TaskPanel::showNote() {
  const QString time = durationText(base::toSeconds(m_view.length));
  const QString points =
      countText(static_cast<std::size_t>(m_view.records[indexOf(pipeline::Task::Position)].count));
  switch (m_view.state) {
    case TasksState::Nothing:
      m_note->setStatus(m_blocked.isEmpty() ? Status::Plain : Status::Attention,
                        m_blocked.isEmpty()
                            ? tr("Executes a program on virtual axes. No machine moves.")
                            : m_blocked);
      break;
    case TasksState::Running:
      m_note->setStatus(Status::Busy, tr("%1: %2, %3 set points").arg(m_view.name, time, points));
      break;
    case TasksState::Ended:
      m_note->setStatus(Status::Good,
                        tr("%1 has ended: %2, %3 set points").arg(m_view.name, time, points));
      break;
    case TasksState::Stopped:
      m_note->setStatus(Status::Plain,
                        tr("%1 was stopped: %2, %3 set points").arg(m_view.name, time, points));
      break;
    case TasksState::Recorded:
      m_note->setStatus(Status::Plain,
                        tr("Recording %1: %2, %3 set points").arg(m_view.name, time, points));
      break;
    case TasksState::Failed:
      m_note->setStatus(Status::Fault, m_view.message);
      break;
  }
}

void TaskPanel::retranslate() {
  const QString example = tr("Example");
  setChoices(m_source, m_program.isEmpty() ? QStringList{example} : QStringList{m_program, example},
             0);
  setChoices(m_policy,
             {tr("Task dependency"), tr("Data flow"), tr("Earliest starvation"), tr("Steady")}, 0);
  QStringList processors;
  for (std::size_t i = 1; i <= pipeline::kTaskCount; ++i) {
    processors.append(tr("Processors: %1").arg(i));
  }
  setChoices(m_processors, processors, kProcessorsFirst);
  QStringList cycles;
  for (const double cycle : kRunCyclesMs) {
    cycles.append(tr("Cycle %1 ms").arg(numberText(cycle, 0)));
  }
  setChoices(m_cycle, cycles, kRunCycleFirst);
  m_remark->setStatus(
      Status::Plain,
      m_isRealTimeAllowed
          ? tr("Without real time, other programs of this computer can delay position control.")
          : tr("This computer does not allow real-time scheduling: position control runs like any "
               "other program, and others can delay it."));
  m_levels->setTitles(tr("Levels of the buffers"), tr("Time, s"), tr("Level"));
  m_tasks->refresh();
  showView();
}

}  // namespace rivulet::widgets
