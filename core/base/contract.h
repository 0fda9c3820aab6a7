// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// `RIVULET_ASSERT(condition)`: a bug in Rivulet if false; checked in release builds too.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace rivulet::base {

[[noreturn]] inline void contractViolated(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: internal error, expected: %s\n", file, line, condition);
  std::abort();
}

}  // namespace rivulet::base

#define RIVULET_ASSERT(condition)     \
  ((condition) ? static_cast<void>(0) \
               : ::rivulet::base::contractViolated(#condition, __FILE__, __LINE__))
