// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/service_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/page.h"
#include "widgets/streaming/run_panel.h"

namespace rivulet::widgets {

namespace {

struct ServiceTexts {
  Q_DECLARE_TR_FUNCTIONS(ServiceTexts)

 public:
  static ServiceStateText state(const ServiceView& view) {
    switch (view.link) {
      case ServiceLink::Connecting:
        return {Status::Busy, tr("Connecting …")};
      case ServiceLink::Silent:
        return {Status::Attention, tr("No answer for some seconds")};
      case ServiceLink::Gone:
        return {Status::Fault, tr("Service does not answer")};
      case ServiceLink::Asked:
        return {Status::Attention, tr("Not connected: needs a decision")};
      case ServiceLink::Connected:
        break;
    }
    const auto run = [](Status status, streaming::RunState state) {
      return ServiceStateText{status, runStateText(state)};
    };
    if (view.state == QLatin1String("disconnected")) {
      return {Status::Fault, tr("Machine does not answer")};
    }
    if (view.state == QLatin1String("connecting")) {
      return {Status::Busy, tr("Connecting to the machine …")};
    }
    if (view.state == QLatin1String("idle")) {
      return {Status::Good, tr("No program")};
    }
    if (view.state == QLatin1String("loaded")) {
      return {Status::Good, tr("Program loaded")};
    }
    if (view.state == QLatin1String("left")) {
      return {Status::Attention, tr("Run interrupted")};
    }
    if (view.state == QLatin1String("armed")) {
      return run(Status::Busy, streaming::RunState::Armed);
    }
    if (view.state == QLatin1String("running")) {
      return run(Status::Busy, streaming::RunState::Running);
    }
    if (view.state == QLatin1String("holding")) {
      return run(Status::Attention, streaming::RunState::Holding);
    }
    if (view.state == QLatin1String("stopping")) {
      return run(Status::Busy, streaming::RunState::Stopping);
    }
    return {Status::Unknown, view.state};
  }

  static QString points(const ServiceView& view) {
    const QString points =
        tr("%1 of %2 points").arg(countText(view.pointsDone), countText(view.points));
    return view.timeLeftS < 0.0 ? points
                                : tr("%1, %2 left").arg(points, durationText(view.timeLeftS));
  }
};

}  // namespace

ServiceStateText serviceStateText(const ServiceView& view) {
  return ServiceTexts::state(view);
}

QString servicePointsText(const ServiceView& view) {
  return ServiceTexts::points(view);
}

void showServiceProgress(QProgressBar& bar, const ServiceView& view) {
  constexpr int kSteps = 1000;
  bar.setRange(0, kSteps);
  bar.setValue(static_cast<int>(kSteps * view.progress));
  bar.setFormat(QStringLiteral("%1\u00A0%").arg(numberText(100.0 * view.progress, 1)));
}

ServiceCard::ServiceCard(QWidget* parent)
    : QFrame(parent),
      m_name(new ElidedLabel(1, this)),
      m_endpoint(new ElidedLabel(1, this)),
      m_state(new StatusLabel(this)),
      m_program(new ElidedLabel(1, this)),
      m_progress(new QProgressBar(this)),
      m_points(new QLabel(this)),
      m_waiting(new StatusLabel(this, StatusLabel::Elided{2})),
      m_alarm(new StatusLabel(this, StatusLabel::Elided{2})),
      m_question(new QLabel(this)),
      m_open(makeTouchButton(this)),
      m_remove(makeTouchButton(this)),
      m_keep(makeTouchButton(this)),
      m_confirm(makeTouchButton(this)) {
  setObjectName(QStringLiteral("service-card"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  QFont font = m_name->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.3);
  m_name->setFont(font);
  m_state->setObjectName(QStringLiteral("service-state"));
  m_state->setEmphasis(font.pointSizeF(), true);
  m_state->setWordWrap(true);
  m_alarm->setObjectName(QStringLiteral("service-alarm"));
  m_waiting->setObjectName(QStringLiteral("service-waiting"));
  m_points->setObjectName(QStringLiteral("service-points"));
  m_question->setWordWrap(true);
  m_open->setObjectName(QStringLiteral("service-open"));
  m_remove->setObjectName(QStringLiteral("service-remove"));
  m_keep->setObjectName(QStringLiteral("service-keep"));
  m_confirm->setObjectName(QStringLiteral("service-confirm-remove"));
  auto* layout = new QVBoxLayout(this);
  for (QWidget* row :
       std::initializer_list<QWidget*>{m_name, m_endpoint, m_state, m_program, m_progress, m_points,
                                       m_waiting, m_alarm, m_question}) {
    layout->addWidget(row);
  }
  layout->addStretch();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_open, 1);
  buttons->addWidget(m_remove);
  buttons->addWidget(m_keep, 1);
  buttons->addWidget(m_confirm);
  layout->addLayout(buttons);
  connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_view.endpoint); });
  connect(m_remove, &QPushButton::clicked, this, [this] { ask(true); });
  connect(m_keep, &QPushButton::clicked, this, [this] { ask(false); });
  // Queued: the board loses the card that is clicked.
  connect(
      m_confirm, &QPushButton::clicked, this, [this] { Q_EMIT removeRequested(m_view.endpoint); },
      Qt::QueuedConnection);
}

