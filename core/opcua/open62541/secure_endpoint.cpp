// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/secure_endpoint.h"

#include <open62541/client_config_default.h>
#include <open62541/plugin/securitypolicy_default.h>

#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/contract.h"
#include "base/secret.h"

namespace rivulet::opcua {

namespace {

/// The policy by which a login is encrypted; nothing for one that Rivulet does not know.
[[nodiscard]] std::optional<SecurityPolicy> tokenPolicy(const UA_EndpointDescription& endpoint,
                                                        const UA_UserTokenPolicy& token) {
  return policyOfUri(view(token.securityPolicyUri.length > 0 ? token.securityPolicyUri
                                                             : endpoint.securityPolicyUri));
}

[[nodiscard]] UA_UserTokenType tokenTypeOf(LoginKind login) {
  switch (login) {
    case LoginKind::Anonymous:
      return UA_USERTOKENTYPE_ANONYMOUS;
    case LoginKind::UserName:
      return UA_USERTOKENTYPE_USERNAME;
    case LoginKind::Certificate:
      break;
  }
  return UA_USERTOKENTYPE_CERTIFICATE;
}

/// How an endpoint takes this kind of login: null if it does not, only with a password that can be
/// read on its way, or with a certificate on a channel that somebody else could take over.
[[nodiscard]] const UA_UserTokenPolicy* findToken(const UA_EndpointDescription& endpoint,
                                                  LoginKind login) {
  const UA_UserTokenType wanted = tokenTypeOf(login);
  for (std::size_t i = 0; i < endpoint.userIdentityTokensSize; ++i) {
    const UA_UserTokenPolicy& token = endpoint.userIdentityTokens[i];
    const auto policy = tokenPolicy(endpoint, token);
    const bool isProtected = policy && *policy != SecurityPolicy::None;
    const bool isSafe =
        login == LoginKind::Anonymous ||
        (login == LoginKind::UserName &&
         (isProtected || endpoint.securityMode == UA_MESSAGESECURITYMODE_SIGNANDENCRYPT)) ||
        (isProtected && endpoint.securityMode != UA_MESSAGESECURITYMODE_NONE);
    if (token.tokenType == wanted && policy && isSafe) {
      return &token;
    }
  }
  return nullptr;
}

using MakePolicy = UA_StatusCode (*)(UA_SecurityPolicy*, UA_ByteString, UA_ByteString,
                                     const UA_Logger*);

[[nodiscard]] MakePolicy makerOf(SecurityPolicy policy) {
  switch (policy) {
    case SecurityPolicy::Basic128Rsa15:
      return &UA_SecurityPolicy_Basic128Rsa15;
    case SecurityPolicy::Basic256:
      return &UA_SecurityPolicy_Basic256;
    case SecurityPolicy::Basic256Sha256:
      return &UA_SecurityPolicy_Basic256Sha256;
    case SecurityPolicy::Aes128Sha256RsaOaep:
      return &UA_SecurityPolicy_Aes128Sha256RsaOaep;
    case SecurityPolicy::Aes256Sha256RsaPss:
      return &UA_SecurityPolicy_Aes256Sha256RsaPss;
    case SecurityPolicy::None:
      break;
  }
  return nullptr;
}

/// Adds a policy to a list of the library; None is always there.
[[nodiscard]] UA_StatusCode addPolicy(std::size_t& count, UA_SecurityPolicy*& list,
                                      SecurityPolicy policy, const OwnCertificate& own,
                                      const UA_Logger* logger) {
  const MakePolicy make = makerOf(policy);
  if (make == nullptr) {
    return UA_STATUSCODE_GOOD;
  }
  auto* grown =
      static_cast<UA_SecurityPolicy*>(UA_realloc(list, (count + 1) * sizeof(UA_SecurityPolicy)));
  if (grown == nullptr) {
    return UA_STATUSCODE_BADOUTOFMEMORY;
  }
  list = grown;
  const UA_StatusCode status =
      make(&list[count], borrow(own.certificate), borrow(own.privateKey), logger);
  count += status == UA_STATUSCODE_GOOD ? 1 : 0;
  return status;
}

/// Only the very certificate of the endpoint is accepted; whether it is trusted has been decided.
UA_StatusCode verifyServer(const UA_CertificateVerification* verification,
                           const UA_ByteString* chain) noexcept {
  const auto* expected = static_cast<const UA_ByteString*>(verification->context);
  return leafOf(view(*chain)) == leafOf(view(*expected)) ? UA_STATUSCODE_GOOD
                                                         : UA_STATUSCODE_BADCERTIFICATEUNTRUSTED;
}

/// The library asks this of our own certificate only.
UA_StatusCode verifyUri(const UA_CertificateVerification* /*verification*/,
                        const UA_ByteString* /*certificate*/,
                        const UA_String* /*applicationUri*/) noexcept {
  return UA_STATUSCODE_GOOD;
}

/// Shows the certificate of the user. That the user has its key, the library proves with the policy
/// of the login.
[[nodiscard]] UA_StatusCode setUserCertificate(UA_ClientConfig& config,
                                               const UserCertificate& user) {
  UA_X509IdentityToken* token = UA_X509IdentityToken_new();
  if (token == nullptr) {
    return UA_STATUSCODE_BADOUTOFMEMORY;
  }
  UA_ExtensionObject_setValue(&config.userIdentityToken, token,
                              &UA_TYPES[UA_TYPES_X509IDENTITYTOKEN]);
  const UA_ByteString certificate = borrow(user.certificate);
  return UA_ByteString_copy(&certificate, &token->certificateData);
}

[[nodiscard]] UA_StatusCode setUser(UA_ClientConfig& config, const ConnectOptions& options) {
  switch (loginKindOf(options)) {
    case LoginKind::Anonymous:
      return UA_STATUSCODE_GOOD;
    case LoginKind::UserName:
      return UA_ClientConfig_setAuthenticationUsername(&config, options.user.c_str(),
                                                       options.password.c_str());
    case LoginKind::Certificate:
      break;
  }
  return setUserCertificate(config, *options.userCertificate);
}

}  // namespace

std::vector<EndpointOffer> offersOf(const Endpoints& endpoints) {
  std::vector<EndpointOffer> offers;
  for (std::size_t i = 0; i < endpoints.count; ++i) {
    const UA_EndpointDescription& endpoint = endpoints.list[i];
    const auto policy = policyOfUri(view(endpoint.securityPolicyUri));
    const bool isModeKnown = endpoint.securityMode >= UA_MESSAGESECURITYMODE_NONE &&
                             endpoint.securityMode <= UA_MESSAGESECURITYMODE_SIGNANDENCRYPT;
    const std::string_view profile = view(endpoint.transportProfileUri);
    // Siemens servers leave it empty.
    const bool isBinary = profile.empty() || profile.find("uatcp-uasc-uabinary") != profile.npos;
    EndpointOffer offer;
    if (policy && isModeKnown && isBinary) {
      offer.security = {*policy, static_cast<MessageMode>(endpoint.securityMode)};
      offer.takesAnonymous = findToken(endpoint, LoginKind::Anonymous) != nullptr;
      offer.takesUserName = findToken(endpoint, LoginKind::UserName) != nullptr;
      offer.takesCertificate = findToken(endpoint, LoginKind::Certificate) != nullptr;
    } else {
      offer.security = {SecurityPolicy::None,
                        MessageMode::Sign};  // contradicts itself: never taken
    }
    offers.push_back(std::move(offer));
  }
  return offers;
}

UA_StatusCode protect(UA_ClientConfig& config, const SecureEndpoint& endpoint,
                      const ConnectOptions& options, const OwnCertificate& own) {
  const UA_EndpointDescription& description = *endpoint.description.get();
  const auto policy = policyOfUri(view(description.securityPolicyUri));
  const LoginKind kind = loginKindOf(options);
  const UA_UserTokenPolicy* token = findToken(description, kind);
  RIVULET_ASSERT(policy && token != nullptr);
  const SecurityPolicy login = *tokenPolicy(description, *token);

  UA_StatusCode status =
      addPolicy(config.securityPoliciesSize, config.securityPolicies, *policy, own, config.logging);
  if (login != *policy) {
    status |=
        addPolicy(config.securityPoliciesSize, config.securityPolicies, login, own, config.logging);
  }
  OwnCertificate signer = own;
  if (kind == LoginKind::Certificate) {
    signer.certificate = options.userCertificate->certificate;
    signer.privateKey = options.userCertificate->privateKey;
  }
  status |= addPolicy(config.authSecurityPoliciesSize, config.authSecurityPolicies, login, signer,
                      config.logging);
  base::wipe(signer.privateKey);
  status |= UA_copy(&description, &config.endpoint, &UA_TYPES[UA_TYPES_ENDPOINTDESCRIPTION]);
  status |= UA_copy(token, &config.userTokenPolicy, &UA_TYPES[UA_TYPES_USERTOKENPOLICY]);
  const UA_String uri = borrow(own.applicationUri);
  UA_String_clear(&config.clientDescription.applicationUri);
  status |= UA_String_copy(&uri, &config.clientDescription.applicationUri);
  status |= setUser(config, options);

  UA_CertificateVerification& verification = config.certificateVerification;
  if (verification.clear != nullptr) {
    verification.clear(&verification);
  }
  verification = {};
  verification.context = const_cast<UA_ByteString*>(&description.serverCertificate);  // only read
  verification.verifyCertificate = &verifyServer;
  verification.verifyApplicationURI = &verifyUri;
  verification.logging = config.logging;
  return status;
}

void forgetPassword(UA_ClientConfig& config) {
  UA_ExtensionObject& token = config.userIdentityToken;
  if (token.encoding >= UA_EXTENSIONOBJECT_DECODED &&
      token.content.decoded.type == &UA_TYPES[UA_TYPES_USERNAMEIDENTITYTOKEN]) {
    UA_ByteString_memZero(
        &static_cast<UA_UserNameIdentityToken*>(token.content.decoded.data)->password);
  }
  UA_ExtensionObject_clear(&token);
}

}  // namespace rivulet::opcua
