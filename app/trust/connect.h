// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Opens connections as this user trusts and allows them: the one place where command line and
/// window connect. @threadsafety one call at a time for one folder.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "opcua/connection.h"
#include "opcua/open62541/ua_link.h"
#include "trust/own_certificate.h"

namespace rivulet::trust {

/// Makes the connection that has been allowed.
using Opener = std::function<base::Result<opcua::Connection>(const opcua::ConnectOptions&)>;

/// An attempt. What a person can decide is a question; the answer is another attempt, so nothing
/// waits for a person while a connection is half open.
/// @return as `open`, and as `TrustStore`
[[nodiscard]] opcua::Attempt connect(const opcua::ConnectRequest& request,
                                     const std::filesystem::path& folder = trustFolder(),
                                     const Opener& open = opcua::openConnection);

/// What a person has to know about a connection that is not protected well; empty if it is.
[[nodiscard]] std::string warningOn(const opcua::Connection& connection);

}  // namespace rivulet::trust
