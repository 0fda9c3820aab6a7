// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "cli/commands.h"
#include "cli/connection.h"
#include "gcode/feeds.h"
#include "opcua/security.h"
#include "papers/catalogue.h"
#include "platform/command_line.h"
#include "platform/log.h"
#include "platform/output.h"
#include "platform/process.h"
#include "streaming/control/machine_profile.h"
#include "templates/cells.h"
#include "trace/signal_file.h"
#include "trace_fetch/agent.h"
#include "trace_fetch/history.h"

#ifdef RIVULET_WITH_OPEN62541
#include "qtopcua/open_link.h"
#endif

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

/// Where an axis can be, mm.
const CLI::Validator kPlace(
    [](std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && std::abs(value) < 1e6
                 ? std::string()
                 : "must be a place in mm, not " + text;
    },
    "MM");

/// Letters of axes.
const CLI::Validator kAxes(
    [](std::string& text) {
      rivulet::templates::TemplateParameters parameters;
      const auto chosen = rivulet::templates::chooseAxes(parameters, text);
      return chosen ? std::string() : chosen.error().message;
    },
    "AXES");

/// A number, or the feeds of the program.
const CLI::Validator kFeed(
    [](std::string& text) { return text == "program" ? std::string() : kPositive(text); },
    "program|MM_PER_MIN");

void addFeedCells(CLI::App* command, OperatingOptions& point) {
  command
      ->add_option("--feed-cells", point.feedCells,
                   "Feeds of the program: one cell per window, which then ends where the feed "
                   "changes, or one per point; auto: what makes the run shorter")
      ->check(CLI::IsMember({"auto", "window", "point"}))
      ->capture_default_str();
}

/// What the feeds of a run are: one for all moves, or those of the program.
void addFeed(CLI::App* command, OperatingOptions& point) {
  command
      ->add_option_function<std::string>(
          "--feed",
          [&point](const std::string& text) {
            point.feedMmPerMin = 0.0;
            if (text != "program") {
              CLI::detail::lexical_cast(text, point.feedMmPerMin);
            }
          },
          "Feed of all moves, mm/min; program: each move with the feed of its own "
          "block, rapids as rapids")
      ->check(kFeed)
      ->default_str("program");
  command
      ->add_option("--override", point.overridePercent,
                   "Override on the feeds of the program, rapids included, %")
      ->check(
          CLI::Range(100.0 * rivulet::gcode::kOverrideMin, 100.0 * rivulet::gcode::kOverrideMax))
      ->capture_default_str();
  command
      ->add_option("--rapid", point.rapidMmPerMin,
                   "Feed of the program's rapids at 100 %, mm/min (default: that of --preset)")
      ->check(kPositive);
  addFeedCells(command, point);
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

void addPacked(CLI::App* command, OperatingOptions& point) {
  command->add_flag("--packed", point.packed,
                    "Points that follow the first of their window have one R-parameter for all "
                    "axes, in steps of 0.001 mm: fewer accesses (methods window and credit)");
}

void addLayout(CLI::App* command, OperatingOptions& point) {
  command
      ->add_option("--layout", point.layout,
                   "Layout of the slots in the R-parameters (methods position and signal)")
      ->check(CLI::IsMember({"paper", "contiguous"}))
      ->capture_default_str();
  addAxes(command, point);
  addPacked(command, point);
  command
      ->add_option("--correction-limit", point.correctionLimitMm,
                   "Largest online correction of each linear axis, mm (methods window and credit)")
      ->check(CLI::Range(0.001, rivulet::templates::kCorrectionLimitMmMax));
  command
      ->add_option("--lift", point.liftMm,
                   "While the axes are held, the tool may be lifted by so much, mm (methods window "
                   "and credit; on a real control after commission --feed-cell --lift)")
      ->check(CLI::Range(0.001, rivulet::templates::kLiftMmMax));
  command
      ->add_option(
          "--silence-limit", point.silenceLimitS,
          "Without a sign of this program for so long, the axes stand on the path, s; 0: "
          "not at all (methods window, credit and file). Default: that of the machine, or 1")
      ->check(CLI::Range(0.0, rivulet::templates::kSilenceLimitSMax));
  command
      ->add_option("--feed-factor", point.factor,
                   "A source beside the operator may multiply the override: least and largest "
                   "factor, as in 0.2 1.2 (methods window and credit)")
      ->expected(2);
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
  command
      ->add_option("--control", point.control, "Make of control that the flexible program is for")
      ->check(CLI::IsMember({"sinumerik", "linuxcnc"}))
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
  std::vector<std::string> names{"auto", "iso"};  // iso: what programs of fanuc are called too
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
  command
      ->add_option("--units", loading.units,
                   "Unit of a program that does not say it: mm, inch (auto: mm, with a warning)")
      ->check(CLI::IsMember({"auto", "mm", "inch"}))
      ->capture_default_str();
  command
      ->add_option("--no-point", loading.noPoint,
                   "What coordinates without a decimal point are: units, increments of 0.001 mm or "
                   "0.0001 inch (auto: units, with a warning)")
      ->check(CLI::IsMember({"auto", "units", "increments"}))
      ->capture_default_str();
  command
      ->add_option("--setting", loading.settings,
                   "Settings of the control that the program needs, as in \"plane=0 stroke=2 "
                   "tap-speed=500 lift=-X lift-by=0.2 lift-angle=0 clearance=0.25 arc=line "
                   "offset=507\" (mm)")
      ->check([](const std::string& text) {
        return rivulet::gcode::controlSettingsOf(text) ? std::string()
                                                       : "no settings of a control: " + text;
      });
  command->add_flag("--block-skip", loading.blockSkip, "Leave out blocks that begin with /");
}

void addResampling(CLI::App* command, rivulet::cli::ResamplingOptions& resampling) {
  command
      ->add_option("--tolerance,--thin", resampling.toleranceMm,
                   "Leave out points where the path stays within this, mm and degrees")
      ->check(kPositive);
  command->add_option("--split", resampling.splitMm, "Longest move; longer ones are divided, mm")
      ->check(kPositive);
}

void addJson(CLI::App* command, bool& json) {
  command->add_flag("--json", json, "Print the result as JSON");
}

void addCheckCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Read NC programs and print their facts and findings");
  command->add_option("FILE", options->files, "NC programs, or folders of NC programs")->required();
  addLoading(command, options->loading);
  command->add_flag("--job", options->asJob,
                    "Say what job would refuse, on a virtual machine, and exit as it would");
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::check(*options); });
}

void addPointsCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::PointsOptions>();
  CLI::App* command = app.add_subcommand("points", "Write the points of an NC program as a table");
  command->add_option("FILE", options->file, "NC program")->required();
  addLoading(command, options->loading);
  command->add_option("-o,--output", options->output, "File to write");
  command->add_flag("--keep-arcs", options->keepArcs, "One point per arc instead of chords");
  addResampling(command, options->resampling);
  command->callback([options, &exit] { exit = rivulet::cli::points(*options); });
}

void addFeasibilityCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::FeasibilityOptions>();
  CLI::App* command =
      app.add_subcommand("feasibility", "Judge an operating point before anything moves");
  addPoint(command, options->point);
  addDelta(command, options->point);
  addAxes(command, options->point);
  addPacked(command, options->point);
  addFeed(command, options->point);
  addLoading(command, options->loading);
  addResampling(command, options->resampling);
  auto* program = command->add_option("--program", options->program, "NC program");
  auto* distance = command
                       ->add_option("--d-min", options->pointDistanceMm,
                                    "Smallest distance of neighbouring points, mm")
                       ->check(kPositive);
  program->excludes(distance);
  command->add_option("--access-time", options->accessTimeMs, "OPC UA access time per node, ms")
      ->check(kPositive)
      ->capture_default_str();
  auto* calibrationFile = command->add_option("--calibration", options->calibration,
                                              "Measured access time: file of calibrate --output");
  command
      ->add_option("--endpoint", options->endpoint,
                   "Measured access time: stored by calibrate for this OPC UA server")
      ->excludes(calibrationFile);
  command->add_option("--delta-safety", options->deltaSafety, "Safety factor on (2)")
      ->check(kPositive)
      ->capture_default_str();
  command
      ->add_option(
          "--preset", options->preset,
          "Machine whose axes determine the cost of pauses and the largest feeds: preset or "
          "TOML file")
      ->capture_default_str();
  addJson(command, options->json);
  command->callback([options, &exit] {
    if (options->program.empty() && !options->pointDistanceMm) {
      throw CLI::RequiredError("--program or --d-min");
    }
    if (options->program.empty() && options->point.feedMmPerMin == 0.0) {
      throw CLI::RequiredError("--feed with a number, where there is no --program");
    }
    exit = rivulet::cli::feasibility(*options);
  });
}

void addTemplateCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::TemplateOptions>();
  CLI::App* command = app.add_subcommand("template", "Write the flexible program for the control");
  addPoint(command, options->point);
  addLayout(command, options->point);
  addFeedCells(command, options->point);
  command
      ->add_option("--r-parameters", options->rParameterCount,
                   "R-parameters of the control (MD28050)")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "File to write");
  auto* lintOption = command->add_option(
      "--lint", options->lint,
      "Look for faults in this flexible program, which was made for the same settings");
  auto* outputOption = command->get_option("--output");
  lintOption->excludes(outputOption);
  command->add_flag("--verify", options->verify,
                    "Look for faults and run the program on the virtual machine");
  command->add_option("--preset", options->preset, "Machine of --verify: a name or a file")
      ->capture_default_str();
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::makeTemplate(*options); });
}

void addLive(CLI::App* command, rivulet::cli::LiveOptions& live) {
  auto* source = command->add_option(
      "--live", live.source,
      "Points that arrive while the machine moves: - (standard input), unix:PATH, tcp:PORT, "
      "udp:PORT or opcua:FILE (docs/live.md)");
  auto* box = command
                  ->add_option("--box", live.boxMm,
                               "Agreed with the source: least and largest X, Y and Z, mm")
                  ->expected(6)
                  ->needs(source);
  source->needs(box);
  const auto add = [&](const char* name, double& value, const char* text) {
    command->add_option(name, value, text)->needs(source)->check(kPositive)->capture_default_str();
  };
  add("--step-max", live.agreed.stepMmMax, "Agreed: largest distance of two points, mm");
  add("--turn-max", live.agreed.turnDegMax, "Agreed: largest turn of a rotary axis, degrees");
  add("--feed-max", live.agreed.feedMmPerMinMax, "Agreed: largest F, mm/min");
  add("--start-within", live.agreed.startMmMax,
      "Agreed: distance of the first point from the tool, mm");
  command
      ->add_option("--merge-below", live.agreed.distanceMmMin,
                   "Points that are closer are merged, mm")
      ->needs(source)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add("--full-within", live.fullWithinMs, "A window that is not full is sent after this, ms");
  add("--hold-after", live.holdAfterS, "The run holds after this much silence, s");
  add("--end-after", live.endAfterS, "The run ends after this much silence, s");
}

/// Options of `stream` that a whole job does not have.
constexpr std::array kForMotionAlone{
    "--tolerance",        "--split",    "--delta",   "--passed-by",   "--resume",
    "--access",           "--transfer", "--correct", "--even-pauses", "--accept-changes",
    "--accept-infeasible"};

/// What the operator wants of the run, and who is told how far it is.
void addOrders(CLI::App* command, rivulet::cli::OrderOptions& options) {
  auto* orders = command->add_option(
      "--orders", options.source,
      "File, pipe or - for standard input with lines: hold, continue, override 50. "
      "Without it: keys h, c, + and - on a terminal");
  command
      ->add_flag_callback(
          "--end-with-orders",
          [&options] {
            if (options.source != "-") {
              throw CLI::ValidationError("--end-with-orders",
                                         "is for orders by standard input: --orders -");
            }
            options.endsRun = true;
          },
          "The end of standard input is a stop, as by Ctrl-C: whoever gives the orders has gone")
      ->needs(orders);
  command->add_option("--progress", options.progress,
                      "File or pipe that is told how far the run is, in lines of JSON");
}

