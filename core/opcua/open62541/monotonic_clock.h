// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The clock of the two parts that run in wall time: the real link and the machine's front.
/// @threadsafety plain value; reading is safe from any thread.
#pragma once

#include "base/instant.h"

namespace rivulet::opcua {

/// The operating system's monotonic clock as a time line that starts at construction.
class MonotonicClock {
 public:
  MonotonicClock();

  [[nodiscard]] base::Instant now() const;
  /// Blocks until the time has come; returns at once if it has passed.
  void sleepUntil(base::Instant instant) const;

 private:
  base::Duration m_origin;  ///< what the system's clock showed at construction
};

}  // namespace rivulet::opcua
