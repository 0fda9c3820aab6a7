// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/path_canvas.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kMarginPx = 44.0;               // room for scale bar, axes and legend
constexpr double kThinningPx = 0.7;              // moves shorter than this on the screen are merged
constexpr std::size_t kSmoothVertices = 20'000;  // above, smooth lines cost more than they show
constexpr qsizetype kPieceVertices = 128;  // a wide line is filled as one shape: keep shapes small
constexpr double kPixelsPerMmMin = 1e-3;
constexpr double kPixelsPerMmMax = 1e5;

/// 1, 2 or 5 times a power of ten, not below `value`.
double roundUp125(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value * (1.0 - 1e-9)) {
      return step * power;
    }
  }
  return 10.0 * power;
}

/// On which sides of a rectangle a point lies; two points with a common side do not cross it.
unsigned outside(QPointF point, const QRectF& rect) {
  return (point.x() < rect.left() ? 1U : 0U) | (point.x() > rect.right() ? 2U : 0U) |
         (point.y() < rect.top() ? 4U : 0U) | (point.y() > rect.bottom() ? 8U : 0U);
}

}  // namespace

PathCanvas::PathCanvas(QWidget* parent) : QWidget(parent) {
  setMouseTracking(false);
  setCursor(Qt::OpenHandCursor);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void PathCanvas::setTexts(const Texts& texts) {
  m_texts = texts;
  dropPicture();
}

void PathCanvas::setProgram(std::shared_ptr<const gcode::Program> program) {
  m_program = std::move(program);
  std::vector<Vertex> vertices;
  if (m_program) {
    const auto& points = m_program->trajectory.points;
    // Coordinates the program has not named yet are drawn where it names them first.
    base::Vec3 open;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const auto named = std::find_if(points.begin(), points.end(), [axis](const auto& point) {
        return std::isfinite(point.positionMm[axis]);
      });
      open.set(axis, named == points.end() ? 0.0 : named->positionMm[axis]);
    }
    vertices.reserve(points.size());
    for (const gcode::TrajectoryPoint& point : points) {
      base::Vec3 position = point.positionMm;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (!std::isfinite(position[axis])) {
          position.set(axis, open[axis]);
        }
      }
      vertices.push_back({position, point.kind == gcode::MoveKind::Rapid});
    }
  }
  m_executed = 0;
  takeVertices(std::move(vertices));
  fit();
}

void PathCanvas::setPoints(const std::vector<gcode::StreamPoint>& points) {
  std::vector<Vertex> vertices;
  vertices.reserve(points.size());
  // Streamed points are the programmed ones without repetitions, so both lists are walked
  // together to learn which moves are rapids.
  std::size_t programmed = 0;
  for (const gcode::StreamPoint& point : points) {
    bool isRapid = false;
    if (m_program) {
      const auto& trajectory = m_program->trajectory.points;
      while (programmed < trajectory.size() && trajectory[programmed].line < point.line) {
        ++programmed;
      }
      isRapid = programmed < trajectory.size() && trajectory[programmed].line == point.line &&
                trajectory[programmed].kind == gcode::MoveKind::Rapid;
    }
    vertices.push_back({point.positionMm, isRapid});
  }
  takeVertices(std::move(vertices));
  if (m_fits) {
    fit();
  }
}

void PathCanvas::setExecuted(std::size_t count) {
  count = std::min(count, m_vertices.size());
  if (count == m_executed) {
    return;
  }
  if (count < m_executedInPicture) {
    dropPicture();
  }
  m_executed = count;
  update();
}

void PathCanvas::setToolPosition(const std::optional<base::Vec3>& positionMm) {
  m_toolMm = positionMm && base::isFinite(*positionMm) ? positionMm : std::nullopt;
  update();
}

void PathCanvas::setView(View view) {
  if (view != m_view) {
    m_view = view;
    project();
    fit();
  }
}

void PathCanvas::fit() {
  m_fits = true;
  dropPicture();
  if (m_projectedMm.empty()) {
    m_centreMm = {};
    m_pixelsPerMm = 10.0;
    return;
  }
  const auto [left, right] =
      std::minmax_element(m_projectedMm.begin(), m_projectedMm.end(),
                          [](QPointF a, QPointF b) { return a.x() < b.x(); });
  const auto [low, high] = std::minmax_element(m_projectedMm.begin(), m_projectedMm.end(),
                                               [](QPointF a, QPointF b) { return a.y() < b.y(); });
  m_centreMm = {(left->x() + right->x()) / 2.0, (low->y() + high->y()) / 2.0};
  const double widthMm = std::max(right->x() - left->x(), 1e-3);
  const double heightMm = std::max(high->y() - low->y(), 1e-3);
  m_pixelsPerMm = std::clamp(std::min(std::max(width() - 2.0 * kMarginPx, 20.0) / widthMm,
                                      std::max(height() - 2.0 * kMarginPx, 20.0) / heightMm),
                             kPixelsPerMmMin, kPixelsPerMmMax);
}

void PathCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    dropPicture();
  }
  QWidget::changeEvent(event);
}

void PathCanvas::resizeEvent(QResizeEvent* /*event*/) {
  dropPicture();
  if (m_fits) {
    fit();
  }
}

void PathCanvas::paintEvent(QPaintEvent* /*event*/) {
  if (m_picture.isNull()) {
    makePicture();
  }
  if (m_executedInPicture < m_executed) {
    QPainter painter(&m_picture);
    drawExecuted(painter, m_executedInPicture, m_executed);
    m_executedInPicture = m_executed;
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, m_picture);
  if (m_vertices.empty()) {
    painter.setPen(themeColors(palette()).mutedText);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_texts.empty);
  } else {
    drawStart(painter);
    drawLegend(painter);
  }
  drawScaleBar(painter);
  drawAxes(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawTool(painter);
}

void PathCanvas::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(1.0015, event->angleDelta().y());
  const double before = m_pixelsPerMm;
  m_pixelsPerMm = std::clamp(before * factor, kPixelsPerMmMin, kPixelsPerMmMax);
  // What lies under the pointer stays there.
  const QPointF fromCentre = event->position() - QPointF(width() / 2.0, height() / 2.0);
  const double shift = 1.0 / before - 1.0 / m_pixelsPerMm;
  m_centreMm += QPointF(fromCentre.x() * shift, -fromCentre.y() * shift);
  m_fits = false;
  dropPicture();
  event->accept();
}

void PathCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    m_dragFrom = event->position();
    setCursor(Qt::ClosedHandCursor);
  }
}

void PathCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragFrom) {
    const QPointF moved = event->position() - *m_dragFrom;
    m_dragFrom = event->position();
    m_centreMm += QPointF(-moved.x(), moved.y()) / m_pixelsPerMm;
    m_fits = false;
    dropPicture();
  }
}

void PathCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  m_dragFrom.reset();
  setCursor(Qt::OpenHandCursor);
}

void PathCanvas::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
  fit();
}

void PathCanvas::takeVertices(std::vector<Vertex> vertices) {
  m_vertices = std::move(vertices);
  m_executed = std::min(m_executed, m_vertices.size());
  project();
}

void PathCanvas::project() {
  m_projectedMm.clear();
  m_projectedMm.reserve(m_vertices.size());
  for (const Vertex& vertex : m_vertices) {
    m_projectedMm.push_back(projected(vertex.positionMm));
  }
  dropPicture();
}

void PathCanvas::dropPicture() {
  m_picture = QPixmap();
  m_executedInPicture = 0;
  update();
}

void PathCanvas::makePicture() {
  const qreal ratio = devicePixelRatioF();
  m_picture = QPixmap(size() * ratio);
  m_picture.setDevicePixelRatio(ratio);
  const ThemeColors& colors = themeColors(palette());
  m_picture.fill(colors.surface);
  QPainter painter(&m_picture);
  drawGrid(painter);
  m_drawnVertices = 0;
  if (!m_vertices.empty()) {
    QPen rapid(colors.rapid, 1.2);
    rapid.setDashPattern({5.0, 4.0});
    m_drawnVertices = drawMoves(painter, 1, m_vertices.size(), QPen(colors.path, 1.4), rapid);
    drawExecuted(painter, 0, m_executed);
    m_executedInPicture = m_executed;
  }
}

