// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Checks user names, passwords and certificates. Wrong ones lock a user for whoever has sent them:
/// the address they came from. Others, and the same user elsewhere, are not kept out.
/// @threadsafety as the server.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/instant.h"
#include "machine/front/login_failure.h"
#include "machine/user.h"

namespace rivulet::machine {

/// So many wrong passwords in a row from one address lock a user there...
inline constexpr int kWrongPasswordsMax = 5;
/// ...for so long. A right password is refused as well meanwhile, so guessing tells nothing.
inline constexpr base::Duration kLockTime = std::chrono::seconds(60);
/// Each further wrong one locks twice as long, up to this.
inline constexpr base::Duration kLockTimeMax = std::chrono::hours(1);
/// Wrong ones are forgotten after a right one, or after this time.
inline constexpr base::Duration kWrongRemembered = std::chrono::hours(24);
/// So many users and addresses are remembered; then the oldest are forgotten.
inline constexpr std::size_t kAttemptsMax = 10'000;

class Login {
 public:
  explicit Login(UserManagement management) : m_management(std::move(management)) {}

  [[nodiscard]] bool letsAnonymousIn() const { return m_management.anonymous; }
  /// Somebody can log in with name and password.
  [[nodiscard]] bool takesPasswords() const;
  /// Somebody can log in by certificate.
  [[nodiscard]] bool takesCertificates() const;

  struct Outcome {
    /// Valid as long as this object; null: name or password are wrong, or the user is locked.
    const User* user = nullptr;
    std::optional<LoginFailure> failure;  ///< nothing while the user is locked
  };

  /// @param network  where the login comes from
  [[nodiscard]] Outcome check(std::string_view name, std::string_view password,
                              const std::string& network, base::Instant now);

  /// @param fingerprint  of a certificate whose key the client has proved to have
  /// @return the user, valid as long as this object; null if it is nobody's
  [[nodiscard]] const User* findByCertificate(std::string_view fingerprint) const;

 private:
  struct Attempts {
    int wrong = 0;
    base::Instant lockedUntil{};
    base::Instant last{};
  };

  void forgetOld(base::Instant now);

  UserManagement m_management;
  /// By user and network; all unknown names share the user "".
  std::map<std::pair<std::string, std::string>, Attempts> m_attempts;
};

}  // namespace rivulet::machine
