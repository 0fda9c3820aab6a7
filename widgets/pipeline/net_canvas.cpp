// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/net_canvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

using Kind = petri::PageNode::Kind;

constexpr double kNetPaddingPx = 6.0;
constexpr double kNodeShare = 0.86;  ///< of the width of a column
constexpr double kNodeWidthMaxPx = 150.0;
constexpr double kNodeHeightShare = 0.56;  ///< of the height of a row
constexpr double kNodeHeightMaxPx = 64.0;
constexpr double kNodeHeightMinPx = 36.0;
constexpr double kColumnPxMin = 100.0;
constexpr double kRowPxMin = 62.0;
constexpr double kLeastColumns = 5.0;  ///< room that every page gets
constexpr double kLeastRows = 4.0;
constexpr double kArrowPx = 9.0;
constexpr double kMarkSidePx = 9.0;
constexpr double kFramePx = 1.4;
constexpr double kThickPx = 3.0;
constexpr int kTokensListed = 6;

/// First and last column and row of a page.
QRectF extentOf(const std::vector<petri::PageNode>& nodes) {
  QRectF extent;
  for (const petri::PageNode& node : nodes) {
    extent.setRight(std::max(extent.right(), node.column));
    extent.setBottom(std::max(extent.bottom(), node.row));
  }
  return extent;
}

/// Where a line from the centre of an ellipse or box leaves it.
QPointF borderPoint(const QRectF& rect, bool isEllipse, const QPointF& towards) {
  const QPointF centre = rect.center();
  const QPointF way = towards - centre;
  const double across = std::abs(way.x()) / (rect.width() / 2.0);
  const double down = std::abs(way.y()) / (rect.height() / 2.0);
  const double reach = isEllipse ? std::hypot(across, down) : std::max(across, down);
  return reach > 0.0 ? centre + way / reach : centre;
}

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& tip) {
  const QLineF line(tip, from);
  if (line.length() < 1.0) {
    return;
  }
  const QPointF along = (from - tip) / line.length();
  const QPointF side(-along.y(), along.x());
  const QPointF foot = tip + along * kArrowPx;
  painter.drawPolygon(QPolygonF{tip, foot + side * kArrowPx * 0.42, foot - side * kArrowPx * 0.42});
}

/// A long name in two lines, broken before a capital letter.
QString brokenName(const QString& name, const QFontMetricsF& metrics, double roomPx) {
  if (metrics.horizontalAdvance(name) <= roomPx) {
    return name;
  }
  int best = -1;
  for (int i = 1; i < name.size(); ++i) {
    if (name[i].isUpper() &&
        (best < 0 || std::abs(2 * i - name.size()) < std::abs(2 * best - name.size()))) {
      best = i;
    }
  }
  return best < 0 ? name : name.left(best) + QLatin1Char('\n') + name.mid(best);
}

/// What a place holds, where a few letters can say it.
QString shortValue(const petri::Net& net, const petri::Place& place,
                   const std::vector<petri::Token>& tokens) {
  if (tokens.size() != 1) {
    return {};
  }
  const petri::Words& value = tokens.front().value;
  switch (net.colours[place.colour].kind) {
    case petri::ColourKind::Int:
    case petri::ColourKind::Bool:
      return QString::fromStdString(net.textOf(place.colour, value.data()));
    case petri::ColourKind::List:
      return QStringLiteral("[%1]").arg(value.front());
    default:
      return {};
  }
}

QStringList textsOf(const std::vector<std::string>& texts) {
  QStringList all;
  for (const std::string& text : texts) {
    all.append(QString::fromStdString(text));
  }
  return all;
}

}  // namespace

