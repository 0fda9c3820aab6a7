// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/runs/runs_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <algorithm>
#include <array>

#include "base/units.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/runs/run_texts.h"
#include "widgets/streaming/report_panel.h"

namespace rivulet::widgets {

using streaming::RunSummary;

namespace {

QString text(const std::string& value) {
  return value.empty() ? noValue() : QString::fromStdString(value);
}

/// A column whose cells sort by a value instead of their text.
template <class Title, class Text, class Value>
TableColumn<RunSummary> column(Title title, Text shown, Value value, bool isNumber) {
  return {title, shown, isNumber, [value](const RunSummary& run, int role) {
            return role == RunsModel::kSortRole ? QVariant(value(run)) : QVariant();
          }};
}

TableColumn<RunSummary> countColumn(QString (*title)(), std::size_t RunSummary::*member,
                                    bool needsJudgement) {
  return column(
      title,
      [=](const RunSummary& run) {
        return needsJudgement && !run.judged ? noValue() : countText(run.*member);
      },
      [=](const RunSummary& run) { return static_cast<qulonglong>(run.*member); }, true);
}

}  // namespace

RunsModel::RunsModel(QObject* parent)
    : TableModel(
          {column([] { return tr("Time"); }, startText,
                  [](const RunSummary& run) {
                    return QString::fromStdString(run.origin.startedAtUtc + run.id);
                  },
                  false),
           column([] { return tr("Program"); },
                  [](const RunSummary& run) { return text(run.programName); },
                  [](const RunSummary& run) { return text(run.programName).toLower(); }, false),
           {[] { return tr("Result"); },
            [](const RunSummary& run) { return resultText(run.outcome, run.finding); }, false,
            [this](const RunSummary& run, int role) {
              if (role == kSortRole) {
                return QVariant(
                    static_cast<int>(ReportPanel::resultStatus(run.outcome, run.finding)) * 10 +
                    static_cast<int>(run.outcome));
              }
              if (role == Qt::DecorationRole) {
                const Status status = ReportPanel::resultStatus(run.outcome, run.finding);
                return QVariant(themedIcon(statusIconName(status), statusColor(status, m_palette)));
              }
              return QVariant();
            }},
           column([] { return tr("Machine"); }, machineText, machineText, false),
           column([] { return tr("Method"); },
                  [](const RunSummary& run) { return methodText(run.method); },
                  [](const RunSummary& run) { return methodText(run.method); }, false),
           column([] { return tr("N"); },
                  [](const RunSummary& run) { return QString::number(run.pointsPerLoop); },
                  [](const RunSummary& run) { return run.pointsPerLoop; }, true),
           column([] { return tr("Feed"); }, [](const RunSummary& run) { return feedsText(run); },
                  [](const RunSummary& run) { return run.feedMmPerS; }, true),
           column([] { return tr("Executed"); },
                  [](const RunSummary& run) {
                    return tr("%1 of %2").arg(countText(run.executed), countText(run.total));
                  },
                  [](const RunSummary& run) { return static_cast<qulonglong>(run.executed); },
                  true),
           countColumn([] { return tr("Repeated"); }, &RunSummary::repeated, true),
           countColumn([] { return tr("Skipped"); }, &RunSummary::skipped, true),
           column([] { return tr("Duration"); },
                  [](const RunSummary& run) { return durationText(base::toSeconds(run.duration)); },
                  [](const RunSummary& run) { return base::toSeconds(run.duration); }, true),
           countColumn([] { return tr("Pauses"); }, &RunSummary::pauses, false),
           column([] { return tr("Who"); },
                  [](const RunSummary& run) { return originText(run.origin); },
                  [](const RunSummary& run) { return originText(run.origin); }, false)},
          parent) {
}

void RunsModel::setColors(const QPalette& palette) {
  m_palette = palette;
  refresh();
}

/// Passes rows in which every word that is looked for stands somewhere.
class RunsPage::Filter final : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setWords(const QString& words) {
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
  }
  /// @param status  nothing: every result
  void setStatus(const std::optional<Status>& status) {
    m_status = status;
    invalidateFilter();
  }
  /// @param machine  empty: every machine
  void setMachine(const QString& machine) {
    m_machine = machine;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex&) const override {
    const auto* model = static_cast<const RunsModel*>(sourceModel());
    const RunSummary& run = model->row(row);
    if ((m_status && ReportPanel::resultStatus(run.outcome, run.finding) != *m_status) ||
        (!m_machine.isEmpty() && machineText(run) != m_machine)) {
      return false;
    }
    return std::all_of(m_words.begin(), m_words.end(), [&](const QString& word) {
      for (int column = 0; column < RunsModel::ColumnCount; ++column) {
        if (model->data(model->index(row, column), Qt::DisplayRole)
                .toString()
                .contains(word, Qt::CaseInsensitive)) {
          return true;
        }
      }
      return QString::fromStdString(run.programHash).contains(word, Qt::CaseInsensitive);
    });
  }

