// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The clock of the pipeline: monotonic, so that nobody can set it. @threadsafety any thread.
#pragma once

#include <semaphore.h>

#include <cstdint>
#include <optional>

namespace rivulet::cnc {

/// ns since some origin of this computer.
[[nodiscard]] std::int64_t monotonicNs();
/// Returns at the instant, not before, whatever signals come.
void sleepUntil(std::int64_t monotonicNs);

/// A semaphore for threads and for processes that share its memory. Those of Boost wait by the time
/// of day, which can be set.
class Semaphore {
 public:
  Semaphore();
  ~Semaphore();
  Semaphore(const Semaphore&) = delete;
  Semaphore& operator=(const Semaphore&) = delete;

  /// @threadsafety any thread, signal handlers too
  void post();
  /// @param until  as monotonicNs() says; nothing: for ever @return false at that time
  bool wait(std::optional<std::int64_t> until = {});

 private:
  sem_t m_semaphore;
};

}  // namespace rivulet::cnc
