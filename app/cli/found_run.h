// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What can be done with a run that was found, as commands that can be copied.
/// @threadsafety pure.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/run_store.h"

namespace rivulet::cli {

/// A word as a shell takes it.
[[nodiscard]] std::string shellWord(const std::string& word);

/// The command that resumes a run: the one that started it, or for a run of the HMI one with the
/// same settings.
/// @param file  where it is kept
[[nodiscard]] std::string resumeCommand(const report::SavedRun& run,
                                        const std::filesystem::path& file);

/// Whose run is on the control, and the commands to resume, watch and stop it.
[[nodiscard]] std::string adviceFor(const report::FoundRun& run, const std::string& endpoint);

}  // namespace rivulet::cli
