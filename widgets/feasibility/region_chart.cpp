// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/feasibility/region_chart.h"

#include <QAreaSeries>
#include <QChart>
#include <QGraphicsItem>
#include <QLineSeries>
#include <QLocale>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nice_step.h"
#include "gcode/feeds.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/chart_style.h"

namespace rivulet::widgets {

using feasibility::Border;
using feasibility::Equation;
using feasibility::SweepAxis;

namespace {

constexpr double kPointsShownMin = 20.0;
constexpr int kSteps = 96;
constexpr double kGrabPx = 28.0;  // a fingertip
constexpr double kLeftPx = 84.0;
constexpr double kRightPx = 24.0;
constexpr double kTopPx = 14.0;
constexpr double kBottomPx = 52.0;

QString shortLabel(Equation equation) {
  switch (equation) {
    case Equation::PointDistance:
      return QStringLiteral("(1)");
    case Equation::Delta:
      return QStringLiteral("(2)");
    case Equation::Window:
      return QStringLiteral("(3)");
    case Equation::RealWindow:
      return QStringLiteral("(3ᴺ)");
    case Equation::Reach:
      return RegionChart::tr("reach");
    case Equation::Machine:
      break;  // has no border
  }
  return {};
}

}  // namespace

/// The area around each simulated point at which runs failed, the stronger the more did: what the
/// equations call feasible does not look so there. Below the points and the limits.
class RegionFailures final : public QGraphicsItem {
 public:
  explicit RegionFailures(RegionChart* view) : QGraphicsItem(view->chart()), m_view(view) {
    setZValue(2.5);
  }
  void refresh() {
    prepareGeometryChange();
    update();
  }
  [[nodiscard]] QRectF boundingRect() const override { return m_view->chart()->rect(); }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/,
             QWidget* /*widget*/) override {
    if (!m_view->m_region || !m_view->m_model) {
      return;
    }
    const std::vector<SimulatedPoint>& points = m_view->m_region->points;
    std::vector<double> abscissas;
    std::vector<double> feeds;
    for (const SimulatedPoint& point : points) {
      abscissas.push_back(point.abscissa);
      feeds.push_back(point.feedMmPerS);
    }
    painter->save();
    painter->setClipRect(m_view->chart()->plotArea());
    painter->setPen(Qt::NoPen);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].failures == 0) {
        continue;
      }
      constexpr double kAlphaMost = 0.45;
      QColor color = themeColors(m_view->m_palette).fault;
      color.setAlphaF(static_cast<float>(kAlphaMost * static_cast<double>(points[i].failures) /
                                         static_cast<double>(points[i].runs)));
      // At the edges of the grid the area goes as far outwards as inwards.
      const auto [x0, x1] = around(abscissas, abscissas[i]);
      const auto [y0, y1] = around(feeds, feeds[i]);
      painter->setBrush(color);
      painter->drawRect(QRectF(m_view->pixel(x0, y1), m_view->pixel(x1, y0)));
    }
    painter->restore();
  }

 private:
  /// Half way to the next values on both sides.
  static std::pair<double, double> around(const std::vector<double>& values, double value) {
    double below = -std::numeric_limits<double>::infinity();
    double above = std::numeric_limits<double>::infinity();
    for (const double other : values) {
      below = other < value ? std::max(below, other) : below;
      above = other > value ? std::min(above, other) : above;
    }
    if (!std::isfinite(below) && !std::isfinite(above)) {
      return {value, value};
    }
    below = std::isfinite(below) ? below : 2.0 * value - above;
    above = std::isfinite(above) ? above : 2.0 * value - below;
    return {(below + value) / 2.0, (above + value) / 2.0};
  }

  RegionChart* m_view;
};

/// Paints everything that is not a series: operating point, line of d_min, names of the limits.
class RegionOverlay final : public QGraphicsItem {
 public:
  explicit RegionOverlay(RegionChart* view)
      : QGraphicsItem(view->chart()), m_view(view), m_failures(new RegionFailures(view)) {
    setZValue(20.0);
  }

