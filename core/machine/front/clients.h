// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the messages of a server come from, and which of its sessions and connections are not
/// logged in. Those have a small share of their own: whoever opens connections or creates sessions
/// without activating them keeps nobody out.
/// @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/instant.h"

namespace rivulet::machine {

/// A session that has not logged in by then is closed.
inline constexpr base::Duration kHalfOpenMax = std::chrono::seconds(5);
/// So many of one address; one more closes the oldest of them.
inline constexpr std::size_t kHalfOpenPerAddress = 3;
/// So many of all addresses.
inline constexpr std::size_t kHalfOpenInAll = 12;

/// The address as far as it tells clients apart: who has an IPv6 network has 2^64 addresses, so
/// only the first 64 bits count.
[[nodiscard]] std::string networkOf(std::string_view address);

class Clients {
 public:
  /// @param now  of the server
  explicit Clients(std::function<base::Instant()> now) : m_now(std::move(now)) {}
  Clients(const Clients&) = delete;
  Clients& operator=(const Clients&) = delete;

  /// The last change of access control before the server is made. This object outlives the server.
  /// @param loggedInMax  sessions that are logged in at a time; further ones are refused
  /// @param connectionsMax  at a time; what is left beside the sessions is for connections that
  ///                        nobody has logged in on, of one address a half of that. One more
  ///                        closes the oldest of the address that has most
  /// @pre connectionsMax >= loggedInMax + 2
  void configure(UA_ServerConfig& config, std::size_t loggedInMax, std::size_t connectionsMax);
  /// After the server is made. @return false: its connections cannot be watched
  [[nodiscard]] bool watch(UA_Server* server);
  /// The object that watches the connections of this manager.
  [[nodiscard]] static Clients& of(const UA_ConnectionManager& manager);

  /// @param closed, heard  told of connections; called while a message is handled
  void tell(std::function<void(std::uintptr_t)> closed, std::function<void(std::uintptr_t)> heard);

  [[nodiscard]] UA_Server* server() const { return m_server; }
  [[nodiscard]] UA_ConnectionManager* manager() const { return m_manager; }
  /// The connection whose message is being handled; 0: none.
  [[nodiscard]] std::uintptr_t receiving() const { return m_receiving; }
  /// Where it comes from, see `networkOf`; empty: not known.
  [[nodiscard]] const std::string& network() const;
  /// Closes sessions that have not logged in in time. In each turn of the server.
  void closeLate();

 private:
  struct HalfOpen {
    UA_NodeId id{};  ///< a GUID: owns nothing
    std::string network;
    base::Instant since{};
  };

  [[nodiscard]] static Clients& of(UA_Server* server);
  void add(const UA_NodeId& session);
  void forget(const UA_NodeId& session);
  void close(std::size_t index);
  void closeTooMany();
  /// After a connection has been taken.
  void closeTooManyStrangers();

  static UA_StatusCode onNode(UA_Server* server, const UA_NodeId* session, void* context,
                              const UA_NodeId* node, void** nodeContext) noexcept;
  static UA_StatusCode onOpen(UA_ConnectionManager* manager, const UA_KeyValueMap* parameters,
                              void* application, void* context,
                              UA_ConnectionManager_connectionCallback callback) noexcept;
  static void onConnection(UA_ConnectionManager* manager, std::uintptr_t connection,
                           void* application, void** context, UA_ConnectionState state,
                           const UA_KeyValueMap* parameters, UA_ByteString message) noexcept;
  static UA_StatusCode onActivate(UA_Server* server, UA_AccessControl* control,
                                  const UA_EndpointDescription* endpoint,
                                  const UA_ByteString* certificate, const UA_NodeId* session,
                                  const UA_ExtensionObject* token, void** context) noexcept;
  static void onCloseSession(UA_Server* server, UA_AccessControl* control, const UA_NodeId* session,
                             void* context) noexcept;

  std::function<base::Instant()> m_now;
  std::function<void(std::uintptr_t)> m_closed;
  std::function<void(std::uintptr_t)> m_heard;
  UA_Server* m_server = nullptr;
  UA_ConnectionManager* m_manager = nullptr;
  decltype(UA_ConnectionManager::openConnection) m_open = nullptr;
  UA_ConnectionManager_connectionCallback m_connection = nullptr;
  decltype(UA_AccessControl::activateSession) m_activate = nullptr;
  decltype(UA_AccessControl::closeSession) m_closeSession = nullptr;
  std::size_t m_loggedInMax = 0;
  std::uintptr_t m_receiving = 0;
  /// Of a connection.
  struct Origin {
    std::string network;
    std::uint64_t serial = 0;  ///< the order in which they were taken
    bool isClosing = false;
  };
  [[nodiscard]] bool isStranger(std::uintptr_t connection) const;
  [[nodiscard]] std::size_t strangersOfOneAddress() const { return m_strangersMax / 2; }

  std::map<std::uintptr_t, Origin> m_origins;
  std::uint64_t m_taken = 0;
  std::size_t m_strangersMax = 0;
  std::vector<HalfOpen> m_halfOpen;  ///< the oldest first
  /// Sessions, and their connections; 0: it is gone.
  std::map<std::string, std::uintptr_t> m_loggedIn;
};

}  // namespace rivulet::machine
