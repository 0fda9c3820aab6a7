// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/trace_page.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QUrl>
#include <algorithm>
#include <iterator>
#include <optional>

#include "base/axes.h"
#include "base/units.h"
#include "trace/formula.h"
#include "trace/hdf5.h"
#include "trace/import/import_error.h"
#include "trace/signal_file.h"
#include "widgets/common/error_text.h"
#include "widgets/common/folding_tabs.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/common/trace_text.h"
#include "widgets/plots/legend_strip.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/compare_panel.h"
#include "widgets/scope/cursor_panel.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/signal_panel.h"
#include "widgets/scope/spectrum_panel.h"
#include "widgets/scope/trigger_panel.h"
#include "widgets/trace/columns_dialog.h"
#include "widgets/trace/layout_menu.h"
#include "widgets/trace/path_panel.h"
#include "widgets/trace/stop_model.h"

namespace rivulet::widgets {

namespace {

constexpr int kPanelPx = 350;
/// Narrower, panel and panes take turns.
constexpr int kBothPx = 660;
/// Narrower, the buttons show their icons alone.
constexpr int kTextPx = 820;
constexpr int kColumnPanes = 4;

QString pathFeed() {
  return QStringLiteral("per_min(path_speed)");
}

/// Files that are no NC programs.
bool isTraceFile(const QString& path) {
  static const QStringList suffixes{QStringLiteral("rivulet"), QStringLiteral("csv"),
                                    QStringLiteral("tsv"),     QStringLiteral("xml"),
                                    QStringLiteral("zst"),     QStringLiteral("trace"),
                                    QStringLiteral("dat"),     QStringLiteral("log"),
                                    QStringLiteral("h5"),      QStringLiteral("hdf5")};
  return suffixes.contains(QFileInfo(path).suffix().toLower());
}

QStringList traceFilesOf(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile() && isTraceFile(url.toLocalFile())) {
      paths.append(url.toLocalFile());
    }
  }
  return paths;
}

/// Asks for no more height than it needs: a page scrolls in a window that is lower than its hint.
class PageSplitter final : public QSplitter {
 public:
  using QSplitter::QSplitter;

  [[nodiscard]] QSize sizeHint() const override {
    return {QSplitter::sizeHint().width(), minimumSizeHint().height()};
  }
};

}  // namespace

