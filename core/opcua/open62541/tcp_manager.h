// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The part of the library that sends and receives on sockets. Whoever replaces one of its
/// functions leaves a pointer to itself there. @threadsafety as the event loop.
#pragma once

#include <open62541/plugin/eventloop.h>

namespace rivulet::opcua {

/// The manager of an event loop's TCP connections, with its owner noted.
/// @return null: there is none, or no memory
[[nodiscard]] UA_ConnectionManager* ownedTcpManager(UA_EventLoop& loop, void* owner);

/// The manager of an event loop's TCP connections; null: there is none.
[[nodiscard]] UA_ConnectionManager* tcpManagerOf(UA_EventLoop& loop);

/// The owner that `ownedTcpManager` has noted.
[[nodiscard]] void* ownerOf(const UA_ConnectionManager& manager);

}  // namespace rivulet::opcua
