// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/status_label.h"

#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>

#include "widgets/common/elided_label.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

QString statusIconName(Status status) {
  switch (status) {
    case Status::Plain:
      break;
    case Status::Unknown:
      return QStringLiteral("status-unknown");
    case Status::Busy:
      return QStringLiteral("status-busy");
    case Status::Good:
      return QStringLiteral("status-good");
    case Status::Attention:
      return QStringLiteral("status-attention");
    case Status::Fault:
      return QStringLiteral("status-fault");
    case Status::Simulated:
      return QStringLiteral("status-simulated");
  }
  return {};
}

QColor statusColor(Status status, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  switch (status) {
    case Status::Attention:
    case Status::Simulated:
      return colors.attention;
    case Status::Fault:
      return colors.fault;
    case Status::Plain:
    case Status::Unknown:
    case Status::Busy:
    case Status::Good:
      break;
  }
  return colors.text;
}

StatusLabel::StatusLabel(QWidget* parent) : StatusLabel(parent, new QLabel) {
}

StatusLabel::StatusLabel(QWidget* parent, Elided elided)
    : StatusLabel(parent, new ElidedLabel(elided.lines)) {
}

StatusLabel::StatusLabel(QWidget* parent, QLabel* text)
    : QWidget(parent), m_icon(new QLabel(this)), m_text(text) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(m_icon, 0, Qt::AlignVCenter);  // as the text
  layout->addWidget(m_text, 1);
  m_text->setTextFormat(Qt::PlainText);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  restyle();
}

void StatusLabel::setStatus(Status status, const QString& text) {
  const bool same = status == m_status;
  m_status = status;
  if (m_text->text() != text) {
    m_text->setText(text);
  }
  if (!same) {
    restyle();
  }
}

QString StatusLabel::text() const {
  return m_text->text();
}

void StatusLabel::setEmphasis(qreal pointSize, bool bold) {
  QFont font = m_text->font();
  font.setPointSizeF(pointSize);
  font.setBold(bold);
  m_text->setFont(font);
  restyle();
}

void StatusLabel::setWordWrap(bool wrap) {
  m_text->setWordWrap(wrap);
  // Beside the first of several lines, also where something next to the label is higher.
  m_text->setAlignment(Qt::AlignLeft | (wrap ? Qt::AlignTop : Qt::AlignVCenter));
  layout()->setAlignment(m_icon, wrap ? Qt::AlignTop : Qt::AlignVCenter);
}

void StatusLabel::setFigure() {
  m_text->setTextInteractionFlags(Qt::NoTextInteraction);
}

void StatusLabel::setOutdated(bool isOutdated) {
  if (isOutdated != m_isOutdated) {
    m_isOutdated = isOutdated;
    QFont font = m_text->font();
    font.setStrikeOut(isOutdated);
    m_text->setFont(font);
    restyle();
  }
}

void StatusLabel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    restyle();
  }
  QWidget::changeEvent(event);
}

void StatusLabel::restyle() {
  const QColor color =
      m_isOutdated ? themeColors(palette()).mutedText : statusColor(m_status, palette());
  const int size = QFontMetrics(m_text->font()).height();
  m_icon->setVisible(m_status != Status::Plain);
  if (m_status != Status::Plain) {
    m_icon->setPixmap(iconPixmap(statusIconName(m_status), color, size, devicePixelRatioF()));
    m_icon->setFixedSize(size, size);
  }
  // Only the text takes the colour; a palette set on this widget itself would call us again.
  QPalette textPalette = m_text->palette();
  if (textPalette.color(QPalette::WindowText) != color) {
    textPalette.setColor(QPalette::WindowText, color);
    m_text->setPalette(textPalette);
  }
}

}  // namespace rivulet::widgets
