// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What has been found out about one machine and stays true between runs, and what it permits.
/// A machine is identified by its endpoint and by its server's application URI.
/// @threadsafety plain values, pure functions.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "opcua/server_identity.h"
#include "streaming/setup/calibration_record.h"
#include "streaming/setup/commissioning.h"

namespace rivulet::streaming {

/// A test of method credit and the server it was made with.
struct CreditTest {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string testedAtUtc;  ///< "2026-05-04T09:30:00Z"; given by a caller that has a clock
  std::string toolVersion;
  Commissioning result;
};

/// Failures of the file that keeps the facts.
enum class MachineFileError {
  NotAMachineFile = 1,  ///< another kind of file
  OtherVersion,         ///< written by another version of Rivulet
  Damaged,              ///< a value is missing or of another type
};

[[nodiscard]] std::error_code make_error_code(MachineFileError code);

/// "Rivulet virtual machine 0.1.0 dmu75".
[[nodiscard]] std::string versionText(const opcua::ServerIdentity& server);

/// Whether method credit may run on a machine.
/// @param test  the last one made there @param now  what the server reports about itself
/// @return NotCommissioned: no test was made, it failed, or it was made with another version of
///         the server
[[nodiscard]] base::Result<void> requireCreditTest(const std::optional<CreditTest>& test,
                                                   const std::string& endpoint,
                                                   const opcua::ServerIdentity& now);

}  // namespace rivulet::streaming

template <>
struct std::is_error_code_enum<rivulet::streaming::MachineFileError> : std::true_type {};
