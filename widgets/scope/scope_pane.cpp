// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/scope_pane.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QGestureEvent>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/nice_step.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"

namespace rivulet::widgets {

namespace {

constexpr double kTopPx = 6.0;
constexpr double kBottomPx = 6.0;
constexpr double kGrabPx = 6.0;  // a cursor is taken from so near
constexpr int kRedrawMs = 16;
constexpr double kWheelZoom = 0.9985;  // per eighth of a degree
constexpr double kKeyZoom = 0.7;
constexpr double kKeyPan = 0.1;  // of the window

/// Few points make a smooth line; many make a filled band, which smoothing only slows down.
constexpr double kSmoothPointsPerPx = 0.5;

}  // namespace

void ScopeCursors::set(Which which, std::optional<double> atS) {
  if (m_atS[which] != atS) {
    m_atS[which] = atS;
    Q_EMIT changed();
  }
}

ScopePane::ScopePane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                     const std::vector<StopRow>* stops, QWidget* parent)
    : Page(parent), m_curves(curves), m_window(window), m_cursors(cursors), m_stops(stops) {
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  setMouseTracking(true);
  grabGesture(Qt::PinchGesture);
  setAttribute(Qt::WA_OpaquePaintEvent);
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  setFont(small);
  m_redraw.setParent(this);  // whoever waits for the page finds it
  m_redraw.setSingleShot(true);
  connect(&m_redraw, &QTimer::timeout, this, &ScopePane::drawCurves);
  connect(m_window, &TimeWindow::changed, this, &ScopePane::scheduleRedraw);
  connect(m_curves, &ScopeCurves::changed, this, &ScopePane::scheduleRedraw);
  connect(m_cursors, &ScopeCursors::changed, this, qOverload<>(&QWidget::update));
  onLanguage(&ScopePane::describe, &ScopePane::scheduleRedraw);
  onTheme(&ScopePane::scheduleRedraw);
}

QString ScopePane::mimeType() {
  return QStringLiteral("application/x-rivulet-signal");
}

void ScopePane::setFormulas(const QStringList& formulas) {
  m_formulas = formulas;
  describe();
  scheduleRedraw();
}

void ScopePane::setStopLabels(bool visible) {
  m_stopLabels = visible;
  update();
}

QSize ScopePane::minimumSizeHint() const {
  return {180, 56};
}

QSize ScopePane::sizeHint() const {
  return {480, 120};
}

void ScopePane::scheduleRedraw() {
  const bool follows = m_curves->isLive() && m_window->isLive();
  if (!m_redraw.isActive() || (!follows && m_redraw.remainingTime() > kRedrawMs)) {
    m_redraw.start(follows ? kFollowMs : kRedrawMs);
  }
}

void ScopePane::redrawNow() {
  m_redraw.stop();
  drawCurves();
}

QColor ScopePane::curveColor(std::size_t index, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  const std::array<QColor, 6> all{colors.trace,        colors.equations[3], colors.equations[1],
                                  colors.equations[2], colors.accent,       colors.fault};
  return all[index % all.size()];
}

TimeArea ScopePane::area() const {
  return {QRectF(kScopeLeftPx, kTopPx, std::max(width() - kScopeLeftPx - kScopeRightPx, 10.0),
                 std::max(height() - kTopPx - kBottomPx, 10.0)),
          m_window->fromS(), m_window->toS()};
}

std::vector<ScopePane::Curve> ScopePane::curves() const {
  std::vector<Curve> curves;
  for (const QString& formula : m_formulas) {
    std::vector<Curve> of = m_curves->curves(formula);
    std::move(of.begin(), of.end(), std::back_inserter(curves));
  }
  return curves;
}

