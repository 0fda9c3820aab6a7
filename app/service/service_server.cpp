// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/service_server.h"

#include <fmt/format.h>
#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "machine/front/client_gate.h"
#include "machine/front/listening.h"
#include "machine/user.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"
#include "platform/log.h"
#include "service/node_table.h"

namespace rivulet::service {

namespace {

constexpr UA_UInt16 kSessionsMax = 50;
constexpr UA_UInt16 kConnectionsMax = 2 * kSessionsMax;
constexpr UA_UInt32 kSubscriptionsMax = 100;
constexpr UA_UInt32 kMonitoredItemsMax = 5000;
constexpr double kSessionTimeoutMsMax = 60'000.0;
constexpr UA_UInt32 kNodesPerRequestMax = 1000;
/// In front of the identifiers: the folder of machines of OPC 40001-1.
constexpr std::string_view kMachinesFolder = "Machines";
constexpr std::string_view kMachineObject = "Machine";

base::Instant now() {
  return base::Instant{std::chrono::steady_clock::now().time_since_epoch()};
}

std::string bytesOfHex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::strtol(hex.substr(i, 2).c_str(), nullptr, 16));
  }
  return bytes;
}

/// The users as the gate knows them; the role is their only right. Who has no PIN cannot log in.
machine::UserManagement managementOf(const preparation::UserFile& file) {
  machine::UserManagement management;
  for (const preparation::KeptUser& user : file.users) {
    management.users.push_back(
        {user.name,
         {preparation::kPinIterations, bytesOfHex(user.saltHex), user.hashHex},
         {std::string(permission::roleName(user.role))}});
  }
  return management;
}

UA_StatusCode setValue(UA_Variant& variant, const NodeValue& value) {
  UA_Variant_init(&variant);
  if (const auto* flag = std::get_if<bool>(&value)) {
    return UA_Variant_setScalarCopy(&variant, flag, &UA_TYPES[UA_TYPES_BOOLEAN]);
  }
  if (const auto* count = std::get_if<std::uint32_t>(&value)) {
    return UA_Variant_setScalarCopy(&variant, count, &UA_TYPES[UA_TYPES_UINT32]);
  }
  if (const auto* number = std::get_if<double>(&value)) {
    return UA_Variant_setScalarCopy(&variant, number, &UA_TYPES[UA_TYPES_DOUBLE]);
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    return UA_Variant_setArrayCopy(&variant, numbers->data(), numbers->size(),
                                   &UA_TYPES[UA_TYPES_DOUBLE]);
  }
  const UA_String text = opcua::borrow(std::get<std::string>(value));
  return UA_Variant_setScalarCopy(&variant, &text, &UA_TYPES[UA_TYPES_STRING]);
}

}  // namespace

class ServiceServer::Impl {
 public:
  Impl(ServiceSession& session, const preparation::UserFile& users,
       const machine::ServerOptions& options)
      : m_session(session),
        m_hasUsers(!users.users.empty()),
        m_gate(managementOf(users), &now, options) {}
  ~Impl() {
    if (m_server != nullptr) {
      if (m_isListening) {
        UA_Server_run_shutdown(m_server);
      }
      UA_Server_delete(m_server);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] base::Result<void> start(const machine::ServerOptions& options);
  void iterate(base::Duration timeout);
  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }

 private:
  /// What a method node refers to.
  struct Bound {
    Impl* server = nullptr;
    const MethodRow* row = nullptr;
  };

  [[nodiscard]] base::Result<void> configure(const machine::ServerOptions& options);
  [[nodiscard]] UA_StatusCode build();
  [[nodiscard]] UA_StatusCode addFolders(std::string_view identifier);
  [[nodiscard]] UA_StatusCode addVariable(const VariableRow& row, const NodeValue& value);
  [[nodiscard]] UA_StatusCode addMethod(const MethodRow& row);
  [[nodiscard]] Caller callerOf(const UA_NodeId* sessionId, void* user) const;
  void show();

  static UA_Byte onAccessLevel(UA_Server* server, UA_AccessControl* control,
                               const UA_NodeId* session, void* user, const UA_NodeId* node,
                               void* row) noexcept;
  static UA_StatusCode onActivate(UA_Server* server, UA_AccessControl* control,
                                  const UA_EndpointDescription* endpoint,
                                  const UA_ByteString* certificate, const UA_NodeId* sessionId,
                                  const UA_ExtensionObject* token, void** context) noexcept;
  static UA_StatusCode onCall(UA_Server* server, const UA_NodeId* sessionId, void* user,
                              const UA_NodeId* methodId, void* context, const UA_NodeId* objectId,
                              void* objectContext, std::size_t inputSize, const UA_Variant* input,
                              std::size_t outputSize, UA_Variant* output) noexcept;

