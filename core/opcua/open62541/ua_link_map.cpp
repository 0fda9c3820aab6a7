// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "opcua/control_map.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

std::optional<NodeId> UaLink::Impl::parsed(const std::string& address) const {
  NodeId id;
  if (isBad(UA_ExpandedNodeId_parse(id.get(), borrow(address))) || id->serverIndex != 0) {
    return std::nullopt;
  }
  if (id->namespaceUri.length > 0) {
    const auto found = std::find(m_namespaces.begin(), m_namespaces.end(), view(id->namespaceUri));
    if (found == m_namespaces.end()) {
      return std::nullopt;
    }
    id->nodeId.namespaceIndex = static_cast<UA_UInt16>(found - m_namespaces.begin());
  }
  return id;
}

base::Error UaLink::Impl::wrongAddress(const std::string& key, const std::string& what) const {
  return base::makeError(
      MapError::WrongAddress,
      fmt::format("{} of the map: {} Correct the map; rivulet-cli map shows what the server has.",
                  key, what),
      endpoint());
}

base::Result<NodeId> UaLink::Impl::resolve(const std::string& address, const std::string& key) {
  if (isBrowsePath(address)) {
    return resolvePath(address, key);
  }
  auto id = parsed(address);
  if (!id) {
    return base::fail(wrongAddress(
        key, fmt::format("{} is in a namespace that the server does not have.", address)));
  }
  return std::move(*id);
}

/// By browsing, level after level: names are compared in whatever namespace they are. The levels
/// are kept, because many addresses share them.
base::Result<NodeId> UaLink::Impl::resolvePath(const std::string& path, const std::string& key) {
  std::string at = kObjectsFolder;
  for (const BrowseStep& step : browseSteps(path)) {
    auto known = m_browsed.find(at);
    if (known == m_browsed.end()) {
      auto nodes = children(at);
      if (!nodes) {
        return base::fail(nodes.error());
      }
      known = m_browsed.emplace(at, std::move(*nodes)).first;
    }
    const BrowsedNode* found = nullptr;
    for (const BrowsedNode& node : known->second) {
      if (node.name != step.name || (step.nameSpace && *step.nameSpace != node.nameSpace)) {
        continue;
      }
      if (found != nullptr && found->address != node.address) {
        return base::fail(wrongAddress(
            key, fmt::format("{} is ambiguous: there are two nodes {}. Write the node id.", path,
                             step.name)));
      }
      found = &node;
    }
    if (found == nullptr) {
      return base::fail(
          wrongAddress(key, fmt::format("{} ends at {}: there is no such node.", path, step.name)));
    }
    at = found->address;
  }
  auto id = parsed(at);
  if (!id) {
    return base::fail(wrongAddress(key, fmt::format("{} is on another server.", path)));
  }
  return std::move(*id);
}

base::Result<void> UaLink::Impl::resolveMap() {
  for (const auto step : {&Impl::resolveVariables, &Impl::resolveMethods, &Impl::checkAddresses}) {
    if (auto done = (this->*step)(); !done) {
      return done;
    }
  }
  m_browsed.clear();
  return {};
}

base::Result<void> UaLink::Impl::resolveVariables() {
  for (const auto& [variable, address] : m_map->nodes) {
    if (m_options.map == nullptr) {
      auto id = parsed(address);
      if (!id) {
        return base::fail(LinkError::VariableMissing,
                          fmt::format("{} is no node of this server. Write it like ns=2;s=Robot.X "
                                      "or nsu=urn:robot;s=X, as a browser of OPC UA shows it.",
                                      address),
                          endpoint());
      }
      m_addressed[variable].id = std::move(*id);
      continue;
    }
    auto id = resolve(address, mapKeyOf(variable));
    if (!id) {
      return base::fail(id.error());
    }
    m_addressed[variable].id = std::move(*id);
  }
  const CellNodes& cells = m_map->cells;
  for (int number = cells.first; number <= cells.last; ++number) {
    auto id = resolve(cellAddress(cells, number), mapKeyOf(rParameter(number)));
    if (!id) {
      return base::fail(id.error());
    }
    Address& address = m_addressed[rParameter(number)];
    address.id = std::move(*id);
    if (cells.isArray) {
      address.range = std::to_string(number + cells.offset);
    }
  }
  return {};
}

base::Result<void> UaLink::Impl::resolveMethods() {
  const MethodNodes& methods = m_map->methods;
  const std::array<std::pair<std::string_view, const std::string*>, 3> named{
      {{kCopyToServer, &methods.write},
       {kCopyFromServer, &methods.read},
       {kSelect, &methods.select}}};
  for (const auto& [name, address] : named) {
    if (address->empty()) {
      continue;
    }
    auto object = resolve(methods.object, "methods.object");
    if (!object) {
      return base::fail(object.error());
    }
    auto method = resolve(*address, "methods");
    if (!method) {
      return base::fail(method.error());
    }
    m_methods.emplace(name, MethodAddress{std::move(*object), std::move(*method)});
  }
  return {};
}

/// A wrong address would otherwise be noticed in the middle of a run, or never.
base::Result<void> UaLink::Impl::checkAddresses() {
  const CellNodes& cells = m_map->cells;
  for (const auto& [variable, address] : m_addressed) {
    const bool isCell = variable.kind == VariableKind::RParameter;
    if (isCell && variable.index != cells.first && variable.index != cells.last) {
      continue;  // all others are made in the same way
    }
    const auto answer = readAttribute(address.id->nodeId, UA_ATTRIBUTEID_VALUE,
                                      addSaturating(now(), m_options.commandDeadline));
    if (!answer) {
      return base::fail(answer.error());
    }
    const UA_DataValue& value = (*answer)->results[0];
    const std::string node =
        isCell ? cellAddress(cells, variable.index) : addressText(address.id->nodeId);
    const LinkError status = value.hasStatus && isBad(value.status)
                                 ? linkErrorOf(value.status, Operation::Read)
                                 : LinkError{};
    if (status == LinkError::VariableMissing) {
      return base::fail(
          wrongAddress(mapKeyOf(variable), fmt::format("the server has no variable {}.", node)));
    }
    if (!isCell || status != LinkError{}) {
      continue;  // a value may be missing for a while
    }
    const auto element = static_cast<std::size_t>(variable.index + cells.offset);
    const auto isOf = [&value, &cells, element](std::size_t type) {
      return cells.isArray
                 ? value.hasValue && UA_Variant_hasArrayType(&value.value, &UA_TYPES[type]) &&
                       value.value.arrayLength > element
                 : value.hasValue && UA_Variant_hasScalarType(&value.value, &UA_TYPES[type]);
    };
    m_floatCells.exist = isOf(UA_TYPES_FLOAT);
    if (m_floatCells.exist && cells.resolution <= 0.0) {
      return base::fail(wrongAddress(
          mapKeyOf(variable),
          fmt::format("R{} is {}, a Float, which does not carry every number. Write the smallest "
                      "increment of the axes into [cells], like resolution = 0.001.",
                      variable.index, node)));
    }
    if (!m_floatCells.exist && !isOf(UA_TYPES_DOUBLE)) {
      return base::fail(wrongAddress(
          mapKeyOf(variable),
          fmt::format("R{} is {}, which is no {}. Cells carry numbers of type Double only.",
                      variable.index, node,
                      cells.isArray ? "array of Double with this element" : "Double")));
    }
  }
  return {};
}

}  // namespace rivulet::opcua
