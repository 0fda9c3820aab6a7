// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report_reader.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/report_json.h"
#include "report/run_fields.h"

namespace rivulet::report {
namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;

constexpr int kFinishedFormat = 1;
constexpr const char* kFinishedFormatKey = "rivulet_finished_run";
streaming::RunReport reportOf(Members& members) {
  streaming::RunReport report;
  FieldReader io(members);
  runFields(io, report);
  // What the trace showed is written from this version on; before, the counter was all.
  report.integrity.executed = report.integrity.judged ? report.counters.executed : 0;
  io.ifThere().count("judged_executed", report.integrity.executed);
  report.access.perNode.count = report.access.requests;
  report.access.perRequest.count = report.access.requests;
  io.object("settings", report.settings, settingsFields);
  io.ifThere().object("started_by", report.settings.origin, originFields);
  if (members.has("/resumed_from")) {
    io.count("resumed_from", report.settings.resume.emplace().point);
  }
  if (report.live) {
    trace::DurationStatistics& delay = report.live->delay;
    delay.count = delay.max.count() > 0 ? report.live->accepted : 0;
  }
  return report;
}

streaming::RunSummary knownOf(Members& members) {
  streaming::RunSummary known;
  FieldReader io(members);
  knownFields(io, known);
  return known;
}

ordered_json knownJson(const streaming::RunSummary& known) {
  ordered_json json{{kFinishedFormatKey, kFinishedFormat}};
  FieldWriter io(json);
  knownFields(io, known);
  return json;
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
  json["sketch"] = listOf(run.sketch, sketchFields);
  return json;
}

base::Result<FinishedRun> finishedRunOf(const nlohmann::json& json, const fs::path& file) {
  Members members(json);
  if (const auto refused = refusal(members, file)) {
    return base::fail(*refused);
  }
  FinishedRun run;
  run.report = reportOf(members);
  FieldReader(members).ifThere().list("sketch", run.sketch, sketchFields);
  run.summary = streaming::summaryOf(run.report, knownOf(members));
  return members.bad().empty() ? base::Result<FinishedRun>(std::move(run))
                               : base::fail(damaged(members, file));
}

base::Result<FinishedRun> readFinishedRun(const fs::path& file) {
  const auto json = readJson(file);
  return json ? finishedRunOf(*json, file) : base::fail(json.error());
}

ordered_json summaryJson(const streaming::RunSummary& summary) {
  ordered_json json = knownJson(summary);
  FieldWriter io(json);
  summaryFields(io, summary);
  return json;
}

base::Result<streaming::RunSummary> summaryOf(const nlohmann::json& json, const fs::path& file) {
  Members members(json);
  members.integer<int>((std::string("/") + kFinishedFormatKey).c_str(), 1, kFinishedFormat);
  streaming::RunSummary summary = knownOf(members);
  if (!members.has("/started_by")) {
    members.refuse("/started_by");
  }
  FieldReader io(members);
  summaryFields(io, summary);
  return members.bad().empty() ? base::Result<streaming::RunSummary>(std::move(summary))
                               : base::fail(damaged(members, file));
}

}  // namespace rivulet::report
