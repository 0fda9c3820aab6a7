// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/clients.h"

#include <algorithm>
#include <utility>

#include "base/contract.h"
#include "opcua/open62541/handle.h"
#include "opcua/open62541/tcp_manager.h"

namespace rivulet::machine {

namespace {

std::string keyOf(const UA_NodeId& session) {
  const UA_Guid& guid = session.identifier.guid;
  std::string key(reinterpret_cast<const char*>(&guid), sizeof guid);
  return key;
}

/// The library gives each session a node of its own with the identifier of the session.
bool isSession(const UA_NodeId& node) {
  return node.namespaceIndex == 1 && node.identifierType == UA_NODEIDTYPE_GUID;
}

}  // namespace

void Clients::configure(UA_ServerConfig& config, std::size_t loggedInMax,
                        std::size_t connectionsMax) {
  RIVULET_ASSERT(connectionsMax >= loggedInMax + 2);
  m_loggedInMax = loggedInMax;
  m_strangersMax = connectionsMax - loggedInMax;
  // One more: it is taken before another one is closed for it.
  config.maxSecureChannels = static_cast<UA_UInt16>(connectionsMax + 1);
  // One more: it is there before another one is closed for it.
  config.maxSessions = static_cast<UA_UInt16>(loggedInMax + kHalfOpenInAll + 1);
  config.nodeLifecycle.constructor = &Clients::onNode;
  m_activate = std::exchange(config.accessControl.activateSession, &Clients::onActivate);
  m_closeSession = std::exchange(config.accessControl.closeSession, &Clients::onCloseSession);
}

bool Clients::watch(UA_Server* server) {
  m_server = server;
  m_manager = opcua::ownedTcpManager(*UA_Server_getConfig(server)->eventLoop, this);
  if (m_manager != nullptr) {
    m_open = std::exchange(m_manager->openConnection, &Clients::onOpen);
  }
  return m_manager != nullptr;
}

Clients& Clients::of(const UA_ConnectionManager& manager) {
  return *static_cast<Clients*>(opcua::ownerOf(manager));
}

Clients& Clients::of(UA_Server* server) {
  const UA_ConnectionManager* manager =
      opcua::tcpManagerOf(*UA_Server_getConfig(server)->eventLoop);
  RIVULET_ASSERT(manager != nullptr);  // sessions come over connections that are watched
  return of(*manager);
}

void Clients::tell(std::function<void(std::uintptr_t)> closed,
                   std::function<void(std::uintptr_t)> heard) {
  m_closed = std::move(closed);
  m_heard = std::move(heard);
}

const std::string& Clients::network() const {
  static const std::string unknown;
  const auto found = m_origins.find(m_receiving);
  return found == m_origins.end() ? unknown : found->second.network;
}

void Clients::add(const UA_NodeId& session) {
  m_halfOpen.push_back({session, network(), m_now()});
}

void Clients::forget(const UA_NodeId& session) {
  std::erase_if(m_halfOpen,
                [&](const HalfOpen& open) { return UA_NodeId_equal(&open.id, &session); });
}

void Clients::close(std::size_t index) {
  const UA_NodeId id = m_halfOpen[index].id;
  UA_Server_closeSession(m_server, &id);  // calls `onCloseSession`
  forget(id);                             // the library knows it no more
}

void Clients::closeLate() {
  while (!m_halfOpen.empty() && m_now() - m_halfOpen.front().since >= kHalfOpenMax) {
    close(0);
  }
}

/// After a message that has made a session.
void Clients::closeTooMany() {
  const auto isOwn = [this](const HalfOpen& open) { return open.network == network(); };
  const auto own = std::count_if(m_halfOpen.begin(), m_halfOpen.end(), isOwn);
  if (static_cast<std::size_t>(own) > kHalfOpenPerAddress) {
    const auto oldest = std::find_if(m_halfOpen.begin(), m_halfOpen.end(), isOwn);
    close(static_cast<std::size_t>(oldest - m_halfOpen.begin()));
  } else if (m_halfOpen.size() > kHalfOpenInAll) {
    close(0);
  }
}

bool Clients::isStranger(std::uintptr_t connection) const {
  return std::none_of(m_loggedIn.begin(), m_loggedIn.end(),
                      [&](const auto& session) { return session.second == connection; });
}

void Clients::closeTooManyStrangers() {
  struct OfAddress {
    std::size_t count = 0;
    std::map<std::uintptr_t, Origin>::iterator oldest;
  };
  std::map<std::string, OfAddress> addresses;
  std::size_t all = 0;
  for (auto each = m_origins.begin(); each != m_origins.end(); ++each) {
    if (each->second.isClosing || !isStranger(each->first)) {
      continue;
    }
    OfAddress& own = addresses[each->second.network];
    const bool isOldest = own.count == 0 || each->second.serial < own.oldest->second.serial;
    own.oldest = isOldest ? each : own.oldest;
    ++own.count;
    ++all;
  }
  const auto most = std::max_element(
      addresses.begin(), addresses.end(),
      [](const auto& one, const auto& other) { return one.second.count < other.second.count; });
  const bool isTooMany = most != addresses.end() &&
                         (all > m_strangersMax || most->second.count > strangersOfOneAddress());
  if (isTooMany) {
    most->second.oldest->second.isClosing = true;
    m_manager->closeConnection(m_manager, most->second.oldest->first);
  }
}

UA_StatusCode Clients::onNode(UA_Server* server, const UA_NodeId* /*session*/, void* /*context*/,
                              const UA_NodeId* node, void** /*nodeContext*/) noexcept {
  if (isSession(*node)) {
    of(server).add(*node);
  }
  return UA_STATUSCODE_GOOD;
}

UA_StatusCode Clients::onOpen(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                              void* application, void* context,
                              UA_ConnectionManager_connectionCallback callback) noexcept {
  Clients& self = of(*manager);
  self.m_connection = callback;
  return self.m_open(manager, parameters, application, context, &Clients::onConnection);
}

void Clients::onConnection(UA_ConnectionManager* manager, std::uintptr_t connection,
                           void* application, void** context, UA_ConnectionState state,
                           const UA_KeyValueMap* parameters, UA_ByteString message) noexcept {
  Clients& self = of(*manager);
  bool isNew = false;
  if (state == UA_CONNECTIONSTATE_CLOSING) {
    self.m_origins.erase(connection);
    for (auto& [session, itsConnection] : self.m_loggedIn) {
      itsConnection = itsConnection == connection ? 0 : itsConnection;  // numbers are used again
    }
    if (self.m_closed) {
      self.m_closed(connection);
    }
  } else if (parameters != nullptr) {
    const auto* address = static_cast<const UA_String*>(UA_KeyValueMap_getScalar(
        parameters, UA_QUALIFIEDNAME(0, const_cast<char*>("remote-address")),
        &UA_TYPES[UA_TYPES_STRING]));
    if (address != nullptr) {
      isNew = self.m_origins
                  .insert_or_assign(connection,
                                    Origin{networkOf(opcua::view(*address)), ++self.m_taken})
                  .second;
    }
  }
  if (message.length > 0 && self.m_heard) {
    self.m_heard(connection);
  }
  self.m_receiving = connection;
  const std::size_t before = self.m_halfOpen.size();
  self.m_connection(manager, connection, application, context, state, parameters, message);
  if (self.m_halfOpen.size() > before) {
    self.closeTooMany();
  }
  if (isNew) {
    self.closeTooManyStrangers();
  }
  self.m_receiving = 0;
}

UA_StatusCode Clients::onActivate(UA_Server* server, UA_AccessControl* control,
                                  const UA_EndpointDescription* endpoint,
                                  const UA_ByteString* certificate, const UA_NodeId* session,
                                  const UA_ExtensionObject* token, void** context) noexcept {
  Clients& self = of(server);
  const std::string key = keyOf(*session);
  if (!self.m_loggedIn.contains(key) && self.m_loggedIn.size() >= self.m_loggedInMax) {
    return UA_STATUSCODE_BADTOOMANYSESSIONS;
  }
  const UA_StatusCode status =
      self.m_activate(server, control, endpoint, certificate, session, token, context);
  if (status == UA_STATUSCODE_GOOD) {
    self.forget(*session);
    self.m_loggedIn[key] = self.m_receiving;
  }
  return status;
}

void Clients::onCloseSession(UA_Server* server, UA_AccessControl* control, const UA_NodeId* session,
                             void* context) noexcept {
  Clients& self = of(server);
  self.forget(*session);
  self.m_loggedIn.erase(keyOf(*session));
  self.m_closeSession(server, control, session, context);
}

}  // namespace rivulet::machine
