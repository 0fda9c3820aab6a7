// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/path_pane.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLinearGradient>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/axes.h"
#include "base/nice_step.h"
#include "trace/analysis/program_path.h"
#include "trace/signals.h"
#include "widgets/common/number_format.h"
#include "widgets/common/ramp.h"
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
constexpr double kStepPx = 0.7;  // shorter steps of a curve are not drawn
constexpr int kColours = 48;     // of the ramp
constexpr double kRampPx = 8.0;
constexpr double kAxisPx = 26.0;
constexpr int kValueDigits = 4;

/// The value of samples between two instants that is farthest from zero: thinning hides no peak.
double extremeOf(const trace::Envelope& samples, base::Instant from, base::Instant to) {
  const auto range = samples.range(from, to);
  if (!range) {
    return trace::valueAt(samples, from);
  }
  return std::abs(range->min) > std::abs(range->max) ? range->min : range->max;
}

}  // namespace

PathPane::PathPane(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors, QWidget* parent)
    : Page(parent), m_curves(curves), m_window(window), m_cursors(cursors) {
  setObjectName(QStringLiteral("scopePath"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
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
  onTheme(&PathPane::schedule);
}

QSize PathPane::minimumSizeHint() const {
  return {160, 150};
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

void PathPane::setColouring(const QString& formula) {
  m_colouring = formula;
  schedule();
}

void PathPane::setEnlargement(double factor) {
  m_enlargement = factor;
  schedule();
}

bool PathPane::canEnlarge() const {
  return !m_curves->isLive() && !m_curves->traces().empty() &&
         m_curves->traces().front()->programPath != nullptr;
}

void PathPane::setSpatial(bool isSpatial) {
  m_isSpatial = isSpatial;
  m_turned = isSpatial ? m_turned : overview::Projection::isometric();
  m_projection = overview::Projection(angles());
  schedule();
}

overview::Projection::Angles PathPane::angles() const {
  return m_isSpatial ? m_turned : overview::Projection::Angles{};
}

void PathPane::turn(double byDeg, double tiltByDeg) {
  m_turned = m_turned.turned(byDeg, tiltByDeg);
  m_projection = overview::Projection(angles());
  schedule();
}

PathPane::Course PathPane::courseOf(std::size_t trace) const {
  for (const char* suffix : {"_act", "_set"}) {
    const QString end = QLatin1String(suffix);
    const auto samples = [&](char axis) {
      return m_curves->samples(trace, QLatin1Char(axis) + end);
    };
    Course course{samples('x'), samples('y'), nullptr, nullptr, nullptr};
    if (!course.x || !course.y) {
      continue;
    }
    course.z = samples('z');
    if (!m_curves->isLive() && trace < m_curves->traces().size()) {
      course.program = m_curves->traces()[trace]->programPath;
      // A trace without its program has none.
      const auto length = [&](const char* name) {
        return m_curves->traces()[trace]->signalSet.find(name) == nullptr
                   ? nullptr
                   : m_curves->samples(trace, QLatin1String(name));
      };
      course.lengthMm = end == QLatin1String("_act") ? length("program_length_act") : nullptr;
      if (!course.lengthMm) {
        course.lengthMm = length("program_length");
      }
    }
    return course;
  }
  return {};
}

double PathPane::rampHeightPx() const {
  return m_colouring.isEmpty() ? 0.0 : 2.0 * fontMetrics().height() + kRampPx + 8.0;
}

QRectF PathPane::room() const {
  const double line = fontMetrics().height() + 6.0;
  return QRectF(rect()).adjusted(kMarginPx, kMarginPx + line, -kMarginPx,
                                 -kMarginPx - line - rampHeightPx());
}

QPointF PathPane::pixelOf(base::Vec3 positionMm) const {
  const QPointF middle = room().center();
  const overview::PlanePoint place = m_projection(positionMm);
  return {middle.x() + (place.right - m_middle.right) * m_pxPerMm,
          middle.y() - (place.up - m_middle.up) * m_pxPerMm};
}

/// Where a sample is on the programmed path. One that hardly moves has no length of its own: it is
/// nearest to a place between those of its neighbours, which need not be that of the same time.
double PathPane::lengthOn(const Course& course, base::Instant at, base::Vec3 positionMm) {
  const trace::Envelope& lengths = *course.lengthMm;
  const std::size_t next = lengths.firstAt(at);
  if (next < lengths.size() && lengths.timeAt(next) == at) {
    return lengths.valueAt(next);
  }
  if (next == 0 || next == lengths.size()) {
    return trace::kNoValue;
  }
  const double fromMm = lengths.valueAt(next - 1);
  const double toMm = lengths.valueAt(next);
  if (!std::isfinite(fromMm) || !std::isfinite(toMm)) {
    return trace::kNoValue;
  }
  return course.program->nearest(positionMm, std::min(fromMm, toMm), std::max(fromMm, toMm))
      .lengthMm;
}

PathPane::Place PathPane::placeOn(const Course& course, base::Instant at,
                                  base::Vec3 positionMm) const {
  constexpr double kNone = trace::kNoValue;
  Place place{base::toSeconds(at), positionMm, {kNone, kNone, kNone}, kNone};
  if (m_enlargement > 1.0 && course.program && course.lengthMm) {
    const double lengthMm = lengthOn(course, at, positionMm);
    if (std::isfinite(lengthMm)) {
      place.programmedMm = course.program->at(lengthMm);
      place.shownMm = place.programmedMm + m_enlargement * (positionMm - place.programmedMm);
    }
  }
  return place;
}

void PathPane::collect(std::size_t trace, std::vector<Place>& path) const {
  const Course course = courseOf(trace);
  if (!course.x) {
    return;
  }
  const auto values = m_colouring.isEmpty() ? nullptr : m_curves->samples(trace, m_colouring);
  const std::size_t begin = course.x->firstAt(instantOf(m_window->fromS()));
  const std::size_t end = course.x->firstAt(instantOf(m_window->toS()) + base::Duration{1});
  const std::size_t stride = (end - begin) / kPlacesMax + 1;
  const auto valueOf = [](const ScopeCurves::Samples& samples, std::size_t i, base::Instant at) {
    const bool isSame = i < samples->size() && samples->timeAt(i) == at;
    return isSame ? samples->valueAt(i) : trace::valueAt(*samples, at);
  };
  for (std::size_t i = begin; i < end; i += stride) {
    const base::Instant at = course.x->timeAt(i);
    const base::Vec3 positionMm{course.x->valueAt(i), valueOf(course.y, i, at),
                                course.z ? valueOf(course.z, i, at) : 0.0};
    if (!base::isFinite(positionMm)) {
      continue;
    }
    Place& place = path.emplace_back(placeOn(course, at, positionMm));
    if (values) {
      const bool isThinned = stride > 1 && i + stride < end;
      place.value =
          isThinned ? extremeOf(*values, at, course.x->timeAt(i + stride)) : valueOf(values, i, at);
    }
  }
}

void PathPane::fit() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  overview::PlanePoint min{kFar, kFar};
  overview::PlanePoint max{-kFar, -kFar};
  m_range = {};
  for (const std::vector<Place>& path : m_paths) {
    for (const Place& one : path) {
      const overview::PlanePoint place = m_projection(one.shownMm);
      min = {std::min(min.right, place.right), std::min(min.up, place.up)};
      max = {std::max(max.right, place.right), std::max(max.up, place.up)};
      if (std::isfinite(one.value)) {
        m_range.add(one.value);
      }
    }
  }
  if (min.right <= max.right) {
    m_middle = {(min.right + max.right) / 2.0, (min.up + max.up) / 2.0};
    m_pxPerMm = std::min(room().width() / std::max(max.right - min.right, kSpanMinMm),
                         room().height() / std::max(max.up - min.up, kSpanMinMm));
  }
}

void PathPane::draw() {
  m_paths.clear();
  if (width() < 1 || height() < 1) {
    return;
  }
  const std::size_t traces = m_curves->isLive() ? 1 : m_curves->traces().size();
  for (std::size_t trace = 0; trace < traces; ++trace) {
    collect(trace, m_paths.emplace_back());
  }
  fit();
  const qreal ratio = devicePixelRatioF();
  m_picture = QPixmap(QSize(width(), height()) * ratio);
  m_picture.setDevicePixelRatio(ratio);
  m_picture.fill(themeColors(palette()).surface);
  QPainter painter(&m_picture);
  painter.setFont(font());
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t trace = 0; trace < m_paths.size(); ++trace) {
    drawPath(painter, trace);
  }
  drawScaleBar(painter);
  if (m_isSpatial) {
    drawAxes(painter);
  }
  drawRamp(painter);
  update();
}

void PathPane::drawPath(QPainter& painter, std::size_t trace) const {
  const ThemeColors& colors = themeColors(palette());
  const std::vector<Place>& path = m_paths[trace];
  const auto stroke = [&painter](QPolygonF& line, const QPen& pen) {
    painter.setPen(pen);
    if (line.size() == 1) {
      painter.drawPoint(line.first());
    } else if (!line.isEmpty()) {
      painter.drawPolyline(line);
    }
    line.clear();
  };
  const auto append = [](QPolygonF& line, QPointF pixel) {
    if (line.isEmpty() || (pixel - line.last()).manhattanLength() > kStepPx) {
      line.append(pixel);
    }
  };
  // What was programmed, below what was done.
  QPolygonF line;
  for (const Place& place : path) {
    if (base::isFinite(place.programmedMm)) {
      append(line, pixelOf(place.programmedMm));
    } else {
      stroke(line, QPen(colors.mutedText, 1.0));
    }
  }
  stroke(line, QPen(colors.mutedText, 1.0));
  if (m_colouring.isEmpty()) {
    for (const Place& place : path) {
      append(line, pixelOf(place.shownMm));
    }
    stroke(line, QPen(ScopePane::curveColor(trace, palette()), 1.4));
    return;
  }
  const auto colourOf = [this](const Place& place) {
    if (!std::isfinite(place.value) || m_range.isEmpty()) {
      return -1;
    }
    const double span = m_range.max - m_range.min;
    const double share = span > 0.0 ? (place.value - m_range.min) / span : 0.5;
    return std::min(kColours - 1, static_cast<int>(share * kColours));
  };
  const auto penOf = [&colors](int colour) {
    return colour < 0 ? QPen(colors.grid, 1.4)
                      : QPen(rampColor((colour + 0.5) / kColours, colors), 2.0);
  };
  int colour = -1;
  for (const Place& place : path) {
    const int now = colourOf(place);
    if (now != colour && !line.isEmpty()) {
      // The next colour begins where this one ends.
      const QPointF last = line.last();
      stroke(line, penOf(colour));
      line.append(last);
    }
    colour = now;
    append(line, pixelOf(place.shownMm));
  }
  stroke(line, penOf(colour));
}

void PathPane::drawScaleBar(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const double lengthMm = base::niceStepBelow(std::max(room().width() / 4.0 / m_pxPerMm, 1e-9));
  const double lengthPx = lengthMm * m_pxPerMm;
  const double y = kMarginPx / 2.0 + 2.0;
  painter.setPen(QPen(colors.text, 2));
  painter.drawLine(QPointF(kMarginPx, y), QPointF(kMarginPx + lengthPx, y));
  painter.drawText(QPointF(kMarginPx + lengthPx + 6.0, y + fontMetrics().ascent() / 2.0),
                   lengthText(lengthMm, base::decimalsOfStep(lengthMm)));
  if (m_enlargement > 1.0 && canEnlarge()) {
    painter.drawText(
        QRectF(0.0, y - fontMetrics().height() / 2.0, width() - kMarginPx, fontMetrics().height()),
        Qt::AlignRight | Qt::AlignVCenter, tr("Error × %1").arg(numberText(m_enlargement, 0)));
  }
}

void PathPane::drawAxes(QPainter& painter) const {
  const QPointF origin(kMarginPx + kAxisPx, room().bottom() - kAxisPx + kMarginPx);
  painter.setPen(QPen(themeColors(palette()).mutedText, 1.6));
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    base::Vec3 unit;
    unit.set(axis, 1.0);
    const overview::PlanePoint along = m_projection(unit);
    const QPointF direction(along.right * kAxisPx, -along.up * kAxisPx);
    painter.drawLine(origin, origin + direction);
    painter.drawText(QRectF(origin + direction * 1.35 - QPointF(10.0, 10.0), QSizeF(20.0, 20.0)),
                     Qt::AlignCenter, QString(QLatin1Char(base::kAxisNames[axis])));
  }
}

