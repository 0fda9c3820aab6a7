// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How long the system tries to send. @threadsafety as the connection.
#pragma once

#include <cstdint>

namespace rivulet::opcua {

/// The system ends the connection if nothing was confirmed on it for so long.
/// @param socket  as the library numbers connections
void endWhenUnconfirmed(std::uintptr_t socket, unsigned milliseconds);

}  // namespace rivulet::opcua
