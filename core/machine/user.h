// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who may log in to the virtual machine and with which rights, as a preset lists them. The rights
/// are named as on a SINUMERIK (Access MyMachine /OPC UA). @threadsafety pure.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rivulet::machine {

/// A password that cannot be read back.
struct HashedPassword {
  int iterations = 0;
  std::string salt;
  std::string hash;  ///< `base::passwordHashHex`
};

struct User {
  std::string name;
  HashedPassword password;  ///< an empty hash: the user has none and logs in by certificate only
  std::set<std::string> rights;  ///< of `userRights`
  /// Fingerprint of the certificate by which the user can log in, too; empty: none.
  std::string certificate = {};
};

struct UserManagement {
  bool anonymous = true;  ///< clients without a user name are let in, with all rights
  std::vector<User> users;
};

/// The rights that a user can be given: "ApWrite" (select a program), "FsRead" and "FsWrite" (part
/// programs), "SinuReadAll" and "SinuWriteAll" (variables), "StateRead" and "StateWrite" (the part
/// of them that a run needs).
[[nodiscard]] const std::set<std::string>& userRights();

/// @param salt  random, another one for every password
[[nodiscard]] HashedPassword hashPassword(std::string_view password, const std::string& salt);
/// As a preset holds it: "pbkdf2-sha256:<iterations>:<salt>:<hash>".
[[nodiscard]] std::string passwordText(const HashedPassword& password);
/// Inverse of `passwordText`; nothing if the text has another form.
[[nodiscard]] std::optional<HashedPassword> passwordOfText(std::string_view text);
/// Takes the same time for every password. Some tens of milliseconds.
[[nodiscard]] bool isPassword(const HashedPassword& hashed, std::string_view password);

}  // namespace rivulet::machine
