// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "cli/access_text.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "report/report_json.h"
#include "streaming/calibration.h"

namespace rivulet::cli {

namespace {

constexpr int kFormatVersion = 1;

nlohmann::ordered_json fitJson(const streaming::AccessFit& fit) {
  return {{"overhead_ms", fit.overheadMs},
          {"node_ms", fit.nodeMs},
          {"node_deviation_ms", fit.nodeDeviationMs},
          {"residual_ms", fit.residualMs}};
}

nlohmann::ordered_json calibrationJson(const streaming::Calibration& calibration,
                                       const CalibrateOptions& options, const std::string& name) {
  nlohmann::ordered_json json{{"rivulet_calibration", kFormatVersion},
                              {"endpoint", name},
                              {"first_cell", options.firstCell},
                              {"last_cell", options.lastCell},
                              {"shots", options.shots},
                              {"read", fitJson(calibration.read)},
                              {"write", fitJson(calibration.write)},
                              {"series", nlohmann::ordered_json::array()}};
  if (calibration.arrayRead && calibration.arrayWrite) {
    json["array_read"] = fitJson(*calibration.arrayRead);
    json["array_write"] = fitJson(*calibration.arrayWrite);
  }
  if (calibration.forms) {
    json["best_form"] = opcua::groupingName(calibration.forms->best());
    json["access_forms"] = report::accessFormsJson(*calibration.forms);
  }
  for (const streaming::AccessSeries& series : calibration.series) {
    json["series"].push_back({{"write", series.write},
                              {"nodes", series.nodes},
                              {"list", series.grouping == opcua::Grouping::List},
                              {"form", opcua::groupingName(series.grouping)},
                              {"mean_ms", base::toMilliseconds(series.durations.mean)},
                              {"deviation_ms", series.deviationMs},
                              {"p50_ms", base::toMilliseconds(series.durations.p50)},
                              {"p95_ms", base::toMilliseconds(series.durations.p95)},
                              {"p99_ms", base::toMilliseconds(series.durations.p99)},
                              {"max_ms", base::toMilliseconds(series.durations.max)}});
  }
  return json;
}

void print(const streaming::Calibration& calibration) {
  fmt::print("  access      cells  form           mean   deviation     p95     p99     max (ms)\n");
  for (const streaming::AccessSeries& series : calibration.series) {
    fmt::print("  {:<10} {:>6}  {:<11} {:>7.2f}     {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f}\n",
               series.write ? "write" : "read", series.nodes, opcua::groupingName(series.grouping),
               base::toMilliseconds(series.durations.mean), series.deviationMs,
               base::toMilliseconds(series.durations.p95),
               base::toMilliseconds(series.durations.p99),
               base::toMilliseconds(series.durations.max));
  }
  for (const bool write : {false, true}) {
    const streaming::AccessFit& fit = write ? calibration.write : calibration.read;
    fmt::print("{}: {:.2f} ms per request and {:.2f} ± {:.2f} ms per node (residual {:.2f} ms)\n",
               write ? "write" : "read", fit.overheadMs, fit.nodeMs, fit.nodeDeviationMs,
               fit.residualMs);
  }
  if (calibration.arrayRead && calibration.arrayWrite) {
    fmt::print(
        "arrays: {:.2f} ms per read and {:.3f} ms per element, {:.2f} ms per write and {:.3f} "
        "ms per element\n",
        calibration.arrayRead->overheadMs, calibration.arrayRead->nodeMs,
        calibration.arrayWrite->overheadMs, calibration.arrayWrite->nodeMs);
  }
  if (calibration.forms) {
    fmt::print("best form: {}\n", accessText(calibration.forms->best(), calibration.forms));
  }
}

}  // namespace

Exit calibrate(const CalibrateOptions& options) {
  auto connection =
      options.simulate ? simulate(options.preset, options.seed) : connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  watchForInterrupt();
  int percent = -1;
  const auto progress = [&percent](double share, base::Duration left) {
    const int now = static_cast<int>(100.0 * share);
    if (isTerminal() && now != percent) {
      percent = now;
      fmt::print(stderr, "\r{} %, {:.0f} s left \x1b[K", now, base::toSeconds(left));
      std::fflush(stderr);
    }
    return !wasInterrupted();
  };
  streaming::CalibrationPlan plan;
  plan.firstCell = options.firstCell;
  plan.lastCell = options.lastCell;
  plan.shots = options.shots;
  plan.arrays = !options.noArrays;
  const auto calibration = streaming::calibrate(*connection->link, plan, progress);
  if (percent >= 0) {
    std::fputs("\r\x1b[K", stderr);
  }
  if (!calibration) {
    return reportError(calibration.error(), options.json);
  }
  const nlohmann::ordered_json json = calibrationJson(*calibration, options, connection->name);
  if (!options.output.empty()) {
    std::ofstream file(options.output, std::ios::binary);
    file << json.dump(2) << '\n';
    file.flush();
    if (!file) {
      return reportError(
          base::makeError(trace::TraceError::FileNotWritable,
                          "The measurement cannot be written. Check folder and permissions.",
                          options.output),
          options.json);
    }
  }
  if (options.json) {
    printJson(json);
  } else {
    print(*calibration);
  }
  return Exit::Done;
}

base::Result<double> measuredAccessMs(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  const auto malformed = [&path](const char* why) {
    return base::fail(trace::TraceError::NotATrace, why, path);
  };
  if (!file || json.is_discarded() || !json.is_object() || !json.contains("rivulet_calibration")) {
    return malformed("This is no file of rivulet-cli calibrate --output. Choose one.");
  }
  if (json["rivulet_calibration"] != kFormatVersion) {
    return malformed("The file was written by another version of Rivulet. Measure again.");
  }
  double slowest = 0.0;
  for (const char* kind : {"read", "write"}) {
    if (!json.contains(kind) || !json[kind].is_object() || !json[kind].contains("node_ms") ||
        !json[kind]["node_ms"].is_number()) {
      return malformed("The file has no time per node. Measure again.");
    }
    slowest = std::max(slowest, json[kind]["node_ms"].get<double>());
  }
  if (!(slowest > 0.0)) {
    return malformed("The time per node in the file is not above zero. Measure again.");
  }
  return slowest;
}

}  // namespace rivulet::cli
