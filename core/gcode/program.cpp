// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/hash.h"
#include "base/text.h"
#include "gcode/block_observer.h"
#include "gcode/interpreter.h"
#include "gcode/packed_points.h"
#include "gcode/path_deviation.h"
#include "gcode/thinning.h"

namespace rivulet::gcode {

namespace {

/// "O100" of O0100 and 100, as files of numbered programs are called; "": not a number.
std::string numberOf(std::string_view stem) {
  stem.remove_prefix(stem.starts_with('O') ? 1 : 0);
  const bool isNumber = !stem.empty() && std::all_of(stem.begin(), stem.end(), base::isDigit);
  const std::optional<int> number = isNumber ? base::parseInteger(stem) : std::nullopt;
  return number ? fmt::format("O{}", *number) : std::string();
}

/// The files of a folder by the names under which programs call them: NAME.SPF is NAME, whatever
/// the case of its letters; O0100.NC and 100.NC are O100, too.
using FilesByName = std::multimap<std::string, std::filesystem::path, std::less<>>;

FilesByName filesIn(const std::filesystem::path& folder) {
  static constexpr std::array<std::string_view, 9> kEndings{"",     ".SPF", ".MPF", ".SUB", ".NC",
                                                            ".NGC", ".TAP", ".CNC", ".H"};
  FilesByName files;
  std::error_code status;
  for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, status), end;
       !status && entry != end; entry.increment(status)) {
    const std::string file = base::toUpper(entry->path().filename().string());
    for (const std::string_view ending : kEndings) {
      if (!file.ends_with(ending)) {
        continue;
      }
      const std::string stem = file.substr(0, file.size() - ending.size());
      files.emplace(stem, entry->path());
      if (std::string number = numberOf(stem); !number.empty() && number != stem) {
        files.emplace(std::move(number), entry->path());
      }
    }
  }
  return files;
}

std::optional<nc::LoadedText> subprogramIn(const FilesByName& files, std::string_view name) {
  // O<name> of RS-274/NGC is name.ngc.
  if (name.size() > 3 && name.substr(0, 2) == "O<") {
    name = name.substr(2, name.size() - 3);
  }
  const auto [first, last] = files.equal_range(name);
  for (auto file = first; file != last; ++file) {
    std::error_code status;
    if (!std::filesystem::is_regular_file(file->second, status) ||
        std::filesystem::file_size(file->second, status) > nc::kSubprogramBytesMax) {
      continue;
    }
    std::ifstream stream(file->second, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (stream) {
      return nc::LoadedText{base::asUtf8(std::move(text).str()), file->second.filename().string()};
    }
  }
  return std::nullopt;
}

base::Error inFile(base::Error error, std::string file) {
  error.context = std::move(file);
  return error;
}

struct ReadinessText {
  std::string_view name;
  std::string_view sentence;
};

ReadinessText textOf(Readiness readiness) {
  static constexpr std::array<ReadinessText, 4> kReadinessTexts{{
      {"streamable", "The whole path is known: the program can be streamed."},
      {"not understood",
       "Parts of the path are not known: the program cannot be streamed. Correct the errors "
       "first."},
      {"no motion", "The program moves no axis: there is nothing to stream."},
      {"needs a transformation",
       "The whole path is known, but it needs a transformation of the control: no method can "
       "stream it."},
  }};
  return kReadinessTexts[static_cast<std::size_t>(readiness)];
}

bool isError(const Diagnostic& diagnostic) {
  return diagnostic.severity == Severity::Error;
}

bool hasErrors(const Interpretation& read) {
  return std::any_of(read.diagnostics.begin(), read.diagnostics.end(), isError);
}

/// Axes that were not named are equal.
bool isSamePoint(const TrajectoryPoint& a, const TrajectoryPoint& b) {
  constexpr double kToleranceMm = 1e-6;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double first = a.positionMm[axis];
    const double second = b.positionMm[axis];
    if (std::isnan(first) != std::isnan(second) || std::abs(first - second) > kToleranceMm) {
      return false;
    }
  }
  return std::abs(a.feedMmPerS - b.feedMmPerS) <= 1e-9 * std::max(1.0, std::abs(a.feedMmPerS));
}

