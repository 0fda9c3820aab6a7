// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/name_lookup.h"

#include <winsock2.h>
#include <ws2tcpip.h>

namespace rivulet::opcua {

namespace {

/// Sockets of the system, for as long as this lives.
class Sockets {
 public:
  Sockets() : m_areThere(WSAStartup(MAKEWORD(2, 2), &m_data) == 0) {}
  ~Sockets() {
    if (m_areThere) {
      WSACleanup();
    }
  }
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;

 private:
  WSADATA m_data{};
  bool m_areThere;
};

}  // namespace

bool hasRoomForSocket() {
  const Sockets sockets;
  const SOCKET handle = socket(AF_INET, SOCK_STREAM, 0);
  if (handle != INVALID_SOCKET) {
    closesocket(handle);
    return true;
  }
  return WSAGetLastError() != WSAEMFILE && WSAGetLastError() != WSAENOBUFS;
}

NameLookup lookUpName(const std::string& host) {
  const Sockets sockets;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (unknown == 0) {
    freeaddrinfo(found);
    return NameLookup::Found;
  }
  return unknown == WSAHOST_NOT_FOUND || unknown == WSANO_DATA ? NameLookup::Unknown
                                                               : NameLookup::NoAnswer;
}

}  // namespace rivulet::opcua
