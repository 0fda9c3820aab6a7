// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace rivulet::interrupt {

namespace {

std::atomic<bool> g_seen{false};
std::atomic<int> g_count{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch it only so");

extern "C" void onInterrupt(int /*signal*/) {
  g_seen.store(true);
  g_count.fetch_add(1);
}

}  // namespace

void watch() {
  struct sigaction action {};
  action.sa_handler = &onInterrupt;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(number, &action, nullptr);
  }
}

bool wasSeen() {
  return g_seen.load();
}

int count() {
  return g_count.load();
}

const std::atomic<bool>& flag() {
  return g_seen;
}

void leaveToOtherThreads() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace rivulet::interrupt
