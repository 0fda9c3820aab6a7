// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/listen_once.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

namespace rivulet::machine {

namespace {

/// Listens for a moment. @return errno, 0 if it worked
[[nodiscard]] int tryToListen(const addrinfo& address) {
  const int descriptor = socket(address.ai_family, address.ai_socktype, address.ai_protocol);
  if (descriptor < 0) {
    return errno;
  }
  int on = 1;
  setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  const bool works =
      bind(descriptor, address.ai_addr, address.ai_addrlen) == 0 && listen(descriptor, 1) == 0;
  const int error = works ? 0 : errno;
  close(descriptor);
  return error;
}

}  // namespace

ListenAttempt listenOnce(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int unresolved = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (unresolved != 0) {
    return {ListenAttempt::Outcome::Unresolved, gai_strerror(unresolved)};
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, &freeaddrinfo);
  int error = EADDRNOTAVAIL;
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    const int result = tryToListen(*address);
    if (result == EADDRINUSE) {
      return {ListenAttempt::Outcome::PortTaken, {}};
    }
    error = result == 0 ? 0 : (error == 0 ? 0 : result);
  }
  return error == 0 ? ListenAttempt{}
                    : ListenAttempt{ListenAttempt::Outcome::Refused, std::strerror(error)};
}

}  // namespace rivulet::machine
