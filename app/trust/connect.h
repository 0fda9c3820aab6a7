// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Opens connections as this user trusts and allows them: the one place where command line and
/// window connect. @threadsafety one call at a time for one folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "opcua/connection.h"
#include "opcua/security.h"
#include "trust/own_certificate.h"

namespace rivulet::trust {

struct ConnectRequest {
  std::string endpoint;
  std::string sessionName = "Rivulet";
  /// Chosen now; remembered for this server once the connection is open. Nothing: as it was
  /// allowed before; else the strongest. A server on this computer that has never been connected
  /// encrypted is then connected without encryption, if it offers that and no user is given: what
  /// is sent does not leave the computer.
  std::optional<opcua::SecurityChoice> security;
  /// This certificate is accepted, whatever was accepted before.
  std::string fingerprint;
  std::string user;  ///< empty: anonymous
  std::string password;
  /// Whether the certificate of a server that is not known is accepted. Empty: no. Never asked
  /// about a certificate that has changed.
  std::function<bool(const opcua::CertificateFacts&)> ask;
};

/// @return as `opcua::openConnection`, and as `TrustStore`
[[nodiscard]] base::Result<opcua::Connection> connect(
    const ConnectRequest& request, const std::filesystem::path& folder = trustFolder());

/// For the window, which cannot ask about certificates yet: a server whose certificate has been
/// accepted is connected encrypted and never otherwise, as is one for which something has been
/// allowed by name; any other one without encryption.
[[nodiscard]] base::Result<opcua::Connection> connectAsKnown(
    const std::string& endpoint, const std::filesystem::path& folder = trustFolder());

/// What a person has to know about a connection that is not protected well; empty if it is.
[[nodiscard]] std::string warningOn(const opcua::Connection& connection);

}  // namespace rivulet::trust
