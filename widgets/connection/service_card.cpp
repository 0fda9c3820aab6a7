// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/service_card.h"

#include <QCoreApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <utility>

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
    for (const auto& [run, status] : {std::pair(streaming::RunState::Armed, Status::Busy),
                                      {streaming::RunState::Running, Status::Busy},
                                      {streaming::RunState::Holding, Status::Attention},
                                      {streaming::RunState::Stopping, Status::Busy}}) {
      if (view.isIn(run)) {
        return {status, runStateText(run)};
      }
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

bool ServiceView::isIn(streaming::RunState run) const {
  return state.toStdString() == streaming::runStateName(run);
}

QString servicePointsText(const ServiceView& view) {
  return ServiceTexts::points(view);
}

ServiceCard::ServiceCard(QWidget* parent)
    : BoardCard(QStringLiteral("service-"), parent),
      m_endpoint(new ElidedLabel(1, this)),
      m_state(new StatusLabel(this)),
      m_program(new ElidedLabel(1, this)),
      m_progress(new QProgressBar(this)),
      m_points(new QLabel(this)),
      m_waiting(new StatusLabel(this, StatusLabel::Elided{2})),
      m_alarm(new StatusLabel(this, StatusLabel::Elided{2})) {
  setObjectName(QStringLiteral("service-card"));
  m_state->setObjectName(QStringLiteral("service-state"));
  m_state->setEmphasis(name()->font().pointSizeF(), true);
  m_state->setWordWrap(true);
  m_alarm->setObjectName(QStringLiteral("service-alarm"));
  m_waiting->setObjectName(QStringLiteral("service-waiting"));
  m_points->setObjectName(QStringLiteral("service-points"));
  addRows({m_endpoint, m_state, m_program, m_progress, m_points, m_waiting, m_alarm});
  connect(open(), &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_view.endpoint); });
  // Queued: the board loses the card that is clicked.
  connect(
      confirm(), &QPushButton::clicked, this, [this] { Q_EMIT removeRequested(m_view.endpoint); },
      Qt::QueuedConnection);
}

void ServiceCard::mouseReleaseEvent(QMouseEvent* event) {
  QFrame::mouseReleaseEvent(event);
  if (event->button() == Qt::LeftButton && rect().contains(event->pos()) && !isAsking()) {
    Q_EMIT openRequested(m_view.endpoint);
  }
}

void ServiceCard::show(const ServiceView& view) {
  const bool isSame = view.endpoint == m_view.endpoint;
  m_view = view;
  const ServiceStateText state = serviceStateText(view);
  name()->setText(view.title());
  m_endpoint->setText(tr("Service at %1").arg(view.endpoint));
  m_state->setStatus(state.status, state.text);
  const bool hasProgram = view.isKnown() && !view.program.isEmpty();
  m_program->setText(view.program);
  m_program->setVisible(hasProgram);
  showProgress(*m_progress, view.progress);
  m_progress->setVisible(hasProgram);
  m_points->setText(servicePointsText(view));
  m_points->setVisible(hasProgram);
  m_waiting->setStatus(Status::Attention, waitingText(view.waitingFor));
  m_waiting->setVisible(view.isKnown() && !view.waitingFor.isEmpty());
  const QString alarm = view.isKnown() ? view.alarm : view.problem;
  m_alarm->setStatus(view.isKnown() ? Status::Fault : Status::Plain, alarm);
  m_alarm->setVisible(!alarm.isEmpty());
  open()->setText(tr("Open"));
  open()->setAccessibleName(open()->text() + QLatin1Char(' ') + name()->text());
  open()->setToolTip(tr("Shows what the service says, and what can be done with it."));
  setRemoval(isSame, view.canRemove,
             tr("Remove this service from the board? It goes on with its work."));
  setAccessibleName(name()->text() + QStringLiteral(": ") + state.text);
}

}  // namespace rivulet::widgets