  ServiceSession& m_session;
  bool m_hasUsers;
  opcua::QuietLogger m_logger;  ///< outlives the server that logs into it
  machine::ClientGate m_gate;   ///< outlives the server that asks it
  UA_Server* m_server = nullptr;
  UA_UInt16 m_namespace = 0;
  std::set<std::string, std::less<>> m_objects;
  std::vector<Bound> m_bound;
  std::vector<NodeValue> m_shown;
  decltype(UA_AccessControl::activateSession) m_activate = nullptr;
  std::string m_endpoint;
  bool m_isListening = false;
};

base::Result<void> ServiceServer::Impl::start(const machine::ServerOptions& options) {
  if (auto able = machine::requireListening(options, kConnectionsMax); !able) {
    return able;
  }
  if (auto configured = configure(options); !configured) {
    return configured;
  }
  if (build() != UA_STATUSCODE_GOOD) {
    return machine::setUpFailed("set up its nodes", m_logger);
  }
  auto endpoint = machine::startListening(*m_server, options, m_logger);
  m_isListening = endpoint.has_value();
  if (!endpoint) {
    return base::fail(endpoint.error());
  }
  m_endpoint = *std::move(endpoint);
  return {};
}

base::Result<void> ServiceServer::Impl::configure(const machine::ServerOptions& options) {
  UA_ServerConfig config;
  std::memset(&config, 0, sizeof config);
  config.logging = m_logger.handle();
  UA_StatusCode status = m_gate.install(config, options);
  if (status == UA_STATUSCODE_GOOD) {
    status |=
        machine::replaceText(config.serverUrls[0], machine::urlOf(options.host, options.port));
    // The library refuses to start if its certificate names another application.
    status |= machine::replaceText(config.applicationDescription.applicationUri,
                                   options.certificate
                                       ? std::string_view(options.certificate->applicationUri)
                                       : kNamespaceUri);
    status |= machine::replaceText(config.applicationDescription.productUri, kNamespaceUri);
    status |=
        machine::replaceText(config.applicationDescription.applicationName.text, kProductName);
    status |= machine::replaceText(config.buildInfo.manufacturerName, "Rivulet");
    status |= machine::replaceText(config.buildInfo.productName, kProductName);
    status |= machine::replaceText(config.buildInfo.softwareVersion, RIVULET_VERSION);
  }
  if (status != UA_STATUSCODE_GOOD) {
    UA_ServerConfig_clean(&config);
    return machine::setUpFailed("be configured", m_logger);
  }
  config.tcpReuseAddr = options.port != 0;
  config.maxSessionTimeout = kSessionTimeoutMsMax;
  config.maxNodesPerRead = kNodesPerRequestMax;
  config.maxNodesPerBrowse = kNodesPerRequestMax;
  config.maxNodesPerMethodCall = 1;
  config.maxSubscriptions = kSubscriptionsMax;
  config.maxMonitoredItems = kMonitoredItemsMax;
  machine::refuseChanges(config.accessControl);
  config.accessControl.getUserAccessLevel = &Impl::onAccessLevel;
  m_gate.clients().configure(config, kSessionsMax, kConnectionsMax);
  config.context = this;
  m_activate = std::exchange(config.accessControl.activateSession, &Impl::onActivate);
  m_server = UA_Server_newWithConfig(&config);
  return m_server != nullptr && m_gate.clients().watch(m_server)
             ? base::Result<void>()
             : base::Result<void>(machine::setUpFailed("be created", m_logger));
}

/// The objects in front of the last slash of an identifier.
UA_StatusCode ServiceServer::Impl::addFolders(std::string_view identifier) {
  UA_StatusCode status = UA_STATUSCODE_GOOD;
  for (std::size_t end = identifier.find('/'); end != std::string_view::npos;
       end = identifier.find('/', end + 1)) {
    const std::string_view object = identifier.substr(0, end);
    if (m_objects.contains(object)) {
      continue;
    }
    m_objects.emplace(object);
    const std::size_t slash = object.rfind('/');
    const bool isTop = slash == std::string_view::npos;
    status |= machine::addObject(
        m_server, m_namespace,
        opcua::borrowNodeId(m_namespace, isTop ? kMachineObject : object.substr(0, slash)), object,
        isTop ? object : object.substr(slash + 1));
  }
  return status;
}

