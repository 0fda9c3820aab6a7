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
#include "qtopcua/open_link.h"
#include "request_times.h"

namespace {

using namespace rivulet;
using bench::required;

struct Kind {
  std::string name;
  opcua::Connection connection;
  bench::RequestTimes times;
};

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
    kinds.push_back({name, required(qtopcua::openLink(kind, options)), {}});
  }
  for (int round = 0; round < bench::kRounds; ++round) {
    for (Kind& kind : kinds) {
      bench::measureRequests(*kind.connection.link, kind.times);
    }
  }
  fmt::print("{} requests of each kind: {} values written, 3 read\n",
             bench::kRounds * bench::kRequestsPerRound, bench::kValues);
  fmt::print("{:<12} {:>9} {:>9} {:>9} {:>9}\n", "", "write us", "p99", "read us", "p99");
  for (const Kind& kind : kinds) {
    fmt::print("{:<12} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}\n", kind.name,
               base::median(kind.times.writeUs), bench::quantileOf(kind.times.writeUs, 990),
               base::median(kind.times.readUs), bench::quantileOf(kind.times.readUs, 990));
  }
  kinds.clear();
  stop = true;
  thread.join();
  return 0;
}
