// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/machine_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/file.h"
#include "base/hash.h"
#include "base/text.h"
#include "platform/user_folders.h"
#include "report/calibration_json.h"
#include "report/control_test_json.h"
#include "report/json_members.h"
#include "report/known_machine.h"

namespace rivulet::report {
namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;
using streaming::MachineFileError;

constexpr int kMachineFormat = 1;
constexpr const char* kMachineFormatKey = "rivulet_machine";
constexpr const char* kRemovedFormatKey = "rivulet_removed_machines";
constexpr const char* kRemovedFile = "removed.json";
constexpr const char* kCalibrationKey = "calibration";
constexpr const char* kCreditTestKey = "credit_test";
constexpr const char* kFeedTestKey = "feed_test";
constexpr const char* kJobTestKey = "job_test";
constexpr const char* kProfileKey = "profile";
constexpr const char* kFunctionsKey = "m_functions";
/// Files of earlier versions: a calibration by itself, and a profile with a `credit_test`.
constexpr const char* kEarlierCalibrationKey = "rivulet_calibration";
constexpr const char* kEarlierProfileKey = "rivulet_machine_profile";

/// Whether a calibration or a credit test was made on this machine.
bool isOf(const ordered_json& fact, const std::string& endpoint,
          const opcua::ServerIdentity& server) {
  return fact.is_object() && fact.value("endpoint", ordered_json()) == endpoint &&
         fact.contains("server") && fact["server"].is_object() &&
         fact["server"].value("application_uri", ordered_json()) == server.applicationUri;
}

/// The first object in a folder that `pick` finds something in. Names do not matter: earlier
/// versions made them in different ways. What cannot be read is passed over.
template <class Pick>
std::optional<ordered_json> findEarlier(const fs::path& folder, Pick pick) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    const auto file = readJson<ordered_json>(entry.path());
    if (!file || !file->is_object()) {
      continue;
    }
    if (std::optional<ordered_json> found = pick(*file)) {
      return found;
    }
  }
  return std::nullopt;
}

/// {"163": "", "164": "M50", "W": "W"}; what is no such member is passed over.
job::Functions functionsOf(const ordered_json& lines) {
  job::Functions functions;
  for (const auto& [name, line] : lines.items()) {
    const std::optional<job::FunctionName> known = job::functionNameOf(name);
    if (known && line.is_string()) {
      functions[*known] = line.get<std::string>();
    }
  }
  return functions;
}

ordered_json linesJson(const job::Functions& functions) {
  ordered_json lines = ordered_json::object();
  for (const auto& [name, line] : functions) {
    lines[name.axis != 0 ? job::textOf(name) : std::to_string(name.number)] = line;
  }
  return lines;
}

}  // namespace

MachineFolders MachineFolders::below(const fs::path& data, const fs::path& config) {
  return {data / "rivulet" / "machines", data / "rivulet" / "calibrations",
          config / "rivulet" / "machines"};
}

MachineFolders MachineFolders::ofUser() {
  return below(folders::dataHome(), folders::configHome());
}

fs::path MachineStore::pathOf(const std::string& endpoint,
                              const opcua::ServerIdentity& server) const {
  // Many characters of an endpoint must not stand in a file name.
  std::string name;
  for (const char letter : endpoint) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.';
    if (plain || (!name.empty() && name.back() != '-')) {
      name += plain ? letter : '-';
    }
  }
  constexpr std::size_t kNameMax = 100;
  name.resize(std::min(name.size(), kNameMax));
  return m_folders.machines / fmt::format("{}-{:016x}.json", name,
                                          base::hashOf(endpoint + '\n' + server.applicationUri));
}

base::Result<ordered_json> MachineStore::read(const std::string& endpoint,
                                              const opcua::ServerIdentity& server) const {
  const fs::path path = pathOf(endpoint, server);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    ordered_json machine{{kMachineFormatKey, kMachineFormat}};
    const auto own = [&](const ordered_json& fact) { return isOf(fact, endpoint, server); };
    const auto calibration = findEarlier(m_folders.earlierCalibrations, [&](const auto& fact) {
      return fact.contains(kEarlierCalibrationKey) && own(fact) ? std::optional(fact)
                                                                : std::nullopt;
    });
    // The whole profile is taken over: other members of it may be somebody's, too.
    const auto profile = findEarlier(m_folders.earlierProfiles, [&](const auto& fact) {
      return fact.contains(kEarlierProfileKey) && fact.contains(kCreditTestKey) &&
                     own(fact[kCreditTestKey])
                 ? std::optional(fact)
                 : std::nullopt;
    });
    if (profile) {
      machine.update(*profile);
      machine.erase(kEarlierProfileKey);
    }
    if (calibration) {
      machine[kCalibrationKey] = *calibration;
    }
    return machine;
  }
  auto read = readJson<ordered_json>(path);
  if (!read) {
    return base::fail(read.error());
  }
  ordered_json& machine = *read;
  if (!machine.is_object() || !machine.contains(kMachineFormatKey) ||
      !machine[kMachineFormatKey].is_number_integer()) {
    return base::fail(MachineFileError::NotAMachineFile,
                      "This is not a machine file of Rivulet. Move the file away.", path.string());
  }
  if (machine[kMachineFormatKey].get<int>() > kMachineFormat) {
    return base::fail(MachineFileError::OtherVersion,
                      "The machine file was written by a later version of Rivulet. Use that one.",
                      path.string());
  }
  return machine;
}

