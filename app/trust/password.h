// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a password comes from, in this order: a file that only its owner can read, the variable
/// RIVULET_PASSWORD, the credential "rivulet-password" of systemd, the terminal. Never the command
/// line, which every user of the computer can read. @threadsafety main thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"

namespace rivulet::trust {

/// A password that is given without asking anybody; nothing if there is none.
/// @param file  empty: none  @return error Unreadable
[[nodiscard]] base::Result<std::optional<std::string>> givenPassword(
    const std::filesystem::path& file);

/// What a program names as the option for a file with the password; empty: it has none.
inline constexpr const char* kPasswordFileOption = "--password-file";

/// @param file  empty: none  @param question  for the terminal, "Password of setter: "
/// @param option  of this program, for the sentence that says where a password can be given
/// @return error Unreadable; LoginRefused if there is no password and nobody to ask
[[nodiscard]] base::Result<std::string> readPassword(const std::filesystem::path& file,
                                                     const std::string& question,
                                                     const std::string& option);

/// Asks on the terminal without showing what is typed. @param option  as for `readPassword`
/// @return LoginRefused if there is none
[[nodiscard]] base::Result<std::string> askForPassword(const std::string& question,
                                                       const std::string& option);

}  // namespace rivulet::trust
