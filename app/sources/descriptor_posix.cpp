// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/descriptor.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace rivulet::sources {

namespace {

/// A reader that has begun a line gets the rest, or is given up.
constexpr int kRestMs = 50;

}  // namespace

Descriptor::~Descriptor() {
  if (isOpen()) {
    ::close(m_number);
  }
}

bool sendNow(int descriptor, std::string_view line) {
  bool hasBegun = false;
  while (!line.empty()) {
    const ssize_t count = ::send(descriptor, line.data(), line.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count > 0) {
      hasBegun = true;
      line.remove_prefix(static_cast<std::size_t>(count));
    } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
      return false;
    } else if (!hasBegun) {
      return true;
    } else {
      pollfd asked{descriptor, POLLOUT, 0};
      const int ready = ::poll(&asked, 1, kRestMs);
      if (ready == 0 || (ready < 0 && errno != EINTR)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace rivulet::sources
