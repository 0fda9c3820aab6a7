// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The text form of certificates, lists and keys (RFC 7468). @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rivulet::opcua {

/// Whether a text has a part of this label, "CERTIFICATE": "-----BEGIN CERTIFICATE-----".
[[nodiscard]] bool hasPemPart(std::string_view text, std::string_view label);
/// The bytes of the first part of this label. @return nothing if there is none or it is damaged
[[nodiscard]] std::optional<std::string> pemPart(std::string_view text, std::string_view label);

}  // namespace rivulet::opcua
