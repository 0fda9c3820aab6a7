// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What runs with a program and with a live source have in common on the command line.
/// @threadsafety main thread.
#pragma once

#include "cli/commands.h"
#include "cli/connection.h"
#include "gcode/program.h"
#include "machine/config.h"
#include "streaming/control/machine_facts.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

[[nodiscard]] streaming::RunSettings settingsOf(const StreamOptions& options,
                                                const gcode::Trajectory& trajectory);

/// One feed for all moves, or those of the program within the limits of the machine.
/// @return as `streaming::requireFeeds`
[[nodiscard]] base::Result<void> takeFeeds(streaming::RunSettings& settings,
                                           const OperatingOptions& options,
                                           const machine::MachineConfig& machine,
                                           const gcode::Program& program);
[[nodiscard]] streaming::FeedCells feedCellsOf(const OperatingOptions& options);

/// @return error BudgetError::Exceeded: the run would take more memory, whatever its method
[[nodiscard]] base::Result<void> requireRunMemory(std::size_t points);

/// What was entered for the machine, where nothing else is said. @return a file of the machine that
/// cannot be read
[[nodiscard]] base::Result<void> takeSilenceLimit(templates::TemplateParameters& parameters,
                                                  const OperatingOptions& options,
                                                  const Connection& connection);

/// What is known of the feed cell on this machine, and how long windows may take without it
/// (`RunSettings::windowSMax`). @return as `takeSilenceLimit`
[[nodiscard]] base::Result<streaming::FeedProof> takeStopLimit(streaming::RunSettings& settings,
                                                               const OperatingOptions& options,
                                                               const Connection& connection);

/// Method credit only if its test has been passed. In virtual time the test is made now.
[[nodiscard]] base::Result<void> requireCreditTest(const Connection& connection);
/// Which whole jobs may run there.
[[nodiscard]] base::Result<streaming::JobRelease> jobRelease(const Connection& connection);
[[nodiscard]] base::Result<void> requireTest(const StreamOptions& options,
                                             const Connection& connection);

}  // namespace rivulet::cli
