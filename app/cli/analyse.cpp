// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "base/file.h"
#include "cli/commands.h"
#include "report/report_json.h"
#include "streaming/run.h"
#include "templates/cells.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/pauses.h"
#include "trace/analysis/statistics.h"
#include "trace/recording.h"

namespace rivulet::cli {

namespace {

using streaming::Outcome;
using streaming::RunFinding;

/// The report of a recorded run, as far as the finding depends on it.
streaming::RunReport reportOf(const trace::Recording& recording) {
  streaming::RunReport report;
  for (const Outcome outcome : {Outcome::Completed, Outcome::Stopped}) {
    if (recording.end && recording.end->outcome == streaming::outcomeName(outcome)) {
      report.outcome = outcome;
    }
  }
  report.counters.total = recording.points.points.size();
  if (recording.controlTrace && recording.pointsComplete) {
    templates::TemplateParameters axes;
    const std::string letters = recording.start.axes.empty() ? "XYZ" : recording.start.axes;
    static_cast<void>(templates::chooseAxes(axes, letters));
    report.integrity =
        trace::judgeRun(recording.points.points, *recording.controlTrace, axes.rotaryAxes);
  }
  return report;
}

/// The same as the run itself said. A recording without its end says nothing good.
RunFinding findingOf(const trace::Recording& recording, const streaming::RunReport& report) {
  if (recording.complete) {
    return report.finding();
  }
  const bool isWrong = report.integrity.judged && !report.integrity.isFaultless();
  return isWrong ? RunFinding::Faulty : RunFinding::NotJudged;
}

}  // namespace

Exit analyse(const AnalyseOptions& options) {
  const auto text = base::readFile(options.file);
  if (!text) {
    return reportError(text.error(), options.json);
  }
  const auto recording = trace::parseRecording(*text);
  if (!recording) {
    return reportError(recording.error(), options.json);
  }
  const streaming::RunReport report = reportOf(*recording);
  const trace::Integrity& integrity = report.integrity;
  const RunFinding finding = findingOf(*recording, report);
  std::vector<trace::Pause> pauses = recording->pauses;
  base::Instant origin{};
  if (recording->controlTrace) {
    if (!recording->controlTrace->truncated) {
      pauses = trace::findPauses(*recording->controlTrace);
    }
    if (!recording->controlTrace->samples.empty()) {
      origin = recording->controlTrace->samples.front().at;
    }
  }
  std::vector<base::Duration> perNode;
  for (const trace::Access& access : recording->accesses) {
    perNode.push_back(access.took / std::max(access.nodes, 1));
  }
  const trace::DurationStatistics access = trace::durationStatistics(perNode);
  base::Duration paused{};
  for (const trace::Pause& pause : pauses) {
    paused += pause.duration;
  }
  const bool wrong = finding == RunFinding::Faulty || !recording->complete;
  if (options.json) {
    nlohmann::ordered_json json{
        {"method", recording->start.method},
        {"program", recording->start.programName},
        {"endpoint", recording->start.endpoint},
        {"complete", recording->complete},
        {"unreadable_lines", recording->unreadableLines},
        {"outcome", recording->end ? recording->end->outcome : std::string("unknown")},
        {"finding", streaming::runFindingName(finding)},
        {"faultless", finding == RunFinding::Faultless},
        {"points", recording->points.points.size()},
        {"judged", integrity.judged},
        {"executed", integrity.executed},
        {"repeated", integrity.repeated},
        {"skipped", integrity.skipped},
        {"foreign", integrity.foreign},
        {"out_of_order", integrity.outOfOrder},
        {"duration_s", recording->end
                           ? nlohmann::ordered_json(base::toSeconds(recording->end->duration))
                           : nlohmann::ordered_json(nullptr)},
        {"pauses", report::pausesJson(pauses, origin)},
        {"paused_s", base::toSeconds(paused)},
        {"access_ms",
         {{"mean", base::toMilliseconds(access.mean)},
          {"p50", base::toMilliseconds(access.p50)},
          {"p95", base::toMilliseconds(access.p95)},
          {"p99", base::toMilliseconds(access.p99)},
          {"max", base::toMilliseconds(access.max)}}}};
    printJson(json);
    return wrong ? Exit::Wrong : Exit::Done;
  }
  fmt::print("{} with method {}, N {}, {}\n", recording->start.programName, recording->start.method,
             recording->start.pointsPerLoop,
             recording->end ? recording->end->outcome : std::string("outcome unknown"));
  if (!recording->complete) {
    fmt::print(
        "  the recording was cut off before the end of the run: its disk was full, or the "
        "program was ended\n");
  }
  if (recording->unreadableLines > 0) {
    fmt::print("  {} lines could not be read and were ignored\n", recording->unreadableLines);
  }
  if (integrity.judged) {
    fmt::print("  executed {} of {} points, repeated {}, skipped {}, foreign {}, out of order {}\n",
               integrity.executed, recording->points.points.size(), integrity.repeated,
               integrity.skipped, integrity.foreign, integrity.outOfOrder);
  } else {
    fmt::print("  not judged: {}\n",
               !recording->controlTrace             ? "the recording holds no trace of the control"
               : recording->controlTrace->truncated ? "the trace of the control is incomplete"
                                                    : "points are missing in the recording");
  }
  fmt::print("  {} pauses, {:.3f} s in total\n", pauses.size(), base::toSeconds(paused));
  fmt::print("  access per node: mean {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
             base::toMilliseconds(access.mean), base::toMilliseconds(access.p99),
             base::toMilliseconds(access.max));
  return wrong ? Exit::Wrong : Exit::Done;
}

}  // namespace rivulet::cli
