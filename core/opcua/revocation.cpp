// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/revocation.h"

#include <algorithm>
#include <utility>

#include "opcua/der.h"
#include "opcua/error.h"
#include "opcua/pem.h"

namespace rivulet::opcua {

namespace {

using der::DerReader;

constexpr unsigned char kVersion = 0xA0;

/// The signed part of a certificate or a list.
DerReader signedPartOf(std::string_view bytes) {
  DerReader outer(bytes);
  const auto whole = outer.take(der::kSequence);
  DerReader members(whole ? whole->content : std::string_view());
  const auto body = members.take(der::kSequence);
  return DerReader(body ? body->content : std::string_view());
}

std::optional<RevocationList> listOf(std::string_view bytes) {
  DerReader reader = signedPartOf(bytes);
  reader.take(der::kInteger);  // the version
  const auto algorithm = reader.take(der::kSequence);
  const auto issuer = reader.take(der::kSequence);
  const auto issuedAt = der::timeOf(reader.takeAny());
  if (!algorithm || !issuer || !issuedAt) {
    return std::nullopt;
  }
  RevocationList list;
  list.issuer = der::nameText(issuer->content);
  list.issuerDer = issuer->content;
  list.issuedAt = *issuedAt;
  if (const auto next = reader.peek();
      next && (next->tag == der::kUtcTime || next->tag == der::kGeneralizedTime)) {
    list.nextAt = der::timeOf(reader.takeAny());
    if (!list.nextAt) {
      return std::nullopt;
    }
  }
  const auto entries = reader.take(der::kSequence);
  DerReader certificates(entries ? entries->content : std::string_view());
  while (const auto entry = certificates.takeAny()) {
    const auto serial = DerReader(entry->content).take(der::kInteger);
    if (!serial) {
      return std::nullopt;
    }
    list.serials.insert(std::string(serial->content));
  }
  return certificates.isAtEnd() ? std::optional(std::move(list)) : std::nullopt;
}

}  // namespace

base::Result<RevocationList> readRevocationList(std::string_view bytes) {
  const auto unpacked = pemPart(bytes, "X509 CRL");
  auto list = listOf(unpacked ? std::string_view(*unpacked) : bytes);
  if (!list) {
    return base::fail(LinkError::CertificateInvalid,
                      "This is no revocation list (X.509 CRL, DER or PEM). Ask the issuer of the "
                      "certificates for one.");
  }
  return std::move(*list);
}

bool isRevoked(std::span<const RevocationList> lists, std::string_view certificate) {
  DerReader reader = signedPartOf(certificate);
  reader.take(kVersion);
  const auto serial = reader.take(der::kInteger);
  reader.take(der::kSequence);  // algorithm of the signature
  const auto issuer = reader.take(der::kSequence);
  return serial && issuer && std::any_of(lists.begin(), lists.end(), [&](const auto& list) {
           return list.issuerDer == issuer->content &&
                  list.serials.contains(std::string(serial->content));
         });
}

}  // namespace rivulet::opcua
