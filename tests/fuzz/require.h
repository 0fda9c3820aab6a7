// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the fuzz targets share. @threadsafety pure.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace rivulet::tests {

/// Ends the program if a promise is broken; libFuzzer keeps the input.
inline void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// The bytes of libFuzzer as text.
inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace rivulet::tests
