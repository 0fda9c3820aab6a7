// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/service_client.h"

#include <fmt/format.h>
#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "opcua/error.h"
#include "opcua/node_map.h"
#include "opcua/open62541/client_wire.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"
#include "opcua/security.h"
#include "service/node_table.h"

namespace rivulet::service {

namespace {

/// The service answers after it has read a large program.
constexpr std::chrono::milliseconds kTimeout{60'000};

std::string textOf(const UA_Variant& value) {
  if (const auto* flag = opcua::scalarOf<UA_Boolean>(value, UA_TYPES_BOOLEAN)) {
    return *flag ? "true" : "false";
  }
  if (const auto* count = opcua::scalarOf<UA_UInt32>(value, UA_TYPES_UINT32)) {
    return std::to_string(*count);
  }
  if (const auto* number = opcua::scalarOf<UA_Double>(value, UA_TYPES_DOUBLE)) {
    return fmt::format("{:.6g}", *number);
  }
  if (const auto* text = opcua::scalarOf<UA_String>(value, UA_TYPES_STRING)) {
    return std::string(opcua::view(*text));
  }
  std::string text;
  if (value.type == &UA_TYPES[UA_TYPES_DOUBLE]) {
    for (std::size_t i = 0; i < value.arrayLength; ++i) {
      text += fmt::format("{}{:.6g}", i > 0 ? " " : "", static_cast<const double*>(value.data)[i]);
    }
  }
  return text;
}

tl::unexpected<base::Error> notReachable(const std::string& endpoint, UA_StatusCode status) {
  return base::fail(
      opcua::LinkError::NotReachable,
      fmt::format("The service does not answer ({}). Is it running?", UA_StatusCode_name(status)),
      endpoint);
}

}  // namespace

class ServiceClient::Impl {
 public:
  explicit Impl(std::string endpoint) : m_endpoint(std::move(endpoint)) {
    UA_ClientConfig config{};
    config.logging = m_logger.handle();
    if (UA_ClientConfig_setDefault(&config) == UA_STATUSCODE_GOOD) {
      config.timeout = static_cast<UA_UInt32>(kTimeout.count());
      m_client = UA_Client_newWithConfig(&config);
      if (m_client != nullptr) {
        m_wire.emplace(*m_client, kTimeout, false);
      }
    }
  }
  ~Impl() {
    if (m_client != nullptr) {
      UA_Client_disconnect(m_client);
      UA_Client_delete(m_client);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  base::Result<void> connect() {
    UA_StatusCode status = m_client != nullptr ? UA_Client_connect(m_client, m_endpoint.c_str())
                                               : UA_STATUSCODE_BADOUTOFMEMORY;
    if (status == UA_STATUSCODE_GOOD) {
      UA_String uri = opcua::borrow(kNamespaceUri);
      status = UA_Client_NamespaceGetIndex(m_client, &uri, &m_namespace);
    }
    return status == UA_STATUSCODE_GOOD ? base::Result<void>()
                                        : base::Result<void>(notReachable(m_endpoint, status));
  }

  base::Result<std::map<std::string, std::string>> read() {
    std::vector<UA_ReadValueId> items(variableRows().size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      UA_ReadValueId_init(&items[i]);
      items[i].nodeId = opcua::borrowNodeId(m_namespace, variableRows()[i].identifier);
      items[i].attributeId = UA_ATTRIBUTEID_VALUE;
    }
    UA_ReadRequest request;
    UA_ReadRequest_init(&request);
    request.nodesToRead = items.data();
    request.nodesToReadSize = items.size();
    opcua::Handle<UA_ReadResponse, UA_TYPES_READRESPONSE> response;
    *response.get() = UA_Client_Service_read(m_client, request);
    if (response->responseHeader.serviceResult != UA_STATUSCODE_GOOD ||
        response->resultsSize != items.size()) {
      return notReachable(m_endpoint, response->responseHeader.serviceResult);
    }
    std::map<std::string, std::string> values;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool isHidden = response->results[i].status == UA_STATUSCODE_BADUSERACCESSDENIED;
      values.emplace(variableRows()[i].identifier,
                     isHidden ? std::string(kHidden) : textOf(response->results[i].value));
    }
    return values;
  }

  base::Result<Answer> call(const std::string& method, const std::vector<std::string>& inputs) {
    std::vector<UA_String> texts;
    for (const std::string& input : inputs) {
      texts.push_back(opcua::borrow(input));
    }
    std::vector<UA_Variant> arguments;
    for (UA_String& text : texts) {
      arguments.push_back(opcua::borrowScalar(text, UA_TYPES_STRING));
    }
    const std::string identifier = methodIdentifier(method);
    std::size_t size = 0;
    UA_Variant* output = nullptr;
    const UA_StatusCode status =
        UA_Client_call(m_client, opcua::borrowNodeId(m_namespace, kMethodsObject),
                       opcua::borrowNodeId(m_namespace, identifier), arguments.size(),
                       arguments.data(), &size, &output);
    constexpr std::size_t kOutputs = 3;
    base::Result<Answer> answer = base::fail(
        opcua::LinkError::Rejected,
        fmt::format("The service refuses the call of {} ({}).", method, UA_StatusCode_name(status)),
        m_endpoint);
    if (status == UA_STATUSCODE_GOOD && size == kOutputs) {
      answer = Answer{textOf(output[0]) == "true", textOf(output[1]), textOf(output[2])};
    } else if (status == UA_STATUSCODE_BADCONNECTIONCLOSED ||
               status == UA_STATUSCODE_BADSECURECHANNELCLOSED ||
               status == UA_STATUSCODE_BADTIMEOUT) {
      answer = notReachable(m_endpoint, status);
    }
    UA_Array_delete(output, size, &UA_TYPES[UA_TYPES_VARIANT]);
    return answer;
  }

 private:
  std::string m_endpoint;
  opcua::QuietLogger m_logger;  ///< outlives the client that logs into it
  std::optional<opcua::ClientWire> m_wire;
  UA_Client* m_client = nullptr;
  UA_UInt16 m_namespace = 0;
};

ServiceClient::ServiceClient(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {
}
ServiceClient::~ServiceClient() = default;

base::Result<std::unique_ptr<ServiceClient>> ServiceClient::connect(const std::string& endpoint) {
  if (!opcua::isLoopback(endpoint)) {
    return base::fail(opcua::LinkError::NotReachable,
                      "This client connects without encryption, so only to services on this "
                      "computer. Use any OPC UA client for others.",
                      endpoint);
  }
  auto impl = std::make_unique<Impl>(endpoint);
  if (auto connected = impl->connect(); !connected) {
    return base::fail(connected.error());
  }
  return std::unique_ptr<ServiceClient>(new ServiceClient(std::move(impl)));
}

base::Result<std::map<std::string, std::string>> ServiceClient::read() {
  return m_impl->read();
}

base::Result<Answer> ServiceClient::call(const std::string& method,
                                         const std::vector<std::string>& inputs) {
  return m_impl->call(method, inputs);
}

}  // namespace rivulet::service
