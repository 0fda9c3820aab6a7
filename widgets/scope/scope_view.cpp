// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/scope_view.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/scope/time_strip.h"

namespace rivulet::widgets {

ScopeView::ScopeView(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                     const std::vector<StopRow>* stops, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_stops(stops),
      m_splitter(new QSplitter(Qt::Vertical, this)),
      m_strip(new TimeStrip(curves, window, stops, this)) {
  m_splitter->setChildrenCollapsible(false);
  m_splitter->setHandleWidth(5);
  m_strip->setObjectName(QStringLiteral("scopeStrip"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_splitter, 1);
  layout->addWidget(m_strip);
}

ScopePane* ScopeView::makePane(int at) {
  auto* pane = new ScopePane(m_curves, m_window, m_cursors, m_stops, this);
  connect(pane, &ScopePane::selected, this, [this, pane] { m_current = pane; });
  connect(pane, &ScopePane::removeRequested, this, [this, pane] { removePane(pane); });
  connect(pane, &ScopePane::formulasChanged, this, &ScopeView::finishChange);
  connect(pane, &ScopePane::signalDropped, this, [this, pane](const QString& formula) {
    m_current = pane;
    addToPane(formula);
  });
  m_splitter->insertWidget(at, pane);
  m_panes.insert(m_panes.begin() + at, pane);
  m_current = pane;
  return pane;
}

void ScopeView::removePane(ScopePane* pane) {
  m_panes.erase(std::remove(m_panes.begin(), m_panes.end(), pane), m_panes.end());
  m_current = m_panes.empty() ? nullptr : m_panes.back();
  pane->hide();
  pane->deleteLater();
  finishChange();
}

void ScopeView::finishChange() {
  for (std::size_t i = 0; i < m_panes.size(); ++i) {
    m_panes[i]->setObjectName(QStringLiteral("scopePane%1").arg(i));
    // The bands are labelled once.
    m_panes[i]->setStopLabels(i + 1 == m_panes.size());
    m_panes[i]->scheduleRedraw();
  }
  m_strip->setFormula(m_panes.empty() || m_panes.back()->formulas().isEmpty()
                          ? QString()
                          : m_panes.back()->formulas().first());
  Q_EMIT changed();
}

void ScopeView::setArrangement(const std::vector<QStringList>& panes) {
  for (ScopePane* pane : m_panes) {
    pane->hide();
    pane->deleteLater();
  }
  m_panes.clear();
  m_current = nullptr;
  for (const QStringList& formulas : panes) {
    if (m_panes.size() < kPanesMax) {
      makePane(static_cast<int>(m_panes.size()))->setFormulas(formulas);
    }
  }
  finishChange();
}

std::vector<QStringList> ScopeView::arrangement() const {
  std::vector<QStringList> panes;
  for (const ScopePane* pane : m_panes) {
    panes.push_back(pane->formulas());
  }
  return panes;
}

bool ScopeView::shows(const QString& formula) const {
  return std::any_of(m_panes.begin(), m_panes.end(), [&formula](const ScopePane* pane) {
    return pane->formulas().contains(formula);
  });
}

void ScopeView::addPane(const QString& formula) {
  if (m_panes.size() >= kPanesMax) {
    addToPane(formula);
    return;
  }
  const auto current = std::find(m_panes.begin(), m_panes.end(), m_current);
  const auto at = current == m_panes.end()
                      ? m_panes.size()
                      : static_cast<std::size_t>(current - m_panes.begin()) + 1;
  makePane(static_cast<int>(at))->setFormulas({formula});
  // As high as the others.
  m_splitter->setSizes(QList<int>(static_cast<qsizetype>(m_panes.size()), 1000));
  finishChange();
}

void ScopeView::addToPane(const QString& formula) {
  if (m_current == nullptr) {
    addPane(formula);
    return;
  }
  QStringList formulas = m_current->formulas();
  if (!formulas.contains(formula)) {
    formulas.append(formula);
    m_current->setFormulas(formulas);
    finishChange();
  }
}

void ScopeView::removeSignal(const QString& formula) {
  const std::vector<ScopePane*> panes = m_panes;
  for (ScopePane* pane : panes) {
    QStringList formulas = pane->formulas();
    if (formulas.removeAll(formula) == 0) {
      continue;
    }
    if (formulas.isEmpty()) {
      removePane(pane);
    } else {
      pane->setFormulas(formulas);
    }
  }
  finishChange();
}

void ScopeView::scheduleRedraw() {
  for (ScopePane* pane : m_panes) {
    pane->scheduleRedraw();
  }
  m_strip->update();
}

void ScopeView::redrawNow() {
  for (ScopePane* pane : m_panes) {
    pane->redrawNow();
  }
}

}  // namespace rivulet::widgets
