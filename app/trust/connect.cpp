// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/connect.h"

#include <fmt/format.h>

#include "opcua/error.h"
#include "opcua/open62541/ua_link.h"
#include "trust/trust_store.h"
#include "utc/now.h"

namespace rivulet::trust {

namespace {

using opcua::LinkError;

opcua::SecurityChoice choiceFor(const ConnectRequest& request,
                                const std::optional<KnownServer>& known) {
  if (request.security) {
    return *request.security;
  }
  if (known && !known->security.empty()) {
    return opcua::securityChoiceOf(known->security).value_or(opcua::SecurityChoice());
  }
  opcua::SecurityChoice choice;
  const bool wasEncrypted = known && !known->fingerprint.empty();
  choice.prefersNone = opcua::isLoopback(request.endpoint) && request.user.empty() && !wasEncrypted;
  return choice;
}

/// The certificate of a server is judged by the store; a new one can be accepted by its fingerprint
/// or, on first use, by a person.
base::Result<void> judge(const TrustStore& store, const ConnectRequest& request,
                         const opcua::CertificateFacts& facts, std::string_view der) {
  const std::string wanted = opcua::fingerprintOf(request.fingerprint);
  if (!wanted.empty() && wanted == facts.fingerprint) {
    if (auto accepted = store.accept(request.endpoint, facts, der); !accepted) {
      return accepted;
    }
  }
  auto checked = store.check(request.endpoint, facts, der, utc::now());
  if (!checked && checked.error().code == LinkError::CertificateUnknown && request.ask &&
      request.ask(facts)) {
    if (auto accepted = store.accept(request.endpoint, facts, der); !accepted) {
      return accepted;
    }
    checked = store.check(request.endpoint, facts, der, utc::now());
  }
  return checked;
}

}  // namespace

base::Result<opcua::Connection> connect(const ConnectRequest& request,
                                        const std::filesystem::path& folder) {
  const TrustStore store(folder);
  const auto known = store.find(request.endpoint);
  if (!known) {
    return base::fail(known.error());
  }
  if (!request.fingerprint.empty() && opcua::fingerprintOf(request.fingerprint).empty()) {
    return base::fail(LinkError::CertificateInvalid,
                      "This is no fingerprint: 64 hexadecimal digits are expected, with or without "
                      "colons.",
                      request.fingerprint);
  }
  opcua::ConnectOptions options;
  options.endpoint = request.endpoint;
  options.name = request.sessionName;
  options.security = choiceFor(request, *known);
  options.user = request.user;
  options.password = request.password;
  options.own = [&] { return ownCertificate(folder, Owner::Client); };
  options.trust = [&](const opcua::CertificateFacts& facts, std::string_view der) {
    return judge(store, request, facts, der);
  };
  auto connection = opcua::openConnection(options);
  if (connection && request.security) {
    const bool isDefault = *request.security == opcua::SecurityChoice{};
    const std::string text = isDefault ? "" : opcua::securityChoiceText(*request.security);
    if (auto remembered = store.allow(request.endpoint, text); !remembered) {
      return base::fail(remembered.error());
    }
  }
  return connection;
}

base::Result<opcua::Connection> connectAsKnown(const std::string& endpoint,
                                               const std::filesystem::path& folder) {
  const auto known = TrustStore(folder).find(endpoint);
  if (!known) {
    return base::fail(known.error());
  }
  ConnectRequest request;
  request.endpoint = endpoint;
  if (!*known) {
    opcua::ConnectOptions options;
    options.endpoint = endpoint;
    options.security = opcua::unencrypted();
    return opcua::openConnection(options);
  }
  return connect(request, folder);
}

std::string warningOn(const opcua::Connection& connection) {
  if (!connection.security || !opcua::isWeak(connection.security->policy)) {
    return {};
  }
  if (connection.security->policy == opcua::SecurityPolicy::None) {
    return opcua::isLoopback(connection.name) ? std::string()
                                              : "This connection is not encrypted: everybody on "
                                                "the network can read what is sent, "
                                                "and move the machine.";
  }
  return fmt::format(
      "This connection is badly encrypted ({}): it can be broken with the means of "
      "today.",
      opcua::policyName(connection.security->policy));
}

}  // namespace rivulet::trust
