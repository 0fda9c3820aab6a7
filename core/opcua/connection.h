// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An open connection to a control, whatever made it. @threadsafety that of `Link`.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "opcua/link.h"
#include "opcua/security.h"

namespace rivulet::opcua {

struct Connection {
  std::shared_ptr<void> owner;  ///< keeps both interfaces alive
  Link* link = nullptr;
  Control* control = nullptr;
  std::string name;  ///< the endpoint, or how the simulation was made
  /// Of a connection over a network; nothing in virtual time.
  std::optional<ChannelSecurity> security = std::nullopt;
  /// Of the server; nothing without encryption.
  std::optional<CertificateFacts> certificate = std::nullopt;

  explicit operator bool() const { return link != nullptr; }
};

/// Opens a connection. @return as the maker of the link says: NotReachable, Rejected, ...
using Connector = std::function<base::Result<Connection>(const std::string& endpoint)>;

}  // namespace rivulet::opcua
