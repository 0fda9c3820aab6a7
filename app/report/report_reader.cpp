// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/text.h"
#include "base/units.h"
#include "job/dry_plan.h"
#include "live/error.h"
#include "opcua/error.h"
#include "report/job_json.h"
#include "report/json_members.h"
#include "report/report_json.h"

namespace rivulet::report {
namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;

constexpr int kFinishedFormat = 1;
constexpr const char* kFinishedFormatKey = "rivulet_finished_run";
constexpr double kSecondsMax = 1e9;
constexpr double kMillisecondsMax = 1e12;

base::Duration seconds(Members& members, const char* at) {
  return base::fromSeconds(members.number(at, 0.0, kSecondsMax));
}

base::Duration milliseconds(Members& members, const char* at) {
  return base::fromSeconds(members.number(at, 0.0, kMillisecondsMax) / 1000.0);
}

std::size_t count(Members& members, const char* at) {
  return members.integer<std::size_t>(at, 0, kJsonCountMax);
}

/// The value whose name stands there. @param nameOf  of each of the values
template <class Value, std::size_t count, class NameOf>
Value named(Members& members, const char* at, const std::array<Value, count>& values,
            NameOf nameOf) {
  const std::string word = members.text(at);
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](Value value) { return nameOf(value) == word; });
  if (found == values.end()) {
    members.refuse(at);
    return values.front();
  }
  return *found;
}

streaming::Outcome outcomeOf(Members& members, const char* at) {
  using streaming::Outcome;
  return named(members, at, std::array{Outcome::Failed, Outcome::Completed, Outcome::Stopped},
               streaming::outcomeName);
}

trace::DurationStatistics durationsOf(Members& members, const std::string& at) {
  const auto value = [&](const char* name) {
    return milliseconds(members, (at + "/" + name).c_str());
  };
  trace::DurationStatistics durations;
  durations.mean = value("mean");
  durations.p50 = value("p50");
  durations.p95 = value("p95");
  durations.p99 = value("p99");
  durations.max = value("max");
  return durations;
}

/// Calls `read` with the members of each item of a list. Without the list nothing happens.
template <class Read>
void forEach(Members& members, const char* at, Read read) {
  const nlohmann::json* list = members.find(at);
  if (list == nullptr) {
    return;
  }
  if (!list->is_array()) {
    members.refuse(at);
    return;
  }
  for (const nlohmann::json& item : *list) {
    Members inner(item);
    read(inner);
    if (!inner.bad().empty()) {
      members.refuse(at);
      return;
    }
  }
}

void readPauses(Members& members, streaming::RunReport& report) {
  using trace::PauseOrigin;
  forEach(members, "/pauses", [&report](Members& item) {
    trace::Pause pause;
    pause.start = base::Instant{seconds(item, "/start_s")};
    pause.duration = milliseconds(item, "/duration_ms");
    pause.origin =
        named(item, "/origin",
              std::array{PauseOrigin::Measured, PauseOrigin::Inferred, PauseOrigin::Predicted},
              trace::pauseOriginName);
    report.pauses.push_back(pause);
  });
}

void readAccessForms(Members& members, streaming::RunReport& report) {
  if (!members.has("/access_forms")) {
    return;
  }
  report.accessForms.emplace();
  forEach(members, "/access_forms", [&report](Members& item) {
    streaming::FormProof proof;
    const auto form = opcua::groupingFromName(item.text("/form"));
    if (!form) {
      item.refuse("/form");
      return;
    }
    proof.form = *form;
    proof.writes = item.flag("/writes");
    proof.reads = item.flag("/reads");
    item.ifThere("/why_not", proof.why, [&item](const char* at) { return item.text(at); });
    report.accessForms->proofs.push_back(std::move(proof));
  });
}

/// "streaming:5" as the code it was printed from. A code of another folder keeps its number only.
std::error_code codeOf(const std::string& text) {
  static const base::NamedCategory unknown("report of an earlier run");
  const std::size_t colon = text.rfind(':');
  int value = 0;
  if (colon != std::string::npos) {
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), value);
  }
  const std::string name = text.substr(0, colon);
  for (const std::error_code& known :
       {make_error_code(streaming::StreamError{}), make_error_code(opcua::LinkError{}),
        make_error_code(base::FileError{}), make_error_code(templates::TemplateError{}),
        make_error_code(live::LiveError{})}) {
    if (known.category().name() == name && value > 0) {
      return {value, known.category()};
    }
  }
  return {std::max(value, 1), unknown};
}

