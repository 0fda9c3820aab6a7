// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/server.h"

#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "machine/front/address_space.h"
#include "machine/front/array_store.h"
#include "machine/front/capabilities.h"
#include "machine/front/client_gate.h"
#include "machine/front/clients.h"
#include "machine/front/listening.h"
#include "machine/front/methods.h"
#include "machine/front/variable_service.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"
#include "opcua/request.h"

namespace rivulet::machine {

namespace {

using std::chrono::milliseconds;

/// Limits as documented for the 840D sl, if there is such a figure.
constexpr UA_UInt16 kSessionsMax = 10;
constexpr UA_UInt16 kConnectionsMax = 2 * kSessionsMax;
constexpr UA_UInt32 kSubscriptionsMax = 10;
constexpr UA_UInt32 kMonitoredItemsMax = 100;
constexpr double kSamplingIntervalMsMax = 5000.0;
constexpr double kSessionTimeoutMsMax = 60'000.0;
constexpr double kNoWorkerMs = 1.0;  ///< after which a call that nobody works on is given up
constexpr UA_UInt32 kQueueSizeMax = 10'000;
constexpr auto kNodesPerRequestMax = static_cast<UA_UInt32>(opcua::kItemsMax);
/// A file of the largest size, its request and some room.
constexpr UA_UInt32 kMessageBytesMax = static_cast<UA_UInt32>(kFileBytesMax) + (1U << 20U);

/// A session whose connection is gone for so long is closed.
constexpr base::Duration kOrphanAge = std::chrono::seconds(10);

/// A client that has said nothing for so long may have lost its power.
constexpr base::Duration kSilenceMax = std::chrono::seconds(3);

/// How often the machine is advanced while no client asks.
constexpr base::Duration kIdleStep = milliseconds(10);

}  // namespace

std::error_code make_error_code(FrontError code) {
  static const base::NamedCategory category("machine.front");
  return {static_cast<int>(code), category};
}

class Server::Impl {
 public:
  Impl(ServedControl& control, const ServerOptions& options)
      : m_service(control), m_gate(gateOf(m_service, options)) {}
  /// @param machine  the control, if it is the virtual machine
  Impl(std::unique_ptr<ServedMachine> machine, const ServerOptions& options)
      : m_machine(std::move(machine)), m_service(*m_machine), m_gate(gateOf(m_service, options)) {}
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] base::Result<void> start(const ServerOptions& options);
  void iterate(base::Duration timeout);

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }
  [[nodiscard]] const VariableService& service() const { return m_service; }

 private:
  [[nodiscard]] static ClientGate gateOf(VariableService& service, const ServerOptions& options) {
    return {service.control().facts().users, [&service] { return service.now(); }, options};
  }
  [[nodiscard]] base::Result<void> configure(const ServerOptions& options);
  [[nodiscard]] base::Result<void> watchAnswers();
  [[nodiscard]] tl::unexpected<base::Error> setUpFailed(const char* what) const;

  /// Answers that are not due yet keep those after them on the same connection waiting.
  struct HeldAnswer {
    std::uintptr_t connection = 0;
    base::Instant due{};
    std::string message;
  };
  /// A client's session, and the connection it was activated on; 0: that is gone.
  struct Session {
    UA_NodeId id{};
    std::uintptr_t connection = 0;
    base::Instant orphanedAt{};
    base::Instant heardAt{};  ///< the last message on its connection
  };

  static UA_StatusCode onActivate(UA_Server* server, UA_AccessControl* control,
                                  const UA_EndpointDescription* endpoint,
                                  const UA_ByteString* certificate, const UA_NodeId* sessionId,
                                  const UA_ExtensionObject* token, void** context) noexcept;
  static void onCloseSession(UA_Server* server, UA_AccessControl* control,
                             const UA_NodeId* sessionId, void* context) noexcept;
  void connectionClosed(std::uintptr_t connection);
  void sendDueAnswers(base::Instant now);
  /// Sessions whose connection is gone for that long.
  void closeOrphans(base::Duration age, std::size_t countMax);

  static UA_StatusCode onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                              const UA_KeyValueMap* parameters, UA_ByteString* message) noexcept;

  std::unique_ptr<ServedMachine> m_machine;
  opcua::QuietLogger m_logger;  ///< outlives the server that logs into it
  VariableService m_service;
  ClientGate m_gate;  ///< outlives the server that asks it
  Clients& m_clients = m_gate.clients();
  ArrayStore m_arrayStore;
  UA_Server* m_server = nullptr;
  UA_EventLoop* m_loop = nullptr;
  std::unique_ptr<AddressSpace> m_addressSpace;
  std::unique_ptr<Methods> m_methods;
  UA_StatusCode (*m_send)(UA_ConnectionManager*, std::uintptr_t, const UA_KeyValueMap*,
                          UA_ByteString*) = nullptr;
  decltype(UA_AccessControl::activateSession) m_activate = nullptr;
  decltype(UA_AccessControl::closeSession) m_closeSession = nullptr;
  std::deque<HeldAnswer> m_held;
  std::map<std::string, Session> m_sessions;
  std::string m_endpoint;
  bool m_running = false;
};

