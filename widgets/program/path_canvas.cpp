// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/path_canvas.h"

#include <QEvent>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/program/thin_line.h"

namespace rivulet::widgets {

namespace {

using overview::Projection;

constexpr double kMarginPx = 44.0;             // room for scale bar and axes
constexpr double kTolerancePx = 0.4;           // what a level may leave out on the screen
constexpr double kThinningPx = 0.7;            // moves shorter than this on the screen are merged
constexpr std::size_t kSmoothMoves = 2'000;    // above, smooth lines cost more than they show
constexpr double kSmoothPx = 60'000.0;         // and so do long ones
constexpr double kMovePxMax = 3'000.0;         // of a move that is drawn, as it is clipped
constexpr std::size_t kFineMoves = 3'000'000;  // of the fine picture: it is to come to an end
constexpr qsizetype kPieceVertices = 128;  // a wide line is filled as one shape: keep shapes small
constexpr double kPixelsPerMmMin = 1e-3;
constexpr double kPixelsPerMmMax = 1e5;
constexpr double kNearPx = 14.0;             // a finger does not hit a line
constexpr double kToolPx = 16.0;             // from the tool to the ends of its cross
constexpr double kClickPx = 4.0;             // a press that moves no farther is a click
constexpr double kMarkCellPx = 18.0;         // of marks in one such cell one is drawn
constexpr std::size_t kSelectedMax = 2'000;  // moves shown as chosen
constexpr double kKeyPx = 40.0;              // an arrow moves by this
constexpr double kKeyZoom = 1.25;            // + zooms by this
constexpr double kFloorLinesMax = 40.0;      // in each direction
constexpr int kRestMs = 120;  // after the last move of the picture the fine one is made

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

/// @param corner  one bit per axis, set: the largest coordinate
base::Vec3 cornerOf(const PathCanvas::Box& box, unsigned corner) {
  base::Vec3 placeMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    placeMm.set(axis, ((corner >> axis) & 1U) != 0 ? box.highestMm[axis] : box.lowestMm[axis]);
  }
  return placeMm;
}

/// Of a view along an axis: from above, from the front and from the right.
Projection::Angles anglesOf(PathCanvas::View view) {
  switch (view) {
    case PathCanvas::View::Front:
      return {0.0, 0.0};
    case PathCanvas::View::Side:
      return {90.0, 0.0};
    case PathCanvas::View::Space:
    case PathCanvas::View::Top:
      break;
  }
  return {};
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
  setFocusPolicy(Qt::StrongFocus);
  grabGesture(Qt::PinchGesture);
  setAttribute(Qt::WA_OpaquePaintEvent);
  m_refineTimer.setSingleShot(true);
  connect(&m_refineTimer, &QTimer::timeout, this, &PathCanvas::refine);
}

void PathCanvas::setTexts(const Texts& texts) {
  m_texts = texts;
  update();
}

void PathCanvas::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_executed = 0;
  m_runBegin = 0;
  m_selected.clear();
  m_marked.reset();
  replaceProgram(std::move(view));
  fit();
}

void PathCanvas::replaceProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  m_pauses.reset();
  m_style = {};
  const std::size_t count = hasPath() ? m_program->points.points.size() : 0;
  m_executed = std::min(m_executed, count);
  if (m_marked && *m_marked >= count) {
    m_marked.reset();
  }
  std::erase_if(m_selected, [count](std::uint32_t point) { return point >= count; });
  dropPicture();
}

void PathCanvas::setStyle(Style style) {
  m_style = std::move(style);
  dropPicture();
  if (m_style.classes &&
      (!hasPath() || m_style.classes->ofLevel.front().size() != m_program->points.points.size())) {
    m_style = {};
  }
}

void PathCanvas::setBox(const std::optional<Box>& box) {
  if (box != m_box) {
    m_box = box;
    fit();
  }
}

void PathCanvas::setExecuted(std::size_t count) {
  count = std::min(count, hasPath() ? m_program->points.points.size() : 0);
  if (count == m_executed) {
    return;
  }
  if (count < m_executedInPicture) {
    dropPicture();
  }
  m_executed = count;
  update();
}

void PathCanvas::setRunBegin(std::size_t point) {
  if (point != m_runBegin) {
    m_runBegin = point;
    dropPicture();
  }
}

void PathCanvas::setToolPosition(const std::optional<base::Vec3>& positionMm) {
  const auto toolMm = positionMm && base::isFinite(*positionMm) ? positionMm : std::nullopt;
  if (toolMm != m_toolMm) {  // an idle machine is read again and again
    QRegion changed = toolRegion();
    m_toolMm = toolMm;
    changed += toolRegion();
    update(changed);
  }
}

PathCanvas::ToolMark PathCanvas::toolMark() const {
  ToolMark mark{onScreen(m_projection(*m_toolMm)),
                QStringLiteral("%1 X %2 Y %3 Z %4")
                    .arg(m_texts.tool, numberText(m_toolMm->x, 2), numberText(m_toolMm->y, 2),
                         lengthText(m_toolMm->z, 2)),
                {}};
  mark.box = QRectF(fontMetrics().boundingRect(mark.label)).adjusted(-6, -3, 6, 3);
  mark.box.moveBottomLeft(mark.place + QPointF(14.0, -12.0));
  // The label never leaves the picture, wherever the tool is.
  mark.box.moveLeft(
      std::clamp(mark.box.left(), 4.0, std::max(4.0, width() - mark.box.width() - 4.0)));
  mark.box.moveTop(
      std::clamp(mark.box.top(), 30.0, std::max(30.0, height() - mark.box.height() - 4.0)));
  return mark;
}