TracePage::TracePage(QWidget* parent)
    : Page(parent),
      m_window(new TimeWindow(this)),
      m_curves(new ScopeCurves(this)),
      m_cursors(new ScopeCursors(this)),
      m_stops(new StopModel(this)),
      m_view(new ScopeView(m_curves, m_window, m_cursors, &m_stops->rows(), this)),
      m_layoutMenu(new LayoutMenu(this)),
      m_legend(new LegendStrip(this)),
      m_panel(new FoldingTabs(this)),
      m_signals(
          new SignalPanel([this](const QString& formula) { return m_view->shows(formula); }, this)),
      m_cursorPanel(new CursorPanel(m_curves, m_window, m_cursors, m_view, this)),
      m_pathPanel(new PathPanel(m_curves, m_window, m_cursors, m_view, this)),
      m_comparePanel(new ComparePanel(m_curves, m_window, m_cursors, m_view, this)),
      m_spectrumPanel(new SpectrumPanel(m_curves, m_window, m_cursors, m_view, this)),
      m_triggerPanel(new TriggerPanel(m_curves, m_window, m_cursors, this)),
      m_table(say(new QTableView(this), {.name = QT_TR_NOOP("Stops"), .id = "stopTable"})) {
  setAcceptDrops(true);
  m_layout->setMenu(m_layoutMenu);
  m_panel->tabs()->setObjectName(QStringLiteral("tracePanel"));
  m_live->setCheckable(true);
  m_live->setChecked(true);
  m_list->setCheckable(true);
  m_panel->addPage(makeStopPanel());
  m_panel->addPage(m_signals);
  m_panel->addPage(m_cursorPanel);
  m_panel->addPage(m_pathPanel);
  m_panel->addPage(m_comparePanel);
  m_panel->addPage(m_spectrumPanel);
  m_panel->addPage(m_triggerPanel);
  layOut();

  connect(m_live, &QPushButton::clicked, m_window, &TimeWindow::goLive);
  connect(m_all, &QPushButton::clicked, m_window, &TimeWindow::showAll);
  connect(m_layoutMenu, &LayoutMenu::showRequested, this, &TracePage::showLayout);
  connect(m_layoutMenu, &LayoutMenu::keepRequested, this, &TracePage::keepLayout);
  connect(m_layoutMenu, &LayoutMenu::deleteRequested, this, [this](const QString& name) {
    ScopeLayouts layouts = m_layoutMenu->layouts();
    layouts.remove(name);
    layouts.standard = layouts.standard == name ? QString() : layouts.standard;
    changeLayouts(std::move(layouts));
  });
  connect(m_layoutMenu, &LayoutMenu::standardRequested, this, [this](const QString& name) {
    ScopeLayouts layouts = m_layoutMenu->layouts();
    layouts.standard = name;
    changeLayouts(std::move(layouts));
  });
  connect(m_list, &QPushButton::clicked, this, [this](bool wanted) {
    m_wantsPanel = wanted;
    showPanel();
  });
  connect(m_window, &TimeWindow::changed, this, [this] { m_live->setChecked(m_window->isLive()); });
  connect(m_curves, &ScopeCurves::failed, this,
          [this](const QString&, const base::Error& error) { m_signals->showFormulaError(error); });
  connect(m_curves, &ScopeCurves::axisChanged, this, &TracePage::followAxis);
  connect(m_view, &ScopeView::changed, m_signals, &SignalPanel::refresh);
  connect(m_signals, &SignalPanel::columnsRequested, this, &TracePage::askForColumns);
  connect(m_signals, &SignalPanel::paneRequested, m_view, &ScopeView::addPane);
  connect(m_signals, &SignalPanel::addRequested, m_view, &ScopeView::addToPane);
  connect(m_signals, &SignalPanel::removeRequested, m_view, &ScopeView::removeSignal);
  connect(m_table, &QTableView::clicked, this,
          [this](const QModelIndex& index) { goToStop(index.row()); });
  connect(m_table, &QTableView::activated, this,
          [this](const QModelIndex& index) { goToStop(index.row()); });
  m_curves->startLive();
  m_signals->setOffers(m_curves->offers());
  arrange();
  retranslate();
  onTheme(&TracePage::showLegend);
}

TracePage::~TracePage() = default;

QWidget* TracePage::makeStopPanel() {
  auto* panel = new QWidget(this);
  m_table->setModel(m_stops);
  styleTable(m_table);
  m_table->setMinimumHeight(100);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setResizeContentsPrecision(50);  // not all of a long run
  auto* summary = new QGridLayout;
  summary->setHorizontalSpacing(16);
  summary->setColumnStretch(1, 1);
  int row = 0;
  for (const char* name : {QT_TR_NOOP("Number"), QT_TR_NOOP("Mean"), QT_TR_NOOP("Total")}) {
    QLabel*& figure = m_summaryValues[static_cast<std::size_t>(row)];
    figure = value();
    summary->addWidget(label({.text = name, .isMuted = true}), row, 0);
    summary->addWidget(figure, row++, 1);
  }
  inColumn({summary, {m_table, 1}, m_legend}, panel, QMargins(4, 6, 4, 4));
  return panel;
}

void TracePage::layOut() {
  m_panel->setMinimumWidth(kPanelPx);
  auto* body = new PageSplitter(Qt::Horizontal, this);
  body->setObjectName(QStringLiteral("traceBody"));
  body->setChildrenCollapsible(false);
  body->setHandleWidth(6);
  body->addWidget(m_view);
  body->addWidget(m_panel);
  // A wide page has room for whole causes.
  body->setStretchFactor(0, 3);
  body->setStretchFactor(1, 1);
  body->setSizes({3 * kPanelPx, kPanelPx});
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(
      inRow({{m_note, 1, Qt::AlignVCenter}, m_open, m_save, m_layout, m_live, m_all, m_list}));
  layout->addWidget(body, 1);
}

void TracePage::setRunner(WorkRunner runner) {
  m_curves->setRunner(std::move(runner));
}

