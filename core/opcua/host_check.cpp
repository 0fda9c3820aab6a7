// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/host_check.h"

#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

#include "opcua/error.h"
#include "opcua/security.h"

namespace rivulet::opcua {

base::Result<void> requireHost(const std::string& endpoint) {
  const int handle = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle >= 0) {
    close(handle);
  } else if (errno == EMFILE || errno == ENFILE) {
    return base::fail(LinkError::NoHandles,
                      "Cannot connect: too many files and connections are open on this computer. "
                      "Close other programs, or raise the limit (ulimit -n), then try again.",
                      endpoint);
  }

  const std::string host = hostOf(endpoint);
  if (host.empty() || endpoint.find("://") == std::string::npos) {
    return {};
  }
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (unknown == 0) {
    freeaddrinfo(found);
    return {};
  }
  const bool hasAnswer = unknown == EAI_NONAME || unknown == EAI_NODATA;
  return base::fail(
      LinkError::HostUnknown,
      fmt::format("Cannot connect: {} Give the IP address of the control instead of its name.",
                  hasAnswer ? fmt::format("no computer is called {}. Check the spelling.", host)
                            : fmt::format("the name {} cannot be looked up, because no name server "
                                          "(DNS) answers. Check the network.",
                                          host)),
      endpoint);
}

}  // namespace rivulet::opcua
