// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a user's files are, by the XDG Base Directory Specification: the variable if it holds an
/// absolute path, else the folder below $HOME.
/// @threadsafety reads the environment.
#pragma once

#include <filesystem>

namespace rivulet::folders {

/// $XDG_DATA_HOME or ~/.local/share.
[[nodiscard]] std::filesystem::path dataHome();
/// $XDG_CONFIG_HOME or ~/.config.
[[nodiscard]] std::filesystem::path configHome();
/// $XDG_STATE_HOME or ~/.local/state: what has to survive the end of the program.
[[nodiscard]] std::filesystem::path stateHome();

}  // namespace rivulet::folders