QRegion PathCanvas::toolRegion() const {
  if (!m_toolMm) {
    return {};
  }
  const ToolMark mark = toolMark();
  const QRectF cross(mark.place - QPointF(kToolPx, kToolPx), QSizeF(2 * kToolPx, 2 * kToolPx));
  return QRegion(cross.adjusted(-4, -4, 4, 4).toAlignedRect()) +
         mark.box.adjusted(-2, -2, 2, 2).toAlignedRect();
}

void PathCanvas::setFirstWay(std::vector<base::Vec3> placesMm) {
  if (placesMm != m_firstWayMm) {
    m_firstWayMm = std::move(placesMm);
    fit();
  }
}

void PathCanvas::setSelected(std::vector<std::uint32_t> points) {
  m_selected = std::move(points);
  update();
}

void PathCanvas::setMarked(std::optional<std::size_t> point) {
  m_marked = point;
  update();
}

void PathCanvas::setPauses(std::shared_ptr<const overview::PauseMap> pauses) {
  m_pauses = std::move(pauses);
  const std::size_t count = hasPath() ? m_program->points.points.size() : 0;
  const auto fits = [count](const std::vector<std::uint32_t>& list) {
    return list.empty() || list.back() < count;
  };
  if (m_pauses && !(fits(m_pauses->offCut) && fits(m_pauses->inCut))) {
    m_pauses.reset();  // of another program
  }
  m_marks = QImage();
  update();
}

void PathCanvas::reveal(std::size_t point) {
  // When fitted, every point is visible, or will be when the widget gets its size.
  const QPointF place = placeOf(point);
  if (!m_fits && !QRectF(rect()).adjusted(kNearPx, kNearPx, -kNearPx, -kNearPx).contains(place)) {
    m_centreMm = m_projection(m_program->points.points[point].positionMm);
    m_fits = false;
    dropPicture();
  }
}

void PathCanvas::setView(View view) {
  if (view != m_view) {
    m_view = view;
    m_projection = Projection(angles());
    fit();
  }
}

Projection::Angles PathCanvas::angles() const {
  return m_view == View::Space ? m_turned : anglesOf(m_view);
}

void PathCanvas::turn(double byDeg, double tiltByDeg) {
  if (m_view != View::Space || (!hasPath() && !m_box)) {
    return;
  }
  const overview::SpaceBox box = spaceBox();
  base::Vec3 middleMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    middleMm.set(axis, 0.5 * (static_cast<double>(box.low[axis]) + box.high[axis]));
  }
  const overview::PlanePoint before = m_projection(middleMm);
  m_turned = m_turned.turned(byDeg, tiltByDeg);
  m_projection = Projection(m_turned);
  const overview::PlanePoint after = m_projection(middleMm);
  m_centreMm.right += after.right - before.right;
  m_centreMm.up += after.up - before.up;
  m_fits = false;
  dropPicture();
}

void PathCanvas::fit() {
  m_fits = true;
  dropPicture();
  if (!hasPath() && !m_box) {
    m_centreMm = {};
    m_pixelsPerMm = 10.0;
    return;
  }
  const overview::PlaneBox box = fitted();
  m_centreMm = {0.5 * (box.left + box.right), 0.5 * (box.low + box.high)};
  const double widthMm = std::max(box.right - box.left, 1e-3);
  const double heightMm = std::max(box.high - box.low, 1e-3);
  m_pixelsPerMm = std::clamp(std::min(std::max(width() - 2.0 * kMarginPx, 20.0) / widthMm,
                                      std::max(height() - 2.0 * kMarginPx, 20.0) / heightMm),
                             kPixelsPerMmMin, kPixelsPerMmMax);
}

overview::PlaneBox PathCanvas::fitted() const {
  if (m_box) {
    return m_projection(spaceBox());
  }
  const std::vector<overview::SpaceBox>& boxes = levels().front().boxes;
  overview::PlaneBox fitted = m_projection(boxes.front());
  for (const overview::SpaceBox& box : boxes) {
    fitted.widen(m_projection(box));
  }
  for (const base::Vec3& placeMm : m_firstWayMm) {
    const overview::PlanePoint place = m_projection(placeMm);
    fitted.widen({place.right, place.right, place.up, place.up});
  }
  return fitted;
}

overview::SpaceBox PathCanvas::spaceBox() const {
  if (!m_box) {
    return m_program->levels.box();
  }
  overview::SpaceBox box;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    box.low[axis] = static_cast<float>(m_box->lowestMm[axis]);
    box.high[axis] = static_cast<float>(m_box->highestMm[axis]);
  }
  return box;
}

