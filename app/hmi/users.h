// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who works at the window: users with a role and a PIN in a file that only its owner may read
/// (mode 0600), who of them is logged in, and whether the window is locked. While there is no user,
/// everybody is an engineer and nothing is locked. @threadsafety GUI thread.
#pragma once

#include <QByteArray>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "base/result.h"
#include "permission/permission.h"
#include "preparation/user_file.h"

namespace rivulet::hmi {

struct User {
  QString name;
  permission::Role role = permission::Role::Operator;
  /// Both empty: no PIN. Who has the same name on this computer is logged in at the start.
  QByteArray salt;
  QByteArray hash;  ///< PBKDF2 with SHA-256

  [[nodiscard]] bool hasPin() const { return !hash.isEmpty(); }
};

class Users final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kPinLengthMin = 4;
  static constexpr int kIterations = preparation::kPinIterations;
  /// After this many wrong PINs in a row the next one has to wait.
  static constexpr int kTriesMax = 3;
  static constexpr int kWaitMs = 30'000;

  /// $XDG_CONFIG_HOME/rivulet/users.json, or below ~/.config.
  [[nodiscard]] static std::filesystem::path fileOfUser();

  /// @param file  empty: nobody is set up, and nothing is kept
  /// @param systemUser  name of the user of this computer
  Users(std::filesystem::path file, QString systemUser);

  [[nodiscard]] bool isSetUp() const { return !m_users.empty(); }
  [[nodiscard]] const std::vector<User>& users() const { return m_users; }
  [[nodiscard]] permission::Standing standing() const;
  [[nodiscard]] const QString& systemUser() const { return m_systemUser; }
  /// Who is logged in; without users the one of this computer.
  [[nodiscard]] QString name() const;
  [[nodiscard]] bool isLocked() const { return isSetUp() && !m_current; }
  [[nodiscard]] std::optional<permission::Refusal> refusal(permission::Act act,
                                                           bool isReleased = true,
                                                           bool mayRepeat = false) const;
  /// Why the file could not be read: everything is locked then. Code clear: it could.
  [[nodiscard]] const base::Error& fileError() const { return m_fileError; }

  /// Checks the PIN on another thread. Answered by `changed` or `logInFailed`.
  void logIn(const QString& name, const QString& pin);
  void lock();
  /// @param minutes  without input until the window locks itself; 0: never
  void setIdleMinutes(int minutes);
  [[nodiscard]] int idleMinutes() const { return m_idleMinutes; }
  /// Somebody has touched the window.
  void noticeInput();

  using PutAnswer = std::function<void(const base::Result<void>&)>;

  /// Adds a user, or changes role and PIN of the one of this name. The first one must be an
  /// engineer, and the last engineer stays one. The PIN is hashed on another thread.
  /// @param pin  empty: without PIN (the user of this computer)
  /// @param answer  called once on the GUI thread, at once for an entry that is refused; an error
  /// says what is missing
  void put(const QString& name, permission::Role role, const QString& pin, PutAnswer answer);
  [[nodiscard]] base::Result<void> remove(const QString& name);

 Q_SIGNALS:
  /// Users, who is logged in, or the lock.
  void changed();
  void loggedIn(const QString& name);
  void logInFailed(const QString& name, int waitS);
  /// By hand, or nobody has touched the window for a while.
  void locked(bool byItself);

 private:
  void load();
  [[nodiscard]] base::Result<void> save(const std::vector<User>& users, int idleMinutes);
  void takeAnswer(const QString& name, bool isRight);
  /// Puts a user into the file and the list.
  [[nodiscard]] base::Result<void> keep(const User& user);
  /// `pinHash` on another thread; `then` runs on this one, unless this object is gone.
  void hashPin(const QString& pin, const QByteArray& salt,
               std::function<void(const QByteArray& hash)> then);
  [[nodiscard]] const User* find(const QString& name) const;

  std::filesystem::path m_file;
  QString m_systemUser;
  std::vector<User> m_users;
  std::optional<QString> m_current;
  base::Error m_fileError;
  int m_idleMinutes = 0;
  QTimer m_idle;
  int m_wrong = 0;         ///< PINs in a row
  QElapsedTimer m_waited;  ///< since the last wrong one
  bool m_isChecking = false;
};

/// Why something about users cannot be done, in the present language.
[[nodiscard]] QString userErrorText(const base::Error& error);

/// PBKDF2 of a PIN; slow on purpose (about 0.1 s).
[[nodiscard]] QByteArray pinHash(const QString& pin, const QByteArray& salt);

}  // namespace rivulet::hmi
