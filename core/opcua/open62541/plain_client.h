// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A client without encryption and without a session, for questions about servers. This header
/// names open62541 types, as `handle.h`. @threadsafety plain values.
#pragma once

#include <open62541/client.h>
#include <open62541/client_config_default.h>

#include <cstring>
#include <string>

#include "opcua/open62541/handle.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::opcua {

/// @param logger  outlives the client
[[nodiscard]] inline UA_StatusCode makePlain(UA_ClientConfig& config, const std::string& address,
                                             QuietLogger& logger) {
  std::memset(&config, 0, sizeof config);
  config.logging = logger.handle();
  const UA_StatusCode status = UA_ClientConfig_setDefault(&config);
  if (status != UA_STATUSCODE_GOOD) {
    UA_ClientConfig_clear(&config);
    return status;
  }
  // With an endpoint of its own, the library does not look for one that it can open a session on,
  // again and again.
  const UA_String none = borrow("http://opcfoundation.org/UA/SecurityPolicy#None");
  const UA_String url = borrow(address);
  config.endpoint.securityMode = UA_MESSAGESECURITYMODE_NONE;
  UA_String_copy(&none, &config.endpoint.securityPolicyUri);
  UA_String_copy(&url, &config.endpoint.endpointUrl);
  config.noReconnect = true;
  return status;
}

}  // namespace rivulet::opcua