void readPoints(Members& members, streaming::RunReport& report) {
  report.counters.total = count(members, "/points");
  report.counters.sent = count(members, "/sent");
  report.counters.accepted = count(members, "/accepted");
  report.counters.executed = count(members, "/executed");
  trace::Integrity& integrity = report.integrity;
  integrity.judged = members.flag("/judged");
  integrity.repeated = count(members, "/repeated");
  integrity.skipped = count(members, "/skipped");
  integrity.foreign = count(members, "/foreign");
  members.ifThere("/out_of_order", integrity.outOfOrder,
                  [&members](const char* at) { return count(members, at); });
  // What the trace showed is written from this version on; before, the counter was all.
  integrity.executed = integrity.judged ? report.counters.executed : 0;
  members.ifThere("/judged_executed", integrity.executed,
                  [&members](const char* at) { return count(members, at); });
}

live::Summary liveOf(Members& members) {
  live::Summary live;
  live.source = members.text("/live/source");
  live.lines = count(members, "/live/lines");
  live.accepted = count(members, "/live/accepted");
  live.merged = count(members, "/live/merged");
  live.lastLine = count(members, "/live/executed_to_line");
  live.windows = count(members, "/live/windows");
  live.shortWindows = count(members, "/live/short_windows");
  live.delay = durationsOf(members, "/live/delay_ms");
  live.delay.p90 = milliseconds(members, "/live/delay_ms/p90");
  live.delay.count = live.delay.max.count() > 0 ? live.accepted : 0;
  live.windowTime = milliseconds(members, "/live/window_ms");
  live.leastDelay = milliseconds(members, "/live/delay_in_theory_ms/least");
  live.mostDelay = milliseconds(members, "/live/delay_in_theory_ms/most");
  if (members.has("/live/refused")) {
    live.refusal = base::makeError(codeOf(members.text("/live/refused/code")),
                                   members.text("/live/refused/message"));
  }
  return live;
}

streaming::RunReport reportOf(Members& members) {
  streaming::RunReport report;
  report.outcome = outcomeOf(members, "/outcome");
  members.ifThere("/program", report.programName,
                  [&members](const char* at) { return members.text(at); });
  readPoints(members, report);
  report.duration = seconds(members, "/duration_s");
  readPauses(members, report);
  report.access.perNode = durationsOf(members, "/access_ms");
  report.access.perRequest = durationsOf(members, "/request_ms");
  report.access.requests = count(members, "/requests");
  report.access.perNode.count = report.access.requests;
  report.access.perRequest.count = report.access.requests;
  report.settings = runSettingsOf(members);
  if (members.has("/resumed_from")) {
    report.settings.resume.emplace();
    report.settings.resume->point = count(members, "/resumed_from");
  }
  if (members.has("/transfer")) {
    report.transfer = {members.flag("/transfer/written"), members.flag("/transfer/compared"),
                       members.flag("/transfer/selected")};
  }
  readAccessForms(members, report);
  if (members.has("/checkpoint")) {
    report.checkpoint = checkpointOf(members);
  }
  if (members.has("/stop_confirmed_ms")) {
    report.stopConfirmedAfter = milliseconds(members, "/stop_confirmed_ms");
  }
  if (members.has("/live")) {
    report.live = liveOf(members);
  }
  members.ifThere("/slowed_by", report.slowedBy,
                  [&members](const char* at) { return members.text(at); });
  if (members.has("/error")) {
    report.error =
        base::makeError(codeOf(members.text("/error/code")), members.text("/error/message"));
  }
  return report;
}

/// As `toolsJson` writes it.
trace::ToolUse toolOf(Members& item) {
  trace::ToolUse use;
  if (const nlohmann::json* number = item.find("/tool"); number != nullptr && number->is_number()) {
    use.number = item.integer<int>("/tool", 0.0, kJsonCountMax);
  }
  use.name = item.text("/name");
  use.change = seconds(item, "/change_s");
  use.inSpindle = seconds(item, "/in_spindle_s");
  use.turning = seconds(item, "/turning_s");
  use.cooling = seconds(item, "/coolant_s");
  use.perMinLeast = item.number("/per_min/0", 0.0, kJsonCountMax);
  use.perMinMost = item.number("/per_min/1", 0.0, kJsonCountMax);
  use.clockwise = item.flag("/clockwise");
  use.counterclockwise = item.flag("/counterclockwise");
  use.flood = item.flag("/flood");
  use.mist = item.flag("/mist");
  for (const std::string& offset : item.words("/work_offsets")) {
    const auto number = base::parseInteger(std::string_view(offset).substr(offset.empty() ? 0 : 1));
    if (!number || offset.front() != 'G') {
      item.refuse("/work_offsets");
    }
    use.workOffsets.push_back(number.value_or(0));
  }
  return use;
}

