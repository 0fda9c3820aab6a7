// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/path_pane.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nice_step.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"

namespace rivulet::widgets {

namespace {

constexpr double kMarginPx = 14.0;
constexpr double kDotPx = 4.5;
constexpr double kClickPx = 24.0;
constexpr std::size_t kPlacesMax = 30'000;  // of each trace: this bounds the time of a picture
constexpr double kSpanMinMm = 1e-3;
constexpr int kPathDelayMs = 40;

}  // namespace

PathPane::PathPane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, QWidget* parent)
    : Page(parent), m_curves(curves), m_window(window), m_cursors(cursors) {
  setObjectName(QStringLiteral("scopePath"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  m_redraw.setParent(this);  // whoever waits for the page finds it
  m_redraw.setSingleShot(true);
  m_redraw.setInterval(kPathDelayMs);
  connect(&m_redraw, &QTimer::timeout, this, &PathPane::draw);
  connect(m_window, &TimeWindow::changed, this, &PathPane::schedule);
  connect(m_curves, &ScopeCurves::changed, this, &PathPane::schedule);
  connect(m_cursors, &ScopeCursors::changed, this, [this] {
    setAccessibleDescription(placeText());
    update();
  });
  retranslate();
}

QSize PathPane::minimumSizeHint() const {
  return {160, 120};
}

void PathPane::schedule() {
  if (isVisible() && !m_redraw.isActive()) {
    m_redraw.start();
  }
}

void PathPane::redrawNow() {
  m_redraw.stop();
  draw();
}

PathPane::Axes PathPane::axesOf(std::size_t trace) const {
  for (const char* suffix : {"_act", "_set"}) {
    const QString end = QLatin1String(suffix);
    const Axes axes{m_curves->samples(trace, QLatin1Char('x') + end),
                    m_curves->samples(trace, QLatin1Char('y') + end)};
    if (axes.x && axes.y) {
      return axes;
    }
  }
  return {};
}

QRectF PathPane::room() const {
  const double low = fontMetrics().height() + 6.0;
  return QRectF(rect()).adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx - low);
}

QPointF PathPane::pixelOf(double xMm, double yMm) const {
  const QPointF middle = room().center();
  return {middle.x() + (xMm - m_middleXMm) * m_pxPerMm,
          middle.y() - (yMm - m_middleYMm) * m_pxPerMm};
}

void PathPane::draw() {
  m_paths.clear();
  if (width() < 1 || height() < 1) {
    return;
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double min[2] = {kFar, kFar};
  double max[2] = {-kFar, -kFar};
  const std::size_t traces = m_curves->isLive() ? 1 : m_curves->traces().size();
  for (std::size_t trace = 0; trace < traces; ++trace) {
    const Axes axes = axesOf(trace);
    std::vector<Place>& path = m_paths.emplace_back();
    if (!axes.x) {
      continue;
    }
    const std::size_t begin = axes.x->firstAt(instantOf(m_window->fromS()));
    const std::size_t end = axes.x->firstAt(instantOf(m_window->toS()) + base::Duration{1});
    const std::size_t stride = (end - begin) / kPlacesMax + 1;
    for (std::size_t i = begin; i < end; i += stride) {
      const base::Instant at = axes.x->timeAt(i);
      const bool isSame = i < axes.y->size() && axes.y->timeAt(i) == at;
      const double x = axes.x->valueAt(i);
      const double y = isSame ? axes.y->valueAt(i) : trace::valueAt(*axes.y, at);
      if (std::isfinite(x) && std::isfinite(y)) {
        path.push_back({base::toSeconds(at), x, y});
        min[0] = std::min(min[0], x);
        max[0] = std::max(max[0], x);
        min[1] = std::min(min[1], y);
        max[1] = std::max(max[1], y);
      }
    }
  }
  if (min[0] <= max[0]) {
    m_middleXMm = (min[0] + max[0]) / 2.0;
    m_middleYMm = (min[1] + max[1]) / 2.0;
    m_pxPerMm = std::min(room().width() / std::max(max[0] - min[0], kSpanMinMm),
                         room().height() / std::max(max[1] - min[1], kSpanMinMm));
  }
  const qreal ratio = devicePixelRatioF();
  m_picture = QPixmap(QSize(width(), height()) * ratio);
  m_picture.setDevicePixelRatio(ratio);
  const ThemeColors& colors = themeColors(palette());
  m_picture.fill(colors.surface);
  QPainter painter(&m_picture);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t trace = 0; trace < m_paths.size(); ++trace) {
    QPolygonF line;
    for (const Place& place : m_paths[trace]) {
      const QPointF pixel = pixelOf(place.xMm, place.yMm);
      if (line.isEmpty() || (pixel - line.last()).manhattanLength() > 0.7) {
        line.append(pixel);
      }
    }
    painter.setPen(QPen(ScopePane::curveColor(trace, palette()), 1.4));
    if (line.size() == 1) {
      painter.drawPoint(line.first());
    } else {
      painter.drawPolyline(line);
    }
  }
  // How long a round length is.
  const double lengthMm = base::niceStepBelow(std::max(room().width() / 4.0 / m_pxPerMm, 1e-9));
  const double y = kMarginPx / 2.0 + 2.0;
  painter.setPen(QPen(colors.text, 2));
  painter.drawLine(QPointF(kMarginPx, y), QPointF(kMarginPx + lengthMm * m_pxPerMm, y));
  painter.drawText(
      QPointF(kMarginPx + lengthMm * m_pxPerMm + 6.0, y + fontMetrics().ascent() / 2.0),
      lengthText(lengthMm, base::decimalsOfStep(lengthMm)));
  update();
}

std::optional<PathPane::Place> PathPane::placeAt(double atS) const {
  const Axes axes = axesOf(0);
  if (!axes.x) {
    return std::nullopt;
  }
  const Place place{atS, trace::valueAt(*axes.x, instantOf(atS)),
                    trace::valueAt(*axes.y, instantOf(atS))};
  return std::isfinite(place.xMm) && std::isfinite(place.yMm) ? std::optional(place) : std::nullopt;
}

std::optional<QPointF> PathPane::placeOf(double atS) const {
  const auto place = placeAt(atS);
  return place ? std::optional(pixelOf(place->xMm, place->yMm)) : std::nullopt;
}

QString PathPane::placeText() const {
  const auto& at = m_cursors->atS(ScopeCursors::A);
  const auto place = at ? placeAt(*at) : std::nullopt;
  if (!place) {
    return {};
  }
  QString text =
      QStringLiteral("X %1  Y %2").arg(numberText(place->xMm, 3), numberText(place->yMm, 3));
  for (const char* name : {"program_line", "line"}) {
    const auto lines = m_curves->samples(0, QLatin1String(name));
    // The line does not change gradually: the one that began last.
    const std::size_t next = lines ? lines->firstAt(instantOf(*at) + base::Duration{1}) : 0;
    if (next > 0 && std::isfinite(lines->valueAt(next - 1))) {
      return text + QStringLiteral("  ") + tr("line %1").arg(lines->valueAt(next - 1), 0, 'f', 0);
    }
  }
  return text;
}

void PathPane::paintEvent(QPaintEvent* /*event*/) {
  if (m_picture.isNull()) {
    draw();
  }
  const ThemeColors& colors = themeColors(palette());
  QPainter painter(this);
  painter.fillRect(rect(), colors.surface);
  painter.drawPixmap(QPointF(0.0, 0.0), m_picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF low(kMarginPx, height() - fontMetrics().height() - 4.0, width() - 2.0 * kMarginPx,
                   fontMetrics().height() + 2.0);
  const bool isEmpty =
      std::all_of(m_paths.begin(), m_paths.end(), [](const auto& path) { return path.empty(); });
  if (isEmpty) {
    painter.setPen(colors.mutedText);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No X and Y here"));
    return;
  }
  for (const auto which : {ScopeCursors::B, ScopeCursors::A}) {
    const auto& at = m_cursors->atS(which);
    const auto place = at ? placeOf(*at) : std::nullopt;
    if (place) {
      painter.setPen(QPen(colors.accent, 2));
      painter.setBrush(which == ScopeCursors::A ? QBrush(colors.accent) : QBrush(colors.surface));
      painter.drawEllipse(*place, kDotPx, kDotPx);
      painter.drawText(*place + QPointF(7.0, -5.0),
                       which == ScopeCursors::A ? QStringLiteral("A") : QStringLiteral("B"));
    }
  }
  painter.setPen(colors.text);
  painter.drawText(low, Qt::AlignLeft | Qt::AlignVCenter, placeText());
}

void PathPane::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  draw();
}

void PathPane::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  draw();
}

void PathPane::mousePressEvent(QMouseEvent* event) {
  const Place* nearest = nullptr;
  double least = kClickPx;
  for (const std::vector<Place>& path : m_paths) {
    for (const Place& place : path) {
      const QPointF off = pixelOf(place.xMm, place.yMm) - event->position();
      const double distance = std::hypot(off.x(), off.y());
      if (distance < least) {
        least = distance;
        nearest = &place;
      }
    }
  }
  if (nearest != nullptr) {
    const bool isSecond = event->modifiers().testFlag(Qt::ShiftModifier);
    m_cursors->set(isSecond ? ScopeCursors::B : ScopeCursors::A, nearest->atS);
  }
}

void PathPane::retranslate() {
  setAccessibleName(tr("Path in X and Y"));
  setToolTip(tr("The path of the time that is seen. Click: cursor A. Shift and click: cursor B."));
  update();
}

void PathPane::restyle() {
  draw();
}

}  // namespace rivulet::widgets
