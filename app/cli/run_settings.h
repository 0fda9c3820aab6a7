// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What runs with a program and with a live source have in common on the command line.
/// @threadsafety main thread.
#pragma once

#include "cli/commands.h"
#include "cli/connection.h"
#include "gcode/trajectory.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

[[nodiscard]] streaming::RunSettings settingsOf(const StreamOptions& options,
                                                const gcode::Trajectory& trajectory);

/// Method credit only if its test has been passed. In virtual time the test is made now.
[[nodiscard]] base::Result<void> requireTest(const StreamOptions& options,
                                             const Connection& connection);

}  // namespace rivulet::cli
