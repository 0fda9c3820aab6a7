// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/trust_sheet.h"

#include <QButtonGroup>
#include <QFontDatabase>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include "widgets/common/hold_button.h"
#include "widgets/common/theme.h"
#include "widgets/connection/certificate_text.h"
#include "widgets/connection/connection_state.h"

namespace rivulet::widgets {

using opcua::TrustQuestion;
using Kind = opcua::TrustQuestion::Kind;

bool isOnSheet(const TrustQuestion& question) {
  return question.kind != Kind::Login;
}

TrustSheet::TrustSheet(QWidget* parent)
    : Page(parent),
      m_accept(say(
          new HoldButton(this),
          {.tip = QT_TR_NOOP("Hold it for one second, with the mouse, a finger or the space bar."),
           .icon = "link",
           .id = "trust-accept",
           .isTouch = true})),
      m_rows(new QGridLayout),
      m_choices(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("trust-sheet"));
  QFont font = m_title->font();
  font.setPointSizeF(16.0);
  m_title->setFont(font);
  m_meaning->setEmphasis(11.0, false);
  m_rows->setHorizontalSpacing(16);
  m_rows->setVerticalSpacing(8);
  m_rows->setColumnStretch(1, 1);
  m_rows->setColumnStretch(2, 1);
  auto* buttons = inRow({m_decline, m_accept, {m_obstacle, 1}, spring()});
  buttons->setSpacing(16);
  auto* layout = inColumn(
      {m_title, m_meaning, buttons, m_rows, m_machineSide, inRow({m_export, spring()}), spring()},
      this, QMargins(16, 8, 16, 8));
  layout->setSpacing(10);
  connect(m_accept, &HoldButton::held, this, &TrustSheet::accept);
  retranslate();
  onTheme([this] { retranslate(); });
}

void TrustSheet::setQuestion(std::shared_ptr<const TrustQuestion> question) {
  if (question == m_question) {
    return;  // a button that is being held must stay there
  }
  m_question = std::move(question);
  m_chosen = 0;
  retranslate();
}

void TrustSheet::setOwnCertificate(const std::optional<opcua::CertificateFacts>& own) {
  if (own != m_own) {
    m_own = own;
    retranslate();
  }
}

void TrustSheet::setBlocked(const QString& reason) {
  if (reason != m_blocked) {
    m_blocked = reason;
    retranslate();
  }
}

void TrustSheet::accept() {
  if (!m_question || !m_accept->isEnabled()) {
    return;
  }
  if (m_question->kind != Kind::Protection) {
    Q_EMIT certificateAccepted();
    return;
  }
  // A copy: the sheet is given another question meanwhile.
  const opcua::SecurityChoice choice = m_question->choices[static_cast<std::size_t>(m_chosen)];
  Q_EMIT choiceAllowed(choice);
}

QString TrustSheet::title() const {
  switch (m_question->kind) {
    case Kind::NewServer:
      return tr("Is this the right machine?");
    case Kind::ChangedServer:
      return tr("The machine shows another certificate");
    case Kind::Protection:
    case Kind::Login:
      break;
  }
  return tr("The machine does not offer sufficient encryption");
}

QString TrustSheet::meaning() const {
  switch (m_question->kind) {
    case Kind::NewServer:
      return tr(
          "This computer has not connected to it before. Compare the fingerprint with the one that "
          "the control shows. If they are equal, accept it: from then on, only this certificate is "
          "trusted at this address.");
    case Kind::ChangedServer:
      return tr(
          "Either somebody has renewed the certificate of the control, or another computer "
          "answers at its address and would get all commands. Ask who looks after the "
          "control. Do not connect if nobody has changed anything.");
    case Kind::Protection:
    case Kind::Login:
      break;
  }
  const QString allow =
      tr("Better: switch encryption on at the control, then connect again. What you allow here is "
         "remembered for this machine until you take it back, and is marked as long as it is "
         "connected.");
  return m_question->wasEncrypted
             ? tr("Until now this machine was connected encrypted. Somebody who stands between "
                  "could hide the encryption.") +
                   QLatin1Char(' ') + allow
             : allow;
}

QString TrustSheet::obstacle() const {
  if (!m_blocked.isEmpty()) {
    return m_blocked;
  }
  if (m_question->kind == Kind::Protection) {
    return m_question->choices.empty()
               ? tr("Nothing that it offers lets this user in with an encrypted password.")
               : QString();
  }
  return m_question->isValidNow
             ? QString()
             : tr("The certificate is not valid today, so it cannot be accepted. Set the clocks of "
                  "both computers, or renew it on the control.");
}

void TrustSheet::clearRows() {
  for (QWidget* widget : m_shown) {
    m_rows->removeWidget(widget);
    widget->hide();
    widget->deleteLater();
  }
  m_shown.clear();
  m_nextRow = 0;
}

void TrustSheet::addRow(const QString& name, Status status, const QString& text,
                        const QString& other, bool isCode) {
  const int row = m_nextRow++;
  auto* label = new QLabel(name, this);
  setMuted(label, palette());
  m_rows->addWidget(label, row, 0, Qt::AlignTop);
  m_shown.push_back(label);
  const auto add = [&](Status shown, const QString& value, int column, int columns) {
    auto* field = new StatusLabel(this);
    if (isCode) {
      field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    }
    field->setWordWrap(true);
    field->setStatus(shown, value);
    m_rows->addWidget(field, row, column, 1, columns, Qt::AlignTop);
    m_shown.push_back(field);
    return field;
  };
  const bool isPair = !other.isNull();
  std::vector<StatusLabel*> fields{add(status, text, 1, isPair ? 1 : 2)};
  if (isPair) {
    fields.push_back(add(Status::Plain, other, 2, 1));
  }
  if (isVisible()) {  // else they are shown with the sheet
    label->show();
    for (StatusLabel* field : fields) {
      field->show();
    }
  }
}

