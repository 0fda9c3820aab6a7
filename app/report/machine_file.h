// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How the files that belong to one machine are named: its calibration and its profile.
/// @threadsafety pure.
#pragma once

#include <string>

#include "opcua/server_identity.h"

namespace rivulet::report {

/// A machine is told from others by its endpoint and its server's application URI. Readable, and
/// never the same for two machines.
[[nodiscard]] std::string machineFileName(const std::string& endpoint,
                                          const opcua::ServerIdentity& server);

}  // namespace rivulet::report
