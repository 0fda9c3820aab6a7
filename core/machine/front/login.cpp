// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/login.h"

#include <algorithm>

namespace rivulet::machine {

namespace {

[[nodiscard]] bool hasPassword(const User& user) {
  return !user.password.hash.empty();
}

}  // namespace

bool Login::takesPasswords() const {
  return std::any_of(m_management.users.begin(), m_management.users.end(), hasPassword);
}

bool Login::takesCertificates() const {
  return std::any_of(m_management.users.begin(), m_management.users.end(),
                     [](const User& user) { return !user.certificate.empty(); });
}

const User* Login::findByCertificate(std::string_view fingerprint) const {
  const auto user = std::find_if(
      m_management.users.begin(), m_management.users.end(), [&](const User& candidate) {
        return !candidate.certificate.empty() && candidate.certificate == fingerprint;
      });
  return user == m_management.users.end() ? nullptr : &*user;
}

const User* Login::check(std::string_view name, std::string_view password, base::Instant now) {
  const auto user = std::find_if(m_management.users.begin(), m_management.users.end(),
                                 [&](const User& candidate) { return candidate.name == name; });
  const bool isKnown = user != m_management.users.end();
  Attempts& attempts = m_attempts[isKnown ? user->name : std::string()];
  if (now < attempts.lockedUntil) {
    return nullptr;
  }
  // An unknown name takes as long as a known one: else the time would tell which names exist.
  static const HashedPassword nobody = hashPassword("", "nobody");
  const bool canMatch = isKnown && hasPassword(*user);
  if (isPassword(canMatch ? user->password : nobody, password) && canMatch) {
    attempts = {};
    return &*user;
  }
  if (++attempts.wrong >= kWrongPasswordsMax) {
    attempts = {0, now + kLockTime};
  }
  return nullptr;
}

}  // namespace rivulet::machine