  /// The names of the limits and the marker move with the chart.
  void refresh() {
    prepareGeometryChange();
    update();
    m_failures->refresh();
  }

  [[nodiscard]] QRectF boundingRect() const override { return m_view->chart()->rect(); }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/,
             QWidget* /*widget*/) override {
    if (!m_view->m_model) {
      return;
    }
    painter->setRenderHint(QPainter::Antialiasing);
    paintPointDistance(painter);
    paintNames(painter);
    paintOperatingPoint(painter);
  }

 private:
  [[nodiscard]] QRectF area() const { return m_view->chart()->plotArea(); }

  void paintLabel(QPainter* painter, QRectF box, const QString& text, const QColor& color) const {
    const ThemeColors& colors = themeColors(m_view->m_palette);
    QColor background = colors.surface;
    background.setAlpha(225);
    painter->setPen(Qt::NoPen);
    painter->setBrush(background);
    painter->drawRoundedRect(box, 3.0, 3.0);
    painter->setPen(color);
    painter->drawText(box, Qt::AlignCenter, text);
  }

  void paintPointDistance(QPainter* painter) const {
    const FeasibilityModel& model = *m_view->m_model;
    if (m_view->m_axis != SweepAxis::PointDistance || model.distances.pointDistanceMmMin <= 0.0) {
      return;
    }
    const double x = m_view->pixel(model.distances.pointDistanceMmMin, 0.0).x();
    const ThemeColors& colors = themeColors(m_view->m_palette);
    painter->setPen(QPen(colors.mutedText, 1.4, Qt::DotLine));
    painter->drawLine(QPointF(x, area().top()), QPointF(x, area().bottom()));
    const QString text =
        (model.scale.isOverride() ? QStringLiteral("t_min = %1") : QStringLiteral("d_min = %1"))
            .arg(model.scale.distanceText(model.distances.pointDistanceMmMin));
    QRectF box = QRectF(painter->fontMetrics().boundingRect(text)).adjusted(-5, -2, 5, 2);
    box.moveTopLeft(QPointF(x + 4.0, area().top() + 2.0));
    if (box.right() > area().right()) {
      box.moveRight(x - 4.0);
    }
    paintLabel(painter, box, text, colors.text);
  }

  void paintNames(QPainter* painter) const {
    // Each limit is labelled where it leaves the picture: on the right, or at the top.
    const ThemeColors& colors = themeColors(m_view->m_palette);
    std::vector<QRectF> taken;
    for (const Border& border : m_view->m_borders) {
      if (!border.withSafety || border.points.empty()) {
        continue;
      }
      QPointF place;
      bool found = false;
      for (auto point = border.points.rbegin(); point != border.points.rend(); ++point) {
        const double feed = m_view->scale().shown(point->feedMmPerS);
        if (std::isfinite(feed) && feed <= m_view->m_feedShownMax * 0.98) {
          place = m_view->pixel(point->abscissa, point->feedMmPerS);
          found = true;
          break;
        }
      }
      if (!found) {
        continue;
      }
      const QString text = shortLabel(border.equation);
      QRectF box = QRectF(painter->fontMetrics().boundingRect(text)).adjusted(-5, -2, 5, 2);
      box.moveCenter(place - QPointF(box.width() / 2.0 + 6.0, 0.0));
      for (int attempt = 0; attempt < 6; ++attempt) {
        const auto hit = std::find_if(taken.begin(), taken.end(), [&box](const QRectF& other) {
          return other.intersects(box);
        });
        if (hit == taken.end()) {
          break;
        }
        box.moveLeft(hit->left() - box.width() - 4.0);
      }
      taken.push_back(box);
      QFont font = painter->font();
      font.setBold(true);
      painter->setFont(font);
      paintLabel(painter, box, text, colors.equations[static_cast<std::size_t>(border.equation)]);
    }
  }

  void paintOperatingPoint(QPainter* painter) const {
    const ThemeColors& colors = themeColors(m_view->m_palette);
    const QPointF centre = m_view->operatingPixel();
    for (const auto& [color, width] :
         {std::pair(colors.surface, 6.0), std::pair(colors.text, 2.4)}) {
      painter->setPen(QPen(color, width));
      painter->setBrush(Qt::NoBrush);
      painter->drawEllipse(centre, 10.0, 10.0);
    }
    painter->setBrush(colors.text);
    painter->setPen(Qt::NoPen);
    painter->drawEllipse(centre, 2.5, 2.5);

    const feasibility::OperatingPoint& point = m_view->m_model->operatingPoint;
    const FeedScale scale = m_view->scale();
    QString text = scale.isOverride()
                       ? RegionChart::tr("Override %1").arg(scale.text(point.feedMmPerS))
                       : QStringLiteral("F = %1").arg(feedText(point.feedMmPerS));
    if (m_view->m_axis == SweepAxis::PointsPerLoop) {
      text = QStringLiteral("N = %1, ").arg(point.pointsPerLoop) + text;
    } else if (m_view->m_axis == SweepAxis::Delta) {
      text = QStringLiteral("δ = %1, ").arg(lengthText(point.deltaMm)) + text;
    }
    QFont font = painter->font();
    font.setBold(true);
    painter->setFont(font);
    QRectF box = QRectF(painter->fontMetrics().boundingRect(text)).adjusted(-6, -3, 6, 3);
    box.moveBottomLeft(centre + QPointF(14.0, -8.0));
    if (box.right() > area().right()) {
      box.moveBottomRight(centre + QPointF(-14.0, -8.0));
    }
    if (box.top() < area().top() + 24.0) {
      box.moveTop(centre.y() + 12.0);
    }
    paintLabel(painter, box, text, colors.text);
  }

  RegionChart* m_view;
  RegionFailures* m_failures;
};

