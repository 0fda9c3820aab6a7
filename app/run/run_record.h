// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What stays of a run: its recording, the file to resume it from, and its place in the history.
/// The same for every kind of run, whoever starts it. @threadsafety one object, one thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "report/run_history.h"
#include "report/run_store.h"
#include "streaming/run/job_times.h"
#include "trace/analysis/tool_use.h"
#include "trace/recording.h"

namespace rivulet::recorder {
class RecordingFile;
}

namespace rivulet::run {

enum class RunKind : unsigned char { Motion, Live, WholeJob };

/// The recording of a run has ended before the run.
struct RecordingCut {
  std::string program;
  std::string file;
  base::Duration recorded{};  ///< on the disk, from the first record to the last
  base::Error error;          ///< why
};

/// What is known of a run before it starts.
struct RunFacts {
  RunKind kind = RunKind::Motion;
  std::string programName;
  std::string programHash;
  std::string programFile;       ///< absolute; may be empty
  gcode::LoadOptions reading{};  ///< see `report::SavedRun`
  std::string endpoint;
  std::string startedAtUtc;
  std::vector<std::string> command{};  ///< see `report::SavedRun`
  /// File to record to. Empty: one of the history's own, which a run does not depend on.
  std::string recording{};
  /// Called once, on the thread of the run, as soon as nothing more of a run in progress can be
  /// recorded; the run itself goes on. May be empty.
  std::function<void(const RecordingCut&)> onCut{};
  std::optional<report::SavedJob> job{};  ///< of a whole job
  double dryRunMm = 0.0;                  ///< > 0: a dry run of a whole job
  /// The run drives this one back along its path, which has `back`: that one can be resumed, and
  /// goes on from wherever the tool stands then.
  std::optional<report::SavedRun> drivenBack{};
  /// A simulation in virtual time leaves nothing but a recording that was asked for.
  bool isSimulated = false;
};

/// What is known of a run only after it.
struct RunResult {
  std::span<const gcode::StreamPoint> points;  ///< its path, for the sketch
  std::optional<streaming::JobTimes> jobTimes{};
  std::vector<trace::ToolUse> tools{};
};

class RunRecord {
 public:
  explicit RunRecord(RunFacts facts);
  ~RunRecord();
  RunRecord(const RunRecord&) = delete;
  RunRecord& operator=(const RunRecord&) = delete;

  /// Right before the start. @return why the recording that was asked for cannot be made; without
  /// one of the history's own a run starts all the same: see `notRecorded`
  [[nodiscard]] base::Result<void> open();

  /// Null: nothing is recorded.
  [[nodiscard]] trace::RecordingWriter* writer() { return m_writer ? &*m_writer : nullptr; }
  [[nodiscard]] trace::RunStart start() const;
  /// Null: nothing is kept.
  [[nodiscard]] streaming::CheckpointKeeper* keeper();

  /// After the run, once: its files are finished, and the history has it.
  void finish(const streaming::RunReport& report, const RunResult& result);

  /// Of the recording, complete or not (its reader says so); empty: there is none.
  [[nodiscard]] const std::string& recording() const { return m_facts.recording; }
  [[nodiscard]] bool isRecorded() const { return m_isRecorded; }  ///< completely
  /// Why there is no recording, or it is not complete; code clear: there is one, or none was
  /// wanted.
  [[nodiscard]] const base::Error& notRecorded() const { return m_notRecorded; }
  /// Nothing: there is no recording, or it goes on, or it came to its end.
  [[nodiscard]] std::optional<RecordingCut> cut() const;
  /// Why the history does not have the run; code clear: it has, or none was wanted.
  [[nodiscard]] const base::Error& notKept() const { return m_notKept; }
  [[nodiscard]] bool ownsRecording() const { return m_ownsRecording; }
  /// The run as it can be resumed; nothing: it cannot.
  [[nodiscard]] std::optional<report::SavedRun> left() const;

 private:
  [[nodiscard]] base::Result<void> openRecording();
  bool append(std::string_view lines);

  RunFacts m_facts;
  bool m_ownsRecording = false;
  std::unique_ptr<recorder::RecordingFile> m_file;
  std::optional<trace::RecordingWriter> m_writer;
  std::optional<report::RunKeeper> m_keeper;  ///< nothing: it cannot be resumed from a file
  std::unique_ptr<streaming::CheckpointKeeper> m_otherKeeper;  ///< of another run that was left
  bool m_isRecorded = false;
  base::Error m_notRecorded{};
  base::Error m_notKept{};
};

}  // namespace rivulet::run
