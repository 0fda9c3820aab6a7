// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/alarms/alarm_line.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include "widgets/alarms/alarm_text.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

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

void setTextColor(QWidget* widget, const QColor& color) {
  QPalette palette = widget->palette();
  palette.setColor(QPalette::WindowText, color);
  widget->setPalette(palette);
}

}  // namespace

AlarmLine::AlarmLine(QWidget* parent)
    : Page(parent),
      m_title(new ElidedLabel(1, this)),
      m_remedy(new ElidedLabel(1, this)),
      m_noteText(new ElidedLabel(2, this)),
      m_acknowledge(
          say(new QToolButton(this), {.text = QT_TR_NOOP("Ack"),
                                      .tip = QT_TR_NOOP("Acknowledge: you have seen this alarm"),
                                      .name = QT_TR_NOOP("Acknowledge the alarm")})),
      m_list(say(new QToolButton(this), {.tip = QT_TR_NOOP("Show all alarms")})),
      m_dismiss(say(new QToolButton(this),
                    {.hint = QT_TR_NOOP("Dismiss the message"), .icon = "dismiss"})) {
  auto* texts =
      inColumn({spring(), m_title, m_remedy, m_noteText, spring()}, nullptr, QMargins(0, 0, 0, 0));
  texts->setSpacing(0);
  auto* layout =
      inRow({m_icon, {texts, 1}, m_dismiss, m_acknowledge, m_list}, this, QMargins(12, 2, 4, 2));
  layout->setSpacing(8);
  for (QToolButton* button : {m_acknowledge, m_list, m_dismiss}) {
    button->setMinimumSize(kTouchHeightPx, kTouchHeightPx);
    button->setIconSize(QSize(20, 20));
  }
  m_dismiss->setAutoRaise(true);
  m_noteTimer.setSingleShot(true);
  m_noteTimer.setInterval(kNoteMs);
  connect(&m_noteTimer, &QTimer::timeout, this, &AlarmLine::clearNote);
  connect(m_dismiss, &QToolButton::clicked, this, &AlarmLine::clearNote);
  connect(m_list, &QToolButton::clicked, this, &AlarmLine::listRequested);
  connect(m_acknowledge, &QToolButton::clicked, this, [this] {
    if (m_alarm) {
      Q_EMIT acknowledgeRequested(m_alarm->number);
    }
  });
  retranslate();
  restyle();
}

void AlarmLine::setAlarm(const std::optional<alarm::Alarm>& alarm, std::size_t count) {
  m_alarm = alarm;
  m_count = count;
  if (m_alarm && m_note && !m_noteTimer.isActive()) {
    m_noteTimer.start();
  }
  retranslate();
  restyle();
}

void AlarmLine::showNote(gcode::Severity severity, Text text) {
  m_noteSeverity = severity;
  m_note = std::move(text);
  m_noteTimer.stop();
  if (m_alarm) {
    m_noteTimer.start();
  }
  retranslate();
  restyle();
}

void AlarmLine::clearNote() {
  m_note = nullptr;
  m_noteTimer.stop();
  retranslate();
  restyle();
}

QString AlarmLine::text() const {
  if (m_note) {
    return m_noteText->text();
  }
  return m_alarm ? m_title->text() + QLatin1Char('\n') + m_remedy->text() : QString();
}

gcode::Severity AlarmLine::severity() const {
  return m_note || !m_alarm ? m_noteSeverity : severityOf(alarm::factsOf(m_alarm->code).priority);
}

void AlarmLine::retranslate() {
  m_noteText->setText(m_note ? m_note() : QString());
  m_title->setText(m_alarm ? alarmText(*m_alarm) : QString());
  m_remedy->setText(m_alarm ? alarmRemedy(*m_alarm) : QString());
  m_list->setText(QStringLiteral("(%1)").arg(m_count));
  m_list->setAccessibleName(tr("Alarms: %1. Show all").arg(m_count));
  refresh();
}

void AlarmLine::refresh() {
  const bool hasNote = static_cast<bool>(m_note);
  const bool hasAlarm = m_alarm.has_value();
  m_noteText->setVisible(hasNote);
  m_title->setVisible(!hasNote && hasAlarm);
  m_remedy->setVisible(!hasNote && hasAlarm);
  m_icon->setVisible(hasNote || hasAlarm);
  m_dismiss->setVisible(hasNote);
  m_acknowledge->setVisible(!hasNote && hasAlarm && !m_alarm->isAcknowledged);
  m_list->setVisible(m_count > 0);
  setCursor(hasAlarm ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setAccessibleName(hasNote || hasAlarm ? severityText(severity()) + QStringLiteral(": ") + text()
                                        : QString());
}

void AlarmLine::restyle() {
  const QColor color = severityColor(severity(), palette());
  m_icon->setPixmap(iconPixmap(severityIconName(severity()), color, 24, devicePixelRatioF()));
  setTextColor(m_title, color);
  QFont font = m_title->font();
  font.setBold(m_alarm && !m_alarm->isAcknowledged);
  m_title->setFont(font);
  update();
}

void AlarmLine::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  m_icon->setFixedWidth(24);
}

void AlarmLine::mouseReleaseEvent(QMouseEvent* event) {
  Page::mouseReleaseEvent(event);
  if (m_alarm && rect().contains(event->pos())) {
    Q_EMIT listRequested();
  }
}

void AlarmLine::paintEvent(QPaintEvent* /*event*/) {
  if (!m_note && !m_alarm) {
    return;
  }
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  painter.fillRect(QRect(0, 0, 4, height()), severityColor(severity(), palette()));
  painter.setPen(colors.line);
  painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace rivulet::widgets
