// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Checks user names, passwords and certificates, and locks a user for some time after wrong ones.
/// @threadsafety as the server.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "base/instant.h"
#include "machine/user.h"

namespace rivulet::machine {

/// So many wrong passwords in a row lock a user...
inline constexpr int kWrongPasswordsMax = 5;
/// ...for so long. A right password is refused as well meanwhile, so guessing tells nothing.
inline constexpr base::Duration kLockTime = std::chrono::seconds(60);

class Login {
 public:
  explicit Login(UserManagement management) : m_management(std::move(management)) {}

  [[nodiscard]] bool letsAnonymousIn() const { return m_management.anonymous; }
  /// Somebody can log in with name and password.
  [[nodiscard]] bool takesPasswords() const;
  /// Somebody can log in by certificate.
  [[nodiscard]] bool takesCertificates() const;

  /// @return the user, valid as long as this object; null if name or password are wrong, or the
  /// user is locked
  [[nodiscard]] const User* check(std::string_view name, std::string_view password,
                                  base::Instant now);

  /// @param fingerprint  of a certificate whose key the client has proved to have
  /// @return the user, valid as long as this object; null if it is nobody's
  [[nodiscard]] const User* findByCertificate(std::string_view fingerprint) const;

 private:
  struct Attempts {
    int wrong = 0;
    base::Instant lockedUntil{};
  };

  UserManagement m_management;
  std::map<std::string, Attempts> m_attempts;  ///< by user; all unknown names share one, ""
};

}  // namespace rivulet::machine