QRectF PathPane::rampBar() const {
  const double top =
      height() - fontMetrics().height() - 6.0 - rampHeightPx() + fontMetrics().height() + 2.0;
  return {kMarginPx, top, width() - 2.0 * kMarginPx, kRampPx};
}

QString PathPane::valueText(double value) const {
  return QLocale().toString(value, 'g', kValueDigits);
}

void PathPane::drawRamp(QPainter& painter) const {
  if (m_colouring.isEmpty()) {
    return;
  }
  const ThemeColors& colors = themeColors(palette());
  const QRectF bar = rampBar();
  const double line = fontMetrics().height();
  QString title = m_curves->title(m_colouring);
  if (const QString unit = m_curves->unit(m_colouring); !unit.isEmpty()) {
    title += QStringLiteral(", ") + unit;
  }
  painter.setPen(colors.text);
  const QRectF above(bar.left(), bar.top() - line - 2.0, bar.width(), line);
  painter.drawText(above, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(
                       !m_range.isEmpty() ? title : tr("%1: no values here").arg(title),
                       Qt::ElideRight, static_cast<int>(above.width())));
  if (m_range.isEmpty()) {
    return;
  }
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= kColours; ++i) {
    const double share = static_cast<double>(i) / kColours;
    gradient.setColorAt(share, rampColor(share, colors));
  }
  painter.fillRect(bar, gradient);
  const QRectF below(bar.left(), bar.bottom() + 1.0, bar.width(), line);
  painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, valueText(m_range.min));
  painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, valueText(m_range.max));
  painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter,
                   valueText((m_range.min + m_range.max) / 2.0));
}

