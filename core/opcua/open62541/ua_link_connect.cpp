// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <open62541/client_config_default.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contract.h"
#include "base/random.h"
#include "base/secret.h"
#include "opcua/host_check.h"
#include "opcua/open62541/method_call.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

namespace {

/// As on the control.
constexpr UA_UInt32 kSessionTimeoutMs = 60'000;
/// Connecting takes a dozen answers.
constexpr int kConnectDeadlines = 6;
/// Reconnections that belong to connecting: another name of the endpoint, another security policy.
constexpr int kHandshakesMax = 4;
/// Pause before a server that closed the connection is tried again; each is twice as long. It is
/// tried three times in the first second at most.
constexpr Duration kRetryPause = milliseconds(400);
/// For closing the session.
constexpr Duration kCloseDeadline = std::chrono::seconds(1);
constexpr UA_UInt32 kCloseStepMs = 10;

constexpr std::string_view kNoneUri = "http://opcfoundation.org/UA/SecurityPolicy#None";

[[nodiscard]] std::optional<UA_UInt16> namespaceIndex(std::span<const UA_String> uris,
                                                      std::string_view uri) {
  const auto found = std::find_if(uris.begin(), uris.end(),
                                  [&](const UA_String& one) { return view(one) == uri; });
  const std::ptrdiff_t index = found - uris.begin();
  return found == uris.end() || index > UA_UINT16_MAX
             ? std::nullopt
             : std::optional(static_cast<UA_UInt16>(index));
}

}  // namespace

UaLink::Impl::~Impl() {
  deleteClient();
}

void UaLink::Impl::deleteClient() {
  m_connection.isEstablished = false;  // what the library reports while it closes is not a loss
  if (m_client != nullptr) {
    close();
    UA_Client_delete(m_client);
    m_client = nullptr;
  }
}

/// The library waits for the end of its connection without a limit, and does not close one on which
/// it has received something that is no OPC UA. So the session gets some time to end, and then all
/// connections are closed below the library.
void UaLink::Impl::close() {
  UA_EventLoop* loop = UA_Client_getConfig(m_client)->eventLoop;
  if (loop == nullptr || loop->state != UA_EVENTLOOPSTATE_STARTED) {
    return;
  }
  const Instant deadline = now() + kCloseDeadline;
  UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
  UA_Client_getState(m_client, &channel, nullptr, nullptr);
  if (channel == UA_SECURECHANNELSTATE_OPEN && !m_connection.isSilent) {
    UA_Client_disconnectAsync(m_client);
    while (channel != UA_SECURECHANNELSTATE_CLOSED && now() < deadline) {
      loop->run(loop, kCloseStepMs);
      UA_Client_getState(m_client, &channel, nullptr, nullptr);
    }
  }
  loop->stop(loop);
  while (loop->state != UA_EVENTLOOPSTATE_STOPPED && now() < deadline + kCloseDeadline) {
    loop->run(loop, kCloseStepMs);
  }
}

base::Result<void> UaLink::Impl::open() {
  if (auto host = requireHost(m_options.endpoint); !host) {
    return host;
  }
  std::optional<SecureEndpoint>& endpoint = m_secureEndpoint;
  const LoginKind login = loginKindOf(m_options);
  if (m_options.security != unencrypted() || login != LoginKind::Anonymous) {
    auto found = discover();
    if (!found) {
      return base::fail(found.error());
    }
    endpoint = std::move(*found);
    if (auto trusted = checkServer(*endpoint); !trusted) {
      return trusted;
    }
  }
  const bool isPlain =
      !endpoint || (m_security == ChannelSecurity{} && login == LoginKind::Anonymous);
  if (auto created = createClient(isPlain ? nullptr : &*endpoint); !created) {
    return created;
  }
  if (auto connected = handshake(); !connected) {
    if (!endpoint && connected.error().code == LinkError::LoginRefused) {
      // The library found nothing to connect with; what the server offers says why.
      if (auto offered = discover(); !offered) {
        return base::fail(offered.error());
      }
    }
    return connected;
  }
  UA_ClientConfig* config = UA_Client_getConfig(m_client);
  config->noNewSession = true;
  forgetPassword(*config);  // the session is never activated again
  base::wipe(m_options.password);
  if (m_options.userCertificate) {
    base::wipe(m_options.userCertificate->privateKey);
  }
  m_options.own = nullptr;
  m_options.trust = nullptr;
  m_options.offered = nullptr;
  m_connection.isEstablished = true;
  return resolveNamespaces(addSaturating(now(), 2 * m_options.connectDeadline));
}

