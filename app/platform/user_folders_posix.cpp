// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/process.h"
#include "platform/user_folders.h"

namespace rivulet::folders {

namespace fs = std::filesystem;

namespace {

fs::path folder(const char* name, const char* belowHome) {
  const fs::path chosen = platform::variable(name).value_or("");
  return chosen.is_absolute() ? chosen
                              : fs::path(platform::variable("HOME").value_or("")) / belowHome;
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

}  // namespace rivulet::folders
