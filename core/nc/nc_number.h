// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Numbers as they are written into blocks for a control. @threadsafety pure.
#pragma once

#include <string>

#include "base/text.h"

namespace rivulet::nc {

/// Decimal, to a millionth: finer than any control resolves. Never with an exponent, which is
/// another word there (12550 on a SINUMERIK). @param value  finite
[[nodiscard]] inline std::string ncNumber(double value) {
  constexpr int kDecimals = 6;
  return base::formatFixed(value, kDecimals);
}

}  // namespace rivulet::nc
