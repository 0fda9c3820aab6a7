// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "platform/interrupt.h"
#include "report/credit_test_json.h"
#include "report/machine_store.h"
#include "streaming/setup/commissioning.h"

namespace rivulet::cli {

namespace {

void print(const streaming::Commissioning& result) {
  for (const streaming::CommissioningCheck& check : result.checks) {
    fmt::print("{:<6} {}: {}\n", check.passed ? "holds" : "FAILS", check.name, check.message);
  }
  fmt::print("{}\n", result.passed() ? "Passed: method credit may run on this control."
                                     : "Not passed: method credit must not run on this control. "
                                       "Use method window.");
}

bool isByHand(const CommissionOptions& options) {
  return options.transfer == "by-hand";
}

/// Instructions for the operator of a real control.
void printSteps(const CommissionOptions& options) {
  fmt::print(
      stderr,
      "The test moves no axis. It writes R{} to R{} and takes a few seconds.\n  1. Bring the "
      "channel to reset, in AUTO.\n  2. {} {}.\n  3. Press cycle start. Ctrl-C aborts the test.\n",
      options.baseCell, options.baseCell + 9,
      isByHand(options) ? "Store what --print writes as a part program, and select it:"
                        : "This program is transferred and selected:",
      streaming::commissioningFileName());
}

}  // namespace

Exit commission(const CommissionOptions& options) {
  if (options.printProgram) {
    fmt::print("{}", streaming::commissioningProgram(options.baseCell));
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
  if (!connection->control->isVirtualMachine() || isByHand(options)) {
    printSteps(options);
  }
  interrupt::watch();
  streaming::CommissioningPlan plan;
  plan.firstCell = options.baseCell;
  plan.transfer = isByHand(options) ? streaming::TransferWay::ByHand : streaming::TransferWay::Link;
  auto result =
      streaming::commission(*connection->link, *connection->control, plan,
                            [](streaming::CommissioningStep) { return !interrupt::wasSeen(); });
  if (!result) {
    return reportError(result.error(), options.json);
  }
  const streaming::CreditTest test{connection->name, *identity, utcNow(), RIVULET_VERSION,
                                   std::move(*result)};
  if (!options.simulate) {
    if (const auto saved = report::MachineStore().save(test); !saved) {
      return reportError(saved.error(), options.json);
    }
  }
  if (options.json) {
    printJson(report::creditTestJson(test));
  } else {
    print(test.result);
  }
  return test.result.passed() ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
