// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "opcua/open62541/method_call.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

namespace {

/// More nodes below one node are not listed.
constexpr std::size_t kChildrenMax = 20'000;
/// Nodes that are examined in one request; each has three attributes that are read.
constexpr std::size_t kExaminedAtOnce = 100;
/// Of a value that is shown to a person.
constexpr std::size_t kShownCharacters = 60;
constexpr std::size_t kShownElements = 3;

}  // namespace

std::string UaLink::Impl::addressText(const UA_NodeId& id) const {
  UA_String printed = UA_STRING_NULL;
  if (isBad(UA_NodeId_print(&id, &printed))) {
    return {};
  }
  std::string text(view(printed));
  UA_String_clear(&printed);
  const std::size_t index = id.namespaceIndex;
  if (index > 0 && index < m_namespaces.size() &&
      m_namespaces[index].find(';') == std::string::npos) {
    text = fmt::format("nsu={};{}", m_namespaces[index], text.substr(text.find(';') + 1));
  }
  return text;
}

void UaLink::Impl::appendChildren(const UA_BrowseResult& result,
                                  std::vector<BrowsedNode>& nodes) const {
  for (std::size_t i = 0; i < result.referencesSize; ++i) {
    const UA_ReferenceDescription& reference = result.references[i];
    if (reference.nodeId.serverIndex != 0) {
      continue;
    }
    BrowsedNode node;
    node.address = addressText(reference.nodeId.nodeId);
    node.nameSpace = reference.browseName.namespaceIndex;
    node.name = view(reference.browseName.name);
    node.kind = reference.nodeClass == UA_NODECLASS_VARIABLE ? NodeKind::Variable
                : reference.nodeClass == UA_NODECLASS_OBJECT ? NodeKind::Object
                : reference.nodeClass == UA_NODECLASS_METHOD ? NodeKind::Method
                                                             : NodeKind::Other;
    if (reference.browseName.namespaceIndex < m_namespaces.size()) {
      node.nameUri = m_namespaces[reference.browseName.namespaceIndex];
    }
    nodes.push_back(std::move(node));
  }
}

base::Result<std::vector<BrowsedNode>> UaLink::Impl::children(const std::string& address) {
  const auto id = parsed(address);
  if (!id) {
    return base::fail(LinkError::VariableMissing, "The server has no such node.", address);
  }
  UA_BrowseDescription item;
  UA_BrowseDescription_init(&item);
  item.nodeId = (*id)->nodeId;
  item.browseDirection = UA_BROWSEDIRECTION_FORWARD;
  item.referenceTypeId = standardNodeId(UA_NS0ID_HIERARCHICALREFERENCES);
  item.includeSubtypes = true;
  item.resultMask = UA_BROWSERESULTMASK_NODECLASS | UA_BROWSERESULTMASK_BROWSENAME;
  UA_BrowseRequest request;
  UA_BrowseRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  request.nodesToBrowse = &item;
  request.nodesToBrowseSize = 1;
  Handle<UA_BrowseResponse, UA_TYPES_BROWSERESPONSE> response;
  const Instant deadline = addSaturating(now(), m_options.commandDeadline);
  UA_StatusCode status = exchange(&request, &UA_TYPES[UA_TYPES_BROWSEREQUEST], response.get(),
                                  response.type(), deadline);
  if (!isBad(status)) {
    status = response->resultsSize == 1 ? response->results[0].statusCode
                                        : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, address));
  }
  std::vector<BrowsedNode> nodes;
  appendChildren(response->results[0], nodes);
  std::string more(view(response->results[0].continuationPoint));
  while (!more.empty()) {
    UA_ByteString point = borrow(more);
    UA_BrowseNextRequest next;
    UA_BrowseNextRequest_init(&next);
    next.requestHeader.timeoutHint = kLibraryTimeoutMs;
    next.continuationPoints = &point;
    next.continuationPointsSize = 1;
    next.releaseContinuationPoints = nodes.size() > kChildrenMax;
    Handle<UA_BrowseNextResponse, UA_TYPES_BROWSENEXTRESPONSE> rest;
    status = exchange(&next, &UA_TYPES[UA_TYPES_BROWSENEXTREQUEST], rest.get(), rest.type(),
                      addSaturating(now(), m_options.commandDeadline));
    if (nodes.size() > kChildrenMax) {
      return base::fail(LinkError::TooManyItems,
                        fmt::format("More than {} nodes are below this one.", kChildrenMax),
                        address);
    }
    if (!isBad(status)) {
      status =
          rest->resultsSize == 1 ? rest->results[0].statusCode : UA_STATUSCODE_BADUNKNOWNRESPONSE;
    }
    if (isBad(status)) {
      return base::fail(requestError(status, Operation::Read, address));
    }
    appendChildren(rest->results[0], nodes);
    more = view(rest->results[0].continuationPoint);
  }
  return nodes;
}