void TracePage::clear() {
  m_curves->startLive();
  m_signals->setTables({});
  m_signals->setOffers(m_curves->offers());
  m_cursors->set(ScopeCursors::A, std::nullopt);
  m_cursors->set(ScopeCursors::B, std::nullopt);
  setStops({});
  m_source = Source::Nothing;
  m_past.start.clear();
  m_news.reading.clear();
  m_news.problem.clear();
  m_news.saved.clear();
  m_live->setEnabled(true);
  m_window->clear();
  m_triggerPanel->restart();
  arrange();
  showNote();
}

void TracePage::append(const TraceSample& sample) {
  if (m_source != Source::Live) {
    m_source = Source::Live;
    showNote();
  }
  m_window->setEnd(sample.atS);
  if (sample.positionMm) {
    appendValue(QStringLiteral("x_act"), sample.atS, sample.positionMm->x);
    appendValue(QStringLiteral("y_act"), sample.atS, sample.positionMm->y);
    appendValue(QStringLiteral("z_act"), sample.atS, sample.positionMm->z);
  }
  if (sample.feedMmPerS) {
    appendValue(pathFeed(), sample.atS, base::mmPerMinFromMmPerS(*sample.feedMmPerS));
  }
  m_view->scheduleRedraw();
}

void TracePage::appendValue(const QString& formula, double atS, double value) {
  m_curves->appendLive(formula, atS, value);
  m_triggerPanel->sample(formula, atS, value);
}

void TracePage::noticeAlarm() {
  if (m_source == Source::Live) {
    m_triggerPanel->happened(trace::TriggerEvent::Alarm, m_window->endS(), m_window->endS());
  }
}

void TracePage::finishLive() {
  m_triggerPanel->finish();
}

void TracePage::addPause(const trace::Pause& pause) {
  const QScrollBar* bar = m_table->verticalScrollBar();
  const bool atEnd = bar->value() >= bar->maximum();
  m_stops->append(stopRow(pause));
  m_stopTotal += pause.duration;
  if (atEnd) {
    m_table->scrollToBottom();
  }
  showSummary();
  m_view->scheduleRedraw();
  const double atS = base::toSeconds(pause.start.time_since_epoch());
  m_triggerPanel->happened(trace::TriggerEvent::PauseBegins, atS, std::max(m_window->endS(), atS));
}

void TracePage::showTraces(const ScopeCurves::Traces& traces, Source source) {
  const ScopeCurves::Traces& before = m_curves->traces();
  bool isSame = !traces.empty() && before.size() == traces.size() && m_source == source;
  for (std::size_t i = 0; isSame && i < traces.size(); ++i) {
    isSame = before[i]->name == traces[i]->name && before[i]->length == traces[i]->length &&
             traces[i]->isAnalysed;
  }
  m_source = source;
  m_news.reading.clear();
  const trace::RunAxis axis = isSame ? m_curves->wantedAxis() : trace::RunAxis::Time;
  m_curves->setTraces(traces);
  m_signals->setOffers(m_curves->offers());
  m_live->setEnabled(false);
  std::vector<StopRow> stops;
  base::Duration length{};
  for (const auto& trace : traces) {
    length = std::max(length, trace->length);
  }
  if (!traces.empty()) {
    // Of several traces, the bands of the first one: they would lie on top of each other.
    const trace::ShownTrace& first = *traces.front();
    if (first.isObserved) {
      std::transform(first.pauses.begin(), first.pauses.end(), std::back_inserter(stops),
                     [](const trace::Pause& pause) { return stopRow(pause); });
    } else {
      std::transform(first.stops.begin(), first.stops.end(), std::back_inserter(stops),
                     [](const trace::Standstill& stop) { return stopRow(stop); });
    }
  }
  if (!isSame) {
    m_cursors->set(ScopeCursors::A, std::nullopt);
    m_cursors->set(ScopeCursors::B, std::nullopt);
    m_window->setLength(base::toSeconds(length));
    arrange();
  }
  setStops(std::move(stops));
  if (axis != trace::RunAxis::Time) {
    m_curves->setAxis(axis);
  }
  showNote();
  showTables();
}