void addFactor(CLI::App* command, rivulet::cli::FactorOptions& factor) {
  auto* source = command
                     ->add_option("--feed-from", factor.source,
                                  "Adaptive feed: source of factors of the override, with lines "
                                  "like feed 0.85: - (standard input), unix:PATH, tcp:PORT or "
                                  "udp:PORT (docs/live.md)")
                     ->needs(command->get_option("--feed-factor"));
  command->add_option("--feed-silence", factor.silenceS, "Agreed: time without a factor, s")
      ->needs(source)
      ->check(kPositive)
      ->capture_default_str();
  command
      ->add_option("--feed-silent", factor.inSilence,
                   "Agreed: what acts then, and instead of a factor that was not agreed: hold the "
                   "axes, or the override of the operator alone")
      ->needs(source)
      ->check(CLI::IsMember({"hold", "override"}))
      ->capture_default_str();
}

/// How the points travel, and what the operator wants of the run.
void addMotionOptions(CLI::App* command, rivulet::cli::StreamOptions& options) {
  command
      ->add_option("--passed-by", options.passedBy,
                   "Method position: what shows that a point has been passed")
      ->check(CLI::IsMember({"position", "distance-to-go"}))
      ->capture_default_str();
  command->add_option("--stop-after", options.stopAfterS, "Request a stop after this many seconds")
      ->check(kPositive);
  addOrders(command, options.orders);
  addFactor(command, options.live.factor);
  command->add_option("--resume", options.resume,
                      "Resume the run of this file: one that runs lists, or a JSON report "
                      "(methods window and credit)");
  command->add_flag("--accept-changes", options.acceptChanges,
                    "Resume although the program has been changed where nothing was executed yet");
  command
      ->add_option("--access", options.access,
                   "How several R-parameters travel; auto: the best form the control understands")
      ->check(CLI::IsMember({"auto", "single", "list", "array"}))
      ->capture_default_str();
  auto* byHand =
      command
          ->add_option("--transfer", options.transfer,
                       "Who transfers the flexible program to the control; auto: Rivulet, through "
                       "the server's file methods; by-hand: you, the steps are printed")
          ->check(CLI::IsMember({"auto", "by-hand"}))
          ->capture_default_str();
  command
      ->add_option("--program-file", options.programFile,
                   "by-hand: file for the flexible program (default: its name, in this folder)")
      ->needs(byHand);
  command
      ->add_option(
          "--correct", options.correct,
          "Live source of corrections, with lines like X 0.01 Y -0.02; - is standard input")
      ->needs(command->get_option("--correction-limit"));
}

void addStraight(CLI::App* command, bool& straight) {
  command->add_flag("--straight", straight,
                    "Nothing is in the way of the first move, though it passes within what the "
                    "program cuts");
}

/// @throws CLI::RequiredError
Exit runStream(rivulet::cli::StreamOptions& options, const CLI::App& command) {
  if (!options.simulate && options.endpoint.empty()) {
    throw CLI::RequiredError("--endpoint or --simulate");
  }
  const bool isLive = !options.live.source.empty();
  if (isLive != options.file.empty()) {
    throw CLI::RequiredError("FILE or --live, one of them");
  }
  if (isLive && options.resampling.toleranceMm > 0.0) {
    throw CLI::ExcludesError("--live", "--tolerance");
  }
  options.namesMachine = command.get_option("--preset")->count() > 0;
  for (const char* const name : kForMotionAlone) {
    if (command.get_option(name)->count() > 0) {
      options.motionOption = name;
    }
  }
  if (options.point.method != "window" && options.point.method != "credit") {
    options.motionOption = "--method " + options.point.method;
  }
  return isLive ? rivulet::cli::streamLive(options) : rivulet::cli::stream(options);
}

void addStreamCommand(CLI::App& app, Exit& exit, std::vector<std::string> words) {
  const auto options = std::make_shared<rivulet::cli::StreamOptions>();
  options->command = std::move(words);
  CLI::App* command = app.add_subcommand("stream", "Stream an NC program to a control");
  command->add_option("FILE", options->file, "NC program");
  addLive(command, options->live);
  addLoading(command, options->loading);
  addResampling(command, options->resampling);
  command->get_option("--tolerance")->excludes(command->get_option("--split"));
  addPoint(command, options->point);
  addDelta(command, options->point);
  addFeed(command, options->point);
  addLayout(command, options->point);
  auto* endpoint = command->add_option("--endpoint", options->endpoint, "OPC UA server");
  auto* simulate =
      command->add_flag("--simulate", options->simulate, "Virtual machine in virtual time");
  endpoint->excludes(simulate);
  command
      ->add_option("--preset", options->preset,
                   "Machine of --simulate, a name or a file; with --endpoint: whose rapid and axes "
                   "limit the feeds of the program")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of --simulate")->capture_default_str();
  command->add_option("--record", options->record, "File for the recording of the run");
  addMotionOptions(command, *options);
  command->add_flag("--from-start", options->fromStart,
                    "Begin a whole job at its beginning although a job was left on this control");
  addStraight(command, options->straight);
  command->add_flag("--motion-only", options->motionOnly,
                    "Without tools, spindle, coolant and all else that the control executes "
                    "itself: set them there");
  command->add_flag("--no-monitor", options->noMonitor, "No reads for the display");
  command
      ->add_option(
          "--stop-limit", options->point.stopLimitS,
          "On a control that has not passed the test of the feed cell, no window of several "
          "moves takes longer, s. Default: that of the machine, or 5")
      ->check(CLI::Range(rivulet::streaming::kStopLimitSMin, rivulet::streaming::kStopLimitSMax));
  command->add_flag("--even-pauses", options->evenPauses,
                    "Method window: windows of M points each, wherever they end");
  command->add_flag("--accept-infeasible", options->accepted.infeasible,
                    "Start on a real control although the verdict is not feasible");
  command->add_flag("--accept-repeats", options->accepted.repeats,
                    "Methods position and signal on a real control: a late client makes it execute "
                    "old points again, and that is accepted");
  addJson(command, options->json);
  command->callback([options, command, &exit] { exit = runStream(*options, *command); });
}

