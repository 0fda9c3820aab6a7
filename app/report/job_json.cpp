// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/job_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/report_json.h"
#include "report/run_fields.h"

namespace rivulet::report {

using base::toSeconds;
using nlohmann::ordered_json;

ordered_json hazardsJson(const std::vector<forecast::Hazard>& hazards) {
  ordered_json all = ordered_json::array();
  for (const forecast::Hazard& hazard : hazards) {
    ordered_json json{{"kind", forecast::hazardName(hazard.kind)},
                      {"stops", hazard.stops()},
                      {"line", hazard.line.value},
                      {"stretch", hazard.stretch},
                      {"message", forecast::describe(hazard)}};
    if (!hazard.file.empty()) {
      json["file"] = hazard.file;
    }
    if (hazard.travel) {
      json["axis"] = std::string(1, hazard.travel->axis);
      json["target"] = hazard.travel->target;
      json["limits"] = {hazard.travel->min, hazard.travel->max};
    }
    all.push_back(std::move(json));
  }
  return all;
}

ordered_json jobTimesJson(const streaming::JobTimes& times) {
  return jsonOf(times, jobTimeFields);
}

ordered_json functionsJson(const std::vector<job::FunctionUse>& uses) {
  ordered_json json = ordered_json::array();
  for (const job::FunctionUse& use : uses) {
    json.push_back({{"name", job::textOf(use.name)},
                    {"number", use.name.number},
                    {"line", use.line.value},
                    {"count", use.count},
                    {"text", use.text},
                    {"assumed", use.isAssumed}});
  }
  return json;
}

ordered_json jobPlaceJson(const streaming::JobPlace& place) {
  ordered_json json{{"stretch", place.stretch}, {"executed", place.executed},
                    {"points", place.total},    {"native_block", place.native},
                    {"line", place.line.value}, {"message", streaming::describe(place)}};
  if (!place.file.empty()) {
    json["file"] = place.file;
  }
  return json;
}

namespace {

ordered_json partJson(const job::Part& part, const streaming::JobTimes& times) {
  ordered_json json;
  if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
    json = {{"kind", "native"},
            {"line", native->place.line.value},
            {"reason", job::nativeReasonName(native->reason)}};
  } else {
    json = {{"kind", "streamed"}, {"stretch", std::get<job::Stretch>(part).number}};
  }
  json["times"] = jobTimesJson(times);
  return json;
}

}  // namespace

ordered_json toolsJson(const std::vector<trace::ToolUse>& uses) {
  return listOf(uses, toolFields);
}

ordered_json wholeJobJson(const job::Plan& plan, const streaming::WholeJobReport& report) {
  std::size_t executed = 0;
  ordered_json runs = ordered_json::array();
  for (const streaming::StretchReport& stretch : report.stretches) {
    executed += stretch.run.counters.executed;
    runs.push_back({{"stretch", stretch.number},
                    {"outcome", streaming::outcomeName(stretch.run.outcome)},
                    {"points", stretch.run.counters.total},
                    {"executed", stretch.run.counters.executed},
                    {"start_mm", {stretch.startMm.x, stretch.startMm.y, stretch.startMm.z}},
                    {"duration_s", toSeconds(stretch.run.duration)}});
  }
  ordered_json parts = ordered_json::array();
  for (std::size_t part = 0; part < report.partTimes.size(); ++part) {
    if (report.partTimes[part].total() > base::Duration{}) {
      parts.push_back(partJson(plan.parts[part], report.partTimes[part]));
    }
  }
  ordered_json json{{"outcome", streaming::outcomeName(report.outcome)},
                    {"run_number", report.runNumber},
                    {"stretches", plan.stretchCount()},
                    {"native_blocks", plan.nativeCount()},
                    {"executed_points", executed},
                    {"reached", jobPlaceJson(report.reached)},
                    {"times", jobTimesJson(report.times)},
                    {"runs", runs},
                    {"parts", parts}};
  if (!report.feed.empty()) {
    json["feed"] = feedJson(report.feed);
  }
  if (report.factor) {
    json["factor"] = factorJson(*report.factor);
  }
  json["left_held"] = report.leftHeld;
  if (report.controlTrace) {
    json["tools"] = toolsJson(report.tools);
  }
  json["judged"] = report.integrity.judged;
  if (report.integrity.judged) {
    json["repeated"] = report.integrity.repeated;
    json["skipped"] = report.integrity.skipped;
    json["foreign"] = report.integrity.foreign;
  }
  json["error"] = report.error.code ? errorJson(report.error) : ordered_json();
  return json;
}

std::string describe(const trace::ToolUse& use) {
  std::string text =
      use.number || !use.name.empty()
          ? fmt::format("tool {}{}: {:.1f} s change, {:.1f} s in the spindle",
                        use.number.value_or(0), use.name.empty() ? "" : " " + use.name,
                        toSeconds(use.change), toSeconds(use.inSpindle))
          : fmt::format("before the first change: {:.1f} s", toSeconds(use.inSpindle));
  if (use.perMinMost > 0.0) {
    text += use.perMinLeast < use.perMinMost
                ? fmt::format(", turning {:.1f} s at {:.0f} to {:.0f} 1/min",
                              toSeconds(use.turning), use.perMinLeast, use.perMinMost)
                : fmt::format(", turning {:.1f} s at {:.0f} 1/min", toSeconds(use.turning),
                              use.perMinMost);
  }
  if (use.cooling > base::Duration{}) {
    text += fmt::format(", coolant {:.1f} s", toSeconds(use.cooling));
  }
  for (const int offset : use.workOffsets) {
    text += fmt::format(", G{}", offset);
  }
  return text;
}

std::string describe(const streaming::JobTimes& times) {
  return fmt::format(
      "{:.1f} s streamed, {:.1f} s pauses, {:.1f} s blocks of the control, {:.1f} s tool changes, "
      "{:.1f} s handovers; {:.1f} s in all",
      toSeconds(times.streamed), toSeconds(times.pauses), toSeconds(times.native),
      toSeconds(times.toolChange), toSeconds(times.handover), toSeconds(times.total()));
}

}  // namespace rivulet::report
