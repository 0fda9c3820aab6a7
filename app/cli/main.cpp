// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CLI/CLI.hpp>

#include <algorithm>

#include "cli/commands.h"
#include "experiments/catalogue.h"
#include "templates/cells.h"

namespace {

using rivulet::cli::Exit;
using rivulet::cli::OperatingOptions;

/// Greater than zero and finite: a feed or a distance.
const CLI::Validator kPositive(
    [](std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && value > 0.0 && value < 1e9
                 ? std::string()
                 : "must be a number greater than zero, not " + text;
    },
    "POSITIVE");

/// Letters of axes.
const CLI::Validator kAxes(
    [](std::string& text) {
      rivulet::templates::TemplateParameters parameters;
      const auto chosen = rivulet::templates::chooseAxes(parameters, text);
      return chosen ? std::string() : chosen.error().message;
    },
    "AXES");

CLI::Option* addFeed(CLI::App* command, OperatingOptions& point) {
  return command->add_option("--feed", point.feedMmPerMin, "Feed F, mm/min")->check(kPositive);
}

void addPoint(CLI::App* command, OperatingOptions& point) {
  command->add_option("--method", point.method, "Streaming method")
      ->check(CLI::IsMember({"window", "position", "signal", "credit", "file"}))
      ->capture_default_str();
  command
      ->add_option("--points", point.pointsPerLoop,
                   "Points per loop N; methods window and credit: per window")
      ->capture_default_str();
}

void addDelta(CLI::App* command, OperatingOptions& point) {
  command->add_option("--delta", point.deltaMm, "Distance at which a point counts as reached, mm")
      ->check(kPositive)
      ->capture_default_str();
}

void addAxes(CLI::App* command, OperatingOptions& point) {
  command
      ->add_option("--axes", point.axes,
                   "Axes to move, out of XYZABC; rotary axes in degrees (method window). Default: "
                   "XYZ and the rotary axes that the program moves")
      ->check(kAxes);
}

void addLayout(CLI::App* command, OperatingOptions& point) {
  command
      ->add_option("--layout", point.layout,
                   "Layout of the slots in the R-parameters (methods position and signal)")
      ->check(CLI::IsMember({"paper", "contiguous"}))
      ->capture_default_str();
  addAxes(command, point);
  command
      ->add_option("--correction-limit", point.correctionLimitMm,
                   "Largest online correction of each linear axis, mm (methods window and credit)")
      ->check(CLI::Range(0.001, rivulet::templates::kCorrectionLimitMmMax));
  command->add_option("--windows", point.windows, "Windows (methods window and credit)")
      ->capture_default_str();
  command
      ->add_option("--base-cell", point.baseCell, "First R-parameter (methods window and credit)")
      ->capture_default_str();
  command
      ->add_option("--windows-ahead", point.windowsAhead,
                   "Method credit: most windows that are copied but not executed")
      ->check(CLI::Range(1, 8))
      ->capture_default_str();
  command->add_flag("--no-slow-down", point.noSlowDown,
                    "Method credit: full feed until nothing is left, then stop");
}

void addLoading(CLI::App* command, rivulet::cli::LoadingOptions& loading) {
  command
      ->add_option("--chord-tolerance", loading.chordToleranceMm,
                   "Greatest distance of chords from their arc or spline, mm")
      ->check(kPositive)
      ->capture_default_str();
  std::vector<std::string> names{"auto"};
  for (const rivulet::gcode::Dialect dialect : rivulet::gcode::kDialects) {
    names.emplace_back(rivulet::gcode::dialectName(dialect));
  }
  command->add_option("--dialect", loading.dialect, "Language of the program")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command->add_option(
      "--accept", loading.accepted,
      "Leave out a word that is not understood, by the name check prints (repeatable)");
  command
      ->add_option("--arc-centres", loading.centres,
                   "Meaning of I, J and K of arcs, if a post-processor differs from the dialect")
      ->check(CLI::IsMember({"as-programmed", "absolute", "start-minus-centre"}))
      ->capture_default_str();
  command->add_flag("--block-skip", loading.blockSkip, "Leave out blocks that begin with /");
}

void addResampling(CLI::App* command, rivulet::cli::ResamplingOptions& resampling) {
  command
      ->add_option("--thin", resampling.thinMm,
                   "Leave out points within this distance of the path, mm")
      ->check(kPositive);
  command->add_option("--split", resampling.splitMm, "Longest move; longer ones are divided, mm")
      ->check(kPositive);
}

void addJson(CLI::App* command, bool& json) {
  command->add_flag("--json", json, "Print the result as JSON");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Streams a tool path to a CNC machine over OPC UA while the machine moves.",
               "rivulet-cli");
  app.set_version_flag("--version", RIVULET_VERSION);
  app.require_subcommand(1);
  Exit exit = Exit::Done;

