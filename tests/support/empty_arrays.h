// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calls a method with arrays in the place of its inputs, which no client of ours does. Open62541
/// takes an array without elements for a scalar. @threadsafety of one thread.
#pragma once

#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/contract.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::tests {

struct MethodToCall {
  std::string_view namespaceUri;
  std::string_view object;
  std::string identifier;
  std::vector<std::size_t> inputs;  ///< UA_TYPES_…
};

/// @return the answers if each input is an array of no elements, and if it is one that is null
inline std::array<UA_StatusCode, 2> callWithEmptyArrays(const std::string& endpoint,
                                                        const MethodToCall& method) {
  opcua::QuietLogger logger;
  UA_ClientConfig config{};
  config.logging = logger.handle();
  config.timeout = 60'000;
  RIVULET_ASSERT(UA_ClientConfig_setDefault(&config) == UA_STATUSCODE_GOOD);
  UA_Client* const client = UA_Client_newWithConfig(&config);
  RIVULET_ASSERT(UA_Client_connect(client, endpoint.c_str()) == UA_STATUSCODE_GOOD);
  UA_String uri = opcua::borrow(method.namespaceUri);
  UA_UInt16 space = 0;
  RIVULET_ASSERT(UA_Client_NamespaceGetIndex(client, &uri, &space) == UA_STATUSCODE_GOOD);
  std::array<UA_StatusCode, 2> answers{};
  for (const bool isNull : {false, true}) {
    std::vector<UA_Variant> inputs(method.inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      UA_Variant_init(&inputs[i]);
      inputs[i].type = &UA_TYPES[method.inputs[i]];
      inputs[i].data = isNull ? nullptr : UA_EMPTY_ARRAY_SENTINEL;
    }
    answers[isNull ? 1 : 0] = UA_Client_call(client, opcua::borrowNodeId(space, method.object),
                                             opcua::borrowNodeId(space, method.identifier),
                                             inputs.size(), inputs.data(), nullptr, nullptr);
  }
  UA_Client_delete(client);
  return answers;
}

}  // namespace rivulet::tests