void addRaiseCommand(CLI::App& app, Exit& exit, std::vector<std::string> words) {
  const auto options = std::make_shared<rivulet::cli::StreamOptions>();
  options->command = std::move(words);
  CLI::App* command = app.add_subcommand(
      "raise", "Raise the tool straight up, as a run of its own: after a stop in the cut");
  command->add_option("--endpoint", options->endpoint, "OPC UA server")->required();
  command
      ->add_option_function<double>(
          "--to", [options](double mm) { options->tool.raiseToMm = mm; },
          "Z to which it is raised, mm, in the frame that the control has active")
      ->required()
      ->check(kPlace);
  command->add_option("--feed", options->point.feedMmPerMin, "Feed, mm/min")
      ->required()
      ->check(kPositive);
  addPoint(command, options->point);
  addLayout(command, options->point);
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::stream(*options); });
}

void addBackCommand(CLI::App& app, Exit& exit, std::vector<std::string> words) {
  const auto options = std::make_shared<rivulet::cli::StreamOptions>();
  options->command = std::move(words);
  options->tool.back.emplace();
  CLI::App* command = app.add_subcommand(
      "back", "Drive the tool back along the path of a run that was left, as a run of its own");
  command->add_option("RUN", options->tool.back->run, "File of the run, see rivulet-cli runs")
      ->required();
  command->add_option("--endpoint", options->endpoint, "OPC UA server")->required();
  const auto toRapid = std::make_shared<bool>(false);
  auto* by = command
                 ->add_option_function<double>(
                     "--by", [options](double mm) { options->tool.back->mm = mm; },
                     "Length of the way, mm, at most to where the last rapid ended")
                 ->check(kPositive);
  by->excludes(command->add_flag("--to-rapid", *toRapid, "To where the last rapid ended"));
  command->add_option("--feed", options->point.feedMmPerMin, "Feed, mm/min")
      ->required()
      ->check(kPositive);
  addJson(command, options->json);
  command->callback([options, by, toRapid, &exit] {
    if (by->count() == 0 && !*toRapid) {
      throw CLI::RequiredError("--by or --to-rapid");
    }
    exit = rivulet::cli::stream(*options);
  });
}

void addJobCommand(CLI::App& app, Exit& exit, std::vector<std::string> words) {
  const auto options = std::make_shared<rivulet::cli::JobOptions>();
  options->command = std::move(words);
  CLI::App* command = app.add_subcommand(
      "job", "Whole job: what is streamed, and what the control executes itself");
  command->add_option("FILE", options->file, "NC program")->required();
  addLoading(command, options->loading);
  addPoint(command, options->point);
  addFeed(command, options->point);
  addLayout(command, options->point);
  command->add_option("-o,--output", options->output, "Folder for the files of the job");
  auto* endpoint =
      command->add_option("--endpoint", options->endpoint, "Run it on this virtual machine");
  auto* simulate = command->add_flag("--simulate", options->simulate,
                                     "Run it on a virtual machine in virtual time");
  endpoint->excludes(simulate);
  auto* dry = command->add_option("--dry-run", options->dryRunMm,
                                  "So many mm higher, without spindle and coolant");
  dry->check(kPositive);
  command
      ->add_flag("--verify", options->verify,
                 "Compare the job with its source on a virtual machine: motion, actions of the "
                 "machine, modal state of its blocks")
      ->excludes(dry);
  const auto* preset =
      command
          ->add_option(
              "--preset", options->preset,
              "Machine of --simulate, a name or a file; whose rapid and axes limit the feeds. "
              "Not given: as large as the job needs")
          ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of --simulate")->capture_default_str();
  command->add_option("--record", options->record, "File for the recording of the job");
  command->add_flag("--no-monitor", options->noMonitor, "No reads for the display in stretches");
  command->add_option("--stop-after", options->stopAfterS, "Request a stop after this many seconds")
      ->check(kPositive);
  addOrders(command, options->orders);
  addFactor(command, options->factor);
  command->add_option("--m", options->functions,
                      "What the control does for an M function of another machine: NUMBER=ignore, "
                      "NUMBER=pass, or NUMBER=\"LINE\"; for its axis W: W=ignore or W=pass. Kept "
                      "for the machine of --endpoint "
                      "(repeatable)");
  auto* resume = command->add_option("--resume", options->resume,
                                     "Go on with a job that was left: the file that it named");
  auto* fromStretch =
      command->add_option("--from-stretch", options->fromStretch,
                          "Begin with this stretch, in the state that the program has there");
  fromStretch->check(CLI::PositiveNumber)->excludes(resume);
  command
      ->add_flag("--from-start", options->fromStart,
                 "Begin at the beginning although a job was left on this control: it cannot be "
                 "resumed then")
      ->excludes(resume)
      ->excludes(fromStretch);
  resume->excludes(simulate);
  resume->excludes(dry);
  addStraight(command, options->straight);
  command->add_flag("--yes", options->confirmed,
                    "What is done before the job goes on has been checked");
  addJson(command, options->json);
  command->callback([options, preset, &exit] {
    if (!options->simulate && !options->verify && options->endpoint.empty() &&
        options->output.empty()) {
      throw CLI::RequiredError("--output, --endpoint, --simulate or --verify");
    }
    options->namesMachine = preset->count() > 0;
    exit = rivulet::cli::job(*options);
  });
}

void addRunsCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::RunsOptions>();
  CLI::App* command = app.add_subcommand(
      "runs", "List runs that can be resumed; watch or stop the run on a control");
  auto* endpoint =
      command->add_option("--endpoint", options->endpoint, "Control that is asked for its run");
  command
      ->add_option("--base-cell", options->baseCell,
                   "First R-parameter of its program, if the name of the program does not say it")
      ->check(CLI::Range(0, 1000000));
  auto* watched =
      command->add_flag("--watch", options->watch, "Show how far the run is")->needs(endpoint);
  command
      ->add_flag("--stop", options->stop,
                 "Hold the axes at once, on the path, whoever started the run")
      ->needs(endpoint)
      ->excludes(watched);
  command
      ->add_flag("--end", options->end,
                 "Let the program go on to the end of its window or block, and end there")
      ->needs(endpoint)
      ->excludes(watched)
      ->excludes("--stop");
  command->add_option("--forget", options->forget, "Number of a run that is not to be kept");
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::runs(*options); });
}

void addAuditCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::AuditOptions>();
  CLI::App* command =
      app.add_subcommand("audit", "Print the audit trail of the window as CSV, or verify it");
  command->add_option("FILE", options->file, "Audit trail; without it that of this user");
  command->add_flag("--verify", options->verify, "Say whether lines were changed or removed");
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::audit(*options); });
}