 private:
  QStringList m_words;
  std::optional<Status> m_status;
  QString m_machine;
};

namespace {

/// Headings and contents are seen whole, unless a text is very long.
void fitColumns(QTableView& table) {
  constexpr int kWidest = 260;
  table.resizeColumnsToContents();
  for (int column = 0; column < RunsModel::ColumnCount; ++column) {
    table.setColumnWidth(column, std::min(table.columnWidth(column), kWidest));
  }
}

}  // namespace

RunsPage::RunsPage(QWidget* parent)
    : Page(parent),
      m_model(new RunsModel(this)),
      m_filter(new Filter(this)),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("Runs")})) {
  m_filter->setSourceModel(m_model);
  m_filter->setSortRole(RunsModel::kSortRole);
  m_table->setModel(m_filter);
  styleTable(m_table);
  m_table->setSortingEnabled(true);
  m_table->sortByColumn(RunsModel::Time, Qt::DescendingOrder);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  m_table->setMinimumHeight(150);
  auto* upper = new QWidget(this);
  inColumn({makeFilterRow(), {m_table, 1}, m_unreadable}, upper, QMargins(0, 0, 0, 0));
  auto* halves = new QSplitter(Qt::Vertical, this);
  halves->addWidget(upper);
  halves->addWidget(makeDetail());
  halves->setChildrenCollapsible(false);
  halves->setStretchFactor(0, 1);
  halves->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(halves);
  setTabOrder(m_csv, m_table);
  connectButtons();
  retranslate();
  restyle();
}

