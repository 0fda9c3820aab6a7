// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/user_folders.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace rivulet::folders {

namespace fs = std::filesystem;

namespace {

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return {value == nullptr ? "" : value};
}

fs::path folder(const char* name, const char* belowHome) {
  const fs::path chosen = variable(name);
  return chosen.is_absolute() ? chosen : variable("HOME") / belowHome;
}

}  // namespace

fs::path dataHome() {
  return folder("XDG_DATA_HOME", ".local/share");
}

fs::path configHome() {
  return folder("XDG_CONFIG_HOME", ".config");
}

fs::path stateHome() {
  return folder("XDG_STATE_HOME", ".local/state");
}

std::filesystem::path moveAside(const std::filesystem::path& file) {
  std::filesystem::path target = file;
  target += ".damaged";
  std::error_code failed;
  for (int number = 2; std::filesystem::exists(target, failed); ++number) {
    target = file;
    target += ".damaged-" + std::to_string(number);
  }
  std::filesystem::rename(file, target, failed);
  return failed ? std::filesystem::path() : target;
}

}  // namespace rivulet::folders