/// What whoever made the run knew of it.
streaming::RunSummary knownOf(Members& members) {
  streaming::RunSummary known;
  const auto text = [&members](const char* at) { return members.text(at); };
  members.ifThere("/id", known.id, text);
  members.ifThere("/program_file", known.programFile, text);
  members.ifThere("/program_hash", known.programHash, text);
  members.ifThere("/endpoint", known.endpoint, text);
  members.ifThere("/tool_version", known.toolVersion, text);
  members.ifThere("/recording", known.recording, text);
  members.ifThere("/owns_recording", known.ownsRecording,
                  [&members](const char* at) { return members.flag(at); });
  members.ifThere("/dry_run_mm", known.dryRunMm,
                  [&members](const char* at) { return members.number(at, 0.0, job::kRaiseMmMax); });
  if (members.has("/job_times")) {
    known.jobTimes = {
        seconds(members, "/job_times/streamed_s"), seconds(members, "/job_times/pauses_s"),
        seconds(members, "/job_times/native_s"), seconds(members, "/job_times/tool_change_s"),
        seconds(members, "/job_times/handover_s")};
  }
  if (members.has("/tools")) {
    forEach(members, "/tools", [&known](Members& item) { known.tools.push_back(toolOf(item)); });
  }
  return known;
}

ordered_json knownJson(const streaming::RunSummary& known) {
  const streaming::RunOrigin& origin = known.origin;
  ordered_json json{
      {kFinishedFormatKey, kFinishedFormat},
      {"id", known.id},
      {"program_file", known.programFile},
      {"program_hash", known.programHash},
      {"endpoint", known.endpoint},
      {"started_by",
       {{"user", origin.user}, {"computer", origin.computer}, {"at_utc", origin.startedAtUtc}}},
      {"tool_version", known.toolVersion},
      {"recording", known.recording},
      {"owns_recording", known.ownsRecording}};
  if (known.dryRunMm > 0.0) {
    json["dry_run_mm"] = known.dryRunMm;
  }
  if (known.jobTimes) {
    json["job_times"] = jobTimesJson(*known.jobTimes);
  }
  if (!known.tools.empty()) {
    json["tools"] = toolsJson(known.tools);
  }
  return json;
}

std::vector<gcode::SketchPoint> sketchOf(Members& members) {
  std::vector<gcode::SketchPoint> sketch;
  forEach(members, "/sketch", [&sketch](Members& item) {
    gcode::SketchPoint point;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const std::string at = fmt::format("/mm/{}", axis);
      point.positionMm.set(axis, item.number(at.c_str(), -kJsonPlaceMax, kJsonPlaceMax));
    }
    item.ifThere("/rapid", point.isRapid, [&item](const char* at) { return item.flag(at); });
    sketch.push_back(point);
  });
  return sketch;
}

/// Nothing if a file of this version, or of one before there were versions, may be read on.
std::optional<base::Error> refusal(Members& members, const fs::path& file) {
  const bool hasVersion = members.has((std::string("/") + kFinishedFormatKey).c_str());
  if (hasVersion && members.integer<int>((std::string("/") + kFinishedFormatKey).c_str(), 1,
                                         kJsonCellMax) > kFinishedFormat) {
    return base::makeError(
        ReportError::NewerVersion,
        "The report was written by a later version of Rivulet. Use that one to open it.",
        file.string());
  }
  if (!hasVersion && !(members.has("/outcome") && members.has("/settings"))) {
    return base::makeError(ReportError::NotAReport,
                           "This is not the report of a run. Choose a file that the Runs page or "
                           "stream --json has written.",
                           file.string());
  }
  return std::nullopt;
}

base::Error damaged(const Members& members, const fs::path& file) {
  return base::makeError(
      ReportError::Damaged,
      fmt::format("The report is damaged: its member {} is missing or cannot be right.",
                  members.bad()),
      file.string());
}

}  // namespace

std::error_code make_error_code(ReportError code) {
  static const base::NamedCategory category("report");
  return {static_cast<int>(code), category};
}

