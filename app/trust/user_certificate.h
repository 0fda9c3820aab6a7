// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The files of a user's certificate. @threadsafety reads files; shares nothing.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "opcua/user_certificate.h"

namespace rivulet::trust {

/// @param certificate  PEM or DER  @param key  PEM or DER, of mode 0600; empty: it is in the file
/// of the certificate, which has mode 0600 then
/// @return Unreadable, also if others may read the key; CertificateInvalid
[[nodiscard]] base::Result<opcua::UserCertificate> readUserFiles(
    const std::filesystem::path& certificate, const std::filesystem::path& key);

}  // namespace rivulet::trust