UA_StatusCode ServiceServer::Impl::addVariable(const VariableRow& row, const NodeValue& value) {
  UA_StatusCode status = addFolders(row.identifier);
  const std::size_t slash = row.identifier.rfind('/');
  const std::string_view name = row.identifier.substr(slash + 1);
  UA_VariableAttributes attributes = UA_VariableAttributes_default;
  attributes.displayName.text = opcua::borrow(name);
  attributes.description.text = opcua::borrow(row.description);
  attributes.accessLevel = UA_ACCESSLEVELMASK_READ;
  const bool isArray = std::holds_alternative<std::vector<double>>(value);
  attributes.valueRank = isArray ? UA_VALUERANK_ONE_DIMENSION : UA_VALUERANK_SCALAR;
  const UA_UInt32 anyLength = 0;
  if (isArray) {
    attributes.arrayDimensionsSize = 1;
    attributes.arrayDimensions = const_cast<UA_UInt32*>(&anyLength);
  }
  status |= setValue(attributes.value, value);
  attributes.dataType = attributes.value.type->typeId;
  UA_QualifiedName browseName{m_namespace, opcua::borrow(name)};
  status |=
      UA_Server_addVariableNode(m_server, opcua::borrowNodeId(m_namespace, row.identifier),
                                opcua::borrowNodeId(m_namespace, row.identifier.substr(0, slash)),
                                opcua::standardNodeId(UA_NS0ID_HASCOMPONENT), browseName,
                                opcua::standardNodeId(UA_NS0ID_BASEDATAVARIABLETYPE), attributes,
                                const_cast<VariableRow*>(&row), nullptr);
  UA_Variant_clear(&attributes.value);
  return status;
}

UA_StatusCode ServiceServer::Impl::addMethod(const MethodRow& row) {
  const auto argument = [](std::string_view name, std::size_t type) {
    UA_Argument made;
    UA_Argument_init(&made);
    made.name = opcua::borrow(name);
    made.dataType = UA_TYPES[type].typeId;
    made.valueRank = UA_VALUERANK_SCALAR;
    return made;
  };
  std::vector<UA_Argument> inputs;
  for (const std::string_view name : row.inputs) {
    inputs.push_back(argument(name, UA_TYPES_STRING));
  }
  const std::vector<UA_Argument> outputs{argument("Accepted", UA_TYPES_BOOLEAN),
                                         argument("Message", UA_TYPES_STRING),
                                         argument("Confirmation", UA_TYPES_STRING)};
  UA_MethodAttributes attributes = UA_MethodAttributes_default;
  attributes.displayName.text = opcua::borrow(row.name);
  attributes.description.text = opcua::borrow(row.description);
  attributes.executable = true;
  attributes.userExecutable = true;
  const std::string identifier = methodIdentifier(row.name);
  UA_QualifiedName browseName{m_namespace, opcua::borrow(row.name)};
  m_bound.push_back({this, &row});
  return UA_Server_addMethodNode(m_server, opcua::borrowNodeId(m_namespace, identifier),
                                 opcua::borrowNodeId(m_namespace, kMethodsObject),
                                 opcua::standardNodeId(UA_NS0ID_HASCOMPONENT), browseName,
                                 attributes, &Impl::onCall, inputs.size(), inputs.data(),
                                 outputs.size(), outputs.data(), &m_bound.back(), nullptr);
}

UA_StatusCode ServiceServer::Impl::build() {
  m_namespace = UA_Server_addNamespace(m_server, std::string(kNamespaceUri).c_str());
  UA_StatusCode status =
      machine::addObject(m_server, m_namespace, opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER),
                         kMachinesFolder, kMachinesFolder);
  status |=
      machine::addObject(m_server, m_namespace, opcua::borrowNodeId(m_namespace, kMachinesFolder),
                         kMachineObject, kMachineObject);
  const Snapshot seen = m_session.snapshot();
  for (const VariableRow& row : variableRows()) {
    m_shown.push_back(valueOf(row, seen));
    status |= addVariable(row, m_shown.back());
  }
  m_bound.reserve(methodRows().size());  // the nodes point to its elements
  for (const MethodRow& row : methodRows()) {
    status |= addMethod(row);
  }
  return status;
}

void ServiceServer::Impl::show() {
  const Snapshot seen = m_session.snapshot();
  for (std::size_t i = 0; i < m_shown.size(); ++i) {
    const VariableRow& row = variableRows()[i];
    NodeValue value = valueOf(row, seen);
    if (value == m_shown[i]) {
      continue;
    }
    UA_Variant variant;
    if (setValue(variant, value) == UA_STATUSCODE_GOOD) {
      UA_Server_writeValue(m_server, opcua::borrowNodeId(m_namespace, row.identifier), variant);
    }
    UA_Variant_clear(&variant);
    m_shown[i] = std::move(value);
  }
}

void ServiceServer::Impl::iterate(base::Duration timeout) {
  UA_EventLoop* loop = UA_Server_getConfig(m_server)->eventLoop;
  const auto ms = std::chrono::ceil<std::chrono::milliseconds>(timeout);
  loop->run(loop, static_cast<UA_UInt32>(ms.count()));
  m_gate.clients().closeLate();
  show();
}