RegionChart::RegionChart(SweepAxis axis, QWidget* parent)
    : QChartView(new QChart, parent),
      m_axis(axis),
      m_xAxis(new QValueAxis(this)),
      m_yAxis(new QValueAxis(this)),
      m_anchor(new QLineSeries(this)),
      m_safeUpper(new QLineSeries(this)),
      m_safeLower(new QLineSeries(this)),
      m_bandUpper(new QLineSeries(this)),
      m_bandLower(new QLineSeries(this)),
      m_safeArea(new QAreaSeries(m_safeUpper, m_safeLower)),
      m_bandArea(new QAreaSeries(m_bandUpper, m_bandLower)),
      m_points(new QScatterSeries(this)),
      m_half(new QLineSeries(this)),
      m_rare(new QLineSeries(this)),
      m_probability(new QAreaSeries(m_half, m_rare)),
      m_overlay(new RegionOverlay(this)) {
  if (m_axis == SweepAxis::PointsPerLoop) {
    m_xMax = kPointsShownMin;  // shown before there is a model, too
  }
  setFrameShape(QFrame::NoFrame);
  setRenderHint(QPainter::Antialiasing);
  setMinimumSize(320, 240);
  setMouseTracking(true);
  chart()->addAxis(m_xAxis, Qt::AlignBottom);
  chart()->addAxis(m_yAxis, Qt::AlignLeft);
  for (QAbstractSeries* series :
       {static_cast<QAbstractSeries*>(m_safeArea), static_cast<QAbstractSeries*>(m_bandArea),
        static_cast<QAbstractSeries*>(m_anchor), static_cast<QAbstractSeries*>(m_points)}) {
    chart()->addSeries(series);
    series->attachAxis(m_xAxis);
    series->attachAxis(m_yAxis);
  }
  chart()->addSeries(m_probability);
  m_probability->attachAxis(m_xAxis);
  m_probability->attachAxis(m_yAxis);
  constexpr std::array kShapes{QScatterSeries::MarkerShapeCircle,
                               QScatterSeries::MarkerShapeTriangle,
                               QScatterSeries::MarkerShapeRectangle};
  for (std::size_t kind = 0; kind < m_simulated.size(); ++kind) {
    m_simulated[kind] = new QScatterSeries(this);
    m_simulated[kind]->setMarkerShape(kShapes[kind]);
    m_simulated[kind]->setMarkerSize(kind == 1 ? 12.0 : 9.0);
    chart()->addSeries(m_simulated[kind]);
    m_simulated[kind]->attachAxis(m_xAxis);
    m_simulated[kind]->attachAxis(m_yAxis);
  }
  m_points->setMarkerShape(QScatterSeries::MarkerShapeCircle);
  m_points->setMarkerSize(5.0);
  connect(chart(), &QChart::plotAreaChanged, this, [this] { m_overlay->refresh(); });
  retranslate();
  restyle(palette());
}

