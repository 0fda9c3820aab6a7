// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/monotonic_clock.h"

#include <cerrno>
#include <ctime>

#include "base/contract.h"

namespace rivulet::opcua {

namespace {

constexpr long kNanosecondsPerSecond = 1'000'000'000;

base::Duration systemTime() {
  timespec time{};
  RIVULET_ASSERT(clock_gettime(CLOCK_MONOTONIC, &time) == 0);
  return base::Duration{time.tv_sec * kNanosecondsPerSecond + time.tv_nsec};
}

}  // namespace

MonotonicClock::MonotonicClock() : m_origin(systemTime()) {
}

base::Instant MonotonicClock::now() const {
  return base::Instant{systemTime() - m_origin};
}

void MonotonicClock::sleepUntil(base::Instant instant) const {
  // The sum saturates: a caller may pass Instant::max() for "forever".
  const base::Duration sinceOrigin = instant.time_since_epoch();
  const base::Duration absolute = sinceOrigin > base::Duration::max() - m_origin
                                      ? base::Duration::max()
                                      : sinceOrigin + m_origin;
  if (absolute <= systemTime()) {
    return;
  }
  timespec time{};
  time.tv_sec = absolute.count() / kNanosecondsPerSecond;
  time.tv_nsec = absolute.count() % kNanosecondsPerSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

}  // namespace rivulet::opcua
