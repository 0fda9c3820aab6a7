// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/run_settings.h"
#include "forecast/machine_verdict.h"
#include "forecast/path_time.h"
#include "gcode/program.h"
#include "machine/config.h"
#include "report/calibration_json.h"
#include "report/operating_point.h"
#include "report/report_json.h"
#include "streaming/control/access_policy.h"
#include "streaming/control/control_axes.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/methods/pause_placement.h"
#include "templates/flexible_program.h"

namespace rivulet::cli {

namespace {

/// Assumed position of the tool for programs that leave coordinates open.
constexpr base::Vec3 kOriginMm{0.0, 0.0, 0.0};

/// @param limit  with the feeds of the program: what limits the override
/// @param waits  of the method: the machine, where the client is late
void print(const feasibility::Verdict& verdict,
           const std::optional<streaming::OverrideLimit>& limit, bool waits) {
  fmt::print("{}\n", !verdict.feasible ? "NOT feasible"
                     : verdict.waits   ? "feasible, but the machine will wait for the client"
                                       : "feasible");
  for (const feasibility::Condition& condition : verdict.conditions) {
    fmt::print("  {:<18} margin {:.3f}  {}{}", feasibility::equationLabel(condition.equation),
               condition.margin, condition.margin > 1.0 ? "holds" : "does not hold",
               condition.decides ? "" : " (for information)");
    if (condition.place) {
      fmt::print("  lines {} to {}", condition.place->firstLine.value,
                 condition.place->lastLine.value);
    }
    fmt::print("\n");
  }
  const char* condition = waits ? " without waiting" : "";
  if (limit) {
    fmt::print("  limiting: {};{} {}\n", feasibility::equationLabel(verdict.limiting.equation),
               condition, streaming::describe(*limit));
    return;
  }
  fmt::print("  limiting: {}; largest feed{} {:.0f} mm/min\n",
             feasibility::equationLabel(verdict.limiting.equation), condition,
             base::mmPerMinFromMmPerS(verdict.feedMmPerSMax));
}

/// Time of the program as it is streamed, and the time that the pauses add.
class PausePrice {
 public:
  PausePrice(const gcode::Trajectory& trajectory, const machine::MachineConfig& machine,
             const streaming::RunSettings& settings)
      : m_trajectory(trajectory), m_machine(machine), m_settings(settings) {
    m_withoutS = totalS({});
  }
  [[nodiscard]] double withoutS() const { return m_withoutS; }
  [[nodiscard]] double priceS(const std::vector<streaming::PlannedPause>& pauses) const {
    return totalS(pauses) - m_withoutS;
  }

 private:
  [[nodiscard]] double totalS(const std::vector<streaming::PlannedPause>& pauses) const {
    forecast::PathTimeOptions options;
    options.feedMmPerS = m_settings.feedMmPerS;
    options.programFeeds = m_settings.programFeeds;
    options.pauseS = base::toSeconds(m_machine.standstillMean);
    for (const streaming::PlannedPause& pause : pauses) {
      options.pausesBehind.push_back(pause.point);
    }
    // Nothing cancels here.
    return forecast::pathTime(m_trajectory, kOriginMm, m_machine, options).value().totalS;
  }

  const gcode::Trajectory& m_trajectory;
  const machine::MachineConfig& m_machine;
  const streaming::RunSettings& m_settings;
  double m_withoutS = 0.0;
};

nlohmann::ordered_json pausesJson(const std::vector<streaming::PlannedPause>& pauses,
                                  const std::vector<gcode::StreamPoint>& points) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const streaming::PlannedPause& pause : pauses) {
    list.push_back({{"behind_point", pause.point + 1},
                    {"line", points[pause.point].line.value},
                    {"in_cut", pause.inCut}});
  }
  return list;
}

/// The pauses, reported together with the verdict.
struct PlannedPauses {
  std::size_t count = 0;
  std::size_t inCut = 0;
  double withoutS = 0.0;
  double priceS = 0.0;
  /// Method window: the number if it were cut evenly.
  struct Even {
    std::size_t count = 0;
    std::size_t inCut = 0;
    double priceS = 0.0;
  };
  std::optional<Even> even;
};

