// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which server answers, and its version: a measurement on one server need not hold for another.
/// @threadsafety plain values.
#pragma once

#include <string>

namespace rivulet::opcua {

/// As reported by the server; empty if it reports nothing.
/// @source OPC UA part 5: Server.ServerArray[0], Server.ServerStatus.BuildInfo
struct ServerIdentity {
  std::string applicationUri;
  std::string productName;
  std::string softwareVersion;
  std::string buildNumber;  ///< of the virtual machine: its preset

  friend bool operator==(const ServerIdentity&, const ServerIdentity&) = default;
};

}  // namespace rivulet::opcua
