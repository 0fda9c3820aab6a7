// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/resume_bar.h"

#include <QPushButton>

#include "widgets/common/hold_button.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

QString restText(const ResumePlace& place) {
  if (!place.restMm) {
    return {};
  }
  return *place.restMm > 0.0
             ? ResumeBar::tr(
                   "The program still stands on the control: first it executes the rest "
                   "of its window, at most %1, and ends.")
                   .arg(lengthText(*place.restMm))
             : ResumeBar::tr(
                   "The program still stands on the control, between its windows: it "
                   "ends without a move.");
}

ResumeBar::ResumeBar(QWidget* parent)
    : NoticeBar(parent),
      m_goOn(addHoldButton({.tip = QT_TR_NOOP("Hold for one second. Then the machine moves."),
                            .icon = "resume",
                            .id = "go-on"})),
      m_dismiss(addButton({.icon = "dismiss", .id = "not-now"})) {
  setObjectName(QStringLiteral("resume-bar"));
  connect(m_goOn, &HoldButton::held, this, &ResumeBar::goOnRequested);
  connect(m_dismiss, &QPushButton::clicked, this, [this] {
    showNothing();
    Q_EMIT dismissed();
  });
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
}

void ResumeBar::retranslate() {
  m_goOn->setVisible(m_state == State::Place);
  m_dismiss->setVisible(m_state == State::Place || m_state == State::Refusal);
  m_dismiss->setText(m_state == State::Place ? tr("Not now") : tr("Close"));
  setIcon(m_state == State::Place ? QStringLiteral("resume") : QString());
  switch (m_state) {
    case State::Nothing:
      setNotice(Status::Busy, {});
      break;
    case State::Asking:
      setNotice(Status::Busy, tr("Asking the control where the run was left …"));
      break;
    case State::Place:
      setNotice(m_place->changedFrom ? Status::Attention : Status::Busy, placeText());
      m_goOn->setText(m_place->isJob
                          ? tr("Press and hold: go on with the job")
                          : (m_place->isChosen ? tr("Press and hold: start at point %1")
                                               : tr("Press and hold: resume at point %1"))
                                .arg(countText(m_place->point + 1)));
      break;
    case State::Refusal:
      setNotice(Status::Attention, tr("The run cannot be resumed: %1").arg(m_reason));
      break;
  }
}

QString ResumeBar::jobText() const {
  const QString line = countText(m_place->line.value);
  const QString place =
      m_place->block.empty()
          ? tr("Nothing has moved yet. The job will go on in part %1 at point %2 of %3, line "
               "%4.")
                .arg(countText(static_cast<std::size_t>(m_place->stretch)),
                     countText(m_place->point + 1), countText(m_place->points), line)
          : tr("Nothing has moved yet. The job will go on at line %1: %2.")
                .arg(line, QString::fromStdString(m_place->block));
  const QString rest = restText(*m_place);
  const QString before = rest.isEmpty() ? place : place + QLatin1Char(' ') + rest;
  return m_place->steps.empty()
             ? before
             : before + QLatin1Char(' ') +
                   tr("Before that, the control executes %Ln blocks: see the list.", nullptr,
                      static_cast<int>(m_place->steps.size()));
}

QString ResumeBar::placeText() const {
  if (m_place->isJob) {
    return jobText();
  }
  QString text =
      (m_place->isChosen
           ? tr("Nothing has moved yet. The run will start at point %1 of %2, where line %3 "
                "begins: "
                "%4.")
           : tr("Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4."))
          .arg(countText(m_place->point + 1), countText(m_place->points),
               countText(m_place->line.value),
               QStringLiteral("X %1 Y %2 Z %3")
                   .arg(numberText(m_place->positionMm.x, 3), numberText(m_place->positionMm.y, 3),
                        lengthText(m_place->positionMm.z, 3)));
  if (m_place->restMm) {
    text += QLatin1Char(' ') + restText(*m_place);
  }
  if (m_place->approachMm) {
    text += QLatin1Char(' ') + (m_place->restMm.value_or(0.0) > 0.0
                                    ? tr("Then the tool moves %1 in a straight line to that "
                                         "point.")
                                    : tr("The tool first moves %1 in a straight line to that "
                                         "point."))
                                   .arg(lengthText(*m_place->approachMm));
  }
  if (m_place->changedFrom) {
    text += QLatin1Char(' ') +
            tr("From point %1 on, the program differs from that of the interrupted run. None of "
               "these points has been executed: check the new path before you go on.")
                .arg(countText(*m_place->changedFrom + 1));
  }
  return text;
}

}  // namespace rivulet::widgets
