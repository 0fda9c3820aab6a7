// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/user_folders.h"

#include <string>
#include <system_error>

namespace rivulet::folders {

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
