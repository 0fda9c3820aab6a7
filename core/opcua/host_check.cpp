// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/host_check.h"

#include <fmt/format.h>

#include "opcua/error.h"
#include "opcua/name_lookup.h"
#include "opcua/security.h"

namespace rivulet::opcua {

base::Result<void> requireHost(const std::string& endpoint) {
  if (!hasRoomForSocket()) {
    return base::fail(LinkError::NoHandles,
                      "Cannot connect: too many files and connections are open on this computer. "
                      "Close other programs, or raise the limit (ulimit -n), then try again.",
                      endpoint);
  }
  const std::string host = hostOf(endpoint);
  if (host.empty() || endpoint.find("://") == std::string::npos) {
    return {};
  }
  const NameLookup known = lookUpName(host);
  if (known == NameLookup::Found) {
    return {};
  }
  return base::fail(
      LinkError::HostUnknown,
      fmt::format("Cannot connect: {} Give the IP address of the control instead of its name.",
                  known == NameLookup::Unknown
                      ? fmt::format("no computer is called {}. Check the spelling.", host)
                      : fmt::format("the name {} cannot be looked up, because no name server "
                                    "(DNS) answers. Check the network.",
                                    host)),
      endpoint);
}

}  // namespace rivulet::opcua
