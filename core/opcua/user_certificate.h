// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The certificate by which a user logs in to a server instead of by name and password (OPC UA
/// Part 4, X509IdentityToken). @threadsafety pure.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "base/utc.h"

namespace rivulet::opcua {

/// DER.
struct UserCertificate {
  std::string certificate;
  std::string privateKey;  ///< RSA
};

/// @param certificate,key  contents of files, PEM or DER; one PEM file can hold both
/// @return CertificateInvalid if one of them cannot be used, or the key is of another certificate
[[nodiscard]] base::Result<UserCertificate> readUserCertificate(std::string_view certificate,
                                                                std::string_view key);

/// Before it is shown to a server. @return CertificateInvalid if it has not begun, or has ended
[[nodiscard]] base::Result<void> checkUserCertificate(const UserCertificate& user, base::UtcMs now);

}  // namespace rivulet::opcua
