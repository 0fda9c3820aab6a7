// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/server.h"

#include <fmt/format.h>
#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/contract.h"
#include "machine/front/address_space.h"
#include "machine/front/array_store.h"
#include "machine/front/methods.h"
#include "machine/front/port_probe.h"
#include "machine/front/variable_service.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::machine {

namespace {

using std::chrono::milliseconds;

/// Limits as documented for the 840D sl, if there is such a figure.
constexpr UA_UInt16 kSessionsMax = 10;
constexpr UA_UInt32 kSubscriptionsMax = 10;
constexpr UA_UInt32 kMonitoredItemsMax = 100;
constexpr double kSamplingIntervalMsMax = 5000.0;
constexpr double kSessionTimeoutMsMax = 60'000.0;
constexpr UA_UInt32 kQueueSizeMax = 10'000;
constexpr UA_UInt32 kNodesPerRequestMax = 1000;
/// A file of the largest size, its request and some room.
constexpr UA_UInt32 kMessageBytesMax = static_cast<UA_UInt32>(kFileBytesMax) + (1U << 20U);

/// How often the machine is advanced while no client asks.
constexpr base::Duration kIdleStep = milliseconds(10);

/// Key under which the connection manager knows the server it belongs to.
constexpr std::string_view kOwnerKey = "rivulet-owner";

[[nodiscard]] UA_QualifiedName ownerKey() {
  return {0, opcua::borrow(kOwnerKey)};
}

[[nodiscard]] std::string urlOf(const std::string& host, std::uint16_t port) {
  const bool isIpv6 = host.find(':') != std::string::npos;
  return isIpv6 ? fmt::format("opc.tcp://[{}]:{}", host, port)
                : fmt::format("opc.tcp://{}:{}", host, port);
}

// A client may use the machine but never change its address space.
UA_Boolean refuseAddNode(UA_Server*, UA_AccessControl*, const UA_NodeId*, void*,
                         const UA_AddNodesItem*) noexcept {
  return false;
}
UA_Boolean refuseAddReference(UA_Server*, UA_AccessControl*, const UA_NodeId*, void*,
                              const UA_AddReferencesItem*) noexcept {
  return false;
}
UA_Boolean refuseDeleteNode(UA_Server*, UA_AccessControl*, const UA_NodeId*, void*,
                            const UA_DeleteNodesItem*) noexcept {
  return false;
}
UA_Boolean refuseDeleteReference(UA_Server*, UA_AccessControl*, const UA_NodeId*, void*,
                                 const UA_DeleteReferencesItem*) noexcept {
  return false;
}

}  // namespace

std::error_code make_error_code(FrontError code) {
  static const base::NamedCategory category("machine.front");
  return {static_cast<int>(code), category};
}

class Server::Impl {
 public:
  explicit Impl(Machine& machine) : m_service(machine) {}
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] base::Result<void> start(const ServerOptions& options);
  void iterate(base::Duration timeout);

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }
  [[nodiscard]] const VariableService& service() const { return m_service; }

 private:
  [[nodiscard]] base::Result<void> configure(const ServerOptions& options);
  [[nodiscard]] base::Result<void> watchAnswers();
  [[nodiscard]] base::Result<void> listen(const ServerOptions& options);
  [[nodiscard]] tl::unexpected<base::Error> setUpFailed(const char* what) const;

  static UA_StatusCode onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                              const UA_KeyValueMap* parameters, UA_ByteString* message) noexcept;

  opcua::QuietLogger m_logger;  ///< outlives the server that logs into it
  VariableService m_service;
  ArrayStore m_arrayStore;
  UA_Server* m_server = nullptr;
  UA_EventLoop* m_loop = nullptr;
  std::unique_ptr<AddressSpace> m_addressSpace;
  std::unique_ptr<Methods> m_methods;
  UA_StatusCode (*m_send)(UA_ConnectionManager*, std::uintptr_t, const UA_KeyValueMap*,
                          UA_ByteString*) = nullptr;
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
}

