// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whether this computer could connect at all. A library that fails to connect says that nothing
/// answers, also when nobody was asked. @threadsafety asks the system; shares nothing.
#pragma once

#include <string>

#include "base/result.h"

namespace rivulet::opcua {

/// Looks the name of the server up, and whether a connection can be opened. Asked before the
/// library, which would ask for the name again and again. Blocks for as long as the system asks its
/// name servers, some seconds if none of them answers; for an address of numbers it asks nobody.
/// @param endpoint  as typed; of one that is no address the library says so
/// @return HostUnknown, NoHandles
[[nodiscard]] base::Result<void> requireHost(const std::string& endpoint);

}  // namespace rivulet::opcua
