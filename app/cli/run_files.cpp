// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run_files.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/found_run.h"
#include "platform/log.h"
#include "run/travel.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

base::Result<void> requireClearWay(const std::optional<streaming::CutOnTheWay>& cut,
                                   bool isAccepted, const std::string& program) {
  if (!cut) {
    return {};
  }
  if (isAccepted) {
    log::logger().warn(streaming::describe(*cut));
    return {};
  }
  return base::fail(
      streaming::StreamError::CutOnTheWay,
      streaming::describe(*cut) +
          (cut->isClearFromAbove
               ? fmt::format(" To raise it: rivulet-cli raise --to {:.3f}.", cut->heightMm)
               : std::string()) +
          " If nothing is in the way, give --straight. Nothing has moved.",
      program);
}

base::Result<void> requireTravel(const Connection& connection, const std::string& preset,
                                 std::span<const gcode::StreamPoint> points) {
  base::Result<std::optional<machine::MachineConfig>> machine =
      std::optional<machine::MachineConfig>();
  if (preset.empty()) {
    machine = run::machineOf(*connection.control, connection.name);
  } else if (auto loaded = machine::loadPreset(preset)) {
    machine = std::optional(*std::move(loaded));
  } else {
    machine = base::fail(loaded.error());
  }
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto checked = run::checkTravel(*connection.link, *connection.control, *machine, points);
  if (!checked) {
    return base::fail(checked.error());
  }
  if (!checked->empty()) {
    log::logger().warn(*checked);
  }
  return {};
}

void tellCut(const run::RecordingCut& cut) {
  log::logger().error(cut.error.text());
}

nlohmann::ordered_json filesJson(const run::RunRecord& record, const char* savedKey) {
  auto json = nlohmann::ordered_json::object();
  if (!record.ownsRecording()) {
    json["recording"] = record.recording();
    json["recording_complete"] = record.isRecorded();
  }
  if (const auto left = record.left()) {
    json[savedKey] = left->file.string();
  }
  return json;
}

bool tellFiles(const run::RunRecord& record) {
  const base::Error& notRecorded = record.notRecorded();
  if (notRecorded.code && record.ownsRecording()) {
    log::logger().warn("The run is not recorded, or not completely: {}", notRecorded.text());
  } else if (notRecorded.code) {
    log::logger().error(notRecorded.text());
  }
  if (record.notKept().code) {
    log::logger().warn("The run is not in the history: {}", record.notKept().text());
  }
  if (const auto left = record.left()) {
    fmt::print(stderr, "The run is not complete. To go on:\n  {}\n",
               resumeCommand(*left, left->file));
  }
  return !notRecorded.code || record.ownsRecording();
}

Exit exitAfter(const streaming::RunReport& done, const run::RunRecord& record) {
  const bool isComplete = tellFiles(record);
  if (done.error.code && exitForRun(done.error) != Exit::Wrong) {
    return exitForRun(done.error);
  }
  const bool isRight =
      done.outcome != streaming::Outcome::Failed && done.finding() != streaming::RunFinding::Faulty;
  return isRight && isComplete ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
