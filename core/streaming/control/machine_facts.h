// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What has been found out about one machine and stays true between runs, and what it permits.
/// A machine is identified by its endpoint and by its server's application URI.
/// @threadsafety plain values, pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "opcua/server_identity.h"
#include "streaming/setup/calibration_record.h"
#include "streaming/setup/commissioning.h"
#include "streaming/setup/feed_test.h"
#include "streaming/setup/job_test.h"

namespace rivulet::streaming {

/// A test of a control and the server it was made with.
template <class Result>
struct TestOfControl {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string testedAtUtc;  ///< "2026-05-04T09:30:00Z"; given by a caller that has a clock
  std::string toolVersion;
  Result result;
};

using CreditTest = TestOfControl<Commissioning>;
using FeedTest = TestOfControl<FeedCommissioning>;
using JobTest = TestOfControl<JobCommissioning>;

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

/// What is known of the feed cell on a control.
enum class FeedProof {
  Proved,  ///< its axes have been seen to obey, or it is a virtual machine
  NotTested,
  OtherServer,  ///< tested with another version of its server
  Failed,
  WithoutMotion,  ///< passed, but no axis has moved: whether they obey was not seen
};

/// @param test  the last one made there  @param now  what the server reports about itself
/// @param isVirtualMachine  these obey by construction, unless a test has failed
[[nodiscard]] FeedProof feedProof(const std::optional<FeedTest>& test,
                                  const opcua::ServerIdentity& now, bool isVirtualMachine);

/// How far a run may lift the tool there, mm, after the same test; a virtual machine: as far as a
/// program can ask.
[[nodiscard]] double provedLiftMm(const std::optional<FeedTest>& test,
                                  const opcua::ServerIdentity& now, bool isVirtualMachine);

/// "This control has not been tested.": why a stop is not promised by the feed cell; Proved: empty.
[[nodiscard]] std::string_view describe(FeedProof proof);

/// Which whole jobs may run on a machine. All on virtual machines, whose wrong motion does no harm,
/// and on LinuxCNC, against which they are tested; elsewhere those whose blocks its test has tried.
class JobRelease {
 public:
  /// All of them: no machine is known yet.
  JobRelease() = default;
  /// @param test  the last one made there  @param now  what the server reports about itself
  JobRelease(const std::optional<JobTest>& test, std::string endpoint,
             const opcua::ServerIdentity& now, bool isVirtualMachine);

  /// Whether any may.
  [[nodiscard]] bool runsJobs() const { return m_whyNone.empty(); }
  /// Why none may, one sentence; empty: some may.
  [[nodiscard]] const std::string& whyNone() const { return m_whyNone; }
  /// The first block that the test has not tried; null: there is none. @pre runsJobs()
  [[nodiscard]] const job::NativeBlock* firstUntried(const job::Plan& plan) const;
  /// @return NotCommissioned: none may, or the first block that the test has not tried, with its
  /// line
  [[nodiscard]] base::Result<void> require(const job::Plan& plan) const;

 private:
  bool m_isUnlimited = true;
  std::string m_whyNone;
  std::string m_endpoint;
  JobCommissioning m_tested;
};

}  // namespace rivulet::streaming

template <>
struct std::is_error_code_enum<rivulet::streaming::MachineFileError> : std::true_type {};
