// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-machine`: the virtual machine as a separate program with an OPC UA server. Its
/// functions are in `machine` and `machine/front`; this file has its options and its shutdown.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "base/file.h"
#include "log/log.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/kept_state.h"
#include "machine/machine.h"
#include "machine/user.h"
#include "opcua/node_map.h"
#include "opcua/open62541/encryption.h"
#include "trust/own_certificate.h"
#include "trust/password.h"
#include "trust/private_file.h"
#include "trust/trust_store.h"

namespace {

/// Clients are answered at once; this is how often the machine goes on without any, and how old
/// the state on disk may be.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{4};

/// Of a random salt, 32 bits each.
constexpr int kSaltWords = 4;

constexpr int kExitOk = 0;
constexpr int kExitUsage = 2;
constexpr int kExitNoPort = 3;

/// Set by a signal, checked between two iterations of the server.
std::atomic<bool> g_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch it only so");

extern "C" void onSignal(int /*signal*/) {
  g_stop.store(true);
}

void installSignalHandlers() {
  struct sigaction action {};
  action.sa_handler = &onSignal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A reader of our output that has gone is no reason to end without cleaning up.
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
}

int complain(const rivulet::base::Error& error, int exitCode) {
  rivulet::log::logger().error(error.text());
  return exitCode;
}

struct Arguments {
  rivulet::machine::ServerOptions server;
  std::string preset = rivulet::machine::kDefaultPreset;
  std::uint64_t seed = 1;
  bool noFileRights = false;
  std::string program;
  std::string stateFolder;
  std::string certificates;  ///< folder; empty: the user's
  bool encrypted = false;
  bool insecure = false;
  bool onlyTrustedClients = false;
  bool hashPassword = false;
  bool renewCertificate = false;
  std::string logLevel;
};

/// @param arguments  outlives the app
void addOptions(CLI::App& app, Arguments& arguments) {
  arguments.server.port = rivulet::opcua::kPort;
  app.add_option("--host", arguments.server.host,
                 "Address to listen on; 0.0.0.0 allows other computers to connect")
      ->capture_default_str();
  app.add_option("--port", arguments.server.port, "TCP port; 0: any free port")
      ->capture_default_str();
  app.add_option("--preset", arguments.preset, "Machine: a built-in preset or a TOML file")
      ->capture_default_str();
  app.add_flag("--no-file-rights", arguments.noFileRights,
               "Clients may not write, read and select part programs");
  app.add_option("--program", arguments.program,
                 "Part program that is stored and selected at the start, as by an operator");
  app.add_option("--seed", arguments.seed, "Seed of the machine's random numbers")
      ->capture_default_str();
  app.add_option("--state", arguments.stateFolder,
                 "Folder that keeps R-parameters, part programs and the places of the axes, as a "
                 "control does when it is switched off");
  app.add_flag("--encrypted", arguments.encrypted,
               "Clients must connect encrypted; always so with an address other than this "
               "computer's");
  app.add_flag("--insecure", arguments.insecure,
               "Clients on other computers may connect without encryption: everybody on the "
               "network can then move the machine");
  app.add_flag("--only-trusted-clients", arguments.onlyTrustedClients,
               "Encrypted clients must have a certificate in the folder clients/trusted of "
               "--certificates; others are kept in clients/rejected");
  app.add_option("--certificates", arguments.certificates,
                 "Folder of the machine's certificate (default: ~/.config/rivulet/trust)");
  app.add_flag("--renew-certificate", arguments.renewCertificate,
               "Make a new certificate; every client has to accept it again");
  app.add_flag("--hash-password", arguments.hashPassword,
               "Ask for a password, print what a preset holds in its place, and end");
  app.add_option("--log-level", arguments.logLevel,
                 "What is logged on standard error (default: warning) and in the log file "
                 "(default: info)")
      ->check(CLI::IsMember(rivulet::log::levelNames()));
  app.set_version_flag("--version", "rivulet-machine " RIVULET_VERSION);
}

/// Stores the program of `file` on the machine and selects it.
rivulet::base::Result<void> select(rivulet::machine::Machine& machine, const std::string& file) {
  const auto text = rivulet::base::readFile(file);
  if (!text) {
    return tl::unexpected(text.error());
  }
  const std::string name = std::filesystem::path(file).filename().string();
  if (auto stored = machine.storeProgram(name, *text, true); !stored) {
    return stored;
  }
  return machine.selectProgram(name);
}

/// For a preset: the password of a user, which nobody can read back.
int printHash() {
  const auto password = rivulet::trust::readPassword({}, "Password: ");
  if (!password) {
    return complain(password.error(), kExitUsage);
  }
  std::random_device random;
  std::string salt;
  for (int i = 0; i < kSaltWords; ++i) {
    salt += fmt::format("{:08x}", random());
  }
  fmt::print("{}\n",
             rivulet::machine::passwordText(rivulet::machine::hashPassword(*password, salt)));
  return kExitOk;
}

/// Reads the certificates of the clients that may connect.
rivulet::base::Result<std::set<std::string>> trustedClients(const std::filesystem::path& folder) {
  std::set<std::string> fingerprints;
  if (auto made = rivulet::trust::makePrivateFolder(folder); !made) {
    return tl::unexpected(made.error());
  }
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status)) {
    const auto text = rivulet::base::readFile(entry.path(), rivulet::trust::kCertificateBytesMax);
    const auto facts = text ? rivulet::opcua::readCertificate(*text)
                            : tl::unexpected<rivulet::base::Error>(text.error());
    if (!facts) {
      return rivulet::base::fail(facts.error().code, facts.error().message, entry.path().string());
    }
    fingerprints.insert(facts->fingerprint);
  }
  return fingerprints;
}

