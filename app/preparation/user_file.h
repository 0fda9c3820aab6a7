// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The users that were set up in the window (docs/formats.md), for the window and for services.
/// @threadsafety reads a file; shares nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "permission/permission.h"

namespace rivulet::preparation {

/// Of PBKDF2 with SHA-256, for the hash of a PIN.
inline constexpr int kPinIterations = 200'000;

struct KeptUser {
  std::string name;
  permission::Role role = permission::Role::Operator;
  std::string saltHex;
  std::string hashHex;  ///< of the PIN: PBKDF2 with SHA-256; empty: no PIN
};

struct UserFile {
  std::vector<KeptUser> users;  ///< none: nobody is set up
  int idleMinutes = 0;          ///< without input until a window locks itself; 0: never
};

/// $XDG_CONFIG_HOME/rivulet/users.json, or below ~/.config.
[[nodiscard]] std::filesystem::path userFileOfUser();

/// A file that does not exist has no users. @return Unreadable; invalid_argument: it is damaged, or
/// no user is an engineer
[[nodiscard]] base::Result<UserFile> readUsers(const std::filesystem::path& path);

}  // namespace rivulet::preparation