base::Result<void> UaLink::Impl::createClient(const SecureEndpoint* endpoint) {
  deleteClient();
  UA_ClientConfig config;
  std::memset(&config, 0, sizeof config);
  config.logging = m_logger.handle();
  config.timeout = kLibraryTimeoutMs;
  config.requestedSessionTimeout = kSessionTimeoutMs;
  config.connectivityCheckInterval = 0;  // its answer could come late, too
  config.stateCallback = &Impl::onState;
  config.clientContext = this;
  UA_StatusCode status = UA_ClientConfig_setDefault(&config);
  if (status == UA_STATUSCODE_GOOD && endpoint != nullptr) {
    status = protect(config, *endpoint, m_options, m_own);
  }
  if (status != UA_STATUSCODE_GOOD) {
    UA_ClientConfig_clear(&config);
    return base::fail(LinkError::Rejected, "The OPC UA library cannot be set up.",
                      this->endpoint());
  }
  // The library would connect again at once and without end. While connecting it has to, because
  // the server may name another endpoint; afterwards a lost connection stays lost, because a stream
  // must not continue as if nothing had happened.
  config.noReconnect = true;
  const UA_String name = borrow(m_options.name);
  UA_String_copy(&name, &config.sessionName);
  m_client = UA_Client_newWithConfig(&config);
  RIVULET_ASSERT(m_client != nullptr);
  const bool isEncrypted = endpoint != nullptr && endpoint->description->securityMode ==
                                                      UA_MESSAGESECURITYMODE_SIGNANDENCRYPT;
  m_wire.emplace(*m_client, m_options.silenceMax, isEncrypted);
  return {};
}

/// Asks the server what it offers, on a connection of its own without encryption. Nothing of the
/// answer is trusted: who falsifies it can prevent the connection, not weaken it.
base::Result<SecureEndpoint> UaLink::Impl::discover() {
  const Instant deadline = addSaturating(now(), m_options.connectDeadline);
  Endpoints found;
  UA_StatusCode status = UA_STATUSCODE_BADTIMEOUT;
  do {
    if (auto created = createClient(nullptr); !created) {
      return base::fail(created.error());
    }
    UA_ClientConfig* config = UA_Client_getConfig(m_client);
    config->timeout =
        static_cast<UA_UInt32>(std::chrono::ceil<milliseconds>(m_options.connectDeadline).count());
    // With an endpoint of its own, the library does not look for one that it can open a session on.
    config->endpoint.securityMode = UA_MESSAGESECURITYMODE_NONE;
    const UA_String none = borrow(kNoneUri);
    const UA_String url = borrow(m_options.endpoint);
    UA_String_copy(&none, &config->endpoint.securityPolicyUri);
    UA_String_copy(&url, &config->endpoint.endpointUrl);
    status =
        UA_Client_getEndpoints(m_client, m_options.endpoint.c_str(), &found.count, &found.list);
    // The pauses are ours: left alone, the library asks a server that closes at once some ten
    // thousand times a second.
  } while (
      (status == UA_STATUSCODE_BADCONNECTIONCLOSED || status == UA_STATUSCODE_BADNOTCONNECTED) &&
      pauseBefore(deadline));
  deleteClient();
  if (isBad(status)) {
    return base::fail(connectError(status));
  }
  const std::vector<EndpointOffer> offers = offersOf(found);
  if (m_options.offered) {
    m_options.offered(offers);
  }
  const auto chosen = chooseOffer(offers, m_options.security, loginKindOf(m_options));
  if (!chosen) {
    return base::fail(chosen.error().code, chosen.error().message, endpoint());
  }
  m_security = offers[*chosen].security;
  SecureEndpoint endpoint;
  UA_copy(&found.list[*chosen], endpoint.description.get(),
          &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]);
  // A server may send the certificates of its issuers along; the library compares the first only.
  UA_ByteString& certificate = endpoint.description->serverCertificate;
  if (const std::size_t length = leafOf(view(certificate)).size(); length > 0) {
    certificate.length = length;
  }
  return endpoint;
}