Server::Impl::~Impl() {
  if (m_server == nullptr) {
    return;
  }
  if (m_running) {
    UA_Server_run_shutdown(m_server);
  }
  UA_Server_delete(m_server);
  for (auto& [key, session] : m_sessions) {
    UA_NodeId_clear(&session.id);
  }
}

base::Result<void> Server::Impl::start(const ServerOptions& options) {
  if (auto able = requireListening(options, kConnectionsMax); !able) {
    return able;
  }
  if (auto configured = configure(options); !configured) {
    return configured;
  }
  if (auto watched = watchAnswers(); !watched) {
    return watched;
  }
  m_addressSpace = std::make_unique<AddressSpace>(m_server, m_service);
  if (auto built = m_addressSpace->build(); !built) {
    return built;
  }
  m_methods = std::make_unique<Methods>(m_server, m_service, options.fileRights);
  if (auto built = m_methods->build(m_addressSpace->namespaceIndex()); !built) {
    return built;
  }
  if (stateCapabilities(m_server,
                        {kSessionsMax, static_cast<std::uint32_t>(m_addressSpace->arrayLengthMax()),
                         static_cast<std::uint32_t>(kFileBytesMax)}) != UA_STATUSCODE_GOOD) {
    return setUpFailed("state its limits");
  }
  m_methods->setSessionCheck([this](const std::string& key) {
    const auto session = m_sessions.find(key);
    return session != m_sessions.end() && session->second.connection != 0 &&
           m_service.now() - session->second.heardAt < kSilenceMax;
  });
  m_arrayStore.setAddressSpace(m_addressSpace.get());
  m_service.goLive();
  auto endpoint = startListening(*m_server, options, m_logger);
  m_running = endpoint.has_value();
  if (!endpoint) {
    return base::fail(endpoint.error());
  }
  m_endpoint = *std::move(endpoint);
  return {};
}

tl::unexpected<base::Error> Server::Impl::setUpFailed(const char* what) const {
  return machine::setUpFailed(what, m_logger);
}

