// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What is known of one machine, as JSON in a file of its own (docs/cli.md names every field): so
/// far whether it has passed the test for method credit. Other parts of the file, known or unknown,
/// are kept as they are. Command line and HMI share the files. @threadsafety pure, but for the
/// files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "opcua/server_identity.h"
#include "streaming/commissioning.h"

namespace rivulet::report {

/// A test of method credit, and what it belongs to.
struct CreditTest {
  std::string endpoint;
  opcua::ServerIdentity server;  ///< in which version
  std::string testedAtUtc;       ///< "2026-05-04T09:30:00Z"; given by whoever has a clock
  std::string toolVersion;
  streaming::Commissioning result;
};

/// The text of a profile with this test in it. @param text  of the profile so far; empty: none
/// @return NotATrace: the text is no profile; NewerVersion: of a later Rivulet
[[nodiscard]] base::Result<std::string> withCreditTest(std::string_view text,
                                                       const CreditTest& test,
                                                       const std::string& origin = {});
/// The test in a profile; nothing if none was made. @return as `withCreditTest`
[[nodiscard]] base::Result<std::optional<CreditTest>> creditTestOf(std::string_view text,
                                                                   const std::string& origin = {});

/// The folder of the profiles: in $XDG_CONFIG_HOME, or else ~/.config.
[[nodiscard]] std::filesystem::path profileFolder();
/// The file of a machine. It is told from others by its endpoint and its server's application URI.
[[nodiscard]] std::filesystem::path profilePath(const std::filesystem::path& folder,
                                                const std::string& endpoint,
                                                const opcua::ServerIdentity& server);
/// Makes the folder where there is none. @return FileNotWritable, and as `withCreditTest`
[[nodiscard]] base::Result<void> saveCreditTest(const std::filesystem::path& folder,
                                                const CreditTest& test);
/// Whether method credit may run on this machine. @return NotCommissioned: the test was not made,
/// not passed, or passed by another version of the server; what the file says
[[nodiscard]] base::Result<void> requireCreditTest(const std::filesystem::path& folder,
                                                   const std::string& endpoint,
                                                   const opcua::ServerIdentity& server);

/// "passed", and every check with what was seen; for `commission --json` and the profile.
[[nodiscard]] std::string creditTestJson(const CreditTest& test);

}  // namespace rivulet::report
