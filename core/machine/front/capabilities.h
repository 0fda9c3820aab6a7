// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the server says of itself in its object ServerCapabilities (OPC 10000-5, 6.3.2): the limits
/// that hold, and no service that it refuses. @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <cstdint>

namespace rivulet::machine {

/// Limits that are not in the configuration of the library.
struct StatedLimits {
  std::uint32_t sessionsMax = 0;          ///< that are logged in
  std::uint32_t arrayLengthMax = 0;       ///< elements of a variable; 0: there are no arrays
  std::uint32_t byteStringLengthMax = 0;  ///< bytes
};

/// The library states some limits of its configuration. This adds the others, and takes away what
/// the library claims for every server: history, changes of the nodes, 50 sessions.
/// @param server  with its final configuration
[[nodiscard]] UA_StatusCode stateCapabilities(UA_Server* server, const StatedLimits& limits);

}  // namespace rivulet::machine
