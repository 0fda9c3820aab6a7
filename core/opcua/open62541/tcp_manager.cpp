// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/tcp_manager.h"

#include <open62541/types.h>

#include <cstdint>
#include <string_view>

#include "base/contract.h"
#include "opcua/open62541/handle.h"

namespace rivulet::opcua {

namespace {

UA_QualifiedName ownerKey() {
  constexpr std::string_view kKey = "rivulet-owner";
  return {0, borrow(kKey)};
}

}  // namespace

UA_ConnectionManager* tcpManagerOf(UA_EventLoop& loop) {
  for (UA_EventSource* source = loop.eventSources; source != nullptr; source = source->next) {
    if (source->eventSourceType != UA_EVENTSOURCETYPE_CONNECTIONMANAGER) {
      continue;
    }
    // The event source is the first member of the manager, as the library itself relies on.
    auto* manager = reinterpret_cast<UA_ConnectionManager*>(source);
    if (view(manager->protocol) == "tcp") {
      return manager;
    }
  }
  return nullptr;
}

UA_ConnectionManager* ownedTcpManager(UA_EventLoop& loop, void* owner) {
  UA_ConnectionManager* manager = tcpManagerOf(loop);
  UA_UInt64 number = reinterpret_cast<std::uintptr_t>(owner);
  const bool isNoted = manager != nullptr &&
                       UA_KeyValueMap_setScalar(&manager->eventSource.params, ownerKey(), &number,
                                                &UA_TYPES[UA_TYPES_UINT64]) == UA_STATUSCODE_GOOD;
  return isNoted ? manager : nullptr;
}

void* ownerOf(const UA_ConnectionManager& manager) {
  const void* number =
      UA_KeyValueMap_getScalar(&manager.eventSource.params, ownerKey(), &UA_TYPES[UA_TYPES_UINT64]);
  RIVULET_ASSERT(number != nullptr);
  return reinterpret_cast<void*>(
      static_cast<std::uintptr_t>(*static_cast<const UA_UInt64*>(number)));
}

}  // namespace rivulet::opcua
