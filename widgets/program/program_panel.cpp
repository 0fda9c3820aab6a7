// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/program_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/units.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/program/diagnostic_model.h"
#include "widgets/program/distance_chart.h"
#include "widgets/program/reading_bar.h"

namespace rivulet::widgets {

namespace {

/// Corners of this many classes of 15 degrees and more are counted as sharp.
constexpr std::size_t kSharpClass = 3;

/// The first local file of a drag; empty if there is none.
QString localFile(const QMimeData* data) {
  const QList<QUrl> urls = data->urls();
  const auto found =
      std::find_if(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
  return found == urls.end() ? QString() : found->toLocalFile();
}

QString boundsText(double minMm, double maxMm) {
  if (!std::isfinite(minMm) || !std::isfinite(maxMm)) {
    return noValue();
  }
  return QStringLiteral("%1 … %2").arg(numberText(minMm, 3), lengthText(maxMm));
}

/// A line number to click on. @param lines  what is shown
QString linkTo(base::LineNumber line, const QString& lines) {
  // With its colour in the text: otherwise it keeps that of the theme it was first shown in.
  return QStringLiteral("<a href=\"%1\" style=\"color:%2\">%3</a>")
      .arg(QString::number(line.value), QApplication::palette().color(QPalette::Link).name(),
           lines);
}

}  // namespace

ProgramPanel::ProgramPanel(QWidget* parent)
    : Page(parent),
      m_recentMenu(new QMenu(this)),
      m_name(new ElidedLabel(1, this)),
      m_about(new ElidedLabel(1, this)),
      m_title(new QBoxLayout(QBoxLayout::LeftToRight)),
      m_tabs(new QTabWidget(this)),
      m_findings(new DiagnosticModel(this)),
      m_sorted(new QSortFilterProxyModel(this)),
      m_findingsTable(new QTableView(this)),
      m_acceptedArea(new QWidget(this)),
      m_acceptedRows(new QVBoxLayout(m_acceptedArea)) {
  setAcceptDrops(true);
  setMinimumWidth(360);
  m_recent->setMenu(m_recentMenu);
  m_recentMenu->setToolTipsVisible(true);

  QFont nameFont = font();
  nameFont.setPointSizeF(13.0);
  nameFont.setBold(true);
  m_name->setFont(nameFont);
  for (ElidedLabel* each : {m_name, m_about}) {
    each->setTextFormat(Qt::PlainText);
  }
  m_dialect->addItem(QString());
  for (std::size_t i = 0; i < gcode::kDialects.size(); ++i) {
    m_dialect->addItem(QString());
  }
  m_pages[Tab::Figures] = makeFigures();
  m_pages[Tab::Findings] = makeFindings();
  m_tabs->addTab(m_pages[Tab::Figures], QString());
  m_tabs->addTab(m_pages[Tab::Findings], QString());

  auto* names = inColumn({m_name, m_about});
  names->setSpacing(0);
  m_title->addLayout(names, 1);
  m_title->addLayout(inRow({m_open, m_recent, m_live}));
  inColumn({m_title, m_summary, {m_tabs, 1}}, this, QMargins(8, 4, 8, 2))->setSpacing(4);
  m_tabs->setDocumentMode(true);

  connect(m_findingsTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ProgramPanel::showFinding);
  const auto jump = [this] {
    // The text of a called file is not shown.
    if (const gcode::Diagnostic* finding = currentFinding(); finding && finding->file.empty()) {
      Q_EMIT lineChosen(finding->line.value);
    }
  };
  connect(m_findingsTable, &QTableView::clicked, this, jump);
  connect(m_findingsTable, &QTableView::activated, this, [this, jump] {
    jump();
    showTab(Tab::Text);
  });
  connect(m_dialect, &QComboBox::activated, this, [this](int index) {
    std::optional<gcode::Dialect> wanted;
    if (index > 0) {
      wanted = gcode::kDialects.at(static_cast<std::size_t>(index - 1));
    }
    if (wanted != m_reading.dialect) {
      Q_EMIT dialectRequested(wanted);
    }
  });
  retranslate();
  onTheme(
      [this] {
        m_findings->setColors(palette());
        setMuted(m_about, palette());
      },
      &ProgramPanel::showDistances);
}

QWidget* ProgramPanel::makeFigures() {
  auto* page = new QWidget;
  auto* figures = new QGridLayout(page);
  figures->setHorizontalSpacing(12);
  figures->setVerticalSpacing(4);
  figures->setColumnStretch(1, 1);
  figures->addWidget(label({.text = QT_TR_NOOP("Dialect"), .isMuted = true}), 0, 0);
  figures->addWidget(m_dialect, 0, 1);
  figures->addWidget(m_evidence, 1, 0, 1, 2);
  figures->addWidget(m_hash, 2, 0, 1, 2);
  constexpr std::array<const char*, FigureCount> kNames{QT_TR_NOOP("Lines"),
                                                        QT_TR_NOOP("Motions"),
                                                        QT_TR_NOOP("Points"),
                                                        QT_TR_NOOP("Units"),
                                                        nullptr,
                                                        nullptr,
                                                        nullptr,
                                                        QT_TR_NOOP("Cutting path"),
                                                        QT_TR_NOOP("Rapid path"),
                                                        QT_TR_NOOP("By kind"),
                                                        QT_TR_NOOP("Feeds"),
                                                        QT_TR_NOOP("Time, feeds as programmed"),
                                                        QT_TR_NOOP("Time, as streamed"),
                                                        nullptr,
                                                        nullptr,
                                                        QT_TR_NOOP("Distances"),
                                                        QT_TR_NOOP("Corners")};
  constexpr const char* kDistanceTip = QT_TR_NOOP("Smallest distance of neighbouring points");
  constexpr const char* kWindowTip =
      QT_TR_NOOP("Smallest path length of half a loop (N/2 points, rounded down)");
  constexpr int kFirstRow = 3;
  for (int figure = 0; figure < FigureCount; ++figure) {
    const int row = kFirstRow + figure;
    auto* value = this->value({.wraps = true});
    value->setTextFormat(Qt::RichText);
    value->setTextInteractionFlags(value->textInteractionFlags() | Qt::LinksAccessibleByMouse |
                                   Qt::LinksAccessibleByKeyboard);
    connect(value, &QLabel::linkActivated, this, &ProgramPanel::followLink);
    m_figureValues.push_back(value);
    m_figureNames.push_back(label({.text = kNames[static_cast<std::size_t>(figure)],
                                   .tip = figure == PointDistance  ? kDistanceTip
                                          : figure == WindowLength ? kWindowTip
                                                                   : nullptr,
                                   .isMuted = true,
                                   .wraps = true}));
    figures->addWidget(m_figureNames.back(), row, 0, Qt::AlignTop);
    figures->addWidget(value, row, 1);
  }
  // The same in every language.
  for (const auto& [figure, symbol] :
       {std::pair(BoundsX, "X"), std::pair(BoundsY, "Y"), std::pair(BoundsZ, "Z"),
        std::pair(PointDistance, "d<sub>min</sub>"),
        std::pair(WindowLength, "d<sub>min</sub><sup>N</sup>")}) {
    m_figureNames[figure]->setText(QLatin1String(symbol));
  }
  m_chart = new DistanceChart(page);
  figures->addWidget(label({.text = QT_TR_NOOP("Distances of neighbouring points, mm"),
                            .isMuted = true,
                            .wraps = true}),
                     kFirstRow + FigureCount, 0, 1, 2);
  figures->addWidget(m_chart, kFirstRow + FigureCount + 1, 0, 1, 2);
  figures->setRowStretch(kFirstRow + FigureCount + 2, 1);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  return scroll;
}

QWidget* ProgramPanel::makeFindings() {
  m_sorted->setSourceModel(m_findings);
  m_sorted->setSortRole(DiagnosticModel::kSortRole);
  m_findingsTable->setModel(m_sorted);
  styleTable(m_findingsTable);
  m_findingsTable->setSortingEnabled(true);
  m_findingsTable->sortByColumn(DiagnosticModel::Line, Qt::AscendingOrder);
  // Whole sentences; only the rows in sight are measured.
  m_findingsTable->setWordWrap(true);
  m_findingsTable->setTextElideMode(Qt::ElideNone);
  m_findingsTable->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_findingsTable->verticalHeader()->setResizeContentsPrecision(0);
  m_findingsTable->setMinimumHeight(70);
  m_findingsTable->setColumnWidth(DiagnosticModel::SeverityColumn, 100);
  m_findingsTable->setColumnWidth(DiagnosticModel::Line, 64);
  m_findingsTable->setColumnHidden(DiagnosticModel::ColumnInLine, true);  // the text shows where
  m_findingsTable->horizontalHeader()->setStretchLastSection(true);
  m_acceptedRows->setContentsMargins(0, 0, 0, 0);
  auto* page = new QWidget;
  inColumn({{m_findingsTable, 1}, m_finding, m_accept, m_acceptedArea}, page);
  return page;
}

void ProgramPanel::setTextPage(QWidget* page, QToolButton* find) {
  m_pages[Tab::Text] = page;
  m_tabs->setCornerWidget(find);
  connect(find, &QToolButton::clicked, this, [this] { showTab(Tab::Text); });
  m_tabs->insertTab(0, page, QString());
  m_tabs->setCurrentIndex(0);
}

void ProgramPanel::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  m_times.reset();
  if (m_program) {
    m_findings->setRows(m_program->program->diagnostics);
  } else {
    m_findings->clear();
  }
  m_findingsTable->selectRow(0);
  m_chart->setHistogram(m_program && m_program->statistics ? m_program->statistics->distances
                                                           : feasibility::DistanceHistogram{});
  showProgram();
  // Findings that prevent streaming are shown first.
  showTab(m_program && !m_program->program->isStreamable() ? Tab::Findings : Tab::Text);
}

void ProgramPanel::setReading(std::optional<gcode::Dialect> dialect,
                              const std::vector<std::string>& accepted,
                              gcode::CentreReading centres) {
  m_reading.dialect = dialect;
  m_reading.accepted = accepted;
  m_reading.centres = centres;
  showDialect();
  showAccepted();
}

void ProgramPanel::setDistances(const std::optional<feasibility::ProgramDistances>& distances) {
  m_distances = distances;
  showDistances();
}

void ProgramPanel::setTimes(std::shared_ptr<const overview::ProgramTimes> times) {
  m_times = std::move(times);
  showTimes();
}

void ProgramPanel::setRecentFiles(const QStringList& paths) {
  m_recentFiles = paths;
  fillRecentMenu();
}

void ProgramPanel::setOpenEnabled(bool enabled) {
  m_openEnabled = enabled;
  setAcceptDrops(enabled);
  m_open->setEnabled(enabled);
  m_live->setEnabled(enabled);
  m_recent->setEnabled(enabled && !m_recentFiles.isEmpty());
  m_dialect->setEnabled(enabled && m_program);
  m_acceptedArea->setEnabled(enabled);
  showFinding();
}

void ProgramPanel::chooseFile() {
  const QString folder =
      m_recentFiles.isEmpty() ? QString() : QFileInfo(m_recentFiles.first()).absolutePath();
  askForFile(this,
             {tr("Open an NC program"), folder,
              tr("NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap "
                 "*.cnc *.gcode *.h *.H *.txt)") +
                  QStringLiteral(";;") + tr("All files (*)")},
             [this](const QString& path) { Q_EMIT openRequested(path); });
}

void ProgramPanel::showTab(Tab tab) {
  m_tabs->setCurrentWidget(m_pages[tab] != nullptr ? m_pages[tab] : m_pages[Tab::Figures]);
}

void ProgramPanel::retranslate() {
  m_tabs->setTabText(m_tabs->indexOf(m_pages[Tab::Figures]), tr("Figures"));
  if (m_pages[Tab::Text] != nullptr) {
    m_tabs->setTabText(0, tr("Text"));
  }
  m_findings->refresh();
  showFinding();
  fillRecentMenu();
  showProgram();
  showAccepted();
}

void ProgramPanel::showProgram() {
  m_name->setText(m_program ? QString::fromStdString(m_program->program->name) : tr("No program"));
  m_about->setText(
      m_program ? tr("%Ln lines", nullptr, static_cast<int>(m_program->program->statistics.lines)) +
                      QStringLiteral(" \u00B7 ") + controlName(m_program->program->dialect)
                : QString());
  fitTitle();
  m_hash->setVisible(m_program != nullptr);
  showSummary();
  std::vector<QString> values(FigureCount, noValue());
  if (m_program) {
    fillFigures(values);
  }
  for (const Figure figure : {Lines, Motions, Points, Units, BoundsX, BoundsY, BoundsZ, CutLength,
                              RapidLength, Kinds, Feeds, Distances, Corners}) {
    m_figureValues[figure]->setText(values[figure]);
  }
  showFinding();
  showDistances();
  showTimes();
  showDialect();
}

/// Name and buttons stand side by side where the name has the room.
void ProgramPanel::fitTitle() {
  int besidePx = 0;
  for (const QPushButton* button : {m_open, m_recent, m_live}) {
    besidePx += button->sizeHint().width() + m_title->spacing();
  }
  int namePx = 0;
  for (const ElidedLabel* each : {m_name, m_about}) {
    namePx = std::max(namePx, each->fontMetrics().horizontalAdvance(each->text()));
  }
  const QMargins edges = layout()->contentsMargins();
  const bool isNarrow = width() - edges.left() - edges.right() - besidePx < namePx + 4;
  m_title->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void ProgramPanel::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  fitTitle();
}

void ProgramPanel::showSummary() {
  std::array<std::size_t, 3> found{};
  if (!m_program) {
    m_summary->setStatus(Status::Unknown, tr("Drop a file here or press Open…"));
  } else {
    const gcode::Program& program = *m_program->program;
    m_hash->setText(tr("Hash %1").arg(QString::fromStdString(program.hash)));
    for (const gcode::Diagnostic& diagnostic : program.diagnostics) {
      ++found[static_cast<std::size_t>(diagnostic.severity)];
    }
    const QString counts = tr("Errors: %1, warnings: %2, notes: %3")
                               .arg(countText(found[2]), countText(found[1]), countText(found[0]));
    if (found[2] > 0) {
      m_summary->setStatus(Status::Fault, tr("Cannot be streamed.") + QLatin1Char(' ') + counts);
    } else if (!program.isStreamable()) {
      m_summary->setStatus(
          Status::Fault,
          (program.trajectory.points.empty()
               ? tr("Cannot be streamed: no axis moves.")
               : tr("Cannot be streamed: it needs a transformation of the control.")) +
              QLatin1Char(' ') + counts);
    } else {
      m_summary->setStatus(found[1] > 0 ? Status::Attention : Status::Good, counts);
    }
  }
  m_summary->setVisible(m_summary->status() != Status::Good);  // the tab has the number of notes
  const std::size_t findings = found[0] + found[1] + found[2];
  m_tabs->setTabText(m_tabs->indexOf(m_pages[Tab::Findings]),
                     findings == 0 ? tr("Findings") : tr("Findings (%1)").arg(countText(findings)));
}

QString ProgramPanel::unitsText(gcode::FileUnits units) {
  switch (units) {
    case gcode::FileUnits::Unspecified:
      return tr("not stated");
    case gcode::FileUnits::Millimetres:
      return QStringLiteral("mm");
    case gcode::FileUnits::Inches:
      return tr("inch");
    case gcode::FileUnits::Mixed:
      return tr("mm and inch");
  }
  return {};
}

QString ProgramPanel::kindsText() const {
  QStringList kinds{tr("lines %1").arg(lengthText(m_program->lengths.lineMm, 1))};
  if (m_program->lengths.arcMm > 0.0) {
    kinds.append(tr("arcs %1").arg(lengthText(m_program->lengths.arcMm, 1)));
  }
  if (m_program->lengths.splineMm > 0.0) {
    kinds.append(tr("splines %1").arg(lengthText(m_program->lengths.splineMm, 1)));
  }
  return kinds.join(QStringLiteral(" · "));
}

QString ProgramPanel::feedsText(const std::vector<double>& feedsMmPerMin) const {
  if (feedsMmPerMin.empty()) {
    return noValue();
  }
  const double first = feedsMmPerMin.front();
  const QString last = feedText(base::mmPerSFromMmPerMin(feedsMmPerMin.back()));
  return feedsMmPerMin.size() == 1
             ? last
             : tr("%1 … %2 (%Ln values)", nullptr, static_cast<int>(feedsMmPerMin.size()))
                   .arg(numberText(first, first >= 10.0 ? 0 : 2), last);
}

void ProgramPanel::fillFigures(std::vector<QString>& values) const {
  const gcode::Program& program = *m_program->program;
  const gcode::Statistics& statistics = program.statistics;
  values[Lines] = countText(statistics.lines);
  values[Motions] = QStringLiteral("G0 %1 · G1 %2 · G2 %3 · G3 %4")
                        .arg(countText(statistics.motions[0]), countText(statistics.motions[1]),
                             countText(statistics.motions[2]), countText(statistics.motions[3]));
  const gcode::PointList& points = m_program->points;
  values[Points] = points.merged == 0
                       ? countText(points.points.size())
                       : tr("%1 (repetitions left out: %2)")
                             .arg(countText(points.points.size()), countText(points.merged));
  values[Units] = unitsText(program.facts.units);
  values[BoundsX] = boundsText(statistics.minMm.x, statistics.maxMm.x);
  values[BoundsY] = boundsText(statistics.minMm.y, statistics.maxMm.y);
  values[BoundsZ] = boundsText(statistics.minMm.z, statistics.maxMm.z);
  values[CutLength] = lengthText(statistics.cutLengthMm, 1);
  values[RapidLength] = lengthText(statistics.rapidLengthMm, 1);
  values[Kinds] = kindsText();
  values[Feeds] = feedsText(statistics.feedsMmPerMin);
  if (const auto& path = m_program->statistics) {
    values[Distances] =
        tr("median %1, largest %2")
            .arg(lengthText(path->distanceMmMedian), lengthText(path->distanceMmMax));
    const auto sharp = std::accumulate(path->angles.counts.begin() + kSharpClass,
                                       path->angles.counts.end(), std::size_t{0});
    values[Corners] = path->angles.degreesMax > 0.0
                          ? tr("%1 of 45° and more; sharpest %2° (%3)")
                                .arg(countText(sharp), numberText(path->angles.degreesMax, 0),
                                     linkTo(path->angles.line,
                                            tr("line %1").arg(countText(path->angles.line.value))))
                          : tr("none");
  }
}

void ProgramPanel::showDistances() {
  const auto text = [](double lengthMm, const feasibility::Place& place) {
    const QString lines =
        place.firstLine == place.lastLine
            ? tr("line %1").arg(countText(place.lastLine.value))
            : tr("lines %1–%2")
                  .arg(countText(place.firstLine.value), countText(place.lastLine.value));
    return QStringLiteral("%1 (%2)").arg(lengthText(lengthMm), linkTo(place.lastLine, lines));
  };
  const bool known = m_program && m_distances;
  m_figureValues[PointDistance]->setText(
      known ? text(m_distances->pointDistanceMmMin, m_distances->pointDistancePlace) : noValue());
  m_figureValues[WindowLength]->setText(
      known && m_distances->windowSteps > 0
          ? text(m_distances->windowLengthMmMin, m_distances->windowPlace)
          : noValue());
}

void ProgramPanel::showTimes() {
  const QString unknown =
      m_program && m_program->points.points.size() > 1 ? tr("computing …") : noValue();
  m_figureValues[ProgrammedTime]->setText(
      m_times ? tr("%1 without pauses").arg(durationText(m_times->programmedS)) : unknown);
  m_figureValues[StreamedTime]->setText(
      m_times && m_times->run
          ? tr("%1 with %Ln pauses, which cost %2", nullptr, static_cast<int>(m_times->run->pauses))
                .arg(durationText(m_times->run->totalS), durationText(m_times->run->pausesCostS()))
          : unknown);
  const QString machine =
      m_times ? tr("Computed with the axes of %1").arg(QString::fromStdString(m_times->machine))
              : QString();
  for (const Figure figure : {ProgrammedTime, StreamedTime}) {
    m_figureValues[figure]->setToolTip(machine);
    m_figureNames[figure]->setToolTip(machine);
  }
}

void ProgramPanel::showDialect() {
  m_dialect->setEnabled(m_openEnabled && m_program);
  m_dialect->setItemText(0, tr("as detected"));
  for (std::size_t i = 0; i < gcode::kDialects.size(); ++i) {
    m_dialect->setItemText(static_cast<int>(i) + 1, controlName(gcode::kDialects[i]));
  }
  int index = 0;
  if (m_reading.dialect) {
    const auto* at =
        std::find(gcode::kDialects.begin(), gcode::kDialects.end(), *m_reading.dialect);
    index = static_cast<int>(at - gcode::kDialects.begin()) + 1;
  }
  m_dialect->setCurrentIndex(index);
  m_evidence->setVisible(m_program != nullptr);
  if (m_program) {
    const QString dialect = controlName(m_program->program->dialect);
    const QString evidence = QString::fromStdString(m_program->program->dialectEvidence);
    m_evidence->setText(
        m_reading.dialect ? tr("Read as %1, as selected.").arg(dialect)
        : evidence.isEmpty()
            ? tr("Read as %1: the text gives no evidence of its dialect.").arg(dialect)
            : tr("Read as %1 because of \"%2\".").arg(dialect, evidence));
  }
}

void ProgramPanel::showAccepted() {
  while (QLayoutItem* item = m_acceptedRows->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const bool ordersCentres = m_reading.centres != gcode::CentreReading::AsProgrammed;
  m_acceptedArea->setVisible(!m_reading.accepted.empty() || ordersCentres);
  // A row is deleted while its button is still reporting, so the request is queued.
  if (ordersCentres) {
    const QString text = m_reading.centres == gcode::CentreReading::Absolute
                             ? tr("I, J, K are read as the centre itself")
                             : tr("I, J, K are read from the centre to the start");
    connect(
        addReadingRow(text, tr("Read I, J, K as usual")), &QPushButton::clicked, this,
        [this] { Q_EMIT centresRequested(gcode::CentreReading::AsProgrammed); },
        Qt::QueuedConnection);
  }
  for (const std::string& accepted : m_reading.accepted) {
    const QString name = QString::fromStdString(accepted);
    connect(
        addReadingRow(tr("Accepted: %1").arg(name), tr("Take back %1").arg(name)),
        &QPushButton::clicked, this, [this, name] { Q_EMIT takeBackRequested(name); },
        Qt::QueuedConnection);
  }
}

QPushButton* ProgramPanel::addReadingRow(const QString& text, const QString& accessibleName) {
  auto* row = new QWidget(m_acceptedArea);
  auto* label = new StatusLabel(row);
  label->setStatus(Status::Attention, text);
  label->setWordWrap(true);
  auto* back = makeTouchButton(row);
  back->setText(tr("Take back"));
  back->setAccessibleName(accessibleName);
  inRow({{label, 1}, back}, row, QMargins(0, 0, 0, 0));
  m_acceptedRows->addWidget(row);
  return back;
}

const gcode::Diagnostic* ProgramPanel::currentFinding() const {
  const QModelIndex row = m_findingsTable->currentIndex();
  if (!m_program || !row.isValid()) {
    return nullptr;
  }
  return &m_program->program->diagnostics.at(
      static_cast<std::size_t>(m_sorted->mapToSource(row).row()));
}

void ProgramPanel::showFinding() {
  const QModelIndex row = m_findingsTable->currentIndex();
  m_finding->setText(row.isValid() ? row.siblingAtColumn(DiagnosticModel::Text).data().toString()
                                   : (m_program ? tr("No findings") : QString()));
  const gcode::Diagnostic* finding = currentFinding();
  const bool isReading = finding != nullptr &&
                         finding->code == gcode::DiagnosticCode::CentreReading &&
                         m_program->program->facts.centreReading != m_reading.centres;
  m_accept->setVisible(isReading ||
                       (finding != nullptr && !gcode::acceptableName(*finding).empty()));
  m_accept->setEnabled(m_openEnabled);
  m_accept->setText(isReading ? tr("Read it that way") : tr("Accept…"));
  m_accept->setToolTip(isReading ? QString()
                                 : tr("The program is read again with this word left out"));
}

void ProgramPanel::askToAccept() {
  const gcode::Diagnostic* finding = currentFinding();
  if (finding == nullptr) {
    return;
  }
  if (finding->code == gcode::DiagnosticCode::CentreReading) {
    Q_EMIT centresRequested(m_program->program->facts.centreReading);
    return;
  }
  const QString name = QString::fromStdString(gcode::acceptableName(*finding));
  auto* box = new QMessageBox(
      QMessageBox::Warning, tr("Accept %1").arg(name),
      tr("Rivulet does not understand %1. If you accept it, it is left out wherever the program "
         "has it, and the path is taken as if it were not there.\n\nIs it certain that %1 does not "
         "change the path of the tool?")
          .arg(name),
      QMessageBox::Cancel);
  QPushButton* accept = box->addButton(tr("Accept and read again"), QMessageBox::AcceptRole);
  box->setDefaultButton(QMessageBox::Cancel);
  connect(accept, &QPushButton::clicked, this, [this, name] { Q_EMIT acceptRequested(name); });
  openSheet(box, this);
}

void ProgramPanel::followLink(const QString& link) {
  bool isNumber = false;
  const auto line = link.toULongLong(&isNumber);
  if (isNumber) {
    Q_EMIT lineChosen(static_cast<std::size_t>(line));
    showTab(Tab::Text);
  }
}

void ProgramPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (m_openEnabled && !localFile(event->mimeData()).isEmpty()) {
    event->acceptProposedAction();
    m_dropHovers = true;
    update();
  }
}

void ProgramPanel::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
  m_dropHovers = false;
  update();
}

void ProgramPanel::dropEvent(QDropEvent* event) {
  m_dropHovers = false;
  update();
  const QString path = localFile(event->mimeData());
  if (!path.isEmpty()) {
    event->acceptProposedAction();
    Q_EMIT fileDropped(path);
  }
}

void ProgramPanel::paintEvent(QPaintEvent* /*event*/) {
  if (m_dropHovers) {
    QPainter painter(this);
    painter.setPen(QPen(themeColors(palette()).accent, 3, Qt::DashLine));
    painter.drawRect(rect().adjusted(2, 2, -3, -3));
  }
}

void ProgramPanel::fillRecentMenu() {
  m_recentMenu->clear();
  for (const QString& path : m_recentFiles) {
    QAction* action = m_recentMenu->addAction(QFileInfo(path).fileName());
    action->setToolTip(path);
    connect(action, &QAction::triggered, this, [this, path] { Q_EMIT openRequested(path); });
  }
  m_recent->setEnabled(m_openEnabled && !m_recentFiles.isEmpty());
}

}  // namespace rivulet::widgets
