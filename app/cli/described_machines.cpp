// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/described_machines.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "opcua/node_browser.h"

namespace rivulet::cli {

namespace {

using opcua::DescribedMachine;

struct Row {
  std::string_view title;
  std::string_view key;
  std::string DescribedMachine::*text;
};
constexpr std::array kRows{
    Row{"Machine", "name", &DescribedMachine::name},
    Row{"Manufacturer", "manufacturer", &DescribedMachine::manufacturer},
    Row{"Model", "model", &DescribedMachine::model},
    Row{"Serial number", "serial_number", &DescribedMachine::serialNumber},
    Row{"Software", "software_revision", &DescribedMachine::softwareRevision},
    Row{"Built in", "year_of_construction", &DescribedMachine::yearOfConstruction},
    Row{"Location", "location", &DescribedMachine::location},
    Row{"Instance", "product_instance_uri", &DescribedMachine::productInstanceUri},
    Row{"State", "state", &DescribedMachine::state},
    Row{"Operation mode", "operation_mode", &DescribedMachine::operationMode},
    Row{"Program", "program", &DescribedMachine::program},
    Row{"Program state", "program_state", &DescribedMachine::programState},
    Row{"Job", "job", &DescribedMachine::job},
    Row{"Job state", "job_state", &DescribedMachine::jobState}};

nlohmann::ordered_json orNull(const std::optional<int>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::vector<DescribedMachine> describedMachines(const opcua::Connection& connection) {
  return connection.browser == nullptr
             ? std::vector<DescribedMachine>()
             : opcua::readMachines(*connection.browser).value_or(std::vector<DescribedMachine>());
}

void printMachines(const std::vector<DescribedMachine>& machines) {
  for (const DescribedMachine& machine : machines) {
    for (const Row& row : kRows) {
      if (const std::string& text = machine.*row.text; !text.empty()) {
        fmt::print("{:<20} {}\n", row.title, text);
      }
    }
    if (machine.runsCompleted) {
      fmt::print("{:<20} {}{}\n", "Runs completed", *machine.runsCompleted,
                 machine.runsPlanned ? fmt::format(" of {}", *machine.runsPlanned) : "");
    }
    fmt::print("\n");
  }
}

nlohmann::ordered_json machinesAsJson(const std::vector<DescribedMachine>& machines) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DescribedMachine& machine : machines) {
    nlohmann::ordered_json one;
    for (const Row& row : kRows) {
      one[std::string(row.key)] = machine.*row.text;
    }
    one["runs_completed"] = orNull(machine.runsCompleted);
    one["runs_planned"] = orNull(machine.runsPlanned);
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace rivulet::cli
