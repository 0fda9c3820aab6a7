// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/page.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <utility>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

Page::Page(QWidget* parent) : QWidget(parent), Parts(static_cast<QWidget*>(this)) {
}

void Page::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    m_waitsForLanguage = canWait();
    if (!m_waitsForLanguage) {
      followLanguage();
    }
  } else if (event->type() == QEvent::PaletteChange) {
    m_waitsForTheme = canWait();
    if (!m_waitsForTheme) {
      followTheme();
    }
  }
  QWidget::changeEvent(event);
}

bool Page::event(QEvent* event) {
  if (event->type() == QEvent::Show) {
    if (std::exchange(m_waitsForLanguage, false)) {
      followLanguage();
    }
    if (std::exchange(m_waitsForTheme, false)) {
      followTheme();
    }
  }
  return QWidget::event(event);
}

void Page::follow(std::vector<Call>& calls, const Call& call) {
  calls.push_back(call);
  call();
}

void Page::followLanguage() {
  setLocale(QLocale());  // spin boxes show and read numbers in the new language
  retranslateParts();
  for (const Call& call : m_onLanguage) {
    call();
  }
  retranslate();
}

void Page::followTheme() {
  restyleParts();
  for (const Call& call : m_onTheme) {
    call();
  }
  restyle();
}

QPushButton* makeTouchButton(QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setMinimumHeight(kTouchHeightPx);
  button->setIconSize(QSize(20, 20));
  return button;
}

QLabel* makeValueLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setTextFormat(Qt::PlainText);
  return label;
}

void paintAttentionBar(QWidget& bar) {
  QPainter painter(&bar);
  const ThemeColors& colors = themeColors(bar.palette());
  painter.fillRect(bar.rect(), colors.surface);
  painter.fillRect(QRect(0, 0, 4, bar.height()), colors.attention);
  painter.setPen(colors.line);
  painter.drawLine(0, bar.height() - 1, bar.width(), bar.height() - 1);
}

QLabel* makeHeading(QWidget* parent) {
  auto* label = new QLabel(parent);
  QFont font = label->font();
  font.setBold(true);
  label->setFont(font);
  return label;
}

void setMuted(QWidget* widget, const QPalette& palette) {
  QPalette muted = widget->palette();
  muted.setColor(QPalette::WindowText, themeColors(palette).mutedText);
  widget->setPalette(muted);
}

}  // namespace rivulet::widgets