std::optional<std::size_t> PathCanvas::pointNear(QPointF place) const {
  if (!hasPath()) {
    return std::nullopt;
  }
  const std::vector<gcode::StreamPoint>& points = m_program->points.points;
  const auto at = [&](std::size_t i) { return onScreen(m_projection(points[i].positionMm)); };
  const auto length = [](QPointF v) { return std::hypot(v.x(), v.y()); };
  if (points.size() == 1) {
    return length(at(0) - place) <= kNearPx ? std::optional<std::size_t>(0) : std::nullopt;
  }
  const std::vector<overview::SpaceBox>& boxes = levels().front().boxes;
  double nearest = kNearPx;
  double nearestEnd = 0.0;
  std::optional<std::size_t> found;
  for (std::size_t chunk = 0; chunk < boxes.size(); ++chunk) {
    if (!isNear(m_projection(boxes[chunk]), place)) {
      continue;
    }
    const std::size_t first = chunk * overview::kChunkMoves;
    QPointF from = at(first);
    for (std::size_t i = first + 1; i <= std::min(first + overview::kChunkMoves, points.size() - 1);
         ++i) {
      const QPointF to = at(i);
      const QPointF along = to - from;
      const double square = QPointF::dotProduct(along, along);
      const double share =
          square > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0)
                       : 0.0;
      const double distance = length(place - from - share * along);
      const double toStart = length(place - from);
      const double toEnd = length(place - to);
      const double end = std::min(toStart, toEnd);
      if (distance < nearest || (distance == nearest && found && end < nearestEnd)) {
        nearest = distance;
        nearestEnd = end;
        found = toStart < toEnd ? i - 1 : i;
      }
      from = to;
    }
  }
  return found;
}

bool PathCanvas::isNear(const overview::PlaneBox& box, QPointF place) const {
  const QPointF upperLeft = onScreen({box.left, box.high});
  const QPointF lowerRight = onScreen({box.right, box.low});
  return place.x() >= upperLeft.x() - kNearPx && place.x() <= lowerRight.x() + kNearPx &&
         place.y() >= upperLeft.y() - kNearPx && place.y() <= lowerRight.y() + kNearPx;
}

std::optional<PathCanvas::Pause> PathCanvas::pauseNear(QPointF place) const {
  if (!hasPath() || !m_pauses) {
    return std::nullopt;
  }
  const std::vector<overview::SpaceBox>& boxes = levels().front().boxes;
  double nearest = kNearPx;
  std::optional<Pause> found;
  for (std::size_t chunk = 0; chunk < boxes.size(); ++chunk) {
    if (!isNear(m_projection(boxes[chunk]), place)) {
      continue;
    }
    // Of two in one place, the one in the cut is reported: it is the one that is drawn.
    for (const bool inCut : {true, false}) {
      const std::vector<std::uint32_t>& list = inCut ? m_pauses->inCut : m_pauses->offCut;
      const std::size_t end =
          std::min((chunk + 1) * overview::kChunkMoves, m_program->points.points.size());
      for (auto at = std::lower_bound(list.begin(), list.end(), chunk * overview::kChunkMoves);
           at != list.end() && *at <= end; ++at) {
        const QPointF way = placeOf(*at) - place;
        const double distance = std::hypot(way.x(), way.y());
        if (distance < nearest) {
          nearest = distance;
          found = Pause{*at, inCut};
        }
      }
    }
  }
  return found;
}

QPointF PathCanvas::placeOf(std::size_t point) const {
  return onScreen(m_projection(m_program->points.points.at(point).positionMm));
}

bool PathCanvas::event(QEvent* event) {
  if (event->type() == QEvent::Gesture) {
    auto* gestures = static_cast<QGestureEvent*>(event);
    auto* pinch = static_cast<QPinchGesture*>(gestures->gesture(Qt::PinchGesture));
    if (pinch == nullptr) {
      return false;
    }
    m_drag.from.reset();
    if (pinch->scaleFactor() > 0.0) {
      zoom(pinch->scaleFactor(), mapFromGlobal(pinch->centerPoint()));
    }
    pan(pinch->centerPoint() - pinch->lastCenterPoint());
    gestures->accept(pinch);
    return true;
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const std::optional<Pause> pause = pauseNear(help->pos())) {
      QToolTip::showText(help->globalPos(),
                         (pause->inCut ? m_texts.pauseInCut : m_texts.pauseOffCut)
                             .arg(countText(pause->point + 1),
                                  countText(m_program->points.points[pause->point].line.value)),
                         this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QWidget::event(event);
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
  m_drawn.now = 0;
  if (m_executed > m_executedInPicture + kPathMoves) {
    m_picture = QImage();  // more than a frame may cost: the levels do it
  }
  if (m_picture.isNull()) {
    makePicture();
  }
  if (m_executedInPicture < m_executed) {
    drawExecuted(m_picture, m_executedInPicture, m_executed);
    m_executedInPicture = m_executed;
  }
  if (m_marks.isNull() && m_pauses) {
    makeMarks();
  }
  QPainter painter(this);
  painter.drawImage(0, 0, m_picture);
  // Where the density is shown as colour, marks come when each of them has a place.
  const bool showsDensity =
      m_style.classes && m_style.classes->classes.colouring == overview::PathColouring::Pauses;
  if (m_pauses && (!showsDensity || m_drawn.pauses == m_drawn.pausesSeen)) {
    painter.drawImage(0, 0, m_marks);
  }
  drawBox(painter);
  if (!hasPath()) {
    painter.setPen(themeColors(palette()).mutedText);
    if (m_box) {  // above the box, which the path will fill
      painter.drawText(rect().adjusted(0, 8, 0, 0), Qt::AlignHCenter | Qt::TextWordWrap,
                       m_texts.emptyBox);
    } else {
      painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_texts.empty);
    }
  } else {
    drawGaps(painter);
    drawFirstWay(painter);
    drawStart(painter);
    drawToolChanges(painter);
    drawChosen(painter);
  }
  drawScaleBar(painter);
  drawAxes(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawTool(painter);
}

void PathCanvas::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(1.0015, event->angleDelta().y()), event->position());
  event->accept();
}

