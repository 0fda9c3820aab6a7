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
#include "opcua/await.h"
#include "opcua/open62541/encryption.h"
#include "opcua/open62541/ua_link.h"

namespace {

using namespace rivulet;
using bench::microseconds;
using bench::required;
using namespace std::chrono_literals;

constexpr base::Duration kDeadline = 20s;
constexpr int kRounds = 20;
constexpr int kRequestsPerRound = 100;
/// As many as a window of 7 points has in three axes, with its header.
constexpr int kValues = 28;

struct Kind {
  std::string security;
  std::unique_ptr<opcua::UaLink> link;
  double connectMs = 0.0;
  std::vector<double> writeUs;
  std::vector<double> readUs;
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

void measure(Kind& kind) {
  std::vector<opcua::Assignment> assignments;
  for (int i = 0; i < kValues; ++i) {
    assignments.push_back({opcua::rParameter(i), 0.5 * i});
  }
  const std::array variables{opcua::rParameter(0), opcua::rParameter(1), opcua::rParameter(2)};
  for (int i = 0; i < kRequestsPerRound; ++i) {
    kind.writeUs.push_back(microseconds([&] {
      if (!opcua::writeNow(*kind.link, assignments, kDeadline)) {
        std::exit(1);
      }
    }));
    kind.readUs.push_back(
        microseconds([&] { required(opcua::readNumbers(*kind.link, variables, kDeadline)); }));
  }
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
    kinds.push_back({security, nullptr, 0.0, {}, {}});
    connect(kinds.back(), server->endpoint(), own);
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Kind& kind : kinds) {
      measure(kind);
    }
  }
  fmt::print("{} requests of each kind; encryption by {}\n", kRounds * kRequestsPerRound,
             opcua::encryptionLibrary());
  fmt::print("{:<28} {:>11} {:>9} {:>9} {:>9} {:>9}\n", "", "connect ms", "write us", "p99",
             "read us", "p99");
  for (const Kind& kind : kinds) {
    fmt::print("{:<28} {:>11.1f} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}\n", kind.security,
               kind.connectMs, base::median(kind.writeUs), bench::quantileOf(kind.writeUs, 990),
               base::median(kind.readUs), bench::quantileOf(kind.readUs, 990));
  }
  kinds.clear();
  stop = true;
  thread.join();
  return 0;
}
