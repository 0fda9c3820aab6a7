// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a server offers of protection, and a connection that is bound to one offer. @threadsafety
/// plain values.
#pragma once

#include <open62541/client.h>

#include <cstddef>
#include <vector>

#include "opcua/open62541/handle.h"
#include "opcua/open62541/ua_link.h"
#include "opcua/security.h"

namespace rivulet::opcua {

/// The endpoints of a server, in the library's own memory.
struct Endpoints {
  Endpoints() = default;
  ~Endpoints() { UA_Array_delete(list, count, &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]); }
  Endpoints(const Endpoints&) = delete;
  Endpoints& operator=(const Endpoints&) = delete;

  std::size_t count = 0;
  UA_EndpointDescription* list = nullptr;
};

/// The endpoint that is used.
struct SecureEndpoint {
  Handle<UA_EndpointDescription, UA_TYPES_ENDPOINTDESCRIPTION> description;
};

/// In the order of the list, so that an index means the same. What Rivulet cannot use takes nobody.
[[nodiscard]] std::vector<EndpointOffer> offersOf(const Endpoints& endpoints);

/// Binds a configuration to one endpoint: this policy, this mode, this certificate, this kind of
/// login. @param endpoint  outlives the client
[[nodiscard]] UA_StatusCode protect(UA_ClientConfig& config, const SecureEndpoint& endpoint,
                                    const ConnectOptions& options, const OwnCertificate& own);

/// Overwrites the password in the library's memory.
void forgetPassword(UA_ClientConfig& config);

}  // namespace rivulet::opcua