QWidget* RunsPage::makeFilterRow() {
  auto* row = new QWidget(this);
  m_search = lineEdit({.tip = QT_TR_NOOP("Shows runs in which each word stands in some column"),
                       .name = QT_TR_NOOP("Search runs"),
                       .placeholder = QT_TR_NOOP("Search")});
  m_results = list({.name = QT_TR_NOOP("Result"),
                    .items = {QT_TR_NOOP("All results"), QT_TR_NOOP("Faultless"),
                              QT_TR_NOOP("Not judged"), QT_TR_NOOP("Failed or wrong")}});
  int item = 1;  // the first is for all
  for (const Status result : {Status::Good, Status::Unknown, Status::Fault}) {
    m_results->setItemData(item++, static_cast<int>(result));
  }
  m_machines = list({.name = QT_TR_NOOP("Machine")});
  m_count = label({.isMuted = true});
  m_csv = button({.text = QT_TR_NOOP("Table as CSV…"), .icon = "save"});
  m_search->setClearButtonEnabled(true);
  m_search->setMinimumWidth(60);
  for (QWidget* field : {static_cast<QWidget*>(m_search), static_cast<QWidget*>(m_results),
                         static_cast<QWidget*>(m_machines)}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  m_results->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // the language may change
  // Long names of machines are not to widen the page.
  m_machines->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_machines->setMinimumContentsLength(12);
  inRow({{m_search, 1}, m_results, m_machines, m_count, m_csv}, row, QMargins(0, 0, 0, 0));
  return row;
}

QWidget* RunsPage::makeDetail() {
  auto* detail = new QWidget(this);
  m_title = new StatusLabel(detail, StatusLabel::Elided{});
  m_traces =
      button({.text = QT_TR_NOOP("Open in Traces"), .icon = "live"}, &RunsPage::tracesRequested);
  m_repeat = button({.text = QT_TR_NOOP("Repeat with these settings")}, &RunsPage::repeatRequested);
  m_resume = button({.text = QT_TR_NOOP("Resume"), .icon = "resume"}, &RunsPage::resumeRequested);
  m_sheet = button({.text = QT_TR_NOOP("Page as PDF…"), .icon = "save"});
  m_report = new ReportPanel(detail);
  auto* scrolled = new QScrollArea(detail);
  scrolled->setWidget(m_report);
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setMinimumHeight(150);
  m_keepRuns =
      say(new WholeNumberField(detail),
          {.name = QT_TR_NOOP("Number of runs that are kept"), .suffix = QT_TR_NOOP(" runs")});
  m_keepSize =
      say(new WholeNumberField(detail),
          {.name = QT_TR_NOOP("Size of reports and recordings that are kept"), .suffix = " GiB"});
  m_keepRuns->setRange(1, 100'000);
  m_keepSize->setRange(1, 10'000);
  m_open = button({.text = QT_TR_NOOP("Open a report…"),
                   .tip = QT_TR_NOOP("A report that was exported here or printed by stream --json"),
                   .icon = "open"});
  m_json = button({.text = QT_TR_NOOP("JSON…"), .icon = "save"});
  inColumn({m_title,
            inRow({m_traces, m_repeat, m_resume, m_sheet, spring()}),
            {scrolled, 1},
            inRow({label({.text = QT_TR_NOOP("Keep at most"), .isMuted = true}), m_keepRuns,
                   m_keepSize, spring(), m_open, m_json})},
           detail, QMargins(0, 4, 0, 0));
  return detail;
}

void RunsPage::connectButtons() {
  connect(m_search, &QLineEdit::textChanged, this, [this](const QString& words) {
    m_filter->setWords(words);
    showCount();
  });
  connect(m_results, &QComboBox::currentIndexChanged, this, [this] {
    const QVariant status = m_results->currentData();
    m_filter->setStatus(status.isValid() ? std::optional(static_cast<Status>(status.toInt()))
                                         : std::nullopt);
    showCount();
  });
  connect(m_machines, &QComboBox::currentIndexChanged, this, [this] {
    m_filter->setMachine(m_machines->currentData().toString());
    showCount();
  });
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &RunsPage::takeSelection);
  const auto save = [this](QPushButton* button, const char* ending, auto request) {
    connect(button, &QPushButton::clicked, this, [this, ending, request] {
      askWhereToSave(this,
                     {tr("Save"), suggestedFile(QLatin1String(ending)),
                      QStringLiteral("*.%1").arg(QLatin1String(ending))},
                     [this, request](const QString& path, auto) { Q_EMIT(this->*request)
                                                                  (path); });
    });
  };
  save(m_sheet, "pdf", &RunsPage::sheetRequested);
  save(m_json, "json", &RunsPage::jsonRequested);
  save(m_csv, "csv", &RunsPage::csvRequested);
  connect(m_open, &QPushButton::clicked, this, [this] {
    askForFile(this, {tr("Open a report"), {}, tr("Reports (*.json)")},
               [this](const QString& path) { Q_EMIT openRequested(path); });
  });
  for (WholeNumberField* box : {m_keepRuns, m_keepSize}) {
    connect(box, &WholeNumberField::valueChanged, this, [this] {
      if (!m_isFilling) {
        Q_EMIT boundsRequested({m_keepRuns->value(), m_keepSize->value()});
      }
    });
  }
}

void RunsPage::setRuns(const std::vector<RunSummary>& runs,
                       const std::vector<UnreadableRunView>& unreadable) {
  const std::string selected = m_current ? m_current->id : std::string();
  m_unreadableRuns = unreadable;
  m_isFilling = true;  // the selection is lost and made again
  m_model->setRows(runs);
  fillMachines();
  m_isFilling = false;
  const bool isThere = std::any_of(runs.begin(), runs.end(),
                                   [&](const RunSummary& run) { return run.id == selected; });
  if (isThere) {
    const bool hadDetail = m_hasDetail;
    m_isFilling = true;
    select(selected);
    m_isFilling = false;
    m_hasDetail = hadDetail;
  } else if (!m_current || !m_current->id.empty()) {
    m_current.reset();
    m_hasDetail = false;
    m_report->setReport(std::nullopt);
    if (m_filter->rowCount() > 0) {
      m_table->selectRow(0);
    }
  }
  fitColumns(*m_table);
  showCount();
  showActions();
}

void RunsPage::fillMachines() {
  const QString present = m_machines->currentData().toString();
  QStringList names;
  for (const RunSummary& run : m_model->rows()) {
    names.append(machineText(run));
  }
  names.removeDuplicates();
  names.sort(Qt::CaseInsensitive);
  const QSignalBlocker blocker(m_machines);
  m_machines->clear();
  m_machines->addItem(tr("All machines"), QString());
  for (const QString& name : names) {
    m_machines->addItem(name, name);
  }
  m_machines->setCurrentIndex(std::max(0, m_machines->findData(present)));
  m_filter->setMachine(m_machines->currentData().toString());
}

void RunsPage::select(const std::string& id) {
  const auto& runs = m_model->rows();
  const auto found =
      std::find_if(runs.begin(), runs.end(), [&](const RunSummary& run) { return run.id == id; });
  if (found == runs.end()) {
    return;
  }
  const QModelIndex row = m_filter->mapFromSource(
      m_model->index(static_cast<int>(found - runs.begin()), RunsModel::Time));
  if (row.isValid()) {
    m_table->selectRow(row.row());
    m_table->scrollTo(row);
  }
  if (!m_current || m_current->id != id) {
    m_current = *found;
    m_hasDetail = false;
    Q_EMIT detailRequested(QString::fromStdString(id));
  }
}

void RunsPage::takeSelection() {
  const QModelIndex row = m_table->currentIndex();
  if (m_isFilling || !row.isValid()) {
    return;
  }
  const RunSummary& run = m_model->row(m_filter->mapToSource(row).row());
  if (m_current && !run.id.empty() && m_current->id == run.id) {
    return;
  }
  m_current = run;
  m_hasDetail = false;
  m_report->setReport(std::nullopt);
  showActions();
  Q_EMIT detailRequested(QString::fromStdString(run.id));
}

void RunsPage::setDetail(const std::string& id, const streaming::RunReport& report) {
  if (m_current && m_current->id == id) {
    m_report->setReport(report, m_current->jobTimes, m_current->tools);
    m_hasDetail = true;
    showActions();
  }
}

void RunsPage::setDetailProblem(const std::string& id, const QString& reason) {
  if (m_current && m_current->id == id) {
    m_report->setReport(std::nullopt);
    m_hasDetail = false;
    showActions();
    m_title->setStatus(Status::Attention, reason);
  }
}

void RunsPage::showFile(const RunSummary& summary, const streaming::RunReport& report) {
  m_table->clearSelection();
  m_table->setCurrentIndex({});
  m_current = summary;
  m_current->id.clear();
  m_report->setReport(report, summary.jobTimes, summary.tools);
  m_hasDetail = true;
  showActions();
}

void RunsPage::setResumable(std::optional<int> runNumber) {
  m_resumable = runNumber;
  showActions();
}

void RunsPage::setRepeatEnabled(bool isEnabled) {
  m_canRepeat = isEnabled;
  showActions();
}

void RunsPage::setBoundsEnabled(bool isEnabled) {
  m_keepRuns->setEnabled(isEnabled);
  m_keepSize->setEnabled(isEnabled);
}

void RunsPage::setBounds(const HistoryBounds& bounds) {
  m_isFilling = true;
  m_keepRuns->setValue(bounds.runs);
  m_keepSize->setValue(bounds.gibibytes);
  m_isFilling = false;
}

const RunSummary* RunsPage::current() const {
  return m_current ? &*m_current : nullptr;
}

std::vector<RunSummary> RunsPage::shownRuns() const {
  std::vector<RunSummary> runs;
  for (int row = 0; row < m_filter->rowCount(); ++row) {
    runs.push_back(m_model->row(m_filter->mapToSource(m_filter->index(row, 0)).row()));
  }
  return runs;
}

void RunsPage::showCount() {
  const auto all = m_model->rows().size();
  const auto shown = static_cast<std::size_t>(m_filter->rowCount());
  m_count->setText(shown == all ? tr("Runs: %1").arg(countText(all))
                                : tr("Runs: %1 of %2").arg(countText(shown), countText(all)));
  m_csv->setEnabled(shown > 0);
  QStringList lines;
  for (const UnreadableRunView& run : m_unreadableRuns) {
    lines.append(QStringLiteral("%1: %2").arg(run.file, run.reason));
  }
  constexpr qsizetype kLinesMax = 3;
  const qsizetype more = lines.size() - kLinesMax;
  if (more > 0) {
    lines = lines.mid(0, kLinesMax);
    lines.append(tr("Others that cannot be shown: %1").arg(more));
  }
  m_unreadable->setText(lines.join(QLatin1Char('\n')));
  m_unreadable->setVisible(!lines.isEmpty());
}

void RunsPage::showActions() {
  const bool isKept = m_current && !m_current->id.empty();
  if (!m_current) {
    m_title->setStatus(Status::Unknown,
                       m_model->rows().empty() ? tr("No run yet") : tr("No run is selected."));
  } else {
    m_title->setStatus(Status::Plain,
                       tr("%1, %2, version %3, %4")
                           .arg(startText(*m_current), text(m_current->programName),
                                text(m_current->programHash), machineText(*m_current)));
  }
  const bool hasRecording = m_hasDetail && !m_current->recording.empty();
  m_traces->setEnabled(hasRecording);
  m_traces->setToolTip(m_hasDetail && !hasRecording ? tr("The run was not recorded.") : QString());
  m_repeat->setEnabled(m_hasDetail && m_canRepeat);
  m_repeat->setToolTip(
      tr("Loads the program, compares it with the one of the run, and sets method "
         "and settings. Nothing starts."));
  const bool isLeft =
      isKept && m_resumable && m_current->runNumber == *m_resumable && m_current->runNumber != 0;
  m_resume->setEnabled(isLeft);
  m_resume->setToolTip(isLeft ? tr("Asks the control where the run was left. Nothing moves.")
                              : tr("Only a run that was left on the connected control, with its "
                                   "program loaded, can be resumed."));
  m_sheet->setEnabled(m_hasDetail);
  m_json->setEnabled(m_hasDetail);
}

QString RunsPage::suggestedFile(const QString& ending) const {
  const QString name = m_current && ending != QLatin1String("csv")
                           ? QStringLiteral("%1-%2").arg(
                                 QString::fromStdString(m_current->programName),
                                 startOf(*m_current).toString(QStringLiteral("yyyyMMdd-HHmmss")))
                           : QStringLiteral("runs");
  return name + QLatin1Char('.') + ending;
}

void RunsPage::retranslate() {
  fillMachines();
  m_model->refresh();
  showCount();
  showActions();
  fitColumns(*m_table);
}

void RunsPage::restyle() {
  m_model->setColors(palette());
}

}  // namespace rivulet::widgets
