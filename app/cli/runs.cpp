// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console_orders.h"
#include "cli/found_run.h"
#include "opcua/await.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "report/report_json.h"
#include "report/run_store.h"

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::chrono::milliseconds kWatchInterval{500};

ordered_json originJson(const streaming::RunOrigin& origin) {
  return {{"user", origin.user}, {"computer", origin.computer}, {"at_utc", origin.startedAtUtc}};
}

ordered_json savedJson(const report::SavedRun& run) {
  return {{"run_number", run.number()},
          {"program", run.programName},
          {"job", run.job ? run.job->number : 0},
          {"points", run.checkpoint.pointCount},
          {"endpoint", run.endpoint},
          {"started_by", originJson(run.settings.origin)},
          {"file", run.file.string()},
          {"resume", resumeCommand(run, run.file)}};
}

ordered_json foundJson(const report::FoundRun& run) {
  ordered_json json{{"run_number", run.onControl.number},
                    {"flexible_program", run.onControl.programName},
                    {"base_cell", run.onControl.baseCell},
                    {"windows_delivered", run.onControl.delivered},
                    {"job", run.onControl.job},
                    {"stretch", run.onControl.stretch},
                    {"is_native", run.onControl.isNative},
                    {"windows_latched", run.onControl.latched},
                    {"windows_executed", run.onControl.executed},
                    {"has_client", run.onControl.hasClient},
                    {"can_resume", run.canResume()}};
  if (run.onControl.origin) {
    json["started_by"] = originJson(*run.onControl.origin);
  }
  if (run.saved) {
    json["saved_run"] = savedJson(*run.saved);
  }
  return json;
}

