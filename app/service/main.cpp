// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `rivulet-service`: one streaming session without a window, for one machine. This file has its
/// options, its main loop and its end; and two small commands that ask a service.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/private_file.h"
#include "journal/line_file.h"
#include "opcua/control_map.h"
#include "opcua/error.h"
#include "platform/command_line.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "platform/output.h"
#include "platform/process.h"
#include "platform/serving/serving.h"
#include "platform/user_folders.h"
#include "preparation/user_file.h"
#include "report/machine_store.h"
#include "service/announcer.h"
#include "service/machine_lock.h"
#include "service/node_table.h"
#include "service/service_client.h"
#include "service/service_server.h"
#include "service/service_session.h"
#include "trust/connect.h"
#include "trust/password.h"
#include "trust/user_certificate.h"

namespace {

using rivulet::serving::complain;
using rivulet::serving::kExitOk;
using rivulet::serving::kExitUsage;

constexpr int kExitRefused = 1;       ///< a method was refused
constexpr int kExitNoService = 3;     ///< no service answers
constexpr int kExitMachineTaken = 4;  ///< another service has the machine
constexpr int kExitNotSettled = 5;    ///< the run in progress did not end as it was told

/// How long requests of clients are waited for; also how old their view of the session may be.
constexpr rivulet::base::Duration kStep = std::chrono::milliseconds{10};
/// While the machine stands and nobody asks.
constexpr rivulet::base::Duration kIdleStep = std::chrono::milliseconds{50};
/// For the end of a run: as long as a stop may take, and a connection to be taken for lost.
constexpr std::chrono::seconds kEndDeadline{45};
/// How often a service is asked by `show --follow`, and an interrupt is noticed.
constexpr int kFollowSteps = 10;
constexpr std::chrono::milliseconds kFollowStep{100};

struct Arguments {
  rivulet::serving::Options serving;
  std::string machine;
  std::string jobs;
  std::string users;
  std::string user;
  std::string passwordFile;
  std::string userCertificate;
  std::string userKey;
  std::string security;
  std::string fingerprint;
  std::string mapFile;
  std::string discovery;
  std::string service;
  bool ready = false;
  bool follow = false;
  std::string method;
  std::vector<std::string> inputs;
};

/// @param arguments  outlives the app
void addRun(CLI::App& app, Arguments& arguments) {
  CLI::App* run = app.add_subcommand("run", "Serve one machine until interrupted");
  run->add_option("machine", arguments.machine, "Address of the machine, opc.tcp://host:port")
      ->required();
  rivulet::serving::addOptions(*run, arguments.serving, rivulet::service::kPort);
  run->add_option("--jobs", arguments.jobs,
                  "Folder of the NC programs; clients can load no others, links included (default: "
                  "~/.local/share/rivulet/jobs, made for this user only)");
  run->add_option("--users", arguments.users,
                  "File of users with role and PIN, as the window sets them up (default: "
                  "~/.config/rivulet/users.json; none: everybody is an engineer)");
  auto* user =
      run->add_option("--user", arguments.user, "Name at the machine (default: anonymous)");
  auto* certificate =
      run->add_option("--user-certificate", arguments.userCertificate,
                      "Log in to the machine by this certificate of a user instead, .pem or .der")
          ->excludes(user);
  run->add_option("--user-key", arguments.userKey,
                  "File of mode 0600 with the key of --user-certificate; default: the same file")
      ->needs(certificate);
  run->add_option("--password-file", arguments.passwordFile,
                  "File with the password for --user, readable by its owner only; without it the "
                  "variable RIVULET_PASSWORD, or the systemd credential rivulet-password");
  run->add_option("--security", arguments.security,
                  "Least protection of the connection to the machine, as in rivulet-cli")
      ->check([](const std::string& text) {
        return rivulet::opcua::securityChoiceOf(text) ? std::string()
                                                      : "unknown protection " + text;
      });
  run->add_option("--trust", arguments.fingerprint,
                  "Fingerprint of the machine's certificate that is accepted");
  run->add_option("--map", arguments.mapFile, "Map of a control that is no SINUMERIK");
  run->add_option("--discovery", arguments.discovery,
                  "Discovery server of OPC UA that is told of this service, opc.tcp://host:4840");
}

void addAsk(CLI::App& app, Arguments& arguments) {
  CLI::App* show = app.add_subcommand("show", "Print the variables of a service on this computer");
  show->add_option("service", arguments.service, "Its address")->required();
  show->add_flag("--ready", arguments.ready,
                 "Print nothing; exit code 1 unless its machine is connected, for probes");
  show->add_flag("--follow", arguments.follow,
                 "Print what changes, each second until interrupted or the service is gone");
  CLI::App* call = app.add_subcommand("call", "Call a method of a service on this computer");
  call->add_option("service", arguments.service, "Its address")->required();
  call->add_option("method", arguments.method, "LoadJob, Preflight, Start, ...")->required();
  call->add_option("inputs", arguments.inputs, "Arguments of the method");
}

int show(const Arguments& arguments) {
  const auto client = rivulet::service::ServiceClient::connect(arguments.service);
  if (!client) {
    return complain(client.error(), kExitNoService);
  }
  const auto values = (*client)->read();
  if (!values) {
    return complain(values.error(), kExitNoService);
  }
  if (arguments.ready) {
    return values->at("Monitoring/IsConnected") == "true" ? kExitOk : kExitRefused;
  }
  std::map<std::string, std::string> shown;
  for (auto seen = values; seen; seen = (*client)->read()) {
    for (const auto& [name, value] : *seen) {
      if (const auto before = shown.find(name); before == shown.end() || before->second != value) {
        fmt::print("{}={}\n", name, value);
      }
    }
    std::fflush(stdout);
    shown = *seen;
    if (!arguments.follow || rivulet::output::isLost()) {
      return kExitOk;
    }
    for (int i = 0; i < kFollowSteps; ++i) {
      if (rivulet::interrupt::wasSeen()) {
        return kExitOk;
      }
      std::this_thread::sleep_for(kFollowStep);
    }
  }
  return kExitNoService;
}

int call(const Arguments& arguments) {
  const auto client = rivulet::service::ServiceClient::connect(arguments.service);
  if (!client) {
    return complain(client.error(), kExitNoService);
  }
  const auto answer = (*client)->call(arguments.method, arguments.inputs);
  if (!answer) {
    const bool isGone = answer.error().code == rivulet::opcua::LinkError::NotReachable;
    return complain(answer.error(), isGone ? kExitNoService : kExitUsage);
  }
  fmt::print("{}\n", answer->message);
  if (!answer->confirmation.empty()) {
    fmt::print("confirmation: {}\n", answer->confirmation);
  }
  return answer->accepted ? kExitOk : kExitRefused;
}

rivulet::base::Result<rivulet::opcua::ConnectRequest> requestOf(const Arguments& arguments) {
  rivulet::opcua::ConnectRequest request;
  request.endpoint = arguments.machine;
  request.sessionName = "rivulet-service";
  request.user = arguments.user;
  request.fingerprint = arguments.fingerprint;
  if (!arguments.security.empty()) {
    request.security = rivulet::opcua::securityChoiceOf(arguments.security);
  }
  if (!arguments.user.empty()) {
    auto password = rivulet::trust::givenPassword(arguments.passwordFile);
    if (!password) {
      return rivulet::base::fail(password.error());
    }
    request.password = password->value_or(std::string());
  }
  if (!arguments.userCertificate.empty()) {
    auto certificate = rivulet::trust::readUserFiles(arguments.userCertificate, arguments.userKey);
    if (!certificate) {
      return rivulet::base::fail(certificate.error());
    }
    request.userCertificate = std::move(*certificate);
  }
  if (!arguments.mapFile.empty()) {
    auto map = rivulet::opcua::readControlMap(arguments.mapFile);
    if (!map) {
      return rivulet::base::fail(map.error());
    }
    request.map = std::make_shared<const rivulet::opcua::ControlMap>(*std::move(map));
  }
  return request;
}

/// Serves until the program is interrupted, and then until the axes stand. @return the exit code
int serve(rivulet::service::ServiceSession& session, rivulet::service::ServiceServer& server) {
  using Clock = std::chrono::steady_clock;
  const auto turn = [&] {
    session.turn(Clock::now());
    server.iterate(session.isRunning() ? kStep : kIdleStep);
  };
  while (!rivulet::interrupt::wasSeen()) {
    turn();
  }
  session.endForGood();
  const bool wasRunning = session.isRunning();
  for (const auto end = Clock::now() + kEndDeadline; session.isRunning() && Clock::now() < end;) {
    turn();
  }
  rivulet::log::logger().info("stopped");
  if (!wasRunning || (!session.isRunning() && session.isSettled())) {
    return kExitOk;
  }
  rivulet::log::logger().error(
      "The run in progress did not end as it was told: look at the machine. {}",
      session.snapshot().alarm);
  return kExitNotSettled;
}

int run(Arguments& arguments) {
  namespace service = rivulet::service;
  const auto lock = service::MachineLock::take(
      rivulet::folders::stateHome() / "rivulet" / "services", arguments.machine);
  if (!lock) {
    const bool isTaken = lock.error().code == service::ServiceError::MachineTaken;
    return complain(lock.error(), isTaken ? kExitMachineTaken : kExitUsage);
  }
  auto request = requestOf(arguments);
  if (!request) {
    return complain(request.error(), kExitUsage);
  }
  const auto users = rivulet::preparation::readUsers(arguments.users.empty()
                                                         ? rivulet::preparation::userFileOfUser()
                                                         : std::filesystem::path(arguments.users));
  if (!users) {
    return complain(users.error(), kExitUsage);
  }
  if (const auto done = rivulet::serving::protect(
          arguments.serving, {"service", service::kProductName, service::kNamespaceUri});
      !done) {
    return complain(done.error(), kExitUsage);
  }
  const std::filesystem::path jobs = arguments.jobs.empty()
                                         ? rivulet::folders::dataHome() / "rivulet" / "jobs"
                                         : std::filesystem::path(arguments.jobs);
  if (arguments.jobs.empty()) {
    if (const auto made = rivulet::base::makePrivateFolder(jobs); !made) {
      return complain(made.error(), kExitUsage);
    }
  }
  service::ServiceSession session(
      {*std::move(request), jobs, rivulet::journal::stateFolderOfUser()},
      [](const rivulet::opcua::ConnectRequest& asked) {
        auto attempt = rivulet::trust::connect(asked);
        if (attempt.connection) {
          const std::string warning = rivulet::trust::warningOn(*attempt.connection);
          if (!warning.empty()) {
            rivulet::log::logger().warn("{}", warning);
          }
        }
        return attempt;
      },
      rivulet::report::MachineStore());
  arguments.serving.server.onFailedLogin =
      [&session](const rivulet::machine::LoginFailure& failure) {
        rivulet::log::logger().warn("{}", rivulet::serving::describe(failure));
        session.noteFailedLogin(failure);
      };
  const auto server = service::ServiceServer::start(session, *users, arguments.serving.server);
  if (!server) {
    return rivulet::serving::complainOfStart(server.error());
  }
  const service::Announcer announcer(arguments.discovery, (*server)->endpoint());
  rivulet::serving::printEndpoint((*server)->endpoint());
  rivulet::log::logger().info("{} serves {}", (*server)->endpoint(), arguments.machine);
  return serve(session, **server);
}

}  // namespace

int main(int argc, char** argv) {
  rivulet::output::guard();
  rivulet::interrupt::watch();

  Arguments arguments;
  CLI::App app{
      "Streams programs to one machine without a window, controlled over OPC UA. See "
      "docs/service.md.",
      "rivulet-service"};
  app.set_version_flag("--version", "rivulet-service " RIVULET_VERSION);
  app.require_subcommand(1);
  addRun(app, arguments);
  addAsk(app, arguments);
  try {
    rivulet::platform::parse(app, rivulet::platform::arguments(argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }

  rivulet::serving::setUpLog("rivulet-service", arguments.serving);
  if (app.got_subcommand("show")) {
    return show(arguments);
  }
  return app.got_subcommand("call") ? call(arguments) : run(arguments);
}
