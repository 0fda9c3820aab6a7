// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How a program without a window is told to end: it finishes what it must not leave, and ends.
/// @threadsafety any thread.
#pragma once

#include <atomic>

namespace rivulet::interrupt {

/// From now on Ctrl-C, SIGTERM and a closed terminal (SIGHUP) do not end the program; `wasSeen`
/// reports them.
void watch();

[[nodiscard]] bool wasSeen();
/// How often so far.
[[nodiscard]] int count();
/// The same, for code that is also told to end by others.
[[nodiscard]] const std::atomic<bool>& flag();

/// Called by a thread that is not to be interrupted by what the system tells this program.
void leaveToOtherThreads();

}  // namespace rivulet::interrupt
