// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/clock.h"

#include <cerrno>
#include <ctime>

#include "base/contract.h"

namespace rivulet::cnc {

namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;

timespec timespecOf(std::int64_t ns) {
  timespec time{};
  time.tv_sec = ns / kNsPerS;
  time.tv_nsec = ns % kNsPerS;
  return time;
}

}  // namespace

std::int64_t monotonicNs() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * kNsPerS + time.tv_nsec;
}

void sleepUntil(std::int64_t ns) {
  const timespec time = timespecOf(ns);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

Semaphore::Semaphore() {
  const int done = sem_init(&m_semaphore, 1, 0);
  RIVULET_ASSERT(done == 0);
}

Semaphore::~Semaphore() {
  sem_destroy(&m_semaphore);
}

void Semaphore::post() {
  sem_post(&m_semaphore);
}

bool Semaphore::wait(std::optional<std::int64_t> until) {
  const timespec time = timespecOf(until.value_or(0));
  for (;;) {
    const int done =
        until ? sem_clockwait(&m_semaphore, CLOCK_MONOTONIC, &time) : sem_wait(&m_semaphore);
    if (done == 0) {
      return true;
    }
    if (errno != EINTR) {
      return false;
    }
  }
}

}  // namespace rivulet::cnc
