// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/rights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console.h"
#include "cli/described_machines.h"

namespace rivulet::cli {

namespace {

std::string_view answerOf(const opcua::RightFinding& finding) {
  return finding.isGiven ? (*finding.isGiven ? "yes" : "no") : "not known";
}

void printText(const opcua::RightsReport& report) {
  for (const opcua::RightFinding& finding : report.findings) {
    fmt::print("{:<20} {:<10} {}\n", opcua::rightTitle(finding.right), answerOf(finding),
               opcua::rightPurpose(finding.right));
    if (!finding.isGiven.value_or(false)) {
      fmt::print("{:<20} {:<10} -> {}\n", "", "",
                 opcua::rightRemedy(finding.right, report.isMapped));
    }
  }
  if (!report.excess.empty()) {
    fmt::print(
        "\nMore than a run needs: {}.\n-> Call DeleteUserAccess with them, or use a user of its "
        "own "
        "for Rivulet.\n",
        fmt::join(report.excess, ", "));
  } else if (!report.isListed) {
    fmt::print(
        "\nThe server does not tell which other rights this user has. Look at the list of users on "
        "the control.\n");
  }
}

nlohmann::ordered_json asJson(const opcua::RightsReport& report) {
  nlohmann::ordered_json rights = nlohmann::ordered_json::array();
  for (const opcua::RightFinding& finding : report.findings) {
    rights.push_back({{"right", opcua::rightTitle(finding.right)},
                      {"essential", opcua::isEssential(finding.right)},
                      {"given", finding.isGiven ? nlohmann::ordered_json(*finding.isGiven)
                                                : nlohmann::ordered_json(nullptr)}});
  }
  return {{"rights", rights}, {"excess", report.excess}};
}

}  // namespace

Exit rights(const RightsOptions& options) {
  const auto connection = connectTo(options.endpoint);
  if (!connection) {
    return reportError(connection.error(), options.json);
  }
  const auto report = opcua::examineRights(*connection);
  if (!report) {
    return reportError(report.error(), options.json);
  }
  const auto machines = describedMachines(*connection);
  if (options.json) {
    auto json = asJson(*report);
    json["machines"] = machinesAsJson(machines);
    printJson(json);
  } else {
    printMachines(machines);
    printText(*report);
  }
  for (const opcua::RightFinding& finding : report->findings) {
    if (opcua::isEssential(finding.right) && !finding.isGiven.value_or(false)) {
      return Exit::Wrong;
    }
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