base::Result<void> UaLink::Impl::checkServer(const SecureEndpoint& endpoint) {
  if (m_security == ChannelSecurity{} && loginKindOf(m_options) == LoginKind::Anonymous) {
    return {};
  }
  if (!m_options.own || !m_options.trust) {
    return base::fail(LinkError::CertificateUnknown,
                      "No certificates are set up on this computer, so nothing can be encrypted.",
                      this->endpoint());
  }
  auto own = m_options.own();
  if (!own) {
    return base::fail(own.error());
  }
  m_own = std::move(*own);
  // The password is encrypted for this certificate even where messages are not.
  const std::string_view der = leafOf(view(endpoint.description->serverCertificate));
  auto facts = readCertificate(der);
  if (!facts) {
    return base::fail(facts.error().code, facts.error().message, this->endpoint());
  }
  const std::string_view calledItself = view(endpoint.description->server.applicationUri);
  if (std::find(facts->applicationUris.begin(), facts->applicationUris.end(), calledItself) ==
      facts->applicationUris.end()) {
    facts->strangerUri = calledItself.empty() ? "(nothing)" : calledItself;
  }
  if (auto trusted = m_options.trust(*facts, der); !trusted) {
    return base::fail(trusted.error().code, trusted.error().message, this->endpoint());
  }
  m_certificate = *facts;
  return {};
}

base::Result<void> UaLink::Impl::handshake() {
  const Instant limit = addSaturating(now(), kConnectDeadlines * m_options.connectDeadline);
  Instant deadline = addSaturating(now(), m_options.connectDeadline);
  bool wasOpen = false;
  UA_SessionState reached = UA_SESSIONSTATE_CLOSED;
  UA_StatusCode status = UA_Client_connectAsync(m_client, m_options.endpoint.c_str());
  for (;;) {
    UA_SecureChannelState channel = UA_SECURECHANNELSTATE_CLOSED;
    UA_SessionState session = UA_SESSIONSTATE_CLOSED;
    if (!isBad(status)) {
      UA_Client_getState(m_client, &channel, &session, &status);
    }
    if (status == UA_STATUSCODE_BADNOTCONNECTED) {
      status = reconnect(wasOpen, std::min(deadline, limit));
      wasOpen = false;
    }
    if (m_wire->isUnreadable()) {
      return base::fail(unreadableAnswer(endpoint()));
    }
    if (isBad(status)) {
      return base::fail(connectError(status));
    }
    const bool isOpen = channel == UA_SECURECHANNELSTATE_OPEN;
    if (isOpen && session == UA_SESSIONSTATE_ACTIVATED) {
      return {};
    }
    if ((isOpen && !wasOpen) || session > reached) {
      deadline = addSaturating(now(), 3 * m_options.connectDeadline);
      wasOpen = wasOpen || isOpen;
      reached = std::max(reached, session);
    }
    const Duration left = std::min(deadline, limit) - now();
    if (left <= Duration::zero()) {
      return base::fail(connectError(UA_STATUSCODE_BADTIMEOUT));
    }
    const auto ms = std::chrono::ceil<milliseconds>(std::min(left, kIterationMax)).count();
    status = UA_Client_run_iterate(m_client, static_cast<UA_UInt32>(ms));
  }
}

