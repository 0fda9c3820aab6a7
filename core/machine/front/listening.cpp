// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/listening.h"

#include <fmt/format.h>

#include "machine/front/handle_limit.h"
#include "machine/front/port_probe.h"
#include "opcua/open62541/handle.h"

namespace rivulet::machine {

namespace {

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

std::string urlOf(const std::string& host, std::uint16_t port) {
  const bool isIpv6 = host.find(':') != std::string::npos;
  return isIpv6 ? fmt::format("opc.tcp://[{}]:{}", host, port)
                : fmt::format("opc.tcp://{}:{}", host, port);
}

base::Result<void> requireListening(const ServerOptions& options, std::size_t connections) {
  if (auto enough = requireHandles(connections); !enough || options.port == 0) {
    return enough;
  }
  return probePort(options.host, options.port);
}

UA_StatusCode replaceText(UA_String& target, std::string_view text) {
  UA_String_clear(&target);
  const UA_String source = opcua::borrow(text);
  return UA_String_copy(&source, &target);
}

UA_StatusCode addObject(UA_Server* server, UA_UInt16 namespaceIndex, const UA_NodeId& parent,
                        std::string_view identifier, std::string_view name,
                        std::string_view description) {
  UA_ObjectAttributes attributes = UA_ObjectAttributes_default;
  attributes.displayName.text = opcua::borrow(name);
  attributes.description = localized(description);
  UA_QualifiedName browseName{namespaceIndex, opcua::borrow(name)};
  return UA_Server_addObjectNode(server, opcua::borrowNodeId(namespaceIndex, identifier), parent,
                                 opcua::standardNodeId(UA_NS0ID_HASCOMPONENT), browseName,
                                 opcua::standardNodeId(UA_NS0ID_BASEOBJECTTYPE), attributes,
                                 nullptr, nullptr);
}

UA_LocalizedText localized(std::string_view english) {
  return english.empty() ? UA_LocalizedText{}
                         : UA_LocalizedText{opcua::borrow("en"), opcua::borrow(english)};
}

UA_StatusCode addProperty(UA_Server* server, const UA_NodeId& owner, const UA_NodeId& id,
                          const UA_QualifiedName& name, const UA_Variant& value,
                          std::string_view description) {
  UA_VariableAttributes attributes = UA_VariableAttributes_default;
  attributes.displayName.text = name.name;
  attributes.description = localized(description);
  attributes.dataType = value.type->typeId;
  attributes.valueRank = UA_VALUERANK_SCALAR;
  attributes.accessLevel = UA_ACCESSLEVELMASK_READ;
  attributes.value = value;
  return UA_Server_addVariableNode(server, id, owner, opcua::standardNodeId(UA_NS0ID_HASPROPERTY),
                                   name, opcua::standardNodeId(UA_NS0ID_PROPERTYTYPE), attributes,
                                   nullptr, nullptr);
}

void refuseChanges(UA_AccessControl& control) {
  control.allowAddNode = &refuseAddNode;
  control.allowAddReference = &refuseAddReference;
  control.allowDeleteNode = &refuseDeleteNode;
  control.allowDeleteReference = &refuseDeleteReference;
}

tl::unexpected<base::Error> setUpFailed(const char* what, const opcua::QuietLogger& logger) {
  return base::fail(FrontError::SetUpFailed,
                    fmt::format("The OPC UA server cannot {}: {}.", what, logger.lastMessage()));
}

base::Result<std::string> startListening(UA_Server& server, const ServerOptions& options,
                                         const opcua::QuietLogger& logger) {
  if (UA_Server_run_startup(&server) != UA_STATUSCODE_GOOD) {
    return setUpFailed("listen", logger);
  }
  // With port 0 the library lists both the 0 and the real port; clients are to see only the real
  // one.
  UA_ApplicationDescription& description = UA_Server_getConfig(&server)->applicationDescription;
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
  std::string endpoint = urlOf(options.host, port);
  bool isAnnounced = port != 0;
  for (std::size_t i = 0; i < description.discoveryUrlsSize; ++i) {
    isAnnounced =
        isAnnounced && replaceText(description.discoveryUrls[i], endpoint) == UA_STATUSCODE_GOOD;
  }
  if (!isAnnounced) {
    UA_Server_run_shutdown(&server);
    return setUpFailed("announce its address", logger);
  }
  return endpoint;
}

}  // namespace rivulet::machine
