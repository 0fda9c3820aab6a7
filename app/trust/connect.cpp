// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/connect.h"

#include <fmt/format.h>

#include "opcua/error.h"
#include "opcua/open62541/ua_link.h"
#include "platform/port_owner.h"
#include "platform/utc_now.h"
#include "trust/trust_store.h"

namespace rivulet::trust {

namespace {

using opcua::ConnectRequest;
using opcua::LinkError;
using opcua::TrustQuestion;

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
  // A server of another user of this computer is as strange as one on another computer.
  choice.prefersNone =
      opcua::isLoopback(request.endpoint) && request.user.empty() && !request.userCertificate &&
      !wasEncrypted &&
      !platform::isPortOfAnother(platform::PortKind::TcpListener, opcua::portOf(request.endpoint));
  return choice;
}

/// What the server has shown during an attempt.
struct Seen {
  std::optional<opcua::CertificateFacts> certificate;
  std::vector<opcua::EndpointOffer> offers;
};

/// The certificate of a server is judged by the store; one is accepted by its fingerprint.
base::Result<void> judge(const TrustStore& store, const ConnectRequest& request,
                         const opcua::CertificateFacts& facts, std::string_view der) {
  const std::string wanted = opcua::fingerprintOf(request.fingerprint);
  if (!wanted.empty() && wanted == facts.fingerprint) {
    if (auto accepted = store.accept(request.endpoint, facts, der); !accepted) {
      return accepted;
    }
  }
  return store.check(request.endpoint, facts, der, utc::now());
}

/// What a person can decide about an attempt that was refused; null: nothing.
std::shared_ptr<const TrustQuestion> questionOn(const base::Error& error, const Seen& seen,
                                                const ConnectRequest& request,
                                                opcua::LoginKind login, const TrustStore& store,
                                                const std::optional<KnownServer>& known) {
  TrustQuestion question;
  question.endpoint = request.endpoint;
  question.acceptedFingerprint = known ? known->fingerprint : std::string();
  question.wasEncrypted = !question.acceptedFingerprint.empty();
  if (error.code == LinkError::EncryptionMissing) {
    question.kind = TrustQuestion::Kind::Protection;
    question.choices = opcua::choicesByName(seen.offers, login);
  } else if (error.code == LinkError::LoginRefused) {
    question.kind = TrustQuestion::Kind::Login;
  } else if (seen.certificate && (error.code == LinkError::CertificateUnknown ||
                                  error.code == LinkError::CertificateChanged)) {
    question.kind = error.code == LinkError::CertificateUnknown
                        ? TrustQuestion::Kind::NewServer
                        : TrustQuestion::Kind::ChangedServer;
    question.shown = *seen.certificate;
    question.isValidNow = opcua::isValidAt(*seen.certificate, utc::now());
    question.accepted = store.keptFacts(question.acceptedFingerprint);
  } else {
    return nullptr;
  }
  return std::make_shared<const TrustQuestion>(std::move(question));
}

}  // namespace

opcua::Attempt connect(const ConnectRequest& request, const std::filesystem::path& folder,
                       const Opener& open) {
  const TrustStore store(folder);
  const auto known = store.find(request.endpoint);
  if (!known) {
    return {base::fail(known.error())};
  }
  if (!request.fingerprint.empty() && opcua::fingerprintOf(request.fingerprint).empty()) {
    return {base::fail(LinkError::CertificateInvalid,
                       "This is no fingerprint: 64 hexadecimal digits are expected, with or "
                       "without colons.",
                       request.fingerprint)};
  }
  if (request.userCertificate) {
    auto usable = opcua::checkUserCertificate(*request.userCertificate, utc::now());
    if (usable) {
      usable = store.checkRevocation(request.userCertificate->certificate, "of the user");
    }
    if (!usable) {
      return {base::fail(usable.error())};
    }
  }
  Seen seen;
  opcua::ConnectOptions options;
  options.endpoint = request.endpoint;
  options.name = request.sessionName;
  options.security = choiceFor(request, *known);
  options.user = request.user;
  options.password = request.password;
  options.userCertificate = request.userCertificate;
  options.nodes = request.nodes;
  options.map = request.map;
  options.own = [&] { return ownCertificate(folder, kClient); };
  options.offered = [&](std::span<const opcua::EndpointOffer> offers) {
    seen.offers.assign(offers.begin(), offers.end());
  };
  options.trust = [&](const opcua::CertificateFacts& facts, std::string_view der) {
    seen.certificate = facts;
    return judge(store, request, facts, der);
  };
  auto connection = open(options);
  if (!connection) {
    return {base::fail(connection.error()), questionOn(connection.error(), seen, request,
                                                       opcua::loginKindOf(options), store, *known)};
  }
  if (request.security) {
    const bool isDefault = *request.security == opcua::SecurityChoice{};
    const std::string text = isDefault ? "" : opcua::securityChoiceText(*request.security);
    if (auto remembered = store.allow(request.endpoint, text); !remembered) {
      return {base::fail(remembered.error())};
    }
  }
  return {std::move(connection)};
}

std::string warningOn(const opcua::Connection& connection) {
  if (!connection.security) {
    return {};
  }
  if (connection.certificate && !connection.certificate->strangerUri.empty()) {
    return strangerText(*connection.certificate) + '.';
  }
  switch (opcua::protectionOf(*connection.security, connection.name)) {
    case opcua::Protection::Encrypted:
    case opcua::Protection::Signed:
    case opcua::Protection::LocalOnly:
      return {};
    case opcua::Protection::Weak:
      return fmt::format(
          "This connection is badly encrypted ({}): it can be broken with the means of today.",
          opcua::policyName(connection.security->policy));
    case opcua::Protection::None:
      break;
  }
  return "This connection is not encrypted: everybody on the network can read what is sent, and "
         "move the machine.";
}

}  // namespace rivulet::trust
