// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <winsock2.h>
#include <ws2tcpip.h>

#include <algorithm>
#include <array>

#include "machine/front/clients.h"

namespace rivulet::machine {

std::string networkOf(std::string_view address) {
  const std::string text(address);
  in6_addr parsed{};
  if (inet_pton(AF_INET6, text.c_str(), &parsed) != 1) {
    return text;
  }
  std::array<char, INET6_ADDRSTRLEN> written{};
  if (IN6_IS_ADDR_V4MAPPED(&parsed) != 0) {
    return inet_ntop(AF_INET, &parsed.s6_addr[12], written.data(), written.size());
  }
  std::fill(parsed.s6_addr + 8, parsed.s6_addr + 16, std::uint8_t{0});
  return inet_ntop(AF_INET6, &parsed, written.data(), written.size());
}

}  // namespace rivulet::machine
