// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The fields of a run's report and of its line in the history, for `json_fields`
/// (docs/formats.md). @threadsafety plain values.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "base/text.h"
#include "gcode/sketch.h"
#include "job/dry_plan.h"
#include "report/json_fields.h"
#include "streaming/run/run.h"
#include "streaming/run/run_summary.h"
#include "templates/flexible_program.h"

namespace rivulet::report {

inline auto outcomeOfName() {
  using streaming::Outcome;
  return nameAmong(std::array{Outcome::Failed, Outcome::Completed, Outcome::Stopped},
                   streaming::outcomeName);
}

/// No window lasts longer, s, and no feed is greater, mm/s.
inline constexpr double kWindowSMost = 1e6;

/// Of a machine that was tested, or whose limits were entered.
inline constexpr auto serverFields = [](auto& io, auto& server) {
  io.text("application_uri", server.applicationUri);
  io.text("product", server.productName);
  io.text("version", server.softwareVersion);
  io.text("build", server.buildNumber);
};

template <class Io, class Durations>
void durationFields(Io& io, Durations& durations) {
  io.milliseconds("mean", durations.mean);
  io.milliseconds("p50", durations.p50);
  io.milliseconds("p95", durations.p95);
  io.milliseconds("p99", durations.p99);
  io.milliseconds("max", durations.max);
}

inline constexpr auto durationList = [](auto& io, auto& durations) {
  durationFields(io, durations);
};

inline constexpr auto pauseFields = [](auto& io, auto& pause) {
  using trace::PauseOrigin;
  io.seconds("start_s", pause.start);
  io.milliseconds("duration_ms", pause.duration);
  io.named(
      "origin", pause.origin, trace::pauseOriginName,
      nameAmong(std::array{PauseOrigin::Measured, PauseOrigin::Inferred, PauseOrigin::Predicted},
                trace::pauseOriginName));
};

/// An order of the feed cell. The first is at 0 s.
inline constexpr auto feedFields = []<class Io>(Io& io, auto& event) {
  io.seconds("at_s", event.at);
  io.number("percent", event.percent, -1e9, 1e9);
  io.ifSet().flag("foreign", event.isForeign);
  io.ifSet().flag("source", event.isSource);
  io.seconds("lasted_s", event.lasted);
  maybe(io, "stood", event.stoodAfter,
        [](auto& inner, auto& after) { inner.seconds("after_s", after); });
};

/// A source of factors of the override.
inline constexpr auto factorFields = [](auto& io, auto& factor) {
  io.text("source", factor.count.source);
  io.count("values", factor.count.values);
  io.count("refused", factor.count.refused);
  io.count("silences", factor.count.silences);
  io.count("written", factor.written);
  io.number("least", factor.least, 0.0, templates::kFactorMax);
  io.number("most", factor.most, 0.0, templates::kFactorMax);
  io.object("delay_ms", factor.delay, durationList);
};

inline constexpr auto formFields = [](auto& io, auto& proof) {
  io.named("form", proof.form, opcua::groupingName, opcua::groupingFromName);
  io.flag("writes", proof.writes);
  io.flag("reads", proof.reads);
  io.ifSet().text("why_not", proof.why);
};

inline constexpr auto liveFields = [](auto& io, auto& live) {
  io.text("source", live.source);
  io.count("lines", live.lines);
  io.count("accepted", live.accepted);
  io.ifSet().count("executed", live.executed);
  io.count("merged", live.merged);
  io.count("executed_to_line", live.lastLine);
  io.count("windows", live.windows);
  io.count("short_windows", live.shortWindows);
  io.object("delay_ms", live.delay, [](auto& delayIo, auto& delay) {
    durationFields(delayIo, delay);
    delayIo.milliseconds("p90", delay.p90);
  });
  io.milliseconds("window_ms", live.windowTime);
  io.object("delay_in_theory_ms", live, [](auto& theoryIo, auto& of) {
    theoryIo.milliseconds("least", of.leastDelay);
    theoryIo.milliseconds("most", of.mostDelay);
  });
  io.error("refused", live.refusal);
};

inline constexpr auto feedLimitFields = [](auto& io, auto& feeds) {
  io.number("override", feeds.overrideFactor, gcode::kOverrideMin, gcode::kOverrideMax);
  io.number("rapid_mm_per_s", feeds.rapidMmPerS, kJsonAbove0, kJsonCountMax);
  io.number("limit_mm_per_s", feeds.feedMmPerSMax, kJsonAbove0, kJsonCountMax);
};

inline constexpr auto checkpointFields = []<class Io>(Io& io, auto& checkpoint) {
  if constexpr (Io::kReads) {
    checkpoint.granted = true;  // of earlier versions, which kept no others
  }
  io.number("run_number", checkpoint.runNumber, 1, streaming::kRunNumberMax);
  io.count("first_point", checkpoint.firstPoint);
  io.ifThere().flag("granted", checkpoint.granted);
  io.ifThere().flag("pauses_placed", checkpoint.pausesPlaced);
  io.ifSet().number("window_s_max", checkpoint.windowSMax, 0.0, kWindowSMost);
  io.ifSet().number("window_feed_mm_per_s", checkpoint.windowFeedMmPerS, 0.0, kWindowSMost);
  io.place("start_mm", checkpoint.startMm);
  io.ifThere().numbers("start_deg", checkpoint.startDeg, -kJsonPlaceMax, kJsonPlaceMax);
  io.ifThere().count("points", checkpoint.pointCount);
  if (Io::kReads || checkpoint.pointsHash != 0) {
    io.ifThere().hexadecimal("points_hash", checkpoint.pointsHash);
  }
};

inline constexpr auto originFields = [](auto& io, auto& origin) {
  io.text("user", origin.user);
  io.text("computer", origin.computer);
  io.text("at_utc", origin.startedAtUtc);
};

template <class Io, class Parameters>
void cellFields(Io& io, Parameters& parameters) {
  io.number("points_per_loop", parameters.pointsPerLoop, 1, kJsonCellMax);
  io.number("windows", parameters.windows, 1, templates::WindowProtocol::kWindowsMax);
  io.number("base_cell", parameters.baseCell, 0, kJsonCellMax);
  io.ifThere().number("slot_stride", parameters.slotStride, 0, kJsonCellMax);
  io.ifThere().number("r_parameters", parameters.rParameterCount, 0, kJsonCellMax);
  io.ifThere().number("correction_limit_mm", parameters.correctionLimitMm, 0.0,
                      templates::kCorrectionLimitMmMax);
  if (Io::kReads || parameters.liftMm != 0.0) {
    io.ifThere().number("lift_mm", parameters.liftMm, 0.0, templates::kLiftMmMax);
  }
  io.ifThere().number("silence_limit_s", parameters.silenceLimitS, 0.0,
                      templates::kSilenceLimitSMax);
  if (Io::kReads || parameters.hasFactor()) {
    io.ifThere().number("factor_least", parameters.factorLeast, 0.0, templates::kFactorMax);
    io.ifThere().number("factor_most", parameters.factorMost, 0.0, templates::kFactorMax);
  }
  io.ifThere().number("windows_ahead", parameters.windowsAhead, 0, kJsonCellMax);
  io.ifThere().flag("slow_down", parameters.slowDown);
  io.ifThere().named("layout", parameters.layout, templates::layoutName, templates::layoutFromName);
}

/// Refuses settings from which no flexible program can be made.
inline constexpr auto settingsFields = []<class Io>(Io& io, auto& settings) {
  auto& parameters = settings.parameters;
  io.ifThere().named("method", parameters.method, base::methodName, base::methodFromName);
  cellFields(io, parameters);
  if (Io::kReads || !settings.factor.address.empty()) {
    io.ifThere().text("factor_source", settings.factor.address);
    io.ifThere().seconds("factor_silence_s", settings.factor.silence);
    io.ifThere().flag("factor_holds", settings.factor.holdsInSilence);
  }
  io.ifThere().named("control", parameters.target, templates::targetName,
                     templates::targetFromName);
  std::string axes = templates::axisLetters(parameters);
  io.ifThere().text("axes", axes);
  if constexpr (Io::kReads) {
    if (!templates::chooseAxes(parameters, axes)) {
      io.refuse("axes");
    }
  }
  io.ifThere().number("delta_mm", settings.deltaMm, kJsonAbove0, kJsonCountMax);
  io.ifThere().named("passed_by", settings.passedBy, streaming::passedByName,
                     streaming::passedByFromName);
  io.ifThere().feed("feed_mm_per_min", settings.feedMmPerS, kJsonAbove0);
  io.ifThere().named("grouping", settings.grouping, opcua::groupingName, opcua::groupingFromName);
  io.ifThere().flag("monitor", settings.monitor);
  if constexpr (!Io::kReads) {
    io.text("feed", settings.programFeeds ? "program" : "fixed");
  }
  io.ifThere().flag("feed_per_point", parameters.feedPerPoint);
  if (Io::kReads || parameters.packed) {
    io.ifThere().flag("packed", parameters.packed);
  }
  io.ifSet().number("tolerance_mm", settings.tolerance, 0.0, gcode::kStreamToleranceMax);
  // In mm/s: a run is resumed with exactly the same feeds.
  maybe(io, "program_feeds", settings.programFeeds, [](auto& inner, auto& feeds) {
    if constexpr (!Io::kReads) {
      inner.count("override_percent", 100.0 * feeds.overrideFactor);
    }
    feedLimitFields(inner, feeds);
  });
  if constexpr (Io::kReads) {
    if (!templates::requireProgram(parameters)) {
      io.refuse();
    }
  }
};

inline constexpr auto mergedFields = [](auto& io, auto& merged) {
  io.count("of", merged.of);
  io.count("to", merged.to);
  io.number("tolerance_mm", merged.toleranceMm, 0.0, gcode::kStreamToleranceMax);
  io.number("deviation_mm", merged.deviationMm, 0.0, gcode::kStreamToleranceMax);
};

/// All but settings and origin. The pauses begin with the trace.
template <class Io, class Report>
void runFields(Io& io, Report& report) {
  io.named("outcome", report.outcome, streaming::outcomeName, outcomeOfName());
  io.ifThere().text("program", report.programName);
  maybe(io, "merged", report.merged, mergedFields);
  io.count("points", report.counters.total);
  io.count("sent", report.counters.sent);
  io.count("accepted", report.counters.accepted);
  io.count("executed", report.counters.executed);
  io.flag("judged", report.integrity.judged);
  io.count("repeated", report.integrity.repeated);
  io.count("skipped", report.integrity.skipped);
  io.count("foreign", report.integrity.foreign);
  io.ifThere().count("out_of_order", report.integrity.outOfOrder);
  io.seconds("duration_s", report.duration);
  io.ifThere().list("pauses", report.pauses, pauseFields);
  io.ifThere().list("holds", report.holds, pauseFields);
  io.ifThere().flag("left_held", report.leftHeld);
  io.ifThere().list("feed", report.feed, feedFields);
  maybe(io, "factor", report.factor, factorFields);
  io.object("access_ms", report.access.perNode, durationList);
  io.object("request_ms", report.access.perRequest, durationList);
  io.count("requests", report.access.requests);
  maybe(io, "live", report.live, liveFields);
  maybe(io, "transfer", report.transfer, [](auto& inner, auto& transfer) {
    inner.flag("written", transfer.written);
    inner.flag("compared", transfer.compared);
    inner.flag("selected", transfer.selected);
  });
  if (io.has("access_forms", report.accessForms)) {
    io.list("access_forms", report.accessForms->proofs, formFields);
  }
  maybe(io, "checkpoint", report.checkpoint, checkpointFields);
  if (io.has("stop_confirmed_ms", report.stopConfirmedAfter)) {
    io.milliseconds("stop_confirmed_ms", *report.stopConfirmedAfter);
  }
  io.ifSet().text("slowed_by", report.slowedBy);
  io.error("error", report.error);
}

inline constexpr auto jobTimeFields = []<class Io>(Io& io, auto& times) {
  io.seconds("streamed_s", times.streamed);
  io.seconds("pauses_s", times.pauses);
  io.seconds("native_s", times.native);
  io.seconds("tool_change_s", times.toolChange);
  io.seconds("handover_s", times.handover);
  if constexpr (!Io::kReads) {
    io.seconds("total_s", times.total());
  }
};

/// The runs of a tool in the spindle.
inline constexpr auto toolFields = []<class Io>(Io& io, auto& use) {
  io.nullable("tool", use.number);
  io.text("name", use.name);
  io.seconds("change_s", use.change);
  io.seconds("in_spindle_s", use.inSpindle);
  io.seconds("turning_s", use.turning);
  io.seconds("coolant_s", use.cooling);
  std::array<double, 2> perMin{use.perMinLeast, use.perMinMost};
  io.numbers("per_min", perMin, 0.0, kJsonCountMax);
  io.flag("clockwise", use.clockwise);
  io.flag("counterclockwise", use.counterclockwise);
  io.flag("flood", use.flood);
  io.flag("mist", use.mist);
  std::vector<std::string> offsets;
  for (const int offset : use.workOffsets) {
    offsets.push_back(fmt::format("G{}", offset));
  }
  io.words("work_offsets", offsets);
  if constexpr (Io::kReads) {
    use.perMinLeast = perMin[0];
    use.perMinMost = perMin[1];
    for (const std::string& offset : offsets) {
      const auto number =
          base::parseInteger(std::string_view(offset).substr(offset.empty() ? 0 : 1));
      if (!number || offset.front() != 'G') {
        io.refuse("work_offsets");
      }
      use.workOffsets.push_back(number.value_or(0));
    }
  }
};

/// What whoever made the run knew of it.
template <class Io, class Summary>
void knownFields(Io& io, Summary& known) {
  io.ifThere().text("id", known.id);
  io.ifThere().text("program_file", known.programFile);
  io.ifThere().text("program_hash", known.programHash);
  io.ifThere().text("endpoint", known.endpoint);
  io.ifThere().object("started_by", known.origin, originFields);
  io.ifThere().text("tool_version", known.toolVersion);
  io.ifThere().text("recording", known.recording);
  io.ifThere().flag("owns_recording", known.ownsRecording);
  io.ifSet().number("dry_run_mm", known.dryRunMm, 0.0, job::kRaiseMmMax);
  maybe(io, "job_times", known.jobTimes, jobTimeFields);
  io.ifSet().list("tools", known.tools, toolFields);
}

/// The line of a run in the table of the history.
template <class Io, class Summary>
void summaryFields(Io& io, Summary& summary) {
  using streaming::RunFinding;
  io.text("program", summary.programName);
  io.named("method", summary.method, base::methodName, base::methodFromName);
  io.number("points_per_loop", summary.pointsPerLoop, 1, kJsonCellMax);
  io.feed("feed_mm_per_min", summary.feedMmPerS);
  if (io.has("override", summary.overrideFactor)) {
    io.number("override", *summary.overrideFactor, gcode::kOverrideMin, gcode::kOverrideMax);
  }
  io.number("delta_mm", summary.deltaMm, 0.0, kJsonPlaceMax);
  io.number("run_number", summary.runNumber, 0, kJsonCellMax);
  io.named("outcome", summary.outcome, streaming::outcomeName, outcomeOfName());
  io.named("finding", summary.finding, streaming::runFindingName,
           nameAmong(std::array{RunFinding::Faulty, RunFinding::NotJudged, RunFinding::Faultless},
                     streaming::runFindingName));
  io.flag("judged", summary.judged);
  io.count("executed", summary.executed);
  io.count("points", summary.total);
  io.count("repeated", summary.repeated);
  io.count("skipped", summary.skipped);
  io.count("foreign", summary.foreign);
  io.count("out_of_order", summary.outOfOrder);
  io.seconds("duration_s", summary.duration);
  io.count("pauses", summary.pauses);
  io.seconds("paused_s", summary.paused);
}

inline constexpr auto sketchFields = [](auto& io, auto& point) {
  io.place("mm", point.positionMm);
  io.ifSet().flag("rapid", point.isRapid);
};

}  // namespace rivulet::report
