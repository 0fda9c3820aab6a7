// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A connection on which nothing is sent, from an address of this computer of the test's choice.
/// @threadsafety one thread.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/contract.h"
#include "opcua/security.h"

namespace rivulet::tests {

class IdleConnection {
 public:
  /// @param endpoint  of a server on 127.0.0.1  @param from  "127.0.0.2"
  IdleConnection(const std::string& endpoint, const std::string& from)
      : m_socket(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const sockaddr_in own = addressOf(from, 0);
    const sockaddr_in server = addressOf("127.0.0.1", opcua::portOf(endpoint));
    RIVULET_ASSERT(bind(m_socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0 &&
                   connect(m_socket, reinterpret_cast<const sockaddr*>(&server), sizeof server) ==
                       0);
  }
  ~IdleConnection() { close(m_socket); }
  IdleConnection(const IdleConnection&) = delete;
  IdleConnection& operator=(const IdleConnection&) = delete;

  /// The server has not closed it.
  [[nodiscard]] bool isOpen() const {
    char byte = 0;
    return recv(m_socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) < 0 &&
           (errno == EAGAIN || errno == EWOULDBLOCK);
  }

 private:
  static sockaddr_in addressOf(const std::string& text, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    RIVULET_ASSERT(inet_pton(AF_INET, text.c_str(), &address.sin_addr) == 1);
    return address;
  }

  int m_socket;
};

class IdleConnections {
 public:
  void open(const std::string& endpoint, const std::string& from, int count) {
    for (int i = 0; i < count; ++i) {
      m_all.push_back(std::make_unique<IdleConnection>(endpoint, from));
    }
  }
  [[nodiscard]] std::size_t stillOpen() const {
    return static_cast<std::size_t>(
        std::count_if(m_all.begin(), m_all.end(), [](const auto& each) { return each->isOpen(); }));
  }

 private:
  std::vector<std::unique_ptr<IdleConnection>> m_all;
};

}  // namespace rivulet::tests
