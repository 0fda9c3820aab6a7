// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/writer.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace rivulet::journal {

struct Writer::State {
  struct Entry {
    Job job;
    std::function<void(const base::Result<void>&)> done;
  };
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Entry> waiting;
  bool isEnding = false;
  std::thread thread;

  void work() {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [this] { return !waiting.empty() || isEnding; });
      if (waiting.empty()) {
        return;
      }
      const Entry entry = std::move(waiting.front());
      waiting.pop_front();
      lock.unlock();
      entry.done(entry.job());
      lock.lock();
    }
  }
};

Writer::Writer() : m_state(std::make_unique<State>()) {
  m_state->thread = std::thread([state = m_state.get()] { state->work(); });
}

Writer::~Writer() {
  {
    const std::lock_guard lock(m_state->mutex);
    m_state->isEnding = true;
  }
  m_state->changed.notify_one();
  m_state->thread.join();
}

void Writer::add(Job job, std::function<void(const base::Result<void>&)> done) {
  {
    const std::lock_guard lock(m_state->mutex);
    if (m_state->waiting.size() < kJobsMax) {
      m_state->waiting.push_back({std::move(job), std::move(done)});
      m_state->changed.notify_one();
      return;
    }
  }
  done(base::fail(std::make_error_code(std::errc::io_error),
                  "The disk takes too long to write. Check it."));
}

}  // namespace rivulet::journal
