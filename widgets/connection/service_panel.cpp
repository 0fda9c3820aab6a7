// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/service_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/elided_label.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/icons.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/connection/board_card.h"
#include "widgets/connection/trust_sheet.h"
#include "widgets/streaming/run_panel.h"

namespace rivulet::widgets {

namespace {

constexpr int kServiceButtonHeightPx = 64;
constexpr int kServiceButtonWidthPxMin = 130;

}  // namespace

ServicePanel::ServicePanel(QWidget* parent)
    : Page(parent),
      m_title(new ElidedLabel(1, this)),
      m_where(say(new ElidedLabel(1, this), {.isMuted = true})),
      m_work(new QWidget(this)),
      m_progress(say(new QProgressBar(m_work), {.name = QT_TR_NOOP("Progress")})),
      m_start(say(new HoldButton(m_work), {.icon = "play", .id = "panel-start"})) {
  setObjectName(QStringLiteral("service"));
  QFont font = m_title->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.3);
  m_title->setFont(font);
  m_state->setEmphasis(14.0, true);
  for (StatusLabel* label : {m_alarm, m_waiting, m_reply, m_login.who}) {
    label->setWordWrap(true);
  }
  auto* names = inColumn({m_title, m_where});
  names->setSpacing(0);
  buildFacts();
  buildLogin();
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(12);  // wide enough apart that one is not hit for the other
  buttons->addWidget(m_stop);
  buttons->addWidget(m_hold);
  buttons->addStretch();
  buttons->addWidget(m_resume);
  buttons->addWidget(m_start);
  for (QPushButton* button : {m_stop, m_hold, m_resume, static_cast<QPushButton*>(m_start)}) {
    QFont large = button->font();
    large.setPointSizeF(14.0);
    large.setBold(true);
    button->setFont(large);
    button->setFixedHeight(kServiceButtonHeightPx);
    button->setMinimumWidth(kServiceButtonWidthPxMin);
    button->setIconSize(QSize(24, 24));
  }
  auto* work = qobject_cast<QVBoxLayout*>(m_work->layout());
  work->addWidget(m_preflightTitle);
  work->addWidget(m_preflight);
  work->addWidget(m_reply);
  work->addWidget(m_whose);
  work->addLayout(buttons);
  inColumn({inRow({m_back, {names, 1}}), m_state, m_alarm, m_work, spring(1)}, this);

  // As the rows stand.
  const std::initializer_list<QWidget*> order{
      m_back,        m_files, m_load, m_login.open, m_login.user, m_login.pin,
      m_login.enter, m_stop,  m_hold, m_resume,     m_start};
  for (const auto* at = order.begin(); at + 1 != order.end(); ++at) {
    setTabOrder(*at, *(at + 1));
  }

  connect(m_stop, &QPushButton::clicked, this,
          [this] { Q_EMIT callRequested(QStringLiteral("Stop"), {}); });
  connect(m_hold, &QPushButton::clicked, this, [this] {
    call(m_view.isIn(streaming::RunState::Running) ? QStringLiteral("Hold")
                                                   : QStringLiteral("Resume"));
  });
  connect(m_resume, &QPushButton::clicked, this, [this] {
    drop();
    call(QStringLiteral("PreflightResume"));
  });
  connect(m_start, &HoldButton::clicked, this, [this] {
    if (m_offered.offer == Offer::None && m_replied.asked.isEmpty()) {
      call(QStringLiteral("Preflight"));
    }
  });
  connect(m_start, &HoldButton::held, this, &ServicePanel::begin);
  connect(m_load, &QPushButton::clicked, this, [this] {
    drop();
    call(QStringLiteral("LoadJob"), {m_file->text().trimmed(), QString()});
  });
  connect(m_file, &QLineEdit::textChanged, this, &ServicePanel::showButtons);
  connect(m_file, &QLineEdit::returnPressed, m_load, &QPushButton::click);
  onLanguage(&ServicePanel::showAll);
  onTheme(&ServicePanel::showButtons);
}

void ServicePanel::buildFacts() {
  auto* work = new QVBoxLayout(m_work);
  work->setContentsMargins(0, 0, 0, 0);
  for (QWidget* row : std::initializer_list<QWidget*>{m_program, m_progress, m_points, m_waiting,
                                                      m_position, m_message}) {
    work->addWidget(row);
  }
  m_files->setEditable(true);
  m_files->setInsertPolicy(QComboBox::NoInsert);
  m_files->setLineEdit(m_file);
  m_files->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  work->addLayout(inRow({label({.text = QT_TR_NOOP("&Program")}, m_files), {m_files, 1}, m_load}));
}

