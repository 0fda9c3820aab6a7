// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/password.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "opcua/error.h"
#include "platform/process.h"
#include "platform/terminal.h"
#include "trust/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;

namespace {

/// A line feed at the end belongs to the file, not to the password.
std::string firstLine(std::string text) {
  text.erase(std::min(text.find('\n'), text.size()));
  return text;
}

std::optional<fs::path> systemdCredential() {
  const std::optional<std::string> folder = platform::variable("CREDENTIALS_DIRECTORY");
  const fs::path path = folder ? fs::path(*folder) / "rivulet-password" : fs::path();
  std::error_code status;
  return folder && fs::exists(path, status) ? std::optional(path) : std::nullopt;
}

}  // namespace

base::Result<std::string> askForPassword(const std::string& question, const std::string& option) {
  std::string password;
  if (!platform::askInSecret(question, password)) {
    return base::fail(opcua::LinkError::LoginRefused,
                      fmt::format("There is no password and no terminal to ask for it. Give it "
                                  "{}in RIVULET_PASSWORD, or as the systemd credential "
                                  "rivulet-password.",
                                  option.empty() ? "" : "in a file (" + option + "), "));
  }
  return password;
}

base::Result<std::optional<std::string>> givenPassword(const fs::path& file) {
  std::optional<fs::path> path = systemdCredential();
  if (!file.empty()) {
    path = file;
  } else if (const auto variable = platform::variable("RIVULET_PASSWORD")) {
    return variable;
  }
  if (!path) {
    return std::nullopt;
  }
  auto text = readPrivateFile(*path);
  if (!text) {
    return base::fail(text.error());
  }
  return firstLine(std::move(*text));
}

base::Result<std::string> readPassword(const fs::path& file, const std::string& question,
                                       const std::string& option) {
  auto given = givenPassword(file);
  if (!given) {
    return base::fail(given.error());
  }
  return *given ? base::Result<std::string>(std::move(**given)) : askForPassword(question, option);
}

}  // namespace rivulet::trust
