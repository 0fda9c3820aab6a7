// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <iterator>
#include <utility>

#include "opcua/open62541/method_call.h"
#include "opcua/open62541/ua_link_impl.h"
#include "opcua/open62541/values.h"
#include "opcua/request.h"

namespace rivulet::opcua {

using base::Duration;
using base::Instant;
using std::chrono::milliseconds;

UA_StatusCode UaLink::Impl::exchange(const void* request, const UA_DataType* requestType,
                                     void* response, const UA_DataType* responseType,
                                     Instant deadline) {
  if (m_connection.isLost) {
    return UA_STATUSCODE_BADCONNECTIONCLOSED;
  }
  m_exchange = Exchange{nextSerial(), response, responseType, false};
  void* const serial = reinterpret_cast<void*>(static_cast<std::uintptr_t>(m_exchange.serial));
  UA_StatusCode status = __UA_Client_AsyncService(m_client, request, requestType, &Impl::onAnswer,
                                                  responseType, serial, nullptr);
  m_connection.isLost = m_connection.isLost || isBad(status);
  while (!isBad(status) && !m_exchange.answered) {
    if (m_connection.isLost) {
      status = UA_STATUSCODE_BADCONNECTIONCLOSED;
    } else if (now() >= deadline) {
      status = UA_STATUSCODE_BADTIMEOUT;
    } else {
      step(deadline);
    }
  }
  m_exchange = Exchange{};
  settle();
  return isBad(status) ? status : static_cast<const UA_ResponseHeader*>(response)->serviceResult;
}

base::Result<CallResponse> UaLink::Impl::call(UA_UInt16 namespaceIndex, std::string_view object,
                                              std::string_view method,
                                              std::span<UA_Variant> inputs) {
  const std::string methodIdentifier = memberIdentifier(object, method);
  return callNode(borrowNodeId(namespaceIndex, object),
                  borrowNodeId(namespaceIndex, methodIdentifier), methodIdentifier, inputs);
}

base::Result<CallResponse> UaLink::Impl::callMapped(std::string_view method,
                                                    std::span<UA_Variant> inputs) {
  const auto found = m_methods.find(method);
  if (found == m_methods.end()) {
    return base::fail(LinkError::MethodMissing, "The map of this server names no such method.",
                      std::string(method));
  }
  return callNode(found->second.object->nodeId, found->second.method->nodeId, std::string(method),
                  inputs);
}

base::Result<CallResponse> UaLink::Impl::callNode(const UA_NodeId& object, const UA_NodeId& method,
                                                  const std::string& name,
                                                  std::span<UA_Variant> inputs) {
  MethodCall call(object, method, inputs);
  CallResponse response;
  UA_StatusCode status =
      exchange(&call.request, &UA_TYPES[UA_TYPES_CALLREQUEST], response.get(), CallResponse::type(),
               addSaturating(now(), m_options.commandDeadline));
  if (!isBad(status)) {
    status = response->resultsSize == 1 ? response->results[0].statusCode
                                        : UA_STATUSCODE_BADUNKNOWNRESPONSE;
  }
  if (isBad(status)) {
    return base::fail(m_connection.isSilent ? lossError()
                                            : requestError(status, Operation::Call, name));
  }
  return response;
}

base::Result<std::vector<NodeValue>> UaLink::Impl::callMethod(const std::string& object,
                                                              const std::string& method,
                                                              std::span<const std::string> inputs) {
  const auto objectId = parsed(object);
  const auto methodId = parsed(method);
  if (!objectId || !methodId) {
    return base::fail(LinkError::MethodMissing, sentenceOf(LinkError::MethodMissing), method);
  }
  std::vector<UA_String> texts;
  std::transform(inputs.begin(), inputs.end(), std::back_inserter(texts),
                 [](const std::string& input) { return borrow(input); });
  std::vector<UA_Variant> arguments;
  std::transform(texts.begin(), texts.end(), std::back_inserter(arguments),
                 [](UA_String& text) { return borrowScalar(text, UA_TYPES_STRING); });
  const auto response = callNode((*objectId)->nodeId, (*methodId)->nodeId, method, arguments);
  if (!response) {
    return base::fail(response.error());
  }
  const UA_CallMethodResult& result = (*response)->results[0];
  std::vector<NodeValue> outputs;
  for (std::size_t i = 0; i < result.outputArgumentsSize; ++i) {
    outputs.push_back(nodeValueOf(result.outputArguments[i]));
  }
  return outputs;
}

base::Result<CallResponse> UaLink::Impl::callFileMethod(std::string_view method,
                                                        std::span<UA_Variant> inputs) {
  if (isMapped()) {
    return callMapped(method, inputs);
  }
  auto answer = call(m_namespace, m_fileMethods, method, inputs);
  if (!answer && answer.error().code == LinkError::MethodMissing) {
    const std::string_view other =
        m_fileMethods == kMethodsObject ? kFileMethodsObject : kMethodsObject;
    answer = call(m_namespace, other, method, inputs);
    m_fileMethods = answer ? other : m_fileMethods;
  }
  return answer;
}

base::Result<CallResponse> UaLink::Impl::callBeyond(std::string_view method,
                                                    std::span<UA_Variant> inputs) {
  if (!m_commands) {
    return base::fail(onlyVirtual(endpoint()));
  }
  return call(m_commands->nameSpace, m_commands->object, method, inputs);
}

}  // namespace rivulet::opcua
