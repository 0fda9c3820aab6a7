// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/streaming/run_panel.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/streaming/state_strip.h"

namespace rivulet::widgets {

using streaming::RunState;

namespace {

constexpr int kRunButtonHeightPx = 60;
constexpr int kProgressSteps = 1000;

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : Page(parent),
      m_strip(new StateStrip(this)),
      m_start(makeTouchButton(this)),
      m_stop(makeTouchButton(this)),
      m_hold(makeTouchButton(this)),
      m_resume(makeTouchButton(this)),
      m_startReason(new StatusLabel(this)),
      m_stopStatus(new StatusLabel(this)),
      m_progressGroup(new QGroupBox(this)),
      m_progress(new QProgressBar(this)),
      m_marginName(new QLabel(this)),
      m_margin(new StatusLabel(this)),
      m_waitingName(new QLabel(this)),
      m_waiting(new QLabel(this)) {
  QFont buttonFont = font();
  buttonFont.setPointSizeF(14.0);
  buttonFont.setBold(true);
  for (QPushButton* button : {m_start, m_stop, m_hold, m_resume}) {
    button->setMinimumHeight(kRunButtonHeightPx);
    button->setIconSize(QSize(24, 24));
    button->setFont(buttonFont);
  }
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(24);  // wide enough apart that one is not hit for the other
  buttons->addWidget(m_start, 1);
  buttons->addWidget(m_hold, 1);
  buttons->addWidget(m_resume, 1);
  buttons->addWidget(m_stop, 1);
  m_startReason->setWordWrap(true);
  m_stopStatus->setWordWrap(true);

  buildProgress();

  auto* commands = new QHBoxLayout;
  commands->setSpacing(24);
  commands->addWidget(m_strip, 2);
  commands->addLayout(buttons, 3);
  // The buttons stay in place, whatever is shown below them: a finger that reaches for Stop must
  // not find that the row has moved.
  for (StatusLabel* label : {m_startReason, m_stopStatus}) {
    QSizePolicy policy = label->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    label->setSizePolicy(policy);
  }
  auto* states = new QHBoxLayout;
  states->addWidget(m_startReason, 1);
  states->addWidget(m_stopStatus, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addLayout(commands);
  layout->addLayout(states);
  layout->addWidget(m_progressGroup);

  connect(m_start, &QPushButton::clicked, this, &RunPanel::startRequested);
  connect(m_hold, &QPushButton::clicked, this,
          [this] { Q_EMIT holdRequested(m_update.state != RunState::Holding); });
  connect(m_resume, &QPushButton::clicked, this, &RunPanel::resumeRequested);
  connect(m_stop, &QPushButton::clicked, this, [this] {
    if (m_stopState == StopState::None) {
      m_stopState = StopState::Requested;
      showAll();
    }
    Q_EMIT stopRequested();  // again and again if the operator wants: it does no harm
  });
  retranslate();
  restyle();
}

void RunPanel::buildProgress() {
  m_progress->setRange(0, kProgressSteps);
  m_progress->setMinimumHeight(24);
  m_progress->setAlignment(Qt::AlignCenter);
  // One row of figures under the bar: the panel is at the bottom of the window and leaves the
  // height to the pages.
  auto* progress = new QGridLayout(m_progressGroup);
  progress->setHorizontalSpacing(10);
  QFont counterFont = font();
  counterFont.setPointSizeF(12.0);
  counterFont.setBold(true);
  int column = 0;
  const auto addFigure = [&](QLabel* name, QWidget* value, int stretch) {
    progress->addWidget(name, 1, column++, Qt::AlignRight | Qt::AlignVCenter);
    progress->setColumnStretch(column, stretch);
    progress->addWidget(value, 1, column++, Qt::AlignLeft | Qt::AlignVCenter);
  };
  for (std::size_t counter = 0; counter < m_counterNames.size(); ++counter) {
    m_counterNames[counter] = new QLabel(this);
    m_counterValues[counter] = makeValueLabel(this);
    m_counterValues[counter]->setFont(counterFont);
    addFigure(m_counterNames[counter], m_counterValues[counter], 1);
  }
  addFigure(m_marginName, m_margin, 1);
  addFigure(m_waitingName, m_waiting, 2);
  progress->addWidget(m_progress, 0, 0, 1, column);
}

void RunPanel::setUpdate(const streaming::LiveUpdate& update) {
  const bool starts = update.state == RunState::Armed || update.state == RunState::Running;
  const bool wasActive = isActive();
  const std::size_t total = m_update.counters.total;
  m_update = update;
  if (m_update.counters.total == 0) {
    m_update.counters.total = total;
  }
  if (starts && !wasActive) {
    m_stopState = StopState::None;
  }
  if (update.state == RunState::Stopping && m_stopState == StopState::None) {
    m_stopState = StopState::Requested;
  }
  if (update.stopConfirmedAfter) {
    m_stopState = StopState::Confirmed;
  }
  showAll();
}

void RunPanel::setTotal(std::size_t points) {
  m_update.counters.total = points;
  showAll();
}

void RunPanel::setStartBlocked(const QString& reason) {
  m_startBlocked = reason;
  showAll();
}

void RunPanel::setCanHold(bool canHold) {
  m_canHold = canHold;
  showAll();
}

void RunPanel::setResumeBlocked(const QString& reason) {
  m_resumeBlocked = reason;
  showAll();
}

void RunPanel::setStopUnconfirmed() {
  m_stopState = StopState::Unconfirmed;
  showAll();
}

void RunPanel::retranslate() {
  m_start->setText(tr("Start"));
  m_stop->setText(tr("Stop"));
  m_resume->setText(tr("Resume …"));
  m_stop->setToolTip(
      tr("Ends the run at the end of the loop. It does not replace the machine's emergency stop."));
  m_progressGroup->setTitle(tr("Progress"));
  m_counterNames[0]->setText(tr("Sent"));
  m_counterNames[1]->setText(tr("Accepted"));
  m_counterNames[2]->setText(tr("Executed"));
  m_marginName->setText(tr("Margin"));
  m_marginName->setToolTip(tr(
      "Time until the control needs the next point, minus the 99th percentile of the access time"));
  m_waitingName->setText(tr("Waiting for"));
  showAll();
}

void RunPanel::restyle() {
  // Both buttons stay neutral: shape and text distinguish them.
  const QColor color = themeColors(palette()).text;
  m_start->setIcon(themedIcon(QStringLiteral("play"), color));
  m_stop->setIcon(themedIcon(QStringLiteral("stop"), color));
  m_resume->setIcon(themedIcon(QStringLiteral("resume"), color));
  showHoldIcon();
  for (QLabel* label : m_counterNames) {
    setMuted(label, palette());
  }
  setMuted(m_marginName, palette());
  setMuted(m_waitingName, palette());
}

bool RunPanel::isActive() const {
  return m_update.state == RunState::Armed || m_update.state == RunState::Running ||
         m_update.state == RunState::Holding || m_update.state == RunState::Stopping;
}

QString RunPanel::waitingText() const {
  // The stream names its reasons by key; one without a sentence here is shown unchanged.
  const QString key = QString::fromStdString(m_update.waitingFor);
  if (key.isEmpty() && m_update.state == RunState::Holding) {
    return tr("Continue; the machine is waiting before the next window");
  }
  if (key == QStringLiteral("proof")) {
    return tr("test of the template on the virtual machine");
  }
  if (key.isEmpty()) {
    return noValue();
  }
  if (key == QStringLiteral("transfer")) {
    return tr("transfer of the template to the control");
  }
  if (key == QStringLiteral("cycle-start")) {
    return tr("cycle start at the control");
  }
  if (key == QStringLiteral("select-and-start")) {
    return tr("selection of the template and cycle start at the control");
  }
  if (key == QStringLiteral("trace")) {
    return tr("the control's own trace");
  }
  return key;
}

void RunPanel::showHoldIcon() {
  m_hold->setIcon(themedIcon(
      m_update.state == RunState::Holding ? QStringLiteral("play") : QStringLiteral("hold"),
      themeColors(palette()).text));
}

void RunPanel::showAll() {
  const bool active = isActive();
  m_strip->setState(m_update.state);
  const bool blocked = !m_startBlocked.isEmpty();
  m_start->setEnabled(!active && !blocked);
  m_stop->setEnabled(active);
  // One place for both, so that a hand finds it: Hold during a run, Continue during a hold.
  const bool isHolding = m_update.state == RunState::Holding;
  m_hold->setText(isHolding ? tr("Continue") : tr("Hold"));
  showHoldIcon();
  m_hold->setEnabled(m_canHold && (isHolding || m_update.state == RunState::Running));
  m_hold->setToolTip(m_canHold
                         ? tr("The machine waits before the next window until you press Continue.")
                         : tr("Only method window can hold."));
  m_resume->setEnabled(!active && m_resumeBlocked.isEmpty());
  m_resume->setToolTip(m_resumeBlocked.isEmpty()
                           ? tr("Asks the control where the run was left. Nothing moves yet.")
                           : m_resumeBlocked);
  m_startReason->setVisible(!active);
  m_startReason->setStatus(
      blocked ? Status::Attention : Status::Good,
      blocked ? tr("Start is not possible: %1").arg(m_startBlocked) : tr("Ready to start"));

  m_stopStatus->setVisible(m_stopState != StopState::None);
  switch (m_stopState) {
    case StopState::None:
      break;
    case StopState::Requested:
      m_stopStatus->setStatus(Status::Busy, tr("Stop requested, not yet confirmed"));
      break;
    case StopState::Confirmed:
      m_stopStatus->setStatus(
          Status::Good,
          m_update.stopConfirmedAfter
              ? tr("Stop confirmed after %1")
                    .arg(secondsText(base::toSeconds(*m_update.stopConfirmedAfter), 2))
              : tr("Stop confirmed"));
      break;
    case StopState::Unconfirmed:
      m_stopStatus->setStatus(Status::Fault, tr("Stop NOT confirmed: check the machine"));
      break;
  }

  const streaming::Counters& counters = m_update.counters;
  const QString total = countText(counters.total);
  const std::array<std::size_t, 3> values{counters.sent, counters.accepted, counters.executed};
  for (std::size_t counter = 0; counter < values.size(); ++counter) {
    m_counterValues[counter]->setText(tr("%1 of %2").arg(countText(values[counter]), total));
  }
  const double done = counters.total == 0 ? 0.0
                                          : static_cast<double>(counters.executed) /
                                                static_cast<double>(counters.total);
  m_progress->setValue(static_cast<int>(done * kProgressSteps));
  m_progress->setFormat(QStringLiteral("%1 %").arg(numberText(done * 100.0, 1)));
  if (m_update.margin && active && m_update.state != RunState::Holding) {
    const bool late = m_update.margin->count() < 0;
    m_margin->setStatus(late ? Status::Attention : Status::Good,
                        millisecondsText(*m_update.margin) +
                            (late ? QStringLiteral(" ") + tr("(too late)") : QString()));
  } else {
    m_margin->setStatus(Status::Plain, noValue());
  }
  m_waiting->setText(active ? waitingText() : noValue());
}

}  // namespace rivulet::widgets