NetCanvas::NetCanvas(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void NetCanvas::setState(const NetState* state) {
  m_state = state;
  refresh();
}

const std::vector<petri::PageNode>& NetCanvas::nodes() const {
  static const std::vector<petri::PageNode> kNone;
  return m_net == nullptr ? kNone : m_net->pages[m_page].nodes;
}

void NetCanvas::refresh() {
  const petri::Net* const net = m_state == nullptr ? nullptr : m_state->net.get();
  if (net != m_net) {
    m_net = net;
    m_page = net == nullptr ? 0 : std::min(m_page, net->pages.size() - 1);
    m_arcs = net == nullptr ? std::vector<petri::PageArc>{} : petri::arcsOfPage(*net, m_page);
  }
  update();
}

void NetCanvas::setPage(std::size_t page) {
  if (m_net == nullptr || page >= m_net->pages.size() || page == m_page) {
    return;
  }
  m_page = page;
  m_arcs = petri::arcsOfPage(*m_net, page);
  m_selected.reset();
  Q_EMIT selectionChanged();
  update();
}

void NetCanvas::select(std::optional<std::size_t> node) {
  if (node && *node >= nodes().size()) {
    node.reset();
  }
  if (node != m_selected) {
    m_selected = node;
    setAccessibleDescription(node ? textOf(*node) : QString());
    Q_EMIT selectionChanged();
    update();
  }
}

QSize NetCanvas::minimumSizeHint() const {
  return {static_cast<int>(kLeastColumns * kColumnPxMin), static_cast<int>(kLeastRows * kRowPxMin)};
}

QSize NetCanvas::sizeHint() const {
  return {600, 380};
}

QRectF NetCanvas::nodeRect(std::size_t node) const {
  const QRectF extent = extentOf(nodes());
  const QRectF room =
      QRectF(rect()).adjusted(kNetPaddingPx, kNetPaddingPx, -kNetPaddingPx, -kNetPaddingPx);
  const double columnPx = room.width() / (extent.width() + 1.0);
  const double rowPx = room.height() / (extent.height() + 1.0);
  const petri::PageNode& drawn = nodes()[node];
  const QPointF centre(room.left() + (drawn.column + 0.5) * columnPx,
                       room.top() + (drawn.row + 0.5) * rowPx);
  const QSizeF size(std::min(kNodeShare * columnPx, kNodeWidthMaxPx),
                    std::clamp(kNodeHeightShare * rowPx, kNodeHeightMinPx, kNodeHeightMaxPx));
  return {centre - QPointF(size.width() / 2.0, size.height() / 2.0), size};
}

std::optional<std::size_t> NetCanvas::nodeAt(const QPointF& point) const {
  for (std::size_t i = 0; i < nodes().size(); ++i) {
    if (nodeRect(i).contains(point)) {
      return i;
    }
  }
  return std::nullopt;
}

bool NetCanvas::leadsTo(const petri::PageNode& node, std::size_t transition) const {
  return (node.kind == Kind::Transition && node.index == transition) ||
         (node.kind == Kind::Substitution && petri::isOnPage(*m_net, transition, node.index));
}

bool NetCanvas::isMarked(std::size_t node) const {
  const petri::PageNode& drawn = nodes()[node];
  for (std::size_t i = 0; i < m_state->enabled.size(); ++i) {
    if (m_state->enabled[i] && leadsTo(drawn, i)) {
      return true;
    }
  }
  return false;
}

QString NetCanvas::textOf(std::size_t node) const {
  const petri::PageNode& drawn = nodes()[node];
  QStringList lines{QString::fromStdString(drawn.name)};
  if (drawn.kind == Kind::Place) {
    const petri::Place& place = m_net->places[drawn.index];
    const std::vector<petri::Token>& tokens = m_state->marking[drawn.index];
    lines.front() +=
        QStringLiteral(": ") + QString::fromStdString(m_net->colours[place.colour].name);
    lines.append(place.isObserver ? tr("Only records; holds no tokens.")
                                  : tr("Tokens: %1").arg(countText(tokens.size())));
    for (std::size_t i = 0; i < tokens.size() && i < kTokensListed; ++i) {
      QString text = QString::fromStdString(m_net->textOf(place.colour, tokens[i].value.data()));
      if (tokens[i].time > m_state->now) {
        text += QStringLiteral(" @ %1").arg(tokens[i].time);
      }
      lines.append(text);
    }
  } else if (drawn.kind == Kind::Transition) {
    const petri::Transition& transition = m_net->transitions[drawn.index];
    lines.append(tr("Priority %1").arg(transition.priority));
    if (!transition.guardText.empty()) {
      lines.append(tr("If %1").arg(QString::fromStdString(transition.guardText)));
    }
    for (const petri::PageArc& arc : m_arcs) {
      if (arc.node != node) {
        continue;
      }
      const QString place = QString::fromStdString(nodes()[arc.place].name);
      for (const QString& text : textsOf(arc.taken)) {
        lines.append(QStringLiteral("%1 → %2").arg(place, text));
      }
      for (const QString& text : textsOf(arc.put)) {
        lines.append(QStringLiteral("%2 → %1").arg(place, text));
      }
    }
  } else {
    lines.append(tr("A page of its own: Enter or a double click opens it."));
  }
  return lines.join(QLatin1Char('\n'));
}

void NetCanvas::openNode(std::size_t node) {
  if (nodes()[node].kind == Kind::Substitution) {
    Q_EMIT pageRequested(static_cast<int>(nodes()[node].index));
  }
}

void NetCanvas::mousePressEvent(QMouseEvent* event) {
  select(nodeAt(event->position()));
}

void NetCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto node = nodeAt(event->position())) {
    openNode(*node);
  }
}

