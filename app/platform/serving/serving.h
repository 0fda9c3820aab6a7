// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the programs with an OPC UA server have in common: options, certificate, log, exit codes.
/// @threadsafety the main thread.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "base/result.h"
#include "machine/front/server.h"
#include "opcua/node_map.h"
#include "trust/own_certificate.h"

namespace rivulet::serving {

enum ExitCode : int {
  kExitOk = 0,
  kExitUsage = 2,   ///< also: a file that cannot be used
  kExitNoPort = 3,  ///< the server cannot listen
};

struct Options {
  machine::ServerOptions server;
  std::string certificates;  ///< folder; empty: the user's
  bool encrypted = false;
  bool insecure = false;
  bool onlyTrustedClients = false;
  bool renewCertificate = false;
  std::string logLevel;
};

/// @param options  outlives the app  @param port  unless another one is given
void addOptions(CLI::App& app, Options& options, std::uint16_t port = opcua::kPort);

/// The log of the program, as the options say.
void setUpLog(const char* program, const Options& options);

/// Certificate, encryption and clients of `options.server`, as the options say.
[[nodiscard]] base::Result<void> protect(Options& options, const trust::Application& application);

/// One English sentence or two.
[[nodiscard]] std::string describe(const machine::LoginFailure& failure);

/// Logs why the program ends. @return `code`
int complain(const base::Error& error, int code);
/// The same of a server that did not start. @return its exit code
int complainOfStart(const base::Error& error);

/// Where clients find the server: the one line on standard output.
void printEndpoint(const std::string& endpoint);

}  // namespace rivulet::serving
