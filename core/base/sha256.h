// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// SHA-256 (FIPS 180-4), for chains of lines that show a later change. Here and not from a library
/// because the command line has to check a chain and is also built without Qt. @threadsafety pure.
#pragma once

#include <string>
#include <string_view>

namespace rivulet::base {

/// 64 hexadecimal digits, lower case.
[[nodiscard]] std::string sha256Hex(std::string_view bytes);

}  // namespace rivulet::base
