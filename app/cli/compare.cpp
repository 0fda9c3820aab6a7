// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/comparison.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/trace_files.h"

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;
using Runs = std::vector<std::shared_ptr<const trace::ShownTrace>>;

base::Result<Runs> openRuns(const AnalyseOptions& options, const gcode::Program* program) {
  Runs runs;
  for (const std::string& file : options.files) {
    const auto source = openTrace(file, options);
    if (!source) {
      return base::fail(source.error());
    }
    trace::ShownTrace shown =
        trace::makeShownTrace(*source, trace::analyseTrace(*source, analysisOf(options, program)));
    shown.name = file;
    runs.push_back(std::make_shared<const trace::ShownTrace>(std::move(shown)));
  }
  return runs;
}

ordered_json differenceJson(const trace::SignalDifference& one, std::string_view atName) {
  const trace::DifferenceFigures& figures = one.figures;
  ordered_json json{
      {"signal", one.offer.formula}, {"unit", one.offer.unit}, {"values", figures.count}};
  if (figures.count > 0) {
    json["max"] = figures.max;
    json[std::string(atName)] = figures.atAxis;
    json["mean"] = figures.mean;
    json["rms"] = figures.rms;
  }
  return json;
}

std::string differenceText(const trace::SignalDifference& one, std::string_view unit) {
  const trace::DifferenceFigures& figures = one.figures;
  const std::string name = one.offer.unit.empty()
                               ? one.offer.formula
                               : fmt::format("{}, {}", one.offer.formula, one.offer.unit);
  if (figures.count == 0) {
    return fmt::format("  {:36}  nothing in common\n", name);
  }
  const std::string where =
      fmt::format("{:.6g}{}{}", figures.atAxis, unit.empty() ? "" : " ", unit);
  return fmt::format("  {:36} {:>14.6g} {:>16} {:>14.6g} {:>14.6g}\n", name, figures.max, where,
                     figures.mean, figures.rms);
}

}  // namespace

Exit compare(const AnalyseOptions& options) {
  const auto program = report::loadComparedProgram(options.program, options.loading.loadOptions());
  if (!program) {
    return reportError(program.error(), options.json);
  }
  const auto runs = openRuns(options, *program ? &**program : nullptr);
  if (!runs) {
    return reportError(runs.error(), options.json);
  }
  const trace::RunAxis axis = *trace::runAxisFrom(options.compare);
  const auto alignment = trace::alignRuns(*runs, axis);
  if (!alignment) {
    return reportError(alignment.error(), options.json);
  }
  const std::string_view unit = trace::runAxisUnit(axis);
  const std::string atName = unit.empty() ? "at_point" : fmt::format("at_{}", unit);
  ordered_json json{{"axis", options.compare},
                    {"of_program", alignment->isOfProgram},
                    {"reference", options.files.front()},
                    {"runs", ordered_json::array()}};
  std::string text;
  if (axis == trace::RunAxis::Path && !alignment->isOfProgram) {
    text +=
        "Each run has the length that it moved itself: say --program to compare at the same "
        "places of the program.\n";
  }
  for (std::size_t run = 1; run < runs->size(); ++run) {
    const auto differences = trace::compareRuns(*runs, *alignment, 0, run, options.signalList);
    if (!differences) {
      return reportError(differences.error(), options.json);
    }
    ordered_json list = ordered_json::array();
    text += fmt::format("{} minus {}\n  {:36} {:>14} {:>16} {:>14} {:>14}\n", options.files[run],
                        options.files.front(), "signal", "max", "at", "mean", "RMS");
    for (const trace::SignalDifference& one : *differences) {
      list.push_back(differenceJson(one, atName));
      text += differenceText(one, unit);
    }
    json["runs"].push_back({{"file", options.files[run]}, {"differences", std::move(list)}});
  }
  if (options.json) {
    printJson(json);
  } else {
    fmt::print("{}", text);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