base::Result<std::optional<streaming::CalibrationRecord>> MachineStore::calibration(
    const std::string& endpoint, const opcua::ServerIdentity& server) const {
  const base::Result<ordered_json> machine = read(endpoint, server);
  if (!machine) {
    return base::fail(machine.error());
  }
  if (!machine->contains(kCalibrationKey)) {
    return std::nullopt;
  }
  auto record = calibrationOf((*machine)[kCalibrationKey], pathOf(endpoint, server).string());
  if (!record) {
    return base::fail(record.error());
  }
  return std::optional(std::move(*record));
}

template <class Test>
base::Result<std::optional<Test>> MachineStore::test(const std::string& endpoint,
                                                     const opcua::ServerIdentity& server,
                                                     const char* key,
                                                     Test (*testOf)(const ordered_json&)) const {
  const base::Result<ordered_json> machine = read(endpoint, server);
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto test = machine->find(key);
  return test == machine->end() || !test->is_object() ? std::nullopt : std::optional(testOf(*test));
}

base::Result<std::optional<streaming::CreditTest>> MachineStore::creditTest(
    const std::string& endpoint, const opcua::ServerIdentity& server) const {
  return test(endpoint, server, kCreditTestKey, creditTestOf);
}

base::Result<std::optional<streaming::FeedTest>> MachineStore::feedTest(
    const std::string& endpoint, const opcua::ServerIdentity& server) const {
  return test(endpoint, server, kFeedTestKey, feedTestOf);
}

base::Result<std::optional<streaming::JobTest>> MachineStore::jobTest(
    const std::string& endpoint, const opcua::ServerIdentity& server) const {
  return test(endpoint, server, kJobTestKey, jobTestOf);
}

base::Result<streaming::JobRelease> MachineStore::jobRelease(const std::string& endpoint,
                                                             const opcua::ServerIdentity& server,
                                                             bool isVirtualMachine) const {
  const auto tested = jobTest(endpoint, server);
  if (!tested) {
    return base::fail(tested.error());
  }
  return streaming::JobRelease(*tested, endpoint, server, isVirtualMachine);
}

base::Result<std::optional<streaming::MachineProfile>> MachineStore::profile(
    const std::string& endpoint, const opcua::ServerIdentity& server) const {
  const base::Result<ordered_json> machine = read(endpoint, server);
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto member = machine->find(kProfileKey);
  if (member == machine->end()) {
    return std::nullopt;
  }
  auto profile = profileOf(*member, pathOf(endpoint, server).string());
  if (!profile) {
    return base::fail(profile.error());
  }
  return std::optional(std::move(*profile));
}

job::Functions MachineStore::functions(const std::string& endpoint) const {
  job::Functions found;
  for (const KnownMachine& machine : machines()) {
    const base::Result<ordered_json> file = machine.endpoint == endpoint
                                                ? read(machine.endpoint, machine.server)
                                                : base::Result<ordered_json>(ordered_json());
    if (file && file->contains(kFunctionsKey) && (*file)[kFunctionsKey].is_object()) {
      found.merge(functionsOf((*file)[kFunctionsKey].value("lines", ordered_json::object())));
    }
  }
  return found;
}

job::Profile MachineStore::jobProfile(const std::string& endpoint, bool isSimulated) const {
  job::Profile profile;
  profile.leavesOutFunctions = isSimulated;
  if (!endpoint.empty()) {
    profile.functions = functions(endpoint);
  }
  return profile;
}