void print(const PlannedPauses& pauses, const std::string& machine) {
  fmt::print("  {} planned pauses, {} of them in the cut", pauses.count, pauses.inCut);
  if (pauses.even) {
    fmt::print(" (windows of at most this size cannot have fewer; cut evenly {} and {})",
               pauses.even->count, pauses.even->inCut);
  }
  fmt::print("\n  {:.1f} s without pauses, which cost {:.1f} s more (axes of {})", pauses.withoutS,
             pauses.priceS, machine);
  if (pauses.even) {
    fmt::print("; cut evenly {:.1f} s", pauses.even->priceS);
  }
  fmt::print("\n");
}

PlannedPauses pausesOf(const std::vector<streaming::PlannedPause>& planned,
                       const std::vector<gcode::StreamPoint>& points,
                       const streaming::RunSettings& settings, const PausePrice& price) {
  PlannedPauses pauses;
  pauses.count = planned.size();
  pauses.inCut = streaming::pausesInCut(planned);
  pauses.withoutS = price.withoutS();
  pauses.priceS = price.priceS(planned);
  const templates::TemplateParameters& parameters = settings.parameters;
  if (base::hasWindows(parameters.method) && !planned.empty()) {
    streaming::WindowCut cut = streaming::windowCut(settings);
    cut.place = false;
    const auto even = streaming::plannedPauses(
        points, parameters.method, static_cast<std::size_t>(parameters.pointsPerLoop), cut);
    pauses.even = {even.size(), streaming::pausesInCut(even), price.priceS(even)};
  }
  return pauses;
}

void put(nlohmann::ordered_json& json, const PlannedPauses& pauses) {
  json["planned_pauses"] = pauses.count;
  json["planned_pauses_in_cut"] = pauses.inCut;
  json["time_without_pauses_s"] = pauses.withoutS;
  json["pauses_cost_s"] = pauses.priceS;
  if (pauses.even) {
    json["even_pauses"] = pauses.even->count;
    json["even_pauses_in_cut"] = pauses.even->inCut;
    json["even_pauses_cost_s"] = pauses.even->priceS;
  }
}

/// What `--calibration` or `--endpoint` says about access; nothing without them.
base::Result<CalibrationChoice> calibrationFor(const FeasibilityOptions& options) {
  if (!options.calibration.empty()) {
    auto record = report::readCalibration(options.calibration, memoryBudget());
    if (!record) {
      return base::fail(record.error());
    }
    CalibrationChoice choice;
    choice.record = std::move(*record);
    return choice;
  }
  if (options.endpoint.empty()) {
    return CalibrationChoice();
  }
  const auto connection = connectTo(options.endpoint);
  if (!connection) {
    return base::fail(connection.error());
  }
  return calibrationOf(*connection);
}

/// What is judged: settings, distances, and what is told about the program.
struct Question {
  streaming::RunSettings settings;
  feasibility::ProgramDistances distances;
  std::vector<gcode::StreamPoint> points;  ///< with their feeds
  machine::MachineConfig machine;          ///< that is to run them
  std::optional<PlannedPauses> pauses;
  nlohmann::ordered_json json;
};

/// Takes distances and pauses from the program of the options.
base::Result<void> readProgram(const FeasibilityOptions& options,
                               const feasibility::AccessModel& access, Question& question) {
  auto program = gcode::loadProgram(options.program, options.loading.loadOptions());
  if (!program) {
    return base::fail(program.error());
  }
  const bool isPacked = templates::packingOf(question.settings.parameters).has_value();
  if (auto resampled = options.resampling.resample(*program, isPacked); !resampled) {
    return resampled;
  }
  const auto machine = machine::loadPreset(options.preset);
  if (!machine) {
    return base::fail(machine.error());
  }
  if (auto taken = takeFeeds(question.settings, options.point, *machine, *program); !taken) {
    return taken;
  }
  const gcode::PointList list = gcode::streamPoints(
      program->trajectory, kOriginMm, {},
      question.settings.programFeeds ? &*question.settings.programFeeds : nullptr);
  if (list.points.size() < 2) {
    return base::fail(gcode::GcodeError::NoMotion,
                      "The program has fewer than two points. Choose another.", program->name);
  }
  if (options.point.axes.empty()) {
    question.settings.parameters =
        streaming::withTurnedAxes(question.settings.parameters, program->trajectory);
  }
  streaming::planFeeds(question.settings, list.points, access, feedCellsOf(options.point));
  const feasibility::OperatingPoint point = report::operatingPointOf(question.settings);
  question.distances = feasibility::programDistances(list.points, point.pointsPerLoop);
  question.points = list.points;
  question.machine = *machine;
  question.json["program"] = program->name;
  question.json["points"] = list.points.size();
  if (program->merged) {
    question.json["merged"] = report::mergedJson(*program->merged);
  }
  question.json["distances"] = report::distancesJson(question.distances);
  if (point.pointsPerLoop >= 1) {
    const PausePrice price(program->trajectory, *machine, question.settings);
    const auto planned = streaming::plannedPauses(list.points, point.method,
                                                  static_cast<std::size_t>(point.pointsPerLoop),
                                                  streaming::windowCut(question.settings));
    question.pauses = pausesOf(planned, list.points, question.settings, price);
    put(question.json, *question.pauses);
    question.json["pauses"] = pausesJson(planned, list.points);
  }
  return {};
}

