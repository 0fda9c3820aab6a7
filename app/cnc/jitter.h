// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How late position control wakes up, beside cyclictest in the same run. @threadsafety one call,
/// one thread. @source [P3] Fig. 14 and 17
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "cnc/cnc_run.h"

namespace rivulet::cnc {

struct JitterOptions {
  RunOptions run;
  base::Duration duration{};
  bool withLoad = false;  ///< stress-ng on all cores meanwhile
};

/// A distribution of times in microseconds.
struct Distribution {
  std::uint64_t count = 0;
  double min = 0.0;
  double mean = 0.0;
  double p50 = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double max = 0.0;

  [[nodiscard]] double spread() const { return max - min; }
};

struct Jitter {
  RunResult run;
  Distribution wakeUp;       ///< of position control, after each instant
  Distribution cycle;        ///< from set point to set point, less the cycle
  std::uint64_t missed = 0;  ///< set points that came a cycle or more too late
  std::optional<Distribution> cyclictest;
  std::vector<std::string> remarks;  ///< what was not there or not granted
};

[[nodiscard]] Distribution distributionOf(std::vector<base::Duration> times);

/// @return errors of runCnc
[[nodiscard]] base::Result<Jitter> measureJitter(const JitterOptions& options,
                                                 const std::atomic<bool>& stop);

}  // namespace rivulet::cnc
