// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who works at the window: a button that shows the user and locks the window, the question for the
/// PIN, and the page on which an engineer sets the users up. @threadsafety GUI thread.
#pragma once

#include <QDialog>
#include <QString>
#include <optional>
#include <vector>

#include "permission/permission.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableView;
class QToolButton;

namespace rivulet::widgets {

struct UserRow {
  QString name;
  permission::Role role = permission::Role::Operator;
  bool hasPin = true;
};

struct UsersView {
  std::vector<UserRow> users;
  QString current;  ///< who is logged in; empty: nobody
  permission::Role role = permission::Role::Engineer;
  bool isLocked = false;
  int idleMinutes = 0;  ///< until the window locks itself; 0: never
  QString systemUser;

  [[nodiscard]] bool isSetUp() const { return !users.empty(); }
};

/// Shows who works here; a click locks the window, or asks who comes. Hidden without users.
class UserButton final : public Page {
  Q_OBJECT

 public:
  explicit UserButton(QWidget* parent = nullptr);
  void setUsers(const UsersView& view);

 Q_SIGNALS:
  void lockRequested();
  void logInRequested();

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  UsersView m_view;
  QToolButton* m_button;
};

/// Asks for user and PIN, with keys large enough for gloves.
class LogInDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit LogInDialog(const UsersView& view, QWidget* parent = nullptr);
  /// The PIN was wrong. @param waitS  how long no PIN is taken; 0: at once
  void showFailure(int waitS);

 Q_SIGNALS:
  void logInRequested(const QString& name, const QString& pin);

 private:
  void tryPin();

  QComboBox* m_name;
  QLineEdit* m_pin;
  QLabel* m_answer;
  QPushButton* m_logIn;
};

class UserModel final : public TableModel<UserRow> {
  Q_OBJECT

 public:
  enum Column { Name, RoleColumn, Pin };
  explicit UserModel(QObject* parent = nullptr);
};

class UsersPage final : public Page {
  Q_OBJECT

 public:
  explicit UsersPage(QWidget* parent = nullptr);
  /// @param mayChange  the one who is there is an engineer
  void setUsers(const UsersView& view, bool mayChange);
  /// What the last request came to; empty: done.
  void showAnswer(const QString& text);

 Q_SIGNALS:
  /// A new user, or another role and PIN of one who is there.
  void putRequested(const QString& name, rivulet::permission::Role role, const QString& pin);
  void removeRequested(const QString& name);
  void idleMinutesRequested(int minutes);

 protected:
  void retranslate() override;

 private:
  void showState();
  [[nodiscard]] QWidget* makeForm();

  UsersView m_view;
  bool m_mayChange = true;
  UserModel* m_model;
  QLabel* m_state = label({.wraps = true});
  QTableView* m_table;
  QWidget* m_form;
  QLineEdit* m_name;
  QComboBox* m_role;
  QLineEdit* m_pin;
  QSpinBox* m_idle;
  QPushButton* m_put;
  QPushButton* m_remove;
  QLabel* m_answer;
};

}  // namespace rivulet::widgets