base::Result<void> Server::Impl::configure(const ServerOptions& options) {
  UA_ServerConfig config;
  std::memset(&config, 0, sizeof config);
  config.logging = m_logger.handle();
  if (m_gate.install(config, options) != UA_STATUSCODE_GOOD) {
    UA_ServerConfig_clean(&config);
    return setUpFailed("be configured");
  }
  const ServedFacts& facts = m_service.control().facts();
  UA_StatusCode status = replaceText(config.serverUrls[0], urlOf(options.host, options.port));
  // The library refuses to start if its certificate names another application.
  status |= replaceText(config.applicationDescription.applicationUri,
                        options.certificate ? std::string_view(options.certificate->applicationUri)
                                            : std::string_view(facts.applicationUri));
  status |= replaceText(config.applicationDescription.productUri, "urn:rivulet");
  status |= replaceText(config.applicationDescription.applicationName.text, facts.product);
  status |= replaceText(config.buildInfo.productUri, "urn:rivulet");
  status |= replaceText(config.buildInfo.manufacturerName, "Rivulet");
  status |= replaceText(config.buildInfo.productName, facts.product);
  // The preset determines the cost of access: a client that stores its measurements must see when
  // the preset has changed.
  status |= replaceText(config.buildInfo.softwareVersion, RIVULET_VERSION);
  status |= replaceText(config.buildInfo.buildNumber, facts.name);
  if (status != UA_STATUSCODE_GOOD) {
    UA_ServerConfig_clean(&config);
    return setUpFailed("be configured");
  }
  // A given port was found free but may still be in time-wait after its last user; a port chosen by
  // the system must not be shared with others.
  config.tcpReuseAddr = options.port != 0;
  config.tcpMaxMsgSize = kMessageBytesMax;
  config.maxSessionTimeout = kSessionTimeoutMsMax;
  config.maxNodesPerRead = kNodesPerRequestMax;
  config.maxNodesPerWrite = kNodesPerRequestMax;
  config.maxNodesPerBrowse = kNodesPerRequestMax;
  config.maxNodesPerRegisterNodes = kNodesPerRequestMax;
  config.maxNodesPerTranslateBrowsePathsToNodeIds = kNodesPerRequestMax;
  config.maxNodesPerMethodCall = 1;
  config.maxMonitoredItemsPerCall = kMonitoredItemsMax;
  config.maxSubscriptions = kSubscriptionsMax;
  config.maxMonitoredItems = kMonitoredItemsMax;
#if UA_MULTITHREADING >= 100
  // No method here is asynchronous, but the library (1.4) takes a call whose method is an object
  // for one and would answer it after two minutes.
  config.asyncOperationTimeout = kNoWorkerMs;
#endif
  const double samplingMsMin = base::toMilliseconds(facts.samplingMin);
  config.samplingIntervalLimits = {samplingMsMin, kSamplingIntervalMsMax};
  config.publishingIntervalLimits = {samplingMsMin, kSamplingIntervalMsMax};
  config.queueSizeLimits = {1, kQueueSizeMax};
  refuseChanges(config.accessControl);
  m_clients.configure(config, kSessionsMax, kConnectionsMax);
  config.context = this;
  m_activate = std::exchange(config.accessControl.activateSession, &Impl::onActivate);
  m_closeSession = std::exchange(config.accessControl.closeSession, &Impl::onCloseSession);
  m_arrayStore.install(config);
  m_server = UA_Server_newWithConfig(&config);
  if (m_server == nullptr) {
    return setUpFailed("be created");
  }
  m_loop = UA_Server_getConfig(m_server)->eventLoop;
  return {};
}

/// The callbacks of variables do not see which request they belong to. An answer on its way to
/// a client is the end of one, so the sending function of the network layer is wrapped.
base::Result<void> Server::Impl::watchAnswers() {
  if (!m_clients.watch(m_server)) {
    return setUpFailed("watch its connections");
  }
  m_send = std::exchange(m_clients.manager()->sendWithConnection, &Impl::onSend);
  m_clients.tell([this](std::uintptr_t connection) { connectionClosed(connection); },
                 [this](std::uintptr_t connection) {
                   for (auto& [key, session] : m_sessions) {
                     if (session.connection == connection) {
                       session.heardAt = m_service.now();
                     }
                   }
                 });
  return {};
}

