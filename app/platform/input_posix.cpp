// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/input.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace rivulet::platform {

Input readNow(int descriptor, std::span<char> into) {
  pollfd asked{descriptor, POLLIN, 0};
  if (::poll(&asked, 1, 0) <= 0 || asked.revents == 0) {
    return {};
  }
  const ssize_t count = ::read(descriptor, into.data(), into.size());
  if (count > 0) {
    return {static_cast<std::size_t>(count), false, false};
  }
  return {0, count == 0, count < 0 && errno != EAGAIN && errno != EINTR};
}

bool isInputFed() {
  struct stat input {};
  return ::fstat(kStandardInput, &input) == 0 &&
         (S_ISFIFO(input.st_mode) || S_ISREG(input.st_mode) || S_ISSOCK(input.st_mode));
}

}  // namespace rivulet::platform
