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

void Login::forgetOld(base::Instant now) {
  std::erase_if(m_attempts,
                [now](const auto& entry) { return now - entry.second.last >= kWrongRemembered; });
  while (m_attempts.size() > kAttemptsMax) {
    m_attempts.erase(std::min_element(
        m_attempts.begin(), m_attempts.end(),
        [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
  }
}

Login::Outcome Login::check(std::string_view name, std::string_view password,
                            const std::string& network, base::Instant now) {
  const auto user = std::find_if(m_management.users.begin(), m_management.users.end(),
                                 [&](const User& candidate) { return candidate.name == name; });
  const bool isKnown = user != m_management.users.end();
  forgetOld(now);
  const std::pair key(isKnown ? user->name : std::string(), network);
  const auto known = m_attempts.find(key);
  if (known != m_attempts.end() && now < known->second.lockedUntil) {
    return {};
  }
  // An unknown name takes as long as a known one: else the time would tell which names exist.
  static const HashedPassword nobody = hashPassword("", "nobody");
  const bool canMatch = isKnown && hasPassword(*user);
  if (isPassword(canMatch ? user->password : nobody, password) && canMatch) {
    m_attempts.erase(key);
    return {&*user, std::nullopt};
  }
  Attempts& attempts = m_attempts[key];
  attempts.last = now;
  base::Duration lock{};
  if (++attempts.wrong >= kWrongPasswordsMax) {
    lock = kLockTime;
    for (int i = kWrongPasswordsMax; i < attempts.wrong && lock < kLockTimeMax; ++i) {
      lock = std::min<base::Duration>(2 * lock, kLockTimeMax);
    }
    attempts.lockedUntil = now + lock;
  }
  return {nullptr, LoginFailure{key.first, network, attempts.wrong, lock}};
}

}  // namespace rivulet::machine
