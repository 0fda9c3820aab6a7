// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/users.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPasswordDigestor>
#include <QRandomGenerator>
#include <algorithm>
#include <array>
#include <utility>

#include "base/file.h"
#include "preparation/user_file.h"
#include "session/background.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using permission::Role;

namespace {

constexpr int kFormatVersion = 1;
constexpr int kMsPerMinute = 60'000;
constexpr int kMsPerS = 1000;
constexpr quint64 kHashBytes = 32;
constexpr const char* kNoEngineer =
    QT_TRANSLATE_NOOP("UserTexts", "At least one user must be an engineer.");

QByteArray newSalt() {
  std::array<quint32, 4> words{};
  QRandomGenerator::system()->fillRange(words.data(), words.size());
  return QByteArray(reinterpret_cast<const char*>(words.data()), sizeof(words));
}

tl::unexpected<base::Error> refused(const char* why) {
  return base::fail(std::make_error_code(std::errc::invalid_argument), why);
}

bool hasEngineer(const std::vector<User>& users) {
  return std::any_of(users.begin(), users.end(),
                     [](const User& user) { return user.role == Role::Engineer; });
}

QJsonObject jsonOf(const User& user) {
  const std::string_view role = permission::roleName(user.role);
  return {
      {QStringLiteral("name"), user.name},
      {QStringLiteral("role"), QString::fromUtf8(role.data(), static_cast<qsizetype>(role.size()))},
      {QStringLiteral("salt"), QString::fromLatin1(user.salt.toHex())},
      {QStringLiteral("hash"), QString::fromLatin1(user.hash.toHex())}};
}

}  // namespace

QString userErrorText(const base::Error& error) {
  return error.code.category() == std::generic_category()
             ? QCoreApplication::translate("UserTexts", error.message.c_str())
             : widgets::errorText(error);
}

QByteArray pinHash(const QString& pin, const QByteArray& salt) {
  return QPasswordDigestor::deriveKeyPbkdf2(QCryptographicHash::Sha256, pin.toUtf8(), salt,
                                            Users::kIterations, kHashBytes);
}

std::filesystem::path Users::fileOfUser() {
  return preparation::userFileOfUser();
}

Users::Users(std::filesystem::path file, QString systemUser)
    : m_file(std::move(file)), m_systemUser(std::move(systemUser)) {
  m_idle.setSingleShot(true);
  connect(&m_idle, &QTimer::timeout, this, [this] {
    if (m_current && isSetUp()) {
      m_current.reset();
      Q_EMIT locked(true);
      Q_EMIT changed();
    }
  });
  load();
  const User* own = find(m_systemUser);
  if (own != nullptr && !own->hasPin()) {
    m_current = own->name;
  }
  noticeInput();
}

void Users::load() {
  if (m_file.empty()) {
    return;
  }
  const auto file = preparation::readUsers(m_file);
  if (!file) {
    // A damaged file must not make an engineer of everybody.
    m_users.assign(1, User{});
    const bool isDamaged = file.error().code == std::make_error_code(std::errc::invalid_argument);
    m_fileError = isDamaged
                      ? base::makeError(file.error().code,
                                        QT_TRANSLATE_NOOP("UserTexts",
                                                          "The file of users is damaged. Restore "
                                                          "it, or delete it to set the users up "
                                                          "again."),
                                        m_file.string())
                      : file.error();
    return;
  }
  m_idleMinutes = file->idleMinutes;
  for (const preparation::KeptUser& user : file->users) {
    m_users.push_back({QString::fromStdString(user.name), user.role,
                       QByteArray::fromHex(QByteArray::fromStdString(user.saltHex)),
                       QByteArray::fromHex(QByteArray::fromStdString(user.hashHex))});
  }
}

base::Result<void> Users::save(const std::vector<User>& users, int idleMinutes) {
  if (m_file.empty()) {
    return {};
  }
  QJsonArray array;
  for (const User& user : users) {
    array.append(jsonOf(user));
  }
  const QJsonObject json{{QStringLiteral("rivulet_users"), kFormatVersion},
                         {QStringLiteral("idle_minutes"), idleMinutes},
                         {QStringLiteral("users"), array}};
  std::error_code ignored;  // writing says what is wrong
  std::filesystem::create_directories(m_file.parent_path(), ignored);
  const auto ownerOnly = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
  const QString name = QString::fromStdString(m_file.string());
  if (!QFile::exists(name)) {
    // The mode is kept when the content is replaced: it is right before there is any.
    QFile created(name);
    if (created.open(QIODevice::WriteOnly | QIODevice::NewOnly, ownerOnly)) {
      created.close();
    }
  }
  QFile::setPermissions(name, ownerOnly);
  return base::writeFile(m_file, QJsonDocument(json).toJson().toStdString());
}

const User* Users::find(const QString& name) const {
  const auto found = std::find_if(m_users.begin(), m_users.end(),
                                  [&name](const User& user) { return user.name == name; });
  return found == m_users.end() ? nullptr : &*found;
}

