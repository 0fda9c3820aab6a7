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
#include <optional>
#include <span>
#include <vector>

namespace rivulet::base {

/// A job whose whole result is numbers, so that another computer can do it.
/// @param results  to be filled; zeros before
using NumberJob = std::function<void(std::size_t index, std::span<double> results)>;

class Executor {
 public:
  virtual ~Executor() = default;
  /// Calls job(0) to job(count - 1), each exactly once, and returns when all have returned.
  virtual void forEach(std::size_t count, const std::function<void(std::size_t)>& job) = 0;

  /// The numbers of all jobs, `width` of each, one job after the other.
  /// @return nothing if only a share of the jobs is done here (base/share.h): there is nothing to
  /// conclude from it
  [[nodiscard]] virtual std::optional<std::vector<double>> numbersOf(std::size_t count,
                                                                     std::size_t width,
                                                                     const NumberJob& job) {
    std::vector<double> numbers(count * width);
    forEach(count, [&](std::size_t index) {
      job(index, std::span(numbers).subspan(index * width, width));
    });
    return numbers;
  }
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
