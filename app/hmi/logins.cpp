// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/logins.h"

#include <QPointer>
#include <utility>

#include "qtopcua/open_link.h"
#include "trust/password.h"

namespace rivulet::hmi {

using Outcome = Keyring::Outcome;
using widgets::Login;
using widgets::LoginName;
using widgets::LoginView;

namespace {

QString keyOf(const QString& endpoint, const QString& user) {
  return user + QLatin1Char('@') + endpoint.trimmed().toLower();
}

}  // namespace

Logins::Logins(std::unique_ptr<Keyring> keyring, std::filesystem::path passwordFile,
               std::filesystem::path folder)
    : m_keyring(std::move(keyring)),
      m_passwordFile(std::move(passwordFile)),
      m_store(std::move(folder)) {
}

LoginName Logins::nameOf(const QString& endpoint) const {
  const auto known = m_store.find(endpoint.trimmed().toStdString());
  if (!known || !*known) {
    return {};
  }
  const trust::KnownServer& server = **known;
  return {QString::fromStdString(server.user), QString::fromStdString(server.certificateFile),
          QString::fromStdString(server.keyFile)};
}

widgets::ControlChoice Logins::controlOf(const QString& endpoint) const {
  widgets::ControlChoice choice;
  const auto known = m_store.find(endpoint.trimmed().toStdString());
  if (known && *known) {
    choice.mapFile = QString::fromStdString((*known)->mapFile);
    choice.link = qtopcua::linkFromName((*known)->link).value_or(opcua::LinkKind::Open62541);
  }
  return choice;
}

void Logins::show(const QString& endpoint) {
  m_view.reason = LoginView::Reason::None;
  if (endpoint != m_endpoint) {  // else what was typed stays
    m_endpoint = endpoint;
    m_view.name = nameOf(endpoint);
  }
  Q_EMIT changed();
}

void Logins::ask(LoginView::Reason reason, const LoginName& name) {
  m_view.reason = reason;
  m_view.name = name;
  Q_EMIT changed();
}

void Logins::setHasKeyring(bool hasKeyring) {
  if (hasKeyring != m_view.hasKeyring) {
    m_view.hasKeyring = hasKeyring;
    Q_EMIT changed();
  }
}

QString Logins::fromFile() const {
  const auto password = trust::givenPassword(m_passwordFile);
  return password && *password ? QString::fromStdString(**password) : QString();
}

void Logins::findPassword(const QString& endpoint, const QString& user,
                          std::function<void(const QString&)> found) {
  m_keyring->read(keyOf(endpoint, user), [self = QPointer<Logins>(this), found = std::move(found)](
                                             Outcome outcome, const QString& password) {
    if (self) {
      self->setHasKeyring(outcome != Outcome::Missing);
      found(outcome == Outcome::Done ? password : self->fromFile());
    }
  });
}

void Logins::remember(const QString& endpoint, const Login& login,
                      const widgets::ControlChoice& control) {
  if (controlOf(endpoint) != control) {
    const bool isDefault = control.link == opcua::LinkKind::Open62541;
    // Without it the map is chosen again, no more.
    (void)m_store.setControl(
        endpoint.trimmed().toStdString(), control.mapFile.toStdString(),
        isDefault ? std::string() : std::string(qtopcua::linkName(control.link)));
  }
  const LoginName& name = login.name;
  if (nameOf(endpoint) != name) {
    // Without it the name is asked for again, no more.
    (void)m_store.setLogin(endpoint.trimmed().toStdString(), name.user.toStdString(),
                           name.certificateFile.toStdString(), name.keyFile.toStdString());
  }
  m_view.reason = LoginView::Reason::None;
  m_view.name = name;
  Q_EMIT changed();
  if (login.keeps && !login.password.isEmpty()) {
    m_keyring->write(keyOf(endpoint, name.user), login.password,
                     [self = QPointer<Logins>(this)](Outcome outcome) {
                       if (self) {
                         self->setHasKeyring(outcome != Outcome::Missing);
                       }
                     });
  }
}

}  // namespace rivulet::hmi
