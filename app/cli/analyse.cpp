// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "base/file.h"
#include "cli/commands.h"
#include "report/report_json.h"
#include "trace/analysis/integrity.h"
#include "trace/analysis/pauses.h"
#include "trace/analysis/statistics.h"
#include "trace/recording.h"

namespace rivulet::cli {

namespace {

constexpr double kPointToleranceMm = 1e-6;

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
  trace::Integrity integrity;
  std::vector<trace::Pause> pauses = recording->pauses;
  base::Instant origin{};
  if (recording->controlTrace) {
    pauses = trace::findPauses(*recording->controlTrace);
    if (recording->pointsComplete) {
      integrity = trace::judgeIntegrity(recording->points.points, recording->controlTrace->blocks,
                                        kPointToleranceMm);
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
  const bool wrong = integrity.judged && !integrity.isFaultless();
  if (options.json) {
    nlohmann::ordered_json json{
        {"method", recording->start.method},
        {"program", recording->start.programName},
        {"endpoint", recording->start.endpoint},
        {"complete", recording->complete},
        {"unreadable_lines", recording->unreadableLines},
        {"outcome", recording->end ? recording->end->outcome : std::string("unknown")},
        {"points", recording->points.points.size()},
        {"judged", integrity.judged},
        {"executed", integrity.executed},
        {"repeated", integrity.repeated},
        {"skipped", integrity.skipped},
        {"foreign", integrity.foreign},
        {"out_of_order", integrity.outOfOrder},
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
             recording->end ? recording->end->outcome : std::string("cut off before its end"));
  if (recording->unreadableLines > 0) {
    fmt::print("  {} lines could not be read and were ignored\n", recording->unreadableLines);
  }
  if (integrity.judged) {
    fmt::print("  executed {} of {} points, repeated {}, skipped {}, foreign {}, out of order {}\n",
               integrity.executed, recording->points.points.size(), integrity.repeated,
               integrity.skipped, integrity.foreign, integrity.outOfOrder);
  } else {
    fmt::print("  not judged: the recording holds no trace of the control\n");
  }
  fmt::print("  {} pauses, {:.3f} s in total\n", pauses.size(), base::toSeconds(paused));
  fmt::print("  access per node: mean {:.2f} ms, p99 {:.2f} ms, max {:.2f} ms\n",
             base::toMilliseconds(access.mean), base::toMilliseconds(access.p99),
             base::toMilliseconds(access.max));
  return wrong ? Exit::Wrong : Exit::Done;
}

}  // namespace rivulet::cli
