// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/serving/serving.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "base/file.h"
#include "base/private_file.h"
#include "opcua/open62541/encryption.h"
#include "platform/log.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"

namespace rivulet::serving {

namespace {

/// Reads the certificates of the clients that may connect.
base::Result<std::set<std::string>> trustedClients(const std::filesystem::path& folder) {
  std::set<std::string> fingerprints;
  if (auto made = base::makePrivateFolder(folder); !made) {
    return tl::unexpected(made.error());
  }
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status)) {
    const auto text = base::readFile(entry.path(), trust::kCertificateBytesMax);
    const auto facts =
        text ? opcua::readCertificate(*text) : tl::unexpected<base::Error>(text.error());
    if (!facts) {
      return base::fail(facts.error().code, facts.error().message, entry.path().string());
    }
    fingerprints.insert(facts->fingerprint);
  }
  return fingerprints;
}

}  // namespace

void addOptions(CLI::App& app, Options& options, std::uint16_t port) {
  options.server.port = port;
  app.add_option("--host", options.server.host,
                 "Address to listen on; 0.0.0.0 allows other computers to connect")
      ->capture_default_str();
  app.add_option("--port", options.server.port, "TCP port; 0: any free port")
      ->capture_default_str();
  app.add_flag("--encrypted", options.encrypted,
               "Clients must connect encrypted; always so with an address other than this "
               "computer's");
  app.add_flag("--insecure", options.insecure,
               "Clients on other computers may connect without encryption: everybody on the "
               "network can then move the machine");
  app.add_flag("--only-trusted-clients", options.onlyTrustedClients,
               "Encrypted clients must have a certificate in the folder clients/trusted of "
               "--certificates; others are kept in clients/rejected");
  app.add_option("--certificates", options.certificates,
                 "Folder of the server's certificate (default: ~/.config/rivulet/trust)");
  app.add_flag("--renew-certificate", options.renewCertificate,
               "Make a new certificate; every client has to accept it again");
  app.add_option("--log-level", options.logLevel,
                 "What is logged on standard error (default: warning) and in the log file "
                 "(default: info)")
      ->check(CLI::IsMember(log::levelNames()));
}

void setUpLog(const char* program, const Options& options) {
  if (const auto done = log::setUp({program, options.logLevel, log::recordingsFolder()}); !done) {
    log::logger().info(done.error().text());
  }
}

base::Result<void> protect(Options& options, const trust::Application& application) {
  const std::filesystem::path folder = options.certificates.empty()
                                           ? trust::trustFolder()
                                           : std::filesystem::path(options.certificates);
  machine::ServerOptions& server = options.server;
  const bool isLocal = opcua::isLoopback("opc.tcp://" + server.host) || server.host == "::1";
  server.unencrypted = !options.encrypted && (isLocal || options.insecure);
  auto own = options.renewCertificate ? trust::renewCertificate(folder, application)
                                      : trust::ownCertificate(folder, application);
  if (!own) {
    return tl::unexpected(own.error());
  }
  if (const auto facts = opcua::readCertificate(own->certificate)) {
    log::logger().info("certificate: {}; encryption by {}", trust::describe(*facts),
                       opcua::encryptionLibrary());
  }
  server.certificate = std::move(*own);
  auto revocations = trust::readRevocations(folder / "clients" / "revoked");
  if (!revocations) {
    return tl::unexpected(revocations.error());
  }
  server.revocations = std::move(*revocations);
  server.onFailedLogin = [](const machine::LoginFailure& failure) {
    log::logger().warn("{}", describe(failure));
  };
  if (options.onlyTrustedClients) {
    auto clients = trustedClients(folder / "clients" / "trusted");
    if (!clients) {
      return tl::unexpected(clients.error());
    }
    server.trustedClients = std::move(*clients);
    server.onRefusedClient = [rejected = folder / "clients" / "rejected"](
                                 const opcua::CertificateFacts& facts, std::string_view der) {
      log::logger().warn("a client is not trusted: {}", trust::describe(facts));
      trust::keepRejected(rejected, facts, der);
    };
  }
  return {};
}

std::string describe(const machine::LoginFailure& failure) {
  std::string text = fmt::format(
      "A login from {} failed: {}, {} in a row.",
      failure.network.empty() ? std::string_view("an unknown address") : failure.network,
      failure.user.empty() ? "nobody has this name" : "wrong password of " + failure.user,
      failure.wrong);
  if (failure.lockedFor > base::Duration::zero()) {
    text += fmt::format(" Locked from there for {:.0f} s.", base::toSeconds(failure.lockedFor));
  }
  return text;
}

int complain(const base::Error& error, int code) {
  log::logger().error(error.text());
  return code;
}

int complainOfStart(const base::Error& error) {
  const bool isAddress = error.code == machine::FrontError::AddressUnusable;
  return complain(error, isAddress ? kExitUsage : kExitNoPort);
}

void printEndpoint(const std::string& endpoint) {
  fmt::print("{}\n", endpoint);
  std::fflush(stdout);
}

}  // namespace rivulet::serving