void ScopePane::fitValues(const std::vector<Curve>& curves) {
  const TimeArea seen = area();
  std::optional<trace::ValueRange> range;
  for (const Curve& curve : curves) {
    if (curve.samples && !curve.samples->empty() && seen.toS >= seen.fromS) {
      const auto one = curve.samples->range(instantOf(seen.fromS), instantOf(seen.toS));
      if (one && std::isfinite(one->min) && std::isfinite(one->max)) {
        range = range ? trace::ValueRange{std::min(range->min, one->min),
                                          std::max(range->max, one->max)}
                      : *one;
      }
    }
  }
  const bool isFeed = !m_formulas.isEmpty() && !m_curves->showsDifferences() &&
                      m_curves->unit(m_formulas.first()) == QLatin1String("mm/min");
  m_min = range ? range->min : 0.0;
  m_max = range ? range->max : 1.0;
  if (isFeed && m_min >= 0.0) {
    m_min = 0.0;
  }
  // Noise of the last digit does not fill the pane.
  const double leastSpan = isFeed ? 10.0 : std::max(2e-4, 1e-5 * std::abs(m_max));
  const double padding = std::max(0.08 * (m_max - m_min), (leastSpan - (m_max - m_min)) / 2.0);
  m_max += padding;
  m_min -= m_min == 0.0 && isFeed ? 0.0 : padding;
  const int ticks = std::clamp(static_cast<int>(seen.rect.height() / 34.0), 1, 8);
  m_step = base::niceStepAbove((m_max - m_min) / ticks);
  m_min = std::floor(m_min / m_step) * m_step;
  m_max = std::ceil(m_max / m_step) * m_step;
}

double ScopePane::yOf(double value) const {
  const QRectF rect = area().rect;
  return rect.bottom() - (value - m_min) / (m_max - m_min) * rect.height();
}

void ScopePane::paintGrid(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const TimeArea seen = area();
  const QFontMetricsF metrics(font());
  const double timeStep = base::niceStepAbove((seen.toS - seen.fromS) /
                                              std::clamp(seen.rect.width() / 75.0, 2.0, 20.0));
  painter.setPen(QPen(colors.grid, 1));
  for (double at = std::ceil(seen.fromS / timeStep) * timeStep; at <= seen.toS; at += timeStep) {
    const double x = std::round(seen.xOf(at)) + 0.5;
    painter.drawLine(QPointF(x, seen.rect.top()), QPointF(x, seen.rect.bottom()));
  }
  const int decimals = std::min(base::decimalsOfStep(m_step), 9);
  const auto count = static_cast<int>(std::round((m_max - m_min) / m_step));
  const bool isCrowded = seen.rect.height() < (count + 1) * metrics.height();
  for (int i = 0; i <= count; ++i) {
    const double value = m_min + i * m_step;
    const double y = std::round(yOf(value)) + 0.5;
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(QPointF(seen.rect.left(), y), QPointF(seen.rect.right(), y));
    if (isCrowded && i != 0 && i != count) {
      continue;
    }
    painter.setPen(colors.text);
    const QRectF place(0.0,
                       std::clamp(y - metrics.height() / 2.0, 0.0, height() - metrics.height()),
                       kScopeLeftPx - 8.0, metrics.height());
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter,
                     numberText(std::abs(value) < m_step / 2.0 ? 0.0 : value, decimals));
  }
  painter.setPen(QPen(colors.line, 1));
  painter.drawRect(seen.rect.adjusted(0.5, 0.5, -0.5, -0.5));
}

void ScopePane::paintCurve(QPainter& painter, const Curve& curve, const QColor& color) const {
  if (!curve.samples || curve.samples->empty()) {
    return;
  }
  const TimeArea seen = area();
  const auto columns = static_cast<std::size_t>(std::clamp(seen.rect.width(), 16.0, 8000.0));
  const auto points = curve.samples->visible(instantOf(seen.fromS), instantOf(seen.toS), columns);
  const bool isSmooth = static_cast<double>(points.size()) < kSmoothPointsPerPx * seen.rect.width();
  painter.setRenderHint(QPainter::Antialiasing, isSmooth);
  painter.setPen(QPen(color, isSmooth ? 1.6 : 1.0));
  QPolygonF line;
  line.reserve(static_cast<qsizetype>(points.size()));
  const auto finish = [&] {
    if (line.size() == 1) {
      painter.drawPoint(line.first());
    } else if (!line.isEmpty()) {
      painter.drawPolyline(line);
    }
    line.clear();
  };
  for (const trace::SeriesPoint& point : points) {
    if (std::isfinite(point.value)) {
      line.append({seen.xOf(base::toSeconds(point.at)), yOf(point.value)});
    } else {
      finish();
    }
  }
  finish();
}

