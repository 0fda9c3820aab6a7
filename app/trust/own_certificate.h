// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The certificate by which a program of this user is known to others. It is made when it is first
/// needed and stays until it is renewed. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.h"
#include "opcua/security.h"

namespace rivulet::trust {

/// Larger files are not read as certificates.
inline constexpr std::uintmax_t kCertificateBytesMax = 65536;

/// Of which program the certificate is.
enum class Owner {
  Client,   ///< rivulet and rivulet-cli
  Machine,  ///< rivulet-machine
};

/// ~/.config/rivulet/trust
[[nodiscard]] std::filesystem::path trustFolder();
/// The certificate itself, without its key, as a control imports it (DER).
[[nodiscard]] std::filesystem::path certificatePath(const std::filesystem::path& folder,
                                                    Owner owner);

/// The certificate, made if there is none. @param folder  `trustFolder()`, or another one
/// @return CertificateInvalid if the files are damaged, NotWritable, Unreadable
[[nodiscard]] base::Result<opcua::OwnCertificate> ownCertificate(
    const std::filesystem::path& folder, Owner owner);

/// Makes a new one. The old one is kept in a folder beside it. Every server that trusts the old one
/// has to be told.
[[nodiscard]] base::Result<opcua::OwnCertificate> renewCertificate(
    const std::filesystem::path& folder, Owner owner);

}  // namespace rivulet::trust
