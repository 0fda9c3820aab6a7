// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/interrupt.h"

#include <windows.h>

namespace rivulet::interrupt {

namespace {

std::atomic<bool> g_seen{false};
std::atomic<int> g_count{0};

/// On a thread of the system. A console that is closed, and a user that logs out, leave some
/// seconds: the program is ended when this returns.
BOOL WINAPI onControl(DWORD kind) {
  g_seen.store(true);
  g_count.fetch_add(1);
  if (kind != CTRL_C_EVENT && kind != CTRL_BREAK_EVENT) {
    Sleep(INFINITE);
  }
  return TRUE;
}

}  // namespace

void watch() {
  SetConsoleCtrlHandler(&onControl, TRUE);
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
}

}  // namespace rivulet::interrupt
