// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Many independent jobs, on as many threads as the application chooses. Core starts no threads:
/// the application provides an executor. Each job gets its own seed and writes to its own place, so
/// the result does not depend on the number of threads.
/// @threadsafety `forEach` is called on one thread at a time; jobs may run at the same time.
#pragma once

#include <cstddef>
#include <functional>

namespace rivulet::base {

class Executor {
 public:
  virtual ~Executor() = default;
  /// Calls job(0) to job(count - 1), each exactly once, and returns when all have returned.
  virtual void forEach(std::size_t count, const std::function<void(std::size_t)>& job) = 0;
};

/// One job after another on the calling thread.
class SerialExecutor final : public Executor {
 public:
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    for (std::size_t index = 0; index < count; ++index) {
      job(index);
    }
  }
};

}  // namespace rivulet::base
