// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
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
    fmt::print("{}:{}:{}: {}: {}{}\n", diagnostic.file.empty() ? program.name : diagnostic.file,
               diagnostic.line.value, diagnostic.column, gcode::severityName(diagnostic.severity),
               gcode::describe(diagnostic),
               name.empty() ? std::string() : fmt::format(" [--accept {}]", name));
  }
  fmt::print("{}\n", gcode::describe(program.readiness()));
}

/// Lines of a stretch or native block, "12" or "12-30".
std::string linesOf(const job::Stretch& stretch) {
  const auto first = stretch.blocks.front().line.value;
  const auto last = stretch.blocks.back().line.value;
  return first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
}

/// @param lists  each part; else their number
void print(const job::Plan& plan, bool lists) {
  fmt::print("\nAs a job: {} streamed, {} for the control\n", plan.stretchCount(),
             plan.nativeCount());
  for (const job::Part& part : lists ? plan.parts : std::vector<job::Part>()) {
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      fmt::print("  {:>9}  {:<19}  {}{}\n", native->place.line.value,
                 job::nativeReasonName(native->reason),
                 native->file.empty() ? std::string() : native->file + ": ", native->source);
    } else if (const auto& stretch = std::get<job::Stretch>(part); stretch.number > 0) {
      fmt::print("  {:>9}  stretch {:<11}  {} point{}\n", linesOf(stretch), stretch.number,
                 stretch.pointCount, stretch.pointCount == 1 ? "" : "s");
    }
  }
  for (const job::Refusal& refusal : plan.refusals) {
    fmt::print("{}:{}: error: {}\n", refusal.file.empty() ? plan.program.name : refusal.file,
               refusal.line.value, job::describe(refusal));
  }
  // What is whole may still be no job.
  const base::Result<void> whole = job::requireWhole(plan);
  if (!whole && plan.isWhole()) {
    fmt::print("{}\n", whole.error().text());
  }
}

/// The same text again, now block by block.
base::Result<job::Plan> planOf(const std::string& file, const gcode::Program& program,
                               gcode::LoadOptions options) {
  options.subprogram = gcode::subprogramsBeside(file);
  return job::makePlan(program.name, program.text, options);
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
  options.chordToleranceMm = chordToleranceMm;
  options.blockSkip = blockSkip;
  options.dialect = gcode::dialectOfName(dialect);
  options.accepted = accepted;
  for (const gcode::CentreReading reading : gcode::kCentreReadings) {
    options.centres = gcode::centreReadingName(reading) == centres ? reading : options.centres;
  }
  for (std::string& name : options.accepted) {
    name = base::toUpper(name);
  }
  return options;
}

Exit check(const CheckOptions& options) {
  const std::vector<std::string> files = filesOf(options.files);
  const bool single = options.files.size() == 1 && files.size() == 1;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<Checked> all;
  Exit exit = Exit::Done;
  for (const std::string& file : files) {
    Checked checked{file, gcode::loadProgram(file, options.loading.loadOptions())};
    if (!checked.program) {
      if (single) {
        return reportError(checked.program.error(), options.json);
      }
      if (options.json) {
        nlohmann::ordered_json failed = report::errorJson(checked.program.error());
        list.push_back({{"file", file}, {"error", failed}});
      } else {
        reportError(checked.program.error(), false);
      }
      exit = exit == Exit::Done ? Exit::Wrong : exit;
    } else if (options.json) {
      list.push_back(report::programJson(*checked.program));
      list.back()["file"] = single ? checked.program->name : file;
      const gcode::PointList points = gcode::streamPoints(checked.program->trajectory, {});
      list.back()["statistics"] = !feasibility::hasDistances(points)
                                      ? nlohmann::ordered_json(nullptr)
                                      : report::statisticsJson(feasibility::pathStatistics(points));
      if (const auto plan = planOf(file, *checked.program, options.loading.loadOptions())) {
        list.back()["stretches"] = report::planJson(*plan);
      }
    } else {
      print(*checked.program);
      if (const auto plan = planOf(file, *checked.program, options.loading.loadOptions())) {
        print(*plan, single);
      }
    }
    if (checked.program) {
      checked.readiness = checked.program->readiness();
      // The table needs figures only; thousands of paths would fill the memory.
      checked.program->trajectory = {};
      checked.program->text = {};
    }
    exit = checked.isUnderstood() ? exit : Exit::Wrong;
    all.push_back(std::move(checked));
  }
  if (files.empty()) {
    fmt::print(stderr, "No NC program was found.\n");
    return Exit::BadInput;
  }
  if (options.json) {
    printJson(single ? list.front() : list);
  } else if (!single) {
    printTable(all);
  }
  return exit;
}

}  // namespace rivulet::cli