void TracePage::showTables() {
  QStringList names;
  int unclear = -1;
  for (const auto& trace : m_curves->traces()) {
    const QString layout = QString::fromStdString(trace->tableLayout);
    if (trace->table.columns.empty()) {
      continue;
    }
    if (!trace->table.isCertain && !m_asked.contains(layout)) {
      m_asked.append(layout);  // once: who has said no is not asked again
      unclear = static_cast<int>(names.size());
    }
    names.append(QString::fromStdString(trace->name));
  }
  m_signals->setTables(names);
  if (unclear >= 0) {
    askForColumns(unclear);
  }
}

void TracePage::askForColumns(int table) {
  for (const auto& trace : m_curves->traces()) {
    if (trace->table.columns.empty() || table-- > 0) {
      continue;
    }
    if (m_columns != nullptr) {
      return;
    }
    auto* dialog = new ColumnsDialog(QString::fromStdString(trace->name), trace->table, nullptr);
    m_columns = dialog;
    connect(dialog, &QDialog::accepted, this, [this, dialog, layout = trace->tableLayout] {
      Q_EMIT mappingChosen(layout, dialog->mapping());
    });
    openSheet(dialog, this);
    return;
  }
}

void TracePage::followAxis() {
  m_cursors->set(ScopeCursors::A, std::nullopt);
  m_cursors->set(ScopeCursors::B, std::nullopt);
  m_window->setLength(m_curves->axisEnd());
  setStops(m_stops->rows());
}

/// The operator's layout of new traces, or the present panes if each still has something to show.
void TracePage::arrange() {
  std::vector<QString> known;
  for (const trace::SignalOffer& offer : m_curves->offers()) {
    known.push_back(QString::fromStdString(offer.formula));
  }
  const auto isKnown = [&known](const QString& formula) {
    return std::find(known.begin(), known.end(), formula) != known.end();
  };
  const auto fits = [this](const std::vector<QStringList>& panes) {
    return !panes.empty() && std::all_of(panes.begin(), panes.end(), [this](const auto& pane) {
      return std::any_of(pane.begin(), pane.end(),
                         [this](const QString& formula) { return canShow(formula); });
    });
  };
  const ScopeLayouts& kept = m_layoutMenu->layouts();
  const ScopeLayout* standard = kept.find(kept.standard);
  if (standard != nullptr && fits(standard->panes)) {
    showLayout(standard->name);
    return;
  }
  if (fits(m_view->arrangement())) {
    m_view->scheduleRedraw();
    return;
  }
  std::vector<QStringList> panes;
  for (const char axis : base::kAxisNames) {
    const QString letter = QString(QLatin1Char(axis)).toLower();
    for (const QString& name : {letter + QStringLiteral("_act"), letter + QStringLiteral("_set")}) {
      if (isKnown(name) && panes.size() <= static_cast<std::size_t>(axis - 'X')) {
        panes.push_back({name});
      }
    }
  }
  if (isKnown(pathFeed())) {
    panes.push_back({pathFeed()});
  }
  for (std::size_t i = 0; i < known.size() && panes.size() < kColumnPanes && !isKnown(pathFeed());
       ++i) {
    panes.push_back({known[i]});
  }
  m_view->setArrangement(panes);
}

void TracePage::setStops(std::vector<StopRow> stops) {
  m_stopTotal = {};
  for (StopRow& stop : stops) {
    m_stopTotal += stop.duration;
    stop.fromAxis = m_curves->placeOnAxis(0, base::toSeconds(stop.start));
    stop.toAxis = m_curves->placeOnAxis(0, base::toSeconds(stop.start + stop.duration));
  }
  m_stops->setRows(std::move(stops));
  m_view->scheduleRedraw();
  showSummary();
}

void TracePage::goToStop(int row) {
  const StopRow& stop = m_stops->row(row);
  m_window->reveal(stop.fromAxis);
  m_cursors->set(ScopeCursors::A, stop.fromAxis);
  m_cursors->set(ScopeCursors::B, stop.toAxis);
}

QStringList TracePage::traceNames() const {
  QStringList names;
  for (const auto& trace : m_curves->traces()) {
    names.append(QString::fromStdString(trace->name));
  }
  return names;
}