namespace {

/// Names of the built-in types, by their numbers. @source OPC UA part 6, 5.1.2
constexpr std::array<std::string_view, 26> kTypeNames{"",
                                                      "Boolean",
                                                      "SByte",
                                                      "Byte",
                                                      "Int16",
                                                      "UInt16",
                                                      "Int32",
                                                      "UInt32",
                                                      "Int64",
                                                      "UInt64",
                                                      "Float",
                                                      "Double",
                                                      "String",
                                                      "DateTime",
                                                      "Guid",
                                                      "ByteString",
                                                      "XmlElement",
                                                      "NodeId",
                                                      "ExpandedNodeId",
                                                      "StatusCode",
                                                      "QualifiedName",
                                                      "LocalizedText",
                                                      "Structure",
                                                      "DataValue",
                                                      "BaseDataType",
                                                      "DiagnosticInfo"};

[[nodiscard]] std::string typeName(const UA_DataValue& value) {
  const auto* id = value.hasValue ? scalarOf<UA_NodeId>(value.value, UA_TYPES_NODEID) : nullptr;
  return id != nullptr && id->namespaceIndex == 0 && id->identifierType == UA_NODEIDTYPE_NUMERIC &&
                 id->identifier.numeric < kTypeNames.size()
             ? std::string(kTypeNames[id->identifier.numeric])
             : std::string();
}

[[nodiscard]] std::string shownValue(const UA_Variant& variant) {
  if (const auto number = numberOf(variant)) {
    return fmt::format("{}", *number);
  }
  if (const auto text = textOf(variant)) {
    return text->size() <= kShownCharacters ? *text : text->substr(0, kShownCharacters - 1) + "…";
  }
  if (UA_Variant_hasArrayType(&variant, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(variant.data);
    std::string text;
    for (std::size_t i = 0; i < std::min(variant.arrayLength, kShownElements); ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
    }
    return variant.arrayLength > kShownElements ? text + ", …" : text;
  }
  return {};
}

[[nodiscard]] NodeFacts factsOf(const UA_DataValue& value, const UA_DataValue& type,
                                const UA_DataValue& level) {
  NodeFacts facts;
  facts.type = typeName(type);
  const unsigned mask = bitsOf(level);
  facts.mayRead = (mask & UA_ACCESSLEVELMASK_READ) != 0;
  facts.mayWrite = (mask & UA_ACCESSLEVELMASK_WRITE) != 0;
  if (value.hasStatus && isBad(value.status)) {
    facts.status = linkErrorOf(value.status, Operation::Read);
    return facts;
  }
  if (!value.hasValue || value.value.type == nullptr) {
    facts.status = LinkError::BadValue;
    return facts;
  }
  const UA_Variant& variant = value.value;
  facts.isArray = !UA_Variant_isScalar(&variant);
  facts.length = facts.isArray ? variant.arrayLength : 1;
  const UA_UInt32 kind = variant.type->typeKind;
  facts.isBoolean = kind == UA_DATATYPEKIND_BOOLEAN;
  facts.isNumber = kind >= UA_DATATYPEKIND_SBYTE && kind <= UA_DATATYPEKIND_DOUBLE;
  facts.isText = kind == UA_DATATYPEKIND_STRING || kind == UA_DATATYPEKIND_LOCALIZEDTEXT;
  facts.value = shownValue(variant);
  return facts;
}

}  // namespace

base::Result<std::vector<NodeFacts>> UaLink::Impl::examine(std::span<const std::string> addresses) {
  constexpr std::array kAttributes{UA_ATTRIBUTEID_VALUE, UA_ATTRIBUTEID_DATATYPE,
                                   UA_ATTRIBUTEID_USERACCESSLEVEL};
  std::vector<NodeFacts> facts;
  while (!addresses.empty()) {
    const auto some = addresses.first(std::min(addresses.size(), kExaminedAtOnce));
    addresses = addresses.subspan(some.size());
    std::vector<NodeId> ids;
    std::vector<UA_ReadValueId> items;
    for (const std::string& address : some) {
      auto id = parsed(address);
      ids.push_back(id ? std::move(*id) : NodeId());
      for (const UA_AttributeId attribute : kAttributes) {
        UA_ReadValueId& item = items.emplace_back();
        UA_ReadValueId_init(&item);
        item.nodeId = ids.back()->nodeId;
        item.attributeId = static_cast<UA_UInt32>(attribute);
      }
    }
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.requestHeader.timeoutHint = kLibraryTimeoutMs;
    request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
    request.nodesToRead = items.data();
    request.nodesToReadSize = items.size();
    ReadResponse response;
    UA_StatusCode status =
        exchange(&request, &UA_TYPES[UA_TYPES_READREQUEST], response.get(), ReadResponse::type(),
                 addSaturating(now(), m_options.commandDeadline));
    if (!isBad(status) && response->resultsSize != items.size()) {
      status = UA_STATUSCODE_BADUNKNOWNRESPONSE;
    }
    if (isBad(status)) {
      return base::fail(requestError(status, Operation::Read, endpoint()));
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      const UA_DataValue* const of = &response->results[i * kAttributes.size()];
      facts.push_back(factsOf(of[0], of[1], of[2]));
    }
  }
  return facts;
}

base::Result<bool> UaLink::Impl::exists(const UA_NodeId& node, Instant deadline) {
  const auto answer = readAttribute(node, UA_ATTRIBUTEID_NODECLASS, deadline);
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& nodeClass = (*answer)->results[0];
  return nodeClass.hasValue && !(nodeClass.hasStatus && isBad(nodeClass.status));
}

base::Result<ServerIdentity> UaLink::Impl::identity() {
  const Instant deadline = addSaturating(now(), m_options.commandDeadline);
  ServerIdentity identity;
  // The first entry of its server array is the server itself.
  const auto servers =
      readAttribute(standardNodeId(UA_NS0ID_SERVER_SERVERARRAY), UA_ATTRIBUTEID_VALUE, deadline);
  if (!servers) {
    return base::fail(servers.error());
  }
  const UA_DataValue& uris = (*servers)->results[0];
  if (uris.hasValue && UA_Variant_hasArrayType(&uris.value, &UA_TYPES[UA_TYPES_STRING]) &&
      uris.value.arrayLength > 0) {
    identity.applicationUri = view(*static_cast<const UA_String*>(uris.value.data));
  }
  const std::array<std::pair<UA_UInt32, std::string*>, 3> members{
      {{UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_PRODUCTNAME, &identity.productName},
       {UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_SOFTWAREVERSION, &identity.softwareVersion},
       {UA_NS0ID_SERVER_SERVERSTATUS_BUILDINFO_BUILDNUMBER, &identity.buildNumber}}};
  for (const auto& [node, text] : members) {
    const auto answer = readAttribute(standardNodeId(node), UA_ATTRIBUTEID_VALUE, deadline);
    if (!answer) {
      return base::fail(answer.error());
    }
    const UA_DataValue& value = (*answer)->results[0];
    *text = (value.hasValue ? textOf(value.value) : std::nullopt).value_or(std::string());
  }
  return identity;
}

base::Result<ReadResponse> UaLink::Impl::readAttribute(const UA_NodeId& node,
                                                       UA_AttributeId attribute, Instant deadline) {
  UA_ReadValueId item;
  UA_ReadValueId_init(&item);
  item.nodeId = node;
  item.attributeId = static_cast<UA_UInt32>(attribute);
  UA_ReadRequest request;
  UA_ReadRequest_init(&request);
  request.requestHeader.timeoutHint = kLibraryTimeoutMs;
  request.timestampsToReturn = UA_TIMESTAMPSTORETURN_NEITHER;
  request.nodesToRead = &item;
  request.nodesToReadSize = 1;
  ReadResponse response;
  UA_StatusCode status = exchange(&request, &UA_TYPES[UA_TYPES_READREQUEST], response.get(),
                                  ReadResponse::type(), deadline);
  if (!isBad(status) && response->resultsSize != 1) {
    status = UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(requestError(status, Operation::Read, endpoint()));
  }
  return response;
}

base::Result<bool> UaLink::Impl::mayWrite(const Variable& variable) {
  const Node node{variable, 1, Grouping::List};
  const std::string name = isMapped() ? mapKeyOf(variable) : identifier(node);
  UA_String range{};
  const auto answer = readAttribute(nodeId(node, range), UA_ATTRIBUTEID_USERACCESSLEVEL,
                                    addSaturating(now(), m_options.commandDeadline));
  if (!answer) {
    return base::fail(answer.error());
  }
  const UA_DataValue& value = (*answer)->results[0];
  if (value.hasStatus && isBad(value.status)) {
    return base::fail(requestError(value.status, Operation::Read, name));
  }
  return (bitsOf(value) & UA_ACCESSLEVELMASK_WRITE) != 0;
}

}  // namespace rivulet::opcua
