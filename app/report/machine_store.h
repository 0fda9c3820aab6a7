// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The one store of facts about machines: one JSON file per machine, all in one folder, shared by
/// command line and HMI (docs/cli.md names every field). Files are replaced as a whole; members
/// that this version does not know are kept. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "base/result.h"
#include "base/utc.h"
#include "job/functions.h"
#include "streaming/control/machine_facts.h"
#include "streaming/control/machine_profile.h"

namespace rivulet::report {

struct MachineFolders {
  std::filesystem::path machines;
  /// Where earlier versions kept calibrations and profiles. Read while a machine has no file in
  /// `machines` yet; never written. Empty: none.
  std::filesystem::path earlierCalibrations;
  std::filesystem::path earlierProfiles;

  /// @param data  e.g. ~/.local/share  @param config  e.g. ~/.config
  [[nodiscard]] static MachineFolders below(const std::filesystem::path& data,
                                            const std::filesystem::path& config);
  /// Below $XDG_DATA_HOME (or ~/.local/share) and $XDG_CONFIG_HOME (or ~/.config).
  [[nodiscard]] static MachineFolders ofUser();
};

/// A machine of which the store knows something.
struct KnownMachine {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string name;  ///< as its profile has it; may be empty
  bool hasLimits = false;
  bool hasCalibration = false;
  bool hasCreditTest = false;
  bool hasFeedTest = false;
  bool hasJobTest = false;
};

class MachineStore {
 public:
  explicit MachineStore(MachineFolders folders = MachineFolders::ofUser())
      : m_folders(std::move(folders)) {}

  /// The file of a machine: readable, and different for every machine.
  [[nodiscard]] std::filesystem::path pathOf(const std::string& endpoint,
                                             const opcua::ServerIdentity& server) const;

  /// The last calibration of this machine; nothing if there is none. `isOutdated` says whether it
  /// still holds. @return FileUnreadable, NotAMachineFile, OtherVersion, Damaged
  [[nodiscard]] base::Result<std::optional<streaming::CalibrationRecord>> calibration(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;
  /// The last test of method credit on this machine; nothing if there is none.
  /// @return as `calibration`
  [[nodiscard]] base::Result<std::optional<streaming::CreditTest>> creditTest(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;

  /// The same of the feed cell.
  [[nodiscard]] base::Result<std::optional<streaming::FeedTest>> feedTest(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;

  /// The same of whole jobs.
  [[nodiscard]] base::Result<std::optional<streaming::JobTest>> jobTest(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;
  /// What that test says about whole jobs there.
  [[nodiscard]] base::Result<streaming::JobRelease> jobRelease(const std::string& endpoint,
                                                               const opcua::ServerIdentity& server,
                                                               bool isVirtualMachine) const;

  /// The limits that were entered for this machine; nothing if there are none.
  /// @return as `calibration`
  [[nodiscard]] base::Result<std::optional<streaming::MachineProfile>> profile(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;
  /// What was said of M functions for this endpoint; none are a machine's that is not known yet.
  [[nodiscard]] job::Functions functions(const std::string& endpoint) const;
  /// What a job has to know of a machine before it is connected. @param endpoint  empty: none
  /// @param isSimulated  nothing moves: M functions that nobody has spoken of are left out
  [[nodiscard]] job::Profile jobProfile(const std::string& endpoint, bool isSimulated) const;
  /// All machines with a file of their own, sorted by endpoint; files that cannot be read are left
  /// out.
  [[nodiscard]] std::vector<KnownMachine> machines() const;

  /// Puts all that is known of a machine aside: its files are renamed (`.removed`), not deleted.
  /// @param at  now  @return NotWritable
  [[nodiscard]] base::Result<void> remove(const std::string& endpoint, base::UtcMs at) const;
  /// When machines were removed, by endpoint.
  [[nodiscard]] std::map<std::string, base::UtcMs> removed() const;

  /// Makes the folder if it is missing. @return FileNotWritable, and as `calibration`: a file that
  /// cannot be read is not overwritten
  [[nodiscard]] base::Result<void> save(const streaming::CalibrationRecord& record) const;
  [[nodiscard]] base::Result<void> save(const streaming::CreditTest& test) const;
  [[nodiscard]] base::Result<void> save(const streaming::FeedTest& test) const;
  [[nodiscard]] base::Result<void> save(const streaming::JobTest& test) const;
  [[nodiscard]] base::Result<void> save(const streaming::MachineProfile& profile) const;
  [[nodiscard]] base::Result<void> save(const std::string& endpoint,
                                        const opcua::ServerIdentity& server,
                                        const job::Functions& functions) const;

 private:
  /// For as long as a file is read, changed and written: another program of this user may do the
  /// same. Makes the folder if it is missing.
  [[nodiscard]] base::Result<base::FileLock> lock() const;
  [[nodiscard]] base::Result<nlohmann::ordered_json> read(
      const std::string& endpoint, const opcua::ServerIdentity& server) const;
  /// A test that the file keeps under this key; nothing: none.
  template <class Test>
  [[nodiscard]] base::Result<std::optional<Test>> test(
      const std::string& endpoint, const opcua::ServerIdentity& server, const char* key,
      Test (*testOf)(const nlohmann::ordered_json&)) const;
  /// Makes a member of the file from the one that was there; null: none.
  using Make = std::function<nlohmann::ordered_json(const nlohmann::ordered_json& was)>;
  [[nodiscard]] base::Result<void> saveMember(const std::string& endpoint,
                                              const opcua::ServerIdentity& server, const char* key,
                                              const Make& make) const;

  MachineFolders m_folders;
};

}  // namespace rivulet::report
