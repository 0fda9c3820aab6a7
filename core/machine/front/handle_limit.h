// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whether this program may open as many connections as the server promises. The library (1.4)
/// closes the socket on which it listens, for good, when it may open no further one: so the limit
/// must not be met. @threadsafety changes the limit of the process; call before the server starts.
#pragma once

#include <cstddef>

#include "base/result.h"

namespace rivulet::machine {

/// Raises the limit of open files to what is needed, if it is lower and may be raised.
/// @param connections  that the server takes at most  @return FrontError::TooFewHandles
[[nodiscard]] base::Result<void> requireHandles(std::size_t connections);

}  // namespace rivulet::machine
