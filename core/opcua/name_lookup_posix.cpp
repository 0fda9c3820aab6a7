// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/name_lookup.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace rivulet::opcua {

bool hasRoomForSocket() {
  const int handle = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle >= 0) {
    close(handle);
    return true;
  }
  return errno != EMFILE && errno != ENFILE;
}

NameLookup lookUpName(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (unknown == 0) {
    freeaddrinfo(found);
    return NameLookup::Found;
  }
  return unknown == EAI_NONAME || unknown == EAI_NODATA ? NameLookup::Unknown
                                                        : NameLookup::NoAnswer;
}

}  // namespace rivulet::opcua
