// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/descriptor.h"

#include <unistd.h>

#include <cerrno>

namespace rivulet::base {

int writeWhole(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return 0;
}

int syncToDisk(int descriptor) {
  const bool failed =
      fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP;
  return failed ? errno : 0;
}

}  // namespace rivulet::base
