// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long an access takes with each library that makes connections. Client and server are on this
// computer, the virtual machine takes no time of its own (preset ideal), nothing is encrypted. The
// libraries are measured in turns, so that what disturbs one disturbs all; medians and the slowest
// hundredth are printed.

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "base/median.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "measuring.h"
#include "opcua/await.h"
#include "qtopcua/open_link.h"

namespace {

using namespace rivulet;
using namespace std::chrono_literals;
using bench::microseconds;
using bench::required;

constexpr base::Duration kDeadline = 20s;
constexpr int kRounds = 20;
constexpr int kRequestsPerRound = 100;
/// As many as a window of 7 points has in three axes, with its header.
constexpr int kValues = 28;

struct Kind {
  std::string name;
  opcua::Connection connection;
  std::vector<double> writeUs;
  std::vector<double> readUs;
};

void measure(Kind& kind) {
  std::vector<opcua::Assignment> assignments;
  for (int i = 0; i < kValues; ++i) {
    assignments.push_back({opcua::rParameter(i), 0.5 * i});
  }
  const std::array variables{opcua::rParameter(0), opcua::rParameter(1), opcua::rParameter(2)};
  opcua::Link& link = *kind.connection.link;
  for (int i = 0; i < kRequestsPerRound; ++i) {
    kind.writeUs.push_back(microseconds([&] {
      if (!opcua::writeNow(link, assignments, kDeadline)) {
        std::exit(1);
      }
    }));
    kind.readUs.push_back(
        microseconds([&] { required(opcua::readNumbers(link, variables, kDeadline)); }));
  }
}

}  // namespace

int main() {
  machine::Machine machine(required(machine::loadPreset("ideal")), 1);
  const auto server = required(machine::Server::start(machine, machine::ServerOptions{}));
  std::atomic<bool> stop{false};
  std::thread thread([&] { server->run(stop); });

  opcua::ConnectOptions options;
  options.endpoint = server->endpoint();
  options.security = opcua::unencrypted();
  std::vector<Kind> kinds;
  for (const opcua::LinkKind kind : {opcua::LinkKind::Open62541, opcua::LinkKind::QtOpcUa}) {
    const std::string name(qtopcua::linkName(kind));
    if (!qtopcua::isAvailable(kind)) {
      fmt::print("{}: not in this build\n", name);
      continue;
    }
    kinds.push_back({name, required(qtopcua::openLink(kind, options)), {}, {}});
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Kind& kind : kinds) {
      measure(kind);
    }
  }
  fmt::print("{} requests of each kind: {} values written, 3 read\n", kRounds * kRequestsPerRound,
             kValues);
  fmt::print("{:<12} {:>9} {:>9} {:>9} {:>9}\n", "", "write us", "p99", "read us", "p99");
  for (const Kind& kind : kinds) {
    fmt::print("{:<12} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}\n", kind.name, base::median(kind.writeUs),
               bench::quantileOf(kind.writeUs, 990), base::median(kind.readUs),
               bench::quantileOf(kind.readUs, 990));
  }
  kinds.clear();
  stop = true;
  thread.join();
  return 0;
}
