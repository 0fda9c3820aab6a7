// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/login_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "widgets/common/file_field.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

/// Places in the list of what a user is known by.
constexpr int kByPassword = 0;
constexpr int kByCertificate = 1;

}  // namespace

LoginFields::LoginFields(QWidget* parent)
    : Page(parent),
      m_fields(new QWidget(this)),
      m_files(new QWidget(this)),
      m_certificate(new FileField(QStringLiteral("login-certificate"), m_files)),
      m_key(new FileField(QStringLiteral("login-key"), m_files)) {
  m_password->setEchoMode(QLineEdit::Password);
  m_kindLabel->setBuddy(m_kind);
  m_userLabel->setBuddy(m_user);
  m_passwordLabel->setBuddy(m_password);
  for (QWidget* field :
       std::initializer_list<QWidget*>{m_hasUser, m_kind, m_user, m_password, m_keeps}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* fields = new QVBoxLayout(m_fields);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->setSpacing(2);
  for (QWidget* field :
       std::initializer_list<QWidget*>{m_userLabel, m_user, m_passwordLabel, m_password, m_keeps}) {
    fields->addWidget(field);
  }
  inColumn({m_certificate, m_key}, m_files, QMargins(0, 4, 0, 0));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (QWidget* field :
       std::initializer_list<QWidget*>{m_hasUser, m_note, m_kindLabel, m_kind, m_fields, m_files}) {
    layout->addWidget(field);
  }
  connect(m_hasUser, &QCheckBox::toggled, this, &LoginFields::showState);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &LoginFields::showState);
  connect(m_password, &QLineEdit::returnPressed, this, &LoginFields::submitted);
  connect(m_certificate, &FileField::submitted, this, &LoginFields::submitted);
  connect(m_key, &FileField::submitted, this, &LoginFields::submitted);
  retranslate();
}

void LoginFields::setLogin(const LoginView& view) {
  const bool isOther = view.name != m_view.name;
  m_view = view;
  if (isOther) {
    showName(view.name);
  }
  if (view.reason != LoginView::Reason::None) {
    m_hasUser->setChecked(true);
  }
  showState();
  if (view.reason != LoginView::Reason::None && isVisible()) {
    QWidget* const missing = isByCertificate() ? static_cast<QWidget*>(m_certificate)
                             : view.reason == LoginView::Reason::NeedsUser ? m_user
                                                                           : m_password;
    missing->setFocus();
  }
}

void LoginFields::showName(const LoginName& name) {
  m_hasUser->setChecked(!name.isAnonymous());
  m_kind->setCurrentIndex(name.certificateFile.isEmpty() ? kByPassword : kByCertificate);
  m_user->setText(name.user);
  m_certificate->setFile(name.certificateFile);
  m_key->setFile(name.keyFile);
}

bool LoginFields::isByCertificate() const {
  return m_kind->currentIndex() == kByCertificate;
}

Login LoginFields::take() {
  Login login;
  if (m_hasUser->isChecked() && isByCertificate()) {
    login.name.certificateFile = m_certificate->file();
    login.name.keyFile = m_key->file();
  } else if (m_hasUser->isChecked()) {
    login.name.user = m_user->text().trimmed();
    login.password = m_password->text();
    login.keeps = m_keeps->isChecked() && m_view.hasKeyring;
  }
  m_password->clear();
  return login;
}

QString LoginFields::note() const {
  using Reason = LoginView::Reason;
  switch (m_view.reason) {
    case Reason::NeedsUser:
      return isByCertificate()
                 ? tr("This machine lets nobody in without a user. Choose the user's certificate.")
                 : tr("This machine lets nobody in without a user. Type user and password.");
    case Reason::NeedsPassword:
      return tr("Type the password of this user.");
    case Reason::Refused:
      return m_view.name.certificateFile.isEmpty()
                 ? tr("The machine refuses user or password. Check both. After several wrong ones "
                      "it locks the user for some time.")
                 : tr("The machine refuses this certificate. Register it for a user on the "
                      "machine, or choose another one.");
    case Reason::None:
      return m_view.hasKeyring || isByCertificate()
                 ? QString()
                 : tr("There is no keyring on this computer: the password is asked for each time.");
  }
  return {};
}

void LoginFields::showState() {
  const bool hasUser = m_hasUser->isChecked();
  m_kindLabel->setVisible(hasUser);
  m_kind->setVisible(hasUser);
  m_fields->setVisible(hasUser && !isByCertificate());
  m_files->setVisible(hasUser && isByCertificate());
  m_keeps->setVisible(m_view.hasKeyring);
  const QString text = note();
  m_note->setVisible(!text.isEmpty() && hasUser);
  m_note->setStatus(m_view.reason == LoginView::Reason::None ? Status::Plain : Status::Attention,
                    text);
}

void LoginFields::retranslate() {
  m_certificate->setTexts(tr("Certificate of the user"),
                          tr("PEM or DER. Register it on the machine first. The name of the file "
                             "is remembered for this machine."),
                          {});
  m_key->setTexts(tr("Key, if it is in another file"),
                  tr("PEM or DER, not locked by a password; only this computer's user may read the "
                     "file (mode 0600). The key is not sent."),
                  {});
  showState();
}

}  // namespace rivulet::widgets