ordered_json finishedRunJson(const FinishedRun& run) {
  ordered_json json = knownJson(run.summary);
  json.update(runJson(run.report));
  if (run.report.integrity.judged) {
    json["judged_executed"] = run.report.integrity.executed;
  }
  if (run.report.settings.resume) {
    json["resumed_from"] = run.report.settings.resume->point;
  }
  ordered_json sketch = ordered_json::array();
  for (const gcode::SketchPoint& point : run.sketch) {
    ordered_json item{{"mm", {point.positionMm.x, point.positionMm.y, point.positionMm.z}}};
    if (point.isRapid) {
      item["rapid"] = true;
    }
    sketch.push_back(std::move(item));
  }
  json["sketch"] = std::move(sketch);
  return json;
}

base::Result<FinishedRun> finishedRunOf(const nlohmann::json& json, const fs::path& file) {
  Members members(json);
  if (const auto refused = refusal(members, file)) {
    return base::fail(*refused);
  }
  FinishedRun run;
  run.report = reportOf(members);
  run.sketch = sketchOf(members);
  run.summary = streaming::summaryOf(run.report, knownOf(members));
  return members.bad().empty() ? base::Result<FinishedRun>(std::move(run))
                               : base::fail(damaged(members, file));
}

base::Result<FinishedRun> readFinishedRun(const fs::path& file) {
  const base::Result<std::string> text = base::readFile(file, kJsonBytesMax);
  return text ? finishedRunOf(nlohmann::json::parse(*text, nullptr, false), file)
              : base::Result<FinishedRun>(base::fail(text.error()));
}

ordered_json summaryJson(const streaming::RunSummary& summary) {
  ordered_json json = knownJson(summary);
  json["program"] = summary.programName;
  json["method"] = base::methodName(summary.method);
  json["points_per_loop"] = summary.pointsPerLoop;
  json["feed_mm_per_min"] = base::mmPerMinFromMmPerS(summary.feedMmPerS);
  if (summary.overrideFactor) {
    json["override"] = *summary.overrideFactor;
  }
  json["delta_mm"] = summary.deltaMm;
  json["run_number"] = summary.runNumber;
  json["outcome"] = streaming::outcomeName(summary.outcome);
  json["finding"] = streaming::runFindingName(summary.finding);
  json["judged"] = summary.judged;
  json["executed"] = summary.executed;
  json["points"] = summary.total;
  json["repeated"] = summary.repeated;
  json["skipped"] = summary.skipped;
  json["foreign"] = summary.foreign;
  json["out_of_order"] = summary.outOfOrder;
  json["duration_s"] = base::toSeconds(summary.duration);
  json["pauses"] = summary.pauses;
  json["paused_s"] = base::toSeconds(summary.paused);
  return json;
}

base::Result<streaming::RunSummary> summaryOf(const nlohmann::json& json, const fs::path& file) {
  using streaming::RunFinding;
  Members members(json);
  members.integer<int>((std::string("/") + kFinishedFormatKey).c_str(), 1, kFinishedFormat);
  streaming::RunSummary summary = knownOf(members);
  summary.programName = members.text("/program");
  summary.origin = {members.text("/started_by/user"), members.text("/started_by/computer"),
                    members.text("/started_by/at_utc")};
  const auto method = base::methodFromName(members.text("/method"));
  if (!method) {
    members.refuse("/method");
  }
  summary.method = method.value_or(summary.method);
  summary.pointsPerLoop = members.integer<int>("/points_per_loop", 1, kJsonCellMax);
  summary.feedMmPerS =
      base::mmPerSFromMmPerMin(members.number("/feed_mm_per_min", 0.0, kJsonCountMax));
  if (members.has("/override")) {
    summary.overrideFactor = members.number("/override", gcode::kOverrideMin, gcode::kOverrideMax);
  }
  summary.deltaMm = members.number("/delta_mm", 0.0, kJsonPlaceMax);
  summary.runNumber = members.integer<int>("/run_number", 0, kJsonCellMax);
  summary.outcome = outcomeOf(members, "/outcome");
  summary.finding =
      named(members, "/finding",
            std::array{RunFinding::Faulty, RunFinding::NotJudged, RunFinding::Faultless},
            streaming::runFindingName);
  summary.judged = members.flag("/judged");
  summary.executed = count(members, "/executed");
  summary.total = count(members, "/points");
  summary.repeated = count(members, "/repeated");
  summary.skipped = count(members, "/skipped");
  summary.foreign = count(members, "/foreign");
  summary.outOfOrder = count(members, "/out_of_order");
  summary.duration = seconds(members, "/duration_s");
  summary.pauses = count(members, "/pauses");
  summary.paused = seconds(members, "/paused_s");
  return members.bad().empty() ? base::Result<streaming::RunSummary>(std::move(summary))
                               : base::fail(damaged(members, file));
}

}  // namespace rivulet::report
