// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Revocation lists (RFC 5280, 5): which certificates of an issuer hold no more. Their signatures
/// are not checked: a list counts because this computer's user has put it in place, and the worst a
/// false one does is to refuse. @threadsafety pure.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/utc.h"

namespace rivulet::opcua {

struct RevocationList {
  std::string issuer;     ///< "CN=..., O=..."
  std::string issuerDer;  ///< the same as the issuer has written it
  base::UtcMs issuedAt = 0;
  std::optional<base::UtcMs> nextAt;  ///< when the issuer gives out the next one; nothing: not said
  std::set<std::string> serials;      ///< of the certificates that hold no more, as bytes
};

/// @param bytes  DER or PEM  @return CertificateInvalid
[[nodiscard]] base::Result<RevocationList> readRevocationList(std::string_view bytes);

/// Whether a list of its issuer names this certificate. @param certificate  DER; bytes after it are
/// not looked at
[[nodiscard]] bool isRevoked(std::span<const RevocationList> lists, std::string_view certificate);

}  // namespace rivulet::opcua
