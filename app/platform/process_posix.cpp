// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/process.h"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace rivulet::platform {

std::string userName() {
  const passwd* user = getpwuid(getuid());
  return user != nullptr ? user->pw_name : std::to_string(getuid());
}

std::string hostName() {
  constexpr std::size_t kHostNameMax = 256;
  std::array<char, kHostNameMax> host{};
  return gethostname(host.data(), host.size() - 1) == 0 ? host.data() : std::string();
}

int processId() {
  return getpid();
}

std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::optional<std::string>(value) : std::nullopt;
}

std::vector<std::string> arguments(int argc, const char* const* argv) {
  return {argv, argv + argc};
}

}  // namespace rivulet::platform
