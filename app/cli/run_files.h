// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the command line says of the files of a run. @threadsafety calls share nothing.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/commands.h"
#include "run/run_record.h"

namespace rivulet::cli {

/// Absolute, or empty if it is.
[[nodiscard]] std::string absolutePath(const std::string& file);

/// The recording that was asked for, and the file to go on from, below `savedKey`.
[[nodiscard]] nlohmann::ordered_json filesJson(const run::RunRecord& record, const char* savedKey);

/// Says on the error stream what is missing, and how an incomplete run goes on.
/// @return false: the recording that was asked for is not complete
bool tellFiles(const run::RunRecord& record);

/// After a motion or a live run: `tellFiles`, and the exit of the whole.
[[nodiscard]] Exit exitAfter(const streaming::RunReport& done, const run::RunRecord& record);

}  // namespace rivulet::cli
