// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the programs that measure speed share.
#pragma once

#include <time.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <utility>
#include <vector>

#include "base/quantile.h"
#include "base/result.h"

namespace rivulet::bench {

/// @param values  in any order, not empty
[[nodiscard]] inline double quantileOf(std::vector<double> values, std::size_t perMille) {
  std::sort(values.begin(), values.end());
  return base::quantile(values, perMille);
}

/// What must be there; else the program ends.
template <class Value>
Value required(base::Result<Value> result) {
  if (!result) {
    fmt::print(stderr, "{}\n", result.error().text());
    std::exit(1);
  }
  return std::move(*result);
}

template <class Work>
[[nodiscard]] double microseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Of this process: a busy machine makes no difference while all work is done on one thread.
[[nodiscard]] inline double processorS() {
  timespec spent{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

/// Memory of this program that is in use now.
[[nodiscard]] inline double residentMb() {
  std::ifstream statm("/proc/self/statm");
  long pages = 0;
  long resident = 0;
  statm >> pages >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace rivulet::bench
