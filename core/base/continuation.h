// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Two motion blocks of a program on the control, of which the second can follow the first without
/// a preprocessor stop between them. @threadsafety plain values.
#pragma once

#include <compare>

#include "base/id.h"

namespace rivulet::base {

struct Continuation {
  LineNumber from;
  LineNumber to;

  friend constexpr auto operator<=>(const Continuation&, const Continuation&) = default;
};

}  // namespace rivulet::base
