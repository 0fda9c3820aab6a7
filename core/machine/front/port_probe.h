// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds out whether a port is free before the library listens on it. The library opens the port as
/// shared, so two machines on one port would answer in turn. Without sharing, it could not restart
/// on a port that was in use a moment ago.
/// @threadsafety pure.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"

namespace rivulet::machine {

/// @param port > 0
/// @return PortTaken, AddressUnusable
[[nodiscard]] base::Result<void> probePort(const std::string& host, std::uint16_t port);

}  // namespace rivulet::machine
