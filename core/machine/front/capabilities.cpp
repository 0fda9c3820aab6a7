// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/capabilities.h"

#include <array>
#include <string_view>

#include "machine/front/listening.h"
#include "opcua/open62541/handle.h"

namespace rivulet::machine {

namespace {

struct Limit {
  UA_UInt32 id;  ///< of the node in the standard's namespace
  std::string_view name;
  UA_UInt32 value;  ///< 0: there is no such limit
  std::string_view description;
};

/// What the library has for all servers and this one does not offer. Nodes must exist.
constexpr std::array kNotOffered{
    UA_NS0ID_HISTORYSERVERCAPABILITIES,
    UA_NS0ID_SERVER_SERVERCAPABILITIES_OPERATIONLIMITS_MAXNODESPERNODEMANAGEMENT};

}  // namespace

UA_StatusCode stateCapabilities(UA_Server* server, const StatedLimits& limits) {
  const UA_ServerConfig& config = *UA_Server_getConfig(server);
  const std::array stated{
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXSESSIONS, "MaxSessions", limits.sessionsMax,
            "Largest number of sessions at a time."},
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXSUBSCRIPTIONS, "MaxSubscriptions",
            config.maxSubscriptions, "Largest number of subscriptions of all clients."},
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXMONITOREDITEMS, "MaxMonitoredItems",
            config.maxMonitoredItems, "Largest number of monitored items of all clients."},
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXMONITOREDITEMSQUEUESIZE,
            "MaxMonitoredItemsQueueSize", config.queueSizeLimits.max,
            "Longest queue of a monitored item."},
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXARRAYLENGTH, "MaxArrayLength",
            limits.arrayLengthMax, "Elements of the longest array of R-parameters."},
      Limit{UA_NS0ID_SERVER_SERVERCAPABILITIES_MAXBYTESTRINGLENGTH, "MaxByteStringLength",
            limits.byteStringLengthMax, "Bytes of the longest part program."}};
  UA_StatusCode status = UA_STATUSCODE_GOOD;
  for (const UA_UInt32 id : kNotOffered) {
    status |= UA_Server_deleteNode(server, opcua::standardNodeId(id), true);
  }
  const UA_NodeId owner = opcua::standardNodeId(UA_NS0ID_SERVER_SERVERCAPABILITIES);
  for (const Limit& limit : stated) {
    if (limit.value > 0) {
      UA_UInt32 value = limit.value;
      status |= addProperty(server, owner, opcua::standardNodeId(limit.id),
                            {0, opcua::borrow(limit.name)},
                            opcua::borrowScalar(value, UA_TYPES_UINT32), limit.description);
    }
  }
  // The standard profile, which the library claims, asks for 50 sessions (OPC 10000-7).
  std::array profiles{
      opcua::borrow("http://opcfoundation.org/UA-Profile/Server/MicroEmbeddedDevice2017"),
      opcua::borrow("http://opcfoundation.org/UA-Profile/Server/Methods")};
  UA_Variant list;
  UA_Variant_init(&list);
  UA_Variant_setArray(&list, profiles.data(), profiles.size(), &UA_TYPES[UA_TYPES_STRING]);
  return status |
         UA_Server_writeValue(
             server, opcua::standardNodeId(UA_NS0ID_SERVER_SERVERCAPABILITIES_SERVERPROFILEARRAY),
             list);
}

}  // namespace rivulet::machine
