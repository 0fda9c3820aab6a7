// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A standstill of the path, and how it is known. @threadsafety plain values.
#pragma once

#include <string_view>

#include "base/instant.h"

namespace rivulet::trace {

enum class PauseOrigin {
  Measured,   ///< from the control's own trace or from feed samples
  Inferred,   ///< from a handshake edge: a STOPRE was passed, the duration is the nominal one
  Predicted,  ///< before the run, from the template and the machine's settings
};

/// "measured", "inferred", "predicted".
[[nodiscard]] std::string_view pauseOriginName(PauseOrigin origin);

struct Pause {
  base::Instant start{};
  base::Duration duration{};
  PauseOrigin origin = PauseOrigin::Measured;
};

}  // namespace rivulet::trace
