// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/monotonic_clock.h"

#include <windows.h>

#include <timeapi.h>

#include <algorithm>

#include "base/contract.h"

namespace rivulet::opcua {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

base::Duration systemTime() {
  LARGE_INTEGER ticks{};
  LARGE_INTEGER perSecond{};
  RIVULET_ASSERT(QueryPerformanceCounter(&ticks) != 0);
  RIVULET_ASSERT(QueryPerformanceFrequency(&perSecond) != 0);
  const std::int64_t whole = ticks.QuadPart / perSecond.QuadPart;
  const std::int64_t part = ticks.QuadPart % perSecond.QuadPart;
  return base::Duration{whole * kNanosecondsPerSecond +
                        part * kNanosecondsPerSecond / perSecond.QuadPart};
}

}  // namespace

/// Who measures time here waits, too: the system's usual step of 15 ms would be too long for that,
/// also in the library. It stays short until the program ends.
MonotonicClock::MonotonicClock() : m_origin(systemTime()) {
  static const MMRESULT isShort = timeBeginPeriod(1);
  static_cast<void>(isShort);
}

base::Instant MonotonicClock::now() const {
  return base::Instant{systemTime() - m_origin};
}

void MonotonicClock::sleepUntil(base::Instant instant) const {
  constexpr std::int64_t kLongestMs = 3'600'000;
  for (base::Instant is = now(); is < instant; is = now()) {
    // Rounded up: an early return would only mean one more turn.
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(
            std::min<base::Duration>(instant - is, std::chrono::milliseconds{kLongestMs}))
            .count() +
        1;
    Sleep(static_cast<DWORD>(left));
  }
}

}  // namespace rivulet::opcua
