// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The link that a command uses: a control over OPC UA, or a virtual machine in virtual time.
/// @threadsafety main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "machine/config.h"
#include "opcua/connection.h"

namespace rivulet::cli {

using opcua::Connection;

/// How every command connects; options of the program itself.
struct ConnectionOptions {
  std::string security;         ///< "strongest", "none", ...; empty: as remembered for the server
  std::string fingerprint;      ///< of the server's certificate that is accepted
  std::string user;             ///< empty: anonymous
  std::string passwordFile;     ///< empty: asked for, or from the environment
  std::string userCertificate;  ///< file, instead of user and password; empty: none
  std::string userKey;          ///< file of its key; empty: that of the certificate
  std::string mapFile;          ///< of a control that is no SINUMERIK; empty: it is one
  opcua::LinkKind link = opcua::LinkKind::Open62541;
};

/// For all connections from now on.
void setConnectionOptions(const ConnectionOptions& options);

/// Says on standard error if the connection is not protected, and what its map does not name. Asks
/// on the terminal about the certificate of a server that is not known.
/// @param endpoint  "opc.tcp://host:port"
[[nodiscard]] base::Result<Connection> connectTo(const std::string& endpoint);
/// The same with this map, whatever file was named.
[[nodiscard]] base::Result<Connection> connectTo(const std::string& endpoint,
                                                 std::shared_ptr<const opcua::ControlMap> map);

/// @param preset  name or file
[[nodiscard]] base::Result<Connection> simulate(const std::string& preset, std::uint64_t seed);
[[nodiscard]] Connection simulate(machine::MachineConfig config, const std::string& name,
                                  std::uint64_t seed);

}  // namespace rivulet::cli
