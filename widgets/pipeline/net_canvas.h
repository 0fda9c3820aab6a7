// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One page of a Petri net, drawn where its file says: places as ellipses with the number of their
/// tokens, transitions as boxes, pages behind substitutions as boxes with a double frame. A
/// transition that could fire has a thick frame and a triangle, the one that fires next is filled;
/// so has a box that it is behind. What fired last has thick lines.
///
/// A click or the arrow keys choose a node; a double click or Enter opens the page behind a box,
/// Backspace the page that this one stands on. @threadsafety GUI thread.
#pragma once

#include <QPainterPath>
#include <QWidget>
#include <optional>
#include <vector>

#include "petri/page_arcs.h"
#include "widgets/pipeline/net_state.h"

namespace rivulet::widgets {

class NetCanvas final : public QWidget {
  Q_OBJECT

 public:
  explicit NetCanvas(QWidget* parent = nullptr);

  /// @param state  outlives the canvas; `refresh` says that it has changed
  void setState(const NetState* state);
  void refresh();
  /// @param page  index in the net
  void setPage(std::size_t page);
  [[nodiscard]] std::size_t page() const { return m_page; }

  void select(std::optional<std::size_t> node);
  [[nodiscard]] std::optional<std::size_t> selected() const { return m_selected; }
  /// Where a node of the page is drawn.
  [[nodiscard]] QRectF nodeRect(std::size_t node) const;
  /// Whether the triangle of what can fire is drawn in a node.
  [[nodiscard]] bool isMarked(std::size_t node) const;
  /// Name, colour set and tokens of a place; guard and arcs of a transition.
  [[nodiscard]] QString textOf(std::size_t node) const;

  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void selectionChanged();
  void pageRequested(int page);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] const std::vector<petri::PageNode>& nodes() const;
  [[nodiscard]] std::optional<std::size_t> nodeAt(const QPointF& point) const;
  [[nodiscard]] bool leadsTo(const petri::PageNode& node, std::size_t transition) const;
  void openNode(std::size_t node);
  void moveSelection(int key);
  void drawArc(QPainter& painter, const petri::PageArc& arc) const;
  void drawPlace(QPainter& painter, std::size_t node) const;
  void drawBox(QPainter& painter, std::size_t node) const;
  void drawName(QPainter& painter, const QRectF& room, const QString& name,
                const QString& value) const;

  const NetState* m_state = nullptr;
  const petri::Net* m_net = nullptr;  ///< for which the arcs were found; for comparison only
  std::size_t m_page = 0;
  std::vector<petri::PageArc> m_arcs;
  std::optional<std::size_t> m_selected;
};

}  // namespace rivulet::widgets
