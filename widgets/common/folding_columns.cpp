// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/folding_columns.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QStyle>

namespace rivulet::widgets {

namespace {

constexpr int kColumnPx = 380;
constexpr int kPagePx = 840;  ///< least width of the pages with their names, beside a column

/// A layout that squeezes wrapped texts does so without a word: the page gets its height first.
class ScrollingColumn final : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const bool result = QScrollArea::eventFilter(object, event);
    if (object == widget() &&
        (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)) {
      const QLayout* layout = widget()->layout();
      const int height = layout->hasHeightForWidth() ? layout->heightForWidth(widget()->width())
                                                     : widget()->sizeHint().height();
      if (height != widget()->minimumHeight()) {
        widget()->setMinimumHeight(height);
      }
    }
    return result;
  }
};

QScrollArea* scrolling(QScrollArea* area, QWidget* page) {
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(page);
  area->setMinimumSize(0, 0);
  area->setFocusPolicy(Qt::NoFocus);
  return area;
}

}  // namespace

QScrollArea* makeScrolling(QWidget* page, QWidget* parent) {
  return scrolling(new QScrollArea(parent), page);
}

QScrollArea* makeColumn(QWidget* page, QWidget* parent) {
  return scrolling(new ScrollingColumn(parent), page);
}

FoldingColumns::FoldingColumns(QWidget* centre, QWidget* first, QWidget* second, QWidget* parent)
    : QWidget(parent),
      m_columns{makeColumn(first, this), makeColumn(second, this)},
      m_centre(centre) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->setSizeConstraint(QLayout::SetNoConstraint);
  layout->addWidget(m_centre, 1);
  layout->addWidget(m_columns[First]);
  layout->addWidget(m_columns[Second]);
  show();
}

FoldingColumns::Room FoldingColumns::room() const {
  if (width() >= kPagePx + 2 * kColumnPx) {
    return Room::BothColumns;
  }
  return width() >= kPagePx + kColumnPx ? Room::OneColumn : Room::Page;
}

bool FoldingColumns::coversCentre() const {
  return m_room == Room::Page && (m_isOpen[First] || m_isOpen[Second]);
}

void FoldingColumns::setColumnsEnabled(bool areEnabled) {
  for (QScrollArea* column : m_columns) {
    column->setEnabled(areEnabled);
  }
}

void FoldingColumns::uncover() {
  if (coversCentre()) {
    m_isOpen[First] = m_isOpen[Second] = false;
    show();
  }
}

QSize FoldingColumns::minimumSizeHint() const {
  return {0, 0};
}

void FoldingColumns::setOpen(Column column, bool open) {
  if (open == m_isOpen[column]) {
    return;
  }
  m_isOpen[column] = open;
  if (open && m_room != Room::BothColumns) {
    m_isOpen[column == First ? Second : First] = false;
  }
  show();
}

void FoldingColumns::show() {
  const bool covers = coversCentre();
  const int scrollBar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  for (const Column column : {First, Second}) {
    QScrollArea* area = m_columns[column];
    area->setMinimumWidth(covers ? 0 : kColumnPx + scrollBar);
    area->setMaximumWidth(covers ? QWIDGETSIZE_MAX : kColumnPx + scrollBar);
    area->setVisible(m_isOpen[column]);
  }
  m_centre->setVisible(!covers);
  Q_EMIT changed();
}

void FoldingColumns::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (const Room now = room(); now != m_room) {
    m_room = now;
    // What is open stays open where it has room beside the page.
    m_isOpen[First] = m_isOpen[First] && now == Room::BothColumns;
    m_isOpen[Second] = m_isOpen[Second] && now != Room::Page;
    show();
  }
}

}  // namespace rivulet::widgets
