// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/file.h"
#include "cli/access_text.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/status_line.h"
#include "platform/interrupt.h"
#include "report/calibration_json.h"
#include "report/machine_store.h"

namespace rivulet::cli {

namespace {

std::string percentileText(const streaming::AccessSeries& series, int perMille) {
  const auto value = series.percentile(perMille);
  return value ? fmt::format("{:.2f}", base::toMilliseconds(*value)) : "-";
}

void print(const streaming::Calibration& calibration) {
  fmt::print(
      "  access form        cells  shots     mean  deviat.     p50     p90     p95     p99   p99.9 "
      "    "
      "max (ms)\n");
  for (const streaming::AccessSeries& series : calibration.series) {
    const char* access = series.write ? "write" : "read";
    if (series.refused) {
      fmt::print("  {:<6} {:<11} {:>5}  rejected by the control\n", access,
                 opcua::groupingName(series.grouping), series.nodes);
      continue;
    }
    fmt::print(
        "  {:<6} {:<11} {:>5} {:>6} {:>8.2f} {:>8.2f} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7.2f}\n",
        access, opcua::groupingName(series.grouping), series.nodes, series.shotsMade,
        base::toMilliseconds(series.mean), series.deviationMs, percentileText(series, 500),
        percentileText(series, 900), percentileText(series, 950), percentileText(series, 990),
        percentileText(series, 999), base::toMilliseconds(series.max));
  }
  for (const streaming::AccessFit& fit : calibration.fits) {
    fmt::print("{:<5} {:<11} {:6.2f} ms + n * {:6.3f} ms, residual {:.2f} ms, at most {:.1f} %\n",
               fit.write ? "write" : "read", opcua::groupingName(fit.grouping), fit.overheadMs,
               fit.nodeMs, fit.residualMs, 100.0 * fit.residualShare);
  }
  if (calibration.forms) {
    fmt::print("best form: {}\n", accessText(calibration.best(), calibration.forms));
  }
  if (calibration.isCut()) {
    fmt::print(
        "{} shots of each kind did not fit into {:.0f} s: see the column of shots. --budget 0 "
        "makes all of them.\n",
        calibration.plan.shots, base::toSeconds(calibration.plan.budget));
  }
}

/// Cells that the user names may still be in use: the values in the cells of a real control are
/// shown before anything is written.
std::optional<base::Error> unconfirmed(const CalibrateOptions& options,
                                       const Connection& connection,
                                       const streaming::CalibrationPlan& plan) {
  if (options.confirmed || connection.control->isVirtualMachine()) {
    return std::nullopt;
  }
  const auto values = streaming::readScratchCells(*connection.link, plan);
  if (!values) {
    return values.error();
  }
  std::string text;
  constexpr int kShown = 10;
  int shown = 0;
  for (const opcua::Assignment& cell : *values) {
    if (cell.value != 0.0 && ++shown <= kShown) {
      text += fmt::format("{}R{} = {}", text.empty() ? "" : ", ", cell.variable.index, cell.value);
    }
  }
  return base::makeError(
      streaming::CalibrationError::NoCells,
      fmt::format(
          "R{} to R{} of a real control will be written: repeatedly with their present values, and "
          "for a moment with other values. {} If no program and no cycle uses them, give --yes.",
          plan.firstCell, plan.lastCell,
          text.empty() ? "All of them are 0 now."
                       : "Now: " + text + (shown > kShown ? ", and more." : ".")));
}

/// Drawn once per percent: the shots are timed.
class Bar {
 public:
  bool show(const streaming::CalibrationProgress& progress) {
    const int percent = static_cast<int>(100.0 * progress.share);
    if (percent != m_percent) {
      m_percent = percent;
      m_line.show(fmt::format("{} %, {} of {} shots, {:.0f} s left", percent, progress.shotsMade,
                              progress.shotsPlanned, base::toSeconds(progress.left)));
    }
    return !interrupt::wasSeen();
  }
  void clear() { m_line.clear(); }

 private:
  int m_percent = -1;
  StatusLine m_line;
};

/// Keeps the calibration in the file of the machine and in the one that was asked for.
/// @return the files
base::Result<std::vector<std::filesystem::path>> save(const CalibrateOptions& options,
                                                      const streaming::CalibrationRecord& record,
                                                      const nlohmann::ordered_json& json) {
  const report::MachineStore store;
  std::vector<std::filesystem::path> files;
  if (!options.simulate) {
    if (const auto saved = store.save(record); !saved) {
      return base::fail(saved.error());
    }
    files.push_back(store.pathOf(record.endpoint, record.server));
  }
  if (!options.output.empty()) {
    const std::string text =
        json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
    if (const auto saved = base::writeFile(options.output, text); !saved) {
      return base::fail(saved.error());
    }
    files.emplace_back(options.output);
  }
  return files;
}

}  // namespace

Exit calibrate(const CalibrateOptions& options) {
  auto connection =
      options.simulate ? simulate(options.preset, options.seed) : connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  streaming::CalibrationPlan plan;
  plan.firstCell = options.firstCell;
  plan.lastCell = options.lastCell;
  plan.shots = options.shots;
  plan.budget = base::fromSeconds(options.budgetS);
  plan.arrays = !options.noArrays;
  if (const auto error = unconfirmed(options, *connection, plan)) {
    return reportError(*error, options.json);
  }
  streaming::CalibrationRecord record;
  record.endpoint = connection->name;
  record.measuredAtUtc = utcNow();
  record.toolVersion = RIVULET_VERSION;
  std::optional<streaming::CalibrationRecord> earlier;
  if (!options.simulate) {
    const auto identity = connection->control->identity();
    if (!identity) {
      return reportError(identity.error(), options.json);
    }
    record.server = *identity;
    // Only for the estimate of the time.
    if (auto found = report::MachineStore().calibration(record.endpoint, record.server); found) {
      earlier = std::move(*found);
    }
  }
  if (isTerminal()) {
    fmt::print(stderr, "R{} to R{}, about {:.0f} s. Ctrl-C ends it; the cells keep their values.\n",
               plan.firstCell, plan.lastCell,
               base::toSeconds(
                   streaming::expectedDuration(plan, earlier ? &earlier->calibration : nullptr)));
  }
  interrupt::watch();
  Bar bar;
  std::optional<Connection> again;
  streaming::CalibrationHooks hooks;
  hooks.progress = [&bar](const streaming::CalibrationProgress& progress) {
    return bar.show(progress);
  };
  hooks.reconnect = [&]() -> opcua::Link* {
    if (options.simulate) {
      return nullptr;
    }
    auto opened = connectTo(options.endpoint);
    if (!opened) {
      return nullptr;
    }
    again = std::move(*opened);
    return again->link;
  };
  auto calibration = streaming::calibrate(*connection->link, plan, hooks);
  bar.clear();
  if (!calibration) {
    return reportError(calibration.error(), options.json);
  }
  record.calibration = std::move(*calibration);
  const nlohmann::ordered_json json = report::calibrationJson(record);
  const auto files = save(options, record, json);
  if (!files) {
    return reportError(files.error(), options.json);
  }
  if (options.json) {
    printJson(json);
  } else {
    print(record.calibration);
    for (const std::filesystem::path& file : *files) {
      fmt::print("saved: {}\n", file.string());
    }
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
