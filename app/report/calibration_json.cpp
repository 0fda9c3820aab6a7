// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/calibration_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/file.h"
#include "report/report_json.h"
#include "report/run_fields.h"
#include "streaming/control/machine_facts.h"

namespace rivulet::report {

namespace {

using base::Duration;
using nlohmann::ordered_json;
using streaming::MachineFileError;

/// 1 had the average of each kind only.
constexpr int kCalibrationFormat = 2;

/// Longer than any request.
constexpr double kMostMs = 1e9;

/// "50", "99", "99.9".
std::string percentText(int perMille) {
  return perMille % 10 == 0 ? std::to_string(perMille / 10)
                            : fmt::format("{}.{}", perMille / 10, perMille % 10);
}

constexpr auto measuredServerFields = [](auto& io, auto& server) {
  io.text("application_uri", server.applicationUri);
  io.text("product_name", server.productName);
  io.text("software_version", server.softwareVersion);
  io.text("build_number", server.buildNumber);
};

constexpr auto fitFields = [](auto& io, auto& fit) {
  io.flag("write", fit.write);
  io.named("form", fit.grouping, opcua::groupingName, opcua::groupingFromName);
  for (const auto& [key, value] :
       {std::pair{"overhead_ms", &fit.overheadMs}, std::pair{"node_ms", &fit.nodeMs},
        std::pair{"residual_ms", &fit.residualMs}, std::pair{"residual_share", &fit.residualShare},
        std::pair{"node_deviation_ms", &fit.nodeDeviationMs}}) {
    io.number(key, *value, -kJsonPlaceMax, kJsonPlaceMax);
  }
};

constexpr auto percentileFields = []<class Io>(Io& io, auto& percentiles) {
  if constexpr (Io::kReads) {
    for (const int perMille : {500, 900, 950, 990, 999}) {
      const std::string key = percentText(perMille);
      std::optional<Duration> value;
      if (io.has(key.c_str(), value)) {
        io.milliseconds(key.c_str(), *value, kMostMs);
        percentiles.push_back({perMille, *value});
      }
    }
  } else {
    for (const trace::Percentile& percentile : percentiles) {
      io.milliseconds(percentText(percentile.perMille).c_str(), percentile.value, kMostMs);
    }
  }
};

constexpr auto seriesFields = [](auto& io, auto& series) {
  io.flag("write", series.write);
  io.named("form", series.grouping, opcua::groupingName, opcua::groupingFromName);
  io.count("nodes", series.nodes);
  io.count("shots", series.shotsMade);
  io.ifSet().flag("refused", series.refused);
  if (series.shotsMade == 0) {
    return;
  }
  io.milliseconds("min_ms", series.min, kMostMs);
  io.milliseconds("mean_ms", series.mean, kMostMs);
  io.number("deviation_ms", series.deviationMs, 0.0, kJsonPlaceMax);
  io.ifThere().object("percentiles_ms", series.percentiles, percentileFields);
  io.milliseconds("max_ms", series.max, kMostMs);
  io.object("histogram", series.histogram, [](auto& inner, auto& histogram) {
    inner.milliseconds("from_ms", histogram.from, kMostMs);
    inner.milliseconds("width_ms", histogram.width, kMostMs);
    inner.counts("counts", histogram.counts);
    inner.count("above", histogram.above);
  });
};

template <class Io, class Record>
void recordFields(Io& io, Record& record) {
  auto& calibration = record.calibration;
  io.text("measured_at_utc", record.measuredAtUtc);
  io.text("tool_version", record.toolVersion);
  io.text("endpoint", record.endpoint);
  io.object("server", record.server, measuredServerFields);
  io.count("first_cell", calibration.plan.firstCell);
  io.count("last_cell", calibration.plan.lastCell);
  io.count("shots_ordered", calibration.plan.shots);
  io.seconds("budget_s", calibration.plan.budget);
  io.seconds("took_s", calibration.took);
  if (io.has("access_forms", calibration.forms)) {
    io.list("access_forms", calibration.forms->proofs, formFields);
  }
  io.list("fits", calibration.fits, fitFields);
  io.list("series", calibration.series, seriesFields);
}

}  // namespace

ordered_json calibrationJson(const streaming::CalibrationRecord& record) {
  ordered_json json{{"rivulet_calibration", kCalibrationFormat},
                    {"cut", record.calibration.isCut()},
                    {"best_form", opcua::groupingName(record.calibration.best())}};
  FieldWriter io(json);
  recordFields(io, record);
  return json;
}

base::Result<streaming::CalibrationRecord> calibrationOf(const nlohmann::json& from,
                                                         const std::string& origin) {
  if (!from.is_object() || !from.contains("rivulet_calibration")) {
    return base::fail(MachineFileError::NotAMachineFile,
                      "This file has no calibration. Choose another.", origin);
  }
  if (from["rivulet_calibration"] != kCalibrationFormat) {
    return base::fail(MachineFileError::OtherVersion,
                      "The calibration was written by another version of Rivulet. Measure again.",
                      origin);
  }
  Members members(from);
  FieldReader io(members);
  streaming::CalibrationRecord record;
  recordFields(io, record);
  const streaming::Calibration& calibration = record.calibration;
  record.calibration.plan.arrays = calibration.forms.has_value();
  const auto usable = [&calibration](bool write) {
    const streaming::AccessFit* fit = calibration.fit(write, opcua::Grouping::List);
    return fit != nullptr && fit->at(1.0) > Duration{};
  };
  if (!members.bad().empty() || !usable(false) || !usable(true)) {
    return base::fail(MachineFileError::Damaged,
                      fmt::format("The calibration is damaged ({}). Measure again.",
                                  members.bad().empty() ? "no fit of the lists" : members.bad()),
                      origin);
  }
  return record;
}

base::Result<streaming::CalibrationRecord> readCalibration(const std::filesystem::path& path,
                                                           const base::Budget& budget) {
  const auto file = readJson(path, budget);
  if (!file) {
    return base::fail(file.error());
  }
  const bool isMachine = file->is_object() && file->contains("rivulet_machine");
  return calibrationOf(isMachine ? file->value("calibration", nlohmann::json()) : *file,
                       path.string());
}

feasibility::AccessModel accessModel(const streaming::Calibration& calibration,
                                     opcua::Grouping grouping) {
  const auto line = [&](bool write) {
    const streaming::AccessFit* fit = calibration.fit(write, grouping);
    if (fit == nullptr) {
      fit = calibration.fit(write, opcua::Grouping::List);
    }
    return fit == nullptr ? feasibility::AccessLine{}
                          : feasibility::AccessLine{base::fromMilliseconds(fit->overheadMs),
                                                    base::fromMilliseconds(fit->nodeMs)};
  };
  feasibility::AccessModel model;
  model.measured = feasibility::MeasuredAccess{line(false), line(true)};
  return model;
}

}  // namespace rivulet::report