void print(const feasibility::ProgramDistances& distances) {
  if (distances.windowSteps > 0) {
    fmt::print(
        "d_min {:.4f} mm (lines {} to {}), d_min^N {:.4f} mm over {} steps (lines {} to {})\n",
        distances.pointDistanceMmMin, distances.pointDistancePlace.firstLine.value,
        distances.pointDistancePlace.lastLine.value, distances.windowLengthMmMin,
        distances.windowSteps, distances.windowPlace.firstLine.value,
        distances.windowPlace.lastLine.value);
  }
}

}  // namespace

Exit feasibility(const FeasibilityOptions& options) {
  Question question;
  question.settings.parameters = options.point.parameters();
  question.settings.deltaMm = options.point.deltaMm;
  if (options.point.feedMmPerMin > 0.0) {
    question.settings.feedMmPerS = base::mmPerSFromMmPerMin(options.point.feedMmPerMin);
  }
  const auto calibrated = calibrationFor(options);
  if (!calibrated) {
    return reportError(calibrated.error(), options.json);
  }
  feasibility::AccessModel access;
  access.accessTime = base::fromMilliseconds(options.accessTimeMs);
  opcua::Grouping form = opcua::Grouping::List;
  if (const streaming::CalibrationRecord* record = calibrated->usable()) {
    form = streaming::accessPlan(streaming::AccessPreference::Automatic,
                                 question.settings.parameters.method)
               .expected(&record->calibration);
    access = report::accessModel(record->calibration, form);
  }
  if (options.program.empty()) {
    question.distances.pointDistanceMmMin = options.pointDistanceMm.value_or(0.0);
    question.json["d_min_mm"] = question.distances.pointDistanceMmMin;
  } else if (const auto read = readProgram(options, access, question); !read) {
    return reportError(read.error(), options.json);
  }
  if (const auto fits = templates::requireProgram(question.settings.parameters); !fits) {
    return reportError(fits.error(), options.json);
  }
  const feasibility::OperatingPoint point = report::operatingPointOf(question.settings);
  const feasibility::ProgramDistances judged =
      question.settings.programFeeds
          ? feasibility::programDistances(question.points, point.pointsPerLoop, point.feedMmPerS)
          : question.distances;
  feasibility::SafetyFactors safety;
  safety.delta = options.deltaSafety;
  const auto verdict =
      question.points.empty()
          ? feasibility::judge(point, judged, access, safety)
          : forecast::judgeOn(question.machine, question.points, point, judged, access, safety);
  if (!verdict) {
    return reportError(verdict.error(), options.json);
  }
  const auto limit = streaming::overrideLimit(*verdict, question.points, question.settings);
  if (options.json) {
    nlohmann::ordered_json& json = question.json;
    json.update(report::verdictJson(*verdict));
    json["method"] = options.point.method;
    json["points_per_loop"] = point.pointsPerLoop;
    json["axes"] = templates::axisLetters(question.settings.parameters);
    json["delta_mm"] = point.deltaMm;
    json["feed"] = question.settings.programFeeds ? "program" : "fixed";
    json["feed_mm_per_min"] = base::mmPerMinFromMmPerS(point.feedMmPerS);
    if (question.settings.programFeeds) {
      json["override_percent"] = options.point.overridePercent;
      json["feed_per_point"] = point.feedPerPoint;
    }
    if (limit) {
      json["override_limit"] = report::overrideLimitJson(*limit);
    }
    json["access_time"] = accessSourceJson(*calibrated, form, *verdict);
    printJson(json);
  } else {
    print(question.distances);
    print(*verdict, limit, base::hasWindows(point.method));
    fmt::print("{}\n", accessSourceText(*calibrated, form, *verdict));
    if (question.pauses) {
      print(*question.pauses, options.preset);
    }
  }
  return verdict->feasible ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