base::Result<void> Server::Impl::start(const ServerOptions& options) {
  if (options.port != 0) {
    if (auto free = probePort(options.host, options.port); !free) {
      return free;
    }
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
  m_arrayStore.setAddressSpace(m_addressSpace.get());
  m_service.goLive();
  return listen(options);
}

tl::unexpected<base::Error> Server::Impl::setUpFailed(const char* what) const {
  return base::fail(FrontError::SetUpFailed,
                    fmt::format("The OPC UA server cannot {}: {}.", what, m_logger.lastMessage()));
}

base::Result<void> Server::Impl::configure(const ServerOptions& options) {
  UA_ServerConfig config;
  std::memset(&config, 0, sizeof config);
  config.logging = m_logger.handle();
  if (UA_ServerConfig_setMinimal(&config, options.port, nullptr) != UA_STATUSCODE_GOOD) {
    return setUpFailed("be configured");  // the library has released everything
  }
  const auto replace = [](UA_String& target, std::string_view text) {
    UA_String_clear(&target);
    const UA_String source = opcua::borrow(text);
    return UA_String_copy(&source, &target);
  };
  UA_StatusCode status = replace(config.serverUrls[0], urlOf(options.host, options.port));
  status |= replace(config.applicationDescription.applicationUri, "urn:rivulet:machine");
  status |= replace(config.applicationDescription.productUri, "urn:rivulet");
  status |= replace(config.applicationDescription.applicationName.text, "Rivulet virtual machine");
  status |= replace(config.buildInfo.productUri, "urn:rivulet");
  status |= replace(config.buildInfo.manufacturerName, "Rivulet");
  status |= replace(config.buildInfo.productName, "Rivulet virtual machine");
  // The preset determines the cost of access: a client that stores its measurements must see when
  // the preset has changed.
  status |= replace(config.buildInfo.softwareVersion, RIVULET_VERSION);
  status |= replace(config.buildInfo.buildNumber, m_service.machine().config().name);
  if (status != UA_STATUSCODE_GOOD) {
    UA_ServerConfig_clean(&config);
    return setUpFailed("be configured");
  }
  // A given port was found free but may still be in time-wait after its last user; a port chosen by
  // the system must not be shared with others.
  config.tcpReuseAddr = options.port != 0;
  config.tcpMaxMsgSize = kMessageBytesMax;
  config.maxSessions = kSessionsMax;
  config.maxSecureChannels = 2 * kSessionsMax;
  config.maxSessionTimeout = kSessionTimeoutMsMax;
  config.maxNodesPerRead = kNodesPerRequestMax;
  config.maxNodesPerWrite = kNodesPerRequestMax;
  config.maxNodesPerBrowse = kNodesPerRequestMax;
  config.maxNodesPerMethodCall = 1;
  config.maxMonitoredItemsPerCall = kMonitoredItemsMax;
  config.maxSubscriptions = kSubscriptionsMax;
  config.maxMonitoredItems = kMonitoredItemsMax;
  const double samplingMsMin =
      base::toMilliseconds(m_service.machine().config().access.samplingMin);
  config.samplingIntervalLimits = {samplingMsMin, kSamplingIntervalMsMax};
  config.publishingIntervalLimits = {samplingMsMin, kSamplingIntervalMsMax};
  config.queueSizeLimits = {1, kQueueSizeMax};
  config.accessControl.allowAddNode = &refuseAddNode;
  config.accessControl.allowAddReference = &refuseAddReference;
  config.accessControl.allowDeleteNode = &refuseDeleteNode;
  config.accessControl.allowDeleteReference = &refuseDeleteReference;
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
  for (UA_EventSource* source = m_loop->eventSources; source != nullptr; source = source->next) {
    if (source->eventSourceType != UA_EVENTSOURCETYPE_CONNECTIONMANAGER) {
      continue;
    }
    // The event source is the first member of the manager, as the library itself relies on.
    auto* manager = reinterpret_cast<UA_ConnectionManager*>(source);
    if (opcua::view(manager->protocol) != "tcp") {
      continue;
    }
    UA_UInt64 owner = reinterpret_cast<std::uintptr_t>(this);
    if (UA_KeyValueMap_setScalar(&source->params, ownerKey(), &owner, &UA_TYPES[UA_TYPES_UINT64]) !=
        UA_STATUSCODE_GOOD) {
      break;
    }
    m_send = manager->sendWithConnection;
    manager->sendWithConnection = &Impl::onSend;
    return {};
  }
  return setUpFailed("watch its connections");
}

UA_StatusCode Server::Impl::onSend(UA_ConnectionManager* manager, std::uintptr_t connectionId,
                                   const UA_KeyValueMap* parameters,
                                   UA_ByteString* message) noexcept {
  const void* owner = UA_KeyValueMap_getScalar(&manager->eventSource.params, ownerKey(),
                                               &UA_TYPES[UA_TYPES_UINT64]);
  RIVULET_ASSERT(owner != nullptr);
  auto* self =
      reinterpret_cast<Impl*>(static_cast<std::uintptr_t>(*static_cast<const UA_UInt64*>(owner)));
  self->m_service.endRequest();
  return self->m_send(manager, connectionId, parameters, message);
}

base::Result<void> Server::Impl::listen(const ServerOptions& options) {
  if (UA_Server_run_startup(m_server) != UA_STATUSCODE_GOOD) {
    return setUpFailed("listen");
  }
  m_running = true;
  // With port 0 the library lists both the 0 and the real port; clients are to see only the real
  // one.
  UA_ApplicationDescription& description = UA_Server_getConfig(m_server)->applicationDescription;
  std::uint16_t port = options.port;
  for (std::size_t i = 0; i < description.discoveryUrlsSize; ++i) {
    UA_String host{};
    UA_UInt16 listed = 0;
    if (UA_parseEndpointUrl(&description.discoveryUrls[i], &host, &listed, nullptr) ==
            UA_STATUSCODE_GOOD &&
        listed != 0) {
      port = listed;
    }
  }
  if (port == 0) {
    return setUpFailed("find out its port");
  }
  m_endpoint = urlOf(options.host, port);
  const UA_String url = opcua::borrow(m_endpoint);
  for (std::size_t i = 0; i < description.discoveryUrlsSize; ++i) {
    UA_String_clear(&description.discoveryUrls[i]);
    if (UA_String_copy(&url, &description.discoveryUrls[i]) != UA_STATUSCODE_GOOD) {
      return setUpFailed("announce its address");
    }
  }
  return {};
}

void Server::Impl::iterate(base::Duration timeout) {
  m_service.advance();
  m_service.endRequest();
  const auto ms = std::chrono::ceil<milliseconds>(std::max(timeout, base::Duration::zero()));
  m_loop->run(m_loop, static_cast<UA_UInt32>(ms.count()));
  m_service.endRequest();
  m_service.advance();
}

Server::Server(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
Server::~Server() = default;

base::Result<std::unique_ptr<Server>> Server::start(Machine& machine,
                                                    const ServerOptions& options) {
  auto impl = std::make_unique<Impl>(machine);
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
