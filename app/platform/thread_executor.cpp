// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/thread_executor.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace rivulet::parallel {

ThreadExecutor::ThreadExecutor(unsigned threads)
    : m_threads(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency())) {
}

void ThreadExecutor::forEach(std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t index = next++; index < count; index = next++) {
      job(index);
    }
  };
  std::vector<std::jthread> helpers;
  const std::size_t threads = std::min<std::size_t>(m_threads, count);
  for (std::size_t i = 1; i < threads; ++i) {
    helpers.emplace_back(work);
  }
  work();
}

}  // namespace rivulet::parallel
