// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which servers a discovery server of OPC UA knows, and how it gets to know one. A server that is
/// none knows itself. Nothing of the answer is trusted: it says where to connect, not with whom.
/// @threadsafety each call by itself; it waits.
#pragma once

#include <string>
#include <vector>

#include "base/instant.h"
#include "base/result.h"

namespace rivulet::opcua {

struct FoundServer {
  std::string name;
  std::string applicationUri;  ///< of this server alone
  std::string productUri;
  std::vector<std::string> addresses;  ///< "opc.tcp://…", as it says itself
};

/// Asks once, without encryption. @param address  "opc.tcp://host:4840"
/// @param deadline  of each answer @return NotReachable and other errors of connecting
[[nodiscard]] base::Result<std::vector<FoundServer>> findServers(const std::string& address,
                                                                 base::Duration deadline);

/// Tells a discovery server once that a server is there, or not any more. Without encryption: one
/// that demands it refuses. @param server  with one address @return NotReachable, Rejected, ...
[[nodiscard]] base::Result<void> registerServer(const std::string& address,
                                                const FoundServer& server, bool isOnline,
                                                base::Duration deadline);

}  // namespace rivulet::opcua
