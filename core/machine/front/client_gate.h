// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which clients the server lets in, how their connections are protected, and what a user may do:
/// the security part of the server's configuration. @threadsafety as the server.
#pragma once

#include <open62541/plugin/accesscontrol_default.h>
#include <open62541/server.h>

#include <functional>
#include <vector>

#include "machine/front/clients.h"
#include "machine/front/login.h"
#include "machine/front/server.h"

namespace rivulet::machine {

class ClientGate {
 public:
  /// @param users  who may log in  @param now  for locks of users after wrong passwords
  ClientGate(UserManagement users, std::function<base::Instant()> now,
             const ServerOptions& options);
  ClientGate(const ClientGate&) = delete;
  ClientGate& operator=(const ClientGate&) = delete;

  /// Sets up endpoints, security policies and access control of an otherwise default configuration.
  /// The configuration refers to this object, which outlives its server.
  [[nodiscard]] UA_StatusCode install(UA_ServerConfig& config, const ServerOptions& options);

  /// Before the library checks a login: it would let everybody in who shows any certificate.
  [[nodiscard]] bool isKindTaken(const UA_ExtensionObject& token) const;
  /// After the library has let somebody in: a login by certificate leaves the session without its
  /// user. @param session  gets it
  void nameUser(const UA_ExtensionObject& token, void** session) const;

  /// Where messages come from, and who is not logged in yet.
  [[nodiscard]] Clients& clients() { return m_clients; }

 private:
  [[nodiscard]] static UA_StatusCode addPolicies(UA_ServerConfig& config,
                                                 const ServerOptions& options);
  [[nodiscard]] UA_StatusCode addLogin(UA_ServerConfig& config);
  [[nodiscard]] UA_StatusCode judge(const UA_ByteString& chain) const;
  [[nodiscard]] UA_StatusCode judgeUser(const UA_ByteString& chain) const;

  static UA_StatusCode onVerify(const UA_CertificateVerification* verification,
                                const UA_ByteString* certificate) noexcept;
  static UA_StatusCode onVerifyUser(const UA_CertificateVerification* verification,
                                    const UA_ByteString* certificate) noexcept;
  static UA_StatusCode onVerifyUri(const UA_CertificateVerification* verification,
                                   const UA_ByteString* certificate,
                                   const UA_String* applicationUri) noexcept;
  static UA_StatusCode onLogin(const UA_String* user, const UA_ByteString* password, std::size_t,
                               const UA_UsernamePasswordLogin*, void** session,
                               void* gate) noexcept;
  static UA_Byte onAccessLevel(UA_Server* server, UA_AccessControl* control,
                               const UA_NodeId* session, void* user, const UA_NodeId* node,
                               void* context) noexcept;

  std::function<base::Instant()> m_now;
  Clients m_clients;
  Login m_login;
  std::optional<std::set<std::string>> m_trusted;
  std::vector<opcua::RevocationList> m_revocations;
  std::function<void(const opcua::CertificateFacts&, std::string_view)> m_onRefused;
  std::function<void(const LoginFailure&)> m_onFailedLogin;
};

}  // namespace rivulet::machine
