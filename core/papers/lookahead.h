// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The look-ahead of the virtual machine compared with recordings of another motion planner with
/// known limits: cycle times with exact stops, use of the axes' limits, speed at rounded corners.
/// @threadsafety pure.
#pragma once

#include <filesystem>
#include <functional>

#include "base/result.h"
#include "machine/config.h"
#include "papers/experiment.h"

namespace rivulet::papers {

/// @param folder  with `programs` and `data` (see recorded_run.h)
/// @param wrong  changes the planning machine, to see which checks catch it; may be empty
/// @return FileUnreadable, Malformed
[[nodiscard]] base::Result<Experiment> runLookahead(
    const std::filesystem::path& folder,
    const std::function<void(machine::MachineConfig&)>& wrong = {});

}  // namespace rivulet::papers
