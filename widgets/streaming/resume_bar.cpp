// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/resume_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "widgets/common/hold_button.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

ResumeBar::ResumeBar(QWidget* parent)
    : Page(parent),
      m_icon(new QLabel(this)),
      m_text(makeValueLabel(this)),
      m_goOn(new HoldButton(this)),
      m_dismiss(makeTouchButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 2, 12, 2);
  layout->setSpacing(12);
  layout->addWidget(m_icon);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_goOn);
  layout->addWidget(m_dismiss);
  m_text->setWordWrap(true);
  connect(m_goOn, &HoldButton::held, this, &ResumeBar::goOnRequested);
  connect(m_dismiss, &QPushButton::clicked, this, [this] {
    showNothing();
    Q_EMIT dismissed();
  });
  hide();
  retranslate();
  restyle();
}

void ResumeBar::showAsking() {
  setState(State::Asking);
}

void ResumeBar::showPlace(const ResumePlace& place) {
  m_place = place;
  setState(State::Place);
}

void ResumeBar::showRefusal(const QString& reason) {
  m_reason = reason;
  setState(State::Refusal);
}

void ResumeBar::showNothing() {
  setState(State::Nothing);
}

void ResumeBar::setState(State state) {
  m_state = state;
  if (state != State::Place) {
    m_place.reset();
  }
  setVisible(state != State::Nothing);
  retranslate();
  restyle();
}

void ResumeBar::retranslate() {
  m_goOn->setVisible(m_state == State::Place);
  m_dismiss->setVisible(m_state == State::Place || m_state == State::Refusal);
  m_dismiss->setText(m_state == State::Place ? tr("Not now") : tr("Close"));
  switch (m_state) {
    case State::Nothing:
      m_text->clear();
      break;
    case State::Asking:
      m_text->setText(tr("Asking the control where the run was left …"));
      break;
    case State::Place: {
      QString text =
          tr("Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4.")
              .arg(countText(m_place->point + 1), countText(m_place->points),
                   countText(m_place->line.value),
                   QStringLiteral("X %1 Y %2 Z %3")
                       .arg(numberText(m_place->positionMm.x, 3),
                            numberText(m_place->positionMm.y, 3),
                            lengthText(m_place->positionMm.z, 3)));
      if (m_place->approachMm) {
        text += QLatin1Char(' ') + tr("The tool first moves %1 in a straight line to that point.")
                                       .arg(lengthText(*m_place->approachMm));
      }
      m_text->setText(text);
      m_goOn->setText(tr("Press and hold: resume at point %1").arg(countText(m_place->point + 1)));
      m_goOn->setToolTip(tr("Hold for one second. Then the machine moves."));
      break;
    }
    case State::Refusal:
      m_text->setText(tr("The run cannot be resumed: %1").arg(m_reason));
      break;
  }
}

void ResumeBar::restyle() {
  const ThemeColors& colors = themeColors(palette());
  const Status status = m_state == State::Refusal ? Status::Attention : Status::Busy;
  m_icon->setPixmap(m_state == State::Place
                        ? iconPixmap(QStringLiteral("resume"), colors.text, 24, devicePixelRatioF())
                        : iconPixmap(statusIconName(status), statusColor(status, palette()), 24,
                                     devicePixelRatioF()));
  m_goOn->setIcon(themedIcon(QStringLiteral("resume"), colors.text));
  m_dismiss->setIcon(themedIcon(QStringLiteral("dismiss"), colors.text));
  update();
}

void ResumeBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  painter.fillRect(QRect(0, 0, 4, height()),
                   m_state == State::Refusal ? colors.attention : colors.accent);
  painter.setPen(colors.line);
  painter.drawLine(0, 0, width(), 0);
}

}  // namespace rivulet::widgets
