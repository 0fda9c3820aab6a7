// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The words behind the name of a program mean the same on each system. @threadsafety the main
/// thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rivulet::platform {

/// On Windows the library would take "/jobs/part.nc" for an option.
inline void takeSlashAsPath(CLI::App& app) {
  app.allow_windows_style_options(false);
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    takeSlashAsPath(*command);
  }
}

/// @param app    with all options and subcommands
/// @param words  as `arguments` has them, the program's name first
/// @throws CLI::ParseError  also for help and version
inline void parse(CLI::App& app, const std::vector<std::string>& words) {
  takeSlashAsPath(app);
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  if (!reversed.empty()) {
    reversed.pop_back();  // the name of the program
  }
  app.parse(std::move(reversed));
}

}  // namespace rivulet::platform
