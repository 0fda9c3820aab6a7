// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/client_gate.h"

#include <open62541/server_config_default.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/contract.h"
#include "opcua/open62541/handle.h"

namespace rivulet::machine {

namespace {

using opcua::SecurityPolicy;

using AddPolicy = UA_StatusCode (*)(UA_ServerConfig*, const UA_ByteString*, const UA_ByteString*);

struct OfferedPolicy {
  SecurityPolicy policy;
  AddPolicy add;
};

constexpr std::array<OfferedPolicy, 3> kPolicies{
    {{SecurityPolicy::Basic256Sha256, &UA_ServerConfig_addSecurityPolicyBasic256Sha256},
     {SecurityPolicy::Aes128Sha256RsaOaep, &UA_ServerConfig_addSecurityPolicyAes128Sha256RsaOaep},
     {SecurityPolicy::Aes256Sha256RsaPss, &UA_ServerConfig_addSecurityPolicyAes256Sha256RsaPss}}};

[[nodiscard]] UA_StatusCode addEndpoint(UA_ServerConfig& config, SecurityPolicy policy,
                                        UA_MessageSecurityMode mode) {
  const std::string uri = opcua::policyUri(policy);
  const UA_StatusCode status = UA_ServerConfig_addEndpoint(&config, opcua::borrow(uri), mode);
  if (status == UA_STATUSCODE_GOOD) {
    // Clients that have no opinion take the largest level.
    constexpr int kPerMode = 10;
    config.endpoints[config.endpointsSize - 1].securityLevel =
        static_cast<UA_Byte>(kPerMode * (static_cast<int>(mode) - 1) + static_cast<int>(policy));
  }
  return status;
}

/// Of a certificate that is known: whether it still holds.
[[nodiscard]] UA_StatusCode judgeValidity(const opcua::CertificateFacts& facts,
                                          std::span<const opcua::RevocationList> revocations,
                                          const UA_ByteString& chain) {
  if (opcua::isRevoked(revocations, opcua::view(chain))) {
    return UA_STATUSCODE_BADCERTIFICATEREVOKED;
  }
  const base::UtcMs now =
      (UA_DateTime_now() - UA_DATETIME_UNIX_EPOCH) / static_cast<UA_DateTime>(UA_DATETIME_MSEC);
  return opcua::isValidAt(facts, now) ? UA_STATUSCODE_GOOD
                                      : UA_STATUSCODE_BADCERTIFICATETIMEINVALID;
}

}  // namespace

ClientGate::ClientGate(UserManagement users, std::function<base::Instant()> now,
                       const ServerOptions& options)
    : m_now(std::move(now)),
      m_clients(m_now),
      m_login(std::move(users)),
      m_trusted(options.trustedClients),
      m_revocations(options.revocations),
      m_onRefused(options.onRefusedClient),
      m_onFailedLogin(options.onFailedLogin) {
}

UA_StatusCode ClientGate::install(UA_ServerConfig& config, const ServerOptions& options) {
  UA_StatusCode status = UA_ServerConfig_setBasics_withPort(&config, options.port);
  if (status != UA_STATUSCODE_GOOD) {
    return status;
  }
  for (UA_CertificateVerification* verification : {&config.secureChannelPKI, &config.sessionPKI}) {
    if (verification->clear != nullptr) {
      verification->clear(verification);
    }
    *verification = {};
  }
  status |= addPolicies(config, options);
  for (UA_CertificateVerification* verification : {&config.secureChannelPKI, &config.sessionPKI}) {
    verification->context = this;
    verification->verifyApplicationURI = &ClientGate::onVerifyUri;
    verification->logging = config.logging;
  }
  // The library offers a login by certificate if it can verify one now.
  if (m_login.takesCertificates()) {
    config.sessionPKI.verifyCertificate = &ClientGate::onVerifyUser;
  }
  status |= addLogin(config);
  config.secureChannelPKI.verifyCertificate = &ClientGate::onVerify;
  config.sessionPKI.verifyCertificate = &ClientGate::onVerifyUser;
  return status;
}

UA_StatusCode ClientGate::addPolicies(UA_ServerConfig& config, const ServerOptions& options) {
  // Clients ask for the endpoints on a connection without encryption.
  UA_ByteString certificate =
      options.certificate ? opcua::borrow(options.certificate->certificate) : UA_BYTESTRING_NULL;
  UA_StatusCode status = UA_ServerConfig_addSecurityPolicyNone(&config, &certificate);
  config.securityPolicyNoneDiscoveryOnly = !options.unencrypted;
  if (options.unencrypted) {
    status |= addEndpoint(config, SecurityPolicy::None, UA_MESSAGESECURITYMODE_NONE);
  }
  if (!options.certificate) {
    return status;
  }
  const UA_ByteString key = opcua::borrow(options.certificate->privateKey);
  for (const OfferedPolicy& offered : kPolicies) {
    status |= offered.add(&config, &certificate, &key);
    status |= addEndpoint(config, offered.policy, UA_MESSAGESECURITYMODE_SIGN);
    status |= addEndpoint(config, offered.policy, UA_MESSAGESECURITYMODE_SIGNANDENCRYPT);
  }
  return status;
}

UA_StatusCode ClientGate::addLogin(UA_ServerConfig& config) {
  // The library wants one user to offer names and passwords at all. It never checks this one,
  // because the callback does, and it replaces the policy by that of each endpoint.
  const UA_UsernamePasswordLogin placeholder{UA_STRING_NULL, UA_STRING_NULL};
  const std::string uri = opcua::policyUri(SecurityPolicy::Basic256Sha256);
  const UA_ByteString policy = opcua::borrow(uri);
  const UA_StatusCode status = UA_AccessControl_defaultWithLoginCallback(
      &config, m_login.letsAnonymousIn(), &policy, m_login.takesPasswords() ? 1 : 0, &placeholder,
      &ClientGate::onLogin, this);
  config.accessControl.getUserAccessLevel = &ClientGate::onAccessLevel;
  return status;
}

bool ClientGate::isKindTaken(const UA_ExtensionObject& token) const {
  if (token.encoding == UA_EXTENSIONOBJECT_ENCODED_NOBODY) {
    return true;  // anonymous
  }
  return token.encoding >= UA_EXTENSIONOBJECT_DECODED &&
         (token.content.decoded.type == &UA_TYPES[UA_TYPES_ANONYMOUSIDENTITYTOKEN] ||
          token.content.decoded.type == &UA_TYPES[UA_TYPES_USERNAMEIDENTITYTOKEN] ||
          (token.content.decoded.type == &UA_TYPES[UA_TYPES_X509IDENTITYTOKEN] &&
           m_login.takesCertificates()));
}

void ClientGate::nameUser(const UA_ExtensionObject& token, void** session) const {
  if (token.encoding < UA_EXTENSIONOBJECT_DECODED ||
      token.content.decoded.type != &UA_TYPES[UA_TYPES_X509IDENTITYTOKEN]) {
    return;
  }
  const auto* shown = static_cast<const UA_X509IdentityToken*>(token.content.decoded.data);
  const auto facts = opcua::readCertificate(opcua::view(shown->certificateData));
  const User* user = facts ? m_login.findByCertificate(facts->fingerprint) : nullptr;
  RIVULET_ASSERT(user != nullptr);     // else `onVerifyUser` has refused it
  *session = const_cast<User*>(user);  // the library hands it back, and nothing else
}

UA_StatusCode ClientGate::judge(const UA_ByteString& chain) const {
  const auto facts = opcua::readCertificate(opcua::view(chain));
  if (!facts) {
    return UA_STATUSCODE_BADCERTIFICATEINVALID;
  }
  if (m_trusted && !m_trusted->contains(facts->fingerprint)) {
    if (m_onRefused) {
      m_onRefused(*facts, opcua::leafOf(opcua::view(chain)));
    }
    return UA_STATUSCODE_BADCERTIFICATEUNTRUSTED;
  }
  return judgeValidity(*facts, m_revocations, chain);
}

/// The library has not checked yet that the client has the key; it does so before the session is
/// let in.
UA_StatusCode ClientGate::judgeUser(const UA_ByteString& chain) const {
  const auto facts = opcua::readCertificate(opcua::view(chain));
  if (!facts || m_login.findByCertificate(facts->fingerprint) == nullptr) {
    return UA_STATUSCODE_BADIDENTITYTOKENREJECTED;
  }
  return judgeValidity(*facts, m_revocations, chain);
}

UA_StatusCode ClientGate::onVerifyUser(const UA_CertificateVerification* verification,
                                       const UA_ByteString* certificate) noexcept {
  return static_cast<const ClientGate*>(verification->context)->judgeUser(*certificate);
}

UA_StatusCode ClientGate::onVerify(const UA_CertificateVerification* verification,
                                   const UA_ByteString* certificate) noexcept {
  return static_cast<const ClientGate*>(verification->context)->judge(*certificate);
}

UA_StatusCode ClientGate::onVerifyUri(const UA_CertificateVerification* /*verification*/,
                                      const UA_ByteString* certificate,
                                      const UA_String* applicationUri) noexcept {
  const auto facts = opcua::readCertificate(opcua::view(*certificate));
  const bool isNamed =
      facts && std::find(facts->applicationUris.begin(), facts->applicationUris.end(),
                         opcua::view(*applicationUri)) != facts->applicationUris.end();
  return isNamed ? UA_STATUSCODE_GOOD : UA_STATUSCODE_BADCERTIFICATEURIINVALID;
}

UA_StatusCode ClientGate::onLogin(const UA_String* user, const UA_ByteString* password,
                                  std::size_t /*count*/, const UA_UsernamePasswordLogin* /*logins*/,
                                  void** session, void* gate) noexcept {
  auto& self = *static_cast<ClientGate*>(gate);
  const Login::Outcome outcome = self.m_login.check(opcua::view(*user), opcua::view(*password),
                                                    self.m_clients.network(), self.m_now());
  const User* found = outcome.user;
  if (outcome.failure && self.m_onFailedLogin) {
    self.m_onFailedLogin(*outcome.failure);
  }
  *session = const_cast<User*>(found);  // the library hands it back, and nothing else
  return found != nullptr ? UA_STATUSCODE_GOOD : UA_STATUSCODE_BADUSERACCESSDENIED;
}

UA_Byte ClientGate::onAccessLevel(UA_Server* /*server*/, UA_AccessControl* /*control*/,
                                  const UA_NodeId* /*session*/, void* user, const UA_NodeId* node,
                                  void* /*context*/) noexcept {
  constexpr UA_Byte kAll = 0xFF;
  if (user == nullptr || node->namespaceIndex == 0) {
    return kAll;  // without a name, or about the server itself
  }
  const std::set<std::string>& rights = static_cast<const User*>(user)->rights;
  unsigned level = 0;
  if (rights.contains("SinuReadAll") || rights.contains("StateRead")) {
    level |= UA_ACCESSLEVELMASK_READ;
  }
  if (rights.contains("SinuWriteAll") || rights.contains("StateWrite")) {
    level |= UA_ACCESSLEVELMASK_WRITE;
  }
  return static_cast<UA_Byte>(level);
}

}  // namespace rivulet::machine
