// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Calls a method with arrays in the place of its inputs, which no client of ours does. Open62541
/// takes an array without elements for a scalar. @threadsafety of one thread.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "opcua/open62541/handle.h"
#include "support/plain_client.h"

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
  const PlainClient client(endpoint);
  const UA_UInt16 space = client.spaceOf(method.namespaceUri);
  std::array<UA_StatusCode, 2> answers{};
  for (const bool isNull : {false, true}) {
    std::vector<UA_Variant> inputs(method.inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      UA_Variant_init(&inputs[i]);
      inputs[i].type = &UA_TYPES[method.inputs[i]];
      inputs[i].data = isNull ? nullptr : UA_EMPTY_ARRAY_SENTINEL;
    }
    answers[isNull ? 1 : 0] =
        UA_Client_call(client.get(), opcua::borrowNodeId(space, method.object),
                       opcua::borrowNodeId(space, method.identifier), inputs.size(), inputs.data(),
                       nullptr, nullptr);
  }
  return answers;
}

}  // namespace rivulet::tests
