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
#include <string>

#include "base/file.h"
#include "log/log.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/kept_state.h"
#include "machine/machine.h"

namespace {

/// Clients are answered at once; this is how often the machine goes on without any, and how old
/// the state on disk may be.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{4};

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

}  // namespace

int main(int argc, char** argv) {
  installSignalHandlers();

  rivulet::machine::ServerOptions options;
  options.port = 4840;
  std::string preset = "dmu75";
  std::uint64_t seed = 1;
  CLI::App app{
      "A virtual CNC machine with an OPC UA server like that of a SINUMERIK. Prints its endpoint "
      "when it is ready and runs until it is interrupted."};
  app.add_option("--host", options.host,
                 "Address to listen on; 0.0.0.0 allows other computers to connect")
      ->capture_default_str();
  app.add_option("--port", options.port, "TCP port; 0: any free port")->capture_default_str();
  app.add_option("--preset", preset, "Machine: a built-in preset or a TOML file")
      ->capture_default_str();
  bool noFileRights = false;
  std::string program;
  app.add_flag("--no-file-rights", noFileRights,
               "Clients may not write, read and select part programs");
  app.add_option("--program", program,
                 "Part program that is stored and selected at the start, as by an operator");
  app.add_option("--seed", seed, "Seed of the machine's random numbers")->capture_default_str();
  std::string folder;
  app.add_option("--state", folder,
                 "Folder that keeps R-parameters, part programs and the places of the axes, as a "
                 "control does when it is switched off");
  std::string logLevel;
  app.add_option("--log-level", logLevel,
                 "What is logged on standard error (default: warning) and in the log file "
                 "(default: info)")
      ->check(CLI::IsMember(rivulet::log::levelNames()));
  app.set_version_flag("--version", "rivulet-machine " RIVULET_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }

  if (const auto done =
          rivulet::log::setUp({"rivulet-machine", logLevel, rivulet::log::recordingsFolder()});
      !done) {
    rivulet::log::logger().info(done.error().text());
  }
  auto config = rivulet::machine::loadPreset(preset);
  if (!config) {
    return complain(config.error(), kExitUsage);
  }
  std::optional<rivulet::machine::KeptState> kept;
  if (!folder.empty()) {
    auto opened = rivulet::machine::KeptState::open(folder, *config);
    if (!opened) {
      return complain(opened.error(), kExitUsage);
    }
    kept.emplace(std::move(*opened));
  }
  rivulet::machine::Machine machine(*config, seed);
  if (kept) {
    kept->restore(machine);
  }
  options.fileRights = !noFileRights;
  if (!program.empty()) {
    const auto text = rivulet::base::readFile(program);
    const std::string name = std::filesystem::path(program).filename().string();
    if (!text) {
      return complain(text.error(), kExitUsage);
    }
    if (const auto stored = machine.storeProgram(name, *text, true); !stored) {
      return complain(stored.error(), kExitUsage);
    }
    if (const auto selected = machine.selectProgram(name); !selected) {
      return complain(selected.error(), kExitUsage);
    }
  }
  const auto server = rivulet::machine::Server::start(machine, options);
  if (!server) {
    const bool isAddress = server.error().code == rivulet::machine::FrontError::AddressUnusable;
    return complain(server.error(), isAddress ? kExitUsage : kExitNoPort);
  }
  fmt::print("{}\n", (*server)->endpoint());
  std::fflush(stdout);
  rivulet::log::logger().info("{} serves {} with seed {}", (*server)->endpoint(), preset, seed);
  while (!g_stop.load()) {
    (*server)->iterate(kStep);
    if (kept) {
      if (const auto done = kept->keep(machine); !done) {
        return complain(done.error(), kExitUsage);
      }
    }
  }
  rivulet::log::logger().info("stopped");
  return kExitOk;
}
