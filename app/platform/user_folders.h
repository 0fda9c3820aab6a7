// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where a user's files are, by the XDG Base Directory Specification: the variable if it holds an
/// absolute path, else the folder below $HOME; on Windows %LOCALAPPDATA%, for settings %APPDATA%.
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

/// Gives a damaged file another name in its folder, so that a new one does not destroy what
/// somebody may still want: "name.damaged", or "name.damaged-2" and so on if that is taken.
/// @return the new name; empty: it cannot be renamed
[[nodiscard]] std::filesystem::path moveAside(const std::filesystem::path& file);

}  // namespace rivulet::folders
