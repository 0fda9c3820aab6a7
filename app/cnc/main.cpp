// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-cnc`: an integrated parallel CNC in six tasks. Its functions are in core/pipeline and
/// beside this file, which has its options and what it prints.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "base/file.h"
#include "cnc/cnc_run.h"
#include "cnc/event_file.h"
#include "cnc/jitter.h"
#include "pipeline/conformance.h"
#include "pipeline/ring.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "platform/output.h"

namespace {

using namespace rivulet;

constexpr int kExitOk = 0;
constexpr int kExitFailed = 1;
constexpr int kExitUsage = 2;
constexpr double kUsPerNs = 1e-3;
/// Of SCHED_FIFO: above the threads of the kernel's interrupts.
constexpr int kPriority = 80;

int complain(const base::Error& error, int code) {
  log::logger().error(error.text());
  return code;
}

void say(const std::string& text) {
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

struct Arguments {
  cnc::RunOptions run;
  std::string policy = "task-dependency";
  double cycleMs = 4.0;
  bool listens = false;
  bool realTime = false;
  std::string trace;
  std::string events;
  bool live = false;
  double seconds = 10.0;
  bool load = false;
  std::string eventFile;
  std::string segment;
  int task = 0;
};

void addRunOptions(CLI::App& command, Arguments& arguments) {
  std::vector<std::string> names;
  for (const pipeline::PolicyFacts& facts : pipeline::policies()) {
    names.emplace_back(facts.name);
  }
  command.add_option("--machine", arguments.run.preset, "A built-in preset or a TOML file")
      ->capture_default_str();
  command.add_option("--policy", arguments.policy, "Who gets a processor")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command.add_option("--cycle", arguments.cycleMs, "Of position control, ms")
      ->check(CLI::Range(1.0, 15.0))
      ->capture_default_str();
  command.add_option("--processors", arguments.run.dispatch.processors, "Tasks that run at a time")
      ->check(CLI::Range(1, static_cast<int>(pipeline::kTaskCount)))
      ->capture_default_str();
  command.add_option("--capacity", arguments.run.dispatch.capacity, "Places of each ring buffer")
      ->check(CLI::Range(1, static_cast<int>(pipeline::kRingCapacity)))
      ->capture_default_str();
  command.add_flag("--processes", arguments.run.inProcesses,
                   "Each task in a process of its own, with the ring buffers in shared memory");
  command.add_flag("--real-time", arguments.realTime,
                   "SCHED_FIFO and locked memory for position control, where the system allows it");
  command.add_option("--core", arguments.run.core, "Processor core of position control");
}

/// What the options of a run mean together.
void complete(Arguments& arguments) {
  for (const pipeline::PolicyFacts& facts : pipeline::policies()) {
    if (facts.name == arguments.policy) {
      arguments.run.policy = facts.kind;
    }
  }
  arguments.run.dispatch.positionCycle = base::fromMilliseconds(arguments.cycleMs);
  arguments.run.priority = arguments.realTime ? kPriority : 0;
  arguments.run.say = &say;
}

double usOf(base::Duration time) {
  return static_cast<double>(time.count()) * kUsPerNs;
}

/// TREC of all tasks.
void printRecords(const cnc::RunResult& result) {
  fmt::print("{:<17} {:>8} {:>10} {:>10} {:>9} {:>9} {:>9} {:>8} {:>8}\n", "task", "steps",
             "data ms", "turn ms", "avg us", "min us", "max us", "preempt", "switch");
  for (std::size_t i = 0; i < pipeline::kTaskCount; ++i) {
    const pipeline::TaskRecord& record = result.records[i];
    fmt::print("{:<17} {:>8} {:>10.1f} {:>10.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>8} {:>8}\n",
               pipeline::kTaskNames[i], record.count, base::toMilliseconds(record.waitedData),
               base::toMilliseconds(record.waitedTurn), usOf(record.responseMean()),
               usOf(record.responseMin), usOf(record.responseMax), record.preemptions,
               record.switches);
  }
}

int run(Arguments& arguments) {
  complete(arguments);
  if (arguments.run.program.empty() != arguments.listens) {
    log::logger().error("Name a program, or let it come over TCP with --listen; not both.");
    return kExitUsage;
  }
  if (arguments.live) {
    arguments.run.say = nullptr;
    const std::string head = cnc::printEventHead(arguments.run.policy, arguments.run.dispatch);
    std::fputs(head.c_str(), stdout);
    arguments.run.watch = [](std::span<const pipeline::Event> events) {
      std::fputs(cnc::printEventLines(events).c_str(), stdout);
      std::fflush(stdout);
    };
  }
  auto result = cnc::runCnc(arguments.run, interrupt::flag());
  if (!result) {
    return complain(result.error(), kExitUsage);
  }
  if (!arguments.trace.empty()) {
    if (auto written = base::writeFile(arguments.trace, trace::printControlTrace(result->trace));
        !written) {
      return complain(written.error(), kExitFailed);
    }
  }
  if (!arguments.events.empty()) {
    const std::string text =
        cnc::printEvents({arguments.run.policy, arguments.run.dispatch, std::move(result->events)});
    if (auto written = base::writeFile(arguments.events, text); !written) {
      return complain(written.error(), kExitFailed);
    }
  }
  if (!arguments.live) {
    fmt::print("{} set points in {:.3f} s\n", result->trace.samples.size(),
               base::toSeconds(result->duration));
    printRecords(*result);
  }
  if (!result->failure.empty()) {
    log::logger().error(result->failure);
    return kExitFailed;
  }
  if (!result->hasEnded) {
    log::logger().error("The run was stopped before the end of the program. Start it again.");
    return kExitFailed;
  }
  return kExitOk;
}

void printDistribution(const char* what, const cnc::Distribution& times) {
  fmt::print("{:<28} {:>8} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f}\n", what,
             times.count, times.min, times.mean, times.p50, times.p99, times.p999, times.max,
             times.spread());
}

int jitter(Arguments& arguments) {
  complete(arguments);
  arguments.run.priority = kPriority;
  cnc::JitterOptions options;
  options.run = arguments.run;
  options.duration = base::fromSeconds(arguments.seconds);
  options.withLoad = arguments.load;
  const auto measured = cnc::measureJitter(options, interrupt::flag());
  if (!measured) {
    return complain(measured.error(), kExitUsage);
  }
  fmt::print("{:<28} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "us", "count", "min",
             "mean", "50 %", "99 %", "99.9 %", "max", "spread");
  printDistribution("position control, wake-up", measured->wakeUp);
  if (measured->cyclictest) {
    printDistribution("cyclictest, wake-up", *measured->cyclictest);
  }
  printDistribution("set points, cycle deviation", measured->cycle);
  fmt::print("set points a cycle late or more: {}\n", measured->missed);
  for (const std::string& remark : measured->remarks) {
    fmt::print("{}\n", remark);
  }
  if (!measured->run.failure.empty()) {
    log::logger().error(measured->run.failure);
    return kExitFailed;
  }
  return kExitOk;
}

int conformance(const Arguments& arguments) {
  const auto text = base::readFile(arguments.eventFile);
  if (!text) {
    return complain(text.error(), kExitUsage);
  }
  const auto recording = cnc::parseEvents(*text);
  if (!recording) {
    return complain(recording.error(), kExitUsage);
  }
  const auto result =
      pipeline::checkConformance(recording->events, recording->policy, recording->dispatch);
  if (!result) {
    return complain(result.error(), kExitUsage);
  }
  if (result->violation) {
    log::logger().error(*result->violation);
    return kExitFailed;
  }
  fmt::print("The net of [P3] allows all {} events.\n", result->events);
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  rivulet::output::guard();
  interrupt::watch();
  Arguments arguments;
  arguments.run.preset = machine::kDefaultPreset;
  CLI::App app{
      "A CNC in six tasks with ring buffers between them, scheduled by policy: G code receiving, "
      "interpreter, discrete, forward-looking, interpolation, position control. It moves the axes "
      "of a virtual machine, never real ones."};
  app.set_version_flag("--version", "rivulet-cnc " RIVULET_VERSION);
  app.require_subcommand(1);

  CLI::App& runCommand = *app.add_subcommand("run", "Execute a program");
  runCommand.add_option("program", arguments.run.program, "NC program (SINUMERIK)");
  runCommand.add_flag("--listen", arguments.listens,
                      "Take the program from a TCP connection of this computer; its end is the "
                      "end of the program");
  runCommand
      .add_option("--port", arguments.run.port, "Of --listen; 0: any free port, which is printed")
      ->capture_default_str();
  addRunOptions(runCommand, arguments);
  runCommand.add_option("--trace", arguments.trace,
                        "File for the set points and positions of the axes, cycle by cycle");
  runCommand.add_option("--events", arguments.events, "File for the events of the scheduler");

  runCommand.add_flag("--live", arguments.live,
                      "Print the events of the scheduler while it runs, and nothing else");

  CLI::App& jitterCommand =
      *app.add_subcommand("jitter", "Measure the cycle of position control beside cyclictest");
  addRunOptions(jitterCommand, arguments);
  jitterCommand.add_option("--seconds", arguments.seconds, "How long")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  jitterCommand.add_flag("--load", arguments.load, "With stress-ng on all cores");

  CLI::App& conformanceCommand = *app.add_subcommand(
      "conformance", "Replay recorded events against the Petri net of the scheduler");
  conformanceCommand.add_option("events", arguments.eventFile, "File of --events")->required();

  CLI::App& taskCommand = *app.add_subcommand("task", "One task; started by run --processes");
  taskCommand.group("");  // not in the help
  taskCommand.add_option("segment", arguments.segment)->required();
  taskCommand.add_option("task", arguments.task)->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  if (taskCommand.parsed()) {
    return cnc::runTaskProcess(arguments.segment, arguments.task);
  }
  static_cast<void>(log::setUp({"rivulet-cnc", {}, {}}));
  if (jitterCommand.parsed()) {
    return jitter(arguments);
  }
  return conformanceCommand.parsed() ? conformance(arguments) : run(arguments);
}
