// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-linuxcnc`: a LinuxCNC on this computer behind an OPC UA server. Its functions are in
/// `linuxcnc_control` and in `machine/front`; this file has its options and its shutdown.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "linuxcnc/linuxcnc_control.h"
#include "machine/front/server.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "platform/output.h"
#include "platform/serving/serving.h"
#include "templates/target.h"

namespace {

using rivulet::serving::complain;
using rivulet::serving::kExitOk;
using rivulet::serving::kExitUsage;

/// How often news of LinuxCNC are read while no client asks.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{1};
constexpr int kCellsMin = 20;
constexpr int kCellsMax = 1000;

constexpr int kExitNoLinuxCnc = 4;

struct Arguments {
  rivulet::serving::Options serving;
  rivulet::linuxcnc::LinuxCncOptions linuxCnc;
};

/// @param arguments  outlives the app
void addOptions(CLI::App& app, Arguments& arguments) {
  rivulet::serving::addOptions(app, arguments.serving);
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
  app.add_option("--helper", arguments.linuxCnc.helper,
                 "The helper (default: rivulet-linuxcnc-helper beside this program)");
  app.set_version_flag("--version", "rivulet-linuxcnc " RIVULET_VERSION);
}

}  // namespace

int main(int argc, char** argv) {
  rivulet::output::guard();
  rivulet::interrupt::watch();

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
  rivulet::serving::setUpLog("rivulet-linuxcnc", arguments.serving);
  if (arguments.linuxCnc.helper.empty()) {
    std::error_code status;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", status);
    arguments.linuxCnc.helper = (self.parent_path() / "rivulet-linuxcnc-helper").string();
  }
  if (const auto done = rivulet::serving::protect(arguments.serving,
                                                  {"linuxcnc", rivulet::linuxcnc::kProductName,
                                                   rivulet::templates::kLinuxCncApplicationUri});
      !done) {
    return complain(done.error(), kExitUsage);
  }
  const auto control = rivulet::linuxcnc::LinuxCncControl::connect(arguments.linuxCnc);
  if (!control) {
    return complain(control.error(), kExitNoLinuxCnc);
  }
  const auto server = rivulet::machine::Server::start(**control, arguments.serving.server);
  if (!server) {
    return rivulet::serving::complainOfStart(server.error());
  }
  rivulet::serving::printEndpoint((*server)->endpoint());
  rivulet::log::logger().info("{} serves {}", (*server)->endpoint(), (*control)->facts().name);
  while (!rivulet::interrupt::wasSeen() && !(*control)->failure()) {
    (*server)->iterate(kStep);
  }
  if ((*control)->failure()) {
    return complain(*(*control)->failure(), kExitNoLinuxCnc);
  }
  rivulet::log::logger().info("stopped");
  return kExitOk;
}
