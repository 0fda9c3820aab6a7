// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Work that would stop the window. @threadsafety GUI thread.
#pragma once

#include <functional>

namespace rivulet::hmi {

/// Runs work in the global pool; what it returns is then called on the GUI thread.
void runInBackground(std::function<std::function<void()>()> work);

}  // namespace rivulet::hmi
