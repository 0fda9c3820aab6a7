// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machines that a server describes by OPC 40001-1 and 40501-1, for a person and as JSON.
/// @threadsafety as the connection.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "opcua/connection.h"
#include "opcua/machinery.h"

namespace rivulet::cli {

/// Nothing if the server cannot be browsed; what cannot be read is left out.
[[nodiscard]] std::vector<opcua::DescribedMachine> describedMachines(
    const opcua::Connection& connection);

/// One line for each thing that a machine says of itself, then an empty line; nothing without one.
void printMachines(const std::vector<opcua::DescribedMachine>& machines);
[[nodiscard]] nlohmann::ordered_json machinesAsJson(
    const std::vector<opcua::DescribedMachine>& machines);

}  // namespace rivulet::cli
