// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/text.h"
#include "cli/commands.h"
#include "feasibility/path_statistics.h"
#include "gcode/block_observer.h"
#include "gcode/feeds.h"
#include "gcode/program.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "report/plan_json.h"
#include "report/report_json.h"

namespace rivulet::cli {

namespace {

/// Programs in a folder are recognised by their extensions.
constexpr std::array<std::string_view, 13> kEndings{".MPF", ".SPF", ".NC",    ".NGC", ".TAP",
                                                    ".CNC", ".H",   ".GCODE", ".PTP", ".ISO",
                                                    ".EIA", ".GC",  ".TXT"};

struct Checked {
  std::string file;
  base::Result<gcode::Program> program;
  gcode::Readiness readiness = gcode::Readiness::NotUnderstood;  ///< the path is not kept

  [[nodiscard]] bool isUnderstood() const {
    return program && readiness != gcode::Readiness::NotUnderstood;
  }
};

/// The files themselves, and the programs in the folders among them, in the order of their names.
std::vector<std::string> filesOf(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& path : given) {
    std::error_code status;
    if (!std::filesystem::is_directory(path, status)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (std::filesystem::recursive_directory_iterator entry(path, status), end;
         !status && entry != end; entry.increment(status)) {
      const std::string ending = base::toUpper(entry->path().extension().string());
      if (entry->is_regular_file(status) &&
          std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end()) {
        found.push_back(entry->path().string());
      }
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

void print(const gcode::Program& program) {
  const gcode::Statistics& statistics = program.statistics;
  fmt::print("{}  ({})\n", program.name, program.hash);
  fmt::print("  dialect  {}{}\n", gcode::dialectName(program.dialect),
             program.dialectEvidence.empty()
                 ? std::string()
                 : fmt::format(" (for \"{}\")", program.dialectEvidence));
  fmt::print("  lines    {}\n", statistics.lines);
  fmt::print("  motions  G0 {}, G1 {}, G2 {}, G3 {}; {} points\n", statistics.motions[0],
             statistics.motions[1], statistics.motions[2], statistics.motions[3],
             statistics.points);
  fmt::print("  length   {:.3f} mm rapid, {:.3f} mm cut\n", statistics.rapidLengthMm,
             statistics.cutLengthMm);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isfinite(statistics.minMm[axis])) {
      fmt::print("  {}        {:.3f} to {:.3f} mm\n", base::kAxisNames[axis],
                 statistics.minMm[axis], statistics.maxMm[axis]);
    }
  }
  fmt::print("  feeds    {} mm/min\n", fmt::join(statistics.feedsMmPerMin, ", "));
  if (const auto line = gcode::lineWithoutFeed(program.trajectory)) {
    fmt::print("  line {} moves at a feed that is not known: stream it with --feed MM_PER_MIN\n",
               line->value);
  }
  for (const gcode::Diagnostic& diagnostic : program.diagnostics) {
    const std::string name = gcode::acceptableName(diagnostic);
    fmt::print("{}:{}:{}: {}: {}{}{}\n", diagnostic.file.empty() ? program.name : diagnostic.file,
               diagnostic.line.value, diagnostic.column, gcode::severityName(diagnostic.severity),
               gcode::describe(diagnostic),
               name.empty() ? std::string() : fmt::format(" [--accept {}]", name),
               diagnostic.count > 1 ? fmt::format(" ({} times)", diagnostic.count) : std::string());
  }
  fmt::print("{}\n", gcode::describe(program.readiness()));
}

/// Lines of a stretch or native block, "12" or "12-30".
std::string linesOf(const job::Stretch& stretch) {
  const auto first = stretch.blocks.front().line.value;
  const auto last = stretch.blocks.back().line.value;
  return first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
}

void print(const job::Part& part) {
  if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
    fmt::print("  {:>9}  {:<19}  {}{}\n", native->place.line.value,
               job::nativeReasonName(native->reason),
               native->file.empty() ? std::string() : native->file + ": ", native->source);
  } else if (const auto& stretch = std::get<job::Stretch>(part); stretch.number > 0) {
    fmt::print("  {:>9}  stretch {:<11}  {} point{}\n", linesOf(stretch), stretch.number,
               stretch.pointCount, stretch.pointCount == 1 ? "" : "s");
  }
}

gcode::LoadOptions optionsOf(const std::string& file, const LoadingOptions& loading) {
  gcode::LoadOptions options = loading.loadOptions();
  options.subprogram = gcode::subprogramsBeside(file);
  return options;
}

/// The same text again, now block by block; after that the program has none. The parts are told as
/// they are found: a program has as many of them as lines. They are kept only of a program of usual
/// size that is understood, to see whether its job refuses it for their order.
base::Result<job::Plan> planOf(const std::string& file, gcode::Program& program,
                               const LoadingOptions& loading,
                               const std::function<void(const job::Part&)>& each) {
  constexpr std::size_t kPartsKept = 20'000;
  std::vector<job::Part> kept;
  bool keeps = program.isUnderstood();
  auto plan = job::visitPlan(program, optionsOf(file, loading), [&](const job::Part& part) {
    keeps = keeps && kept.size() < kPartsKept;
    if (keeps) {
      kept.push_back(part);
    } else {
      kept = {};
    }
    each(part);
  });
  program.text = {};
  if (plan) {
    plan->parts = std::move(kept);
  }
  return plan;
}

/// @param lists  each part; else their number
void printPlan(const std::string& file, gcode::Program& program, const LoadingOptions& loading,
               bool lists) {
  std::size_t stretches = 0;
  std::size_t natives = 0;
  if (lists) {
    fmt::print("\n");
  }
  const auto plan = planOf(file, program, loading, [&](const job::Part& part) {
    const auto* const stretch = std::get_if<job::Stretch>(&part);
    natives += stretch == nullptr ? 1U : 0U;
    stretches += stretch != nullptr && stretch->number > 0 ? 1U : 0U;
    if (lists) {
      print(part);
    }
  });
  if (!plan) {
    return;
  }
  fmt::print("{}As a job: {} streamed, {} for the control\n", lists ? "" : "\n", stretches,
             natives);
  for (const job::Refusal& refusal : plan->refusals) {
    fmt::print("{}:{}: error: {}\n", refusal.file.empty() ? program.name : refusal.file,
               refusal.line.value, job::describe(refusal));
  }
  // What is whole may still be no job.
  const base::Result<void> whole = job::requireWhole(*plan);
  if (!whole && plan->isWhole()) {
    fmt::print("{}\n", whole.error().text());
  }
}

std::string dumped(const nlohmann::ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// One object with the plan as its last value, printed as it is found.
void printJsonWithPlan(nlohmann::ordered_json json, const std::string& file,
                       gcode::Program& program, const CheckOptions& options,
                       const nlohmann::ordered_json& asJob) {
  std::string head = dumped(json, 2);
  json = nullptr;
  head.resize(head.rfind('}'));
  fmt::print("{},\n  \"stretches\": {{\n    \"parts\": [", base::trim(head));
  bool isFirst = true;
  const auto plan = planOf(file, program, options.loading, [&isFirst](const job::Part& part) {
    const nlohmann::ordered_json made = report::partJson(part);
    if (!made.is_null()) {
      fmt::print("{}\n      {}", isFirst ? "" : ",", dumped(made));
      isFirst = false;
    }
  });
  fmt::print("],\n    \"whole\": {},\n    \"refusals\": {}", plan && plan->isWhole(),
             plan ? dumped(report::refusalsJson(plan->refusals)) : "[]");
  const base::Result<void> whole = plan ? job::requireWhole(*plan) : base::fail(plan.error());
  if (!whole) {
    fmt::print(",\n    \"refused\": {}", dumped(whole.error().text()));
  }
  fmt::print("\n  }}");
  if (!asJob.is_null()) {
    fmt::print(",\n  \"job\": {}", dumped(asJob));
  }
  fmt::print("\n}}");
}

/// Its path and its text are given up where nothing needs them any more. @param asJob  whether it
/// runs as a job
void printChecked(const std::string& file, gcode::Program& program,
                  const std::optional<base::Result<void>>& asJob, const CheckOptions& options,
                  bool single) {
  if (options.json) {
    nlohmann::ordered_json json = report::programJson(program);
    json["file"] = single ? program.name : file;
    {
      const gcode::PointList points = gcode::streamPoints(program.trajectory, {});
      json["statistics"] = !feasibility::hasDistances(points)
                               ? nlohmann::ordered_json(nullptr)
                               : report::statisticsJson(feasibility::pathStatistics(points));
    }
    program.trajectory = {};
    nlohmann::ordered_json runs;
    if (asJob) {
      runs["runs"] = asJob->has_value();
      if (!*asJob) {
        runs["error"] = report::errorJson(asJob->error());
      }
    }
    printJsonWithPlan(std::move(json), file, program, options, runs);
  } else {
    print(program);
    program.trajectory = {};
    printPlan(file, program, options.loading, single);
    if (asJob) {
      fmt::print("job: {}\n",
                 *asJob ? std::string("runs on a virtual machine") : asJob->error().text());
    }
  }
}

void printTable(const std::vector<Checked>& all) {
  std::size_t widest = 4;
  for (const Checked& checked : all) {
    widest = std::max(widest, checked.file.size());
  }
  fmt::print("\n{:<{}}  {:<10}  {:>8}  {:>8}  {:>6}  {:>8}  {}\n", "FILE", widest, "DIALECT",
             "LINES", "POINTS", "ERRORS", "WARNINGS", "RESULT");
  std::size_t understood = 0;
  for (const Checked& checked : all) {
    if (!checked.program) {
      fmt::print("{:<{}}  {:<10}  {:>8}  {:>8}  {:>6}  {:>8}  {}\n", checked.file, widest, "-", "-",
                 "-", "-", "-", "not read");
      continue;
    }
    const gcode::Program& program = *checked.program;
    const auto count = [&program](gcode::Severity severity) {
      return std::count_if(
          program.diagnostics.begin(), program.diagnostics.end(),
          [severity](const gcode::Diagnostic& found) { return found.severity == severity; });
    };
    understood += checked.isUnderstood() ? 1U : 0U;
    fmt::print("{:<{}}  {:<10}  {:>8}  {:>8}  {:>6}  {:>8}  {}\n", checked.file, widest,
               gcode::dialectName(program.dialect), program.statistics.lines,
               program.statistics.points, count(gcode::Severity::Error),
               count(gcode::Severity::Warning), gcode::readinessName(checked.readiness));
  }
  fmt::print("{} of {} understood\n", understood, all.size());
}

}  // namespace

gcode::LoadOptions LoadingOptions::loadOptions() const {
  gcode::LoadOptions options;
  options.budget = memoryBudget();
  options.chordToleranceMm = chordToleranceMm;
  options.blockSkip = blockSkip;
  options.dialect = gcode::dialectOfName(dialect);
  options.accepted = accepted;
  options.centres = gcode::centreReadingOfName(centres).value_or(options.centres);
  if (units != "auto") {
    options.units = units == "inch" ? gcode::FileUnits::Inches : gcode::FileUnits::Millimetres;
  }
  options.noPoint = gcode::noPointOfName(noPoint);
  options.settings = gcode::controlSettingsOf(settings).value_or(options.settings);
  for (std::string& name : options.accepted) {
    name = base::toUpper(name);
  }
  return options;
}

base::Result<void> requireMeaning(const gcode::Program& program, bool isForControl) {
  const gcode::Diagnostic* open = gcode::findingOf(program, gcode::DiagnosticCode::DialectUnclear);
  if (open == nullptr && isForControl) {
    open = gcode::openSetting(program);
  }
  return open == nullptr
             ? base::Result<void>()
             : base::fail(gcode::GcodeError::Ambiguous, gcode::describe(*open), program.name);
}

Exit check(const CheckOptions& options) {
  const std::vector<std::string> files = filesOf(options.files);
  const bool single = options.files.size() == 1 && files.size() == 1;
  std::vector<Checked> all;
  Exit exit = Exit::Done;
  if (files.empty()) {
    fmt::print(stderr, "No NC program was found.\n");
    return Exit::BadInput;
  }
  const auto separate = [&] {
    if (options.json && !single) {
      fmt::print("{}", all.empty() ? "[\n" : ",\n");
    }
  };
  for (const std::string& file : files) {
    // Before the program is read here: each of the two may take all of the memory limit.
    const std::optional<base::Result<void>> asJob =
        options.asJob ? std::optional(tryJob(file, options.loading)) : std::nullopt;
    Checked checked{file, gcode::loadProgram(file, options.loading.loadOptions())};
    if (!checked.program) {
      if (single) {
        return reportError(checked.program.error(), options.json);
      }
      separate();
      if (options.json) {
        fmt::print(
            "{}",
            dumped({{"file", file}, {"error", report::errorJson(checked.program.error())}}, 2));
      } else {
        reportError(checked.program.error(), false);
      }
      exit = exit == Exit::Done ? Exit::Wrong : exit;
      all.push_back(std::move(checked));
      continue;
    }
    gcode::Program& program = *checked.program;
    checked.readiness = program.readiness();
    separate();
    printChecked(file, program, asJob, options, single);
    if (asJob) {
      exit = *asJob || exit == Exit::BadInput ? exit : exitFor(asJob->error());
    } else if (program.ambiguity) {
      exit = Exit::BadInput;
    } else if (!checked.isUnderstood() && exit == Exit::Done) {
      exit = Exit::Wrong;
    }
    all.push_back(std::move(checked));
  }
  if (options.json) {
    fmt::print("{}", single ? "\n" : "\n]\n");
  } else if (!single) {
    printTable(all);
  }
  return exit;
}

}  // namespace rivulet::cli
