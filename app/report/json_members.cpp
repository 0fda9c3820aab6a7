// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/json_members.h"

#include "base/units.h"
#include "report/run_fields.h"

namespace rivulet::report {

namespace {

double above0(Members& members, const char* at) {
  constexpr double kMax = 1e9;
  const double number = members.number(at, 0.0, kMax);
  if (!(number > 0.0)) {
    members.refuse(at);
  }
  return number;
}

/// The value that `fromName` gives to the word at `at`; it stays if there is none.
template <class Value, class FromName>
void readNamed(Members& members, const char* at, Value& value, FromName fromName) {
  if (!members.has(at)) {
    return;
  }
  const auto known = fromName(members.text(at));
  value = known.value_or(value);
  if (!known) {
    members.refuse(at);
  }
}

void readCells(Members& members, templates::TemplateParameters& parameters) {
  parameters.pointsPerLoop = members.integer<int>("/settings/points_per_loop", 1, kJsonCellMax);
  parameters.windows =
      members.integer<int>("/settings/windows", 1, templates::WindowProtocol::kWindowsMax);
  parameters.baseCell = members.integer<int>("/settings/base_cell", 0, kJsonCellMax);
  const auto cells = [&members](const char* at) {
    return members.integer<int>(at, 0, kJsonCellMax);
  };
  members.ifThere("/settings/slot_stride", parameters.slotStride, cells);
  members.ifThere("/settings/r_parameters", parameters.rParameterCount, cells);
  members.ifThere("/settings/windows_ahead", parameters.windowsAhead, cells);
}

void readFeeds(Members& members, streaming::RunSettings& settings) {
  const auto positive = [&members](const char* at) { return above0(members, at); };
  double feedMmPerMin = base::mmPerMinFromMmPerS(settings.feedMmPerS);
  members.ifThere("/settings/feed_mm_per_min", feedMmPerMin, positive);
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  members.ifThere("/settings/feed_per_point", settings.parameters.feedPerPoint,
                  [&members](const char* at) { return members.flag(at); });
  if (members.has("/settings/program_feeds")) {
    settings.programFeeds =
        gcode::ProgramFeeds{members.number("/settings/program_feeds/override", gcode::kOverrideMin,
                                           gcode::kOverrideMax),
                            positive("/settings/program_feeds/rapid_mm_per_s"),
                            positive("/settings/program_feeds/limit_mm_per_s")};
  }
  members.ifThere("/settings/delta_mm", settings.deltaMm, positive);
}

}  // namespace

streaming::RunSettings runSettingsOf(Members& members) {
  streaming::RunSettings settings;
  templates::TemplateParameters& parameters = settings.parameters;
  const auto flag = [&members](const char* at) { return members.flag(at); };
  parameters.method = base::kDefaultMethod;
  readNamed(members, "/settings/method", parameters.method, base::methodFromName);
  readCells(members, parameters);
  members.ifThere("/settings/slow_down", parameters.slowDown, flag);
  members.ifThere("/settings/correction_limit_mm", parameters.correctionLimitMm,
                  [&members](const char* at) {
                    return members.number(at, 0.0, templates::kCorrectionLimitMmMax);
                  });
  readFeeds(members, settings);
  std::string axes = "XYZ";
  members.ifThere("/settings/axes", axes, [&members](const char* at) { return members.text(at); });
  if (!templates::chooseAxes(parameters, axes)) {
    members.refuse("/settings/axes");
  }
  readNamed(members, "/settings/layout", parameters.layout, templates::layoutFromName);
  readNamed(members, "/settings/control", parameters.target, templates::targetFromName);
  readNamed(members, "/settings/passed_by", settings.passedBy, streaming::passedByFromName);
  readNamed(members, "/settings/grouping", settings.grouping, opcua::groupingFromName);
  members.ifThere("/settings/monitor", settings.monitor, flag);
  if (members.bad().empty() && !templates::requireProgram(parameters)) {
    members.refuse("/settings");
  }
  if (members.has("/started_by")) {
    settings.origin = {members.text("/started_by/user"), members.text("/started_by/computer"),
                       members.text("/started_by/at_utc")};
  }
  return settings;
}

streaming::Checkpoint checkpointOf(Members& members) {
  streaming::Checkpoint checkpoint;
  FieldReader io(members, "/checkpoint");
  checkpointFields(io, checkpoint);
  return checkpoint;
}

}  // namespace rivulet::report
