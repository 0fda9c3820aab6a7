// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-machine`: the virtual machine as a separate program with an OPC UA server. Its
/// functions are in `machine` and `machine/front`; this file has its options and its shutdown.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "base/file.h"
#include "machine/config.h"
#include "machine/front/server.h"
#include "machine/kept_state.h"
#include "machine/machine.h"
#include "machine/surveyed.h"
#include "machine/user.h"
#include "platform/command_line.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "platform/output.h"
#include "platform/process.h"
#include "platform/serving/serving.h"
#include "trust/password.h"

namespace {

using rivulet::serving::complain;
using rivulet::serving::kExitOk;
using rivulet::serving::kExitUsage;

/// Clients are answered at once; this is how often the machine goes on without any, and how old
/// the state on disk may be.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{4};

/// Of a random salt, 32 bits each.
constexpr int kSaltWords = 4;

struct Arguments {
  rivulet::serving::Options serving;
  std::string preset = rivulet::machine::kDefaultPreset;
  std::uint64_t seed = 1;
  bool noFileRights = false;
  std::string program;
  std::string stateFolder;
  std::string survey;
  bool hashPassword = false;
};

/// @param arguments  outlives the app
void addOptions(CLI::App& app, Arguments& arguments) {
  rivulet::serving::addOptions(app, arguments.serving);
  app.add_option("--preset", arguments.preset, "Machine: a built-in preset or a TOML file")
      ->capture_default_str();
  app.add_option("--from", arguments.survey,
                 "Survey of a control (rivulet-cli survey -o FILE): the machine has its "
                 "R-parameters, axes, forms and times of reading, and rights to part programs; "
                 "all else is that of the preset");
  app.add_flag("--no-file-rights", arguments.noFileRights,
               "Clients may not write, read and select part programs");
  app.add_option("--program", arguments.program,
                 "Part program that is stored and selected at the start, as by an operator");
  app.add_option("--seed", arguments.seed, "Seed of the machine's random numbers")
      ->capture_default_str();
  app.add_option("--state", arguments.stateFolder,
                 "Folder that keeps R-parameters, part programs and the places of the axes, as a "
                 "control does when it is switched off");
  app.add_flag("--hash-password", arguments.hashPassword,
               "Ask for a password, print what a preset holds in its place, and end");
  app.set_version_flag("--version", "rivulet-machine " RIVULET_VERSION);
}

/// Says what is assumed, for the survey does not say it.
rivulet::base::Result<rivulet::machine::Surveyed> surveyedMachine(
    const rivulet::machine::MachineConfig& preset, const std::string& file) {
  const auto text = rivulet::base::readFile(file);
  if (!text) {
    return tl::unexpected(text.error());
  }
  auto surveyed = rivulet::machine::asSurveyed(preset, *text);
  if (!surveyed) {
    surveyed.error().context = file;
    return surveyed;
  }
  for (const std::string& assumed : surveyed->assumed) {
    rivulet::log::logger().warn("as the preset has it, not as surveyed: {}", assumed);
  }
  return surveyed;
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
  const auto password = rivulet::trust::readPassword({}, "Password: ", {});
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

/// Serves until the program is interrupted. @return the exit code
int serve(rivulet::machine::Server& server, const rivulet::machine::Machine& machine,
          rivulet::machine::KeptState* kept) {
  while (!rivulet::interrupt::wasSeen()) {
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
  rivulet::output::guard();
  rivulet::interrupt::watch();

  Arguments arguments;
  CLI::App app{
      "A virtual CNC machine with an OPC UA server like that of a SINUMERIK. Prints its endpoint "
      "when it is ready and runs until it is interrupted.",
      "rivulet-machine"};
  addOptions(app, arguments);
  try {
    rivulet::platform::parse(app, rivulet::platform::arguments(argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }

  rivulet::serving::setUpLog("rivulet-machine", arguments.serving);
  if (arguments.hashPassword) {
    return printHash();
  }
  auto config = rivulet::machine::loadPreset(arguments.preset);
  if (!config) {
    return complain(config.error(), kExitUsage);
  }
  bool hasFileRights = !arguments.noFileRights;
  if (!arguments.survey.empty()) {
    auto surveyed = surveyedMachine(*config, arguments.survey);
    if (!surveyed) {
      return complain(surveyed.error(), kExitUsage);
    }
    config = std::move(surveyed->config);
    hasFileRights = hasFileRights && surveyed->hasFileRights;
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
  arguments.serving.server.fileRights = hasFileRights;
  if (const auto done = rivulet::serving::protect(
          arguments.serving,
          {"machine", rivulet::machine::kProductName, rivulet::machine::kApplicationUri});
      !done) {
    return complain(done.error(), kExitUsage);
  }
  const auto server = rivulet::machine::Server::start(machine, arguments.serving.server);
  if (!server) {
    return rivulet::serving::complainOfStart(server.error());
  }
  rivulet::serving::printEndpoint((*server)->endpoint());
  rivulet::log::logger().info("{} serves {} with seed {}", (*server)->endpoint(), arguments.preset,
                              arguments.seed);
  return serve(**server, machine, kept ? &*kept : nullptr);
}