std::vector<KnownMachine> MachineStore::machines() const {
  std::vector<KnownMachine> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folders.machines, ignored)) {
    const ordered_json json = readJson<ordered_json>(entry.path()).value_or(ordered_json::object());
    if (entry.path().extension() != ".json" || !json.is_object() ||
        !json.contains(kMachineFormatKey)) {
      continue;
    }
    // Each fact names its machine; the profile comes first because it has the name.
    for (const char* key :
         {kProfileKey, kCalibrationKey, kCreditTestKey, kFeedTestKey, kJobTestKey, kFunctionsKey}) {
      const auto fact = json.find(key);
      if (fact == json.end() || !fact->is_object() || !fact->contains("endpoint") ||
          !(*fact)["endpoint"].is_string()) {
        continue;
      }
      KnownMachine machine;
      machine.endpoint = (*fact)["endpoint"].get<std::string>();
      const ordered_json server = fact->value("server", ordered_json::object());
      const auto uri = server.find("application_uri");
      machine.server.applicationUri =
          uri != server.end() && uri->is_string() ? uri->get<std::string>() : std::string();
      const auto name = fact->find("name");
      machine.name = key == kProfileKey && name != fact->end() && name->is_string()
                         ? name->get<std::string>()
                         : std::string();
      machine.hasLimits = json.contains(kProfileKey);
      machine.hasCalibration = json.contains(kCalibrationKey);
      machine.hasCreditTest = json.contains(kCreditTestKey);
      machine.hasFeedTest = json.contains(kFeedTestKey);
      machine.hasJobTest = json.contains(kJobTestKey);
      found.push_back(std::move(machine));
      break;
    }
  }
  std::sort(found.begin(), found.end(), [](const KnownMachine& a, const KnownMachine& b) {
    return std::pair(a.endpoint, a.server.applicationUri) <
           std::pair(b.endpoint, b.server.applicationUri);
  });
  return found;
}

base::Result<base::FileLock> MachineStore::lock() const {
  std::error_code ignored;  // locking says what is wrong
  fs::create_directories(m_folders.machines, ignored);
  return base::FileLock::take(m_folders.machines / ".lock");
}

base::Result<void> MachineStore::remove(const std::string& endpoint, base::UtcMs at) const {
  const auto changing = lock();
  if (!changing) {
    return base::fail(changing.error());
  }
  std::error_code error;
  for (const KnownMachine& machine : machines()) {
    const fs::path path = pathOf(machine.endpoint, machine.server);
    if (machine.endpoint == endpoint && fs::exists(path, error)) {
      fs::path aside = path;
      fs::rename(path, aside += ".removed", error);
      if (error) {
        return base::fail(base::FileError::NotWritable,
                          "The machine cannot be removed. Check the rights of its file.",
                          path.string());
      }
    }
  }
  // Its runs name it, too.
  ordered_json file{{kRemovedFormatKey, kMachineFormat}, {"machines", ordered_json::object()}};
  for (const auto& [name, when] : removed()) {
    file["machines"][name] = base::utcText(when);
  }
  file["machines"][endpoint] = base::utcText(at);
  return base::writeFile(m_folders.machines / kRemovedFile,
                         file.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

std::map<std::string, base::UtcMs> MachineStore::removed() const {
  std::map<std::string, base::UtcMs> machines;
  const ordered_json file =
      readJson<ordered_json>(m_folders.machines / kRemovedFile).value_or(ordered_json::object());
  const auto list = file.is_object() ? file.find("machines") : file.end();
  if (list == file.end() || !list->is_object()) {
    return machines;
  }
  for (const auto& [endpoint, when] : list->items()) {
    if (const auto at =
            when.is_string() ? base::utcOfText(when.get<std::string>()) : std::nullopt) {
      machines[endpoint] = *at;
    }
  }
  return machines;
}

base::Result<void> MachineStore::saveMember(const std::string& endpoint,
                                            const opcua::ServerIdentity& server, const char* key,
                                            const Make& make) const {
  const auto changing = lock();
  base::Result<ordered_json> machine =
      changing ? read(endpoint, server) : base::fail(changing.error());
  if (!machine) {
    return base::fail(machine.error());
  }
  ordered_json& member = (*machine)[key];
  member = make(member);
  // What a server says of itself may hold bytes that are not UTF-8.
  return base::writeFile(
      pathOf(endpoint, server),
      machine->dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

base::Result<void> MachineStore::save(const streaming::CalibrationRecord& record) const {
  return saveMember(record.endpoint, record.server, kCalibrationKey,
                    [&record](const auto&) { return calibrationJson(record); });
}

base::Result<void> MachineStore::save(const streaming::CreditTest& test) const {
  return saveMember(test.endpoint, test.server, kCreditTestKey,
                    [&test](const auto&) { return testJson(test); });
}

base::Result<void> MachineStore::save(const streaming::FeedTest& test) const {
  return saveMember(test.endpoint, test.server, kFeedTestKey,
                    [&test](const auto&) { return testJson(test); });
}

base::Result<void> MachineStore::save(const streaming::JobTest& test) const {
  return saveMember(test.endpoint, test.server, kJobTestKey,
                    [&test](const auto&) { return testJson(test); });
}

base::Result<void> MachineStore::save(const std::string& endpoint,
                                      const opcua::ServerIdentity& server,
                                      const job::Functions& functions) const {
  return saveMember(endpoint, server, kFunctionsKey, [&](const auto&) {
    return ordered_json{{"endpoint", endpoint},
                        {"server", {{"application_uri", server.applicationUri}}},
                        {"lines", linesJson(functions)}};
  });
}

base::Result<void> MachineStore::save(const streaming::MachineProfile& profile) const {
  return saveMember(profile.endpoint, profile.server, kProfileKey,
                    [&profile](const auto& was) { return profileJson(profile, was); });
}

}  // namespace rivulet::report