void ScopePane::paintContent(QPainter& painter, const std::vector<Curve>& shown) const {
  paintGrid(painter);
  const TimeArea seen = area();
  painter.save();
  paintStopBands(painter, seen, *m_stops, m_stopLabels, palette());
  painter.restore();
  painter.save();
  painter.setClipRect(seen.rect);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    paintCurve(painter, shown[i], curveColor(i, palette()));
  }
  painter.restore();
}

void ScopePane::paintOn(QPainter& painter) {
  const std::vector<Curve> shown = curves();
  fitValues(shown);
  painter.fillRect(rect(), themeColors(palette()).surface);
  painter.setFont(font());
  paintContent(painter, shown);
  paintLegend(painter, shown);
  paintCursors(painter);
}

void ScopePane::drawCurves() {
  const qreal ratio = devicePixelRatioF();
  const QSize pixels(std::max(1, static_cast<int>(width() * ratio)),
                     std::max(1, static_cast<int>(height() * ratio)));
  if (m_picture.size() != pixels) {
    m_picture = QPixmap(pixels);
  }
  m_picture.setDevicePixelRatio(ratio);
  m_picture.fill(themeColors(palette()).surface);
  const std::vector<Curve> shown = curves();
  fitValues(shown);
  QPainter painter(&m_picture);
  painter.setFont(font());
  paintContent(painter, shown);
  painter.end();
  describe();
  update();
  Q_EMIT redrawn();
}

void ScopePane::paintLegend(QPainter& painter, const std::vector<Curve>& shown) const {
  const ThemeColors& colors = themeColors(palette());
  const QFontMetricsF metrics(font());
  const QRectF rect = area().rect;
  double x = rect.left() + 6.0;
  double y = rect.top() + 3.0;
  const double lineHeight = metrics.height() + 3.0;
  const auto& at = m_cursors->atS(ScopeCursors::A);
  for (std::size_t i = 0; i < shown.size() && x < rect.right() - 30.0; ++i) {
    QString text = shown[i].title;
    const QString unit = m_curves->unit(shown[i].formula);
    if (at && shown[i].samples) {
      const double value = trace::valueAt(*shown[i].samples, instantOf(*at));
      const int decimals = std::clamp(base::decimalsOfStep(m_step) + 2, 0, 9);
      text += QStringLiteral(": ") + numberText(value, decimals);
    }
    text += unit.isEmpty() ? QString() : (at ? QStringLiteral(" ") : QStringLiteral(", ")) + unit;
    const double wide = metrics.horizontalAdvance(text) + 28.0;
    // A title that finds no room starts a line of its own, if that leaves half of the curves.
    const bool isCut = x + wide > rect.right() - 2.0;
    if (isCut && i > 0 && y + 2.0 * lineHeight < rect.center().y()) {
      x = rect.left() + 6.0;
      y += lineHeight;
    }
    const double room = std::min(wide, rect.right() - x - 2.0);
    QColor ground = colors.surface;
    ground.setAlpha(215);
    painter.fillRect(QRectF(x - 3.0, y, room, metrics.height() + 2.0), ground);
    painter.fillRect(QRectF(x, y + metrics.height() / 2.0, 12.0, 3.0), curveColor(i, palette()));
    painter.setPen(colors.text);
    painter.drawText(QRectF(x + 17.0, y, room - 22.0, metrics.height() + 2.0), Qt::AlignVCenter,
                     metrics.elidedText(text, Qt::ElideRight, room - 22.0));
    x += room + 6.0;
  }
}

