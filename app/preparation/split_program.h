// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A program as it is run: as a whole job where that is wanted and possible, else its motion alone.
/// @threadsafety reads the files of subprograms, else pure.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "base/error.h"
#include "gcode/program.h"
#include "job/plan.h"

namespace rivulet::preparation {

struct SplitProgram {
  std::shared_ptr<const gcode::Program> program;
  /// Of a job, or of the blocks that are left out; null: it could not be split, or was cancelled.
  std::shared_ptr<const job::Plan> plan;
  std::optional<base::Error> dryRunError{};
};

/// Reads the same text again, block by block. A program that cannot be split stays as it is.
/// @param options  with which the program was read  @param path  subprograms are looked for beside
/// it  @param asJob  a whole job is wanted  @param dryRunMm  > 0: dry, so much higher
/// @param machine  that runs it
[[nodiscard]] SplitProgram splitProgram(gcode::Program program, gcode::LoadOptions options,
                                        const std::filesystem::path& path, bool asJob,
                                        double dryRunMm, const job::Profile& machine);

/// The same program with its moves merged and divided by the rules; the very same if nothing has to
/// be done, or if the path would not fit into the memory allowed. What cannot be kept within the
/// tolerance is not merged: `gcode::Program::merged` says so.
[[nodiscard]] std::shared_ptr<const gcode::Program> programByRules(
    std::shared_ptr<const gcode::Program> program, const gcode::MoveRules& rules,
    const base::Budget& budget = {});

}  // namespace rivulet::preparation
