// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/port_owner.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace rivulet::platform {

namespace {

// Columns of /proc/net/tcp and udp, as proc(5) has them.
constexpr std::size_t kLocalAddress = 1;
constexpr std::size_t kState = 3;
constexpr std::size_t kUser = 7;
constexpr const char* kListens = "0A";

/// @return whether the list could be read
bool addOwners(const std::filesystem::path& list, bool listenersOnly, std::uint16_t port,
               std::set<UserNumber>& owners) {
  std::ifstream stream(list);
  std::string line;
  if (!std::getline(stream, line)) {  // titles
    return false;
  }
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::vector<std::string> columns;
    for (std::string word; columns.size() <= kUser && words >> word;) {
      columns.push_back(std::move(word));
    }
    if (columns.size() <= kUser || (listenersOnly && columns[kState] != kListens)) {
      continue;
    }
    const std::string& local = columns[kLocalAddress];
    const std::string& user = columns[kUser];
    unsigned number = 0;
    UserNumber owner = 0;
    constexpr int kHex = 16;
    const std::size_t colon = local.rfind(':') + 1;
    const bool isRead =
        std::from_chars(local.data() + colon, local.data() + local.size(), number, kHex).ec ==
            std::errc() &&
        std::from_chars(user.data(), user.data() + user.size(), owner).ec == std::errc();
    if (isRead && number == port) {
      owners.insert(owner);
    }
  }
  return true;
}

}  // namespace

std::optional<std::set<UserNumber>> ownersOfPort(PortKind kind, std::uint16_t port,
                                                 const std::filesystem::path& table) {
  const bool isTcp = kind == PortKind::TcpListener;
  std::set<UserNumber> owners;
  const bool isRead = addOwners(table / (isTcp ? "tcp" : "udp"), isTcp, port, owners);
  // A computer without IPv6 has no second list.
  addOwners(table / (isTcp ? "tcp6" : "udp6"), isTcp, port, owners);
  return isRead ? std::optional(std::move(owners)) : std::nullopt;
}

bool isPortOfAnother(PortKind kind, std::uint16_t port, const std::filesystem::path& table) {
  const auto owners = ownersOfPort(kind, port, table);
  return owners && std::any_of(owners->begin(), owners->end(),
                               [](UserNumber owner) { return owner != 0 && owner != geteuid(); });
}

}  // namespace rivulet::platform
