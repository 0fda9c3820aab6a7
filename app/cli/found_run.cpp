// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/found_run.h"

#include <fmt/format.h>

#include <algorithm>

namespace rivulet::cli {

std::string shellWord(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,+-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::string resumeCommand(const std::vector<std::string>& command,
                          const std::filesystem::path& file) {
  constexpr std::string_view kResume = "--resume";
  if (command.empty()) {
    return "Open the window and press Resume.";
  }
  std::string text;
  for (std::size_t i = 0; i < command.size(); ++i) {
    // The option for the earlier run is replaced; a change was accepted for that run only.
    const std::string& word = command[i];
    if (word == kResume) {
      ++i;
    } else if (word != "--accept-changes" && !word.starts_with("--resume=")) {
      text += shellWord(word) + ' ';
    }
  }
  return text + fmt::format("{} {}", kResume, shellWord(file.string()));
}

std::string adviceFor(const report::FoundRun& run, const std::string& endpoint) {
  const std::string asked = "rivulet-cli runs --endpoint " + shellWord(endpoint);
  std::string text =
      fmt::format("The control executes {}: {} windows of it are done, and its client {}.",
                  report::describeRun(run), run.onControl.executed,
                  run.onControl.hasClient ? "is still at work" : "is gone");
  if (run.canResume()) {
    text += fmt::format("\n  resume: {}", resumeCommand(run.saved->command, run.saved->file));
  } else if (!run.onControl.hasClient && run.onControl.number != 0) {
    text += " It can be resumed on the computer where it was started.";
  }
  return text + fmt::format("\n  watch:  {} --watch\n  stop:   {} --stop", asked, asked);
}

}  // namespace rivulet::cli