UA_StatusCode UaLink::Impl::reconnect(bool wasOpen, Instant deadline) {
  if ((!wasOpen || ++m_connection.handshakes > kHandshakesMax) && !pauseBefore(deadline)) {
    return UA_STATUSCODE_BADCONNECTIONCLOSED;
  }
  return UA_Client_connectAsync(m_client, m_options.endpoint.c_str());
}

/// @return false, without a pause, if the deadline would be missed
bool UaLink::Impl::pauseBefore(Instant deadline) {
  // Clients that were turned away together do not come back together.
  base::Random random(static_cast<std::uint64_t>(now().time_since_epoch().count()));
  const double factor = (0.5 + random.uniform()) * std::pow(2.0, m_connection.retries++);
  const Instant next = now() + base::fromSeconds(base::toSeconds(kRetryPause) * factor);
  if (next >= deadline) {
    return false;
  }
  m_clock.sleepUntil(next);
  return true;
}

base::Result<void> UaLink::Impl::resolveNamespaces(Instant deadline) {
  auto answer =
      readAttribute(standardNodeId(UA_NS0ID_SERVER_NAMESPACEARRAY), UA_ATTRIBUTEID_VALUE, deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& value = (*answer)->results[0];
  std::span<const UA_String> uris;
  if (value.hasValue && UA_Variant_hasArrayType(&value.value, &UA_TYPES[UA_TYPES_STRING])) {
    uris = {static_cast<const UA_String*>(value.value.data), value.value.arrayLength};
  }
  for (const UA_String& uri : uris) {
    m_namespaces.emplace_back(view(uri));
  }
  if (m_options.map != nullptr) {
    m_map = m_options.map;
    if (auto resolved = resolveMap(); !resolved) {
      return resolved;
    }
  } else if (!m_options.nodes.empty()) {
    ControlMap map;
    map.nodes = std::move(m_options.nodes);
    m_map = std::make_shared<const ControlMap>(std::move(map));
    return resolveVariables();  // no control
  }
  const std::optional<UA_UInt16> found = namespaceIndex(uris, kNamespaceUri);
  const std::optional<UA_UInt16> foundVirtual = namespaceIndex(uris, kVirtualNamespaceUri);
  const std::optional<UA_UInt16> foundBridge = namespaceIndex(uris, kBridgeNamespaceUri);
  if (!found && !isMapped()) {
    return base::fail(error(LinkError::NamespaceMissing));
  }
  m_namespace = found.value_or(0);
  // The namespace alone proves nothing; the object itself must be there.
  if (foundVirtual) {
    const auto isThere = exists(borrowNodeId(*foundVirtual, kVirtualObject), deadline);
    if (!isThere) {
      return base::fail(isThere.error());
    }
    if (*isThere) {
      m_isVirtual = true;
      const std::string piece = memberIdentifier(kVirtualObject, kFetchTracePiece);
      const auto givesPieces = exists(borrowNodeId(*foundVirtual, piece), deadline);
      if (!givesPieces) {
        return base::fail(givesPieces.error());
      }
      m_commands = Commands{*foundVirtual, kVirtualObject, {true, true}, *givesPieces};
      return {};
    }
  }
  if (foundBridge) {
    Abilities abilities;
    for (const auto& [method, ability] : {std::pair(kCycleStart, &abilities.startsOnRequest),
                                          {kFetchTrace, &abilities.keepsTrace}}) {
      const std::string identifier = memberIdentifier(kBridgeObject, method);
      const auto isThere = exists(borrowNodeId(*foundBridge, identifier), deadline);
      if (!isThere) {
        return base::fail(isThere.error());
      }
      *ability = *isThere;
    }
    m_commands = Commands{*foundBridge, kBridgeObject, abilities};
  }
  return {};
}

}  // namespace rivulet::opcua
