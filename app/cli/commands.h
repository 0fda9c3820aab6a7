// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The commands of rivulet-cli. Each takes its parsed options and returns the exit code.
/// @threadsafety main thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "cli/console.h"
#include "gcode/program.h"
#include "job/plan.h"
#include "live/feed_factor.h"
#include "live/setup.h"
#include "machine/config.h"

namespace rivulet::cli {

/// How NC programs are read, the same for every command.
struct LoadingOptions {
  double chordToleranceMm = 0.005;
  std::string dialect = "auto";
  std::vector<std::string> accepted;
  bool blockSkip = false;
  std::string centres = "as-programmed";
  std::string units = "auto";
  std::string noPoint = "auto";
  std::string settings;

  [[nodiscard]] gcode::LoadOptions loadOptions() const;
};

/// What a command that moves a machine has to be told before it reads the program.
/// @param isForControl  the result is for a real control, whose settings decide what is left open
/// @return error Ambiguous, with the options that answer it
[[nodiscard]] base::Result<void> requireMeaning(const gcode::Program& program, bool isForControl);

/// What a whole job may take for granted. @param isVirtualAlone  it is made for a virtual machine
/// that is set up for it, and for nothing else
[[nodiscard]] job::Profile jobProfile(const std::string& endpoint, bool isVirtualAlone);

/// Fewer or more points on the same path.
struct ResamplingOptions {
  double toleranceMm = 0.0;  ///< 0: all points
  double splitMm = 0.0;      ///< 0: not

  /// Prints on standard error what was left out.
  /// @param onSteps  the points that stay are going to be packed
  /// @return error BudgetError::Exceeded, GcodeError::BadTolerance
  [[nodiscard]] base::Result<void> resample(gcode::Program& program, bool onSteps = false) const;
  [[nodiscard]] base::Result<void> split(gcode::Program& program) const;
};

/// How many points are left of those of the program, if a tolerance was given.
void tellMerged(const gcode::Program& program);

struct CheckOptions {
  std::vector<std::string> files;  ///< or folders
  LoadingOptions loading;
  bool asJob = false;  ///< says what `job` would say, and returns its exit code
  bool json = false;
};
[[nodiscard]] Exit check(const CheckOptions& options);

struct PointsOptions {
  std::string file;
  LoadingOptions loading;
  ResamplingOptions resampling;
  std::string output;  ///< file; empty: standard output
  bool keepArcs = false;
};
[[nodiscard]] Exit points(const PointsOptions& options);

struct FeasibilityOptions {
  OperatingOptions point;
  std::string program;  ///< file; empty: none
  LoadingOptions loading;
  ResamplingOptions resampling;
  std::optional<double> pointDistanceMm;  ///< d_min if no program is given
  double accessTimeMs = 4.3;
  std::string calibration;  ///< file of `calibrate` to be used instead; empty: none
  std::string endpoint;     ///< machine whose calibration is used instead; empty: none
  double deltaSafety = 1.5;
  std::string preset =
      machine::kDefaultPreset;  ///< machine whose axes determine the cost of pauses
  bool json = false;
};
[[nodiscard]] Exit feasibility(const FeasibilityOptions& options);

struct TemplateOptions {
  OperatingOptions point;
  int rParameterCount = 100;
  std::string output;  ///< file; empty: standard output
  std::string lint;    ///< program to be checked instead of generating one; empty: none
  bool verify = false;
  std::string preset = machine::kDefaultPreset;  ///< machine of `verify`
  bool json = false;
};
[[nodiscard]] Exit makeTemplate(const TemplateOptions& options);

struct FactorOptions {
  std::string source;  ///< see `sources::openSource`; empty: none
  double silenceS = base::toSeconds(live::FactorSource{}.silence);
  std::string inSilence = "hold";  ///< hold, override

