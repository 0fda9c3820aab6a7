// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/program_panel.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/program/diagnostic_model.h"

namespace rivulet::widgets {

namespace {

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

}  // namespace

ProgramPanel::ProgramPanel(QWidget* parent)
    : Page(parent),
      m_open(makeTouchButton(this)),
      m_recent(makeTouchButton(this)),
      m_recentMenu(new QMenu(this)),
      m_name(makeValueLabel(this)),
      m_hash(makeValueLabel(this)),
      m_summary(new StatusLabel(this)),
      m_figuresGroup(new QGroupBox(this)),
      m_findingsGroup(new QGroupBox(this)),
      m_findings(new DiagnosticModel(this)),
      m_findingsTable(new QTableView(this)),
      m_finding(makeValueLabel(this)) {
  setAcceptDrops(true);
  setMinimumWidth(360);
  m_recent->setMenu(m_recentMenu);
  m_recentMenu->setToolTipsVisible(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_open, 1);
  buttons->addWidget(m_recent, 1);

  QFont nameFont = font();
  nameFont.setPointSizeF(13.0);
  nameFont.setBold(true);
  m_name->setFont(nameFont);
  m_name->setWordWrap(true);
  m_summary->setWordWrap(true);

  auto* figures = new QGridLayout(m_figuresGroup);
  figures->setHorizontalSpacing(16);
  figures->setVerticalSpacing(4);
  figures->setColumnStretch(1, 1);
  for (int row = 0; row < FigureCount; ++row) {
    auto* name = new QLabel(this);
    auto* value = makeValueLabel(this);
    value->setWordWrap(true);
    m_figureNames.push_back(name);
    m_figureValues.push_back(value);
    figures->addWidget(name, row, 0, Qt::AlignTop);
    figures->addWidget(value, row, 1);
  }

  m_findingsTable->setModel(m_findings);
  styleTable(m_findingsTable);
  m_findingsTable->setMinimumHeight(120);
  m_findingsTable->setColumnWidth(DiagnosticModel::SeverityColumn, 104);
  m_findingsTable->setColumnWidth(DiagnosticModel::Line, 56);
  m_findingsTable->setColumnWidth(DiagnosticModel::ColumnInLine, 60);
  m_findingsTable->horizontalHeader()->setStretchLastSection(true);
  auto* findings = new QVBoxLayout(m_findingsGroup);
  findings->addWidget(m_findingsTable, 1);
  findings->addWidget(m_finding);
  m_finding->setWordWrap(true);

  auto* layout = new QVBoxLayout(this);
  layout->addLayout(buttons);
  layout->addWidget(m_name);
  layout->addWidget(m_hash);
  layout->addWidget(m_summary);
  layout->addWidget(m_figuresGroup);
  layout->addWidget(m_findingsGroup, 1);

  connect(m_open, &QPushButton::clicked, this, &ProgramPanel::chooseFile);
  connect(m_findingsTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ProgramPanel::showFinding);
  retranslate();
  restyle();
}

void ProgramPanel::setProgram(std::shared_ptr<const gcode::Program> program) {
  m_program = std::move(program);
  m_findings->setProgram(m_program);
  m_findingsTable->selectRow(0);
  showProgram();
}

void ProgramPanel::setDistances(const std::optional<feasibility::ProgramDistances>& distances) {
  m_distances = distances;
  showDistances();
}

void ProgramPanel::setRecentFiles(const QStringList& paths) {
  m_recentFiles = paths;
  fillRecentMenu();
}

void ProgramPanel::setOpenEnabled(bool enabled) {
  m_openEnabled = enabled;
  setAcceptDrops(enabled);
  m_open->setEnabled(enabled);
  m_recent->setEnabled(enabled && !m_recentFiles.isEmpty());
}

void ProgramPanel::chooseFile() {
  const QString folder =
      m_recentFiles.isEmpty() ? QString() : QFileInfo(m_recentFiles.first()).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open an NC program"), folder,
      tr("NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.txt)") +
          QStringLiteral(";;") + tr("All files (*)"));
  if (!path.isEmpty()) {
    Q_EMIT openRequested(path);
  }
}

void ProgramPanel::retranslate() {
  m_open->setText(tr("Open…"));
  m_recent->setText(tr("Recent"));
  m_figuresGroup->setTitle(tr("Figures"));
  m_findingsGroup->setTitle(tr("Findings"));
  const auto name = [this](Figure figure, const QString& text) {
    m_figureNames[static_cast<std::size_t>(figure)]->setText(text);
  };
  name(Lines, tr("Lines"));
  name(Motions, tr("Motions"));
  name(Points, tr("Points"));
  name(BoundsX, QStringLiteral("X"));
  name(BoundsY, QStringLiteral("Y"));
  name(BoundsZ, QStringLiteral("Z"));
  name(CutLength, tr("Cutting path"));
  name(RapidLength, tr("Rapid path"));
  name(Feeds, tr("Feeds"));
  name(PointDistance, QStringLiteral("d<sub>min</sub>"));
  name(WindowLength, QStringLiteral("d<sub>min</sub><sup>N</sup>"));
  m_figureNames[PointDistance]->setToolTip(tr("Smallest distance of neighbouring points"));
  m_figureNames[WindowLength]->setToolTip(
      tr("Smallest path length of half a loop (N/2 points, rounded down)"));
  m_findings->retranslate();
  showFinding();
  fillRecentMenu();
  showProgram();
}

