// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/found_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.h"
#include "gcode/facts.h"

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

namespace {

void addFactor(std::vector<std::string>& command, const streaming::RunSettings& settings) {
  if (settings.parameters.hasFactor()) {
    command.insert(command.end(),
                   {"--feed-factor", fmt::format("{}", settings.parameters.factorLeast),
                    fmt::format("{}", settings.parameters.factorMost)});
  }
  const live::FactorSource& source = settings.factor;
  if (!source.address.empty()) {
    command.insert(command.end(), {"--feed-from", source.address, "--feed-silence",
                                   fmt::format("{}", base::toSeconds(source.silence)),
                                   "--feed-silent", source.holdsInSilence ? "hold" : "override"});
  }
}

void addReading(std::vector<std::string>& command, const gcode::LoadOptions& reading) {
  const gcode::LoadOptions asRead;
  if (reading.dialect) {
    command.insert(command.end(), {"--dialect", std::string(gcode::dialectName(*reading.dialect))});
  }
  if (reading.units) {
    const bool inches = *reading.units == gcode::FileUnits::Inches;
    command.insert(command.end(), {"--units", inches ? "inch" : "mm"});
  }
  if (reading.noPoint) {
    command.insert(command.end(),
                   {"--no-point", std::string(gcode::noPointName(*reading.noPoint))});
  }
  if (!reading.settings.empty()) {
    command.insert(command.end(), {"--setting", gcode::textOf(reading.settings)});
  }
  for (const std::string& name : reading.accepted) {
    command.insert(command.end(), {"--accept", name});
  }
  if (reading.centres != asRead.centres) {
    command.insert(command.end(),
                   {"--arc-centres", std::string(gcode::centreReadingName(reading.centres))});
  }
  if (reading.chordToleranceMm != asRead.chordToleranceMm) {
    command.insert(command.end(),
                   {"--chord-tolerance", fmt::format("{:g}", reading.chordToleranceMm)});
  }
  if (reading.moveRules.tolerance > 0.0) {
    command.insert(command.end(), {"--tolerance", fmt::format("{}", reading.moveRules.tolerance)});
  }
}

/// A command with the settings of a run that was started in the HMI.
std::vector<std::string> commandOf(const report::SavedRun& run) {
  const templates::TemplateParameters& parameters = run.settings.parameters;
  std::vector<std::string> command{"rivulet-cli",
                                   run.job ? "job" : "stream",
                                   run.programFile.empty() ? run.programName : run.programFile,
                                   "--method",
                                   std::string(base::methodName(parameters.method)),
                                   "--points",
                                   std::to_string(parameters.pointsPerLoop),
                                   "--windows",
                                   std::to_string(parameters.windows),
                                   "--base-cell",
                                   std::to_string(parameters.baseCell),
                                   "--axes",
                                   templates::axisLetters(parameters)};
  if (const auto& feeds = run.settings.programFeeds) {
    command.insert(
        command.end(),
        {"--feed", "program", "--override", fmt::format("{:.10g}", 100.0 * feeds->overrideFactor),
         "--rapid", fmt::format("{:.10g}", base::mmPerMinFromMmPerS(feeds->rapidMmPerS))});
  } else {
    command.insert(
        command.end(),
        {"--feed", fmt::format("{:g}", base::mmPerMinFromMmPerS(run.settings.feedMmPerS))});
  }
  command.insert(command.end(), {"--endpoint", run.endpoint});
  addReading(command, run.reading);
  if (parameters.target != templates::TemplateParameters{}.target) {
    command.insert(command.end(),
                   {"--control", std::string(templates::targetName(parameters.target))});
  }
  if (base::goesOn(parameters.method)) {
    command.insert(command.end(), {"--windows-ahead", std::to_string(parameters.windowsAhead)});
    if (!parameters.slowDown) {
      command.emplace_back("--no-slow-down");
    }
  }
  if (parameters.packed) {
    command.emplace_back("--packed");
  }
  if (parameters.correctionLimitMm > 0.0) {
    command.insert(command.end(),
                   {"--correction-limit", fmt::format("{:g}", parameters.correctionLimitMm)});
  }
  if (parameters.liftMm > 0.0) {
    command.insert(command.end(), {"--lift", fmt::format("{:g}", parameters.liftMm)});
  }
  if (parameters.silenceLimitS != templates::kSilenceLimitS) {
    command.insert(command.end(),
                   {"--silence-limit", fmt::format("{:g}", parameters.silenceLimitS)});
  }
  addFactor(command, run.settings);
  return command;
}

}  // namespace

std::string resumeCommand(const report::SavedRun& run, const std::filesystem::path& file) {
  constexpr std::string_view kResume = "--resume";
  // Options for the earlier run are replaced; what was confirmed was that run only.
  constexpr std::array<std::string_view, 2> kWithValue{kResume, "--from-stretch"};
  constexpr std::array<std::string_view, 3> kAlone{"--accept-changes", "--yes", "--from-start"};
  const std::vector<std::string> command = run.command.empty() ? commandOf(run) : run.command;
  std::string text;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const std::string& word = command[i];
    const auto isWord = [&word](std::string_view option) { return word == option; };
    if (std::any_of(kWithValue.begin(), kWithValue.end(), isWord)) {
      ++i;
      continue;
    }
    const bool isInOne =
        std::any_of(kWithValue.begin(), kWithValue.end(), [&word](std::string_view option) {
          return word.starts_with(option) && word[option.size()] == '=';
        });
    if (!isInOne && std::none_of(kAlone.begin(), kAlone.end(), isWord)) {
      text += shellWord(word) + ' ';
    }
  }
  return text + fmt::format("{} {}", kResume, shellWord(file.string()));
}

std::string adviceFor(const report::FoundRun& run, const std::string& endpoint) {
  const std::string asked = "rivulet-cli runs --endpoint " + shellWord(endpoint);
  const std::string_view client = run.onControl.hasClient ? "is still at work" : "is gone";
  std::string text =
      run.onControl.isNative
          ? fmt::format("The control executes {}: blocks of its own, {}, and its client {}.",
                        report::describeRun(run),
                        run.onControl.stretch > 0
                            ? fmt::format("after stretch {}", run.onControl.stretch)
                            : "before its first stretch",
                        client)
      : run.onControl.job != 0
          ? fmt::format(
                "The control executes {}: stretch {}, {} windows of which are done, and "
                "its client {}.",
                report::describeRun(run), run.onControl.stretch, run.onControl.executed, client)
          : fmt::format("The control executes {}: {} windows of it are done, and its client {}.",
                        report::describeRun(run), run.onControl.executed, client);
  if (run.canResume()) {
    text += fmt::format("\n  resume: {}", resumeCommand(*run.saved, run.saved->file));
  } else if (!run.saved && !run.onControl.hasClient && run.onControl.number != 0) {
    text += " It can be resumed on the computer where it was started.";
  }
  return text + fmt::format("\n  watch:  {} --watch\n  stop:   {} --stop\n  end:    {} --end",
                            asked, asked, asked);
}

}  // namespace rivulet::cli