  [[nodiscard]] live::FactorSource agreed() const {
    return {source, base::fromSeconds(silenceS), inSilence == "hold"};
  }
};

/// A source of points that arrive while the machine moves, and what is agreed with it.
struct LiveOptions {
  std::string source;         ///< see `sources::openSource`; empty: a program is streamed
  std::vector<double> boxMm;  ///< least and largest X, Y, Z
  live::Agreement agreed;     ///< without the box
  double fullWithinMs = base::toMilliseconds(live::Limits{}.fullWithin);
  double holdAfterS = base::toSeconds(live::Limits{}.holdAfter);
  double endAfterS = base::toSeconds(live::Limits{}.endAfter);
  FactorOptions factor;  ///< another source, beside points or a program
};

/// Who has a say in a run, and who is told how far it is.
struct OrderOptions {
  std::string source;    ///< of hold and override; empty: keys on a terminal
  bool endsRun = false;  ///< the end of the source is a stop: whoever gives the orders has gone
  std::string progress;  ///< file or pipe for `ProgressLines`; empty: none
};

/// A run that was left is driven back along its path.
struct BackOptions {
  std::string run;           ///< its file
  std::optional<double> mm;  ///< nothing: to where the last rapid ended
};

/// The tool is moved, and nothing of a program; one of both, or neither.
struct ToolOptions {
  std::optional<double> raiseToMm;  ///< to this Z; there is no program then
  std::optional<BackOptions> back;  ///< the program is that of the run which is driven back
};

struct StreamOptions {
  OperatingOptions point;
  std::string file;
  LoadingOptions loading;
  ResamplingOptions resampling;
  std::string endpoint;
  bool simulate = false;
  std::string preset = machine::kDefaultPreset;
  std::uint64_t seed = 1;
  std::string record;
  double stopAfterS = 0.0;            ///< 0: not
  std::string resume;                 ///< report of an earlier run; empty: from the beginning
  std::string access = "auto";        ///< auto, single, list, array
  std::string passedBy = "position";  ///< position, distance-to-go
  std::string transfer = "auto";      ///< auto, by-hand
  std::string programFile;            ///< by-hand: where the program is written; empty: its name
  std::string correct;                ///< source of corrections, - is standard input; empty: none
  OrderOptions orders;
  bool noMonitor = false;
  bool evenPauses = false;
  /// On a real control.
  struct Accepted {
    bool infeasible = false;
    bool repeats = false;  ///< methods position and signal may execute old points again
  };
  Accepted accepted;
  bool acceptChanges = false;  ///< the program differs where nothing has been executed
  bool straight = false;       ///< the first move may pass within what the program cuts
  ToolOptions tool;
  std::vector<std::string> command;  ///< the words of the command line
  bool json = false;
  LiveOptions live;
  bool namesMachine = false;  ///< `preset` was given
  bool fromStart = false;     ///< see `JobOptions`
  bool motionOnly = false;    ///< leaves out what the control executes itself
  std::string motionOption;   ///< one that was given and is for the motion alone; empty: none
};
[[nodiscard]] Exit stream(const StreamOptions& options);
/// The same with points of a live source.
[[nodiscard]] Exit streamLive(const StreamOptions& options);

struct JobOptions {
  OperatingOptions point;
  std::string file;
  LoadingOptions loading;
  std::string output;    ///< folder for the files of the job; empty: none are written
  std::string endpoint;  ///< empty: the job is not run, unless `simulate`
  bool simulate = false;
  bool verify = false;  ///< compares the job with its source, on a virtual machine
  std::string preset = "dmu75-mill";
  bool namesMachine = false;  ///< else one that is large enough takes the place of the preset
  std::uint64_t seed = 1;
  double stopAfterS = 0.0;  ///< 0: not
  OrderOptions orders;
  FactorOptions factor;
  std::string record;                  ///< file; empty: none
  bool noMonitor = false;              ///< no reads for the display within stretches
  std::string resume;                  ///< file of a job that was left; empty: from the beginning
  int fromStretch = 0;                 ///< 0: from the beginning
  bool fromStart = false;              ///< although a job was left on this control
  double dryRunMm = 0.0;               ///< > 0: a dry run, so much higher
  std::vector<std::string> functions;  ///< M functions of another machine, see --m
  bool straight = false;               ///< the first move may pass within what the program cuts
  bool confirmed = false;              ///< what is done before a job goes on has been checked
  std::vector<std::string> command;    ///< the words of the command line
  bool json = false;
};
/// Writes the files of a whole job, or runs it on a virtual machine.
[[nodiscard]] Exit job(const JobOptions& options);
/// Everything that `job --simulate` looks at before anything moves. @return what it would refuse
[[nodiscard]] base::Result<void> tryJob(const std::string& file, const LoadingOptions& loading);

struct RunsOptions {
  std::string endpoint;  ///< control that is asked, too; empty: none
  int baseCell = 0;      ///< of a program whose name does not say it
  bool watch = false;
  bool stop = false;  ///< holds the axes, and the program is to end
  bool end = false;   ///< lets it go on to its end
  int forget = 0;     ///< number of a run that is not kept any longer; 0: none
  bool json = false;
};
/// Lists the runs that can be resumed; watches or stops the one on a control.
[[nodiscard]] Exit runs(const RunsOptions& options);

struct AuditOptions {
  std::string file;     ///< audit trail; empty: the user's
  bool verify = false;  ///< findings instead of lines
  bool json = false;    ///< both
};
/// Prints an audit trail, and whether it was changed.
[[nodiscard]] Exit audit(const AuditOptions& options);

struct AnalyseOptions {
  /// Recordings, traces of the control, or of other tools; addresses of MTConnect
  /// agents, or of OPC UA servers with a history.
  std::vector<std::string> files;
  std::string program;  ///< what should have been executed; empty: not known
  LoadingOptions loading;
  std::string columns;       ///< `trace::parseTableMapping`; empty: as remembered, or guessed
  double rateHz = 0.0;       ///< of a table without time; 0: not said
  double toleranceMm = 0.0;  ///< of the path; 0: the usual one
  double fromS = 0.0;        ///< only what happens from then on, from the first sample
  double untilS = std::numeric_limits<double>::infinity();  ///< and until then
  bool overview = false;                ///< only what the index of a recording says
  bool summary = false;                 ///< one table of all files
  bool csv = false;                     ///< the summary as CSV
  std::string trend;                    ///< HTML, SVG or JSON file; empty: none
  std::string compare;                  ///< "time", "path", "point"; empty: files are not compared
  std::vector<std::string> signalList;  ///< formulas to compare; empty: the usual ones
  std::string failIf;                   ///< rule; empty: none
  std::string report;                   ///< PDF or HTML file for a page on one trace; empty: none
  std::string language = "en";          ///< of the report and the trend
  std::string save;                     ///< CSV or HDF5 file for the signals of one trace; or empty
  double recordS = 0.0;                 ///< from an agent, after what it has kept
  std::string keep;                     ///< file for the answers of an agent; empty: none
  std::vector<std::string> nodes;       ///< of an OPC UA server: `trace_fetch::parseHistoryNode`
  std::string since;                    ///< of its history, UTC: `base::utcOfText`
  std::string to;                       ///< the same, later
  bool json = false;