void PathCanvas::zoom(double factor, QPointF place) {
  const double before = m_pixelsPerMm;
  m_pixelsPerMm = std::clamp(before * factor, kPixelsPerMmMin, kPixelsPerMmMax);
  const QPointF fromCentre = place - QPointF(width() / 2.0, height() / 2.0);
  const double shift = 1.0 / before - 1.0 / m_pixelsPerMm;
  m_centreMm.right += fromCentre.x() * shift;
  m_centreMm.up -= fromCentre.y() * shift;
  m_fits = false;
  dropPicture();
}

void PathCanvas::pan(QPointF byPx) {
  m_centreMm.right -= byPx.x() / m_pixelsPerMm;
  m_centreMm.up += byPx.y() / m_pixelsPerMm;
  m_fits = false;
  dropPicture();
}

void PathCanvas::mousePressEvent(QMouseEvent* event) {
  m_drag.from = event->position();
  m_drag.pressedAt = event->position();
  m_drag.moved = false;
  setCursor(Qt::ClosedHandCursor);
}

void PathCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (!m_drag.from) {
    return;
  }
  m_drag.moved =
      m_drag.moved || (event->position() - m_drag.pressedAt).manhattanLength() > kClickPx;
  if (m_drag.moved) {
    const QPointF by = event->position() - *m_drag.from;
    m_drag.from = event->position();
    if (m_view == View::Space && event->buttons().testFlag(Qt::LeftButton) &&
        !event->modifiers().testFlag(Qt::ShiftModifier)) {
      turn(-by.x() * Projection::kDegPerPx, by.y() * Projection::kDegPerPx);
    } else {
      pan(by);
    }
  }
}

void PathCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (m_drag.from && !m_drag.moved && event->button() == Qt::LeftButton) {
    if (const std::optional<std::size_t> point = pointNear(event->position())) {
      Q_EMIT pointClicked(*point);
    }
  }
  m_drag.from.reset();
  setCursor(Qt::OpenHandCursor);
}

void PathCanvas::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
  fit();
}

