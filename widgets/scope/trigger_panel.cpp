// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/trigger_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <algorithm>

#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/plots/time_window.h"

namespace rivulet::widgets {

using trace::Trigger;
using trace::TriggerEvent;
using trace::TriggerKind;

namespace {

/// The entries of the list of conditions.
struct Choice {
  TriggerKind kind;
  TriggerEvent event = TriggerEvent::PauseBegins;
};
constexpr std::array<Choice, 8> kChoices{{{TriggerKind::Rising},
                                          {TriggerKind::Falling},
                                          {TriggerKind::Above},
                                          {TriggerKind::Below},
                                          {TriggerKind::Inside},
                                          {TriggerKind::Outside},
                                          {TriggerKind::Event, TriggerEvent::PauseBegins},
                                          {TriggerKind::Event, TriggerEvent::Alarm}}};
constexpr double kValueMax = 1e6;
constexpr double kTimeMaxS = 3600.0;
constexpr double kBeforeS = 2.0;
constexpr double kAfterS = 3.0;

}  // namespace

TriggerPanel::TriggerPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                           QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_level(say(new NumberField(this),
                  {.tip = QT_TR_NOOP("Value at which the trigger fires"), .id = "triggerLevel"})),
      m_low(say(new NumberField(this),
                {.tip = QT_TR_NOOP("Lower end of the range"), .id = "triggerLow"})),
      m_high(say(new NumberField(this),
                 {.tip = QT_TR_NOOP("Upper end of the range"), .id = "triggerHigh"})),
      m_hysteresis(number(
          {.min = 0.0, .max = kValueMax},
          {.tip = QT_TR_NOOP("The signal must go back this far before the trigger can fire again"),
           .id = "triggerHysteresis"})),
      m_before(
          say(new NumberField(this),
              {.tip = QT_TR_NOOP("How much is shown before the trigger"), .id = "triggerBefore"})),
      m_after(say(new NumberField(this), {.tip = QT_TR_NOOP("How much is shown after the trigger"),
                                          .id = "triggerAfter"})) {
  m_arm->setCheckable(true);
  for (NumberField* field : {m_level, m_low, m_high}) {
    field->setDecimals(3);
    field->setRange(-kValueMax, kValueMax);
  }
  for (NumberField* field : {m_before, m_after}) {
    field->setDecimals(3);
    field->setRange(0.0, kTimeMaxS);
    field->setSuffix(QChar(0x00A0) + QStringLiteral("s"));
  }
  for (QComboBox* list : {m_signal, m_condition, m_mode}) {
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(8);
  }
  m_before->setValue(kBeforeS);
  m_after->setValue(kAfterS);
  const std::array<QWidget*, kRows> fields{m_signal,     m_condition, m_level, m_low, m_high,
                                           m_hysteresis, m_before,    m_after, m_mode};
  constexpr std::array<const char*, kRows> kNames{
      QT_TR_NOOP("Signal"), QT_TR_NOOP("When"),  QT_TR_NOOP("Level"),
      QT_TR_NOOP("From"),   QT_TR_NOOP("To"),    QT_TR_NOOP("Hysteresis"),
      QT_TR_NOOP("Before"), QT_TR_NOOP("After"), QT_TR_NOOP("Fires")};
  auto* rows = new QGridLayout;
  rows->setColumnStretch(1, 1);
  for (int row = 0; row < kRows; ++row) {
    const auto index = static_cast<std::size_t>(row);
    m_names[index] = label({.text = kNames[index]}, fields[index]);
    say(fields[index], {.name = kNames[index], .isTouch = true});
    rows->addWidget(m_names[index], row, 0);
    rows->addWidget(fields[index], row, 1);
  }
  inColumn({rows, m_arm, m_state, spring(1)}, this, QMargins(4, 6, 4, 4));
  onEdit({m_condition, m_signal}, &TriggerPanel::showFields);
  connect(m_arm, &QPushButton::clicked, this, &TriggerPanel::arm);
  onLanguage(&TriggerPanel::listSignals, &TriggerPanel::showFields, &TriggerPanel::showState);
}

/// Those of the live view, whatever is shown: a trigger may be armed before a run.
void TriggerPanel::listSignals() {
  const QString chosen = formula();
  const QSignalBlocker quiet(m_signal);
  m_signal->clear();
  for (const trace::SignalOffer& offer : ScopeCurves::liveOffers()) {
    m_signal->addItem(signalTitle(offer), QString::fromStdString(offer.formula));
    m_signal->setItemData(m_signal->count() - 1, QString::fromStdString(offer.unit),
                          Qt::UserRole + 1);
  }
  m_signal->setCurrentIndex(std::max(0, m_signal->findData(chosen)));
  showFields();
}

QString TriggerPanel::formula() const {
  return m_signal->currentData().toString();
}

void TriggerPanel::showFields() {
  const TriggerKind kind = kChoices[static_cast<std::size_t>(m_condition->currentIndex())].kind;
  const bool isEvent = kind == TriggerKind::Event;
  const bool isWindow = kind == TriggerKind::Inside || kind == TriggerKind::Outside;
  const auto setShown = [this](Row row, QWidget* field, bool isShown) {
    m_names[row]->setVisible(isShown);
    field->setVisible(isShown);
  };
  setShown(Signal, m_signal, !isEvent);
  setShown(Level, m_level, !isEvent && !isWindow);
  setShown(Low, m_low, isWindow);
  setShown(High, m_high, isWindow);
  setShown(Hysteresis, m_hysteresis, !isEvent);
  const QString unit = m_signal->currentData(Qt::UserRole + 1).toString();
  for (NumberField* field : {m_level, m_low, m_high, m_hysteresis}) {
    field->setSuffix(unit.isEmpty() ? QString() : QChar(0x00A0) + unit);
  }
}

trace::TriggerSettings TriggerPanel::settings() const {
  const Choice& choice = kChoices[static_cast<std::size_t>(m_condition->currentIndex())];
  trace::TriggerSettings settings;
  settings.condition.kind = choice.kind;
  settings.condition.event = choice.event;
  settings.condition.level = m_level->value();
  settings.condition.low = std::min(m_low->value(), m_high->value());
  settings.condition.high = std::max(m_low->value(), m_high->value());
  settings.condition.hysteresis = m_hysteresis->value();
  settings.before = base::fromSeconds(m_before->value());
  settings.after = base::fromSeconds(m_after->value());
  settings.isRepeated = m_mode->currentIndex() == 1;
  return settings;
}

void TriggerPanel::arm(bool wanted) {
  m_trigger.reset();
  m_firedAtS.reset();
  if (wanted) {
    m_trigger.emplace(settings());
    m_formula = formula();
    if (m_curves->isLive()) {
      m_window->goLive();
    }
  }
  showState();
}

void TriggerPanel::restart() {
  if (m_trigger) {
    m_trigger.emplace(m_trigger->settings());
  }
  m_firedAtS.reset();
  showState();
}

void TriggerPanel::sample(const QString& formula, double atS, double value) {
  if (!m_trigger) {
    return;
  }
  const auto before = m_trigger->state();
  takeShot(formula == m_formula ? m_trigger->sample(instantOf(atS), value)
                                : m_trigger->advance(instantOf(atS)));
  if (m_trigger && m_trigger->state() != before) {
    showState();
  }
}

void TriggerPanel::happened(TriggerEvent event, double atS, double nowS) {
  if (m_trigger) {
    takeShot(m_trigger->happened(event, instantOf(atS), instantOf(nowS)));
    showState();
  }
}

void TriggerPanel::finish() {
  if (m_trigger) {
    takeShot(m_trigger->finish());
    showState();
  }
}

void TriggerPanel::takeShot(const std::optional<trace::TriggerShot>& shot) {
  if (!shot) {
    return;
  }
  const auto secondsOf = [](base::Instant at) { return base::toSeconds(at.time_since_epoch()); };
  m_firedAtS = secondsOf(shot->at);
  m_window->showRange(secondsOf(shot->from), secondsOf(shot->to));
  m_cursors->set(ScopeCursors::A, *m_firedAtS);
  if (m_trigger->state() == Trigger::State::Done) {
    m_trigger.reset();
  }
  showState();
}

void TriggerPanel::showState() {
  const QString at = m_firedAtS ? secondsText(*m_firedAtS, 3) : QString();
  m_arm->setChecked(isArmed());
  m_arm->setText(isArmed() ? tr("Disarm") : tr("Arm"));
  if (!m_trigger) {
    m_state->setStatus(
        m_firedAtS ? Status::Good : Status::Unknown,
        m_firedAtS ? tr("Triggered at %1. Cursor A is there.").arg(at) : tr("Not armed"));
  } else if (m_trigger->state() == Trigger::State::Filling) {
    m_state->setStatus(Status::Busy, tr("Triggered: waiting for the time after it"));
  } else if (m_firedAtS) {
    m_state->setStatus(Status::Busy, tr("Triggered at %1. Waiting for the next").arg(at));
  } else {
    m_state->setStatus(Status::Busy, m_curves->isLive() ? tr("Waiting for the trigger")
                                                        : tr("Waiting for the next run"));
  }
}

}  // namespace rivulet::widgets
