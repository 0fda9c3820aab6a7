// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A file of users with PINs, as the window writes it. @threadsafety the test's thread.
#pragma once

#include <QFile>
#include <QString>
#include <string>
#include <utility>
#include <vector>

#include "base/sha256.h"
#include "permission/permission.h"
#include "preparation/user_file.h"

namespace rivulet::tests {

struct ListedUser {
  std::string name;
  permission::Role role = permission::Role::Operator;
  std::string pin;
};

/// Written anew. The salt is the name.
inline void writeUsers(const QString& path, const std::vector<ListedUser>& users) {
  QByteArray list;
  for (const ListedUser& user : users) {
    const QByteArray name = QByteArray::fromStdString(user.name);
    const std::string role(permission::roleName(user.role));
    const std::string hash =
        base::passwordHashHex(user.pin, user.name, preparation::kPinIterations);
    list += (list.isEmpty() ? "" : ", ") + ("{\"name\": \"" + name) + "\", \"role\": \"" +
            role.c_str() + "\", \"salt\": \"" + name.toHex() + "\", \"hash\": \"" + hash.c_str() +
            "\"}";
  }
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write("{\"users\": [" + list + "]}") <= 0) {
    qFatal("the users cannot be written");
  }
}

}  // namespace rivulet::tests