/// To the node that is nearest in a direction.
void NetCanvas::moveSelection(int key) {
  if (nodes().empty()) {
    return;
  }
  if (!m_selected) {
    select(0);
    return;
  }
  const petri::PageNode& from = nodes()[*m_selected];
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < nodes().size(); ++i) {
    double along = nodes()[i].column - from.column;
    double aside = nodes()[i].row - from.row;
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      std::swap(along, aside);
    }
    if (key == Qt::Key_Left || key == Qt::Key_Up) {
      along = -along;
    }
    // What lies aside is farther than it looks.
    const double distance = along + 2.0 * std::abs(aside);
    if (along > 0.0 && distance < least) {
      least = distance;
      best = i;
    }
  }
  if (best) {
    select(best);
  }
}

void NetCanvas::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      moveSelection(event->key());
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (m_selected) {
        openNode(*m_selected);
        return;
      }
      break;
    case Qt::Key_Backspace:
      if (m_net != nullptr && m_page != 0) {
        Q_EMIT pageRequested(static_cast<int>(m_net->pages[m_page].parent));
        return;
      }
      break;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

bool NetCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* const help = static_cast<QHelpEvent*>(event);
    if (const auto node = nodeAt(help->pos())) {
      QToolTip::showText(help->globalPos(), textOf(*node), this, nodeRect(*node).toRect());
      return true;
    }
  }
  return QWidget::event(event);
}

void NetCanvas::drawArc(QPainter& painter, const petri::PageArc& arc) const {
  const ThemeColors& colors = themeColors(palette());
  const bool hasFired = m_state->fired && leadsTo(nodes()[arc.node], *m_state->fired);
  const QColor color = hasFired ? colors.accent : colors.outline;
  const QRectF place = nodeRect(arc.place);
  const QRectF box = nodeRect(arc.node);
  const QPointF start = borderPoint(place, true, box.center());
  const QPointF end = borderPoint(box, false, place.center());
  painter.setPen(QPen(color, hasFired ? kThickPx : kFramePx));
  painter.drawLine(start, end);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  if (arc.takes) {
    drawArrow(painter, start, end);
  }
  if (arc.puts) {
    drawArrow(painter, end, start);
  }
}

void NetCanvas::drawName(QPainter& painter, const QRectF& room, const QString& name,
                         const QString& value) const {
  const QFontMetricsF metrics(painter.font());
  QStringList lines = brokenName(name, metrics, room.width()).split(QLatin1Char('\n'));
  if (!value.isEmpty()) {
    if (lines.size() > 1) {
      lines = QStringList{name};
    }
    lines.append(value);
  }
  double y = room.center().y() - metrics.height() * static_cast<double>(lines.size()) / 2.0;
  const QFont plain = painter.font();
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const bool isValue = !value.isEmpty() && i + 1 == lines.size();
    QFont font = plain;
    font.setBold(isValue);
    painter.setFont(font);
    painter.drawText(QRectF(room.left(), y, room.width(), metrics.height()), Qt::AlignCenter,
                     metrics.elidedText(lines[i], Qt::ElideRight, room.width()));
    y += metrics.height();
  }
  painter.setFont(plain);
}

