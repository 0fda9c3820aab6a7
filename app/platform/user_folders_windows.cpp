// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>

#include "platform/process.h"
#include "platform/user_folders.h"

namespace rivulet::folders {

namespace fs = std::filesystem;

namespace {

/// The first of the variables that holds an absolute path.
fs::path folder(const std::array<const char*, 2>& names) {
  for (const char* name : names) {
    if (fs::path chosen = platform::variable(name).value_or(""); chosen.is_absolute()) {
      return chosen;
    }
  }
  return {};
}

}  // namespace

fs::path dataHome() {
  return folder({"XDG_DATA_HOME", "LOCALAPPDATA"});
}

fs::path configHome() {
  return folder({"XDG_CONFIG_HOME", "APPDATA"});
}

fs::path stateHome() {
  return folder({"XDG_STATE_HOME", "LOCALAPPDATA"});
}

}  // namespace rivulet::folders