/// What only makes sense with one trace, or one MTConnect agent.
void requireOneTrace(const rivulet::cli::AnalyseOptions& options) {
  if (!options.save.empty() && options.files.size() > 1) {
    throw CLI::ValidationError("--save", "writes the signals of one file");
  }
  if (!options.save.empty() && !rivulet::trace::isSignalFile(options.save)) {
    throw CLI::ValidationError("--save", "writes .csv or .h5");
  }
  const bool isOneAgent =
      options.files.size() == 1 && rivulet::trace_fetch::isAgentAddress(options.files.front());
  if (options.recordS > 0.0 && !isOneAgent) {
    throw CLI::ValidationError("--record", "needs the address of one MTConnect agent");
  }
  if (!options.keep.empty() && !isOneAgent) {
    throw CLI::ValidationError("--keep", "needs the address of one MTConnect agent");
  }
  const bool isOneServer =
      options.files.size() == 1 && rivulet::trace_fetch::isOpcUaAddress(options.files.front());
  if (!isOneServer && !(options.nodes.empty() && options.since.empty() && options.to.empty())) {
    throw CLI::ValidationError("--node, --since, --to", "need the address of one OPC UA server");
  }
}

/// What is read from elsewhere, and what is written of it.
void addTraceFiles(CLI::App& command, rivulet::cli::AnalyseOptions& options) {
  command.add_option("--save", options.save,
                     "File for all signals and events of the trace: .csv or .h5 (HDF5)");
  command
      .add_option("--record", options.recordS,
                  "From an MTConnect agent, also what comes in so many seconds")
      ->check(kPositive);
  command.add_option("--keep", options.keep,
                     "File for the answers of an MTConnect agent, which analyse reads again: .xml");
  command.add_option("--node", options.nodes,
                     "From the history of an OPC UA server: NAME=NODE, such as "
                     "x_act=ns=2;s=Axis.X; may be given several times");
  command.add_option("--since", options.since,
                     "Beginning of the history, UTC: 2026-01-02T03:04:05Z");
  command.add_option("--to", options.to, "End of the history, UTC");
}

void addAnalyseCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::AnalyseOptions>();
  CLI::App* command = app.add_subcommand("analyse", "Analyse recordings and traces");
  command
      ->add_option("FILE", options->files,
                   "Recordings of stream, traces of the control, or traces of other tools (CSV, "
                   "XML, HDF5, also compressed with zstd); or http://HOST:PORT of an MTConnect "
                   "agent, opc.tcp://HOST:PORT of an OPC UA server with a history")
      ->required();
  command->add_option("--program", options->program, "NC program that the trace should show");
  addLoading(command, options->loading);
  command->add_option("--map", options->columns,
                      "What columns mean, such as x_set=Pos1:um,time=t:ms; is remembered for files "
                      "of the same layout");
  command->add_option("--rate", options->rateHz, "Samples per second of a table without time, Hz")
      ->check(kPositive);
  command->add_option("--from", options->fromS, "Only from this time on, s from the first sample")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--until", options->untilS, "Only until this time, s from the first sample")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--tolerance", options->toleranceMm,
                   "Distance from the path that still is on it, mm (0.05)")
      ->check(kPositive);
  command->add_flag("--overview", options->overview,
                    "Only what the index of recordings says; hours are opened at once");
  auto* summary = command->add_flag("--summary", options->summary, "One table of all files");
  command->add_flag("--csv", options->csv, "The summary as comma-separated values")->needs(summary);
  command
      ->add_option("--trend", options->trend,
                   "File for access time and pauses over the runs of each machine: .html, .svg or "
                   ".json")
      ->needs(summary);
  addTraceFiles(*command, *options);
  command->add_option("--report", options->report,
                      "File for one page with pictures, to be read or printed: .pdf "
                      "or .html");
  auto* language =
      command->add_option("--language", options->language, "Of the report and the trend")
          ->check(CLI::IsMember({"de", "en", "es", "fr", "it"}))
          ->capture_default_str();
  auto* compare =
      command
          ->add_option("--compare", options->compare,
                       "Say how the other files differ from the first: at the same time, the same "
                       "length of path, or the same point of the program")
          ->check(CLI::IsMember({"time", "path", "point"}));
  command
      ->add_option("--signal", options->signalList,
                   "Formula of a signal to compare, such as x_act; may be given several times")
      ->needs(compare);
  command->add_option("--fail-if", options->failIf,
                      "Exit with 4 if the rule applies to a file, such as \"skipped>0 or "
                      "contour_error.max>0.05\"");
  addJson(command, options->json);
  command->callback([options, language, &exit] {
    if (language->count() > 0 && options->report.empty() && options->trend.empty()) {
      throw CLI::ValidationError("--language", "is that of --report or --trend");
    }
    if (!options->report.empty() && options->files.size() > 1) {
      throw CLI::ValidationError("--report", "makes a page of one file");
    }
    requireOneTrace(*options);
    if (options->fromS > options->untilS) {
      throw CLI::ValidationError("--until", "is before --from");
    }
    if (!options->compare.empty() && options->files.size() < 2) {
      throw CLI::ValidationError("--compare", "needs two files or more");
    }
    exit = !options->compare.empty() ? rivulet::cli::compare(*options)
           : options->overview       ? rivulet::cli::overview(*options)
                                     : rivulet::cli::analyse(*options);
  });
}

void addCalibrateCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::CalibrateOptions>();
  CLI::App* command =
      app.add_subcommand("calibrate", "Measure how long it takes to read and write R-parameters");
  auto* measured = command->add_option("--endpoint", options->endpoint, "OPC UA server");
  auto* virtually = command->add_flag("--simulate", options->simulate, "Virtual machine");
  measured->excludes(virtually);
  command->add_flag("--no-arrays", options->noArrays,
                    "Do not try arrays: only the present values are written");
  command->add_option("--preset", options->preset, "Machine of --simulate")->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of --simulate")->capture_default_str();
  command->add_option("--first-cell", options->firstCell, "First R-parameter that nobody uses")
      ->required();
  command->add_option("--last-cell", options->lastCell, "Last R-parameter that nobody uses")
      ->required();
  command->add_option("--shots", options->shots, "Requests of each kind")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command
      ->add_option("--budget", options->budgetS,
                   "Time limit, s; to keep it, the longest kinds get fewer shots; 0: no limit")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--yes", options->confirmed,
                    "Confirm that the cells of the real control may be written");
  command->add_option("-o,--output", options->output, "File for feasibility --calibration");
  addJson(command, options->json);
  command->callback([options, &exit] {
    if (!options->simulate && options->endpoint.empty()) {
      throw CLI::RequiredError("--endpoint or --simulate");
    }
    exit = rivulet::cli::calibrate(*options);
  });
}

void addCommissionCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::CommissionOptions>();
  CLI::App* command = app.add_subcommand(
      "commission",
      "Test a control: whether method credit or whole jobs may run on it, or whether a stop acts "
      "at once");
  auto* tested = command->add_option("--endpoint", options->endpoint, "OPC UA server");
  auto* pretended = command->add_flag("--simulate", options->simulate, "Virtual machine");
  tested->excludes(pretended);
  command->add_option("--preset", options->preset, "Machine of --simulate")->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of --simulate")->capture_default_str();
  command
      ->add_option(
          "--base-cell", options->baseCell,
          "First of ten R-parameters that nobody uses; of eighteen with --feed-cell, of 36 "
          "with --jobs")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command
      ->add_option(
          "--transfer", options->transfer,
          "Who transfers the program of the test to the control; by-hand: you, with --print")
      ->check(CLI::IsMember({"auto", "by-hand"}))
      ->capture_default_str();
  command->add_flag("--print", options->printProgram,
                    "Print the program of the test and do nothing else");
  auto* feedCell = command->add_flag("--feed-cell", options->feedCell,
                                     "Test whether hold, stop and override act at once. Without "
                                     "--air-move no axis moves, and the axes are not seen to obey");
  auto* jobs = command->add_flag("--jobs", options->jobs,
                                 "Test whether whole jobs may run: needs --air-move, and cycle "
                                 "start five times");
  jobs->excludes(feedCell);
  command
      ->add_option(
          "--block", options->blocks,
          "You agree that the control executes this block, as in \"S500 M3\", with nothing "
          "in its way; may be given again. A job may have only blocks of kinds that have "
          "been tried")
      ->needs(jobs)
      ->take_all();
  auto* move = command->add_option("--air-move", options->airMove,
                                   "You agree that this axis moves so many mm back and forth, "
                                   "several times, with nothing in its way: X20");
  command
      ->add_option(
          "--lift", options->liftMm,
          "You agree that the tool is lifted along Z by so much, mm, while that axis (X or "
          "Y) is held: a run may lift it only on a control that has been seen to")
      ->needs(move)
      ->check(CLI::Range(0.0, rivulet::templates::kLiftMmMax));
  command->add_option("--feed", options->feedMmPerMin, "Feed of --air-move, mm/min")
      ->needs(move)
      ->capture_default_str();
  addJson(command, options->json);
  command->callback([options, &exit] {
    if (!options->simulate && options->endpoint.empty() && !options->printProgram) {
      throw CLI::RequiredError("--endpoint or --simulate");
    }
    if (options->jobs && options->airMove.empty()) {
      throw CLI::RequiredError("--air-move, with --jobs,");
    }
    if (!options->airMove.empty() && !options->jobs && !options->feedCell) {
      throw CLI::RequiredError("--feed-cell or --jobs, with --air-move,");
    }
    if (options->jobs && (options->printProgram || options->transfer == "by-hand")) {
      throw CLI::ValidationError("--jobs", "Rivulet transfers the programs of this test itself.");
    }
    exit = rivulet::cli::commission(*options);
  });
}

using EmulatorOptionsPtr = std::shared_ptr<rivulet::cli::EmulatorOptions>;

void addPrograms(CLI::App* command, const EmulatorOptionsPtr& options) {
  command
      ->add_option("--program", options->programs,
                   "Program of each trace, if this has no set points (repeatable)")
      ->allow_extra_args(false);
  command
      ->add_option("--preset", options->preset,
                   "Virtual machine with the limits of the machine: a name or a file")
      ->capture_default_str();
}

void addKnown(CLI::App* command, const EmulatorOptionsPtr& options) {
  command->add_option("--emulator", options->emulator, "File of a learned emulator")->required();
}

void addStudy(CLI::App* command, const EmulatorOptionsPtr& options) {
  addPrograms(command, options);
  command->add_option("--lambda", options->lambda, "Weight of the speeds in the objective, s²")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--generations", options->generations, "Of the genetic algorithm")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Same seed, same result")->capture_default_str();
  command->add_option("--threads", options->threads, "0: one per core")->check(CLI::Range(0, 1024));
}

void addDesign(CLI::App* command, const EmulatorOptionsPtr& options) {
  addKnown(command, options);
  command->add_option("--box", options->box, "Least and greatest X, Y and perhaps Z, mm")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--feeds", options->feeds, "Least and greatest feed, mm/min")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "Duration of the program")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Same seed, same program")->capture_default_str();
  command->add_option("--output", options->output, "File for the program");
}