/// Where two readings of one text part. @return nothing if they are one path
std::optional<Ambiguity> difference(const Interpretation& a, const Interpretation& b) {
  const std::vector<TrajectoryPoint>& first = a.trajectory.points;
  const std::vector<TrajectoryPoint>& second = b.trajectory.points;
  const auto [one, other] =
      std::mismatch(first.begin(), first.end(), second.begin(), second.end(), isSamePoint);
  if (one == first.end() && other == second.end()) {
    return std::nullopt;
  }
  Ambiguity found;
  found.readings[0].dialect = a.dialect;
  found.readings[1].dialect = b.dialect;
  if (one != first.end()) {
    found.readings[0].endMm = one->positionMm;
    found.line = one->line;
  }
  if (other != second.end()) {
    found.readings[1].endMm = other->positionMm;
    found.line = one == first.end() ? other->line : std::min(one->line, other->line);
  }
  return found;
}

/// Reads the text as the other dialects it may be of. One that has words which that control does
/// not know is none. @param again  `read` is of blocks that are not all executed: read it as well
/// @return error BudgetError::Exceeded: for a moment there are two or three paths
base::Result<std::optional<Ambiguity>> findAmbiguity(const std::string& text,
                                                     const LoadOptions& options,
                                                     const std::string& name,
                                                     const Interpretation& read, bool again) {
  LoadOptions own = options;
  own.progress = nullptr;
  const auto as = [&](Dialect dialect) {
    own.dialect = dialect;
    return interpret(text, own, name);
  };
  const auto keepBeside = [&own](const Interpretation& kept) {
    const std::vector<TrajectoryPoint>& points = kept.trajectory.points;
    own.budget = own.budget.without(points.capacity() * sizeof(TrajectoryPoint));
  };
  keepBeside(read);
  std::optional<Interpretation> whole;
  for (const Dialect other : read.otherDialects) {
    if (!whole && again) {
      whole = as(read.dialect);
      keepBeside(*whole);
    }
    const Interpretation& first = whole ? *whole : read;
    if (first.refused) {
      return base::fail(*first.refused);
    }
    if (hasErrors(first)) {
      return std::nullopt;
    }
    own.accepted.clear();  // what one control has, and a person accepts, is no word of another
    const Interpretation second = as(other);
    own.accepted = options.accepted;
    if (second.refused) {
      return base::fail(*second.refused);
    }
    if (hasErrors(second)) {
      continue;
    }
    if (std::optional<Ambiguity> found = difference(first, second)) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string_view noPointName(NoPoint meaning) {
  return meaning == NoPoint::Units ? "units" : "increments";
}

std::optional<NoPoint> noPointOfName(std::string_view name) {
  for (const NoPoint known : {NoPoint::Units, NoPoint::Increments}) {
    if (noPointName(known) == name) {
      return known;
    }
  }
  return std::nullopt;
}

std::string_view readinessName(Readiness readiness) {
  return textOf(readiness).name;
}

std::string_view describe(Readiness readiness) {
  return textOf(readiness).sentence;
}

bool Program::isUnderstood() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(), isError);
}

Readiness Program::readiness() const {
  if (!isUnderstood()) {
    return Readiness::NotUnderstood;
  }
  if (trajectory.points.empty()) {
    return Readiness::NoMotion;
  }
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& diagnostic) {
                       return diagnostic.code == DiagnosticCode::ToolDirections ||
                              diagnostic.code == DiagnosticCode::ToolTip;
                     })
             ? Readiness::NeedsTransformation
             : Readiness::Streamable;
}

std::string describe(const Ambiguity& ambiguity) {
  std::string text;
  for (const Ambiguity::Reading& reading : ambiguity.readings) {
    text += fmt::format("{}as {} the tool goes", text.empty() ? "" : ", ",
                        nc::dialectName(reading.dialect));
    if (!reading.endMm) {
      text += " no further";
      continue;
    }
    text += " to";
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double value = (*reading.endMm)[axis];
      text += std::isnan(value)
                  ? std::string()
                  : fmt::format(" {}{}", base::kAxisNames[axis], base::formatFixed(value, 3));
    }
  }
  return text;
}

