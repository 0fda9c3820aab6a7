// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// As whom a machine is connected: anonymous, or a user with a password. A password that was typed
/// is given away once and not kept here. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "widgets/common/page.h"

class QCheckBox;
class QLineEdit;

namespace rivulet::widgets {

class StatusLabel;

/// As it was typed.
struct Login {
  QString user;  ///< empty: anonymous
  QString password;
  bool keeps = false;  ///< the password, in the system's keyring
};

struct LoginView {
  /// Why the fields are asked to be filled in.
  enum class Reason {
    None,
    NeedsUser,      ///< the machine lets nobody in without one
    NeedsPassword,  ///< it is not in the keyring
    Refused,        ///< user or password are wrong, or the user is locked
  };
  Reason reason = Reason::None;
  QString user;            ///< with whom this machine was connected last
  bool hasKeyring = true;  ///< as far as it is known
};

class LoginFields final : public Page {
  Q_OBJECT

 public:
  explicit LoginFields(QWidget* parent = nullptr);

  void setLogin(const LoginView& view);
  /// What is typed now. The password is taken out of its field.
  [[nodiscard]] Login take();

 Q_SIGNALS:
  /// Return was pressed in the last field.
  void submitted();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  void showState();

  LoginView m_view;
  QCheckBox* m_hasUser;
  QWidget* m_fields;
  QLabel* m_userLabel;
  QLineEdit* m_user;
  QLabel* m_passwordLabel;
  QLineEdit* m_password;
  QCheckBox* m_keeps;
  StatusLabel* m_note;
};

}  // namespace rivulet::widgets
