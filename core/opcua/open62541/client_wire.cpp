// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/client_wire.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "opcua/open62541/handle.h"
#include "opcua/open62541/sending_limit.h"
#include "opcua/open62541/tcp_manager.h"

namespace rivulet::opcua {

namespace {

/// "MSG", the kind of the chunk, its size.
constexpr std::size_t kChunkHeader = 8;
/// With the numbers of channel, token, sequence and request.
constexpr std::size_t kMessageHeader = 24;
/// What a node id takes at most: one with a GUID. The type of an answer is no text.
constexpr std::size_t kTypeMax = 19;

bool isNodeId(std::string_view bytes) {
  const UA_ByteString encoded = borrow(bytes);
  UA_NodeId id;
  const UA_StatusCode status = UA_decodeBinary(&encoded, &id, &UA_TYPES[UA_TYPES_NODEID], nullptr);
  if (status == UA_STATUSCODE_GOOD) {
    UA_NodeId_clear(&id);
  }
  return status == UA_STATUSCODE_GOOD;
}

}  // namespace

bool AnswerTypes::take(std::string_view bytes) {
  while (!bytes.empty() && !m_isForeign) {
    const std::size_t wanted =
        m_size == 0 ? kChunkHeader : std::min<std::size_t>(m_size, kMessageHeader + kTypeMax);
    if (m_head.size() < wanted) {
      const std::string_view part = bytes.substr(0, wanted - m_head.size());
      m_head += part;
      m_received += static_cast<std::uint32_t>(part.size());
      bytes.remove_prefix(part.size());
      if (m_head.size() < wanted) {
        return true;
      }
      if (m_size == 0) {
        std::memcpy(&m_size, &m_head[4], sizeof m_size);  // little endian, as this computer
        m_isForeign = m_size <= kChunkHeader;
        continue;
      }
      if (!isReadable()) {
        return false;
      }
    }
    const std::size_t rest = std::min<std::size_t>(m_size - m_received, bytes.size());
    m_received += static_cast<std::uint32_t>(rest);
    bytes.remove_prefix(rest);
    if (m_received == m_size) {
      m_isContinued = m_head[3] == 'C';
      m_head.clear();
      m_size = m_received = 0;
    }
  }
  return true;
}

bool AnswerTypes::isReadable() const {
  const std::string_view head = m_head;
  const bool beginsAnswer = head.starts_with("MSG") && head[3] != 'A' && !m_isContinued;
  return !beginsAnswer || (head.size() > kMessageHeader && isNodeId(head.substr(kMessageHeader)));
}

ClientWire::ClientWire(UA_Client& client, base::Duration sendingMax, bool isEncrypted)
    : m_sendingMaxMs(static_cast<unsigned>(
          std::chrono::duration_cast<std::chrono::milliseconds>(sendingMax).count())),
      m_isEncrypted(isEncrypted) {
  if (auto* manager = ownedTcpManager(*UA_Client_getConfig(&client)->eventLoop, this)) {
    m_open = std::exchange(manager->openConnection, &ClientWire::onOpen);
    m_send = std::exchange(manager->sendWithConnection, &ClientWire::onSend);
  }
}

UA_StatusCode ClientWire::onOpen(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                                 void* application, void* context,
                                 UA_ConnectionManager_connectionCallback callback) noexcept {
  auto& self = *static_cast<ClientWire*>(ownerOf(*manager));
  self.m_receive = callback;
  self.m_answers = {};
  return self.m_open(manager, parameters, application, context, &ClientWire::onReceive);
}

void ClientWire::onReceive(UA_ConnectionManager* manager, std::uintptr_t connection,
                           void* application, void** context, UA_ConnectionState state,
                           const UA_KeyValueMap* parameters, UA_ByteString message) noexcept {
  auto& self = *static_cast<ClientWire*>(ownerOf(*manager));
  if (message.length > 0 && !self.m_isEncrypted) {
    if (!self.m_isUnreadable && !self.m_answers.take(view(message))) {
      self.m_isUnreadable = true;
      manager->closeConnection(manager, connection);
    }
    if (self.m_isUnreadable) {
      return;
    }
  }
  self.m_receive(manager, connection, application, context, state, parameters, message);
}

/// The number of a connection is that of its socket.
UA_StatusCode ClientWire::onSend(UA_ConnectionManager* manager, std::uintptr_t connection,
                                 const UA_KeyValueMap* parameters,
                                 UA_ByteString* message) noexcept {
  const auto& self = *static_cast<const ClientWire*>(ownerOf(*manager));
  endWhenUnconfirmed(connection, self.m_sendingMaxMs);
  return self.m_send(manager, connection, parameters, message);
}

}  // namespace rivulet::opcua
