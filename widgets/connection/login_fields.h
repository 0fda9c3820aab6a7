// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// As whom a machine is connected: anonymous, a user with a password, or one with a certificate. A
/// password that was typed is given away once and not kept here. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "widgets/common/page.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace rivulet::widgets {

class FileField;
class StatusLabel;

/// Nothing is set: anonymous.
struct LoginName {
  QString user;             ///< with a password
  QString certificateFile;  ///< of the user, in place of name and password
  QString keyFile;          ///< of the certificate; empty: the same file
  [[nodiscard]] bool isAnonymous() const { return user.isEmpty() && certificateFile.isEmpty(); }
  friend bool operator==(const LoginName&, const LoginName&) = default;
};

/// As it was typed.
struct Login {
  LoginName name;
  QString password;
  bool keeps = false;  ///< the password, in the system's keyring
};

struct LoginView {
  /// Why the fields are asked to be filled in.
  enum class Reason {
    None,
    NeedsUser,      ///< the machine lets nobody in without one
    NeedsPassword,  ///< it is not in the keyring
    Refused,        ///< user, password or certificate are wrong, or the user is locked
  };
  Reason reason = Reason::None;
  LoginName name;          ///< with which this machine was connected last
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
  /// Return was pressed in a field that can be the last one.
  void submitted();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  void showState();
  void showName(const LoginName& name);
  [[nodiscard]] QString note() const;
  [[nodiscard]] bool isByCertificate() const;

  LoginView m_view;
  QCheckBox* m_hasUser;
  QLabel* m_kindLabel;
  QComboBox* m_kind;
  QWidget* m_fields;
  QLabel* m_userLabel;
  QLineEdit* m_user;
  QLabel* m_passwordLabel;
  QLineEdit* m_password;
  QCheckBox* m_keeps;
  QWidget* m_files;
  FileField* m_certificate;
  FileField* m_key;
  StatusLabel* m_note;
};

}  // namespace rivulet::widgets