void ProgramPanel::restyle() {
  m_open->setIcon(themedIcon(QStringLiteral("open"), themeColors(palette()).text));
  m_findings->setColors(palette());
  setMuted(m_hash, palette());
  for (QLabel* name : m_figureNames) {
    setMuted(name, palette());
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

void ProgramPanel::showProgram() {
  const bool loaded = m_program != nullptr;
  m_name->setText(loaded ? QString::fromStdString(m_program->name) : tr("No program"));
  m_hash->setVisible(loaded);
  m_figuresGroup->setEnabled(loaded);
  std::vector<QString> values(FigureCount, noValue());
  if (!loaded) {
    m_summary->setStatus(Status::Unknown, tr("Drop a file here or press Open…"));
  } else {
    m_hash->setText(tr("Hash %1").arg(QString::fromStdString(m_program->hash)));
    std::array<std::size_t, 3> found{};
    for (const gcode::Diagnostic& diagnostic : m_program->diagnostics) {
      ++found[static_cast<std::size_t>(diagnostic.severity)];
    }
    const QString counts = tr("Errors: %1, warnings: %2, notes: %3")
                               .arg(countText(found[2]), countText(found[1]), countText(found[0]));
    if (found[2] > 0) {
      m_summary->setStatus(Status::Fault, tr("Cannot be streamed.") + QLatin1Char(' ') + counts);
    } else {
      m_summary->setStatus(found[1] > 0 ? Status::Attention : Status::Good, counts);
    }

    const gcode::Statistics& statistics = m_program->statistics;
    values[Lines] = countText(statistics.lines);
    values[Motions] = QStringLiteral("G0 %1 · G1 %2 · G2 %3 · G3 %4")
                          .arg(countText(statistics.motions[0]), countText(statistics.motions[1]),
                               countText(statistics.motions[2]), countText(statistics.motions[3]));
    values[Points] = countText(statistics.points);
    values[BoundsX] = boundsText(statistics.minMm.x, statistics.maxMm.x);
    values[BoundsY] = boundsText(statistics.minMm.y, statistics.maxMm.y);
    values[BoundsZ] = boundsText(statistics.minMm.z, statistics.maxMm.z);
    values[CutLength] = lengthText(statistics.cutLengthMm, 1);
    values[RapidLength] = lengthText(statistics.rapidLengthMm, 1);
    if (!statistics.feedsMmPerMin.empty()) {
      const double first = statistics.feedsMmPerMin.front();
      const double last = statistics.feedsMmPerMin.back();
      values[Feeds] = feedText(base::mmPerSFromMmPerMin(last));
      if (statistics.feedsMmPerMin.size() > 1) {
        values[Feeds] = tr("%1 … %2 (%3 values)")
                            .arg(numberText(first, first >= 10.0 ? 0 : 2), values[Feeds],
                                 countText(statistics.feedsMmPerMin.size()));
      }
    }
  }
  for (std::size_t figure = 0; figure < PointDistance; ++figure) {
    m_figureValues[figure]->setText(values[figure]);
  }
  showFinding();
  showDistances();
}

void ProgramPanel::showDistances() {
  const auto text = [](double lengthMm, const feasibility::Place& place) {
    const QString lines =
        place.firstLine == place.lastLine
            ? tr("line %1").arg(countText(place.lastLine.value))
            : tr("lines %1–%2")
                  .arg(countText(place.firstLine.value), countText(place.lastLine.value));
    return QStringLiteral("%1 (%2)").arg(lengthText(lengthMm), lines);
  };
  const bool known = m_program && m_distances;
  m_figureValues[PointDistance]->setText(
      known ? text(m_distances->pointDistanceMmMin, m_distances->pointDistancePlace) : noValue());
  m_figureValues[WindowLength]->setText(
      known && m_distances->windowSteps > 0
          ? text(m_distances->windowLengthMmMin, m_distances->windowPlace)
          : noValue());
}

void ProgramPanel::showFinding() {
  const QModelIndex row = m_findingsTable->currentIndex();
  m_finding->setText(row.isValid() ? row.siblingAtColumn(DiagnosticModel::Text).data().toString()
                                   : (m_program ? tr("No findings") : QString()));
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
