// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Emulators learned from recordings of another motion controller, tested on designs that they were
/// not learned from. @threadsafety pure.
#pragma once

#include <filesystem>
#include <functional>

#include "base/result.h"
#include "papers/experiment.h"

namespace rivulet::papers {

/// Every trace with set points and actual positions in `folder`/data, or in the folder itself, is
/// used: those of G1, G2, G3 and circles to learn, all others only to test. Of traces in two rates
/// the slower is learned from.
/// @param cpuSeconds  of this process so far
/// @return FileUnreadable; errors of the emulator
[[nodiscard]] base::Result<Experiment> runEmulation(const std::filesystem::path& folder,
                                                    const std::function<double()>& cpuSeconds);

}  // namespace rivulet::papers
