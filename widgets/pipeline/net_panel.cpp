// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/net_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/pipeline/choice_list.h"
#include "widgets/pipeline/net_canvas.h"
#include "widgets/plots/curve_chart.h"

namespace rivulet::widgets {

namespace {

using Kind = petri::PageNode::Kind;

constexpr std::array<int, 3> kCyclesMs{2, 10, 15};  ///< [P3], Figure 13
constexpr int kCycleFirst = 1;
constexpr std::array<int, 5> kFiringsPerS{1, 5, 25, 200, 2000};
constexpr int kSpeedFirst = 2;
constexpr double kUsPerMs = 1e3;
constexpr double kLevelsShownS = 0.1;  ///< at least, so that the axes do not jump at the beginning
constexpr double kLevelsShown = 5.0;
constexpr int kChartPxMin = 120;
constexpr int kChartWidthPxMin = 205;
constexpr int kTablePxMin = 110;
constexpr int kDetailLines = 4;

}  // namespace

NetPanel::NetPanel(QWidget* parent)
    : Page(parent),
      m_cycle(say(makeChoiceList("netCycle", this),
                  {.hint = QT_TR_NOOP("Cycle of position control; the net begins anew")})),
      m_policy(say(makeChoiceList("netPolicy", this),
                   {.hint = QT_TR_NOOP("Which task gets the processor; the net begins anew")})),
      m_pages(say(makeChoiceList("netPage", this), {.hint = QT_TR_NOOP("Page of the net")})),
      m_speed(say(makeChoiceList("netSpeed", this),
                  {.hint = QT_TR_NOOP("Transitions that fire in a second")})),
      m_note(say(new StatusLabel(this, StatusLabel::Elided{1}), {.id = "netNote"})),
      m_canvas(say(new NetCanvas(this),
                   {.tip = QT_TR_NOOP("A thick frame with a triangle: this transition could fire. "
                                      "Filled: it fires next. Thick lines: it fired last."),
                    .name = QT_TR_NOOP("Petri net"),
                    .id = "netCanvas"})),
      m_levels(say(new CurveChart(AxisScale::Even, AxisScale::Even, this), {.id = "netLevels"})),
      m_table(say(new QTableView(this),
                  {.hint = QT_TR_NOOP("Places of this page"), .id = "netPlaces"})),
      m_detail(say(new ElidedLabel(kDetailLines, this),
                   {.name = QT_TR_NOOP("What is chosen"), .id = "netDetail"})) {
  m_levels->setMinimumSize(kChartWidthPxMin, kChartPxMin);
  m_levels->setShown(QRectF(0.0, 0.0, kLevelsShownS, kLevelsShown));
  styleTable(m_table);
  m_places = new TableModel<PlaceRow>(
      {{[] { return tr("Place"); }, [](const PlaceRow& row) { return row.name; }},
       {[] { return tr("Tokens"); }, [](const PlaceRow& row) { return row.count; }, true},
       {[] { return tr("Values"); }, [](const PlaceRow& row) { return row.value; }}},
      this);
  m_table->setModel(m_places);
  m_table->setMinimumHeight(kTablePxMin);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);

  inColumn({inRow({m_cycle, m_policy, m_pages, m_follow, spring()}),
            inRow({m_step, m_play, m_restart, m_speed, {m_note, 1, Qt::AlignVCenter}}),
            {inRow({{m_canvas, 5}, {inColumn({{m_levels, 3}, {m_table, 3}, m_detail}), 3}}), 1}},
           this, QMargins(0, 0, 0, 0));
  m_canvas->setState(&m_state);
  connectParts();
  retranslate();
  onTheme([this] {
    m_canvas->update();
    m_levels->update();
  });
}

NetPanel::~NetPanel() = default;

void NetPanel::connectParts() {
  connect(m_cycle, &QComboBox::activated, this, &NetPanel::emitChoice);
  connect(m_policy, &QComboBox::activated, this, &NetPanel::emitChoice);
  connect(m_pages, &QComboBox::activated, this, &NetPanel::showPage);
  connect(m_canvas, &NetCanvas::pageRequested, this, &NetPanel::showPage);
  connect(m_canvas, &NetCanvas::selectionChanged, this, &NetPanel::showSelection);
  connect(m_play, &QPushButton::clicked, this,
          [this] { Q_EMIT playRequested(!m_state.isPlaying); });
  connect(m_speed, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedChosen(kFiringsPerS[static_cast<std::size_t>(index)]); });
  connect(m_follow, &QCheckBox::toggled, this, &NetPanel::showState);
  connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid() && m_table->hasFocus()) {
              m_canvas->select(m_places->row(current.row()).node);
            }
          });
}

void NetPanel::emitChoice() {
  Q_EMIT choiceChanged(NetChoice{kCyclesMs[static_cast<std::size_t>(m_cycle->currentIndex())],
                                 m_policy->currentIndex()});
}

void NetPanel::setState(NetState state) {
  m_state = std::move(state);
  m_canvas->refresh();
  showState();
}

