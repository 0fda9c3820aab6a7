// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "base/units.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "platform/interrupt.h"
#include "report/control_test_json.h"
#include "report/machine_store.h"
#include "streaming/setup/commissioning.h"
#include "streaming/setup/feed_test.h"
#include "streaming/setup/job_test.h"

namespace rivulet::cli {

namespace {

void printChecks(const streaming::ChecksOfControl& result) {
  for (const streaming::CommissioningCheck& check : result.checks) {
    fmt::print("{:<6} {}: {}\n", check.passed ? "holds" : "FAILS", check.name, check.message);
  }
}

void print(const streaming::Commissioning& result) {
  printChecks(result);
  fmt::print("{}\n", result.passed() ? "Passed: method credit may run on this control."
                                     : "Not passed: method credit must not run on this control. "
                                       "Use method window.");
}

void print(const streaming::FeedCommissioning& result) {
  printChecks(result);
  fmt::print("{}\n",
             result.provedLiftMm() > 0.0
                 ? fmt::format("Passed: hold, stop and override act at once on this control, and "
                               "the tool may be lifted by up to {:g} mm.",
                               result.provedLiftMm())
             : result.proves() ? "Passed: hold, stop and override act at once on this control."
             : result.passed()
                 ? "Passed without motion: whether the axes obey shows only with --air-move."
                 : "Not passed: a stop is sure to act only before the next window.");
}

void print(const streaming::JobCommissioning& result) {
  printChecks(result);
  for (const streaming::TriedBlock& block : result.tried) {
    const bool isReleased = result.passed() && block.witness != streaming::Witness::Nobody;
    fmt::print("{:<6} {}: {}\n", isReleased ? "tried" : "open", block.text, block.message);
  }
  fmt::print("{}\n", result.passed()
                         ? "Passed: whole jobs may run on this control that have no other kinds of "
                           "blocks than dwells, messages, modes and those listed as tried."
                         : "Not passed: whole jobs must not run on this control.");
}

/// For the time that is said.
constexpr int kMovesOfJobTest = 17;

bool isByHand(const CommissionOptions& options) {
  return options.transfer == "by-hand";
}

/// "X20", "Z-15.5". @return BadAirMove
base::Result<std::optional<streaming::AirMove>> moveOf(const CommissionOptions& options) {
  if (options.airMove.empty()) {
    return std::nullopt;
  }
  constexpr std::string_view kAxes = "XYZ";
  const auto axis = kAxes.find(
      static_cast<char>(std::toupper(static_cast<unsigned char>(options.airMove.front()))));
  const auto mm = base::parseNumber(std::string_view(options.airMove).substr(1));
  const streaming::AirMove move{axis == std::string_view::npos ? -1 : static_cast<int>(axis),
                                mm.value_or(0.0), options.feedMmPerMin, options.liftMm};
  if (const base::Result<void> fits = streaming::requireAirMove(move); !fits) {
    return base::fail(fits.error());
  }
  return move;
}

/// Instructions for the operator of a real control.
void printSteps(const CommissionOptions& options, const streaming::JobTestPlan& plan) {
  fmt::print(stderr,
             "The test makes this move back and forth, about ten times: {}. Keep its way clear.\n",
             streaming::describe(plan.move));
  for (const std::string& block : plan.blocks) {
    fmt::print(stderr, "The control executes {}. Nothing may be in its way.\n", block);
  }
  fmt::print(stderr,
             "It writes R{} to R{}, and takes about {:.0f} minutes.\n  1. Bring the channel to "
             "reset, in AUTO.\n  2. Press cycle start whenever it is asked for, {} times in all. "
             "Ctrl-C aborts the test.\n",
             options.baseCell, options.baseCell + streaming::kJobTestCells - 1,
             std::ceil(base::toSeconds(kMovesOfJobTest * plan.move.duration()) / 60.0 + 1.0),
             streaming::kJobTestStarts);
}

/// Asks on the terminal. @return nothing: nobody is there
std::optional<bool> hasSeen(const std::string& block) {
  fmt::print(stderr, "The control shows nothing of \"{}\". Have you seen it being executed? [y/n] ",
             block);
  std::string answer;
  return std::getline(std::cin, answer) && !answer.empty()
             ? std::optional(answer == "y" || answer == "Y")
             : std::nullopt;
}

void printSteps(const CommissionOptions& options, const streaming::FeedTestPlan& plan) {
  const std::string motion =
      plan.move ? fmt::format(
                      "The test makes this move back and forth, three times: {}. Keep its "
                      "way clear.",
                      streaming::describe(*plan.move))
                : std::string("The test moves no axis.");
  const int cells = options.feedCell ? streaming::kFeedTestCells : streaming::kCreditTestCells;
  fmt::print(
      stderr,
      "{} It writes R{} to R{} and takes {}.\n  1. Bring the channel to reset, in AUTO.\n  2. {} "
      "{}.\n  3. Press cycle start{}. Ctrl-C aborts the test.\n",
      motion, options.baseCell, options.baseCell + cells - 1,
      plan.move ? "about a minute" : "a few seconds",
      isByHand(options) ? "Store what --print writes as a part program, and select it:"
                        : "This program is transferred and selected:",
      options.feedCell ? streaming::feedTestFileName() : streaming::commissioningFileName(),
      plan.move ? ", and once more when the program has ended: that move obeys the control only"
                : "");
}

/// Keeps what was found, and says it.
template <class Result>
Exit finish(const CommissionOptions& options, const Connection& connection,
            const opcua::ServerIdentity& identity, base::Result<Result> result) {
  if (!result) {
    return reportError(result.error(), options.json);
  }
  const streaming::TestOfControl<Result> test{connection.name, identity, utcNow(), RIVULET_VERSION,
                                              std::move(*result)};
  if (!options.simulate) {
    if (const auto saved = report::MachineStore().save(test); !saved) {
      return reportError(saved.error(), options.json);
    }
  }
  if (options.json) {
    printJson(report::testJson(test));
  } else {
    print(test.result);
  }
  return test.result.passed() ? Exit::Done : Exit::Wrong;
}

}  // namespace

Exit commission(const CommissionOptions& options) {
  const auto move = moveOf(options);
  if (!move) {
    return reportError(move.error(), options.json);
  }
  streaming::JobTestPlan jobs;
  jobs.firstCell = options.baseCell;
  jobs.move = move->value_or(streaming::AirMove());
  jobs.blocks = options.blocks;
  if (options.jobs) {
    if (const base::Result<void> fits = streaming::requireJobTestPlan(jobs); !fits) {
      return reportError(fits.error(), options.json);
    }
  }
  streaming::FeedTestPlan plan;
  plan.firstCell = options.baseCell;
  plan.transfer = isByHand(options) ? streaming::TransferWay::ByHand : streaming::TransferWay::Link;
  plan.move = *move;
  if (options.printProgram) {
    fmt::print("{}", options.feedCell ? streaming::feedTestProgram(plan)
                                      : streaming::commissioningProgram(options.baseCell));
    return Exit::Done;
  }
  auto connection =
      options.simulate ? simulate(options.preset, options.seed) : connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  const auto identity = connection->control->identity();
  if (!identity) {
    return reportError(identity.error(), options.json);
  }
  const bool hasOperator = !connection->control->isVirtualMachine();
  if (options.jobs && hasOperator) {
    printSteps(options, jobs);
  } else if (hasOperator || isByHand(options)) {
    printSteps(options, plan);
  }
  interrupt::watch();
  streaming::CommissioningStep said = streaming::CommissioningStep::CycleStart;
  const auto saysAgain = [&](streaming::CommissioningStep step) {
    if (step != std::exchange(said, step) &&
        step == streaming::CommissioningStep::CycleStartAgain && hasOperator) {
      fmt::print(stderr, "Press cycle start once more.\n");
    }
    return !interrupt::wasSeen();
  };
  if (options.jobs) {
    streaming::JobTestTalk talk;
    talk.progress = saysAgain;
    if (!options.json) {
      talk.hasSeen = hasSeen;
    }
    return finish(options, *connection, *identity,
                  streaming::testJobs(*connection->link, *connection->control, jobs, talk));
  }
  return options.feedCell ? finish(options, *connection, *identity,
                                   streaming::testFeedCell(*connection->link, *connection->control,
                                                           plan, saysAgain))
                          : finish(options, *connection, *identity,
                                   streaming::commission(*connection->link, *connection->control,
                                                         plan, saysAgain));
}

}  // namespace rivulet::cli
