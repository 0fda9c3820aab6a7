// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/listen_once.h"

#include <winsock2.h>
#include <ws2tcpip.h>

#include <memory>
#include <system_error>

namespace rivulet::machine {

namespace {

/// Listens for a moment; a port that another program has is not shared.
/// @return the error of the system, 0 if it worked
[[nodiscard]] int tryToListen(const addrinfo& address) {
  const SOCKET handle = socket(address.ai_family, address.ai_socktype, address.ai_protocol);
  if (handle == INVALID_SOCKET) {
    return WSAGetLastError();
  }
  const bool works = bind(handle, address.ai_addr, static_cast<int>(address.ai_addrlen)) == 0 &&
                     listen(handle, 1) == 0;
  const int error = works ? 0 : WSAGetLastError();
  closesocket(handle);
  return error;
}

}  // namespace

ListenAttempt listenOnce(const std::string& host, std::uint16_t port) {
  WSADATA data{};
  if (const int error = WSAStartup(MAKEWORD(2, 2), &data); error != 0) {
    return {ListenAttempt::Outcome::Refused, std::to_string(error)};
  }
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  const int unresolved = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (unresolved != 0) {
    return {ListenAttempt::Outcome::Unresolved, std::system_category().message(unresolved)};
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, &freeaddrinfo);
  int error = WSAEADDRNOTAVAIL;
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    const int result = tryToListen(*address);
    if (result == WSAEADDRINUSE) {
      return {ListenAttempt::Outcome::PortTaken, {}};
    }
    error = result == 0 ? 0 : (error == 0 ? 0 : result);
  }
  return error == 0 ? ListenAttempt{}
                    : ListenAttempt{ListenAttempt::Outcome::Refused,
                                    std::system_category().message(error)};
}

}  // namespace rivulet::machine