std::size_t PathCanvas::drawMoves(QPainter& painter, std::size_t from, std::size_t to,
                                  const QPen& cut, const QPen& rapid) const {
  // Runs of moves of one kind become polylines; a move is merged into the next one while it
  // stays below the resolution of the screen, and left out when it cannot cross the picture.
  const QRectF visible = QRectF(rect()).adjusted(-8.0, -8.0, 8.0, 8.0);
  std::vector<QPolygonF> cuts;
  std::vector<QPolygonF> rapids;
  std::size_t vertices = 0;
  QPolygonF line;
  bool lineIsRapid = false;
  const auto finish = [&] {
    if (line.size() > 1) {
      vertices += static_cast<std::size_t>(line.size());
      (lineIsRapid ? rapids : cuts).push_back(line);
    }
    line.clear();
  };
  QPointF last = onScreen(m_projectedMm[from - 1]);
  for (std::size_t index = from; index < to; ++index) {
    const QPointF next = onScreen(m_projectedMm[index]);
    const bool isRapid = m_vertices[index].isRapid;
    const bool endsRun = index + 1 == to || m_vertices[index + 1].isRapid != isRapid;
    if (!line.isEmpty() && isRapid != lineIsRapid) {
      finish();
    }
    const QPointF step = next - last;
    if (!endsRun && std::abs(step.x()) < kThinningPx && std::abs(step.y()) < kThinningPx) {
      continue;
    }
    if ((outside(last, visible) & outside(next, visible)) != 0) {
      finish();
    } else {
      if (line.isEmpty()) {
        lineIsRapid = isRapid;
        line.append(last);
      }
      line.append(next);
      if (line.size() == kPieceVertices) {
        finish();  // the next piece begins where this one ends
      }
    }
    last = next;
  }
  finish();
  const bool smooth = vertices < kSmoothVertices;
  painter.setRenderHint(QPainter::Antialiasing, smooth);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(rapid);
  for (const QPolygonF& polygon : rapids) {
    painter.drawPolyline(polygon);
  }
  QPen cutPen = cut;
  if (!smooth && cut.widthF() < 2.0) {
    cutPen.setWidthF(1.0);  // thin lines are drawn, not filled: many times faster
  }
  painter.setPen(cutPen);
  for (const QPolygonF& polygon : cuts) {
    painter.drawPolyline(polygon);
  }
  return vertices;
}

void PathCanvas::drawExecuted(QPainter& painter, std::size_t from, std::size_t to) {
  if (to < 2 || to <= from) {
    return;
  }
  const ThemeColors& colors = themeColors(palette());
  QPen cut(colors.accent, 3.0);
  cut.setCapStyle(Qt::RoundCap);
  cut.setJoinStyle(Qt::RoundJoin);
  QPen rapid(colors.accent, 2.0);
  rapid.setDashPattern({4.0, 3.0});
  drawMoves(painter, std::max<std::size_t>(from, 1), to, cut, rapid);
}

void PathCanvas::drawGrid(QPainter& painter) const {
  if (m_view != View::Top) {
    return;  // a grid of the screen would not be one of the machine
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(themeColors(palette()).grid);
  const double stepMm = gridStepMm();
  const double halfWidthMm = width() / 2.0 / m_pixelsPerMm;
  const double halfHeightMm = height() / 2.0 / m_pixelsPerMm;
  const auto firstX = std::llround(std::floor((m_centreMm.x() - halfWidthMm) / stepMm));
  const auto lastX = std::llround(std::ceil((m_centreMm.x() + halfWidthMm) / stepMm));
  for (auto line = firstX; line <= lastX; ++line) {
    const double x = onScreen({static_cast<double>(line) * stepMm, 0.0}).x();
    painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
  }
  const auto firstY = std::llround(std::floor((m_centreMm.y() - halfHeightMm) / stepMm));
  const auto lastY = std::llround(std::ceil((m_centreMm.y() + halfHeightMm) / stepMm));
  for (auto line = firstY; line <= lastY; ++line) {
    const double y = onScreen({0.0, static_cast<double>(line) * stepMm}).y();
    painter.drawLine(QPointF(0.0, y), QPointF(width(), y));
  }
}

void PathCanvas::drawScaleBar(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const double lengthMm = gridStepMm();
  // Seen isometrically, each axis is foreshortened: the bar is true along the axes.
  const double foreshortening = m_view == View::Top ? 1.0 : std::sqrt(2.0 / 3.0);
  const double lengthPx = lengthMm * m_pixelsPerMm * foreshortening;
  const QPointF right(width() - 14.0, height() - 14.0);
  const QPointF left = right - QPointF(lengthPx, 0.0);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(colors.text, 2.0));
  painter.drawLine(left, right);
  painter.drawLine(left - QPointF(0.0, 5.0), left);
  painter.drawLine(right - QPointF(0.0, 5.0), right);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(lengthMm) - 1e-9)));
  painter.drawText(QRectF(right.x() - 200.0, right.y() - 26.0, 200.0, 20.0),
                   Qt::AlignRight | Qt::AlignVCenter, lengthText(lengthMm, decimals));
}