const Diagnostic* findingOf(const Program& program, DiagnosticCode code) {
  const auto found = std::find_if(program.diagnostics.begin(), program.diagnostics.end(),
                                  [code](const Diagnostic& each) { return each.code == code; });
  return found == program.diagnostics.end() ? nullptr : &*found;
}

const Diagnostic* openSetting(const Program& program) {
  for (const DiagnosticCode code : {DiagnosticCode::UnitsNotSaid, DiagnosticCode::NoDecimalPoint,
                                    DiagnosticCode::ControlSettingOpen}) {
    if (const Diagnostic* const found = findingOf(program, code)) {
      return found;
    }
  }
  return nullptr;
}

ControlSettings openSettings(const Program& program) {
  ControlSettings open;
  for (const Diagnostic& each : program.diagnostics) {
    if (each.code == DiagnosticCode::ControlSettingOpen) {
      // "G83: stroke=0"
      open.merge(controlSettingsOf(each.argument.substr(each.argument.find(':') + 1)).value());
    }
  }
  return open;
}

namespace {

/// Everything but text and hash.
base::Result<Program> interpretText(const std::string& name, const std::string& text,
                                    const LoadOptions& options, BlockObserver* observer) {
  LoadOptions own = options;
  own.budget = options.budget.without(text.capacity());
  Interpretation interpretation = interpret(text, own, name, observer);
  if (interpretation.refused) {
    return base::fail(inFile(std::move(*interpretation.refused), name));
  }
  if (interpretation.cancelled) {
    return base::fail(GcodeError::Cancelled, "Loading the program was cancelled.", name);
  }
  if (interpretation.blocks == 0) {
    return base::fail(GcodeError::EmptyProgram,
                      "The program has no blocks: choose a file with NC text.", name);
  }
  std::optional<Ambiguity> ambiguity;
  if (interpretation.facts.dependsOnDialect && !interpretation.cancelled) {
    auto found = findAmbiguity(text, own, name, interpretation, observer != nullptr);
    if (!found) {
      return base::fail(inFile(std::move(found.error()), name));
    }
    ambiguity = std::move(*found);
  }
  if (ambiguity) {
    interpretation.diagnostics.insert(interpretation.diagnostics.begin(),
                                      {Severity::Error, ambiguity->line, 1,
                                       DiagnosticCode::DialectUnclear, describe(*ambiguity)});
  }
  Program program{name,
                  {},
                  {},
                  interpretation.dialect,
                  std::move(interpretation.dialectEvidence),
                  std::move(interpretation.trajectory),
                  std::move(interpretation.diagnostics),
                  std::move(interpretation.statistics),
                  std::move(interpretation.facts),
                  ambiguity};
  if (observer == nullptr) {  // who observes counts points
    const std::uint64_t held = program.trajectory.points.capacity() * sizeof(TrajectoryPoint);
    if (auto applied = applyRules(program, options.moveRules, own.budget.without(held)); !applied) {
      return base::fail(inFile(std::move(applied.error()), program.name));
    }
    program.statistics.points = program.trajectory.points.size();
  }
  return program;
}

}  // namespace

base::Result<Program> interpretProgram(std::string name, std::string text,
                                       const LoadOptions& options) {
  return interpretProgram(std::move(name), std::move(text), options, nullptr);
}

base::Result<Program> interpretProgram(std::string name, std::string text,
                                       const LoadOptions& options, BlockObserver* observer) {
  // Converted, a text is there twice.
  if (auto fits = options.budget.require(2.0 * static_cast<double>(text.size()), "The program");
      !fits) {
    return base::fail(inFile(fits.error(), name));
  }
  text = base::asUtf8(std::move(text));
  base::Result<Program> program = interpretText(name, text, options, observer);
  if (program) {
    program->hash = fmt::format("{:016x}", base::hashOfFile(text));
    program->text = std::move(text);
  }
  return program;
}

base::Result<Program> interpretAgain(const Program& read, const LoadOptions& options,
                                     BlockObserver& observer) {
  base::Result<Program> program = interpretText(read.name, read.text, options, &observer);
  if (program) {
    program->hash = read.hash;
  }
  return program;
}

std::string describe(const MergedMoves& merged) {
  return fmt::format("{} of {} points are streamed, at most {:.4f} mm off the program.", merged.to,
                     merged.of, merged.deviationMm);
}

