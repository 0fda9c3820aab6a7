// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a connection is protected: what servers offer (OPC UA Part 4, EndpointDescription; policies
/// of Part 7), what a user allows, and which offer is taken. @threadsafety pure.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "opcua/certificate.h"

namespace rivulet::opcua {

/// From weak to strong: of two policies the later one is taken.
enum class SecurityPolicy {
  None,           ///< anyone on the network reads and changes what is sent
  Basic128Rsa15,  ///< broken (SHA-1, RSA 1.5), only for servers that have nothing else
  Basic256,       ///< withdrawn (SHA-1), only for servers that have nothing else
  Basic256Sha256,
  Aes128Sha256RsaOaep,
  Aes256Sha256RsaPss,
};

/// The numbers are those of the standard.
enum class MessageMode { None = 1, Sign = 2, SignAndEncrypt = 3 };

/// "None", "Basic256Sha256", "Aes128_Sha256_RsaOaep", ... as the standard writes it.
[[nodiscard]] std::string_view policyName(SecurityPolicy policy);
/// "http://opcfoundation.org/UA/SecurityPolicy#Basic256Sha256"
[[nodiscard]] std::string policyUri(SecurityPolicy policy);
/// Inverse of `policyUri`; nothing for a policy that Rivulet does not know.
[[nodiscard]] std::optional<SecurityPolicy> policyOfUri(std::string_view uri);
/// "None", "Sign", "SignAndEncrypt".
[[nodiscard]] std::string_view modeName(MessageMode mode);

/// Withdrawn by the OPC Foundation, or no protection at all.
[[nodiscard]] constexpr bool isWeak(SecurityPolicy policy) {
  return policy < SecurityPolicy::Basic256Sha256;
}

/// How a connection is protected, or one of the ways that a server offers.
struct ChannelSecurity {
  SecurityPolicy policy = SecurityPolicy::None;
  MessageMode mode = MessageMode::None;

  friend bool operator==(const ChannelSecurity&, const ChannelSecurity&) = default;
};

/// "Aes256_Sha256_RsaPss, SignAndEncrypt", or "None".
[[nodiscard]] std::string securityText(const ChannelSecurity& security);

/// One endpoint of a server, without what does not matter for the choice.
struct EndpointOffer {
  ChannelSecurity security;
  std::string certificate;  ///< DER, of the server; may be empty with None
  bool takesAnonymous = false;
  bool takesUserName = false;  ///< and the password is encrypted on its way
  bool takesCertificate = false;
};

/// As whom a client logs in (Part 4, UserIdentityToken).
enum class LoginKind { Anonymous, UserName, Certificate };

/// What the user allows.
struct SecurityChoice {
  /// Nothing: the strongest of those that are not weak.
  std::optional<SecurityPolicy> policy;
  /// Nothing: SignAndEncrypt.
  std::optional<MessageMode> mode;
  /// Takes None if a server offers it, as long as no policy is named. For servers on this computer.
  bool prefersNone = false;

  friend bool operator==(const SecurityChoice&, const SecurityChoice&) = default;
};

/// No protection, chosen by name.
[[nodiscard]] SecurityChoice unencrypted();

/// "strongest", "none", or a policy's name, with "/Sign" or "/SignAndEncrypt" after it; in any
/// case.
/// @return nothing for other words
[[nodiscard]] std::optional<SecurityChoice> securityChoiceOf(std::string_view text);
/// Inverse of `securityChoiceOf`.
[[nodiscard]] std::string securityChoiceText(const SecurityChoice& choice);

/// Which offer is taken. @return the index in `offers`; EncryptionMissing if only weaker ones are
/// offered, LoginRefused if none takes this kind of login
[[nodiscard]] base::Result<std::size_t> chooseOffer(std::span<const EndpointOffer> offers,
                                                    const SecurityChoice& choice, LoginKind login);

/// What can be allowed by name where the strongest is not offered: every offer that takes this
/// kind of login and is taken once it is named, from strong to weak.
[[nodiscard]] std::vector<SecurityChoice> choicesByName(std::span<const EndpointOffer> offers,
                                                        LoginKind login);

/// The host of an endpoint, "cell-4" of "opc.tcp://cell-4:4840/path", without the brackets of IPv6.
[[nodiscard]] std::string hostOf(std::string_view endpoint);

/// Whether the host of an endpoint is this computer by its very address ("127.0.0.1", "[::1]",
/// "localhost"): what is sent to it does not leave the computer.
[[nodiscard]] bool isLoopback(std::string_view endpoint);
/// The port of an address; that of the standard if it names none, 0 if it is no number.
[[nodiscard]] std::uint16_t portOf(std::string_view endpoint);

/// What a person has to know about how a connection is protected.
enum class Protection {
  Encrypted,
  Signed,     ///< nobody changes what is sent, but everybody on the network can read it
  Weak,       ///< a withdrawn policy
  LocalOnly,  ///< none, and what is sent does not leave this computer
  None,
};
[[nodiscard]] Protection protectionOf(const ChannelSecurity& security, std::string_view endpoint);

/// A certificate and its key, DER.
struct OwnCertificate {
  std::string certificate;
  std::string privateKey;
  std::string applicationUri;  ///< as in the certificate
};

/// Decides whether a server's certificate is trusted: nothing, or the error that ends the attempt
/// (CertificateUnknown, CertificateChanged, CertificateInvalid). It is asked before a password is
/// sent. @param der  the certificate
using TrustCheck =
    std::function<base::Result<void>(const CertificateFacts& facts, std::string_view der)>;

}  // namespace rivulet::opcua