  rivulet::cli::CheckOptions check;
  CLI::App* checkCommand =
      app.add_subcommand("check", "Read NC programs and print their facts and findings");
  checkCommand->add_option("FILE", check.files, "NC programs, or folders of NC programs")
      ->required();
  addLoading(checkCommand, check.loading);
  addJson(checkCommand, check.json);
  checkCommand->callback([&] { exit = rivulet::cli::check(check); });

  rivulet::cli::PointsOptions points;
  CLI::App* pointsCommand =
      app.add_subcommand("points", "Write the points of an NC program as a table");
  pointsCommand->add_option("FILE", points.file, "NC program")->required();
  addLoading(pointsCommand, points.loading);
  pointsCommand->add_option("-o,--output", points.output, "File to write");
  pointsCommand->add_flag("--keep-arcs", points.keepArcs, "One point per arc instead of chords");
  addResampling(pointsCommand, points.resampling);
  pointsCommand->callback([&] { exit = rivulet::cli::points(points); });

  rivulet::cli::FeasibilityOptions feasibility;
  CLI::App* feasibilityCommand =
      app.add_subcommand("feasibility", "Judge an operating point before anything moves");
  addPoint(feasibilityCommand, feasibility.point);
  addDelta(feasibilityCommand, feasibility.point);
  addAxes(feasibilityCommand, feasibility.point);
  addFeed(feasibilityCommand, feasibility.point)->required();
  addLoading(feasibilityCommand, feasibility.loading);
  addResampling(feasibilityCommand, feasibility.resampling);
  auto* program = feasibilityCommand->add_option("--program", feasibility.program, "NC program");
  auto* distance = feasibilityCommand
                       ->add_option("--d-min", feasibility.pointDistanceMm,
                                    "Smallest distance of neighbouring points, mm")
                       ->check(kPositive);
  program->excludes(distance);
  feasibilityCommand
      ->add_option("--access-time", feasibility.accessTimeMs, "OPC UA access time per node, ms")
      ->check(kPositive)
      ->capture_default_str();
  auto* calibrationFile = feasibilityCommand->add_option(
      "--calibration", feasibility.calibration, "Measured access time: file of calibrate --output");
  feasibilityCommand
      ->add_option("--endpoint", feasibility.endpoint,
                   "Measured access time: stored by calibrate for this OPC UA server")
      ->excludes(calibrationFile);
  feasibilityCommand->add_option("--delta-safety", feasibility.deltaSafety, "Safety factor on (2)")
      ->check(kPositive)
      ->capture_default_str();
  feasibilityCommand
      ->add_option("--preset", feasibility.preset,
                   "Machine whose axes determine the cost of pauses: preset or TOML file")
      ->capture_default_str();
  addJson(feasibilityCommand, feasibility.json);
  feasibilityCommand->callback([&] {
    if (feasibility.program.empty() && !feasibility.pointDistanceMm) {
      throw CLI::RequiredError("--program or --d-min");
    }
    exit = rivulet::cli::feasibility(feasibility);
  });

  rivulet::cli::TemplateOptions makeTemplate;
  CLI::App* templateCommand =
      app.add_subcommand("template", "Write the flexible program for the control");
  addPoint(templateCommand, makeTemplate.point);
  addLayout(templateCommand, makeTemplate.point);
  templateCommand
      ->add_option("--r-parameters", makeTemplate.rParameterCount,
                   "R-parameters of the control (MD28050)")
      ->capture_default_str();
  templateCommand->add_option("-o,--output", makeTemplate.output, "File to write");
  auto* lintOption = templateCommand->add_option(
      "--lint", makeTemplate.lint,
      "Look for faults in this flexible program, which was made for the same settings");
  auto* outputOption = templateCommand->get_option("--output");
  lintOption->excludes(outputOption);
  templateCommand->add_flag("--verify", makeTemplate.verify,
                            "Look for faults and run the program on the virtual machine");
  templateCommand
      ->add_option("--preset", makeTemplate.preset, "Machine of --verify: a name or a file")
      ->capture_default_str();
  addJson(templateCommand, makeTemplate.json);
  templateCommand->callback([&] { exit = rivulet::cli::makeTemplate(makeTemplate); });