namespace {

/// Merges, and looks whether the path is still the same, in a way of its own.
base::Result<MergedMoves> mergeMoves(Trajectory& trajectory, const MoveRules& rules) {
  if (!(rules.tolerance > 0.0 && rules.tolerance <= kStreamToleranceMax)) {
    return base::fail(
        GcodeError::BadTolerance,
        fmt::format("A tolerance of {} mm cannot be kept: give one above 0, up to {}.",
                    rules.tolerance, kStreamToleranceMax));
  }
  Trajectory merged = thin(trajectory, {rules.tolerance, rules.onSteps}).trajectory;
  std::vector<base::AxisPosition> streamed = placesOf(merged);
  for (base::AxisPosition& place : streamed) {
    place = rules.onSteps ? onSteps(place) : place;
  }
  const auto deviation = pathDeviation(placesOf(trajectory), streamed, rules.tolerance);
  if (!deviation) {
    return base::fail(
        GcodeError::BadTolerance,
        fmt::format("The path cannot be kept within {} mm{}.", rules.tolerance,
                    rules.onSteps ? " where points are packed: they are moved to whole "
                                    "steps of 0.001 mm. Allow more, or do not pack them"
                                  : ""));
  }
  const MergedMoves done{trajectory.points.size(), merged.points.size(), rules.tolerance,
                         *deviation};
  trajectory = std::move(merged);
  return done;
}

}  // namespace

base::Result<bool> applyRules(Program& program, const MoveRules& rules,
                              const base::Budget& budget) {
  Trajectory whole;
  std::optional<MergedMoves> merged;
  if (rules.tolerance != 0.0) {
    whole = program.trajectory;
    auto done = mergeMoves(program.trajectory, rules);
    if (!done) {
      return base::fail(done.error());
    }
    merged = *done;
  }
  const std::size_t before = program.trajectory.points.size();
  if (auto divided = divideLongMoves(program.trajectory, rules, budget); !divided) {
    if (merged) {
      program.trajectory = std::move(whole);
    }
    return base::fail(divided.error());
  }
  program.merged = merged;
  program.statistics.points = program.trajectory.points.size();
  return merged.has_value() || program.trajectory.points.size() != before;
}

std::function<std::optional<nc::LoadedText>(std::string_view name)> subprogramsBeside(
    const std::filesystem::path& file) {
  // Read once, where a program calls anything: a text may call thousands of other names.
  return [folder = file.parent_path(),
          files = std::make_shared<std::optional<FilesByName>>()](std::string_view name) {
    if (!*files) {
      *files = filesIn(folder);
    }
    return subprogramIn(**files, name);
  };
}

base::Result<Program> loadProgram(const std::filesystem::path& path, const LoadOptions& options) {
  const auto unreadable = [&](std::string message) {
    return base::fail(GcodeError::FileUnreadable, std::move(message), path.string());
  };
  std::error_code status;
  const std::filesystem::file_status file = std::filesystem::status(path, status);
  if (file.type() == std::filesystem::file_type::not_found) {
    return unreadable("The file does not exist: check its name and folder.");
  }
  if (file.type() == std::filesystem::file_type::directory) {
    return unreadable("This is a folder: choose an NC program file in it.");
  }
  if (file.type() != std::filesystem::file_type::regular) {
    return unreadable("This is not a regular file: choose an NC program file.");
  }
  const std::uintmax_t bytes = std::filesystem::file_size(path, status);
  if (status) {
    return unreadable("The size of the file cannot be read: check its permissions.");
  }
  if (auto fits = options.budget.require(2.0 * static_cast<double>(bytes), "The program"); !fits) {
    return base::fail(inFile(fits.error(), path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return unreadable("The file cannot be opened: check its permissions.");
  }
  std::string text(static_cast<std::size_t>(bytes), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(stream.gcount()) != bytes) {
    return unreadable("The file could not be read to its end: check the drive and try again.");
  }
  LoadOptions own = options;
  if (!own.subprogram) {
    own.subprogram = subprogramsBeside(path);
  }
  base::Result<Program> program = interpretProgram(path.filename().string(), std::move(text), own);
  if (!program) {
    return base::fail(inFile(program.error(), path.string()));
  }
  return program;
}

}  // namespace rivulet::gcode
