// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/login_fields.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

LoginFields::LoginFields(QWidget* parent)
    : Page(parent),
      m_hasUser(new QCheckBox(this)),
      m_fields(new QWidget(this)),
      m_userLabel(new QLabel(m_fields)),
      m_user(new QLineEdit(m_fields)),
      m_passwordLabel(new QLabel(m_fields)),
      m_password(new QLineEdit(m_fields)),
      m_keeps(new QCheckBox(m_fields)),
      m_note(new StatusLabel(this)) {
  m_hasUser->setObjectName(QStringLiteral("login"));
  m_user->setObjectName(QStringLiteral("login-user"));
  m_password->setObjectName(QStringLiteral("login-password"));
  m_keeps->setObjectName(QStringLiteral("login-keep"));
  m_note->setObjectName(QStringLiteral("login-note"));
  m_password->setEchoMode(QLineEdit::Password);
  m_userLabel->setBuddy(m_user);
  m_passwordLabel->setBuddy(m_password);
  m_note->setWordWrap(true);
  for (QWidget* field : std::initializer_list<QWidget*>{m_hasUser, m_user, m_password, m_keeps}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* fields = new QVBoxLayout(m_fields);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->setSpacing(2);
  for (QWidget* field :
       std::initializer_list<QWidget*>{m_userLabel, m_user, m_passwordLabel, m_password, m_keeps}) {
    fields->addWidget(field);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_hasUser);
  layout->addWidget(m_note);
  layout->addWidget(m_fields);
  connect(m_hasUser, &QCheckBox::toggled, this, &LoginFields::showState);
  connect(m_password, &QLineEdit::returnPressed, this, &LoginFields::submitted);
  retranslate();
  restyle();
}

void LoginFields::setLogin(const LoginView& view) {
  const bool isOtherUser = view.user != m_view.user;
  m_view = view;
  if (isOtherUser) {
    m_user->setText(view.user);
    m_hasUser->setChecked(!view.user.isEmpty());
  }
  if (view.reason != LoginView::Reason::None) {
    m_hasUser->setChecked(true);
  }
  showState();
  if (view.reason != LoginView::Reason::None && isVisible()) {
    (view.reason == LoginView::Reason::NeedsUser ? m_user : m_password)->setFocus();
  }
}

Login LoginFields::take() {
  Login login;
  if (m_hasUser->isChecked()) {
    login.user = m_user->text().trimmed();
    login.password = m_password->text();
    login.keeps = m_keeps->isChecked() && m_view.hasKeyring;
  }
  m_password->clear();
  return login;
}

void LoginFields::showState() {
  using Reason = LoginView::Reason;
  m_fields->setVisible(m_hasUser->isChecked());
  m_keeps->setVisible(m_view.hasKeyring);
  QString note;
  Status status = Status::Attention;
  switch (m_view.reason) {
    case Reason::NeedsUser:
      note = tr("This machine lets nobody in without a user. Type user and password.");
      break;
    case Reason::NeedsPassword:
      note = tr("Type the password of this user.");
      break;
    case Reason::Refused:
      note =
          tr("The machine refuses user or password. Check both. After several wrong ones it "
             "locks the user for some time.");
      break;
    case Reason::None:
      status = Status::Plain;
      if (!m_view.hasKeyring) {
        note = tr("There is no keyring on this computer: the password is asked for each time.");
      }
      break;
  }
  m_note->setVisible(!note.isEmpty() && m_hasUser->isChecked());
  m_note->setStatus(status, note);
}

void LoginFields::retranslate() {
  m_hasUser->setText(tr("Log in as a user of the machine"));
  m_hasUser->setToolTip(tr("Without it, the connection is anonymous."));
  m_userLabel->setText(tr("User"));
  m_user->setAccessibleName(tr("User"));
  m_user->setToolTip(tr("User of the OPC UA server, as it is set up on the control."));
  m_passwordLabel->setText(tr("Password"));
  m_password->setAccessibleName(tr("Password"));
  m_password->setToolTip(tr("It is sent encrypted only, and is in no setting, log or recording."));
  m_keeps->setText(tr("Keep it in the keyring"));
  m_keeps->setToolTip(
      tr("The keyring of this computer's user keeps it encrypted; it is not asked for again."));
  showState();
}

void LoginFields::restyle() {
  setMuted(m_userLabel, palette());
  setMuted(m_passwordLabel, palette());
}

}  // namespace rivulet::widgets