void PathCanvas::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const auto arrow = [this](double right, double down) {
    if (m_view == View::Space) {
      turn(-right * Projection::kKeyDeg, down * Projection::kKeyDeg);
    } else {
      pan({right * kKeyPx, down * kKeyPx});
    }
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return arrow(-1.0, 0.0);
    case Qt::Key_Right:
      return arrow(1.0, 0.0);
    case Qt::Key_Up:
      return arrow(0.0, -1.0);
    case Qt::Key_Down:
      return arrow(0.0, 1.0);
    case Qt::Key_Plus:
      return zoom(kKeyZoom, middle);
    case Qt::Key_Minus:
      return zoom(1.0 / kKeyZoom, middle);
    case Qt::Key_Home:
      m_turned = Projection::isometric();
      m_projection = Projection(angles());
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

void PathCanvas::dropPicture() {
  m_picture = QImage();
  m_marks = QImage();
  m_fine.picture = QImage();
  m_refineTimer.stop();
  m_executedInPicture = 0;
  update();
}

QImage PathCanvas::emptyPicture() const {
  const qreal ratio = devicePixelRatioF();
  QImage picture(size() * ratio, QImage::Format_RGB32);
  picture.setDevicePixelRatio(ratio);
  picture.fill(themeColors(palette()).surface);
  QPainter painter(&picture);
  drawGrid(painter);
  return picture;
}

void PathCanvas::makePicture() {
  m_picture = emptyPicture();
  m_drawn.moves = 0;
  m_executedInPicture = 0;
  m_isFine = true;
  if (!hasPath() || !m_style.classes) {
    return;
  }
  const std::size_t wanted = wantedLevel();
  std::size_t level = wanted;
  while (level + 1 < levels().size() && visibleMoves(level) > kPathMoves) {
    ++level;
  }
  Strokes strokes;
  const std::size_t moves = levels()[level].kept.size() - 1;
  for (std::size_t chunk = 0; chunk * overview::kChunkMoves < moves; ++chunk) {
    if (isVisible(level, chunk)) {
      collect(level, chunk * overview::kChunkMoves + 1,
              std::min((chunk + 1) * overview::kChunkMoves, moves) + 1, false, strokes);
    }
  }
  stroke(m_picture, strokes, m_style.pens, false);
  m_drawn.moves = strokes.moves;
  drawExecuted(m_picture, 0, m_executed);
  m_executedInPicture = m_executed;

  m_fine.level = wanted;
  while (m_fine.level < level && visibleMoves(m_fine.level) > kFineMoves) {
    ++m_fine.level;
  }
  m_isFine = m_fine.level == level;
  if (!m_isFine) {
    m_refineTimer.start(kRestMs);
  }
}

void PathCanvas::refine() {
  if (m_picture.isNull() || m_isFine || !hasPath()) {
    return;
  }
  if (m_fine.picture.isNull()) {
    m_fine.picture = emptyPicture();
    m_fine.chunk = 0;
    m_fine.moves = 0;
  }
  m_drawn.now = 0;
  Strokes strokes;
  const std::size_t moves = levels()[m_fine.level].kept.size() - 1;
  std::size_t collected = 0;
  for (; m_fine.chunk * overview::kChunkMoves < moves &&
         collected + overview::kChunkMoves <= kPathMoves;
       ++m_fine.chunk) {
    if (isVisible(m_fine.level, m_fine.chunk)) {
      collect(m_fine.level, m_fine.chunk * overview::kChunkMoves + 1,
              std::min((m_fine.chunk + 1) * overview::kChunkMoves, moves) + 1, false, strokes);
      collected += overview::kChunkMoves;
    }
  }
  stroke(m_fine.picture, strokes, m_style.pens, true);
  m_fine.moves += strokes.moves;
  if (m_fine.chunk * overview::kChunkMoves < moves) {
    m_refineTimer.start(0);
    return;
  }
  drawExecuted(m_fine.picture, 0, m_executed);
  m_picture = std::exchange(m_fine.picture, QImage());
  m_executedInPicture = m_executed;
  m_drawn.moves = m_fine.moves;
  m_isFine = true;
  update();
}

bool PathCanvas::isVisible(std::size_t level, std::size_t chunk) const {
  const overview::PlaneBox box = m_projection(levels()[level].boxes[chunk]);
  const QPointF upperLeft = onScreen({box.left, box.high});
  const QPointF lowerRight = onScreen({box.right, box.low});
  constexpr double kEdgePx = 8.0;
  return lowerRight.x() > -kEdgePx && upperLeft.x() < width() + kEdgePx &&
         lowerRight.y() > -kEdgePx && upperLeft.y() < height() + kEdgePx;
}

std::size_t PathCanvas::visibleMoves(std::size_t level) const {
  const std::size_t moves = levels()[level].kept.size() - 1;
  std::size_t visible = 0;
  for (std::size_t chunk = 0; chunk * overview::kChunkMoves < moves; ++chunk) {
    if (isVisible(level, chunk)) {
      visible += std::min(overview::kChunkMoves, moves - chunk * overview::kChunkMoves);
    }
  }
  return visible;
}

std::size_t PathCanvas::wantedLevel() const {
  std::size_t level = 0;
  while (level + 1 < levels().size() &&
         levels()[level + 1].toleranceMm * m_pixelsPerMm <= kTolerancePx) {
    ++level;
  }
  return level;
}

void PathCanvas::collect(std::size_t level, std::size_t from, std::size_t to, bool isExecuted,
                         Strokes& strokes) const {
  // Runs of moves of one class become polylines; a move is merged into the next one while it
  // stays below the resolution of the screen, and left out when it cannot cross the picture.
  const QRectF visible = QRectF(rect()).adjusted(-8.0, -8.0, 8.0, 8.0);
  const std::vector<std::uint32_t>& kept = levels()[level].kept;
  const std::vector<gcode::StreamPoint>& points = m_program->points.points;
  const auto at = [&](std::size_t i) { return onScreen(m_projection(points[kept[i]].positionMm)); };
  const overview::PathClasses& shown = m_style.classes->classes;
  const std::vector<std::uint8_t>& classOf = m_style.classes->ofLevel[level];
  const auto isGap = [&](std::size_t i) { return shown.hasGaps && classOf[i] + 1U == shown.count; };
  const auto classAt = [&](std::size_t i) -> std::size_t {
    if (isExecuted) {
      return isGap(i) ? 2 : points[kept[i]].kind == gcode::MoveKind::Rapid ? 0 : 1;
    }
    return classOf[i];
  };
  const std::size_t classes = isExecuted ? 3 : shown.count;
  strokes.lines.resize(std::max(strokes.lines.size(), classes));
  QPolygonF line;
  std::size_t lineClass = 0;
  const auto finish = [&] {
    if (line.size() > 1) {
      strokes.moves += static_cast<std::size_t>(line.size()) - 1;
      for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF move = line[i] - line[i - 1];
        strokes.lengthPx += std::min(std::abs(move.x()) + std::abs(move.y()), kMovePxMax);
      }
      strokes.lines[lineClass].push_back(line);
    }
    line.clear();
  };
  QPointF last = at(from - 1);
  for (std::size_t index = from; index < to; ++index) {
    const QPointF next = at(index);
    const std::size_t moveClass = classAt(index);
    const bool endsRun = index + 1 == to || classAt(index + 1) != moveClass;
    if (!line.isEmpty() && moveClass != lineClass) {
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
        lineClass = moveClass;
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
}

void PathCanvas::stroke(QImage& picture, const Strokes& strokes, const std::vector<QPen>& pens,
                        bool isSlice) {
  m_drawn.now += strokes.moves;
  m_drawn.mostAtOnce = std::max(m_drawn.mostAtOnce, m_drawn.now);
  // Slices must look alike: none is smooth.
  if (strokes.moves < kSmoothMoves && strokes.lengthPx < kSmoothPx && !isSlice) {
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t one = 0; one < strokes.lines.size(); ++one) {
      if (pens[one].style() == Qt::NoPen) {
        continue;
      }
      painter.setPen(pens[one]);
      for (const QPolygonF& polygon : strokes.lines[one]) {
        painter.drawPolyline(polygon);
      }
    }
    return;
  }
  // Dashes of thousands of short moves could not be distinguished: all lines are solid.
  const qreal ratio = picture.devicePixelRatio();
  for (std::size_t one = 0; one < strokes.lines.size(); ++one) {
    if (pens[one].style() == Qt::NoPen) {
      continue;
    }
    const QRgb color = pens[one].color().rgb();
    const int width = std::max(1, static_cast<int>(pens[one].widthF() * ratio / 1.5));
    for (const QPolygonF& polygon : strokes.lines[one]) {
      for (qsizetype i = 1; i < polygon.size(); ++i) {
        drawThinLine(picture, polygon[i - 1] * ratio, polygon[i] * ratio, color, width);
      }
    }
  }
}

void PathCanvas::drawExecuted(QImage& picture, std::size_t from, std::size_t to) {
  from = std::max(from, m_runBegin);
  if (to < 2 || to <= from || !hasPath()) {
    return;
  }
  const ThemeColors& colors = themeColors(palette());
  QPen cut(colors.accent, 3.0);
  cut.setCapStyle(Qt::RoundCap);
  cut.setJoinStyle(Qt::RoundJoin);
  QPen rapid(colors.accent, 2.0);
  rapid.setDashPattern({4.0, 3.0});
  // Few new moves are drawn as they are, many in a level that a frame can afford.
  std::size_t level = 0;
  if (to - from > kPathMoves / 2) {
    level = wantedLevel();
    while (level + 1 < levels().size() && visibleMoves(level) > kPathMoves) {
      ++level;
    }
  }
  const std::vector<std::uint32_t>& kept = levels()[level].kept;
  const auto positionOf = [&](std::size_t point) {
    return static_cast<std::size_t>(
        std::lower_bound(kept.begin(), kept.end(), static_cast<std::uint32_t>(point)) -
        kept.begin());
  };
  const std::size_t first = std::max<std::size_t>(positionOf(from), 1);
  const std::size_t end = std::min(positionOf(to), kept.size());
  Strokes strokes;
  for (std::size_t chunk = (first - 1) / overview::kChunkMoves;
       chunk * overview::kChunkMoves + 1 < end; ++chunk) {
    if (isVisible(level, chunk)) {
      collect(level, std::max(first, chunk * overview::kChunkMoves + 1),
              std::min(end, (chunk + 1) * overview::kChunkMoves + 1), true, strokes);
    }
  }
  stroke(picture, strokes, {rapid, cut, Qt::NoPen}, false);
}

std::vector<QPointF> PathCanvas::placesOf(const std::vector<std::uint32_t>& pauses) const {
  // Ranges of the list that may be visible, chunk by chunk.
  const std::size_t moves = levels().front().kept.size() - 1;
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  std::size_t count = 0;
  const auto positionOf = [&pauses](std::size_t point) {
    return static_cast<std::size_t>(std::lower_bound(pauses.begin(), pauses.end(), point) -
                                    pauses.begin());
  };
  for (std::size_t chunk = 0; chunk == 0 || chunk * overview::kChunkMoves < moves; ++chunk) {
    if (isVisible(0, chunk)) {
      const std::size_t from = positionOf(chunk == 0 ? 0 : chunk * overview::kChunkMoves + 1);
      const std::size_t to = positionOf((chunk + 1) * overview::kChunkMoves + 1);
      if (!ranges.empty() && ranges.back().second == from) {
        ranges.back().second = to;
      } else if (to > from) {
        ranges.emplace_back(from, to);
      }
      count += to - from;
    }
  }
  const std::size_t stride = (count + kPausesSeen - 1) / kPausesSeen;
  std::vector<QPointF> places;
  std::size_t next = 0;  // counted over all ranges
  std::size_t passed = 0;
  for (const auto& [from, to] : ranges) {
    for (; next < passed + to - from; next += stride) {
      places.push_back(placeOf(pauses[from + next - passed]));
    }
    passed += to - from;
  }
  return places;
}

void PathCanvas::makeMarks() {
  const ThemeColors& colors = themeColors(palette());
  const qreal ratio = devicePixelRatioF();
  m_marks = QImage(size() * ratio, QImage::Format_ARGB32_Premultiplied);
  m_marks.setDevicePixelRatio(ratio);
  m_marks.fill(Qt::transparent);
  m_drawn.pauses = 0;
  m_drawn.pausesSeen = 0;
  if (!hasPath() || m_marks.isNull()) {
    return;
  }
  const auto columns = static_cast<std::size_t>(width() / kMarkCellPx) + 1;
  const auto rows = static_cast<std::size_t>(height() / kMarkCellPx) + 1;
  std::vector<bool> taken(columns * rows);
  const auto thinned = [&](const std::vector<std::uint32_t>& pauses) {
    std::vector<QPointF> shown;
    const std::vector<QPointF> places = placesOf(pauses);
    m_drawn.pausesSeen += places.size();
    for (const QPointF& place : places) {
      if (!QRectF(rect()).contains(place)) {
        continue;
      }
      const std::size_t cell = static_cast<std::size_t>(place.y() / kMarkCellPx) * columns +
                               static_cast<std::size_t>(place.x() / kMarkCellPx);
      if (!taken[cell]) {
        taken[cell] = true;
        shown.push_back(place);
      }
    }
    m_drawn.pauses += shown.size();
    return shown;
  };
  const std::vector<QPointF> inCut = thinned(m_pauses->inCut);
  const std::vector<QPointF> offCut = thinned(m_pauses->offCut);
  QPainter painter(&m_marks);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.text, 1.4));
  painter.setBrush(colors.surface);
  for (const QPointF& place : offCut) {
    painter.drawRect(QRectF(place - QPointF(3.5, 3.5), QSizeF(7.0, 7.0)));
  }
  painter.setPen(QPen(colors.surface, 1.2));
  painter.setBrush(colors.attention);
  for (const QPointF& place : inCut) {
    painter.drawPolygon(QPolygonF{place + QPointF(0.0, -6.5), place + QPointF(6.5, 5.0),
                                  place + QPointF(-6.5, 5.0)});
  }
}