void ServicePanel::buildLogin() {
  m_login.open->setCheckable(true);
  m_login.pin->setEchoMode(QLineEdit::Password);
  m_login.userLabel->setBuddy(m_login.user);
  m_login.pinLabel->setBuddy(m_login.pin);
  auto* fields = new QHBoxLayout(m_login.fields);
  fields->setContentsMargins(0, 0, 0, 0);
  for (const auto& [label, field] :
       {std::pair(m_login.userLabel, m_login.user), {m_login.pinLabel, m_login.pin}}) {
    field->setMinimumHeight(kTouchHeightPx);
    fields->addWidget(label);
    fields->addWidget(field, 1);
  }
  fields->addWidget(m_login.enter);
  m_login.fields->hide();
  auto* work = qobject_cast<QVBoxLayout*>(m_work->layout());
  work->addLayout(inRow({{m_login.who, 1}, m_login.open}));
  work->addWidget(m_login.fields);
  connect(m_login.open, &QPushButton::toggled, this, [this](bool isOpen) {
    m_login.fields->setVisible(isOpen);
    if (isOpen) {
      (m_login.user->text().isEmpty() ? m_login.user : m_login.pin)->setFocus();
    }
  });
  connect(m_login.pin, &QLineEdit::returnPressed, this, &ServicePanel::logIn);
}

void ServicePanel::logIn() {
  const QString user = m_login.user->text().trimmed();
  const QString pin = m_login.pin->text();
  m_login.pin->clear();
  m_login.open->setChecked(false);
  drop();
  m_replied.asked.clear();
  Q_EMIT loginRequested(user, user.isEmpty() ? QString() : pin);
}

void ServicePanel::call(const QString& method, const QStringList& inputs) {
  m_replied.asked = method;
  m_replied.answer.clear();
  showAll();
  Q_EMIT callRequested(method, inputs);
}

void ServicePanel::begin() {
  if (m_offered.offer == Offer::None) {
    return;
  }
  const QString method =
      m_offered.offer == Offer::Start ? QStringLiteral("Start") : QStringLiteral("ResumeRun");
  const QString confirmation = m_offered.confirmation;
  drop();
  call(method, {confirmation});
}

/// What was shown is not true any more.
void ServicePanel::drop() {
  m_offered = {};
}

void ServicePanel::setAnswer(const QString& method, bool accepted, const QString& message,
                             const QString& confirmation) {
  if (method == m_replied.asked) {
    m_replied.asked.clear();
  }
  m_replied.isRefused = !accepted;
  m_replied.answer = message;
  if (accepted && !confirmation.isEmpty()) {
    m_offered.offer = method == QLatin1String("PreflightResume") ? Offer::Resume : Offer::Start;
    m_offered.confirmation = confirmation;
    m_offered.text = message;
    m_replied.answer.clear();
  }
  showAll();
}

void ServicePanel::setService(const ServiceView& view) {
  const bool isOther = view.endpoint != m_view.endpoint;
  if (isOther || !view.isKnown() || view.isRunning || view.user != m_view.user) {
    drop();
  }
  if (isOther) {
    m_replied.asked.clear();
    m_replied.answer.clear();
    m_login.user->clear();
    m_file->clear();
  }
  if (isOther || view.programs != m_view.programs) {
    showPrograms(view.programs);
  }
  if (isOther || !view.isKnown()) {
    m_login.pin->clear();
  }
  if (!view.isKnown()) {
    m_replied.asked.clear();
  }
  const bool asksElse = view.question != m_view.question || isOther;
  m_view = view;
  if (asksElse) {
    showQuestion();
  }
  showAll();
}

/// What has been typed stays.
void ServicePanel::showPrograms(const QStringList& programs) {
  const QString typed = m_file->text();
  const QSignalBlocker blocker(m_files);
  m_files->clear();
  m_files->addItems(programs);
  m_files->setCurrentIndex(-1);
  m_file->setText(typed);
}

void ServicePanel::showQuestion() {
  delete m_trust;
  m_trust = nullptr;
  if (!m_view.question || !isOnSheet(*m_view.question)) {
    return;
  }
  m_trust = new TrustSheet(this);
  m_trust->setOwnCertificate(m_own);
  m_trust->setBlocked(m_trustBlocked);
  m_trust->setQuestion(m_view.question);
  // Queued: what answers takes the sheet away.
  connect(m_trust, &TrustSheet::certificateAccepted, this, &ServicePanel::certificateAccepted,
          Qt::QueuedConnection);
  connect(m_trust, &TrustSheet::choiceAllowed, this, &ServicePanel::choiceAllowed,
          Qt::QueuedConnection);
  connect(m_trust, &TrustSheet::declined, this, &ServicePanel::declined, Qt::QueuedConnection);
  connect(m_trust, &TrustSheet::exportRequested, this, &ServicePanel::exportRequested);
  auto* rows = qobject_cast<QVBoxLayout*>(layout());
  rows->insertWidget(rows->indexOf(m_work), m_trust);
}

void ServicePanel::setOwnCertificate(const std::optional<opcua::CertificateFacts>& own) {
  m_own = own;
  if (m_trust != nullptr) {
    m_trust->setOwnCertificate(own);
  }
}

void ServicePanel::setTrustBlocked(const QString& reason) {
  m_trustBlocked = reason;
  if (m_trust != nullptr) {
    m_trust->setBlocked(reason);
  }
}

