// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// As whom and how each machine is connected: the name of the user or the file of the user's
/// certificate, the map of the control and the library are remembered with the server, the password
/// in the keyring or nowhere. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>

#include "hmi/keyring.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"
#include "widgets/connection/control_fields.h"
#include "widgets/connection/login_fields.h"

namespace rivulet::hmi {

class Logins final : public QObject {
  Q_OBJECT

 public:
  /// @param passwordFile  for passwords that are not typed and not in the keyring, of mode 0600;
  ///                      empty: none
  Logins(std::unique_ptr<Keyring> keyring, std::filesystem::path passwordFile = {},
         std::filesystem::path folder = trust::trustFolder());

  /// As whom this machine was connected last; anonymous also if it never was.
  [[nodiscard]] widgets::LoginName nameOf(const QString& endpoint) const;
  /// With which map and library this machine was connected last.
  [[nodiscard]] widgets::ControlChoice controlOf(const QString& endpoint) const;
  [[nodiscard]] const widgets::LoginView& view() const { return m_view; }
  /// As whom this machine is connected is shown; nothing is asked any more.
  void show(const QString& endpoint);
  void ask(widgets::LoginView::Reason reason, const widgets::LoginName& name);

  /// Calls back with the password of a user, or an empty one; at once or later.
  void findPassword(const QString& endpoint, const QString& user,
                    std::function<void(const QString& password)> found);
  /// The connection is open.
  void remember(const QString& endpoint, const widgets::Login& login,
                const widgets::ControlChoice& control);

 Q_SIGNALS:
  void changed();

 private:
  [[nodiscard]] QString fromFile() const;
  void setHasKeyring(bool hasKeyring);

  std::unique_ptr<Keyring> m_keyring;
  std::filesystem::path m_passwordFile;
  trust::TrustStore m_store;
  QString m_endpoint;  ///< shown
  widgets::LoginView m_view;
};

}  // namespace rivulet::hmi
