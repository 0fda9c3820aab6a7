// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A job as a client of the service has loaded it, and what follows from it and from the machine.
/// @threadsafety reads files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "machine/config.h"
#include "overview/program_view.h"
#include "permission/permission.h"
#include "preparation/judged.h"
#include "preparation/settings_facts.h"
#include "report/load_machine.h"
#include "report/machine_store.h"
#include "session/hazards.h"
#include "streaming/run/run.h"
#include "streaming/start/first_move.h"

namespace rivulet::service {

/// What is known of the machine at the other end, as the window has stored it.
struct MachineFacts {
  std::string endpoint;
  opcua::ServerIdentity server;
  streaming::JobRelease jobs;                        ///< which may run there
  report::LoadMachine load;                          ///< what loading a program asks of it
  gcode::ProgramFeeds feeds;                         ///< its limits, at 100 %
  double silenceLimitS = templates::kSilenceLimitS;  ///< see `streaming::silenceLimitS`
  streaming::FeedProof feedProof = streaming::FeedProof::NotTested;
  double stopLimitS = streaming::stopLimitS(nullptr);   ///< where the feed cell is not proved
  std::shared_ptr<const machine::MachineConfig> known;  ///< null: jobs are not compared with it
  /// What access costs; null: not measured with this version of its server.
  std::shared_ptr<const streaming::CalibrationRecord> calibration;
};

/// @return a file of the machine that cannot be read
[[nodiscard]] base::Result<MachineFacts> factsOf(const report::MachineStore& store,
                                                 const std::string& endpoint,
                                                 const opcua::ServerIdentity& server,
                                                 bool isVirtual);

struct JobSettings {
  streaming::StreamSettings run;
  gcode::TextReading reading;
  /// Of the run that is resumed: its long moves are divided as they were. Nothing: as the machine
  /// and the settings want it.
  std::optional<gcode::MoveRules> moveRules{};
};

/// The settings of a job for which nobody has given any: feeds of the program, whole jobs.
[[nodiscard]] JobSettings defaultSettings();
/// With what a client has given as "name=value;…". A feed alone means one feed for all moves.
/// @return BadSettings, naming the setting
[[nodiscard]] base::Result<JobSettings> settingsWith(JobSettings settings,
                                                     const std::string& given);

struct LoadedJob {
  std::filesystem::path file;
  gcode::LoadOptions reading;
  std::uintmax_t fileBytes = 0;
  std::filesystem::file_time_type fileTime{};
  streaming::StreamSettings settings;
  std::shared_ptr<const gcode::Program> program;   ///< as read; moves of the view's may be divided
  std::optional<gcode::MoveRules> moveRulesOfRun;  ///< see `JobSettings`
  std::shared_ptr<const overview::ProgramView> view;
  streaming::RunSettings runSettings;
  preparation::Judged judged;
  std::shared_ptr<const session::Hazards> hazards;  ///< of a whole job on a machine that is known
  streaming::CutBox cut;                            ///< of that job, machine coordinates
  permission::Job released;                         ///< what a release has to name

  /// The file is no longer what was read.
  [[nodiscard]] bool hasFileChanged() const;
  /// The points depend on where the tool stands: makes them again.
  void place(base::Vec3 toolMm, const MachineFacts& machine);
};

/// @param reading  to begin with  @param settings  of a text of this hash; asked once it has been
/// read, and read again if that says so  @param toolMm  where the tool is
/// @return what is wrong with file or program; BadSettings; NotAJob if blocks for the control would
///         be left out and nobody has asked for that
[[nodiscard]] base::Result<LoadedJob> loadJob(
    const std::filesystem::path& file, const gcode::LoadOptions& reading,
    const std::function<base::Result<JobSettings>(const std::string& hash)>& settings,
    base::Vec3 toolMm, const MachineFacts& machine);

}  // namespace rivulet::service
