// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/calibration_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/report_json.h"
#include "streaming/control/machine_facts.h"

namespace rivulet::report {

namespace {

using base::Duration;
using nlohmann::ordered_json;
using streaming::MachineFileError;

/// 1 had the average of each kind only.
constexpr int kCalibrationFormat = 2;

/// "50", "99", "99.9".
std::string percentText(int perMille) {
  return perMille % 10 == 0 ? std::to_string(perMille / 10)
                            : fmt::format("{}.{}", perMille / 10, perMille % 10);
}

ordered_json seriesJson(const streaming::AccessSeries& series) {
  ordered_json one{{"write", series.write},
                   {"form", opcua::groupingName(series.grouping)},
                   {"nodes", series.nodes},
                   {"shots", series.shotsMade}};
  if (series.refused) {
    one["refused"] = true;
  }
  if (series.shotsMade == 0) {
    return one;
  }
  one["min_ms"] = base::toMilliseconds(series.min);
  one["mean_ms"] = base::toMilliseconds(series.mean);
  one["deviation_ms"] = series.deviationMs;
  for (const trace::Percentile& percentile : series.percentiles) {
    one["percentiles_ms"][percentText(percentile.perMille)] =
        base::toMilliseconds(percentile.value);
  }
  one["max_ms"] = base::toMilliseconds(series.max);
  one["histogram"] = {{"from_ms", base::toMilliseconds(series.histogram.from)},
                      {"width_ms", base::toMilliseconds(series.histogram.width)},
                      {"counts", series.histogram.counts},
                      {"above", series.histogram.above}};
  return one;
}

/// Reads members and remembers whether one was missing or of another type.
class Reader {
 public:
  template <class T>
  T get(const nlohmann::json& from, const char* key) {
    if (from.is_object() && from.contains(key)) {
      const nlohmann::json& value = from[key];
      if constexpr (std::is_same_v<T, std::string>) {
        if (value.is_string()) {
          return value.get<T>();
        }
      } else if constexpr (std::is_same_v<T, bool>) {
        if (value.is_boolean()) {
          return value.get<T>();
        }
      } else if (value.is_number()) {
        return value.get<T>();
      }
    }
    m_bad = m_bad.empty() ? key : m_bad;
    return T{};
  }
  Duration milliseconds(const nlohmann::json& from, const char* key) {
    const double value = get<double>(from, key);
    // Longer than any request: no such number is converted.
    constexpr double kMostMs = 1e9;
    if (!(value >= 0.0) || value > kMostMs) {
      m_bad = m_bad.empty() ? key : m_bad;
      return {};
    }
    return base::fromMilliseconds(value);
  }
  opcua::Grouping form(const nlohmann::json& from) {
    const auto form = opcua::groupingFromName(get<std::string>(from, "form"));
    if (!form) {
      m_bad = m_bad.empty() ? "form" : m_bad;
    }
    return form.value_or(opcua::Grouping::List);
  }
  const nlohmann::json& list(const nlohmann::json& from, const char* key) {
    static const nlohmann::json none = nlohmann::json::array();
    if (from.is_object() && from.contains(key) && from[key].is_array()) {
      return from[key];
    }
    m_bad = m_bad.empty() ? key : m_bad;
    return none;
  }
  [[nodiscard]] const std::string& bad() const { return m_bad; }

