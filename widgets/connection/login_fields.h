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

 private:
  void showState();
  void showName(const LoginName& name);
  [[nodiscard]] QString note() const;
  [[nodiscard]] bool isByCertificate() const;

  LoginView m_view;
  QCheckBox* m_hasUser = checkBox({.text = QT_TR_NOOP("Log in as a user of the machine"),
                                   .tip = QT_TR_NOOP("Without it, the connection is anonymous."),
                                   .id = "login"});
  QLabel* m_kindLabel = label({.text = QT_TR_NOOP("The user is known by"), .isMuted = true});
  QComboBox* m_kind = list({.tip = QT_TR_NOOP("What the machine asks of its users."),
                            .name = QT_TR_NOOP("The user is known by"),
                            .items = {QT_TR_NOOP("name and password"), QT_TR_NOOP("a certificate")},
                            .id = "login-kind"});
  QWidget* m_fields;
  QLabel* m_userLabel = label({.text = QT_TR_NOOP("User"), .isMuted = true});
  QLineEdit* m_user =
      lineEdit({.tip = QT_TR_NOOP("User of the OPC UA server, as it is set up on the control."),
                .name = QT_TR_NOOP("User"),
                .id = "login-user"});
  QLabel* m_passwordLabel = label({.text = QT_TR_NOOP("Password"), .isMuted = true});
  QLineEdit* m_password = lineEdit(
      {.tip = QT_TR_NOOP("It is sent encrypted only, and is in no setting, log or recording."),
       .name = QT_TR_NOOP("Password"),
       .id = "login-password"});
  QCheckBox* m_keeps =
      checkBox({.text = QT_TR_NOOP("Keep it in the keyring"),
                .tip = QT_TR_NOOP("The keyring of this computer's user keeps it encrypted; it "
                                  "is not asked for again."),
                .id = "login-keep"});
  QWidget* m_files;
  FileField* m_certificate;
  FileField* m_key;
  StatusLabel* m_note = status({.id = "login-note", .wraps = true});
};

}  // namespace rivulet::widgets
