// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The certificate by which a program of this user is known to others. It is made when it is first
/// needed and stays until it is renewed. @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "opcua/security.h"

namespace rivulet::trust {

/// Larger files are not read as certificates.
inline constexpr std::uintmax_t kCertificateBytesMax = 65536;

/// A program that has a certificate.
struct Application {
  std::string_view folder;  ///< its certificate's, in the folder of trust
  std::string_view name;    ///< for people, before the name of the computer
  /// Application URI of a server: the same on every computer. Clients keep what they know of a
  /// server under its address and this URI. Empty: a client, with one of its computer.
  std::string_view uri;
};

/// rivulet, rivulet-cli, and what else connects to a control.
inline constexpr Application kClient{"client", "Rivulet", ""};

/// ~/.config/rivulet/trust
[[nodiscard]] std::filesystem::path trustFolder();
/// The certificate itself, without its key, as a control imports it (DER).
[[nodiscard]] std::filesystem::path certificatePath(const std::filesystem::path& folder,
                                                    const Application& application);

/// The certificate, made if there is none. @param folder  `trustFolder()`, or another one
/// @return CertificateInvalid if the files are damaged, NotWritable, Unreadable
[[nodiscard]] base::Result<opcua::OwnCertificate> ownCertificate(
    const std::filesystem::path& folder, const Application& application);

/// Makes a new one. The old one is kept in a folder beside it. Every server that trusts the old one
/// has to be told.
[[nodiscard]] base::Result<opcua::OwnCertificate> renewCertificate(
    const std::filesystem::path& folder, const Application& application);

}  // namespace rivulet::trust