void RegionChart::setModel(const FeasibilityModel& model) {
  const bool isOtherScale = model.scale.isOverride() != scale().isOverride();
  m_model = model;
  if (isOtherScale) {
    retranslate();
  }
  rebuild();
}

void RegionChart::showEvent(QShowEvent* event) {
  QChartView::showEvent(event);
  if (m_isStale) {
    draw();
  }
}

double RegionChart::shownX(double abscissa) const {
  return m_axis == SweepAxis::PointDistance ? scale().shownDistance(abscissa) : abscissa;
}

void RegionChart::setRegion(const std::optional<SimulatedRegion>& region) {
  m_region = region;
  showRegion();
}

std::array<QColor, 3> RegionChart::pointColors(const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  return {colors.accent, colors.attention, colors.fault};
}

QBrush RegionChart::bandBrush(const QPalette& palette) {
  // Hatched: it overlaps the areas of the equations and must look different from them.
  QColor color = themeColors(palette).attention;
  color.setAlpha(130);
  return QBrush(color, Qt::BDiagPattern);
}

SimulationWanted RegionChart::simulationWanted() const {
  constexpr int kAbscissas = 8;
  constexpr int kFeeds = 10;
  // Larger ones cannot be set.
  const double feedShownMax = scale().isOverride() ? scale().typed(m_feedShownMax) : m_feedShownMax;
  SimulationWanted wanted;
  wanted.axis = m_axis;
  if (!m_model || abscissa() <= 0.0) {
    return wanted;
  }
  if (m_axis == SweepAxis::PointsPerLoop) {
    const int step = std::max(1, static_cast<int>(m_xMax - 1.0) / kAbscissas);
    // Not on the edges of the picture, where half of a mark would be cut off.
    for (int value = 3; value < static_cast<int>(m_xMax); value += step) {
      wanted.abscissas.push_back(value);
    }
  } else {
    for (int i = 0; i < kAbscissas; ++i) {
      wanted.abscissas.push_back(m_xMax * (i + 0.5) / kAbscissas);
    }
  }
  // The operating point's own abscissa instead of the nearest one.
  const auto nearest = std::min_element(
      wanted.abscissas.begin(), wanted.abscissas.end(), [this](double left, double right) {
        return std::abs(left - abscissa()) < std::abs(right - abscissa());
      });
  *nearest = abscissa();
  for (int i = 0; i < kFeeds; ++i) {
    wanted.feedsMmPerS.push_back(scale().feedMmPerS(feedShownMax * (i + 0.5) / kFeeds));
  }
  return wanted;
}

void RegionChart::showRegion() {
  std::array<QList<QPointF>, 3> points;
  QList<QPointF> half;
  QList<QPointF> rare;
  if (m_region) {
    for (const SimulatedPoint& point : m_region->points) {
      if (point.runs > 0) {
        const std::size_t kind = point.failures == 0 ? 0 : point.failures < point.runs ? 1 : 2;
        points[kind].append(QPointF(shownX(point.abscissa), scale().shown(point.feedMmPerS)));
      }
    }
    for (const ProbabilityBand& band : m_region->band) {
      half.append(QPointF(shownX(band.abscissa), scale().shown(band.halfMmPerS)));
      rare.append(QPointF(shownX(band.abscissa), scale().shown(band.rareMmPerS)));
    }
  }
  for (std::size_t kind = 0; kind < points.size(); ++kind) {
    m_simulated[kind]->replace(points[kind]);
  }
  m_half->replace(half);
  m_rare->replace(rare);
  m_overlay->refresh();
}

