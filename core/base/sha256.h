// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// SHA-256 (FIPS 180-4), for chains of lines that show a later change, fingerprints of certificates
/// and hashes of passwords. Here and not from a library because the command line needs it and is
/// also built without Qt. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>

namespace rivulet::base {

/// 64 hexadecimal digits, lower case.
[[nodiscard]] std::string sha256Hex(std::string_view bytes);

/// A password as it is kept: PBKDF2 with HMAC-SHA-256 (RFC 8018), 64 hexadecimal digits.
/// @param iterations  at least 1; the time it takes is proportional to them
[[nodiscard]] std::string passwordHashHex(std::string_view password, std::string_view salt,
                                          int iterations);

/// 64 lower-case digits from a hash as people write it, with or without colons and blanks; empty if
/// it is none.
[[nodiscard]] std::string sha256OfText(std::string_view text);

}  // namespace rivulet::base