  [[nodiscard]] bool hasWindow() const { return fromS > 0.0 || std::isfinite(untilS); }
};
/// What recordings hold, without reading them as a whole.
[[nodiscard]] Exit overview(const AnalyseOptions& options);
/// Says how the other files differ from the first one.
[[nodiscard]] Exit compare(const AnalyseOptions& options);
/// Judges what a recording or trace shows.
[[nodiscard]] Exit analyse(const AnalyseOptions& options);

struct CalibrateOptions {
  std::string endpoint;
  bool simulate = false;
  std::string preset = machine::kDefaultPreset;
  std::uint64_t seed = 1;
  int firstCell = 0;
  int lastCell = 0;
  int shots = 500;
  double budgetS = 900.0;  ///< 0: no limit
  bool confirmed = false;  ///< the cells of a real control may be written
  bool noArrays = false;
  std::string output;
  bool json = false;
};
[[nodiscard]] Exit calibrate(const CalibrateOptions& options);

struct CommissionOptions {
  std::string endpoint;
  bool simulate = false;
  std::string preset = machine::kDefaultPreset;
  std::uint64_t seed = 1;
  int baseCell = 0;
  std::string transfer = "auto";  ///< auto, by-hand
  bool printProgram = false;
  bool feedCell = false;            ///< the test of the feed cell
  bool jobs = false;                ///< the test of whole jobs; neither: of method credit
  std::vector<std::string> blocks;  ///< to be tried by the test of whole jobs
  std::string airMove;              ///< "X20": the move that the operator agrees to; empty: none
  double liftMm = 0.0;              ///< of the tool while that move is held; 0: none
  double feedMmPerMin = 400.0;      ///< of this move
  bool json = false;
};
/// Tests whether method credit may run on this machine, or its feed cell; the result is stored.
[[nodiscard]] Exit commission(const CommissionOptions& options);

struct EmulatorOptions {
  std::vector<std::string> files;  ///< recordings, traces of the control, or of other tools
  std::string columns;             ///< `trace::parseTableMapping`; empty: as remembered, or guessed
  std::string emulator;            ///< file of one that was learned
  std::string output;              ///< file for the emulator, or for what it answers
  std::string preset = machine::kDefaultPreset;  ///< has what the emulator's file does not say
  double falseAlarmsPerHour = 0.1;               ///< of the monitor, for a machine in good order
  /// One for each file, whose own set points are not used then.
  std::vector<std::string> programs;
  double lambda = 0.0;  ///< weight of the speeds in the objective of [P2], s²
  int generations = 100;
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: one per core
  /// Of a proposed program: least and greatest X, Y and perhaps Z, mm.
  std::vector<double> box{0.0, 60.0, 0.0, 60.0};
  std::vector<double> feeds{60.0, 3000.0};  ///< least and greatest, mm/min
  double seconds = 25.0;                    ///< its duration
  bool json = false;
};
/// Learns an emulator of a machine from set points and actual positions.
[[nodiscard]] Exit learnEmulator(const EmulatorOptions& options);
/// Says how far an emulator is off on other runs.
[[nodiscard]] Exit testEmulator(const EmulatorOptions& options);
/// Prints what an emulator answers to the set points of a run.
[[nodiscard]] Exit simulateEmulator(const EmulatorOptions& options);
/// Proposes the program that tells most about what is not known yet.
[[nodiscard]] Exit designProgram(const EmulatorOptions& options);
/// The emulator of [P2], learned from each run and tested on each.
[[nodiscard]] Exit emulatorMatrix(const EmulatorOptions& options);
/// How much each parameter of the emulator of [P2] says about its objective.
[[nodiscard]] Exit emulatorImportance(const EmulatorOptions& options);
/// Marks where traces depart from what an emulator expects. @return Wrong if one does
[[nodiscard]] Exit monitorEmulator(const EmulatorOptions& options);

struct SurveyOptions {
  std::string endpoint;
  std::string output;  ///< file; empty: none
  bool json = false;
};
/// Reads what a control is and what access to it costs. Writes nothing to it.
[[nodiscard]] Exit survey(const SurveyOptions& options);

struct RightsOptions {
  std::string endpoint;
  bool json = false;
};
/// Says which rights a run needs and this user has. Wrong if one is missing that every run needs.
[[nodiscard]] Exit rights(const RightsOptions& options);

struct MapOptions {
  std::string endpoint;
  std::string output;  ///< empty: standard output
  std::size_t nodesMax = 20'000;
  int depthMax = 8;
  double timeMaxS = 60.0;
  bool json = false;
};
/// Asks only, writes nothing on the server.
[[nodiscard]] Exit map(const MapOptions& options);

struct CertificateOptions {
  bool renew = false;
  std::string exportFile;      ///< empty: none
  std::string forget;          ///< endpoint of a server that is not trusted any longer; empty: none
  std::string revocationList;  ///< file of a list that is taken over; empty: none
  bool json = false;
};
/// Shows the certificate of this user and the servers that are trusted.
[[nodiscard]] Exit certificate(const CertificateOptions& options);

struct ExperimentCommandOptions {
  std::vector<std::string> names;  ///< or "all"
  std::size_t seeds = 0;           ///< 0: the usual number
  std::string preset = machine::kDefaultPreset;
  std::string endpoint;    ///< empty: virtual time
  std::string recordings;  ///< folder for experiments lookahead, emulator and p2
  unsigned threads = 0;    ///< 0: one per core
  std::string json;
  std::string csv;
  std::string plot;
  std::string report;  ///< folder for experiments.html, fidelity.md and emulator-p2.md
  std::string shard;   ///< "2/8": only this part of one experiment; empty: all
  std::string part;    ///< file for it
};
[[nodiscard]] Exit experiment(const ExperimentCommandOptions& options);
/// Puts the parts of experiments together. @param parts  files
[[nodiscard]] Exit mergeExperiments(const std::vector<std::string>& parts,
                                    const ExperimentCommandOptions& options);

struct PetriOptions {
  std::string net = "p3";             ///< a net that comes with Rivulet, or a .toml file
  std::vector<std::string> settings;  ///< NAME=NUMBER, parameters of the net
  double untilMs = 1000.0;
  std::uint64_t seed = 0;  ///< 0: the first of several transitions fires
  std::string recorded;    ///< file for the tokens of observer places
  std::size_t statesMax = 2'000'000;
  std::string pnml;
  std::string graphviz;
  std::string report;  ///< folder of parallel.md
  bool json = false;
};
[[nodiscard]] Exit petriSimulate(const PetriOptions& options);
[[nodiscard]] Exit petriAnalyse(const PetriOptions& options);
[[nodiscard]] Exit petriExport(const PetriOptions& options);
[[nodiscard]] Exit petriFigure13(const PetriOptions& options);

}  // namespace rivulet::cli