void ScopePane::paintCursors(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const TimeArea seen = area();
  const QFontMetricsF metrics(font());
  for (const auto which : {ScopeCursors::A, ScopeCursors::B}) {
    const auto& at = m_cursors->atS(which);
    if (!at || *at < seen.fromS || *at > seen.toS) {
      continue;
    }
    const double x = std::round(seen.xOf(*at)) + 0.5;
    painter.setPen(QPen(colors.accent, 1, which == ScopeCursors::A ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(x, seen.rect.top()), QPointF(x, seen.rect.bottom()));
    const QString name = which == ScopeCursors::A ? QStringLiteral("A") : QStringLiteral("B");
    const double wide = metrics.horizontalAdvance(name) + 6.0;
    const QRectF flag(std::min(x, seen.rect.right() - wide), seen.rect.bottom() - metrics.height(),
                      wide, metrics.height());
    painter.fillRect(flag, colors.surface);
    painter.setPen(colors.accent);
    painter.drawText(flag, Qt::AlignCenter, name);
  }
}

void ScopePane::paintEvent(QPaintEvent* /*event*/) {
  if (m_picture.isNull()) {
    drawCurves();
  }
  QPainter painter(this);
  painter.fillRect(rect(), themeColors(palette()).surface);
  painter.drawPixmap(QPointF(0.0, 0.0), m_picture);
  painter.setFont(font());
  paintLegend(painter, curves());
  paintCursors(painter);
  if (m_drag == Drag::Band && m_hasMoved) {
    const QRectF seen = area().rect;
    QColor fill = themeColors(palette()).accent;
    fill.setAlpha(50);
    painter.fillRect(QRectF(QPointF(m_pressed.x(), seen.top()), QPointF(m_dragX, seen.bottom())),
                     fill);
  }
}

void ScopePane::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  drawCurves();
}

double ScopePane::secondsAt(double x) const {
  return area().secondsAt(x);
}

std::optional<ScopeCursors::Which> ScopePane::cursorAt(double x) const {
  for (const auto which : {ScopeCursors::A, ScopeCursors::B}) {
    const auto& at = m_cursors->atS(which);
    if (at && std::abs(area().xOf(*at) - x) <= kGrabPx) {
      return which;
    }
  }
  return std::nullopt;
}

/// Two fingers zoom: the time between them stays there.
bool ScopePane::event(QEvent* event) {
  if (event->type() != QEvent::Gesture) {
    return Page::event(event);
  }
  auto* gestures = static_cast<QGestureEvent*>(event);
  auto* pinch = static_cast<QPinchGesture*>(gestures->gesture(Qt::PinchGesture));
  if (pinch == nullptr) {
    return false;
  }
  m_drag = Drag::None;
  if (pinch->changeFlags().testFlag(QPinchGesture::ScaleFactorChanged) &&
      pinch->scaleFactor() > 0.0) {
    m_window->zoom(1.0 / pinch->scaleFactor(), secondsAt(mapFromGlobal(pinch->centerPoint()).x()));
  }
  gestures->accept(pinch);
  return true;
}

void ScopePane::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  if (event->modifiers().testFlag(Qt::ShiftModifier) || turned.y() == 0) {
    const int by = turned.y() != 0 ? turned.y() : turned.x();
    m_window->pan(-by / 120.0 * kKeyPan * (m_window->toS() - m_window->fromS()));
  } else {
    m_window->zoom(std::pow(kWheelZoom, turned.y()), secondsAt(event->position().x()));
  }
  event->accept();
}

void ScopePane::mousePressEvent(QMouseEvent* event) {
  Q_EMIT selected();
  m_pressed = event->position();
  m_dragX = m_pressed.x();
  m_hasMoved = false;
  const auto cursor = cursorAt(m_pressed.x());
  if (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ControlModifier)) {
    m_drag = Drag::Band;
  } else if (event->button() == Qt::LeftButton && cursor) {
    m_drag = *cursor == ScopeCursors::A ? Drag::CursorA : Drag::CursorB;
  } else if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) {
    m_drag = Drag::Pan;
  }
}

void ScopePane::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (m_drag == Drag::None) {
    setCursor(cursorAt(x) ? Qt::SplitHCursor : Qt::ArrowCursor);
    return;
  }
  if ((event->position() - m_pressed).manhattanLength() >= QApplication::startDragDistance()) {
    m_hasMoved = true;
  }
  if (!m_hasMoved) {
    return;
  }
  const TimeArea seen = area();
  switch (m_drag) {
    case Drag::Pan:
      m_window->pan((m_dragX - x) / seen.rect.width() * (seen.toS - seen.fromS));
      break;
    case Drag::CursorA:
      m_cursors->set(ScopeCursors::A, secondsAt(x));
      break;
    case Drag::CursorB:
      m_cursors->set(ScopeCursors::B, secondsAt(x));
      break;
    default:
      update();
      break;
  }
  m_dragX = x;
}

