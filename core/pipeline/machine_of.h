// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machine as the tasks of a pipeline see it. @threadsafety pure.
#pragma once

#include "machine/config.h"

namespace rivulet::pipeline {

/// Nobody presses cycle start: M0 and M1 do not wait. Tools that are missing are accepted.
[[nodiscard]] machine::MachineConfig pipelineMachine(machine::MachineConfig config);

}  // namespace rivulet::pipeline
