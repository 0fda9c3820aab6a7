// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What encryption costs: the time of a request beside None, and of connecting. Client and server
// are on this computer, the virtual machine takes no time of its own (preset ideal). The kinds are
// measured in turns, so that what disturbs one disturbs all; medians and the slowest hundredth are
// printed.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/median.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "measuring.h"
#include "opcua/open62541/encryption.h"
#include "opcua/open62541/ua_link.h"
#include "request_times.h"

namespace {

using namespace rivulet;
using bench::microseconds;
using bench::required;

struct Kind {
  std::string security;
  std::unique_ptr<opcua::UaLink> link;
  double connectMs = 0.0;
  bench::RequestTimes times;
};

void connect(Kind& kind, const std::string& endpoint, const opcua::OwnCertificate& own) {
  opcua::ConnectOptions options;
  options.endpoint = endpoint;
  options.security = opcua::securityChoiceOf(kind.security).value_or(opcua::SecurityChoice());
  options.own = [own] { return base::Result<opcua::OwnCertificate>(own); };
  options.trust = [](const opcua::CertificateFacts&, std::string_view) {
    return base::Result<void>();
  };
  kind.connectMs =
      microseconds([&] { kind.link = required(opcua::UaLink::connect(options)); }) / 1000.0;
}

}  // namespace

int main() {
  machine::Machine machine(required(machine::loadPreset("ideal")), 1);
  machine::ServerOptions options;
  options.certificate =
      required(opcua::makeCertificate({"machine", "urn:bench:machine", {"localhost"}, 1}));
  const auto server = required(machine::Server::start(machine, options));
  const auto own =
      required(opcua::makeCertificate({"client", "urn:bench:client", {"localhost"}, 1}));
  std::atomic<bool> stop{false};
  std::thread thread([&] { server->run(stop); });

  std::vector<Kind> kinds;
  for (const char* security :
       {"None", "Basic256Sha256/Sign", "Basic256Sha256", "Aes128_Sha256_RsaOaep",
        "Aes256_Sha256_RsaPss/Sign", "Aes256_Sha256_RsaPss"}) {
    kinds.push_back({security, nullptr, 0.0, {}});
    connect(kinds.back(), server->endpoint(), own);
  }
  for (int round = 0; round < bench::kRounds; ++round) {
    for (Kind& kind : kinds) {
      bench::measureRequests(*kind.link, kind.times);
    }
  }
  fmt::print("{} requests of each kind; encryption by {}\n",
             bench::kRounds * bench::kRequestsPerRound, opcua::encryptionLibrary());
  fmt::print("{:<28} {:>11} {:>9} {:>9} {:>9} {:>9}\n", "", "connect ms", "write us", "p99",
             "read us", "p99");
  for (const Kind& kind : kinds) {
    fmt::print("{:<28} {:>11.1f} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}\n", kind.security,
               kind.connectMs, base::median(kind.times.writeUs),
               bench::quantileOf(kind.times.writeUs, 990), base::median(kind.times.readUs),
               bench::quantileOf(kind.times.readUs, 990));
  }
  kinds.clear();
  stop = true;
  thread.join();
  return 0;
}
