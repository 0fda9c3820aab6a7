// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What `host_check` asks the system. @threadsafety asks the system; shares nothing.
#pragma once

#include <string>

namespace rivulet::opcua {

/// This program may open one more connection.
[[nodiscard]] bool hasRoomForSocket();

enum class NameLookup {
  Found,
  Unknown,   ///< no computer has this name
  NoAnswer,  ///< nobody could be asked
};

/// Blocks for as long as the system asks its name servers.
[[nodiscard]] NameLookup lookUpName(const std::string& host);

}  // namespace rivulet::opcua