void ServicePanel::showAll() {
  const ServiceStateText state = serviceStateText(m_view);
  m_title->setText(m_view.title());
  m_where->setText(m_view.model.isEmpty()
                       ? tr("Service at %1").arg(m_view.endpoint)
                       : tr("Service at %1, %2").arg(m_view.endpoint, m_view.model));
  m_state->setStatus(state.status, state.text);
  m_whose->setText(
      tr("These buttons act on %1. Those at the bottom of the window act on the machine "
         "that the window is connected with.")
          .arg(m_view.title()));
  const QString alarm = m_view.isKnown() && !m_view.alarm.isEmpty() ? m_view.alarm : m_view.problem;
  m_alarm->setStatus(m_view.isKnown() ? Status::Fault : Status::Plain, alarm);
  m_alarm->setVisible(!alarm.isEmpty());
  m_work->setVisible(m_trust == nullptr);
  showFacts();
  showButtons();
}

void ServicePanel::showFacts() {
  const bool hasProgram = m_view.isKnown() && !m_view.program.isEmpty();
  m_program->setText(m_view.program);
  showProgress(*m_progress, m_view.progress);
  const QString points = servicePointsText(m_view);
  m_points->setText(m_view.lateWindows == 0 ? points
                                            : points + QStringLiteral(", ") +
                                                  tr("%Ln windows late", nullptr,
                                                     static_cast<int>(m_view.lateWindows)));
  for (QWidget* part : std::initializer_list<QWidget*>{m_program, m_progress, m_points}) {
    part->setVisible(hasProgram);
  }
  m_waiting->setStatus(Status::Attention, waitingText(m_view.waitingFor));
  m_waiting->setVisible(m_view.isKnown() && !m_view.waitingFor.isEmpty());
  const std::vector<double>& at = m_view.positionMm;
  constexpr std::size_t kAxes = 3;
  m_position->setVisible(m_view.isKnown() && at.size() == kAxes);
  if (at.size() == kAxes) {
    m_position->setText(QStringLiteral("X %1  Y %2  Z %3")
                            .arg(lengthText(at[0]), lengthText(at[1]), lengthText(at[2])));
  }
  m_message->setText(m_view.message);
  m_message->setVisible(m_view.isKnown() && !m_view.message.isEmpty());
  m_preflight->setText(m_offered.text);
  m_preflightTitle->setText(m_offered.offer == Offer::Resume ? tr("What Resume will do")
                                                             : tr("What Start will do"));
  m_preflightTitle->setVisible(m_offered.offer != Offer::None);
  m_preflight->setVisible(m_offered.offer != Offer::None);
  m_reply->setStatus(
      !m_replied.asked.isEmpty() ? Status::Busy
      : m_replied.isRefused      ? Status::Attention
                                 : Status::Good,
      m_replied.asked.isEmpty() ? m_replied.answer : tr("The service is working on it …"));
  m_reply->setVisible(!m_replied.asked.isEmpty() || !m_replied.answer.isEmpty());
  m_login.who->setStatus(Status::Plain, m_view.user.isEmpty()
                                            ? tr("Nobody is logged in.")
                                            : tr("Logged in: %1").arg(m_view.user));
}

void ServicePanel::showButtons() {
  const bool isFree = m_view.isKnown() && m_replied.asked.isEmpty();
  // A run that was stopped is held; then it goes on to the end of its window, and ends there.
  const bool isStopped = m_view.isIn(streaming::RunState::Stopping);
  const bool isHolding = isStopped || m_view.isIn(streaming::RunState::Holding);
  const bool canHold = isHolding || m_view.isIn(streaming::RunState::Running);
  m_stop->setEnabled(m_view.link == ServiceLink::Silent || (m_view.isKnown() && m_view.isRunning));
  m_hold->setText(isStopped ? tr("End here") : isHolding ? tr("Continue") : tr("Pause"));
  setThemedIcon(*m_hold, isHolding ? QStringLiteral("play") : QStringLiteral("hold"),
                themeColors(palette()).text);
  m_hold->setEnabled(isFree && canHold);
  m_resume->setVisible(m_view.isKnown() && !m_view.leftRun.isEmpty() && !m_view.isRunning &&
                       m_offered.offer != Offer::Resume);
  m_resume->setEnabled(isFree);
  m_start->setNeedsHold(m_offered.offer != Offer::None);
  m_start->setText(m_offered.offer == Offer::Resume  ? tr("Hold to resume")
                   : m_offered.offer == Offer::Start ? tr("Hold to start")
                                                     : tr("Start …"));
  m_start->setToolTip(m_offered.offer != Offer::None
                          ? tr("Hold for one second. Then the machine moves.")
                          : tr("Shows what will happen first. Nothing moves yet."));
  m_start->setEnabled(isFree && !m_view.isRunning && !m_view.program.isEmpty());
  if (m_offered.offer == Offer::Resume) {
    m_start->setEnabled(isFree && !m_view.isRunning);
  }
  m_files->setEnabled(isFree && !m_view.isRunning);
  m_load->setEnabled(m_files->isEnabled() && !m_file->text().trimmed().isEmpty());
  m_login.open->setEnabled(m_view.isKnown());
  m_login.open->setText(m_view.user.isEmpty() ? tr("Log in …") : tr("Change user …"));
}

}  // namespace rivulet::widgets