void PathCanvas::drawGrid(QPainter& painter) const {
  painter.setPen(themeColors(palette()).grid);
  if (m_view == View::Space) {
    drawFloor(painter);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  const double stepMm = gridStepMm();
  const double halfWidthMm = width() / 2.0 / m_pixelsPerMm;
  const double halfHeightMm = height() / 2.0 / m_pixelsPerMm;
  const auto firstX = std::llround(std::floor((m_centreMm.right - halfWidthMm) / stepMm));
  const auto lastX = std::llround(std::ceil((m_centreMm.right + halfWidthMm) / stepMm));
  for (auto line = firstX; line <= lastX; ++line) {
    const double x = onScreen({static_cast<double>(line) * stepMm, 0.0}).x();
    painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
  }
  const auto firstY = std::llround(std::floor((m_centreMm.up - halfHeightMm) / stepMm));
  const auto lastY = std::llround(std::ceil((m_centreMm.up + halfHeightMm) / stepMm));
  for (auto line = firstY; line <= lastY; ++line) {
    const double y = onScreen({0.0, static_cast<double>(line) * stepMm}).y();
    painter.drawLine(QPointF(0.0, y), QPointF(width(), y));
  }
}

/// The floor under the path, where the lowest point of it is.
void PathCanvas::drawFloor(QPainter& painter) const {
  if (!hasPath() && !m_box) {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const overview::SpaceBox box = spaceBox();
  const double stepMm = gridStepMm();
  const auto below = [&](std::size_t axis) { return std::floor(box.low[axis] / stepMm) - 1.0; };
  const auto above = [&](std::size_t axis) { return std::ceil(box.high[axis] / stepMm) + 1.0; };
  const double z = box.low[2];
  const auto line = [&](double fromX, double fromY, double toX, double toY) {
    painter.drawLine(onScreen(m_projection(base::Vec3{fromX * stepMm, fromY * stepMm, z})),
                     onScreen(m_projection(base::Vec3{toX * stepMm, toY * stepMm, z})));
  };
  for (double x = below(0); x <= above(0); ++x) {
    line(x, below(1), x, above(1));
  }
  for (double y = below(1); y <= above(1); ++y) {
    line(below(0), y, above(0), y);
  }
}

void PathCanvas::drawBox(QPainter& painter) const {
  if (!m_box) {
    return;
  }
  QPen pen(themeColors(palette()).mutedText, 1.2);
  pen.setDashPattern({6.0, 4.0});
  painter.setPen(pen);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto place = [this](unsigned corner) {
    return onScreen(m_projection(cornerOf(*m_box, corner)));
  };
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (unsigned axis = 0; axis < base::kAxisCount; ++axis) {
      const unsigned other = corner | (1U << axis);
      if (other != corner) {
        painter.drawLine(place(corner), place(other));
      }
    }
  }
}

void PathCanvas::drawScaleBar(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const double lengthMm = gridStepMm();
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(lengthMm) - 1e-9)));
  QString text = lengthText(lengthMm, decimals);
  const QPointF right(width() - 14.0, height() - 14.0);
  const QRectF place(right.x() - 200.0, right.y() - 26.0, 200.0, 20.0);
  if (m_view == View::Space) {  // where a bar would be true in one direction alone
    painter.setPen(colors.mutedText);
    if ((hasPath() || m_box) && !m_texts.grid.isEmpty()) {
      painter.drawText(place.translated(0.0, 14.0), Qt::AlignRight | Qt::AlignVCenter,
                       m_texts.grid.arg(text));
    }
    return;
  }
  const QPointF left = right - QPointF(lengthMm * m_pixelsPerMm, 0.0);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(colors.text, 2.0));
  painter.drawLine(left, right);
  painter.drawLine(left - QPointF(0.0, 5.0), left);
  painter.drawLine(right - QPointF(0.0, 5.0), right);
  painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, text);
}

