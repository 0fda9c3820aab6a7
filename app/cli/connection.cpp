// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/connection.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"

#ifdef RIVULET_WITH_OPEN62541
#include "opcua/open62541/ua_link.h"
#endif

namespace rivulet::cli {

namespace {

std::atomic<bool> interrupted{false};

extern "C" void onInterrupt(int) {
  interrupted = true;
}

struct SimulatedCell {
  SimulatedCell(machine::MachineConfig config, std::uint64_t seed)
      : machine(std::move(config), seed), link(machine) {}
  machine::Machine machine;
  streaming::SimulatedLink link;
};

}  // namespace

base::Result<Connection> connectTo([[maybe_unused]] const std::string& endpoint) {
#ifdef RIVULET_WITH_OPEN62541
  opcua::ConnectOptions connect;
  connect.endpoint = endpoint;
  connect.name = "rivulet-cli";
  return opcua::openConnection(connect);
#else
  return base::fail(opcua::LinkError::NotReachable,
                    "This build has no OPC UA. Use --simulate, or build with open62541.");
#endif
}

base::Result<Connection> simulate(const std::string& preset, std::uint64_t seed) {
  auto config = machine::loadPreset(preset);
  return config ? base::Result<Connection>(simulate(std::move(*config), preset, seed))
                : base::fail(config.error());
}

Connection simulate(machine::MachineConfig config, const std::string& name, std::uint64_t seed) {
  const auto cell = std::make_shared<SimulatedCell>(std::move(config), seed);
  return Connection{cell, &cell->link, &cell->link,
                    fmt::format("simulated {} seed {}", name, seed)};
}

void watchForInterrupt() {
  struct sigaction action {};
  action.sa_handler = &onInterrupt;
  // A terminal that is closed and a limit of the shell stop a run in order, too.
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) {
    sigaction(number, &action, nullptr);
  }
  // A reader of our output that has gone stops nothing.
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
}

bool wasInterrupted() {
  return interrupted;
}

bool isTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace rivulet::cli
