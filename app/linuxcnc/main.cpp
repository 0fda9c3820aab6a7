// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-linuxcnc`: a LinuxCNC on this computer behind an OPC UA server. Its functions are in
/// `linuxcnc_control` and in `machine/front`; this file has its options and its shutdown.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>

#include "linuxcnc/linuxcnc_control.h"
#include "log/log.h"
#include "machine/front/server.h"
#include "opcua/node_map.h"
#include "opcua/security.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"

namespace {

/// How often news of LinuxCNC are read while no client asks.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{1};
constexpr int kCellsMin = 20;
constexpr int kCellsMax = 1000;

constexpr int kExitOk = 0;
constexpr int kExitUsage = 2;
constexpr int kExitNoPort = 3;
constexpr int kExitNoLinuxCnc = 4;

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
  action.sa_handler = SIG_IGN;  // the helper may end before we do
  sigaction(SIGPIPE, &action, nullptr);
}

int complain(const rivulet::base::Error& error, int exitCode) {
  rivulet::log::logger().error(error.text());
  return exitCode;
}

struct Arguments {
  rivulet::machine::ServerOptions server;
  rivulet::linuxcnc::LinuxCncOptions linuxCnc;
  std::string certificates;  ///< folder; empty: the user's
  bool encrypted = false;
  bool insecure = false;
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
  app.add_option("--programs", arguments.linuxCnc.programs,
                 "Folder of the part programs that clients write and select")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--cells", arguments.linuxCnc.cells, "R0 to R(n-1), each a pin rivulet.r-<i>")
      ->check(CLI::Range(kCellsMin, kCellsMax))
      ->capture_default_str();
  app.add_flag("--allow-start", arguments.linuxCnc.mayStart,
               "Clients may start and end programs; otherwise the operator does, in LinuxCNC");
  app.add_flag("--sampler", arguments.linuxCnc.hasSampler,
               "sampler.0 is loaded with the pins of docs/linuxcnc.md: clients get its trace");
  app.add_flag("--encrypted", arguments.encrypted,
               "Clients must connect encrypted; always so with an address other than this "
               "computer's");
  app.add_flag("--insecure", arguments.insecure,
               "Clients on other computers may connect without encryption: everybody on the "
               "network can then move the machine");
  app.add_option("--certificates", arguments.certificates,
                 "Folder of the server's certificate (default: ~/.config/rivulet/trust)");
  app.add_option("--helper", arguments.linuxCnc.helper,
                 "The helper (default: rivulet-linuxcnc-helper beside this program)");
  app.add_option("--log-level", arguments.logLevel,
                 "What is logged on standard error (default: warning) and in the log file "
                 "(default: info)")
      ->check(CLI::IsMember(rivulet::log::levelNames()));
  app.set_version_flag("--version", "rivulet-linuxcnc " RIVULET_VERSION);
}

/// Certificate and encryption, as the options say.
rivulet::base::Result<void> protect(Arguments& arguments) {
  namespace trust = rivulet::trust;
  const std::filesystem::path folder = arguments.certificates.empty()
                                           ? trust::trustFolder()
                                           : std::filesystem::path(arguments.certificates);
  rivulet::machine::ServerOptions& server = arguments.server;
  const bool isLocal =
      rivulet::opcua::isLoopback("opc.tcp://" + server.host) || server.host == "::1";
  server.unencrypted = !arguments.encrypted && (isLocal || arguments.insecure);
  auto own = trust::ownCertificate(folder, trust::Owner::Machine);
  if (!own) {
    return tl::unexpected(own.error());
  }
  server.certificate = std::move(*own);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  installSignalHandlers();

  Arguments arguments;
  CLI::App app{
      "An OPC UA server in front of the LinuxCNC that runs on this computer, with the variables "
      "and methods of a SINUMERIK where LinuxCNC has the same. Prints its endpoint when it is "
      "ready and runs until it is interrupted or LinuxCNC ends."};
  addOptions(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  if (const auto done = rivulet::log::setUp(
          {"rivulet-linuxcnc", arguments.logLevel, rivulet::log::recordingsFolder()});
      !done) {
    rivulet::log::logger().info(done.error().text());
  }
  if (arguments.linuxCnc.helper.empty()) {
    std::error_code status;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", status);
    arguments.linuxCnc.helper = (self.parent_path() / "rivulet-linuxcnc-helper").string();
  }
  if (const auto done = protect(arguments); !done) {
    return complain(done.error(), kExitUsage);
  }
  const auto control = rivulet::linuxcnc::LinuxCncControl::connect(arguments.linuxCnc);
  if (!control) {
    return complain(control.error(), kExitNoLinuxCnc);
  }
  const auto server = rivulet::machine::Server::start(**control, arguments.server);
  if (!server) {
    const bool isAddress = server.error().code == rivulet::machine::FrontError::AddressUnusable;
    return complain(server.error(), isAddress ? kExitUsage : kExitNoPort);
  }
  fmt::print("{}\n", (*server)->endpoint());
  std::fflush(stdout);
  rivulet::log::logger().info("{} serves {}", (*server)->endpoint(), (*control)->facts().name);
  while (!g_stop.load() && !(*control)->failure()) {
    (*server)->iterate(kStep);
  }
  if ((*control)->failure()) {
    return complain(*(*control)->failure(), kExitNoLinuxCnc);
  }
  rivulet::log::logger().info("stopped");
  return kExitOk;
}