void TrustSheet::showCertificate() {
  const opcua::CertificateFacts& shown = m_question->shown;
  const bool isChange = m_question->kind == Kind::ChangedServer;
  const auto& before = m_question->accepted;
  const auto old = [&](const QString& text) {
    return !isChange ? QString() : before ? text : tr("not kept");
  };
  addRow(tr("Address"), Status::Plain, untrustedText(m_question->endpoint));
  if (isChange) {
    addRow({}, Status::Plain, tr("Shown now"), tr("Accepted before"));
  }
  addRow(tr("Fingerprint (SHA-256)"), isChange ? Status::Attention : Status::Plain,
         fingerprintLines(shown.fingerprint),
         isChange ? fingerprintLines(m_question->acceptedFingerprint) : QString(), true);
  addRow(tr("Issued to"), Status::Plain, untrustedText(shown.subject),
         old(before ? untrustedText(before->subject) : QString()));
  addRow(tr("Issued by"), Status::Plain, issuerText(shown),
         old(before ? issuerText(*before) : QString()));
  const bool isStranger = !shown.strangerUri.empty();
  addRow(tr("Application"), isStranger ? Status::Attention : Status::Plain,
         isStranger ? tr("%1: the server says that it is %2")
                          .arg(listText(shown.applicationUris), untrustedText(shown.strangerUri))
                    : listText(shown.applicationUris),
         old(before ? listText(before->applicationUris) : QString()));
  const std::string host = opcua::hostOf(m_question->endpoint);
  const bool isForHost = opcua::isForHost(shown, host);
  addRow(tr("Made for"), isForHost ? Status::Good : Status::Attention,
         isForHost ? listText(shown.hostNames)
                   : tr("%1: not for %2").arg(listText(shown.hostNames), untrustedText(host)),
         old(before ? listText(before->hostNames) : QString()));
  addRow(tr("Valid"), m_question->isValidNow ? Status::Good : Status::Fault, validityText(shown),
         old(before ? validityText(*before) : QString()));
}

void TrustSheet::showChoices() {
  addRow(tr("Address"), Status::Plain, untrustedText(m_question->endpoint));
  for (std::size_t i = 0; i < m_question->choices.size(); ++i) {
    const opcua::SecurityChoice& choice = m_question->choices[i];
    const opcua::ChannelSecurity security{
        *choice.policy, *choice.policy == opcua::SecurityPolicy::None
                            ? opcua::MessageMode::None
                            : choice.mode.value_or(opcua::MessageMode::SignAndEncrypt)};
    const ProtectionText protection =
        protectionText(opcua::protectionOf(security, m_question->endpoint));
    const int row = m_nextRow++;
    auto* button = new QRadioButton(QString::fromStdString(opcua::securityText(security)), this);
    button->setObjectName(QStringLiteral("trust-choice-%1").arg(i));
    button->setMinimumHeight(kTouchHeightPx);
    auto* text = new StatusLabel(this);
    text->setWordWrap(true);
    text->setStatus(protection.status, protection.sentence);
    m_rows->addWidget(button, row, 0);
    m_rows->addWidget(text, row, 1, 1, 2);
    m_choices->addButton(button);
    button->setChecked(static_cast<int>(i) == m_chosen);
    connect(button, &QRadioButton::clicked, this, [this, i] { m_chosen = static_cast<int>(i); });
    m_shown.insert(m_shown.end(), {button, text});
    if (isVisible()) {
      button->show();
      text->show();
    }
  }
}

void TrustSheet::showMachineSide() {
  const bool isShown = m_question->kind != Kind::Protection && m_own;
  m_machineSide->setVisible(isShown);
  m_export->setVisible(isShown);
  if (isShown) {
    m_machineSide->setText(
        tr("The control has to trust this computer, too. On a SINUMERIK, switch on in the dialog "
           "of "
           "the OPC UA server that client certificates are accepted by themselves, connect, and "
           "switch it off again; or import the file of this computer's certificate there. Its "
           "fingerprint: %1")
            .arg(QString::fromStdString(opcua::fingerprintText(m_own->fingerprint))
                     .replace(QLatin1Char(':'), QStringLiteral(":\u200B"))));
  }
}

void TrustSheet::retranslate() {
  clearRows();
  if (!m_question || !isOnSheet(*m_question)) {
    return;
  }
  const bool isProtection = m_question->kind == Kind::Protection;
  m_title->setText(title());
  m_meaning->setStatus(m_question->kind == Kind::NewServer ? Status::Plain : Status::Attention,
                       meaning());
  m_accept->setText(isProtection ? tr("Hold: allow and connect") : tr("Hold: accept and connect"));
  const QString reason = obstacle();
  m_obstacle->setText(reason);
  m_obstacle->setVisible(!reason.isEmpty());
  m_accept->setEnabled(reason.isEmpty());
  if (isProtection) {
    showChoices();
  } else {
    showCertificate();
  }
  showMachineSide();
}

}  // namespace rivulet::widgets
