// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A client of open62541 itself, for what no client of ours asks. @threadsafety one thread.
#pragma once

#include <open62541/client.h>
#include <open62541/client_config_default.h>
#include <open62541/client_highlevel.h>

#include <string>
#include <string_view>

#include "base/contract.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::tests {

class PlainClient {
 public:
  /// Connects without encryption.
  explicit PlainClient(const std::string& endpoint) {
    UA_ClientConfig config{};
    config.logging = m_logger.handle();
    config.timeout = 60'000;
    RIVULET_ASSERT(UA_ClientConfig_setDefault(&config) == UA_STATUSCODE_GOOD);
    m_client = UA_Client_newWithConfig(&config);
    RIVULET_ASSERT(UA_Client_connect(m_client, endpoint.c_str()) == UA_STATUSCODE_GOOD);
  }
  ~PlainClient() { UA_Client_delete(m_client); }
  PlainClient(const PlainClient&) = delete;
  PlainClient& operator=(const PlainClient&) = delete;

  [[nodiscard]] UA_Client* get() const { return m_client; }
  /// Index of a namespace of the server.
  [[nodiscard]] UA_UInt16 spaceOf(std::string_view uri) const {
    UA_String text = opcua::borrow(uri);
    UA_UInt16 space = 0;
    RIVULET_ASSERT(UA_Client_NamespaceGetIndex(m_client, &text, &space) == UA_STATUSCODE_GOOD);
    return space;
  }

 private:
  opcua::QuietLogger m_logger;
  UA_Client* m_client = nullptr;
};

}  // namespace rivulet::tests