  rivulet::cli::StreamOptions stream;
  CLI::App* streamCommand = app.add_subcommand("stream", "Stream an NC program to a control");
  streamCommand->add_option("FILE", stream.file, "NC program")->required();
  addLoading(streamCommand, stream.loading);
  addResampling(streamCommand, stream.resampling);
  addPoint(streamCommand, stream.point);
  addDelta(streamCommand, stream.point);
  addFeed(streamCommand, stream.point)->required();
  addLayout(streamCommand, stream.point);
  auto* endpoint = streamCommand->add_option("--endpoint", stream.endpoint, "OPC UA server");
  auto* simulate =
      streamCommand->add_flag("--simulate", stream.simulate, "Virtual machine in virtual time");
  endpoint->excludes(simulate);
  streamCommand->add_option("--preset", stream.preset, "Machine of --simulate: a name or a file")
      ->capture_default_str();
  streamCommand->add_option("--seed", stream.seed, "Seed of --simulate")->capture_default_str();
  streamCommand->add_option("--record", stream.record, "File for the recording of the run");
  streamCommand
      ->add_option("--stop-after", stream.stopAfterS, "Request a stop after this many seconds")
      ->check(kPositive);
  streamCommand->add_option("--resume", stream.resume,
                            "Resume the run of this JSON report (methods window and credit)");
  streamCommand
      ->add_option("--access", stream.access,
                   "How several R-parameters travel; auto: the best form the control understands")
      ->check(CLI::IsMember({"auto", "single", "list", "array"}))
      ->capture_default_str();
  auto* byHand =
      streamCommand
          ->add_option("--transfer", stream.transfer,
                       "Who transfers the flexible program to the control; auto: Rivulet, through "
                       "the server's file methods; by-hand: you, the steps are printed")
          ->check(CLI::IsMember({"auto", "by-hand"}))
          ->capture_default_str();
  streamCommand
      ->add_option("--program-file", stream.programFile,
                   "by-hand: file for the flexible program (default: its name, in this folder)")
      ->needs(byHand);
  streamCommand
      ->add_option(
          "--correct", stream.correct,
          "Live source of corrections, with lines like X 0.01 Y -0.02; - is standard input")
      ->needs(streamCommand->get_option("--correction-limit"));
  streamCommand->add_flag("--no-monitor", stream.noMonitor, "No reads for the display");
  streamCommand->add_flag("--even-pauses", stream.evenPauses,
                          "Method window: windows of M points each, wherever they end");
  streamCommand->add_flag("--accept-infeasible", stream.acceptInfeasible,
                          "Start on a real control although the verdict is not feasible");
  addJson(streamCommand, stream.json);
  streamCommand->callback([&] {
    if (!stream.simulate && stream.endpoint.empty()) {
      throw CLI::RequiredError("--endpoint or --simulate");
    }
    exit = rivulet::cli::stream(stream);
  });

  rivulet::cli::AnalyseOptions analyse;
  CLI::App* analyseCommand = app.add_subcommand("analyse", "Analyse a recording");
  analyseCommand->add_option("RECORDING", analyse.file, "File of stream --record")->required();
  addJson(analyseCommand, analyse.json);
  analyseCommand->callback([&] { exit = rivulet::cli::analyse(analyse); });

