// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/run_record.h"

#include <filesystem>
#include <utility>

#include "platform/recording_file.h"

namespace rivulet::run {

namespace {

report::SavedRun savedRun(const RunFacts& facts) {
  report::SavedRun saved;
  saved.programName = facts.programName;
  saved.programFile = facts.programFile;
  saved.reading = facts.reading;
  saved.endpoint = facts.endpoint;
  saved.toolVersion = RIVULET_VERSION;
  saved.recording = facts.recording;
  saved.command = facts.command;
  saved.job = facts.job;
  return saved;
}

report::RunStore storeOf(RunKind kind) {
  return report::RunStore(kind == RunKind::WholeJob ? report::RunStore::folderOfJobs()
                                                    : report::RunStore::folderOfUser());
}

/// A live run ends with its source, and nobody goes on in the middle of a dry run.
bool canBeResumed(const RunFacts& facts) {
  return !facts.isSimulated && facts.kind != RunKind::Live && facts.dryRunMm == 0.0;
}

/// Of a dry run, which cannot be resumed itself. Once it begins, the control has forgotten the job
/// that was left before; until then that one can still go on.
class Forgetter final : public streaming::CheckpointKeeper {
 public:
  explicit Forgetter(std::string endpoint) : m_endpoint(std::move(endpoint)) {}
  base::Result<void> keep(const streaming::Checkpoint& checkpoint,
                          const streaming::RunSettings& /*settings*/,
                          std::span<const gcode::StreamPoint> /*points*/) override {
    if (!checkpoint.granted || std::exchange(m_isDone, true)) {
      return {};
    }
    const report::RunStore store = storeOf(RunKind::WholeJob);
    if (const auto left = store.leftOn(m_endpoint)) {
      store.remove(*left);
    }
    return {};
  }

 private:
  std::string m_endpoint;
  bool m_isDone = false;
};

/// Keeps the run that is driven back, before anything moves: from then on the control knows another
/// run.
class BackKeeper final : public streaming::CheckpointKeeper {
 public:
  explicit BackKeeper(report::SavedRun run) : m_run(std::move(run)) {}
  base::Result<void> keep(const streaming::Checkpoint& /*checkpoint*/,
                          const streaming::RunSettings& /*settings*/,
                          std::span<const gcode::StreamPoint> /*points*/) override {
    return storeOf(RunKind::Motion).save(m_run, {});
  }

 private:
  report::SavedRun m_run;
};

}  // namespace

RunRecord::RunRecord(RunFacts facts)
    : m_facts(std::move(facts)), m_ownsRecording(m_facts.recording.empty()) {
}
RunRecord::~RunRecord() = default;

base::Result<void> RunRecord::open() {
  if (base::Result<void> opened = openRecording(); !opened) {
    return opened;
  }
  if (m_facts.drivenBack) {
    m_otherKeeper = std::make_unique<BackKeeper>(*m_facts.drivenBack);
  } else if (canBeResumed(m_facts)) {
    m_keeper.emplace(storeOf(m_facts.kind), savedRun(m_facts));
  } else if (m_facts.kind == RunKind::WholeJob && !m_facts.isSimulated) {
    m_otherKeeper = std::make_unique<Forgetter>(m_facts.endpoint);
  }
  return {};
}

streaming::CheckpointKeeper* RunRecord::keeper() {
  return m_keeper ? &*m_keeper : m_otherKeeper.get();
}

base::Result<void> RunRecord::openRecording() {
  base::Result<std::filesystem::path> path = std::filesystem::path(m_facts.recording);
  if (m_ownsRecording) {
    if (m_facts.isSimulated) {
      return {};
    }
    path = report::RunHistory().newRecording(m_facts.programName, m_facts.startedAtUtc);
  }
  auto file =
      path ? recorder::RecordingFile::open(*path)
           : base::Result<std::unique_ptr<recorder::RecordingFile>>(base::fail(path.error()));
  if (!file) {
    m_notRecorded = file.error();
    return m_ownsRecording ? base::Result<void>() : base::fail(file.error());
  }
  m_facts.recording = path->string();
  m_file = std::move(*file);
  m_writer.emplace([this](std::string_view lines) { return append(lines); });
  return {};
}

/// A writer whose text was refused once comes no more.
bool RunRecord::append(std::string_view lines) {
  if (m_file->append(lines)) {
    return true;
  }
  if (auto seen = cut(); seen && m_facts.onCut) {
    seen->error.message += " The run goes on.";
    m_facts.onCut(*seen);
  }
  return false;
}

std::optional<RecordingCut> RunRecord::cut() const {
  if (const auto taken = m_file ? m_file->soFar() : base::Result<void>(); !taken) {
    return RecordingCut{m_facts.programName, m_facts.recording, m_file->recorded(), taken.error()};
  }
  return std::nullopt;
}

trace::RunStart RunRecord::start() const {
  trace::RunStart start;
  start.toolVersion = RIVULET_VERSION;
  start.endpoint = m_facts.endpoint;
  start.startedAtUtc = m_facts.startedAtUtc;
  return start;
}

void RunRecord::finish(const streaming::RunReport& report, const RunResult& result) {
  if (m_keeper) {
    m_keeper->finish(report);
  }
  if (m_file) {
    const base::Result<void> recorded = m_file->finish();
    m_isRecorded = recorded.has_value();
    m_notRecorded = recorded ? base::Error{} : recorded.error();
  }
  if (m_facts.isSimulated) {
    return;
  }
  streaming::RunSummary known;
  known.programFile = m_facts.programFile;
  known.programHash = m_facts.programHash;
  known.endpoint = m_facts.endpoint;
  known.toolVersion = RIVULET_VERSION;
  known.ownsRecording = m_ownsRecording;
  known.jobTimes = result.jobTimes;
  known.tools = result.tools;
  known.dryRunMm = m_facts.dryRunMm;
  std::error_code ignored;
  if (m_file && std::filesystem::is_regular_file(m_facts.recording, ignored)) {
    // One that was cut off as well: its reader says so, and the history removes it with the run.
    known.recording = std::filesystem::absolute(m_facts.recording, ignored).string();
  }
  const auto kept = report::RunHistory().add(report, std::move(known), result.points);
  m_notKept = kept ? base::Error{} : kept.error();
}

std::optional<report::SavedRun> RunRecord::left() const {
  return m_keeper ? m_keeper->left() : m_facts.drivenBack;
}

}  // namespace rivulet::run