std::optional<PathPane::Place> PathPane::placeAt(double atS) const {
  const Course course = courseOf(0);
  if (!course.x) {
    return std::nullopt;
  }
  const base::Instant at = instantOf(atS);
  const base::Vec3 positionMm{trace::valueAt(*course.x, at), trace::valueAt(*course.y, at),
                              course.z ? trace::valueAt(*course.z, at) : 0.0};
  return base::isFinite(positionMm) ? std::optional(placeOn(course, at, positionMm)) : std::nullopt;
}

std::optional<QPointF> PathPane::placeOf(double atS) const {
  const auto shown = shownMm(atS);
  return shown ? std::optional(pixelOf(*shown)) : std::nullopt;
}

std::optional<base::Vec3> PathPane::shownMm(double atS) const {
  const auto place = placeAt(atS);
  return place ? std::optional(place->shownMm) : std::nullopt;
}

QString PathPane::placeText() const {
  const auto& at = m_cursors->atS(ScopeCursors::A);
  const Course course = courseOf(0);
  if (!at || !course.x) {
    return {};
  }
  const auto valueOf = [&at](const ScopeCurves::Samples& samples) {
    return samples ? trace::valueAt(*samples, instantOf(*at)) : std::nan("");
  };
  if (!std::isfinite(valueOf(course.x)) || !std::isfinite(valueOf(course.y))) {
    return {};
  }
  QString text = QStringLiteral("X %1  Y %2")
                     .arg(numberText(valueOf(course.x), 3), numberText(valueOf(course.y), 3));
  if (course.z && std::isfinite(valueOf(course.z))) {
    text += QStringLiteral("  Z %1").arg(numberText(valueOf(course.z), 3));
  }
  for (const char* name : {"program_line", "line"}) {
    const auto lines = m_curves->samples(0, QLatin1String(name));
    const double line = lines ? trace::heldValueAt(*lines, instantOf(*at)) : std::nan("");
    if (std::isfinite(line)) {
      return text + QStringLiteral("  ") + tr("line %1").arg(line, 0, 'f', 0);
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
  // The value of cursor A on the scale of the colours.
  const auto& at = m_cursors->atS(ScopeCursors::A);
  const auto values = at && m_range.max > m_range.min ? m_curves->samples(0, m_colouring) : nullptr;
  const double value = values ? trace::valueAt(*values, instantOf(*at)) : std::nan("");
  if (std::isfinite(value)) {
    const QRectF bar = rampBar();
    const double share = std::clamp((value - m_range.min) / (m_range.max - m_range.min), 0.0, 1.0);
    const QPointF tip(bar.left() + share * bar.width(), bar.bottom() - 1.0);
    painter.setPen(QPen(colors.surface, 1.0));
    painter.setBrush(colors.text);
    painter.drawPolygon(
        QPolygonF{tip, tip + QPointF(-5.0, -kRampPx - 1.0), tip + QPointF(5.0, -kRampPx - 1.0)});
  }
  painter.setPen(colors.text);
  painter.drawText(low, Qt::AlignLeft | Qt::AlignVCenter, placeText());
  if (hasFocus()) {
    painter.setPen(QPen(colors.accent, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
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
  if (event->button() == Qt::LeftButton) {
    m_pressed = event->position();
    m_dragged = m_pressed;
    m_isDragging = false;
  }
}

void PathPane::mouseMoveEvent(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton) || !m_isSpatial) {
    return;
  }
  const QPointF way = event->position() - m_pressed;
  m_isDragging = m_isDragging || way.manhattanLength() >= QApplication::startDragDistance();
  if (m_isDragging) {
    const QPointF by = event->position() - m_dragged;
    m_dragged = event->position();
    turn(-by.x() * overview::Projection::kDegPerPx, by.y() * overview::Projection::kDegPerPx);
  }
}

void PathPane::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !m_isDragging) {
    chooseAt(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
  }
  m_isDragging = false;
}

void PathPane::chooseAt(QPointF pixel, bool isSecond) {
  const Place* nearest = nullptr;
  double least = kClickPx;
  for (const std::vector<Place>& path : m_paths) {
    for (const Place& place : path) {
      const QPointF off = pixelOf(place.shownMm) - pixel;
      const double distance = std::hypot(off.x(), off.y());
      if (distance < least) {
        least = distance;
        nearest = &place;
      }
    }
  }
  if (nearest != nullptr) {
    m_cursors->set(isSecond ? ScopeCursors::B : ScopeCursors::A, nearest->atS);
  }
}

void PathPane::keyPressEvent(QKeyEvent* event) {
  if (m_isSpatial) {
    switch (event->key()) {
      case Qt::Key_Left:
        turn(overview::Projection::kKeyDeg, 0.0);
        return;
      case Qt::Key_Right:
        turn(-overview::Projection::kKeyDeg, 0.0);
        return;
      case Qt::Key_Up:
        turn(0.0, -overview::Projection::kKeyDeg);
        return;
      case Qt::Key_Down:
        turn(0.0, overview::Projection::kKeyDeg);
        return;
      case Qt::Key_Home:
        m_turned = overview::Projection::isometric();
        turn(0.0, 0.0);
        return;
      default:
        break;
    }
  }
  Page::keyPressEvent(event);
}

void PathPane::retranslate() {
  setAccessibleName(tr("Path of the axes"));
  setToolTip(
      tr("The path during the time shown. Click: cursor A. Shift and click: cursor B. In 3D, drag "
         "or the arrow keys turn it, Home turns it back."));
  schedule();
}

}  // namespace rivulet::widgets
