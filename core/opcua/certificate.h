// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a person has to see of a certificate before trusting it. Reads the DER encoding of X.509
/// (RFC 5280) and checks no signature: a certificate is trusted because it is the very one that was
/// accepted before, and its owner proves possession of the key when the connection is opened.
/// @threadsafety pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/utc.h"

namespace rivulet::opcua {

struct CertificateFacts {
  std::string fingerprint;  ///< SHA-256 of the DER bytes, 64 hexadecimal digits, lower case
  std::string subject;      ///< "CN=..., O=..."
  std::string issuer;       ///< as `subject`; equal to it if the certificate is self-signed
  base::UtcMs validFrom = 0;
  base::UtcMs validTo = 0;
  std::vector<std::string> applicationUris;  ///< of the subject's alternative names
  std::vector<std::string> hostNames;        ///< there, too: names, and addresses of IPv4
  /// Of the server that has shown it: the URI by which it calls itself, if the certificate does not
  /// name it. Empty: it does, or no server has shown it.
  std::string strangerUri{};

  friend bool operator==(const CertificateFacts&, const CertificateFacts&) = default;
};

/// @param der  one certificate; bytes after it (the rest of a chain) are not looked at
/// @return error CertificateInvalid
[[nodiscard]] base::Result<CertificateFacts> readCertificate(std::string_view der);

/// The first certificate of a chain; empty if there is none. A server may send the chain as one
/// text.
[[nodiscard]] std::string_view leafOf(std::string_view chain);

/// The fingerprint as people compare it: "A1:B2:...".
[[nodiscard]] std::string fingerprintText(std::string_view fingerprint);
/// 64 lower-case digits from a fingerprint with or without colons and blanks; empty if it is none.
[[nodiscard]] std::string fingerprintOf(std::string_view text);

/// Whether the certificate was made for this host; a certificate without hosts was made for none.
[[nodiscard]] bool isForHost(const CertificateFacts& facts, std::string_view host);

/// Whether the certificate has begun and not ended.
[[nodiscard]] inline bool isValidAt(const CertificateFacts& facts, base::UtcMs now) {
  return now >= facts.validFrom && now <= facts.validTo;
}

/// Whole days until the certificate ends; negative if it has ended.
[[nodiscard]] int daysLeft(const CertificateFacts& facts, base::UtcMs now);

}  // namespace rivulet::opcua