UA_StatusCode Server::Impl::onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                                   const UA_KeyValueMap* parameters,
                                   UA_ByteString* message) noexcept {
  Impl& self = *static_cast<Impl*>(UA_Server_getConfig(Clients::of(*manager).server())->context);
  self.m_service.endRequest();
  const std::optional<base::Instant> due =
      self.m_methods ? self.m_methods->takeAnswerDue() : std::nullopt;
  const auto waiting =
      std::find_if(self.m_held.rbegin(), self.m_held.rend(),
                   [&](const HeldAnswer& held) { return held.connection == connectionId; });
  if (!due && waiting == self.m_held.rend()) {
    return self.m_send(manager, connectionId, parameters, message);
  }
  const base::Instant before = waiting == self.m_held.rend() ? base::Instant{} : waiting->due;
  self.m_held.push_back({connectionId, std::max(due.value_or(base::Instant{}), before),
                         std::string(opcua::view(*message))});
  manager->freeNetworkBuffer(manager, connectionId, message);
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode Server::Impl::onActivate(UA_Server* server, UA_AccessControl* control,
                                       const UA_EndpointDescription* endpoint,
                                       const UA_ByteString* certificate, const UA_NodeId* sessionId,
                                       const UA_ExtensionObject* token, void** context) noexcept {
  Impl& self = *static_cast<Impl*>(UA_Server_getConfig(server)->context);
  if (!self.m_gate.isKindTaken(*token)) {
    return UA_STATUSCODE_BADIDENTITYTOKENREJECTED;
  }
  *context = nullptr;  // a session can be taken over by another user
  const UA_StatusCode status =
      self.m_activate(server, control, endpoint, certificate, sessionId, token, context);
  if (status == UA_STATUSCODE_GOOD) {
    self.m_gate.nameUser(*token, context);
    Session& session = self.m_sessions[sessionKey(sessionId)];
    session.connection = self.m_clients.receiving();
    session.heardAt = self.m_service.now();
    UA_NodeId_clear(&session.id);
    UA_NodeId_copy(sessionId, &session.id);
  }
  return status;
}

void Server::Impl::onCloseSession(UA_Server* server, UA_AccessControl* control,
                                  const UA_NodeId* sessionId, void* context) noexcept {
  Impl& self = *static_cast<Impl*>(UA_Server_getConfig(server)->context);
  if (const auto session = self.m_sessions.find(sessionKey(sessionId));
      session != self.m_sessions.end()) {
    UA_NodeId_clear(&session->second.id);
    self.m_sessions.erase(session);
  }
  self.m_closeSession(server, control, sessionId, context);
}

void Server::Impl::connectionClosed(std::uintptr_t connection) {
  for (auto& [key, session] : m_sessions) {
    if (session.connection == connection) {
      session.connection = 0;
      session.orphanedAt = m_service.now();
    }
  }
  std::erase_if(m_held, [&](const HeldAnswer& held) { return held.connection == connection; });
}

void Server::Impl::sendDueAnswers(base::Instant now) {
  // Of one connection, none is due before an earlier one.
  for (auto answer = m_held.begin(); answer != m_held.end();) {
    if (answer->due > now) {
      ++answer;
      continue;
    }
    const HeldAnswer due = std::move(*answer);
    answer = m_held.erase(answer);
    UA_ByteString buffer = UA_BYTESTRING_NULL;
    if (m_clients.manager()->allocNetworkBuffer(m_clients.manager(), due.connection, &buffer,
                                                due.message.size()) == UA_STATUSCODE_GOOD) {
      std::memcpy(buffer.data, due.message.data(), due.message.size());
      m_send(m_clients.manager(), due.connection, &UA_KEYVALUEMAP_NULL,
             &buffer);  // takes the buffer
    }
  }
}

void Server::Impl::closeOrphans(base::Duration age, std::size_t countMax) {
  std::vector<UA_NodeId> orphans;
  for (const auto& [key, session] : m_sessions) {
    if (session.connection == 0 && m_service.now() - session.orphanedAt >= age &&
        m_sessions.size() - orphans.size() > countMax) {
      UA_NodeId id{};
      UA_NodeId_copy(&session.id, &id);
      orphans.push_back(id);
    }
  }
  for (UA_NodeId& id : orphans) {
    UA_Server_closeSession(m_server, &id);  // calls `onCloseSession`
    UA_NodeId_clear(&id);
  }
}

void Server::Impl::iterate(base::Duration timeout) {
  m_service.advance();
  m_service.endRequest();
  const auto ms = std::chrono::ceil<milliseconds>(std::max(timeout, base::Duration::zero()));
  m_loop->run(m_loop, static_cast<UA_UInt32>(ms.count()));
  m_service.endRequest();
  m_service.advance();
  sendDueAnswers(m_service.now());
  // A client may come back with its session; not if that locks out another.
  closeOrphans(kOrphanAge, 0);
  m_clients.closeLate();
  closeOrphans(base::Duration::zero(), kSessionsMax - 1);
}

Server::Server(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
Server::~Server() = default;

base::Result<std::unique_ptr<Server>> Server::start(Machine& machine,
                                                    const ServerOptions& options) {
  return start(std::make_unique<Impl>(std::make_unique<ServedMachine>(machine), options), options);
}

base::Result<std::unique_ptr<Server>> Server::start(ServedControl& control,
                                                    const ServerOptions& options) {
  return start(std::make_unique<Impl>(control, options), options);
}

base::Result<std::unique_ptr<Server>> Server::start(std::unique_ptr<Impl> impl,
                                                    const ServerOptions& options) {
  if (auto started = impl->start(options); !started) {
    return base::fail(started.error());
  }
  return std::unique_ptr<Server>(new Server(std::move(impl)));
}

const std::string& Server::endpoint() const {
  return m_impl->endpoint();
}
void Server::iterate(base::Duration timeout) {
  m_impl->iterate(timeout);
}

void Server::run(const std::atomic<bool>& stop) {
  while (!stop.load()) {
    iterate(kIdleStep);
  }
}

std::uint64_t Server::requestsServed() const {
  return m_impl->service().requestsServed();
}
std::uint64_t Server::nodesServed() const {
  return m_impl->service().nodesServed();
}

}  // namespace rivulet::machine