 private:
  std::string m_bad;
};

streaming::AccessSeries seriesOf(Reader& reader, const nlohmann::json& one) {
  streaming::AccessSeries series;
  series.write = reader.get<bool>(one, "write");
  series.grouping = reader.form(one);
  series.nodes = reader.get<int>(one, "nodes");
  series.shotsMade = reader.get<int>(one, "shots");
  series.refused = one.contains("refused");
  if (series.shotsMade == 0) {
    return series;
  }
  series.min = reader.milliseconds(one, "min_ms");
  series.mean = reader.milliseconds(one, "mean_ms");
  series.deviationMs = reader.get<double>(one, "deviation_ms");
  series.max = reader.milliseconds(one, "max_ms");
  if (one.contains("percentiles_ms") && one["percentiles_ms"].is_object()) {
    for (const int perMille : {500, 900, 950, 990, 999}) {
      const std::string key = percentText(perMille);
      if (one["percentiles_ms"].contains(key)) {
        series.percentiles.push_back(
            {perMille, reader.milliseconds(one["percentiles_ms"], key.c_str())});
      }
    }
  }
  const nlohmann::json bins = one.value("histogram", nlohmann::json::object());
  series.histogram.from = reader.milliseconds(bins, "from_ms");
  series.histogram.width = reader.milliseconds(bins, "width_ms");
  series.histogram.above = reader.get<std::size_t>(bins, "above");
  for (const nlohmann::json& count : reader.list(bins, "counts")) {
    series.histogram.counts.push_back(count.is_number_unsigned() ? count.get<std::size_t>() : 0);
  }
  return series;
}

streaming::AccessForms formsOf(Reader& reader, const nlohmann::json& list) {
  streaming::AccessForms forms;
  for (const nlohmann::json& one : list) {
    forms.proofs.push_back(
        {reader.form(one), reader.get<bool>(one, "writes"), reader.get<bool>(one, "reads"),
         one.contains("why_not") ? reader.get<std::string>(one, "why_not") : std::string()});
  }
  return forms;
}

}  // namespace

ordered_json calibrationJson(const streaming::CalibrationRecord& record) {
  const streaming::Calibration& calibration = record.calibration;
  ordered_json result{{"rivulet_calibration", kCalibrationFormat},
                      {"measured_at_utc", record.measuredAtUtc},
                      {"tool_version", record.toolVersion},
                      {"endpoint", record.endpoint},
                      {"server",
                       {{"application_uri", record.server.applicationUri},
                        {"product_name", record.server.productName},
                        {"software_version", record.server.softwareVersion},
                        {"build_number", record.server.buildNumber}}},
                      {"first_cell", calibration.plan.firstCell},
                      {"last_cell", calibration.plan.lastCell},
                      {"shots_ordered", calibration.plan.shots},
                      {"budget_s", base::toSeconds(calibration.plan.budget)},
                      {"took_s", base::toSeconds(calibration.took)},
                      {"cut", calibration.isCut()},
                      {"best_form", opcua::groupingName(calibration.best())}};
  if (calibration.forms) {
    result["access_forms"] = accessFormsJson(*calibration.forms);
  }
  result["fits"] = ordered_json::array();
  for (const streaming::AccessFit& fit : calibration.fits) {
    result["fits"].push_back({{"write", fit.write},
                              {"form", opcua::groupingName(fit.grouping)},
                              {"overhead_ms", fit.overheadMs},
                              {"node_ms", fit.nodeMs},
                              {"residual_ms", fit.residualMs},
                              {"residual_share", fit.residualShare},
                              {"node_deviation_ms", fit.nodeDeviationMs}});
  }
  result["series"] = ordered_json::array();
  for (const streaming::AccessSeries& series : calibration.series) {
    result["series"].push_back(seriesJson(series));
  }
  return result;
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
  Reader reader;
  streaming::CalibrationRecord record;
  record.measuredAtUtc = reader.get<std::string>(from, "measured_at_utc");
  record.toolVersion = reader.get<std::string>(from, "tool_version");
  record.endpoint = reader.get<std::string>(from, "endpoint");
  const nlohmann::json server = from.value("server", nlohmann::json::object());
  record.server.applicationUri = reader.get<std::string>(server, "application_uri");
  record.server.productName = reader.get<std::string>(server, "product_name");
  record.server.softwareVersion = reader.get<std::string>(server, "software_version");
  record.server.buildNumber = reader.get<std::string>(server, "build_number");
  streaming::Calibration& calibration = record.calibration;
  calibration.plan.firstCell = reader.get<int>(from, "first_cell");
  calibration.plan.lastCell = reader.get<int>(from, "last_cell");
  calibration.plan.shots = reader.get<int>(from, "shots_ordered");
  calibration.plan.budget = base::fromSeconds(reader.get<double>(from, "budget_s"));
  calibration.plan.arrays = from.contains("access_forms");
  calibration.took = base::fromSeconds(reader.get<double>(from, "took_s"));
  if (from.contains("access_forms")) {
    calibration.forms = formsOf(reader, reader.list(from, "access_forms"));
  }
  for (const nlohmann::json& one : reader.list(from, "fits")) {
    streaming::AccessFit fit;
    fit.write = reader.get<bool>(one, "write");
    fit.grouping = reader.form(one);
    fit.overheadMs = reader.get<double>(one, "overhead_ms");
    fit.nodeMs = reader.get<double>(one, "node_ms");
    fit.residualMs = reader.get<double>(one, "residual_ms");
    fit.residualShare = reader.get<double>(one, "residual_share");
    fit.nodeDeviationMs = reader.get<double>(one, "node_deviation_ms");
    calibration.fits.push_back(fit);
  }
  for (const nlohmann::json& one : reader.list(from, "series")) {
    calibration.series.push_back(seriesOf(reader, one));
  }
  const auto usable = [&calibration](bool write) {
    const streaming::AccessFit* fit = calibration.fit(write, opcua::Grouping::List);
    return fit != nullptr && fit->at(1.0) > Duration{};
  };
  if (!reader.bad().empty() || !usable(false) || !usable(true)) {
    return base::fail(MachineFileError::Damaged,
                      fmt::format("The calibration is damaged ({}). Measure again.",
                                  reader.bad().empty() ? "no fit of the lists" : reader.bad()),
                      origin);
  }
  return record;
}

base::Result<streaming::CalibrationRecord> readCalibration(const std::filesystem::path& path) {
  const base::Result<std::string> text = base::readFile(path);
  if (!text) {
    return base::fail(text.error());
  }
  const nlohmann::json file = nlohmann::json::parse(*text, nullptr, false);
  const bool isMachine = file.is_object() && file.contains("rivulet_machine");
  return calibrationOf(isMachine ? file.value("calibration", nlohmann::json()) : file,
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
