// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/scope_view.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSplitter>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/common/theme.h"
#include "widgets/scope/time_strip.h"

namespace rivulet::widgets {

namespace {

constexpr int kCaptionPx = 26;
constexpr int kScreenDpi = 96;
constexpr double kPointsPerPx = 72.0 / kScreenDpi;
constexpr double kSharpness = 2.0;  // pixels of a picture per pixel of the screen

}  // namespace

ScopeView::ScopeView(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                     const std::vector<StopRow>* stops, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_stops(stops),
      m_splitter(new QSplitter(Qt::Vertical, this)),
      m_strip(say(new TimeStrip(curves, window, stops, this), {.id = "scopeStrip"})) {
  m_splitter->setChildrenCollapsible(false);
  m_splitter->setHandleWidth(5);
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

QList<int> ScopeView::heights() const {
  QList<int> heights;
  for (ScopePane* pane : m_panes) {
    heights.append(m_splitter->sizes().value(m_splitter->indexOf(pane)));
  }
  return heights;
}

void ScopeView::setHeights(const QList<int>& heights) {
  if (heights.size() != static_cast<qsizetype>(m_panes.size())) {
    return;
  }
  // Panes that were taken out are still in the splitter, hidden.
  QList<int> sizes(m_splitter->count(), 0);
  for (std::size_t i = 0; i < m_panes.size(); ++i) {
    m_panes[i]->show();
    sizes[m_splitter->indexOf(m_panes[i])] = heights[static_cast<qsizetype>(i)];
  }
  m_splitter->setSizes(sizes);
}

void ScopeView::paintOn(QPainter& painter, const QString& caption) {
  painter.fillRect(QRect(0, 0, width(), height() + kCaptionPx), themeColors(palette()).surface);
  painter.setPen(themeColors(palette()).text);
  const QRectF line(kScopeLeftPx, 0.0, width() - kScopeLeftPx - kScopeRightPx, kCaptionPx);
  painter.drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      painter.fontMetrics().elidedText(caption, Qt::ElideRight, static_cast<int>(line.width())));
  for (ScopePane* pane : m_panes) {
    painter.save();
    painter.translate(pane->mapTo(this, QPoint(0, kCaptionPx)));
    pane->paintOn(painter);
    painter.restore();
  }
  painter.save();
  painter.translate(m_strip->pos() + QPoint(0, kCaptionPx));
  m_strip->paintOn(painter);
  painter.restore();
}

bool ScopeView::savePicture(const QString& path, const QString& caption) {
  const QSize size(width(), height() + kCaptionPx);
  if (path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
    QImage image(size * kSharpness, QImage::Format_RGB32);
    image.setDevicePixelRatio(kSharpness);
    QPainter painter(&image);
    painter.setFont(font());
    paintOn(painter, caption);
    painter.end();
    return image.save(path);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const auto paint = [&](QPaintDevice& device) {
    setPalette(themePalette(Theme::Light));
    QPainter painter(&device);
    painter.setFont(font());
    paintOn(painter, caption);
    painter.end();
    setPalette(QPalette());
  };
  if (path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setSize(size);
    svg.setViewBox(QRect(QPoint(0, 0), size));
    svg.setTitle(caption);
    paint(svg);
  } else {
    QPdfWriter pdf(&buffer);
    pdf.setResolution(kScreenDpi);
    pdf.setPageSize(QPageSize(QSizeF(size) * kPointsPerPx, QPageSize::Point));
    pdf.setPageMargins(QMarginsF());
    pdf.setTitle(caption);
    paint(pdf);
  }
  QSaveFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

}  // namespace rivulet::widgets