/// Shows how far the run is until it ends, or until Ctrl-C.
Exit watch(const report::RunStore& store, const Connection& connection,
           const RunsOptions& options) {
  std::optional<std::size_t> shown;
  std::vector<std::size_t> ends;
  int number = 0;
  while (!interrupt::wasSeen()) {
    const auto found = report::findRun(store, *connection.link, *connection.control,
                                       options.baseCell, base::Duration{0});
    if (!found) {
      return reportError(found.error(), options.json);
    }
    if (!*found) {
      fmt::print("{}\n",
                 shown ? "The run has ended." : "There is no run and no whole job on the control.");
      return Exit::Done;
    }
    const report::FoundRun& run = **found;
    if (!shown || run.onControl.number != number) {
      number = run.onControl.number;
      ends = run.saved ? report::pointsAfterWindows(store, *run.saved) : std::vector<std::size_t>();
      shown.reset();
      fmt::print("{}\n", report::describeRun(run));
    }
    const std::size_t executed = run.onControl.executed;
    if (shown != executed) {
      shown = executed;
      fmt::print("{} windows executed", executed);
      if (executed < ends.size()) {
        fmt::print(", {} of {} points", ends[executed], ends.back());
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
    std::this_thread::sleep_for(kWatchInterval);
  }
  return Exit::Done;
}

Exit nothingStopped(const RunsOptions& options) {
  return reportError(
      base::makeError(streaming::StreamError::CannotResume,
                      "No run and no whole job of Rivulet is on this control: nothing was "
                      "stopped. If it executes another program, stop it at the control."),
      options.json);
}

/// Whatever else the control executes.
Exit stopAnother(const Connection& connection, const RunsOptions& options) {
  const opcua::Variable status{opcua::VariableKind::ChannelStatus, 0};
  const auto seen = opcua::readNumbers(*connection.link, {&status, 1}, streaming::kSetupDeadline);
  if (!seen) {
    return reportError(seen.error(), options.json);
  }
  if (seen->front() == opcua::kChannelReset) {
    return nothingStopped(options);
  }
  const auto stopped = streaming::stopByReset(*connection.link, *connection.control,
                                              [] { return !interrupt::wasSeen(); });
  if (!stopped) {
    return reportError(stopped.error(), options.json);
  }
  if (options.json) {
    printJson({{"stopped", nullptr}, {"was_reset", true}});
  } else {
    fmt::print("The control was reset, and its program has ended.\n");
  }
  return Exit::Done;
}

/// Holds the axes of the run at once. It goes on only to its end, and with `end`.
Exit stop(const Connection& connection, const report::FoundRun& run, const RunsOptions& options) {
  bool isTold = false;
  const auto goesOn = [&isTold] {
    if (!std::exchange(isTold, true)) {
      log::logger().error(
          "The axes still move: what moves now does not obey the override. Stop it at the control. "
          "The program ends before its next window.");
    }
    return !interrupt::wasSeen();
  };
  const auto stopped = streaming::stopRun(*connection.link, run.onControl, {}, goesOn);
  if (!stopped) {
    return reportError(stopped.error(), options.json);
  }
  if (options.json) {
    ordered_json json{{"stopped", foundJson(run)}, {"has_ended", stopped->hasEnded}};
    json["stood_after_s"] = stopped->stoodAfter
                                ? ordered_json(base::toSeconds(*stopped->stoodAfter))
                                : ordered_json(nullptr);
    printJson(json);
  } else if (stopped->stoodAfter) {
    fmt::print("Held: {}. The axes stand, {:.3f} s after the order.\n{}\n",
               report::describeRun(run), base::toSeconds(*stopped->stoodAfter),
               leftHeldText(connection.name));
  } else {
    fmt::print("Stopped: {}. It has ended.\n", report::describeRun(run));
    if (run.saved) {
      fmt::print("To go on: {}\n", resumeCommand(*run.saved, run.saved->file));
    }
  }
  return Exit::Done;
}

Exit end(const Connection& connection, const report::FoundRun& run, const RunsOptions& options) {
  const auto goesOn = [] { return !interrupt::wasSeen(); };
  if (const auto ended = streaming::endRun(*connection.link, run.onControl, {}, goesOn); !ended) {
    return reportError(ended.error(), options.json);
  }
  if (options.json) {
    printJson({{"ended", foundJson(run)}});
  } else {
    fmt::print("Ended: {}. It executed {}.\n", report::describeRun(run),
               run.onControl.isNative ? "the block of the control that it was in"
                                      : "the windows that it had copied");
    if (run.saved) {
      fmt::print("To go on: {}\n", resumeCommand(*run.saved, run.saved->file));
    }
  }
  return Exit::Done;
}

/// Of a whole job that is kept; what was executed since is asked of the control when it goes on.
std::string howFar(const report::SavedRun& run) {
  if (run.isUntouched()) {
    return "nothing of it executed";
  }
  return run.checkpoint.pointCount == 0
             ? "in the blocks of the control before its next stretch"
             : fmt::format("in a stretch of {} points, or the blocks after it",
                           run.checkpoint.pointCount);
}

void printList(const std::vector<report::SavedRun>& runs) {
  if (runs.empty()) {
    fmt::print("No run of this computer is left to be resumed.\n");
  }
  for (const report::SavedRun& run : runs) {
    const streaming::RunOrigin& origin = run.settings.origin;
    fmt::print("{} {}: {}, {}, {}\n  started by {} on {} at {}\n  resume: {}\n",
               run.job ? "whole job" : "run", run.number(), run.programName,
               run.job ? howFar(run) : fmt::format("{} points", run.checkpoint.pointCount),
               run.endpoint, origin.user, origin.computer, origin.startedAtUtc,
               resumeCommand(run, run.file));
  }
}

}  // namespace

Exit runs(const RunsOptions& options) {
  interrupt::watch();
  const report::RunStore store;
  const report::RunStore jobs(report::RunStore::folderOfJobs());
  if (options.forget != 0) {
    const auto run = store.find(options.forget);
    const auto job = run ? run : jobs.find(options.forget);
    if (!job) {
      return reportError(base::makeError(streaming::StreamError::CannotResume,
                                         "No run of this number is kept. See rivulet-cli runs."),
                         options.json);
    }
    (run ? store : jobs).remove(*job);
  }
  ordered_json json{{"runs", ordered_json::array()}};
  std::vector<report::SavedRun> kept = store.runs();
  std::ranges::move(jobs.runs(), std::back_inserter(kept));
  for (const report::SavedRun& run : kept) {
    json["runs"].push_back(savedJson(run));
  }
  if (options.endpoint.empty()) {
    options.json ? printJson(json) : printList(kept);
    return Exit::Done;
  }
  const auto connection = connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  if (options.watch) {
    return watch(store, *connection, options);
  }
  const auto found =
      report::findRun(store, *connection->link, *connection->control, options.baseCell);
  if (!found) {
    return reportError(found.error(), options.json);
  }
  if ((options.stop || options.end) && *found) {
    return options.stop ? stop(*connection, **found, options) : end(*connection, **found, options);
  }
  if (options.stop || options.end) {
    return options.stop ? stopAnother(*connection, options) : nothingStopped(options);
  }
  json["on_control"] = *found ? foundJson(**found) : ordered_json(nullptr);
  if (options.json) {
    printJson(json);
  } else {
    printList(kept);
    fmt::print("{}\n", *found ? adviceFor(**found, connection->name)
                              : std::string("There is no run and no whole job on the control."));
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