void addEmulatorCommand(CLI::App& app, Exit& exit) {
  using rivulet::cli::EmulatorOptions;
  CLI::App* emulator = app.add_subcommand(
      "emulator", "Learn how a machine follows its set points, and predict it (docs/emulator.md)");
  emulator->require_subcommand(1);
  const auto add = [&](const char* name, const char* what, Exit (*run)(const EmulatorOptions&),
                       bool readsTraces = true) {
    const auto options = std::make_shared<EmulatorOptions>();
    CLI::App* command = emulator->add_subcommand(name, what);
    if (readsTraces) {
      command->add_option("FILE", options->files, "Traces with set points and actual positions")
          ->required();
      command->add_option("--columns", options->columns,
                          "What the columns mean, as for analyse: x_set=NAME[:UNIT],...");
    }
    addJson(command, options->json);
    command->callback([options, run, &exit] { exit = run(*options); });
    return std::pair(command, options);
  };
  const auto [learn, learnOptions] =
      add("learn", "Find the parameters of each axis", rivulet::cli::learnEmulator);
  addPrograms(learn, learnOptions);
  learn->add_option("--output", learnOptions->output, "File for the emulator, .toml");
  const auto [test, testOptions] =
      add("test", "Say how far it is off on other runs", rivulet::cli::testEmulator);
  addKnown(test, testOptions);
  const auto [simulate, simulateOptions] =
      add("simulate", "Print what it answers to the set points of a run",
          rivulet::cli::simulateEmulator);
  addKnown(simulate, simulateOptions);
  simulate->add_option("--output", simulateOptions->output, "File, .csv");
  const auto [monitor, monitorOptions] =
      add("monitor", "Mark where a trace departs from what was expected",
          rivulet::cli::monitorEmulator);
  addKnown(monitor, monitorOptions);
  monitor
      ->add_option("--false-alarms", monitorOptions->falseAlarmsPerHour,
                   "Marks in an hour of a machine in good order")
      ->check(CLI::Range(1e-9, 1000.0))
      ->capture_default_str();
  const auto [design, designOptions] =
      add("design", "Propose the program that tells most about what is not known yet",
          rivulet::cli::designProgram, false);
  addDesign(design, designOptions);
  const auto [matrix, matrixOptions] =
      add("matrix", "Learn the emulator of [P2] from each run and test it on each",
          rivulet::cli::emulatorMatrix);
  addStudy(matrix, matrixOptions);
  const auto [importance, importanceOptions] =
      add("importance", "Say which of its parameters matter", rivulet::cli::emulatorImportance);
  addStudy(importance, importanceOptions);
}

void addPetriCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::PetriOptions>();
  CLI::App* petri = app.add_subcommand("petri", "Timed coloured Petri nets (docs/parallel.md)");
  petri->require_subcommand(1);
  const auto add = [&](const char* name, const char* text,
                       Exit (*run)(const rivulet::cli::PetriOptions&)) {
    CLI::App* command = petri->add_subcommand(name, text);
    command->add_option("NET", options->net, "Net: p3, or a .toml file")->capture_default_str();
    command->add_option("--set", options->settings, "NAME=NUMBER: parameter (repeatable)");
    command->callback([options, run, &exit] { exit = run(*options); });
    return command;
  };
  CLI::App* simulate = add("simulate", "Play a net", rivulet::cli::petriSimulate);
  simulate->add_option("--until", options->untilMs, "Simulated time, ms")
      ->check(kPositive)
      ->capture_default_str();
  simulate->add_option("--seed", options->seed, "Of several transitions draw one; 0: the first")
      ->capture_default_str();
  simulate->add_option("--recorded", options->recorded,
                       "File for the tokens of observer places, as CSV");
  addJson(simulate, options->json);
  CLI::App* analyse = add("analyse", "Bounds, deadlocks, transitions and invariants of a net",
                          rivulet::cli::petriAnalyse);
  analyse->add_option("--states", options->statesMax, "Most markings to look at")
      ->capture_default_str();
  addJson(analyse, options->json);
  CLI::App* write = add("export", "Write a net for other tools", rivulet::cli::petriExport);
  write->add_option("--pnml", options->pnml, "File, PNML");
  write->add_option("--graphviz", options->graphviz, "File, Graphviz");
  CLI::App* figure = petri->add_subcommand("figure13", "Repeat Figure 13 of [P3]");
  figure->add_option("--report", options->report, "Folder of parallel.md and its pictures");
  figure->callback([options, &exit] { exit = rivulet::cli::petriFigure13(*options); });
}

void addExperimentOutput(CLI::App& command, rivulet::cli::ExperimentCommandOptions& options) {
  command.add_option("--threads", options.threads, "0: one per core")->check(CLI::Range(0, 1024));
  command.add_option("--json", options.json, "File for all figures");
  command.add_option("--csv", options.csv, "File for all figures");
  command.add_option("--plot", options.plot, "File for the plot, .svg");
  command.add_option("--report", options.report, "Folder for the pages and their pictures");
}

void addMergeCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::ExperimentCommandOptions>();
  const auto parts = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("merge", "Put together the parts that experiment --shard has computed");
  command->add_option("FILE", *parts, "All parts, of one experiment or several")->required();
  addExperimentOutput(*command, *options);
  command->callback(
      [options, parts, &exit] { exit = rivulet::cli::mergeExperiments(*parts, *options); });
}

void addExperimentCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::ExperimentCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "experiment", "Repeat the experiments of the paper and compare the figures");
  std::vector<std::string> experiments = rivulet::papers::experimentNames();
  experiments.insert(experiments.end(),
                     {"lookahead", "emulator", "monitor", "design", "p2", "figure13", "all"});
  command->add_option("NAME", options->names, "Experiments, or all")
      ->required()
      ->check(CLI::IsMember(experiments));
  command->add_option("--seeds", options->seeds, "Runs per point (shots, contours)")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--preset", options->preset, "Virtual machine: a name or a file")
      ->capture_default_str();
  command->add_option("--endpoint", options->endpoint,
                      "OPC UA server instead of virtual time (table1, figure2)");
  command->add_option("--recordings", options->recordings,
                      "Recordings of another motion controller, for lookahead, emulator and p2");
  CLI::Option* part = command->add_option("--part", options->part, "File for the part");
  part->needs(command
                  ->add_option("--shard", options->shard,
                               "Only part K of N of one experiment, K/N, for command merge")
                  ->needs(part));
  addExperimentOutput(*command, *options);
  command->callback([options, &exit] {
    if (options->recordings.empty() &&
        std::ranges::any_of(options->names, [](const std::string& name) {
          return name == "lookahead" || name == "emulator" || name == "p2";
        })) {
      throw CLI::RequiredError("--recordings");
    }
    exit = rivulet::cli::experiment(*options);
  });
}

#ifdef RIVULET_WITH_OPEN62541

void addRightsCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::RightsOptions>();
  CLI::App* command = app.add_subcommand(
      "rights", "Say which rights a run needs, and which of them this user has on the control");
  command->add_option("--endpoint", options->endpoint, "OPC UA server")->required();
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::rights(*options); });
}

void addSurveyCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::SurveyOptions>();
  CLI::App* command = app.add_subcommand(
      "survey", "Read what a control is, has and costs, without writing anything to it");
  command->add_option("--endpoint", options->endpoint, "OPC UA server")->required();
  command->add_option("-o,--output", options->output, "File for the survey, as JSON");
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::survey(*options); });
}

void addMapCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::MapOptions>();
  CLI::App* command = app.add_subcommand(
      "map", "Propose a map of a server that is no SINUMERIK, and read what it names");
  command->add_option("--endpoint", options->endpoint, "OPC UA server")->required();
  command->add_option("-o,--output", options->output, "File for the map; else standard output");
  command->add_option("--max-nodes", options->nodesMax, "Look at no more nodes")
      ->capture_default_str();
  command->add_option("--max-depth", options->depthMax, "Levels below Objects")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--max-time", options->timeMaxS, "Browse no longer, in s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::map(*options); });
}

void addCertificateCommand(CLI::App& app, Exit& exit) {
  const auto options = std::make_shared<rivulet::cli::CertificateOptions>();
  CLI::App* command = app.add_subcommand(
      "certificate", "Show the certificate of this user and the servers that are trusted");
  command->add_flag("--renew", options->renew,
                    "Make a new one; every server has to accept it again");
  command->add_option("--export", options->exportFile,
                      "File for the certificate, as a control imports it (.der)");
  command->add_option("--forget", options->forget, "Address of a server that is trusted no longer");
  command->add_option("--revocation-list", options->revocationList,
                      "Take over a revocation list of an issuer (.crl): what it names is refused");
  addJson(command, options->json);
  command->callback([options, &exit] { exit = rivulet::cli::certificate(*options); });
}

/// How all commands connect; the names of the policies are those of the standard.
void addConnection(CLI::App& app, rivulet::cli::ConnectionOptions& options) {
  const CLI::Validator security(
      [](std::string& text) {
        return rivulet::opcua::securityChoiceOf(text)
                   ? std::string()
                   : "must be strongest, none, or a security policy of OPC UA, not " + text;
      },
      "SECURITY");
  app.add_option("--security", options.security,
                 "Protection of the connection, remembered for this server: strongest, none, or a "
                 "policy such as Basic256Sha256/Sign")
      ->check(security);
  app.add_option("--trust", options.fingerprint,
                 "Accept the server's certificate with this fingerprint (SHA-256)");
  auto* user = app.add_option("--user", options.user, "OPC UA user; without it, anonymous");
  auto* certificate = app.add_option("--user-certificate", options.userCertificate,
                                     "Log in by this certificate of a user instead, .pem or .der")
                          ->excludes(user);
  app.add_option("--user-key", options.userKey,
                 "File of mode 0600 with the key of --user-certificate; default: the same file")
      ->needs(certificate);
  app.add_option("--password-file", options.passwordFile,
                 "File of mode 0600 with the password; else RIVULET_PASSWORD, the systemd "
                 "credential rivulet-password, or the terminal");
  app.add_option("--map", options.mapFile,
                 "Map of a control that is no SINUMERIK, .toml: which node is what; command map "
                 "proposes one");
  app.add_option_function<std::string>(
         "--link",
         [&options](const std::string& name) {
           options.link = *rivulet::qtopcua::linkFromName(name);
         },
         "Library that makes the connection: open62541, or qtopcua where Rivulet was built with it "
         "(default: open62541)")
      ->check(CLI::Validator(
          [](std::string& text) {
            return rivulet::qtopcua::linkFromName(text)
                       ? std::string()
                       : "must be open62541 or qtopcua, not " + text;
          },
          "LINK"));
}

#endif

}  // namespace

int main(int argc, char** argv) {
  rivulet::output::guard();
  const std::vector<std::string> words = rivulet::platform::arguments(argc, argv);
  CLI::App app("Streams a tool path to a CNC machine over OPC UA while the machine moves.",
               "rivulet-cli");
  app.set_version_flag("--version", RIVULET_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  Exit exit = Exit::Done;
  std::string logLevel;
  app.add_option("--log-level", logLevel,
                 "What is logged on standard error (default: warning) and in the log file "
                 "(default: info)")
      ->check(CLI::IsMember(rivulet::log::levelNames()));
  constexpr std::uint64_t kMegabyte = 1'000'000;
  std::uint64_t memoryLimit = rivulet::base::Budget::kUsualBytes;
  app.add_option("--memory-limit", memoryLimit,
                 "Most memory that a file may take when it is read or expanded, such as 2GB "
                 "(default: 1GB)")
      ->transform(CLI::AsSizeValue(true))
      ->check(CLI::Range(kMegabyte, kMegabyte * kMegabyte));
  rivulet::cli::ConnectionOptions connection;
  app.parse_complete_callback([&] {
    rivulet::cli::setMemoryBudget(rivulet::base::Budget(memoryLimit));
    rivulet::cli::startLog(logLevel, words);
    rivulet::cli::setConnectionOptions(connection);
  });
  addCheckCommand(app, exit);
  addPointsCommand(app, exit);
  addFeasibilityCommand(app, exit);
  addTemplateCommand(app, exit);
  addStreamCommand(app, exit, words);
  addRaiseCommand(app, exit, words);
  addBackCommand(app, exit, words);
  addJobCommand(app, exit, words);
  addRunsCommand(app, exit);
  addAuditCommand(app, exit);
  addAnalyseCommand(app, exit);
  addCalibrateCommand(app, exit);
  addCommissionCommand(app, exit);
  addEmulatorCommand(app, exit);
  addExperimentCommand(app, exit);
  addMergeCommand(app, exit);
  addPetriCommand(app, exit);
#ifdef RIVULET_WITH_OPEN62541
  addRightsCommand(app, exit);
  addSurveyCommand(app, exit);
  addMapCommand(app, exit);
  addCertificateCommand(app, exit);
  addConnection(app, connection);
#endif

  try {
    rivulet::platform::parse(app, words);
  } catch (const CLI::ParseError& error) {
    // Help and version are successes; everything else is wrong usage.
    std::ostringstream help;
    exit = app.exit(error, help) == 0 ? Exit::Done : Exit::BadInput;
    fmt::print("{}", help.str());
  }
  if (const std::string lost = rivulet::output::failure(); !lost.empty()) {
    fmt::print(stderr, "rivulet-cli: {}\n", lost);  // there is no log behind --help
    exit = exit == Exit::Done ? Exit::Wrong : exit;
  }
  return static_cast<int>(exit);
}
