// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/elided_label.h"

#include <QHelpEvent>
#include <QPainter>
#include <QTextLayout>
#include <QToolTip>
#include <algorithm>

namespace rivulet::widgets {

ElidedLabel::ElidedLabel(int lines, QWidget* parent) : QLabel(parent), m_lines(lines) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

int ElidedLabel::heightPx() const {
  return m_lines * fontMetrics().lineSpacing();
}

QSize ElidedLabel::sizeHint() const {
  return {fontMetrics().horizontalAdvance(text()), heightPx()};
}

QSize ElidedLabel::minimumSizeHint() const {
  return {0, heightPx()};
}

QStringList ElidedLabel::shownLines() const {
  const QString all = text();
  QStringList lines;
  QTextLayout layout(all, font());
  layout.beginLayout();
  while (lines.size() < m_lines) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) {
      break;
    }
    line.setLineWidth(std::max(1, width()));
    lines.append(all.mid(line.textStart(), line.textLength()));
    if (lines.size() == m_lines) {
      lines.last() =
          fontMetrics().elidedText(all.mid(line.textStart()), Qt::ElideRight, std::max(1, width()));
    }
  }
  layout.endLayout();
  return lines;
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && toolTip().isEmpty()) {
    // Only what cannot be read in full needs one.
    const bool isCut = shownLines().join(QString()) != text();
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), isCut ? text() : QString(),
                       this);
    return true;
  }
  return QLabel::event(event);
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  const QStringList lines = shownLines();
  const int spacing = fontMetrics().lineSpacing();
  int top = (height() - spacing * static_cast<int>(lines.size())) / 2;
  for (const QString& line : lines) {
    painter.drawText(QRect(0, top, width(), spacing),
                     static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter,
                     line);
    top += spacing;
  }
}

}  // namespace rivulet::widgets