void PathCanvas::drawAxes(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const bool top = m_view == View::Top;
  const QPointF origin(top ? 18.0 : 26.0, height() - (top ? 18.0 : 36.0));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.mutedText, 1.6));
  for (std::size_t axis = 0; axis < (top ? 2U : 3U); ++axis) {
    base::Vec3 unit;
    unit.set(axis, 1.0);
    const QPointF along = projected(unit);
    const QPointF direction(along.x() * 34.0, -along.y() * 34.0);
    painter.drawLine(origin, origin + direction);
    painter.drawText(QRectF(origin + direction * 1.3 - QPointF(10.0, 10.0), QSizeF(20.0, 20.0)),
                     Qt::AlignCenter, QString(QLatin1Char(base::kAxisNames[axis])));
  }
}

void PathCanvas::drawLegend(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  QPen rapid(colors.rapid, 1.2);
  rapid.setDashPattern({5.0, 4.0});
  const std::array<std::pair<QPen, QString>, 3> entries{
      {{QPen(colors.accent, 3.0), m_texts.executed},
       {QPen(colors.path, 1.4), m_texts.cut},
       {rapid, m_texts.rapid}}};
  double x = 12.0;
  constexpr double kY = 16.0;
  for (const auto& [pen, text] : entries) {
    const double textWidth = painter.fontMetrics().horizontalAdvance(text);
    painter.setPen(pen);
    painter.drawLine(QPointF(x, kY), QPointF(x + 30.0, kY));
    painter.setPen(colors.text);
    painter.drawText(QRectF(x + 36.0, kY - 10.0, textWidth + 4.0, 20.0),
                     Qt::AlignLeft | Qt::AlignVCenter, text);
    x += 36.0 + textWidth + 22.0;
  }
}

void PathCanvas::drawStart(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const QPointF start = onScreen(m_projectedMm.front());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.text, 1.6));
  painter.setBrush(colors.surface);
  painter.drawEllipse(start, 5.0, 5.0);
  painter.drawText(start + QPointF(8.0, -7.0), m_texts.start);
}

void PathCanvas::drawTool(QPainter& painter) const {
  if (!m_toolMm) {
    return;
  }
  const ThemeColors& colors = themeColors(palette());
  const QPointF tool = onScreen(projected(*m_toolMm));
  const auto cross = [&](const QPen& pen) {
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(tool, 8.0, 8.0);
    for (const QPointF direction :
         {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)}) {
      painter.drawLine(tool + 4.0 * direction, tool + 16.0 * direction);
    }
  };
  cross(QPen(colors.surface, 5.0));  // stands out from any path under it
  cross(QPen(colors.text, 2.0));
  const QString label = QStringLiteral("%1 X %2 Y %3 Z %4")
                            .arg(m_texts.tool, numberText(m_toolMm->x, 2),
                                 numberText(m_toolMm->y, 2), lengthText(m_toolMm->z, 2));
  QRectF box = QRectF(painter.fontMetrics().boundingRect(label)).adjusted(-6, -3, 6, 3);
  box.moveBottomLeft(tool + QPointF(14.0, -12.0));
  // The label never leaves the picture, wherever the tool is.
  box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, width() - box.width() - 4.0)));
  box.moveTop(std::clamp(box.top(), 30.0, std::max(30.0, height() - box.height() - 4.0)));
  painter.setPen(colors.line);
  painter.setBrush(colors.surface);
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setPen(colors.text);
  painter.drawText(box, Qt::AlignCenter, label);
}

QPointF PathCanvas::projected(base::Vec3 positionMm) const {
  if (m_view == View::Top) {
    return {positionMm.x, positionMm.y};
  }
  // Seen from front, left and above alike: X to the lower right, Y to the upper right, Z up.
  static const double root2 = std::sqrt(2.0);
  static const double root6 = std::sqrt(6.0);
  return {(positionMm.x + positionMm.y) / root2,
          (-positionMm.x + positionMm.y + 2.0 * positionMm.z) / root6};
}

QPointF PathCanvas::onScreen(QPointF projectedMm) const {
  return {width() / 2.0 + (projectedMm.x() - m_centreMm.x()) * m_pixelsPerMm,
          height() / 2.0 - (projectedMm.y() - m_centreMm.y()) * m_pixelsPerMm};
}

double PathCanvas::gridStepMm() const {
  return roundUp125(64.0 / m_pixelsPerMm);
}

}  // namespace rivulet::widgets
