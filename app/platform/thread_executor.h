// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs independent jobs on several threads. Their results do not depend on the number of threads.
/// @threadsafety `forEach` blocks its caller; the threads end with it.
#pragma once

#include "base/executor.h"

namespace rivulet::parallel {

class ThreadExecutor final : public base::Executor {
 public:
  /// @param threads  0: one per core
  explicit ThreadExecutor(unsigned threads = 0);
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override;

 private:
  unsigned m_threads;
};

}  // namespace rivulet::parallel
