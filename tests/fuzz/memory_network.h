// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// OPC UA within one thread, without sockets and without waiting. A program that links this gets it
/// in place of the library's TCP: messages go from one side's queue to the other's. The monotonic
/// clock is simulated: it stands still while anything is to be done, and jumps when someone waits,
/// so that a deadline of two seconds passes at once.
/// @threadsafety one thread.
#pragma once

#include <functional>
#include <string>

namespace rivulet::tests {

/// What the other side of a connection does while an event loop of the library waits; nothing: both
/// sides are driven by the caller. It may run event loops itself.
void setPartner(std::function<void()> partner);

/// What the network does to the next message of a server; nothing: it arrives as it was sent.
void setDamage(std::function<void(std::string& message)> damage);

}  // namespace rivulet::tests
