// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The control's trace, which is fetched in parts. @threadsafety as the link.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/result.h"
#include "trace/control_trace.h"

namespace rivulet::opcua {

struct TracePart {
  std::string bytes;
  std::uint64_t total = 0;  ///< bytes of the whole trace
};

/// @param fetch  the part from this byte on
/// @return the error of a part; Rejected for parts that do not fit together, and those of
/// `parseControlTrace`
[[nodiscard]] base::Result<trace::ControlTrace> joinTrace(
    const std::function<base::Result<TracePart>(std::uint64_t from)>& fetch);

}  // namespace rivulet::opcua
