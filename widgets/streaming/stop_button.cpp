// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/stop_button.h"

#include <QStyleOptionButton>
#include <QStylePainter>

namespace rivulet::widgets {

StopButton::StopButton(QWidget* parent) : QPushButton(parent) {
}

void StopButton::setNote(const QString& note) {
  m_note = note;
  setAccessibleDescription(note);
  update();
}

QFont StopButton::noteFont() const {
  constexpr double kNotePt = 9.0;
  QFont small = font();
  small.setPointSizeF(kNotePt);
  small.setBold(false);
  return small;
}

void StopButton::paintEvent(QPaintEvent* event) {
  if (m_note.isEmpty()) {
    QPushButton::paintEvent(event);
    return;
  }
  constexpr int kGapPx = 4;  ///< to the edge below
  const QFont small = noteFont();
  const QFontMetrics metrics(small);
  QStylePainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  painter.drawControl(QStyle::CE_PushButtonBevel, option);
  const QRect all = option.rect;
  option.rect = all.adjusted(0, 0, 0, -metrics.height());
  painter.drawControl(QStyle::CE_PushButtonLabel, option);
  painter.setFont(small);
  painter.setPen(option.palette.color(QPalette::ButtonText));
  const QRect below(all.left() + kGapPx, all.bottom() - kGapPx - metrics.height(),
                    all.width() - 2 * kGapPx, metrics.height());
  painter.drawText(below, Qt::AlignCenter,
                   metrics.elidedText(m_note, Qt::ElideRight, below.width()));
}

}  // namespace rivulet::widgets
