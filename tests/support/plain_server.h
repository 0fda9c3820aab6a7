// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An OPC UA server of this process that is no control: it has the standard's own namespace and
/// the variables that a test adds, as ns=1;s=NAME. @threadsafety its values belong to its thread,
/// which calls `turn`.
#pragma once

#include <open62541/plugin/pki_default.h>
#include <open62541/server.h>
#include <open62541/server_config_default.h>

#include <atomic>
#include <chrono>
#include <cstdarg>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "opcua/open62541/handle.h"
#include "opcua/security.h"

namespace rivulet::tests {

class PlainServer {
 public:
  using Turn = std::function<void(PlainServer&)>;

  /// What it says of itself.
  enum class Kind { Server, DiscoveryServer };

  /// @param turn  called every millisecond or so; may be empty
  explicit PlainServer(const std::map<std::string, double>& numbers = {},
                       const std::map<std::string, std::string>& texts = {}, Turn turn = {},
                       const std::map<std::string, std::vector<double>>& arrays = {},
                       const std::map<std::string, std::vector<float>>& floats = {},
                       Kind kind = Kind::Server, const opcua::OwnCertificate* own = nullptr)
      : m_turn(std::move(turn)) {
    m_logger.log = [](void*, UA_LogLevel, UA_LogCategory, const char*, va_list) {};
    UA_ServerConfig config{};
    config.logging = &m_logger;
    if (own == nullptr) {
      RIVULET_ASSERT(UA_ServerConfig_setMinimal(&config, 0, nullptr) == UA_STATUSCODE_GOOD);
    } else {
      // It calls itself as the library does, whatever the certificate says.
      const UA_ByteString certificate = opcua::borrow(own->certificate);
      const UA_ByteString key = opcua::borrow(own->privateKey);
      RIVULET_ASSERT(UA_ServerConfig_setDefaultWithSecurityPolicies(&config, 0, &certificate, &key,
                                                                    nullptr, 0, nullptr, 0, nullptr,
                                                                    0) == UA_STATUSCODE_GOOD);
      for (UA_CertificateVerification* pki : {&config.secureChannelPKI, &config.sessionPKI}) {
        pki->clear(pki);
        UA_CertificateVerification_AcceptAll(pki);
      }
    }
    config.context = this;
    m_activate = std::exchange(config.accessControl.activateSession, &PlainServer::onActivate);
    UA_String_clear(&config.serverUrls[0]);
    config.serverUrls[0] = UA_String_fromChars("opc.tcp://127.0.0.1:0");
    config.tcpReuseAddr = false;
    if (kind == Kind::DiscoveryServer) {
      config.applicationDescription.applicationType = UA_APPLICATIONTYPE_DISCOVERYSERVER;
    }
    m_server = UA_Server_newWithConfig(&config);
    for (auto [name, value] : numbers) {
      add(name, opcua::borrowScalar(value, UA_TYPES_DOUBLE));
    }
    for (const auto& [name, value] : texts) {
      UA_String text = opcua::borrow(value);
      add(name, opcua::borrowScalar(text, UA_TYPES_STRING));
    }
    for (auto [name, values] : arrays) {
      UA_Variant array;
      UA_Variant_init(&array);
      UA_Variant_setArray(&array, values.data(), values.size(), &UA_TYPES[UA_TYPES_DOUBLE]);
      add(name, array);
    }
    for (auto [name, values] : floats) {  // one: a scalar
      UA_Variant value;
      UA_Variant_init(&value);
      if (values.size() == 1) {
        UA_Variant_setScalar(&value, values.data(), &UA_TYPES[UA_TYPES_FLOAT]);
      } else {
        UA_Variant_setArray(&value, values.data(), values.size(), &UA_TYPES[UA_TYPES_FLOAT]);
      }
      add(name, value);
    }
    RIVULET_ASSERT(UA_Server_run_startup(m_server) == UA_STATUSCODE_GOOD);
    m_endpoint =
        opcua::view(UA_Server_getConfig(m_server)->applicationDescription.discoveryUrls[0]);
    m_thread = std::thread([this] {
      while (!m_stop.load()) {
        UA_Server_run_iterate(m_server, !m_turn);
        if (m_turn) {
          m_turn(*this);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      }
    });
  }
  ~PlainServer() {
    m_stop.store(true);
    m_thread.join();
    UA_Server_run_shutdown(m_server);
    UA_Server_delete(m_server);
  }
  PlainServer(const PlainServer&) = delete;
  PlainServer& operator=(const PlainServer&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_endpoint; }

  /// In `turn` only.
  void set(const std::string& name, double value) {
    write(name, opcua::borrowScalar(value, UA_TYPES_DOUBLE));
  }
  void set(const std::string& name, const std::string& value) {
    UA_String text = opcua::borrow(value);
    write(name, opcua::borrowScalar(text, UA_TYPES_STRING));
  }
  /// The same: of all clients, over connections that stay.
  void closeSessions() {
    for (const UA_NodeId& session : std::exchange(m_sessions, {})) {
      UA_Server_closeSession(m_server, &session);
    }
  }
  [[nodiscard]] double number(const std::string& name) {
    opcua::Handle<UA_Variant, UA_TYPES_VARIANT> value;
    UA_Server_readValue(m_server, opcua::borrowNodeId(1, name), value.get());
    const double* number = opcua::scalarOf<double>(*value.get(), UA_TYPES_DOUBLE);
    RIVULET_ASSERT(number != nullptr);
    return *number;
  }

 private:
  static UA_StatusCode onActivate(UA_Server* server, UA_AccessControl* control,
                                  const UA_EndpointDescription* endpoint,
                                  const UA_ByteString* certificate, const UA_NodeId* session,
                                  const UA_ExtensionObject* token, void** context) {
    auto& self = *static_cast<PlainServer*>(UA_Server_getConfig(server)->context);
    self.m_sessions.push_back(*session);  // a GUID: owns nothing
    return self.m_activate(server, control, endpoint, certificate, session, token, context);
  }
  void add(const std::string& name, UA_Variant value) {
    UA_VariableAttributes attributes = UA_VariableAttributes_default;
    attributes.value = value;
    attributes.dataType = value.type->typeId;
    UA_UInt32 anyLength = 0;
    if (!UA_Variant_isScalar(&value)) {
      attributes.valueRank = UA_VALUERANK_ONE_DIMENSION;
      attributes.arrayDimensions = &anyLength;
      attributes.arrayDimensionsSize = 1;
    }
    attributes.accessLevel = UA_ACCESSLEVELMASK_READ | UA_ACCESSLEVELMASK_WRITE;
    RIVULET_ASSERT(UA_Server_addVariableNode(m_server, opcua::borrowNodeId(1, name),
                                             opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER),
                                             opcua::standardNodeId(UA_NS0ID_ORGANIZES),
                                             UA_QualifiedName{1, opcua::borrow(name)},
                                             opcua::standardNodeId(UA_NS0ID_BASEDATAVARIABLETYPE),
                                             attributes, nullptr, nullptr) == UA_STATUSCODE_GOOD);
  }
  void write(const std::string& name, const UA_Variant& value) {
    RIVULET_ASSERT(UA_Server_writeValue(m_server, opcua::borrowNodeId(1, name), value) ==
                   UA_STATUSCODE_GOOD);
  }

  Turn m_turn;
  UA_Logger m_logger{};
  UA_Server* m_server = nullptr;
  decltype(UA_AccessControl::activateSession) m_activate = nullptr;
  std::vector<UA_NodeId> m_sessions;
  std::string m_endpoint;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

}  // namespace rivulet::tests
