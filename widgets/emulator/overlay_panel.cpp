// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/emulator/overlay_panel.h"

#include <QComboBox>
#include <QSplitter>
#include <algorithm>
#include <utility>

#include "base/axes.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/path_pane.h"
#include "widgets/scope/scope_view.h"

namespace rivulet::widgets {

namespace {

constexpr int kFirstEnlargement = 3;
/// Wider, the path is beside the panes.
constexpr int kBesidePx = 700;

}  // namespace

OverlayPanel::OverlayPanel(QWidget* parent)
    : Page(parent),
      m_window(new TimeWindow(this)),
      m_curves(new ScopeCurves(this)),
      m_cursors(new ScopeCursors(this)),
      m_view(new ScopeView(m_curves, m_window, m_cursors, &m_noStops, this)),
      m_path(say(new PathPane(m_curves, m_window, m_cursors, this), {.id = "emulatorPath"})),
      m_body(say(new QSplitter(Qt::Horizontal, this), {.id = "emulatorOverlayBody"})) {
  for (QComboBox* list : {m_run, m_enlargement}) {
    list->setMinimumHeight(kTouchHeightPx);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(9);
  }
  for (const double factor : PathPane::kEnlargements) {
    m_enlargement->addItem(QString(), factor);
  }
  m_enlargement->setCurrentIndex(kFirstEnlargement);
  m_body->setChildrenCollapsible(false);
  m_body->setHandleWidth(6);
  m_body->addWidget(m_view);
  m_body->addWidget(m_path);
  m_body->setStretchFactor(0, 3);
  m_body->setStretchFactor(1, 2);
  m_body->setSizes({3000, 2000});
  inColumn(
      {inRow({label({.text = QT_TR_NOOP("Recording")}, m_run), {m_run, 2}, {m_enlargement, 1}}),
       {m_body, 1}},
      this, QMargins(4, 6, 4, 4));
  connect(m_run, &QComboBox::activated, this, &OverlayPanel::overlayRequested);
  connect(m_enlargement, &QComboBox::activated, this, &OverlayPanel::showEnlargement);
  retranslate();
  restyle();
}

void OverlayPanel::setRunner(WorkRunner runner) {
  m_curves->setRunner(std::move(runner));
}

void OverlayPanel::setRuns(const QStringList& names) {
  m_run->clear();
  m_run->addItems(names);
  m_curves->setTraces({});
  m_view->setArrangement({});
  if (!names.isEmpty()) {
    Q_EMIT overlayRequested(0);
  }
}

emulator::OverlayNames OverlayPanel::names() const {
  emulator::OverlayNames names{tr("Machine").toStdString(), tr("Emulator").toStdString(), {}};
  for (std::size_t axis = 0; axis < names.departure.size(); ++axis) {
    names.departure[axis] =
        tr("%1 machine − emulator").arg(QString(QLatin1Char(base::kAxisNames[axis]))).toStdString();
  }
  return names;
}

void OverlayPanel::setOverlay(const emulator::Overlay& overlay) {
  m_curves->setTraces({overlay.machine, overlay.emulated});
  m_window->setLength(base::toSeconds(overlay.machine->length));
  std::vector<QStringList> panes;
  const std::vector<trace::SignalOffer> offers = m_curves->offers();
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const std::string departure = names().departure[axis];
    const auto found = std::find_if(offers.begin(), offers.end(),
                                    [&](const auto& offer) { return offer.label == departure; });
    if (found != offers.end()) {
      panes.push_back(
          {QString(QLatin1Char(base::kAxisNames[axis])).toLower() + QStringLiteral("_act")});
      panes.push_back({QString::fromStdString(found->formula)});
    }
  }
  m_view->setArrangement(panes);
  showEnlargement();
}

void OverlayPanel::redrawNow() {
  m_view->redrawNow();
  m_path->redrawNow();
}

void OverlayPanel::showEnlargement() {
  m_path->setEnlargement(m_enlargement->currentData().toDouble());
}

void OverlayPanel::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  m_body->setOrientation(width() >= kBesidePx ? Qt::Horizontal : Qt::Vertical);
}

void OverlayPanel::retranslate() {
  for (int i = 0; i < m_enlargement->count(); ++i) {
    m_enlargement->setItemText(
        i,
        tr("Error × %1").arg(numberText(PathPane::kEnlargements[static_cast<std::size_t>(i)], 0)));
  }
  // The names of the curves are in the traces.
  if (m_run->count() > 0) {
    Q_EMIT overlayRequested(m_run->currentIndex());
  }
}

}  // namespace rivulet::widgets