void PathCanvas::drawAxes(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const double marginPx = m_view == View::Space ? 52.0 : 18.0;  // axes of the space point anywhere
  const QPointF origin(marginPx, height() - marginPx);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.mutedText, 1.6));
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    base::Vec3 unit;
    unit.set(axis, 1.0);
    const overview::PlanePoint along = m_projection(unit);
    const QPointF direction(along.right * 34.0, -along.up * 34.0);
    if (std::hypot(direction.x(), direction.y()) < 8.0) {
      continue;  // towards whoever looks
    }
    painter.drawLine(origin, origin + direction);
    painter.drawText(QRectF(origin + direction * 1.3 - QPointF(10.0, 10.0), QSizeF(20.0, 20.0)),
                     Qt::AlignCenter, QString(QLatin1Char(base::kAxisNames[axis])));
  }
}

void PathCanvas::drawGaps(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  QPen native(colors.native, 2.0);
  native.setDashPattern({1.5, 2.0});
  QPen approach(colors.rapid, 1.2);  // streamed, from where the control has brought the tool
  approach.setDashPattern({5.0, 4.0});
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF visible = QRectF(rect()).adjusted(-8.0, -8.0, 8.0, 8.0);
  std::size_t drawn = 0;
  for (const overview::ProgramView::Gap& gap : m_program->gaps) {
    if (!gap.isKnown()) {
      continue;
    }
    const std::array<QPointF, 3> places{placeOf(gap.point - 1), onScreen(m_projection(gap.fromMm)),
                                        placeOf(gap.point)};
    for (std::size_t i = 0; i < 2; ++i) {
      if ((outside(places[i], visible) & outside(places[i + 1], visible)) == 0) {
        painter.setPen(i == 0 ? native : approach);
        painter.drawLine(places[i], places[i + 1]);
        ++drawn;
      }
    }
    if (drawn >= kGapsDrawn) {
      return;
    }
  }
}

