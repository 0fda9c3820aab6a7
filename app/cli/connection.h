// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The link that a command uses: a control over OPC UA, or a virtual machine in virtual time.
/// @threadsafety main thread.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "machine/config.h"
#include "opcua/connection.h"

namespace rivulet::cli {

using opcua::Connection;

/// @param endpoint  "opc.tcp://host:port"
[[nodiscard]] base::Result<Connection> connectTo(const std::string& endpoint);

/// @param preset  name or file
[[nodiscard]] base::Result<Connection> simulate(const std::string& preset, std::uint64_t seed);
[[nodiscard]] Connection simulate(machine::MachineConfig config, const std::string& name,
                                  std::uint64_t seed);

/// From now on Ctrl-C, SIGTERM, SIGHUP and SIGXFSZ do not end the program; `wasInterrupted` reports
/// them.
void watchForInterrupt();
[[nodiscard]] bool wasInterrupted();

/// Whether standard error is read by a person.
[[nodiscard]] bool isTerminal();

}  // namespace rivulet::cli
