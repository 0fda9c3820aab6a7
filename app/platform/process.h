// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Who runs this program, where, and with which words. Texts are UTF-8.
/// @threadsafety asks the system; shares nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rivulet::platform {

/// Of the user that runs this program: its name, or its number.
[[nodiscard]] std::string userName();
/// Of this computer; empty: it has none.
[[nodiscard]] std::string hostName();
/// Of this process.
[[nodiscard]] int processId();
/// Of the environment; nothing if it is not set.
[[nodiscard]] std::optional<std::string> variable(const char* name);
/// The words of the command line, the program's name first. @param argc, argv  those of `main`
[[nodiscard]] std::vector<std::string> arguments(int argc, const char* const* argv);

}  // namespace rivulet::platform