bool TracePage::canShow(const QString& formula) const {
  const std::string text = formula.toStdString();
  const auto offers = m_curves->offers();
  if (std::any_of(offers.begin(), offers.end(),
                  [&text](const auto& offer) { return offer.formula == text; })) {
    return true;
  }
  const auto parsed = trace::Formula::parse(text);
  const ScopeCurves::Traces& traces = m_curves->traces();
  return parsed && std::any_of(traces.begin(), traces.end(), [&parsed](const auto& trace) {
           return std::all_of(parsed->names().begin(), parsed->names().end(),
                              [&trace](const std::string& name) {
                                return trace->signalSet.find(name) != nullptr;
                              });
         });
}

void TracePage::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_pathPanel->setProgram(std::move(view));
}

void TracePage::setLayouts(ScopeLayouts layouts) {
  m_layoutMenu->setLayouts(std::move(layouts));
  arrange();
}

const ScopeLayouts& TracePage::layouts() const {
  return m_layoutMenu->layouts();
}

void TracePage::changeLayouts(ScopeLayouts layouts) {
  m_layoutMenu->setLayouts(std::move(layouts));
  Q_EMIT layoutsChanged(m_layoutMenu->layouts());
}

void TracePage::showLayout(const QString& name) {
  if (const ScopeLayout* layout = m_layoutMenu->layouts().find(name)) {
    const QList<int> heights = layout->heights;
    m_view->setArrangement(layout->panes);
    m_view->setHeights(heights);
  }
}

void TracePage::keepLayout(const QString& name) {
  ScopeLayouts layouts = m_layoutMenu->layouts();
  layouts.keep({name, m_view->arrangement(), m_view->heights()});
  changeLayouts(std::move(layouts));
}

void TracePage::chooseFileToSave() {
  struct Choice {
    QString suffix;
    QString filter;
  };
  std::vector<Choice> choices;
  const auto offer = [&choices](const QString& what, const QString& suffix) {
    choices.push_back({suffix, what + QStringLiteral(" (*.%1)").arg(suffix)});
  };
  offer(tr("Samples as a table"), QStringLiteral("csv"));
  if (trace::hasHdf5()) {
    offer(tr("Samples and events as HDF5"), QStringLiteral("h5"));
  }
  for (const char* suffix : {"png", "svg", "pdf"}) {
    offer(tr("Picture"), QLatin1String(suffix));
  }
  QStringList filters;
  for (const Choice& choice : choices) {
    filters.append(choice.filter);
  }
  askWhereToSave(this, {tr("Save what the panes show"), {}, filters.join(QStringLiteral(";;"))},
                 [this, choices, filters](QString path, const QString& chosen) {
                   const QString suffix = QFileInfo(path).suffix().toLower();
                   const bool isKnown =
                       trace::isSignalFile(path.toStdString()) ||
                       std::any_of(choices.begin(), choices.end(), [&suffix](const Choice& choice) {
                         return choice.suffix == suffix;
                       });
                   if (!isKnown) {
                     const auto choice = std::max<qsizetype>(0, filters.indexOf(chosen));
                     path += QLatin1Char('.') + choices[static_cast<std::size_t>(choice)].suffix;
                   }
                   save(path);
                 });
}

void TracePage::save(const QString& path) {
  if (trace::isSignalFile(path.toStdString())) {
    saveSignals(path);
    return;
  }
  const bool isSaved = m_view->savePicture(path, traceNames().join(QStringLiteral(", ")));
  showSaved(path, isSaved ? QString() : cannotBeWritten(path));
}

QString TracePage::cannotBeWritten(const QString& path) {
  return tr("%1 cannot be written. Choose another folder.").arg(path);
}