void RegionChart::retranslate() {
  chart()->setLocale(QLocale());
  m_yAxis->setTitleText(scale().isOverride() ? tr("Override, %") : tr("F, mm/min"));
  switch (m_axis) {
    case SweepAxis::PointDistance:
      m_xAxis->setTitleText(scale().isOverride() ? tr("t_min, ms: shortest move at 100 %")
                                                 : tr("d_min, mm"));
      break;
    case SweepAxis::PointsPerLoop:
      m_xAxis->setTitleText(tr("N, points per loop"));
      break;
    case SweepAxis::Delta:
      m_xAxis->setTitleText(tr("δ, mm"));
      break;
  }
  m_overlay->refresh();
}

void RegionChart::restyle(const QPalette& palette) {
  m_palette = palette;
  const ThemeColors& colors = themeColors(palette);
  styleChart(chart(), palette);
  setBackgroundBrush(colors.surface);
  m_safeArea->setPen(Qt::NoPen);
  m_safeArea->setBrush(colors.feasibleFill);
  m_bandArea->setPen(Qt::NoPen);
  m_bandArea->setBrush(QBrush(colors.safetyFill));
  m_probability->setPen(Qt::NoPen);
  m_probability->setBrush(bandBrush(palette));
  const std::array<QColor, 3> simulated = pointColors(palette);
  for (std::size_t kind = 0; kind < simulated.size(); ++kind) {
    m_simulated[kind]->setColor(simulated[kind]);
    m_simulated[kind]->setBorderColor(colors.surface);
  }
  m_points->setColor(colors.mutedText);
  m_points->setPen(Qt::NoPen);
  rebuild();
}

QPointF RegionChart::operatingPixel() const {
  return m_model ? pixel(abscissa(), m_model->operatingPoint.feedMmPerS) : QPointF();
}

bool RegionChart::decides(const Border& border) const {
  // If the real path of the program is known, the published limit (3) is for information only.
  if (border.equation != Equation::Window) {
    return true;
  }
  return std::none_of(m_borders.begin(), m_borders.end(),
                      [](const Border& other) { return other.equation == Equation::RealWindow; });
}

void RegionChart::mousePressEvent(QMouseEvent* event) {
  if (m_editable && m_model && event->button() == Qt::LeftButton &&
      QLineF(event->position(), operatingPixel()).length() <= kGrabPx) {
    m_dragging = true;
    setCursor(Qt::ClosedHandCursor);
  }
}

void RegionChart::mouseMoveEvent(QMouseEvent* event) {
  if (m_dragging) {
    dragTo(event->position());
  } else {
    const bool near =
        m_editable && m_model && QLineF(event->position(), operatingPixel()).length() <= kGrabPx;
    setCursor(near ? Qt::OpenHandCursor : Qt::ArrowCursor);
  }
}

void RegionChart::mouseReleaseEvent(QMouseEvent* /*event*/) {
  if (m_dragging) {
    m_dragging = false;
    setCursor(Qt::ArrowCursor);
    rebuild();  // the ranges stood still while the marker moved
  }
}

void RegionChart::resizeEvent(QResizeEvent* event) {
  // The plot area first: the axes are laid out around it when the chart takes its new size.
  chart()->setPlotArea(QRectF(kLeftPx, kTopPx, std::max(width() - kLeftPx - kRightPx, 10.0),
                              std::max(height() - kTopPx - kBottomPx, 10.0)));
  QChartView::resizeEvent(event);
  divideAxes();
  m_overlay->refresh();
}

void RegionChart::rebuild() {
  if (!m_model) {
    divideAxes();
    return;
  }
  if (!m_dragging) {
    chooseRanges();
  }
  m_borders = feasibility::sweepBorders(m_model->operatingPoint, m_model->distances, m_axis,
                                        sweepRange(), m_model->access, m_model->safety);
  // The picture of a chart in the back is made when it comes to the front.
  m_isStale = !isVisible();
  if (!m_isStale) {
    draw();
  }
}