void ScopePane::mouseReleaseEvent(QMouseEvent* event) {
  const Drag drag = m_drag;
  m_drag = Drag::None;
  const double x = event->position().x();
  if (drag == Drag::Band && m_hasMoved) {
    const double from = secondsAt(std::min(m_pressed.x(), x));
    const double to = secondsAt(std::max(m_pressed.x(), x));
    m_window->showRange(from, to);
    update();
  } else if (drag == Drag::Pan && !m_hasMoved && event->button() == Qt::LeftButton) {
    const bool isSecond = event->modifiers().testFlag(Qt::ShiftModifier);
    m_cursors->set(isSecond ? ScopeCursors::B : ScopeCursors::A, secondsAt(x));
  }
}

void ScopePane::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
  m_window->showAll();
}

bool ScopePane::handleKey(int key, Qt::KeyboardModifiers modifiers) {
  const double from = m_window->fromS();
  const double span = m_window->toS() - from;
  const auto& a = m_cursors->atS(ScopeCursors::A);
  // Zooming keeps cursor A where it is, if it is in view.
  const double around = a && *a >= from && *a <= from + span ? *a : from + span / 2.0;
  const auto moveCursor = [this, span](ScopeCursors::Which which, double sign) {
    const double pixel = span / area().rect.width();
    const double at = m_cursors->atS(which).value_or(m_window->fromS() + span / 2.0);
    m_cursors->set(which, at + sign * pixel);
  };
  switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      m_window->zoom(kKeyZoom, around);
      return true;
    case Qt::Key_Minus:
      m_window->zoom(1.0 / kKeyZoom, around);
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right: {
      const double sign = key == Qt::Key_Left ? -1.0 : 1.0;
      if (modifiers.testFlag(Qt::ShiftModifier)) {
        moveCursor(modifiers.testFlag(Qt::ControlModifier) ? ScopeCursors::B : ScopeCursors::A,
                   sign);
      } else {
        m_window->pan(sign * kKeyPan * span);
      }
      return true;
    }
    case Qt::Key_Home:
      m_window->showAll();
      return true;
    case Qt::Key_End:
      m_window->pan(m_window->endS() - m_window->toS());
      return true;
    case Qt::Key_A:
      m_cursors->set(ScopeCursors::A, from + span / 2.0);
      return true;
    case Qt::Key_B:
      m_cursors->set(ScopeCursors::B, from + span / 2.0);
      return true;
    case Qt::Key_C:
      m_cursors->set(ScopeCursors::A, std::nullopt);
      m_cursors->set(ScopeCursors::B, std::nullopt);
      return true;
    case Qt::Key_Delete:
      Q_EMIT removeRequested();
      return true;
    default:
      return false;
  }
}

void ScopePane::keyPressEvent(QKeyEvent* event) {
  if (!handleKey(event->key(), event->modifiers())) {
    Page::keyPressEvent(event);
  }
}

void ScopePane::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (m_formulas.size() > 1) {
    for (const QString& formula : m_formulas) {
      menu->addAction(tr("Remove %1").arg(m_curves->title(formula)), this, [this, formula] {
        m_formulas.removeAll(formula);
        scheduleRedraw();
        Q_EMIT formulasChanged();
      });
    }
  }
  menu->addAction(tr("Remove the pane"), this, &ScopePane::removeRequested);
  menu->popup(event->globalPos());
}

void ScopePane::focusInEvent(QFocusEvent* event) {
  Page::focusInEvent(event);
  Q_EMIT selected();
}

void ScopePane::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(mimeType())) {
    event->acceptProposedAction();
  }
}

void ScopePane::dropEvent(QDropEvent* event) {
  const QByteArray formula = event->mimeData()->data(mimeType());
  if (!formula.isEmpty()) {
    event->acceptProposedAction();
    Q_EMIT signalDropped(QString::fromUtf8(formula));
  }
}

void ScopePane::describe() {
  QStringList names;
  for (const QString& formula : m_formulas) {
    names.append(m_curves->title(formula));
  }
  setAccessibleName(tr("Curves: %1").arg(names.join(QStringLiteral(", "))));
  const int decimals = std::min(base::decimalsOfStep(m_step), 9);
  setAccessibleDescription(tr("%1 to %2, from %3 to %4")
                               .arg(numberText(m_min, decimals), numberText(m_max, decimals),
                                    m_curves->axisText(m_window->fromS()),
                                    m_curves->axisText(m_window->toS())));
}

}  // namespace rivulet::widgets
