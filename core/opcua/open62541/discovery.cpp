// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/discovery.h"

#include <chrono>
#include <optional>

#include "base/contract.h"
#include "opcua/error.h"
#include "opcua/host_check.h"
#include "opcua/open62541/client_wire.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/plain_client.h"
#include "opcua/open62541/quiet_logger.h"
#include "opcua/open62541/status.h"

namespace rivulet::opcua {

namespace {

/// What the library gives away in its own memory.
struct Applications {
  Applications() = default;
  ~Applications() { UA_Array_delete(list, count, &UA_TYPES[UA_TYPES_APPLICATIONDESCRIPTION]); }
  Applications(const Applications&) = delete;
  Applications& operator=(const Applications&) = delete;

  std::size_t count = 0;
  UA_ApplicationDescription* list = nullptr;
};

/// A client that is not connected.
class PlainClient {
 public:
  PlainClient(const std::string& address, base::Duration deadline) {
    UA_ClientConfig config;
    status = makePlain(config, address, m_logger);
    if (!isBad(status)) {
      config.timeout =
          static_cast<UA_UInt32>(std::chrono::ceil<std::chrono::milliseconds>(deadline).count());
      client = UA_Client_newWithConfig(&config);
      m_wire.emplace(*client, deadline, false);
    }
  }
  ~PlainClient() {
    if (client != nullptr) {
      UA_Client_delete(client);
    }
  }
  PlainClient(const PlainClient&) = delete;
  PlainClient& operator=(const PlainClient&) = delete;

 private:
  QuietLogger m_logger;  ///< outlives the client
  std::optional<ClientWire> m_wire;

 public:
  UA_StatusCode status = UA_STATUSCODE_GOOD;
  UA_Client* client = nullptr;  ///< not null if the status is good
};

}  // namespace

base::Result<std::vector<FoundServer>> findServers(const std::string& address,
                                                   base::Duration deadline) {
  if (auto host = requireHost(address); !host) {
    return base::fail(host.error());
  }
  const PlainClient asking(address, deadline);
  Applications found;
  UA_StatusCode status = asking.status;
  if (!isBad(status)) {
    status = UA_Client_findServers(asking.client, address.c_str(), 0, nullptr, 0, nullptr,
                                   &found.count, &found.list);
  }
  if (isBad(status)) {
    return base::fail(connectError(status, address));
  }
  std::vector<FoundServer> servers;
  for (std::size_t i = 0; i < found.count; ++i) {
    const UA_ApplicationDescription& one = found.list[i];
    FoundServer& server = servers.emplace_back();
    server.name = view(one.applicationName.text);
    server.applicationUri = view(one.applicationUri);
    server.productUri = view(one.productUri);
    for (std::size_t k = 0; k < one.discoveryUrlsSize; ++k) {
      server.addresses.emplace_back(view(one.discoveryUrls[k]));
    }
  }
  return servers;
}

base::Result<void> registerServer(const std::string& address, const FoundServer& server,
                                  bool isOnline, base::Duration deadline) {
  RIVULET_ASSERT(server.addresses.size() == 1);
  if (auto host = requireHost(address); !host) {
    return host;
  }
  const PlainClient asking(address, deadline);
  UA_StatusCode status = asking.status;
  if (!isBad(status)) {
    status = UA_Client_connectSecureChannel(asking.client, address.c_str());
  }
  if (!isBad(status)) {
    UA_LocalizedText name{};
    name.text = borrow(server.name);
    UA_String url = borrow(server.addresses.front());
    UA_RegisterServerRequest request;
    UA_RegisterServerRequest_init(&request);
    request.server.serverUri = borrow(server.applicationUri);
    request.server.productUri = borrow(server.productUri);
    request.server.serverNames = &name;
    request.server.serverNamesSize = 1;
    request.server.serverType = UA_APPLICATIONTYPE_SERVER;
    request.server.discoveryUrls = &url;
    request.server.discoveryUrlsSize = 1;
    request.server.isOnline = isOnline;
    Handle<UA_RegisterServerResponse, UA_TYPES_REGISTERSERVERRESPONSE> response;
    __UA_Client_Service(asking.client, &request, &UA_TYPES[UA_TYPES_REGISTERSERVERREQUEST],
                        response.get(), response.type());
    status = response->responseHeader.serviceResult;
  }
  return isBad(status) ? base::Result<void>(base::fail(connectError(status, address)))
                       : base::Result<void>();
}

}  // namespace rivulet::opcua