void RegionChart::draw() {
  m_isStale = false;
  drawAreas();
  drawBorders();
  drawDistances();
  divideAxes();
  m_overlay->refresh();
}

feasibility::SweepRange RegionChart::sweepRange() const {
  feasibility::SweepRange range;
  if (m_axis == SweepAxis::PointsPerLoop) {
    range.min = 2.0;
    range.max = m_xMax;
    range.steps = static_cast<int>(m_xMax) - 1;
  } else {
    range.min = m_xMax / kSteps;
    range.max = m_xMax;
    range.steps = kSteps;
  }
  return range;
}

void RegionChart::drawAreas() {
  // The area below all limits that decide, with safety factor and as published.
  QList<QPointF> safe;
  QList<QPointF> published;
  for (const Border& border : m_borders) {
    if (!decides(border)) {
      continue;
    }
    QList<QPointF>& lowest = border.withSafety ? safe : published;
    for (std::size_t index = 0; index < border.points.size(); ++index) {
      const double feed = scale().shown(border.points[index].feedMmPerS);
      const double shown = std::isfinite(feed) ? feed : 10.0 * m_feedShownMax;
      if (static_cast<std::size_t>(lowest.size()) <= index) {
        lowest.append(QPointF(shownX(border.points[index].abscissa), shown));
      } else {
        QPointF& point = lowest[static_cast<qsizetype>(index)];
        point.setY(std::min(point.y(), shown));
      }
    }
  }
  // Far above the picture the area would only cost time.
  const double ceiling = 2.0 * m_feedShownMax;
  QList<QPointF> floor;
  for (QPointF& point : safe) {
    point.setY(std::min(point.y(), ceiling));
    floor.append(QPointF(point.x(), 0.0));
  }
  QList<QPointF> bandLower = safe;
  for (qsizetype index = 0; index < published.size(); ++index) {
    published[index].setY(std::min(published[index].y(), ceiling));
    if (index < bandLower.size()) {
      published[index].setY(std::max(published[index].y(), bandLower[index].y()));
    }
  }
  m_safeUpper->replace(safe);
  m_safeLower->replace(floor);
  m_bandUpper->replace(published);
  m_bandLower->replace(bandLower);
}

void RegionChart::drawBorders() {
  const ThemeColors& colors = themeColors(m_palette);
  while (m_lines.size() < m_borders.size()) {
    auto* line = new QLineSeries(this);
    chart()->addSeries(line);
    line->attachAxis(m_xAxis);
    line->attachAxis(m_yAxis);
    m_lines.push_back(line);
  }
  for (std::size_t index = 0; index < m_lines.size(); ++index) {
    QList<QPointF> points;
    if (index < m_borders.size()) {
      const Border& border = m_borders[index];
      for (const feasibility::BorderPoint& point : border.points) {
        const double feed = scale().shown(point.feedMmPerS);
        if (std::isfinite(feed)) {
          points.append(QPointF(shownX(point.abscissa), std::min(feed, 50.0 * m_feedShownMax)));
        }
      }
      QPen pen(colors.equations[static_cast<std::size_t>(border.equation)],
               decides(border) ? 2.4 : 1.2);
      if (!border.withSafety) {
        pen.setWidthF(1.4);
        pen.setDashPattern({5.0, 4.0});
      }
      m_lines[index]->setPen(pen);
    }
    m_lines[index]->replace(points);
  }
}

void RegionChart::drawDistances() {
  QList<QPointF> marks;
  if (m_axis == SweepAxis::PointDistance) {
    const double feed = scale().shown(m_model->operatingPoint.feedMmPerS);
    for (const double distanceMm : m_model->smallestDistancesMm) {
      if (distanceMm <= m_xMax) {
        marks.append(QPointF(shownX(distanceMm), feed));
      }
    }
  }
  m_points->replace(marks);
}

