// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/user_certificate.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "opcua/certificate.h"
#include "opcua/der.h"
#include "opcua/error.h"
#include "opcua/pem.h"

namespace rivulet::opcua {

namespace {

/// The modulus of an RSA key of RFC 8017 (PKCS #1).
std::optional<std::string_view> rsaModulus(std::string_view key) {
  der::DerReader outer(key);
  const auto body = outer.take(der::kSequence);
  der::DerReader members(body ? body->content : std::string_view());
  members.take(der::kInteger);  // the version
  const auto modulus = members.take(der::kInteger);
  return modulus ? std::optional(modulus->content) : std::nullopt;
}

/// The same of a key that may be packed as RFC 5208 (PKCS #8) has it.
std::optional<std::string_view> modulusOf(std::string_view key) {
  der::DerReader outer(key);
  const auto body = outer.take(der::kSequence);
  der::DerReader members(body ? body->content : std::string_view());
  members.take(der::kInteger);  // the version
  const bool isPacked = members.take(der::kSequence).has_value();
  const auto packed = members.take(der::kOctetString);
  return isPacked && packed ? rsaModulus(packed->content) : rsaModulus(key);
}

tl::unexpected<base::Error> unusable(const char* message) {
  return base::fail(LinkError::CertificateInvalid, message);
}

/// Without the time of the day.
std::string dateText(base::UtcMs at) {
  constexpr std::size_t kDateLength = 10;
  return base::utcText(at).substr(0, kDateLength);
}

}  // namespace

base::Result<UserCertificate> readUserCertificate(std::string_view certificate,
                                                  std::string_view key) {
  UserCertificate user;
  user.certificate = leafOf(pemPart(certificate, "CERTIFICATE").value_or(std::string(certificate)));
  if (!readCertificate(user.certificate)) {
    return unusable(
        "This file holds no certificate (X.509, DER or PEM). Give the one of the user.");
  }
  if (hasPemPart(key, "ENCRYPTED PRIVATE KEY") ||
      key.find("4,ENCRYPTED") != std::string_view::npos) {
    return unusable(
        "The key of the user's certificate is locked by a password. Save it without one (openssl "
        "pkey -in KEY -out NEW) in a file that only you can read (chmod 600).");
  }
  auto unpacked = pemPart(key, "PRIVATE KEY");
  if (!unpacked) {
    unpacked = pemPart(key, "RSA PRIVATE KEY");
  }
  user.privateKey = unpacked.value_or(std::string(key));
  const auto modulus = modulusOf(user.privateKey);
  constexpr std::size_t kModulusBytesMin = 128;
  if (!modulus || modulus->size() < kModulusBytesMin) {
    return unusable(
        "This file holds no RSA key (DER or PEM). Give the key of the user's certificate.");
  }
  if (user.certificate.find(*modulus) == std::string::npos) {
    return unusable(
        "The key does not belong to the user's certificate. Give the two files of one user.");
  }
  return user;
}

base::Result<void> checkUserCertificate(const UserCertificate& user, base::UtcMs now) {
  const auto facts = readCertificate(user.certificate);
  if (!facts) {
    return base::fail(facts.error());
  }
  if (!isValidAt(*facts, now)) {
    return base::fail(LinkError::CertificateInvalid,
                      fmt::format("The user's certificate is valid from {} to {} only. Set the "
                                  "clock of this computer, or ask its issuer for a new one.",
                                  dateText(facts->validFrom), dateText(facts->validTo)));
  }
  return {};
}

}  // namespace rivulet::opcua
