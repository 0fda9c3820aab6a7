// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What every OPC UA server of Rivulet does with the library's configuration, objects and socket.
/// @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "machine/front/server.h"
#include "opcua/open62541/quiet_logger.h"

namespace rivulet::machine {

/// "opc.tcp://127.0.0.1:4840", with brackets around an address of IPv6.
[[nodiscard]] std::string urlOf(const std::string& host, std::uint16_t port);

/// Whether a server can listen as the options say, asked before the library, which gives no reason.
/// @param connections  that it takes at most  @return PortTaken, AddressUnusable, TooFewHandles
[[nodiscard]] base::Result<void> requireListening(const ServerOptions& options,
                                                  std::size_t connections);

/// A text of a configuration gets another value.
[[nodiscard]] UA_StatusCode replaceText(UA_String& target, std::string_view text);

/// An object that is a component of another one, with the same browse and display name.
/// @param namespaceIndex  of its identifier and of its name
/// @param description  what it is, in one short sentence; empty: the name says it
[[nodiscard]] UA_StatusCode addObject(UA_Server* server, UA_UInt16 namespaceIndex,
                                      const UA_NodeId& parent, std::string_view identifier,
                                      std::string_view name, std::string_view description = {});

/// A text in English, as the server has told its clients that all are; valid as long as `english`.
[[nodiscard]] UA_LocalizedText localized(std::string_view english);

/// A property of a node, which only clients read.
/// @param id  of the property @param value  copied
[[nodiscard]] UA_StatusCode addProperty(UA_Server* server, const UA_NodeId& owner,
                                        const UA_NodeId& id, const UA_QualifiedName& name,
                                        const UA_Variant& value, std::string_view description);

/// A client may use the nodes but never change which there are.
void refuseChanges(UA_AccessControl& control);

/// `FrontError::SetUpFailed` with the last words of the library. @param what  the server cannot do
[[nodiscard]] tl::unexpected<base::Error> setUpFailed(const char* what,
                                                      const opcua::QuietLogger& logger);

/// Starts the server and has it announce only its real port. @return the address for clients
[[nodiscard]] base::Result<std::string> startListening(UA_Server& server,
                                                       const ServerOptions& options,
                                                       const opcua::QuietLogger& logger);

}  // namespace rivulet::machine
