// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are one of the smaller files or texts that come from others, or that others could have
// changed: first a letter that says which, then its content. It is refused with a sentence, or
// what was read keeps its promises.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "cnc/event_file.h"
#include "emulator/emulator.h"
#include "emulator/paper/learning.h"
#include "fuzz/require.h"
#include "journal/alarm_history.h"
#include "journal/audit.h"
#include "linuxcnc/sampler.h"
#include "live/line.h"
#include "opcua/control_map.h"
#include "opcua/revocation.h"
#include "opcua/user_certificate.h"
#include "petri/export.h"
#include "petri/net_file.h"
#include "petri/simulator.h"
#include "preparation/release_file.h"
#include "preparation/settings_facts.h"
#include "preparation/user_file.h"
#include "report/machine_store.h"
#include "report/report_reader.h"
#include "report/rule.h"
#include "report/sweep_part.h"
#include "sources/server_map.h"
#include "streaming/run/correction_lines.h"
#include "trace/control_trace.h"
#include "trace/formula.h"
#include "trace/import/columns.h"
#include "training/recorded_run.h"
#include "trust/trust_store.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t sizeMax);

using namespace rivulet;
using tests::require;

namespace {

template <class T>
void checkResult(const base::Result<T>& result) {
  require(result || !result.error().message.empty());
}

/// A file in memory, for what reads by path. Its content is replaced with each input.
class MemoryFile {
 public:
  MemoryFile() : m_descriptor(memfd_create("fuzz", 0)) { require(m_descriptor >= 0); }
  ~MemoryFile() { close(m_descriptor); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::filesystem::path holding(std::string_view bytes) const {
    require(ftruncate(m_descriptor, 0) == 0);
    require(pwrite(m_descriptor, bytes.data(), bytes.size(), 0) ==
            static_cast<ssize_t>(bytes.size()));
    return "/proc/self/fd/" + std::to_string(m_descriptor);
  }

 private:
  int m_descriptor;
};

std::filesystem::path fileHolding(std::string_view bytes) {
  static const MemoryFile file;
  return file.holding(bytes);
}

/// The same as the file of this name in a folder that has nothing else.
std::filesystem::path folderHolding(const char* name, std::string_view bytes) {
  namespace fs = std::filesystem;
  static const struct Folder {
    fs::path path = [] {
      std::string made = (fs::temp_directory_path() / "rivulet-fuzz-XXXXXX").string();
      require(mkdtemp(made.data()) != nullptr);
      return fs::path(made);
    }();
    Folder() = default;
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
  } folder;
  const fs::path of = folder.path / name;
  std::error_code ignored;
  if (fs::create_directory(of, ignored)) {
    fs::create_symlink(fileHolding(bytes), of / name);
  }
  fileHolding(bytes);
  return of;
}

void readControlMap(std::string_view text) {
  const auto map = opcua::parseControlMap(text, "fuzz.toml");
  checkResult(map);
  if (map) {
    const auto again = opcua::parseControlMap(opcua::controlMapText(*map), "again.toml");
    require(again && *again == *map);
    for (const opcua::MapGap& gap : opcua::gapsOf(*map)) {
      require(!gap.consequence.empty());
    }
    for (int number = map->cells.first; map->cells.has(number) && number < 3; ++number) {
      require(opcua::isAddress(opcua::cellAddress(map->cells, number)));
    }
  }
}

void readServerMap(std::string_view text) {
  checkResult(sources::readServerMap(fileHolding(text)));
}

void readNet(std::string_view text) {
  const auto net = petri::parseNet(text, "fuzz.toml");
  checkResult(net);
  if (net) {
    require(!petri::pnmlOf(*net).empty() && !petri::graphvizOf(*net).empty());
    constexpr int kSteps = 20;
    petri::Simulator simulator(*net, 1);
    for (int i = 0; i < kSteps && simulator.step(); ++i) {
    }
  }
}

void readEmulator(std::string_view text) {
  const auto emulator = emulator::parseEmulator(text, "fuzz.toml");
  checkResult(emulator);
  if (emulator) {
    require(emulator::parseEmulator(emulator::printEmulator(*emulator), "again.toml").has_value());
  }
}

void readLearning(std::string_view text) {
  const auto learning = emulator::paper::parseLearning(text);
  checkResult(learning);
  if (learning) {
    require(emulator::paper::parseLearning(emulator::paper::learningText(*learning)).has_value());
  }
}

void readLiveLine(std::string_view text) {
  const auto line = live::parseLine(text);
  checkResult(line);
  if (line) {
    for (const auto& value : line->mm) {
      require(!value || std::isfinite(*value));
    }
    require(!line->feedMmPerMin || std::isfinite(*line->feedMmPerMin));
  }
}

void readSweepPart(std::string_view text) {
  const auto part = report::sweepPartOf(text, "fuzz.json");
  checkResult(part);
  if (part) {
    require(report::sweepPartOf(report::sweepPartText(*part), "again.json").has_value());
  }
}

void readRule(std::string_view text) {
  const auto rule = report::Rule::parse(text);
  checkResult(rule);
  if (rule) {
    static const auto kResult =
        nlohmann::ordered_json::parse(R"({"skipped":1,"feed":{"kept_share":0.5,"max_mm":null}})");
    const auto verdict = rule->judge(kResult);
    require(verdict.unknown.size() <= text.size());
  }
}

void readFormula(std::string_view text) {
  const auto formula = trace::Formula::parse(text);
  checkResult(formula);
  if (formula) {
    const std::vector<base::Instant> at{base::Instant{base::Duration{0}},
                                        base::Instant{base::Duration{1'000'000}},
                                        base::Instant{base::Duration{2'000'000}}};
    const std::vector<std::vector<double>> values(formula->names().size(), {0.0, -1.5, 1e300});
    require(formula->evaluate(at, values).size() == at.size());
  }
}

void readTableMapping(std::string_view text) {
  const auto mapping = trace::parseTableMapping(text);
  checkResult(mapping);
  if (mapping) {
    require(trace::parseTableMapping(trace::printTableMapping(*mapping)).has_value());
  }
}

void readControlTrace(std::string_view text) {
  const auto trace = trace::parseControlTrace(text);
  checkResult(trace);
  if (trace) {
    require(trace::parseControlTrace(trace::printControlTrace(*trace)).has_value());
  }
}

void readEvents(std::string_view text) {
  const auto recording = cnc::parseEvents(text);
  checkResult(recording);
  if (recording) {
    const auto again = cnc::parseEvents(cnc::printEvents(*recording));
    require(again && again->events == recording->events);
  }
}

void readRecordedSamples(std::string_view text) {
  checkResult(training::parseRecordedSamples(text));
}

void readObservedSamples(std::string_view text) {
  checkResult(training::parseObservedSamples(text));
}

void readRecordedProgram(std::string_view text) {
  checkResult(training::parseRecordedProgram(text, {}));
}

void readRevocations(std::string_view bytes) {
  const auto list = opcua::readRevocationList(bytes);
  checkResult(list);
  if (list) {
    require(!opcua::isRevoked(std::vector{*list}, {}));
    (void)opcua::isRevoked(std::vector{*list}, bytes);
  }
}

void readUserCertificate(std::string_view bytes) {
  const auto user = opcua::readUserCertificate(bytes, bytes);
  checkResult(user);
  if (user) {
    require(!user->certificate.empty() && !user->privateKey.empty());
    checkResult(opcua::checkUserCertificate(*user, 0));
  }
}

void readFinishedRun(std::string_view text) {
  const auto run = report::finishedRunOf(nlohmann::json::parse(text, nullptr, false), "fuzz.json");
  checkResult(run);
  if (run) {
    const nlohmann::json again = report::finishedRunJson(*run);
    require(report::finishedRunOf(again, "again.json").has_value());
  }
}

void readSummary(std::string_view text) {
  checkResult(report::summaryOf(nlohmann::json::parse(text, nullptr, false), "fuzz.json"));
}

constexpr const char* kEndpoint = "opc.tcp://127.0.0.1:4840";

report::MachineStore storeHolding(std::string_view text) {
  static const std::string kName =
      report::MachineStore({"/", {}, {}}).pathOf(kEndpoint, {}).filename().string();
  return report::MachineStore({folderHolding(kName.c_str(), text), {}, {}});
}

void readMachines(std::string_view text) {
  require(storeHolding(text).machines().size() <= 1);
}

void readKeptCalibration(std::string_view text) {
  checkResult(storeHolding(text).calibration(kEndpoint, {}));
}

void readCreditTest(std::string_view text) {
  checkResult(storeHolding(text).creditTest(kEndpoint, {}));
}

void readProfile(std::string_view text) {
  checkResult(storeHolding(text).profile(kEndpoint, {}));
}

void readAudit(std::string_view text) {
  const auto content = journal::readAudit(fileHolding(text));
  checkResult(content);
  if (content) {
    require(!journal::auditCsv(*content).empty());
    for (const journal::AuditFinding& finding : content->findings) {
      require(!journal::describe(finding).empty());
    }
  }
}

void readAuditAsJson(std::string_view text) {
  const auto content = journal::readAudit(fileHolding(text));
  require(!content || !journal::auditJson(*content).empty());
}

void readAlarms(std::string_view text) {
  const std::filesystem::path folder = folderHolding("alarms.jsonl", text);
  const auto content = journal::AlarmHistory(folder).read();
  checkResult(content);
  if (content) {
    require(journal::unacknowledged(content->transitions).size() <= content->transitions.size());
  }
}

void readUsers(std::string_view text) {
  const auto file = preparation::readUsers(fileHolding(text));
  checkResult(file);
  require(!file || file->idleMinutes >= 0);
}

void readReleases(std::string_view text) {
  checkResult(preparation::readReleases(fileHolding(text)));
}

void readTrustedServers(std::string_view text) {
  checkResult(trust::TrustStore(folderHolding("servers.json", text)).servers());
}

void readSamples(std::string_view text) {
  trace::ControlTrace trace;
  const linuxcnc::SampleScale scale{std::chrono::milliseconds{1}, 1.0, {}};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    linuxcnc::addSample(trace, text.substr(begin, end - begin), scale);
    begin = end + 1;
  }
}

void readCorrections(std::string_view text) {
  streaming::CorrectionLines lines;
  lines.add(text.substr(0, text.size() / 2));
  lines.add(text.substr(text.size() / 2));
  lines.finishLine();
  require(std::isfinite(lines.valueMm().x) && std::isfinite(lines.valueMm().y) &&
          std::isfinite(lines.valueMm().z));
}

void readSettings(std::string_view text) {
  streaming::StreamSettings settings;
  preparation::applySettings(settings, preparation::factsOfText(std::string(text)));
  // What has been taken over is taken again.
  const auto facts = preparation::settingsFacts(settings);
  streaming::StreamSettings again;
  preparation::applySettings(again, facts);
  require(preparation::settingsFacts(again) == facts);
}

/// The first is 'A', the second 'B', …; new ones at the end, or seeds change their meaning.
constexpr std::array kReaders{&readControlMap,      &readServerMap,      &readNet,
                              &readEmulator,        &readLearning,       &readLiveLine,
                              &readSweepPart,       &readRule,           &readFormula,
                              &readTableMapping,    &readControlTrace,   &readEvents,
                              &readRecordedSamples, &readRevocations,    &readUserCertificate,
                              &readFinishedRun,     &readMachines,       &readAudit,
                              &readAlarms,          &readUsers,          &readReleases,
                              &readTrustedServers,  &readSamples,        &readCorrections,
                              &readSettings,        &readSummary,        &readKeptCalibration,
                              &readCreditTest,      &readProfile,        &readAuditAsJson,
                              &readObservedSamples, &readRecordedProgram};

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) {
    const auto choice = static_cast<std::uint8_t>(data[0] - 'A');
    kReaders[choice % kReaders.size()](tests::textOf(data + 1, size - 1));
  }
  return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t sizeMax, unsigned seed) {
  // What is good for one reader is seldom good for another, except of the same kind of file.
  base::Random random(seed);
  if (size == 0) {
    return LLVMFuzzerMutate(data, size, sizeMax);
  }
  if (random.below(64) == 0) {
    data[0] = static_cast<std::uint8_t>('A' + random.below(kReaders.size()));
    return size;
  }
  return 1 + LLVMFuzzerMutate(data + 1, size - 1, sizeMax - 1);
}