void NetCanvas::drawPlace(QPainter& painter, std::size_t node) const {
  const ThemeColors& colors = themeColors(palette());
  const petri::PageNode& drawn = nodes()[node];
  const petri::Place& place = m_net->places[drawn.index];
  const std::vector<petri::Token>& tokens = m_state->marking[drawn.index];
  const QRectF ellipse = nodeRect(node);
  painter.setBrush(colors.surface);
  painter.setPen(QPen(colors.outline, kFramePx, place.isObserver ? Qt::DashLine : Qt::SolidLine));
  painter.drawEllipse(ellipse);
  if (drawn.isPort || drawn.isFusion) {
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(ellipse.adjusted(3.0, 3.0, -3.0, -3.0));
  }
  painter.setPen(colors.text);
  drawName(painter, ellipse.adjusted(9.0, 4.0, -9.0, -4.0), QString::fromStdString(drawn.name),
           shortValue(*m_net, place, tokens));
  if (tokens.empty()) {
    return;
  }
  // The number of tokens; a frame alone while none of them is available yet.
  const bool isReady = std::any_of(tokens.begin(), tokens.end(), [this](const petri::Token& token) {
    return token.time <= m_state->now;
  });
  const QString count = countText(tokens.size());
  const QFontMetricsF metrics(painter.font());
  const double height = metrics.height() + 2.0;
  const double width = std::max(height, metrics.horizontalAdvance(count) + 8.0);
  const QRectF badge(ellipse.right() - 0.75 * width, ellipse.top() - 0.3 * height, width, height);
  const QColor fill = isReady ? colors.trace : colors.surface;
  painter.setPen(QPen(colors.trace, kFramePx));
  painter.setBrush(fill);
  painter.drawRoundedRect(badge, height / 2.0, height / 2.0);
  painter.setPen(isReady ? colors.surface : colors.text);
  painter.drawText(badge, Qt::AlignCenter, count);
}

void NetCanvas::drawBox(QPainter& painter, std::size_t node) const {
  const ThemeColors& colors = themeColors(palette());
  const petri::PageNode& drawn = nodes()[node];
  const QRectF box = nodeRect(node);
  const bool marked = isMarked(node);
  const bool isNext = m_state->next && leadsTo(drawn, *m_state->next);
  painter.setBrush(isNext ? colors.accent : colors.button);
  painter.setPen(QPen(marked ? colors.accent : colors.outline, marked ? kThickPx : kFramePx));
  painter.drawRect(box);
  const QColor ink = isNext ? colors.surface : colors.text;
  if (drawn.kind == Kind::Substitution) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(isNext ? colors.surface : colors.outline, kFramePx));
    painter.drawRect(box.adjusted(4.0, 4.0, -4.0, -4.0));
  }
  painter.setPen(ink);
  drawName(painter, box.adjusted(5.0, 4.0, -5.0, -4.0), QString::fromStdString(drawn.name), {});
  if (marked) {
    const QPointF tip(box.left() - 2.0 + kMarkSidePx, box.top() - 2.0);
    painter.setBrush(colors.surface);
    painter.setPen(QPen(colors.accent, 2.0));
    painter.drawPolygon(QPolygonF{tip + QPointF(-kMarkSidePx, -kMarkSidePx),
                                  tip + QPointF(kMarkSidePx, 0.0),
                                  tip + QPointF(-kMarkSidePx, kMarkSidePx)});
  }
}

void NetCanvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  if (m_net == nullptr) {
    return;
  }
  QFont small = font();
  small.setPointSizeF(kScopeFontPt);
  painter.setFont(small);
  for (const petri::PageArc& arc : m_arcs) {
    drawArc(painter, arc);
  }
  for (std::size_t i = 0; i < nodes().size(); ++i) {
    if (nodes()[i].kind == Kind::Place) {
      drawPlace(painter, i);
    } else {
      drawBox(painter, i);
    }
  }
  if (m_selected) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.text, 1.5, Qt::DotLine));
    painter.drawRect(nodeRect(*m_selected).adjusted(-5.0, -5.0, 5.0, 5.0));
  }
}

}  // namespace rivulet::widgets
