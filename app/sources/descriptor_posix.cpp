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

Read readNow(int descriptor, std::span<char> into) {
  // Standard input may be shared with other programs: it is polled, not switched to non-blocking
  // mode.
  pollfd asked{descriptor, POLLIN, 0};
  if (::poll(&asked, 1, 0) <= 0 || asked.revents == 0) {
    return {};
  }
  const ssize_t count = ::read(descriptor, into.data(), into.size());
  if (count > 0) {
    return {static_cast<std::size_t>(count), false};
  }
  return {0, count == 0 || (errno != EAGAIN && errno != EINTR)};
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