void PathCanvas::drawToolChanges(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  QRectF taken;  // a label that would cover the one before it gives way
  std::size_t drawn = 0;
  for (const overview::ProgramView::ToolChange& change : m_program->toolChanges) {
    const QPointF place = placeOf(change.point);
    if (!QRectF(rect()).contains(place)) {
      continue;
    }
    painter.setPen(QPen(colors.native, 1.6));
    painter.setBrush(colors.surface);
    painter.drawPolygon(QPolygonF{place + QPointF(0.0, -6.0), place + QPointF(6.0, 0.0),
                                  place + QPointF(0.0, 6.0), place + QPointF(-6.0, 0.0)});
    const QString tool = QString::fromStdString(change.tool);
    const QString label = tool[0].isDigit() ? QLatin1Char('T') + tool : tool;
    QRectF box = QRectF(painter.fontMetrics().boundingRect(label)).adjusted(-4, -2, 4, 2);
    box.moveTopLeft(place + QPointF(9.0, 5.0));
    if (!box.intersects(taken)) {
      taken = box;
      painter.setBrush(colors.surface);
      painter.drawRoundedRect(box, 3.0, 3.0);
      painter.setPen(colors.text);
      painter.drawText(box, Qt::AlignCenter, label);
    }
    if (++drawn == kGapsDrawn) {
      return;
    }
  }
}

void PathCanvas::drawStart(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const QPointF start = placeOf(0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors.text, 1.6));
  painter.setBrush(colors.surface);
  painter.drawEllipse(start, 5.0, 5.0);
  painter.drawText(start + QPointF(8.0, -7.0), m_texts.start);
}

void PathCanvas::drawFirstWay(QPainter& painter) const {
  if (m_firstWayMm.size() < 2) {
    return;
  }
  QPolygonF way;
  for (const base::Vec3& placeMm : m_firstWayMm) {
    way << onScreen(m_projection(placeMm));
  }
  const ThemeColors& colors = themeColors(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(colors.surface, 6.0), QPen(colors.accent, 3.0)}) {
    painter.setPen(pen);
    painter.drawPolyline(way);
  }
}

void PathCanvas::drawChosen(QPainter& painter) const {
  const ThemeColors& colors = themeColors(palette());
  const QColor chosen = colors.equations[1];  // no move is drawn in it
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF visible = QRectF(rect()).adjusted(-8.0, -8.0, 8.0, 8.0);
  painter.setPen(QPen(chosen, 4.0, Qt::SolidLine, Qt::RoundCap));
  std::size_t drawn = 0;
  for (const std::uint32_t point : m_selected) {
    const QPointF to = placeOf(point);
    const QPointF from = placeOf(point > 0 ? point - 1 : point);
    if ((outside(from, visible) & outside(to, visible)) == 0) {
      painter.drawLine(from, to);
      if (++drawn == kSelectedMax) {
        break;
      }
    }
  }
  if (m_marked) {
    const QPointF marked = placeOf(*m_marked);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(colors.surface, 6.0), QPen(chosen, 3.0)}) {
      painter.setPen(pen);
      painter.drawEllipse(marked, 9.0, 9.0);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(chosen);
    painter.drawEllipse(marked, 2.5, 2.5);
  }
}

void PathCanvas::drawTool(QPainter& painter) const {
  if (!m_toolMm) {
    return;
  }
  const ThemeColors& colors = themeColors(palette());
  const ToolMark mark = toolMark();
  const QPointF tool = mark.place;
  const auto cross = [&](const QPen& pen) {
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(tool, 8.0, 8.0);
    for (const QPointF direction :
         {QPointF(1.0, 0.0), QPointF(-1.0, 0.0), QPointF(0.0, 1.0), QPointF(0.0, -1.0)}) {
      painter.drawLine(tool + 4.0 * direction, tool + kToolPx * direction);
    }
  };
  cross(QPen(colors.surface, 5.0));  // stands out from any path under it
  cross(QPen(colors.text, 2.0));
  painter.setPen(colors.line);
  painter.setBrush(colors.surface);
  painter.drawRoundedRect(mark.box, 3.0, 3.0);
  painter.setPen(colors.text);
  painter.drawText(mark.box, Qt::AlignCenter, mark.label);
}

QPointF PathCanvas::onScreen(overview::PlanePoint place) const {
  return {width() / 2.0 + (place.right - m_centreMm.right) * m_pixelsPerMm,
          height() / 2.0 - (place.up - m_centreMm.up) * m_pixelsPerMm};
}

double PathCanvas::gridStepMm() const {
  double leastMm = 64.0 / m_pixelsPerMm;
  if (m_view == View::Space && (hasPath() || m_box)) {  // its floor ends somewhere
    const overview::SpaceBox box = spaceBox();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      leastMm =
          std::max(leastMm, (static_cast<double>(box.high[axis]) - box.low[axis]) / kFloorLinesMax);
    }
  }
  return roundUp125(leastMm);
}

}  // namespace rivulet::widgets