/// @param row  of the table, as `addVariable` has noted it; null: a node of the library
UA_Byte ServiceServer::Impl::onAccessLevel(UA_Server* server, UA_AccessControl* /*control*/,
                                           const UA_NodeId* /*session*/, void* user,
                                           const UA_NodeId* node, void* row) noexcept {
  const Impl& self = *static_cast<Impl*>(UA_Server_getConfig(server)->context);
  const bool isOurs = node->namespaceIndex == self.m_namespace && row != nullptr;
  const bool isHidden = isOurs && user == nullptr && self.m_hasUsers &&
                        static_cast<const VariableRow*>(row)->readers == Readers::LoggedIn;
  return isHidden ? UA_Byte{0} : UA_Byte{UA_ACCESSLEVELMASK_READ};
}

UA_StatusCode ServiceServer::Impl::onActivate(UA_Server* server, UA_AccessControl* control,
                                              const UA_EndpointDescription* endpoint,
                                              const UA_ByteString* certificate,
                                              const UA_NodeId* sessionId,
                                              const UA_ExtensionObject* token,
                                              void** context) noexcept {
  Impl& self = *static_cast<Impl*>(UA_Server_getConfig(server)->context);
  if (!self.m_gate.isKindTaken(*token)) {
    return UA_STATUSCODE_BADIDENTITYTOKENREJECTED;
  }
  *context = nullptr;  // a session can be taken over by another user
  const UA_StatusCode status =
      self.m_activate(server, control, endpoint, certificate, sessionId, token, context);
  if (status == UA_STATUSCODE_GOOD) {
    self.m_gate.nameUser(*token, context);
    if (*context != nullptr) {
      self.m_session.noteLogin(self.callerOf(sessionId, *context));
    }
  }
  return status;
}

Caller ServiceServer::Impl::callerOf(const UA_NodeId* /*sessionId*/, void* user) const {
  Caller caller;
  caller.hasRole = m_hasUsers;
  if (user == nullptr) {
    caller.name = "anonymous";
    caller.standing.isLocked = m_hasUsers;
    return caller;
  }
  const auto& known = *static_cast<const machine::User*>(user);
  caller.name = known.name;
  caller.standing.role =
      known.rights.contains(std::string(permission::roleName(permission::Role::Engineer)))
          ? permission::Role::Engineer
          : permission::Role::Operator;
  return caller;
}

UA_StatusCode ServiceServer::Impl::onCall(UA_Server* /*server*/, const UA_NodeId* sessionId,
                                          void* user, const UA_NodeId* /*methodId*/, void* context,
                                          const UA_NodeId* /*objectId*/, void* /*objectContext*/,
                                          std::size_t inputSize, const UA_Variant* input,
                                          std::size_t /*outputSize*/, UA_Variant* output) noexcept {
  if (!opcua::areScalars(input, inputSize)) {
    return UA_STATUSCODE_BADINVALIDARGUMENT;
  }
  const auto& bound = *static_cast<const Bound*>(context);
  std::vector<std::string> inputs;
  for (std::size_t i = 0; i < inputSize; ++i) {
    inputs.emplace_back(opcua::view(*static_cast<const UA_String*>(input[i].data)));
  }
  Impl& self = *bound.server;
  const Caller caller = self.callerOf(sessionId, user);
  const Answer answer = bound.row->call(self.m_session, caller, inputs);
  log::logger().info("{} called {}: {} {}", caller.name, bound.row->name,
                     answer.accepted ? "accepted." : "refused.", answer.message);
  self.show();  // what the method has changed is there when its answer is
  const UA_Boolean accepted = answer.accepted;
  const UA_String message = opcua::borrow(answer.message);
  const UA_String confirmation = opcua::borrow(answer.confirmation);
  return UA_Variant_setScalarCopy(&output[0], &accepted, &UA_TYPES[UA_TYPES_BOOLEAN]) |
         UA_Variant_setScalarCopy(&output[1], &message, &UA_TYPES[UA_TYPES_STRING]) |
         UA_Variant_setScalarCopy(&output[2], &confirmation, &UA_TYPES[UA_TYPES_STRING]);
}

ServiceServer::ServiceServer(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
ServiceServer::~ServiceServer() = default;

base::Result<std::unique_ptr<ServiceServer>> ServiceServer::start(
    ServiceSession& session, const preparation::UserFile& users,
    const machine::ServerOptions& options) {
  auto impl = std::make_unique<Impl>(session, users, options);
  if (auto started = impl->start(options); !started) {
    return base::fail(started.error());
  }
  return std::unique_ptr<ServiceServer>(new ServiceServer(std::move(impl)));
}

const std::string& ServiceServer::endpoint() const {
  return m_impl->endpoint();
}

void ServiceServer::iterate(base::Duration timeout) {
  m_impl->iterate(timeout);
}

}  // namespace rivulet::service
