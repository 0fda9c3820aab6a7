// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the command line says of the files of a run. @threadsafety calls share nothing.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <system_error>

#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "run/run_record.h"
#include "streaming/start/first_move.h"

namespace rivulet::cli {

/// At once; see `run::RunFacts`.
void tellCut(const run::RecordingCut& cut);

/// All that is known of a run of a file before it starts. @param options  of `stream` or `job`
template <class Options>
[[nodiscard]] run::RunFacts factsOf(const Options& options, const gcode::Program& program,
                                    const std::string& endpoint) {
  run::RunFacts facts;
  std::error_code ignored;
  facts.programName = program.name;
  facts.programHash = program.hash;
  facts.programFile = std::filesystem::absolute(options.file, ignored).string();
  facts.reading = options.loading.loadOptions();
  facts.endpoint = endpoint;
  facts.startedAtUtc = utcNow();
  facts.command = options.command;
  facts.recording = options.record;
  facts.onCut = &tellCut;
  facts.isSimulated = options.simulate;
  return facts;
}

/// Refuses a first move through what the program cuts, unless the operator has looked.
/// @param isAccepted  --straight was given, or nothing can be in the way: it is only said
[[nodiscard]] base::Result<void> requireClearWay(const std::optional<streaming::CutOnTheWay>& cut,
                                                 bool isAccepted, const std::string& program);

/// Refuses a motion that would leave the travel, and warns of what could not be checked.
/// @param preset  of a simulation; empty: the machine of the connection
[[nodiscard]] base::Result<void> requireTravel(const Connection& connection,
                                               const std::string& preset,
                                               std::span<const gcode::StreamPoint> points);

/// The recording that was asked for, and the file to go on from, below `savedKey`.
[[nodiscard]] nlohmann::ordered_json filesJson(const run::RunRecord& record, const char* savedKey);

/// Says on the error stream what is missing, and how an incomplete run goes on.
/// @return false: the recording that was asked for is not complete
bool tellFiles(const run::RunRecord& record);

/// After a motion or a live run: `tellFiles`, and the exit of the whole.
[[nodiscard]] Exit exitAfter(const streaming::RunReport& done, const run::RunRecord& record);

}  // namespace rivulet::cli