permission::Standing Users::standing() const {
  if (!isSetUp()) {
    return {};
  }
  const User* user = m_current ? find(*m_current) : nullptr;
  return user == nullptr ? permission::Standing{Role::Operator, true}
                         : permission::Standing{user->role, false};
}

QString Users::name() const {
  return m_current ? *m_current : (isSetUp() ? QString() : m_systemUser);
}

std::optional<permission::Refusal> Users::refusal(permission::Act act, bool isReleased,
                                                  bool mayRepeat) const {
  return permission::refusal(standing(), act, isReleased, mayRepeat);
}

void Users::logIn(const QString& name, const QString& pin) {
  if (m_isChecking) {
    return;
  }
  if (m_wrong >= kTriesMax && m_waited.elapsed() < kWaitMs) {
    Q_EMIT logInFailed(name, static_cast<int>((kWaitMs - m_waited.elapsed()) / kMsPerS) + 1);
    return;
  }
  const User* user = find(name);
  if (user == nullptr || (!user->hasPin() && user->name != m_systemUser)) {
    takeAnswer(name, false);
    return;
  }
  if (!user->hasPin()) {
    takeAnswer(name, true);
    return;
  }
  m_isChecking = true;
  hashPin(pin, user->salt, [this, name, right = user->hash](const QByteArray& hash) {
    m_isChecking = false;
    takeAnswer(name, hash == right);
  });
}

void Users::hashPin(const QString& pin, const QByteArray& salt,
                    std::function<void(const QByteArray& hash)> then) {
  session::inBackground(
      this, [pin, salt] { return pinHash(pin, salt); },
      [then = std::move(then)](Users&, const QByteArray& hash) { then(hash); });
}

void Users::takeAnswer(const QString& name, bool isRight) {
  if (!isRight) {
    ++m_wrong;
    m_waited.start();
    Q_EMIT logInFailed(name, m_wrong >= kTriesMax ? kWaitMs / kMsPerS : 0);
    return;
  }
  m_wrong = 0;
  m_current = name;
  noticeInput();
  Q_EMIT loggedIn(name);
  Q_EMIT changed();
}

void Users::lock() {
  if (m_current && isSetUp()) {
    m_current.reset();
    Q_EMIT locked(false);
    Q_EMIT changed();
  }
}

void Users::setIdleMinutes(int minutes) {
  m_idleMinutes = minutes;
  if (const auto saved = save(m_users, minutes); !saved) {
    m_fileError = saved.error();
  }
  noticeInput();
  Q_EMIT changed();
}

void Users::noticeInput() {
  if (m_idleMinutes > 0 && m_current && isSetUp()) {
    m_idle.start(m_idleMinutes * kMsPerMinute);
  } else {
    m_idle.stop();
  }
}

void Users::put(const QString& typedName, Role role, const QString& pin, PutAnswer answer) {
  const QString name = typedName.trimmed();
  if (name.isEmpty()) {
    answer(refused(QT_TRANSLATE_NOOP("UserTexts", "Give a name.")));
    return;
  }
  if (pin.size() < kPinLengthMin && !(pin.isEmpty() && name == m_systemUser)) {
    answer(refused(QT_TRANSLATE_NOOP("UserTexts", "The PIN needs at least 4 characters.")));
    return;
  }
  User user{name, role, {}, {}};
  if (pin.isEmpty()) {
    answer(keep(user));
    return;
  }
  user.salt = newSalt();
  hashPin(pin, user.salt, [this, user, answer = std::move(answer)](const QByteArray& hash) mutable {
    user.hash = hash;
    answer(keep(user));
  });
}

base::Result<void> Users::keep(const User& user) {
  std::vector<User> users = m_users;
  const auto known = std::find_if(users.begin(), users.end(),
                                  [&user](const User& one) { return one.name == user.name; });
  if (known == users.end()) {
    users.push_back(user);
  } else {
    *known = user;
  }
  if (!hasEngineer(users)) {
    return refused(kNoEngineer);
  }
  const bool isFirst = m_users.empty();
  if (auto saved = save(users, m_idleMinutes); !saved) {
    return saved;
  }
  m_users = std::move(users);
  if (isFirst) {
    m_current = user.name;  // who sets the window up stays in it
  }
  Q_EMIT changed();
  return {};
}

base::Result<void> Users::remove(const QString& name) {
  std::vector<User> users = m_users;
  std::erase_if(users, [&name](const User& user) { return user.name == name; });
  if (!users.empty() && !hasEngineer(users)) {
    return refused(kNoEngineer);
  }
  if (auto saved = save(users, m_idleMinutes); !saved) {
    return saved;
  }
  if (users.empty() && !m_file.empty()) {
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
  }
  m_users = std::move(users);
  if (m_current && (m_users.empty() || find(*m_current) == nullptr)) {
    m_current.reset();
  }
  Q_EMIT changed();
  return {};
}

}  // namespace rivulet::hmi