/// Certificate, encryption and clients, as the options say.
rivulet::base::Result<void> protect(Arguments& arguments) {
  namespace trust = rivulet::trust;
  const std::filesystem::path folder = arguments.certificates.empty()
                                           ? trust::trustFolder()
                                           : std::filesystem::path(arguments.certificates);
  rivulet::machine::ServerOptions& server = arguments.server;
  const bool isLocal =
      rivulet::opcua::isLoopback("opc.tcp://" + server.host) || server.host == "::1";
  server.unencrypted = !arguments.encrypted && (isLocal || arguments.insecure);
  auto own = arguments.renewCertificate ? trust::renewCertificate(folder, trust::Owner::Machine)
                                        : trust::ownCertificate(folder, trust::Owner::Machine);
  if (!own) {
    return tl::unexpected(own.error());
  }
  if (const auto facts = rivulet::opcua::readCertificate(own->certificate)) {
    rivulet::log::logger().info("certificate: {}; encryption by {}", trust::describe(*facts),
                                rivulet::opcua::encryptionLibrary());
  }
  server.certificate = std::move(*own);
  if (arguments.onlyTrustedClients) {
    auto clients = trustedClients(folder / "clients" / "trusted");
    if (!clients) {
      return tl::unexpected(clients.error());
    }
    server.trustedClients = std::move(*clients);
    server.onRefusedClient = [rejected = folder / "clients" / "rejected"](
                                 const rivulet::opcua::CertificateFacts& facts,
                                 std::string_view der) {
      rivulet::log::logger().warn("a client is not trusted: {}", trust::describe(facts));
      trust::keepRejected(rejected, facts, der);
    };
  }
  return {};
}

/// Serves until the program is interrupted. @return the exit code
int serve(rivulet::machine::Server& server, const rivulet::machine::Machine& machine,
          rivulet::machine::KeptState* kept) {
  while (!g_stop.load()) {
    server.iterate(kStep);
    if (kept != nullptr) {
      if (const auto done = kept->keep(machine); !done) {
        return complain(done.error(), kExitUsage);
      }
    }
  }
  rivulet::log::logger().info("stopped");
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  installSignalHandlers();

  Arguments arguments;
  CLI::App app{
      "A virtual CNC machine with an OPC UA server like that of a SINUMERIK. Prints its endpoint "
      "when it is ready and runs until it is interrupted."};
  addOptions(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }

  if (const auto done = rivulet::log::setUp(
          {"rivulet-machine", arguments.logLevel, rivulet::log::recordingsFolder()});
      !done) {
    rivulet::log::logger().info(done.error().text());
  }
  if (arguments.hashPassword) {
    return printHash();
  }
  auto config = rivulet::machine::loadPreset(arguments.preset);
  if (!config) {
    return complain(config.error(), kExitUsage);
  }
  std::optional<rivulet::machine::KeptState> kept;
  if (!arguments.stateFolder.empty()) {
    auto opened = rivulet::machine::KeptState::open(arguments.stateFolder, *config);
    if (!opened) {
      return complain(opened.error(), kExitUsage);
    }
    kept.emplace(std::move(*opened));
  }
  rivulet::machine::Machine machine(*config, arguments.seed);
  if (kept) {
    kept->restore(machine);
  }
  if (!arguments.program.empty()) {
    if (const auto selected = select(machine, arguments.program); !selected) {
      return complain(selected.error(), kExitUsage);
    }
  }
  arguments.server.fileRights = !arguments.noFileRights;
  if (const auto done = protect(arguments); !done) {
    return complain(done.error(), kExitUsage);
  }
  const auto server = rivulet::machine::Server::start(machine, arguments.server);
  if (!server) {
    const bool isAddress = server.error().code == rivulet::machine::FrontError::AddressUnusable;
    return complain(server.error(), isAddress ? kExitUsage : kExitNoPort);
  }
  fmt::print("{}\n", (*server)->endpoint());
  std::fflush(stdout);
  rivulet::log::logger().info("{} serves {} with seed {}", (*server)->endpoint(), arguments.preset,
                              arguments.seed);
  return serve(**server, machine, kept ? &*kept : nullptr);
}
