// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/message_area.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kRoomyPx = 420;

QColor severityColor(gcode::Severity severity, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  switch (severity) {
    case gcode::Severity::Warning:
      return colors.attention;
    case gcode::Severity::Error:
      return colors.fault;
    case gcode::Severity::Note:
      break;
  }
  return colors.text;
}

}  // namespace

MessageArea::MessageArea(QWidget* parent)
    : Page(parent),
      m_icon(new QLabel(this)),
      m_severityText(makeHeading(this)),
      m_text(new ElidedLabel(2, this)),
      m_copy(new QToolButton(this)),
      m_dismiss(new QToolButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 2, 4, 2);
  layout->setSpacing(8);
  layout->addWidget(m_icon);
  layout->addWidget(m_severityText);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_copy);
  layout->addWidget(m_dismiss);
  for (QToolButton* button : {m_copy, m_dismiss}) {
    button->setAutoRaise(true);
    button->setFixedSize(kTouchHeightPx, kTouchHeightPx);
    button->setIconSize(QSize(20, 20));
  }
  connect(m_copy, &QToolButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(m_text->text()); });
  connect(m_dismiss, &QToolButton::clicked, this, [this] {
    clear();
    Q_EMIT dismissed();
  });
  hide();
  retranslate();
  restyle();
}

void MessageArea::showMessage(Severity severity, const QString& text) {
  m_severity = severity;
  m_text->setText(text);
  retranslate();
  restyle();
  show();
}

void MessageArea::clear() {
  m_text->clear();
  hide();
}

QString MessageArea::text() const {
  return m_text->text();
}

void MessageArea::retranslate() {
  m_severityText->setText(severityText(m_severity));
  m_copy->setToolTip(tr("Copy the message"));
  m_copy->setAccessibleName(tr("Copy the message"));
  m_dismiss->setToolTip(tr("Dismiss the message"));
  m_dismiss->setAccessibleName(tr("Dismiss the message"));
}

void MessageArea::restyle() {
  const QColor color = severityColor(m_severity, palette());
  m_icon->setPixmap(iconPixmap(severityIconName(m_severity), color, 24, devicePixelRatioF()));
  QPalette textPalette = m_severityText->palette();
  textPalette.setColor(QPalette::WindowText, color);
  m_severityText->setPalette(textPalette);
  const QColor neutral = themeColors(palette()).text;
  m_copy->setIcon(themedIcon(QStringLiteral("copy"), neutral));
  m_dismiss->setIcon(themedIcon(QStringLiteral("dismiss"), neutral));
}

void MessageArea::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // In a small window the text is more important; the shape of the icon says the same.
  const bool hasRoom = width() >= kRoomyPx;
  m_severityText->setVisible(hasRoom);
  m_copy->setVisible(hasRoom);
}

void MessageArea::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  painter.fillRect(QRect(0, 0, 4, height()), severityColor(m_severity, palette()));
  painter.setPen(colors.line);
  painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace rivulet::widgets
