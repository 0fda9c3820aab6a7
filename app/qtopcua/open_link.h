// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Opens a connection with one of the libraries that this build has. @threadsafety pure, except
/// `openLink`, which connects.
#pragma once

#include <optional>
#include <string_view>

#include "base/result.h"
#include "opcua/connection.h"
#include "opcua/open62541/ua_link.h"

namespace rivulet::qtopcua {

/// "open62541", "qtopcua".
[[nodiscard]] std::string_view linkName(opcua::LinkKind kind);
/// Inverse of `linkName`; nothing for any other word.
[[nodiscard]] std::optional<opcua::LinkKind> linkFromName(std::string_view name);

/// Whether this build can make such connections.
[[nodiscard]] bool isAvailable(opcua::LinkKind kind);

/// @return as `opcua::openConnection`, and `LinkKindError`
[[nodiscard]] base::Result<opcua::Connection> openLink(opcua::LinkKind kind,
                                                       const opcua::ConnectOptions& options);

}  // namespace rivulet::qtopcua