  rivulet::cli::CalibrateOptions calibrate;
  CLI::App* calibrateCommand =
      app.add_subcommand("calibrate", "Measure how long it takes to read and write R-parameters");
  auto* measured = calibrateCommand->add_option("--endpoint", calibrate.endpoint, "OPC UA server");
  auto* virtually = calibrateCommand->add_flag("--simulate", calibrate.simulate, "Virtual machine");
  measured->excludes(virtually);
  calibrateCommand->add_flag("--no-arrays", calibrate.noArrays,
                             "Do not try arrays: only the present values are written");
  calibrateCommand->add_option("--preset", calibrate.preset, "Machine of --simulate")
      ->capture_default_str();
  calibrateCommand->add_option("--seed", calibrate.seed, "Seed of --simulate")
      ->capture_default_str();
  calibrateCommand
      ->add_option("--first-cell", calibrate.firstCell, "First R-parameter that nobody uses")
      ->required();
  calibrateCommand
      ->add_option("--last-cell", calibrate.lastCell, "Last R-parameter that nobody uses")
      ->required();
  calibrateCommand->add_option("--shots", calibrate.shots, "Requests of each kind")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  calibrateCommand
      ->add_option("--budget", calibrate.budgetS,
                   "Time limit, s; to keep it, the longest kinds get fewer shots; 0: no limit")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  calibrateCommand->add_flag("--yes", calibrate.confirmed,
                             "Confirm that the cells of the real control may be written");
  calibrateCommand->add_option("-o,--output", calibrate.output,
                               "File for feasibility --calibration");
  addJson(calibrateCommand, calibrate.json);
  calibrateCommand->callback([&] {
    if (!calibrate.simulate && calibrate.endpoint.empty()) {
      throw CLI::RequiredError("--endpoint or --simulate");
    }
    exit = rivulet::cli::calibrate(calibrate);
  });

  rivulet::cli::CommissionOptions commission;
  CLI::App* commissionCommand = app.add_subcommand(
      "commission", "Test whether method credit may run on a control; moves no axis");
  auto* tested = commissionCommand->add_option("--endpoint", commission.endpoint, "OPC UA server");
  auto* pretended =
      commissionCommand->add_flag("--simulate", commission.simulate, "Virtual machine");
  tested->excludes(pretended);
  commissionCommand->add_option("--preset", commission.preset, "Machine of --simulate")
      ->capture_default_str();
  commissionCommand->add_option("--seed", commission.seed, "Seed of --simulate")
      ->capture_default_str();
  commissionCommand
      ->add_option("--base-cell", commission.baseCell, "First of ten R-parameters that nobody uses")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  commissionCommand
      ->add_option(
          "--transfer", commission.transfer,
          "Who transfers the program of the test to the control; by-hand: you, with --print")
      ->check(CLI::IsMember({"auto", "by-hand"}))
      ->capture_default_str();
  commissionCommand->add_flag("--print", commission.printProgram,
                              "Print the program of the test and do nothing else");
  addJson(commissionCommand, commission.json);
  commissionCommand->callback([&] {
    if (!commission.simulate && commission.endpoint.empty() && !commission.printProgram) {
      throw CLI::RequiredError("--endpoint or --simulate");
    }
    exit = rivulet::cli::commission(commission);
  });

  rivulet::cli::ExperimentCommandOptions experiment;
  CLI::App* experimentCommand = app.add_subcommand(
      "experiment", "Repeat the experiments of the paper and compare the figures");
  std::vector<std::string> experiments = rivulet::experiments::experimentNames();
  experiments.insert(experiments.end(), {"lookahead", "all"});
  experimentCommand->add_option("NAME", experiment.names, "Experiments, or all")
      ->required()
      ->check(CLI::IsMember(experiments));
  experimentCommand->add_option("--seeds", experiment.seeds, "Runs per point (shots, contours)")
      ->check(CLI::Range(1, 1000000));
  experimentCommand->add_option("--preset", experiment.preset, "Virtual machine: a name or a file")
      ->capture_default_str();
  experimentCommand->add_option("--endpoint", experiment.endpoint,
                                "OPC UA server instead of virtual time (table1, figure2)");
  experimentCommand->add_option("--recordings", experiment.recordings,
                                "Recordings of another motion planner, for lookahead");
  experimentCommand->add_option("--threads", experiment.threads, "0: one per core")
      ->check(CLI::Range(0, 1024));
  experimentCommand->add_option("--json", experiment.json, "File for all figures");
  experimentCommand->add_option("--csv", experiment.csv, "File for all figures");
  experimentCommand->add_option("--plot", experiment.plot, "File for the plot, .svg");
  experimentCommand->add_option("--report", experiment.report,
                                "Folder for fidelity.md and its pictures");
  experimentCommand->callback([&] {
    if (experiment.recordings.empty() &&
        std::count(experiment.names.begin(), experiment.names.end(), "lookahead") > 0) {
      throw CLI::RequiredError("--recordings");
    }
    exit = rivulet::cli::experiment(experiment);
  });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are successes; everything else is wrong usage.
    return app.exit(error) == 0 ? 0 : static_cast<int>(Exit::BadInput);
  }
  return static_cast<int>(exit);
}
