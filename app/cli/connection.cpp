// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/connection.h"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <utility>

#include "cli/status_line.h"
#include "machine/machine.h"
#include "opcua/control_map.h"
#include "streaming/simulation/simulated_link.h"

#ifdef RIVULET_WITH_OPEN62541
#include "platform/log.h"
#include "platform/terminal.h"
#include "qtopcua/open_link.h"
#include "trust/connect.h"
#include "trust/password.h"
#include "trust/trust_store.h"
#include "trust/user_certificate.h"
#endif

namespace rivulet::cli {

namespace {

ConnectionOptions& connectionOptions() {
  static ConnectionOptions options;
  return options;
}

struct SimulatedCell {
  SimulatedCell(machine::MachineConfig config, std::uint64_t seed)
      : machine(std::move(config), seed), link(machine) {}
  machine::Machine machine;
  streaming::SimulatedLink link;
};

}  // namespace

void setConnectionOptions(const ConnectionOptions& options) {
  connectionOptions() = options;
}

#ifdef RIVULET_WITH_OPEN62541

namespace {

/// The map of the option; null without it.
base::Result<std::shared_ptr<const opcua::ControlMap>> chosenMap() {
  const std::string& file = connectionOptions().mapFile;
  if (file.empty()) {
    return nullptr;
  }
  auto map = opcua::readControlMap(file);
  if (!map) {
    return base::fail(map.error());
  }
  return std::make_shared<const opcua::ControlMap>(std::move(*map));
}

/// Asked for once, however often a command connects.
base::Result<std::string> passwordOnce(const ConnectionOptions& options) {
  static std::optional<std::string> kept;
  if (!kept) {
    auto password =
        trust::readPassword(options.passwordFile, fmt::format("Password of {}: ", options.user),
                            trust::kPasswordFileOption);
    if (!password) {
      return password;
    }
    kept = std::move(*password);
  }
  return *kept;
}

bool isAccepted(const opcua::CertificateFacts& facts) {
  if (!isTerminal() || !platform::isInputTerminal()) {
    return false;
  }
  fmt::print(stderr,
             "This server is not known yet. Its certificate:\n  {}\nIs this the fingerprint that "
             "the control shows? Type yes to accept it: ",
             trust::describe(facts));
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "yes";
}

/// Without a terminal, the next step is an option.
base::Error withOption(base::Error error) {
  if (error.code == opcua::LinkError::CertificateUnknown ||
      error.code == opcua::LinkError::CertificateChanged) {
    error.message += " To accept it, give its fingerprint with --trust.";
  } else if (error.code == opcua::LinkError::EncryptionMissing) {
    error.message += " The option is --security.";
  } else if (error.code == opcua::LinkError::ClientNotTrusted) {
    error.message += " The certificate of this computer: rivulet-cli certificate.";
  } else if (error.code == opcua::LinkError::LoginRefused) {
    error.message += " The options are --user and --user-certificate.";
  }
  return error;
}

}  // namespace

base::Result<Connection> connectTo(const std::string& endpoint) {
  auto map = chosenMap();
  if (!map) {
    return base::fail(map.error());
  }
  if (*map != nullptr) {
    for (const opcua::MapGap& gap : opcua::gapsOf(**map)) {
      log::logger().warn("{} has no {}: {}.", connectionOptions().mapFile, gap.key,
                         gap.consequence);
    }
  }
  return connectTo(endpoint, std::move(*map));
}

base::Result<Connection> connectTo(const std::string& endpoint,
                                   std::shared_ptr<const opcua::ControlMap> map) {
  const ConnectionOptions& options = connectionOptions();
  opcua::ConnectRequest request;
  request.endpoint = endpoint;
  request.map = std::move(map);
  request.sessionName = "rivulet-cli";
  request.link = options.link;
  if (!options.security.empty()) {
    request.security = opcua::securityChoiceOf(options.security);
  }
  request.fingerprint = options.fingerprint;
  request.user = options.user;
  if (!options.user.empty()) {
    auto password = passwordOnce(options);
    if (!password) {
      return base::fail(password.error());
    }
    request.password = std::move(*password);
  }
  if (!options.userCertificate.empty()) {
    auto certificate = trust::readUserFiles(options.userCertificate, options.userKey);
    if (!certificate) {
      return base::fail(certificate.error());
    }
    request.userCertificate = std::move(*certificate);
  }
  const auto open = [&](const opcua::ConnectOptions& asked) {
    return qtopcua::openLink(request.link, asked);
  };
  opcua::Attempt attempt = trust::connect(request, trust::trustFolder(), open);
  // A certificate that has changed is never asked about: its fingerprint has to be given.
  if (attempt.question && attempt.question->kind == opcua::TrustQuestion::Kind::NewServer &&
      isAccepted(attempt.question->shown)) {
    request.fingerprint = attempt.question->shown.fingerprint;
    attempt = trust::connect(request, trust::trustFolder(), open);
  }
  base::Result<Connection>& connection = attempt.connection;
  if (!connection) {
    return tl::unexpected(withOption(connection.error()));
  }
  if (const std::string warning = trust::warningOn(*connection); !warning.empty()) {
    log::logger().warn("{}: {}", endpoint, warning);
  }
  return std::move(connection);
}

#else

base::Result<Connection> connectTo(const std::string& endpoint) {
  return connectTo(endpoint, nullptr);
}

base::Result<Connection> connectTo(const std::string& /*endpoint*/,
                                   std::shared_ptr<const opcua::ControlMap> /*map*/) {
  return base::fail(opcua::LinkError::NotReachable,
                    "This build has no OPC UA. Use --simulate, or build with open62541.");
}

#endif

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

}  // namespace rivulet::cli