void TracePage::saveSignals(const QString& path) {
  trace::SignalFile file;
  for (const QStringList& pane : m_view->arrangement()) {
    for (const QString& formula : pane) {
      std::size_t index = m_curves->showsDifferences() ? 1 : 0;
      for (const ScopeCurves::Curve& curve : m_curves->curves(formula)) {
        // The formula instead of a title: whoever reads the table next need not know the language.
        QString name = formula;
        if (m_curves->traces().size() > 1) {
          name += QLatin1Char(' ') + traceNames().value(static_cast<qsizetype>(index));
          name += m_curves->showsDifferences() ? QStringLiteral(" - ") + traceNames().first()
                                               : QString();
        }
        ++index;
        if (curve.samples && !curve.samples->empty()) {
          file.exported.push_back(
              {name.toStdString(), m_curves->unit(formula).toStdString(), curve.samples});
        }
      }
    }
  }
  file.from = instantOf(m_window->fromS());
  file.to = instantOf(m_window->toS());
  const trace::RunAxis axis = m_curves->axis();
  if (axis != trace::RunAxis::Time) {
    file.timeName = trace::runAxisName(axis);
  } else if (!m_curves->traces().empty()) {
    file.events = m_curves->traces().front()->events;  // as the bands
  }
  file.timeUnit = trace::runAxisUnit(axis);
  const auto write = [file = std::move(file), path] {
    const auto done = trace::saveSignals(path.toStdString(), file);
    // The sentence is made on the GUI thread.
    return done ? std::optional<base::Error>() : std::optional(done.error());
  };
  const auto show = [this, path](const std::optional<base::Error>& error) {
    const bool isHdf5Missing = error && error->code == trace::ImportError::NoHdf5;
    showSaved(path, !error ? QString() : isHdf5Missing ? errorText(*error) : cannotBeWritten(path));
  };
  if (m_curves->isLive()) {
    show(write());  // samples are appended meanwhile
    return;
  }
  m_curves->run([self = QPointer(this), show, write]() -> std::function<void()> {
    const auto error = write();
    return [self, show, error] {
      if (self) {
        show(error);
      }
    };
  });
}

void TracePage::showSaved(const QString& path, const QString& problem) {
  m_news.saved = problem.isEmpty() ? QFileInfo(path).fileName() : QString();
  m_news.problem = problem;
  showNote();
}

void TracePage::showReading(const QStringList& names) {
  m_news.saved.clear();
  m_news.reading = names;
  m_news.problem.clear();
  showNote();
}

void TracePage::showProblem(const QString& sentence) {
  m_news.reading.clear();
  m_news.problem = sentence;
  showNote();
}

void TracePage::chooseFiles() {
  askForFiles(
      this,
      {tr("Open traces"),
       {},
       tr("Traces") +
           QStringLiteral(" (*.rivulet *.csv *.tsv *.txt *.xml *.h5 *.hdf5 *.zst *.dat *.log);;") +
           tr("All files") + QStringLiteral(" (*)")},
      [this](const QStringList& paths) { Q_EMIT openRequested(paths); });
}

void TracePage::dragEnterEvent(QDragEnterEvent* event) {
  if (!traceFilesOf(event->mimeData()).isEmpty()) {
    event->acceptProposedAction();
  }
}

void TracePage::dropEvent(QDropEvent* event) {
  const QStringList paths = traceFilesOf(event->mimeData());
  if (!paths.isEmpty()) {
    event->acceptProposedAction();
    Q_EMIT openRequested(paths);
  }
}

void TracePage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  showPanel();
}

void TracePage::showPanel() {
  const bool hasRoom = width() >= kBothPx;
  const bool isOpen = m_wantsPanel.value_or(hasRoom);
  m_panel->setVisible(isOpen);
  m_view->setVisible(hasRoom || !isOpen);
  m_list->setChecked(isOpen);
  const bool hasTexts = width() >= kTextPx;
  m_open->setText(hasTexts ? tr("Open…") : QString());
  m_live->setText(hasTexts ? tr("Live") : QString());
  m_all->setText(hasTexts ? tr("Show all") : QString());
  m_list->setText(hasTexts ? tr("List") : QString());
  m_layout->setText(hasTexts ? tr("Panes") : QString());
  m_save->setText(hasTexts ? tr("Save…") : QString());
}

void TracePage::redrawNow() {
  m_view->redrawNow();
  m_cursorPanel->refreshNow();
  m_pathPanel->redrawNow();
  m_comparePanel->refreshNow();
  m_spectrumPanel->refreshNow();
}

void TracePage::retranslate() {
  m_panel->setTexts({tr("Stops"), tr("Signals"), tr("Cursors"), tr("Path"), tr("Compare"),
                     tr("Spectrum"), tr("Trigger")},
                    tr("Shown beside the panes"));
  m_stops->refresh();
  m_view->scheduleRedraw();
  showPanel();
  showNote();
  showSummary();
  showLegend();
}

