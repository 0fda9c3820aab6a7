// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a client sends and receives, below the library, which needs help with two things: it sends
/// for ever while the other side takes nothing, and (up to 1.5.7 at least) it clears memory that it
/// has never written when the type of an answer cannot be read. @threadsafety as the client.
#pragma once

#include <open62541/client.h>
#include <open62541/plugin/eventloop.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/instant.h"

namespace rivulet::opcua {

/// The chunks of one connection as they arrive, cut anywhere (OPC 10000-6, 6.7.2).
class AnswerTypes {
 public:
  /// @return false: the type of an answer cannot be read; none of `bytes` may go to the library,
  /// nor anything after them
  [[nodiscard]] bool take(std::string_view bytes);

 private:
  /// Whether the chunk that `m_head` begins may go to the library.
  [[nodiscard]] bool isReadable() const;

  std::string m_head;            ///< of the present chunk, as much of it as is looked at
  std::uint32_t m_size = 0;      ///< of the present chunk; 0: not known yet
  std::uint32_t m_received = 0;  ///< of the present chunk
  bool m_isContinued = false;    ///< the present chunk is not the first of its message
  bool m_isForeign = false;      ///< not OPC UA: left to the library
};

class ClientWire {
 public:
  /// @param client  not connected yet; deleted before this
  /// @param sendingMax  the system ends a connection on which nothing was confirmed for so long
  /// @param isEncrypted  answers cannot be looked at; only a server with the trusted certificate
  ///   can have written them
  ClientWire(UA_Client& client, base::Duration sendingMax, bool isEncrypted);
  ClientWire(const ClientWire&) = delete;
  ClientWire& operator=(const ClientWire&) = delete;

  /// The connection was closed here, because the type of an answer cannot be read.
  [[nodiscard]] bool isUnreadable() const { return m_isUnreadable; }

 private:
  static UA_StatusCode onOpen(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                              void* application, void* context,
                              UA_ConnectionManager_connectionCallback callback) noexcept;
  static void onReceive(UA_ConnectionManager* manager, std::uintptr_t connection, void* application,
                        void** context, UA_ConnectionState state, const UA_KeyValueMap* parameters,
                        UA_ByteString message) noexcept;
  static UA_StatusCode onSend(UA_ConnectionManager* manager, std::uintptr_t connection,
                              const UA_KeyValueMap* parameters, UA_ByteString* message) noexcept;

  unsigned m_sendingMaxMs;
  bool m_isEncrypted;
  bool m_isUnreadable = false;
  AnswerTypes m_answers;  ///< of the present connection
  decltype(UA_ConnectionManager::openConnection) m_open = nullptr;
  decltype(UA_ConnectionManager::sendWithConnection) m_send = nullptr;
  UA_ConnectionManager_connectionCallback m_receive = nullptr;
};

}  // namespace rivulet::opcua
