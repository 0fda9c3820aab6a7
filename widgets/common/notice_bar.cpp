// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/notice_bar.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QResizeEvent>

#include "widgets/common/hold_button.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

/// Below this width the buttons have a row of their own.
constexpr int kOneRowWidthPx = 980;
constexpr int kStripeWidthPx = 4;

}  // namespace

NoticeBar::NoticeBar(QWidget* parent)
    : Page(parent),
      m_rows(new QGridLayout(this)),
      m_buttons(new QWidget(this)),
      m_buttonRow(new QHBoxLayout(m_buttons)) {
  m_rows->setContentsMargins(12, 4, 12, 4);
  m_rows->setHorizontalSpacing(12);
  m_rows->setVerticalSpacing(2);
  m_rows->setColumnStretch(1, 1);
  m_buttonRow->setContentsMargins(0, 0, 0, 0);
  m_buttonRow->setSpacing(12);
  m_text->setMinimumWidth(0);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  arrange();
  hide();
}

QSize NoticeBar::minimumSizeHint() const {
  return {0, Page::minimumSizeHint().height()};
}

void NoticeBar::setNotice(Status status, const QString& text) {
  m_status = status;
  m_text->setText(text);
  NoticeBar::restyle();
}

void NoticeBar::setIcon(const QString& name) {
  m_iconName = name;
  NoticeBar::restyle();
}

QPushButton* NoticeBar::addButton(const Part& part) {
  QPushButton* made = button(part);
  m_buttonRow->addWidget(made);
  return made;
}

HoldButton* NoticeBar::addHoldButton(const Part& part) {
  auto* made = say(new HoldButton(m_buttons), part);
  m_buttonRow->addWidget(made);
  return made;
}

void NoticeBar::arrange() {
  const bool isNarrow = width() < kOneRowWidthPx;
  for (QWidget* part : {static_cast<QWidget*>(m_icon), static_cast<QWidget*>(m_text), m_buttons}) {
    m_rows->removeWidget(part);
  }
  m_rows->addWidget(m_icon, 0, 0);
  m_rows->addWidget(m_text, 0, 1);
  m_rows->addWidget(m_buttons, isNarrow ? 1 : 0, isNarrow ? 0 : 2, 1, isNarrow ? 2 : 1,
                    Qt::AlignRight);
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  if ((width() < kOneRowWidthPx) != (event->oldSize().width() < kOneRowWidthPx)) {
    arrange();
  }
}

void NoticeBar::restyle() {
  const ThemeColors& colors = themeColors(palette());
  const bool isOwn = !m_iconName.isEmpty();
  m_icon->setPixmap(iconPixmap(isOwn ? m_iconName : statusIconName(m_status),
                               isOwn ? colors.text : statusColor(m_status, palette()), 24,
                               devicePixelRatioF()));
  update();
}

void NoticeBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  const bool isAbnormal = m_status == Status::Attention || m_status == Status::Fault;
  painter.fillRect(QRect(0, 0, kStripeWidthPx, height()),
                   isAbnormal ? statusColor(m_status, palette()) : colors.accent);
  painter.setPen(colors.line);
  painter.drawLine(0, 0, width(), 0);
}

}  // namespace rivulet::widgets
