// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the OPC UA library needs for encrypted connections. @threadsafety pure, except
/// `makeCertificate`: one at a time.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "opcua/security.h"

namespace rivulet::opcua {

struct CertificateRequest {
  std::string commonName;              ///< "Rivulet@cell-4"
  std::string applicationUri;          ///< "urn:cell-4:rivulet"
  std::vector<std::string> hostNames;  ///< under which others reach the application
  int days = 5 * 365;                  ///< valid from now on, at most 65535
};

/// A new RSA key of 2048 bits and its self-signed certificate, with the key usage that OPC UA asks
/// for (Part 6, 6.2.2). Takes up to some seconds.
/// @return CertificateInvalid if the library cannot make one
[[nodiscard]] base::Result<OwnCertificate> makeCertificate(const CertificateRequest& request);

/// The library that encrypts for the OPC UA library, as it is loaded in this process:
/// "/usr/lib/.../libmbedcrypto.so.16". Empty if the OPC UA library cannot encrypt.
[[nodiscard]] std::string encryptionLibrary();

}  // namespace rivulet::opcua