void NetPanel::listPages() {
  const QSignalBlocker blocker(m_pages);
  m_listed = m_state.net.get();
  m_pages->clear();
  for (const petri::NetPage& page : m_state.net->pages) {
    m_pages->addItem(
        QString::fromStdString(page.path).split(QLatin1Char('.')).join(QStringLiteral(" › ")));
  }
  m_pages->setCurrentIndex(static_cast<int>(m_canvas->page()));
}

void NetPanel::showPage(int page) {
  m_canvas->setPage(static_cast<std::size_t>(page));
  m_pages->setCurrentIndex(page);
  showPlaces();
  showSelection();
}

void NetPanel::showState() {
  const bool isThere = m_state.net != nullptr;
  for (QWidget* part : {static_cast<QWidget*>(m_pages), static_cast<QWidget*>(m_follow),
                        static_cast<QWidget*>(m_restart)}) {
    part->setEnabled(isThere);
  }
  m_step->setEnabled(isThere && !m_state.isPlaying && m_state.next.has_value());
  m_play->setEnabled(isThere && (m_state.isPlaying || m_state.next.has_value()));
  m_play->setText(m_state.isPlaying ? tr("Pause") : tr("Play"));
  m_play->setAccessibleName(m_play->text());
  if (!isThere) {
    m_note->setStatus(Status::Unknown, tr("There is no net."));
    return;
  }
  if (m_listed != m_state.net.get()) {
    listPages();
  }
  if (m_follow->isChecked() && m_state.next) {
    const std::vector<petri::NetPage>& pages = m_state.net->pages;
    for (std::size_t i = 0; i < pages.size(); ++i) {
      const bool isHere = std::any_of(
          pages[i].nodes.begin(), pages[i].nodes.end(), [this](const petri::PageNode& node) {
            return node.kind == Kind::Transition && node.index == *m_state.next;
          });
      if (isHere && i != m_canvas->page()) {
        m_canvas->setPage(i);
        m_pages->setCurrentIndex(static_cast<int>(i));
      }
    }
  }
  const QString time = millisecondsText(static_cast<double>(m_state.now) / kUsPerMs, 3);
  const QString fired = countText(static_cast<std::size_t>(m_state.firings));
  m_note->setStatus(
      Status::Plain,
      m_state.next ? tr("%1, fired %2; next: %3")
                         .arg(time, fired,
                              QString::fromStdString(m_state.net->transitions[*m_state.next].name))
                   : tr("%1, fired %2; nothing more is played").arg(time, fired));
  std::vector<ChartCurve> curves;
  for (std::size_t i = 0; i < kShownBuffers; ++i) {
    curves.push_back({QStringLiteral("B%1").arg(i + 1), i, false, m_state.levels[i]});
  }
  m_levels->setCurves(std::move(curves));
  showPlaces();
  showSelection();
}

void NetPanel::showPlaces() {
  std::vector<PlaceRow> rows;
  const std::vector<petri::PageNode>& nodes = m_state.net->pages[m_canvas->page()].nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].kind != Kind::Place) {
      continue;
    }
    const petri::Place& place = m_state.net->places[nodes[i].index];
    const std::vector<petri::Token>& tokens = m_state.marking[nodes[i].index];
    QStringList values;
    for (const petri::Token& token : tokens) {
      const QString value =
          QString::fromStdString(m_state.net->textOf(place.colour, token.value.data()));
      if (!values.contains(value)) {
        values.append(value);
      }
    }
    rows.push_back({i, QString::fromStdString(nodes[i].name),
                    place.isObserver ? noValue() : countText(tokens.size()),
                    values.join(QStringLiteral("; "))});
  }
  // Replaced only where it differs, so that a row stays chosen.
  const auto& before = m_places->rows();
  const bool isSame = std::equal(before.begin(), before.end(), rows.begin(), rows.end(),
                                 [](const PlaceRow& a, const PlaceRow& b) {
                                   return a.node == b.node && a.name == b.name &&
                                          a.count == b.count && a.value == b.value;
                                 });
  if (!isSame) {
    const int chosen = m_table->currentIndex().row();
    m_places->setRows(rows);
    if (chosen >= 0 && chosen < m_places->rowCount()) {
      m_table->setCurrentIndex(m_places->index(chosen, 0));
    }
  }
}

void NetPanel::showSelection() {
  const auto node = m_canvas->selected();
  m_detail->setText(node ? m_canvas->textOf(*node)
                         : tr("Click a place or a transition: what it holds or needs is shown "
                              "here."));
}

void NetPanel::retranslate() {
  QStringList cycles;
  for (const int cycle : kCyclesMs) {
    cycles.append(tr("Cycle %1 ms").arg(cycle));
  }
  setChoices(m_cycle, cycles, kCycleFirst);
  setChoices(m_policy, {tr("Task dependency"), tr("Data flow")}, 0);
  QStringList speeds;
  for (const int speed : kFiringsPerS) {
    speeds.append(tr("%1 per s").arg(countText(static_cast<std::size_t>(speed))));
  }
  setChoices(m_speed, speeds, kSpeedFirst);
  m_levels->setTitles(tr("Levels of the buffers"), tr("Time of the net, s"), tr("Level"));
  m_places->refresh();
  showState();
}

}  // namespace rivulet::widgets