void ServiceCard::mouseReleaseEvent(QMouseEvent* event) {
  QFrame::mouseReleaseEvent(event);
  if (event->button() == Qt::LeftButton && rect().contains(event->pos()) && !m_isAsking) {
    Q_EMIT openRequested(m_view.endpoint);
  }
}

void ServiceCard::show(const ServiceView& view) {
  m_isAsking = m_isAsking && view.endpoint == m_view.endpoint && view.canRemove;
  m_view = view;
  const ServiceStateText state = serviceStateText(view);
  m_name->setText(view.title());
  m_endpoint->setText(tr("Service at %1").arg(view.endpoint));
  m_state->setStatus(state.status, state.text);
  const bool hasProgram = view.isKnown() && !view.program.isEmpty();
  m_program->setText(view.program);
  m_program->setVisible(hasProgram);
  showServiceProgress(*m_progress, view);
  m_progress->setVisible(hasProgram);
  m_points->setText(servicePointsText(view));
  m_points->setVisible(hasProgram);
  m_waiting->setStatus(Status::Attention, waitingText(view.waitingFor));
  m_waiting->setVisible(view.isKnown() && !view.waitingFor.isEmpty());
  const QString alarm = view.isKnown() ? view.alarm : view.problem;
  m_alarm->setStatus(view.isKnown() ? Status::Fault : Status::Plain, alarm);
  m_alarm->setVisible(!alarm.isEmpty());
  m_open->setText(tr("Open"));
  m_remove->setText(tr("Remove …"));
  m_keep->setText(tr("Keep it"));
  m_confirm->setText(tr("Remove"));
  m_question->setText(tr("Remove this service from the board? It goes on with its work."));
  for (QPushButton* button : {m_open, m_remove}) {
    button->setAccessibleName(button->text() + QLatin1Char(' ') + m_name->text());
  }
  m_open->setToolTip(tr("Shows what the service says, and what can be done with it."));
  setAccessibleName(m_name->text() + QStringLiteral(": ") + state.text);
  showQuestion();
}

void ServiceCard::ask(bool isAsking) {
  m_isAsking = isAsking;
  showQuestion();
  (isAsking ? m_keep : m_remove)->setFocus();
}

void ServiceCard::showQuestion() {
  m_question->setVisible(m_isAsking);
  m_confirm->setVisible(m_isAsking);
  m_keep->setVisible(m_isAsking);
  m_open->setVisible(!m_isAsking);
  m_remove->setVisible(!m_isAsking && m_view.canRemove);
}

}  // namespace rivulet::widgets
