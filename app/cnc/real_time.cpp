// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/real_time.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <system_error>
#include <thread>

namespace rivulet::cnc {

std::vector<std::string> makeRealTime(const RealTimeWish& wish) {
  std::vector<std::string> sentences;
  const auto text = [](int error) { return std::generic_category().message(error); };
  if (wish.priority > 0) {
    sched_param parameter{};
    parameter.sched_priority = wish.priority;
    if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter)) {
      sentences.push_back(fmt::format(
          "The system does not grant SCHED_FIFO with priority {} ({}): position control "
          "runs as an ordinary thread, and others can delay it. Allow it with rtprio in "
          "/etc/security/limits.conf or the capability CAP_SYS_NICE.",
          wish.priority, text(error)));
    }
    if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
      sentences.push_back(
          fmt::format("The system does not lock memory ({}): a page that is fetched from disk can "
                      "delay position "
                      "control. Allow it with memlock in /etc/security/limits.conf.",
                      text(errno)));
    }
  }
  if (wish.core >= 0) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    if (wish.core < CPU_SETSIZE) {
      CPU_SET(static_cast<std::size_t>(wish.core), &cores);
    }
    if (const int error = pthread_setaffinity_np(pthread_self(), sizeof cores, &cores)) {
      sentences.push_back(fmt::format(
          "Position control cannot be bound to core {} ({}). Name a core that this computer has.",
          wish.core, text(error)));
    }
  }
  return sentences;
}

bool grantsRealTime() {
  bool isGranted = false;
  std::thread([&isGranted] {
    sched_param parameter{};
    parameter.sched_priority = sched_get_priority_min(SCHED_FIFO);
    isGranted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
  }).join();
  return isGranted;
}

}  // namespace rivulet::cnc