void TracePage::setPastRun(const QString& start, const QString& program) {
  m_past.start = start;
  m_past.program = program;
  showNote();
}

QString TracePage::liveText() const {
  return tr(
      "Live samples: read while the stream has time; short pauses "
      "may be missing from the curves");
}

QString TracePage::tracesText() const {
  const ScopeCurves::Traces& traces = m_curves->traces();
  if (traces.empty()) {
    return {};
  }
  QString text;
  if (m_source == Source::Control && traces.front()->isObserved) {
    text = liveText();
  } else if (m_source == Source::Control) {
    text = tr("The control's own trace: one sample every %1")
               .arg(millisecondsText(traces.front()->step, 0));
  } else {
    text = traceNames().join(QStringLiteral(", "));
    if (traces.size() == 1 && traces.front()->step.count() > 0) {
      text = tr("%1: one sample every %2").arg(text, millisecondsText(traces.front()->step));
    }
  }
  if (!traces.front()->isAnalysed) {
    text += QStringLiteral(". ") + tr("Looking for stops …");
  }
  QStringList remarks;
  for (const auto& trace : traces) {
    for (const trace::Remark& remark : trace->remarks) {
      remarks.append(traceRemarkText(remark));
    }
  }
  m_note->setToolTip(remarks.join(QLatin1Char('\n')));
  if (!remarks.isEmpty()) {
    text += QStringLiteral(" · ") + remarks.first();
  }
  if (remarks.size() > 1) {
    // The tool tip has all of them.
    text += QStringLiteral(" (+%1)").arg(remarks.size() - 1);
  }
  return text;
}

void TracePage::showNote() {
  if (!m_news.reading.isEmpty()) {
    m_note->setStatus(Status::Busy,
                      tr("Reading %1 …").arg(m_news.reading.join(QStringLiteral(", "))));
    return;
  }
  if (!m_news.problem.isEmpty()) {
    const QString shown = tracesText();
    m_note->setStatus(Status::Attention, shown.isEmpty()
                                             ? m_news.problem
                                             : m_news.problem + QStringLiteral(" · ") + shown);
    return;
  }
  if (!m_news.saved.isEmpty()) {
    m_note->setStatus(Status::Good,
                      tr("Saved: %1").arg(m_news.saved) + QStringLiteral(" · ") + tracesText());
    return;
  }
  const QString of =
      m_past.start.isEmpty() ? QString() : tr("Run of %1, %2. ").arg(m_past.start, m_past.program);
  switch (m_source) {
    case Source::Nothing:
      m_note->setStatus(Status::Unknown, of + tr("No samples yet"));
      break;
    case Source::Live:
      m_note->setStatus(of.isEmpty() ? Status::Busy : Status::Unknown, of + liveText());
      break;
    case Source::Control:
    case Source::Files: {
      const ScopeCurves::Traces& traces = m_curves->traces();
      const bool hasRemarks = std::any_of(traces.begin(), traces.end(),
                                          [](const auto& one) { return !one->remarks.empty(); });
      m_note->setStatus(hasRemarks ? Status::Attention : Status::Good, of + tracesText());
      break;
    }
  }
}

void TracePage::showSummary() {
  const std::size_t count = m_stops->rows().size();
  m_summaryValues[0]->setText(countText(count));
  m_summaryValues[1]->setText(count == 0 ? noValue()
                                         : millisecondsText(base::toMilliseconds(m_stopTotal) /
                                                            static_cast<double>(count)));
  m_summaryValues[2]->setText(secondsText(base::toSeconds(m_stopTotal), 2));
}

void TracePage::showLegend() {
  std::vector<LegendEntry> entries;
  for (const trace::PauseOrigin origin :
       {trace::PauseOrigin::Measured, trace::PauseOrigin::Inferred,
        trace::PauseOrigin::Predicted}) {
    entries.push_back({LegendEntry::Symbol::Fill, QPen(themeColors(palette()).line, 1),
                       pauseBrush(origin, palette()),
                       tr("%1: pause %2").arg(pauseOriginLetter(origin), pauseOriginText(origin))});
  }
  m_legend->setEntries(std::move(entries));
}

}  // namespace rivulet::widgets
