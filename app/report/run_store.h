// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The runs that are in progress or were left, on disk: everything that is needed to resume one
/// after a crash or a loss of power. Command line and HMI share the folder. One JSON file per run
/// (docs/formats.md) and one with its points; both are replaced as a whole.
/// @threadsafety reads and writes files; shares nothing.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "streaming/recovery/job_resume.h"
#include "streaming/recovery/resume.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/job.h"

namespace rivulet::report {

/// What is kept of a whole job beside its checkpoint.
struct SavedJob {
  int number = 0;  ///< of its programs on the control, see `job::JobName`
  /// Number of its run when it began at its beginning: however often it has been resumed since, it
  /// stays in the file of this number. 0: it has not begun yet.
  int firstRun = 0;
  /// Where it went on last, in the plan of its source; nothing: it began at its beginning.
  std::optional<streaming::JobRest> rest{};
};

/// A run as it is kept.
struct SavedRun {
  std::string programName;
  std::string programFile;  ///< absolute path; may be empty
  std::string endpoint;
  std::string toolVersion;
  std::string recording;  ///< file; empty: none
  /// How the text of the program was read: dialect, accepted words, arc centres, chord tolerance.
  gcode::LoadOptions reading;
  std::vector<std::string> command;  ///< words that started it; empty: it was started in the HMI
  streaming::RunSettings settings;   ///< with `origin`: who started it
  streaming::Checkpoint checkpoint;
  std::optional<SavedJob> job{};  ///< nothing: the motion alone
  /// The tool has been driven back along its path: see `streaming::resumeOnPart`. Nothing: it has
  /// not.
  std::optional<streaming::BackPart> back{};
  std::filesystem::path file;  ///< where it was read from; empty: not from a file

  /// Under which it is kept.
  [[nodiscard]] int number() const {
    return job && job->firstRun != 0 ? job->firstRun : checkpoint.runNumber;
  }
  /// Nothing has been executed of it: there is nothing to go on with.
  [[nodiscard]] bool isUntouched() const;
  /// "rows.nc-123456": program and number of the run.
  [[nodiscard]] std::string name() const;
};

/// A name that can stand in a file name on any system.
[[nodiscard]] std::string plainName(std::string_view name);

/// Who is working here, and the time.
[[nodiscard]] streaming::RunOrigin thisUser();

/// Reads a run from the store, or the output of `stream --json`.
/// @param file  for the error
/// @return CannotResume: it is neither, or a member is missing, has another type or is out of range
[[nodiscard]] base::Result<SavedRun> savedRunOf(const nlohmann::json& json,
                                                const std::filesystem::path& file);
/// The same for a file. @return also errors of `readJson`
[[nodiscard]] base::Result<SavedRun> readSavedRun(const std::filesystem::path& file,
                                                  const base::Budget& budget = {});

class RunStore {
 public:
  /// Below $XDG_STATE_HOME, or ~/.local/state.
  [[nodiscard]] static std::filesystem::path folderOfUser();
  /// Beside it, for whole jobs: the checkpoint of the stretch that was begun last.
  [[nodiscard]] static std::filesystem::path folderOfJobs();

  explicit RunStore(std::filesystem::path folder = folderOfUser()) : m_folder(std::move(folder)) {}

  [[nodiscard]] std::filesystem::path pathOf(const SavedRun& run) const;
  /// Makes the folder if it is missing. @param points  of the whole program; empty: stored already
  /// @return NotWritable
  [[nodiscard]] base::Result<void> save(const SavedRun& run,
                                        std::span<const gcode::StreamPoint> points) const;
  /// The newest first. Files that cannot be read are left out.
  [[nodiscard]] std::vector<SavedRun> runs() const;
  /// The run that is kept under this number; nothing if it is not kept here.
  [[nodiscard]] std::optional<SavedRun> find(int runNumber) const;
  /// The whole job that is on a control; nothing if it is not kept here.
  [[nodiscard]] std::optional<SavedRun> findJob(const streaming::RunOnControl& onControl) const;
  /// The newest run that was left on this control; nothing if there is none.
  [[nodiscard]] std::optional<SavedRun> leftOn(const std::string& endpoint) const;
  /// The points of the whole program as the run had them; empty if they are not kept.
  [[nodiscard]] std::vector<gcode::StreamPoint> points(const SavedRun& run) const;
  void remove(const SavedRun& run) const;

 private:
  std::filesystem::path m_folder;
};

/// Keeps one run in the store while it is in progress.
class RunKeeper final : public streaming::CheckpointKeeper {
 public:
  /// @param run  all but settings and checkpoint, which the job supplies
  RunKeeper(RunStore store, SavedRun run) : m_store(std::move(store)), m_run(std::move(run)) {}

  base::Result<void> keep(const streaming::Checkpoint& checkpoint,
                          const streaming::RunSettings& settings,
                          std::span<const gcode::StreamPoint> points) override;
  /// After the run: removes it from the store if nothing of it is left.
  void finish(const streaming::RunReport& report);

  /// The run as it can be resumed; nothing if it is not kept.
  [[nodiscard]] std::optional<SavedRun> left() const;

 private:
  RunStore m_store;
  SavedRun m_run;
  bool m_isKept = false;
};

/// A run on a control together with what is known about it here.
struct FoundRun {
  streaming::RunOnControl onControl;
  std::optional<SavedRun> saved;  ///< nothing: it was not started from here

  /// It waits for a client that is gone, and can be resumed from here.
  [[nodiscard]] bool canResume() const {
    return saved && !onControl.hasClient && !onControl.isNative;
  }
};

/// Looks for a run on the control and in the store. @return nothing if there is none
[[nodiscard]] base::Result<std::optional<FoundRun>> findRun(
    const RunStore& store, opcua::Link& link, opcua::Control& control, int baseCell,
    base::Duration watchFor = streaming::kHeartbeatWatch);

/// Points of the program that are executed after each number of windows, from none to all.
/// @return empty if the points of the run are not kept here
[[nodiscard]] std::vector<std::size_t> pointsAfterWindows(const RunStore& store,
                                                          const SavedRun& run);

/// "run 123456 of anna on cell-pc-3, started 2026-11-22T05:00:00Z", as far as it is known.
[[nodiscard]] std::string describeRun(const FoundRun& run);

}  // namespace rivulet::report
