// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "report/run_fields.h"

namespace rivulet::report {

using nlohmann::ordered_json;

namespace {

/// A number, or null if there is none: JSON has no NaN.
ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

std::vector<trace::Pause> since(base::Instant origin, std::vector<trace::Pause> pauses) {
  for (trace::Pause& pause : pauses) {
    pause.start = base::Instant{pause.start - origin};
  }
  return pauses;
}

/// By the client's clock, which is not that of the trace.
std::vector<streaming::FeedEvent> sinceFirst(std::vector<streaming::FeedEvent> events) {
  const base::Instant origin = events.empty() ? base::Instant{} : events.front().at;
  for (streaming::FeedEvent& event : events) {
    event.at = base::Instant{event.at - origin};
  }
  return events;
}

}  // namespace

ordered_json errorJson(const base::Error& error) {
  return {{"code",
           std::string(error.code.category().name()) + ":" + std::to_string(error.code.value())},
          {"message", error.text()}};
}

ordered_json feedJson(const std::vector<streaming::FeedEvent>& events) {
  return listOf(sinceFirst(events), feedFields);
}

ordered_json factorJson(const streaming::FactorReport& factor) {
  return listOf(std::vector{factor}, factorFields).front();
}

ordered_json pausesJson(const std::vector<trace::Pause>& pauses, base::Instant origin) {
  return listOf(since(origin, pauses), pauseFields);
}

ordered_json faultsJson(const std::vector<trace::IntegrityFault>& faults, base::Instant origin) {
  const auto name = [](trace::IntegrityFault::Kind kind) {
    switch (kind) {
      case trace::IntegrityFault::Kind::Repeated:
        return "repeated";
      case trace::IntegrityFault::Kind::Skipped:
        return "skipped";
      case trace::IntegrityFault::Kind::Foreign:
        return "foreign";
      case trace::IntegrityFault::Kind::OutOfOrder:
        return "out-of-order";
    }
    return "";
  };
  ordered_json list = ordered_json::array();
  for (const trace::IntegrityFault& fault : faults) {
    list.push_back({{"kind", name(fault.kind)},
                    {"point", fault.point.value},
                    {"at_s", base::toSeconds(fault.at - origin)}});
  }
  return list;
}

ordered_json accessFormsJson(const streaming::AccessForms& forms) {
  return listOf(forms.proofs, formFields);
}

ordered_json runJson(const streaming::RunReport& report) {
  const bool traced = report.controlTrace && !report.controlTrace->samples.empty();
  const base::Instant origin =
      traced ? report.controlTrace->samples.front().at
             : (report.pauses.empty() ? base::Instant{} : report.pauses.front().start);
  streaming::RunReport shown = report;
  shown.pauses = since(origin, std::move(shown.pauses));
  shown.holds = since(origin, std::move(shown.holds));
  shown.feed = sinceFirst(std::move(shown.feed));
  ordered_json json{{"faultless", report.isFaultless()},
                    {"finding", streaming::runFindingName(report.finding())},
                    {"method", base::methodName(report.settings.parameters.method)}};
  FieldWriter io(json);
  runFields(io, std::as_const(shown));
  json["settings"] = jsonOf(report.settings, settingsFields);
  if (report.wrong) {
    json["wrong_motion_seen"] = streaming::describe(*report.wrong);
  }
  if (!report.integrity.faults.empty()) {
    json["faults"] = faultsJson(report.integrity.faults, origin);
  }
  return json;
}

ordered_json verdictJson(const feasibility::Verdict& verdict) {
  const auto condition = [](const feasibility::Condition& item) {
    ordered_json json{{"equation", feasibility::equationLabel(item.equation)},
                      {"margin", numberOrNull(item.margin)},
                      {"holds", item.margin > 1.0},
                      {"decides", item.decides}};
    if (item.place) {
      json["lines"] = {item.place->firstLine.value, item.place->lastLine.value};
    }
    return json;
  };
  ordered_json conditions = ordered_json::array();
  for (const feasibility::Condition& item : verdict.conditions) {
    conditions.push_back(condition(item));
  }
  return {{"feasible", verdict.feasible},
          {"waits", verdict.waits},
          {"limiting", condition(verdict.limiting)},
          {"feed_mm_per_min_max", base::mmPerMinFromMmPerS(verdict.feedMmPerSMax)},
          {"delta_mm_min", verdict.deltaMmMin},
          {"conditions", conditions}};
}

ordered_json overrideLimitJson(const streaming::OverrideLimit& limit) {
  return {{"override_percent_max", 100.0 * limit.overrideFactor},
          {"line", limit.line.value},
          {"feed_mm_per_min", base::mmPerMinFromMmPerS(limit.feedMmPerS)},
          {"step_mm", limit.stepMm},
          {"rapid", limit.isRapid}};
}

ordered_json mergedJson(const gcode::MergedMoves& merged) {
  return jsonOf(merged, mergedFields);
}

ordered_json distancesJson(const feasibility::ProgramDistances& distances) {
  return {
      {"d_min_mm", distances.pointDistanceMmMin},
      {"d_min_lines",
       {distances.pointDistancePlace.firstLine.value, distances.pointDistancePlace.lastLine.value}},
      {"window_steps", distances.windowSteps},
      {"d_min_n_mm", distances.windowLengthMmMin},
      {"d_min_n_lines",
       {distances.windowPlace.firstLine.value, distances.windowPlace.lastLine.value}}};
}

ordered_json factsJson(const gcode::ProgramFacts& facts) {
  const auto ifComplete = [&facts](auto value) {
    return facts.complete ? ordered_json(value) : ordered_json(nullptr);
  };
  // Lengths and bounds in two units at once are meaningless.
  const bool measured = facts.complete && facts.units != gcode::FileUnits::Mixed;
  const bool lengths = measured && facts.lengthsKnown;
  ordered_json bounds = ordered_json::object();
  for (std::size_t axis = 0; axis < gcode::kProgrammedAxisCount; ++axis) {
    const std::string name(1, gcode::kProgrammedAxes[axis]);
    const auto& range = facts.bounds[axis];
    if (facts.boundsUnknown[axis]) {
      bounds[name] = nullptr;
    } else if (range) {
      bounds[name] = {range->smallest, range->largest};
    }
  }
  // The length of arcs whose ends do not fit is not known.
  const bool arcsFit = facts.arcRadiusMismatch <= nc::kArcRadiusToleranceMm;
  ordered_json json;
  for (std::size_t g = 0; g < facts.motions.size(); ++g) {
    json["n_G" + std::to_string(g)] = ifComplete(facts.motions[g]);
  }
  json["n_Gdefault"] = ifComplete(facts.defaultMotions);
  json["n_mcs_moves"] = ifComplete(facts.machineMotions);
  json["n_other_motion"] = ifComplete(facts.otherMotions);
  json["units"] = gcode::fileUnitsName(facts.units);
  json["bbox_programmed"] = measured ? bounds : ordered_json(nullptr);
  json["g1_length"] = lengths ? ordered_json(facts.g1Length) : ordered_json(nullptr);
  json["g1_excluded"] = ifComplete(facts.g1Excluded);
  json["arc_length"] = lengths && arcsFit ? ordered_json(facts.arcLength) : ordered_json(nullptr);
  json["arc_excluded"] = ifComplete(facts.arcExcluded);
  json["arc_radius_mismatch"] = ifComplete(facts.arcRadiusMismatch);
  json["arc_centres"] = gcode::centreReadingName(facts.centreReading);
  json["feeds"] = ifComplete(facts.feeds);
  return json;
}

ordered_json statisticsJson(const feasibility::PathStatistics& statistics) {
  return {
      {"points", statistics.points},
      {"duplicates", statistics.duplicates},
      {"distance_mm",
       {{"min", statistics.distanceMmMin},
        {"median", statistics.distanceMmMedian},
        {"max", statistics.distanceMmMax}}},
      {"histogram",
       {{"borders_mm", statistics.distances.bordersMm}, {"counts", statistics.distances.counts}}},
      {"corners",
       {{"counts_per_15_deg", statistics.angles.counts},
        {"max_deg", statistics.angles.degreesMax},
        {"line", statistics.angles.line.value}}}};
}

ordered_json programJson(const gcode::Program& program) {
  const gcode::Statistics& statistics = program.statistics;
  ordered_json bounds = ordered_json::object();
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isfinite(statistics.minMm[axis])) {
      bounds[std::string(1, base::kAxisNames[axis])] = {statistics.minMm[axis],
                                                        statistics.maxMm[axis]};
    }
  }
  ordered_json diagnostics = ordered_json::array();
  for (const gcode::Diagnostic& diagnostic : program.diagnostics) {
    diagnostics.push_back({{"severity", gcode::severityName(diagnostic.severity)},
                           {"line", diagnostic.line.value},
                           {"column", diagnostic.column},
                           {"code", gcode::diagnosticName(diagnostic.code)},
                           {"accept", gcode::acceptableName(diagnostic)},
                           {"message", gcode::describe(diagnostic)}});
    if (!diagnostic.file.empty()) {
      diagnostics.back()["file"] = diagnostic.file;
    }
    if (diagnostic.count > 1) {
      diagnostics.back()["count"] = diagnostic.count;
    }
  }
  const auto lineWithoutFeed = gcode::lineWithoutFeed(program.trajectory);
  return {{"file", program.name},
          {"hash", program.hash},
          {"dialect", gcode::dialectName(program.dialect)},
          {"lines", statistics.lines},
          {"motions",
           {{"g0", statistics.motions[0]},
            {"g1", statistics.motions[1]},
            {"g2", statistics.motions[2]},
            {"g3", statistics.motions[3]}}},
          {"points", statistics.points},
          {"bounds", bounds},
          {"length_mm", {{"rapid", statistics.rapidLengthMm}, {"cut", statistics.cutLengthMm}}},
          {"feeds", statistics.feedsMmPerMin},
          {"line_without_feed",
           lineWithoutFeed ? ordered_json(lineWithoutFeed->value) : ordered_json(nullptr)},
          {"streamable", program.isStreamable()},
          {"facts", factsJson(program.facts)},
          {"diagnostics", diagnostics}};
}

}  // namespace rivulet::report