void RegionChart::divideAxes() {
  divideAxis(m_xAxis, m_axis == SweepAxis::PointsPerLoop ? 2.0 : 0.0, shownX(m_xMax),
             std::clamp(width() / 70, 3, 12));
  divideAxis(m_yAxis, 0.0, m_feedShownMax, std::clamp(height() / 45, 3, 10));
}

void RegionChart::chooseRanges() {
  const FeasibilityModel& model = *m_model;
  switch (m_axis) {
    case SweepAxis::PointDistance: {
      double reach = std::max(2.0 * model.distances.pointDistanceMmMin, 1e-3);
      if (!model.smallestDistancesMm.empty()) {
        // Enough of the program's own points to show their distribution, with the smallest still
        // visible.
        const double typical =
            model.smallestDistancesMm[model.smallestDistancesMm.size() * 3 / 4] * 1.2;
        reach = std::clamp(typical, reach, 4.0 * reach);
      }
      m_xMax = model.scale.distanceMm(base::niceCeil(model.scale.shownDistance(reach)));
      break;
    }
    case SweepAxis::PointsPerLoop:
      m_xMax = std::max(kPointsShownMin, base::niceCeil(2.0 * model.operatingPoint.pointsPerLoop));
      break;
    case SweepAxis::Delta:
      m_xMax = base::niceCeil(std::max(2.0 * model.operatingPoint.deltaMm, 0.1));
      break;
  }
  // High enough for the operating point and for the feed that would be possible here.
  feasibility::SweepRange here;
  here.min = std::max(abscissa(), m_axis == SweepAxis::PointsPerLoop ? 2.0 : 1e-6);
  here.max = m_axis == SweepAxis::PointsPerLoop ? here.min + 1.0 : here.min * 1.001;
  here.steps = 2;
  double limitMmPerS = std::numeric_limits<double>::infinity();
  for (const Border& border : feasibility::sweepBorders(model.operatingPoint, model.distances,
                                                        m_axis, here, model.access, model.safety)) {
    if (!border.withSafety && !border.points.empty()) {
      limitMmPerS = std::min(limitMmPerS, border.points.front().feedMmPerS);
    }
  }
  double reach = 1.4 * model.operatingPoint.feedMmPerS;
  if (std::isfinite(limitMmPerS)) {
    reach = std::max(reach, std::min(1.5 * limitMmPerS, 20.0 * model.operatingPoint.feedMmPerS));
  }
  if (model.scale.isOverride()) {
    // A larger override cannot be set.
    reach = std::min(reach, 1.25 * gcode::kOverrideMax * model.scale.fullFeedMmPerS);
  }
  m_feedShownMax = base::niceCeil(std::max(model.scale.shown(reach), 1.0));
}

double RegionChart::abscissa() const {
  switch (m_axis) {
    case SweepAxis::PointDistance:
      return m_model->distances.pointDistanceMmMin;
    case SweepAxis::PointsPerLoop:
      return static_cast<double>(m_model->operatingPoint.pointsPerLoop);
    case SweepAxis::Delta:
      return m_model->operatingPoint.deltaMm;
  }
  return 0.0;
}

QPointF RegionChart::pixel(double abscissa, double feedMmPerS) const {
  return chart()->mapToPosition(QPointF(shownX(abscissa), scale().shown(feedMmPerS)), m_anchor);
}

void RegionChart::dragTo(QPointF pixel) {
  const QPointF value = chart()->mapToValue(pixel, m_anchor);
  feasibility::OperatingPoint& point = m_model->operatingPoint;
  // Whole mm/min or %, and hundredths of a mm: as an operator would type them.
  point.feedMmPerS = scale().feedMmPerS(scale().typed(std::min(value.y(), m_feedShownMax)));
  if (m_axis == SweepAxis::PointsPerLoop) {
    point.pointsPerLoop = static_cast<int>(std::clamp(std::round(value.x()), 2.0, m_xMax));
  } else if (m_axis == SweepAxis::Delta) {
    point.deltaMm = std::clamp(std::round(value.x() * 100.0) / 100.0, 0.01, m_xMax);
  }
  rebuild();
  Q_EMIT operatingPointRequested(point);
}

}  // namespace rivulet::widgets
