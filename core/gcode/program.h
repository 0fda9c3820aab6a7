// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A loaded NC program: text, trajectory, findings and figures. Immutable once made; the HMI
/// and the stream share it as `shared_ptr<const Program>`.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "gcode/control_settings.h"
#include "gcode/diagnostic.h"
#include "gcode/error.h"
#include "gcode/facts.h"
#include "gcode/feeds.h"
#include "gcode/trajectory.h"
#include "nc/flow/cursor.h"
#include "nc/limits.h"
#include "nc/syntax/dialect.h"

namespace rivulet::gcode {

using nc::detectDialect;
using nc::Dialect;
using nc::dialectName;
using nc::dialectOfName;
using nc::kDialects;

/// Findings kept of one program.
inline constexpr std::size_t kDiagnosticsMax = 1000;
/// How often the same finding is listed; the first one says how many there are.
inline constexpr std::size_t kRepeatsListed = 20;
using nc::kRepeatedLinesMax;

enum class NoPoint : unsigned char {
  Units,       ///< X10 is 10 mm or 10 inch
  Increments,  ///< X10 is ten of the least increment: 0.01 mm, 0.001 inch
};
/// "units", "increments": for files and options.
[[nodiscard]] std::string_view noPointName(NoPoint meaning);
[[nodiscard]] std::optional<NoPoint> noPointOfName(std::string_view name);

/// How a person wants a text to be read: what it leaves open, and how finely its curves are
/// divided. Belongs to a run, so that the same points come out when it is resumed.
struct TextReading {
  /// Coarser chords are no picture of an arc.
  static constexpr double kChordToleranceMmMax = 10.0;

  double chordToleranceMm = 0.005;  ///< greatest distance of chords from their arc or spline, > 0
  CentreReading centres = CentreReading::AsProgrammed;  ///< what I, J and K of arcs are
  std::optional<Dialect> dialect;                       ///< nothing: as detected from the text
  /// Millimetres or Inches: the unit until a block names one. Nothing: mm, and a finding where the
  /// control would decide it.
  std::optional<FileUnits> units;
  /// What coordinates without a decimal point are, where the control decides it. Nothing: whole
  /// units, and a finding.
  std::optional<NoPoint> noPoint;
  /// What the program leaves to settings of the control. Not there: that of a virtual machine, and
  /// a finding where it is needed.
  ControlSettings settings;
  /// Names (`acceptableName`) of what Rivulet does not understand and the user knows to be
  /// harmless: the finding becomes a warning, the word is left out.
  std::vector<std::string> accepted;

  friend bool operator==(const TextReading&, const TextReading&) = default;
};

struct LoadOptions : TextReading {
  bool blockSkip = false;  ///< blocks with "/" are left out, as with the switch on
  /// Of a machine (SD42110): holds until the program names a feed, which stays a finding. 0: none.
  double defaultFeedMmPerS = 0.0;
  bool keepArcs = false;  ///< arcs stay one point each, see `Trajectory::arcs`
  std::size_t repeatedLinesMax = kRepeatedLinesMax;
  /// Of the program as it is held: its text, its path, and what is read of it in trees.
  base::Budget budget{};
  /// The text of a subprogram by its name (upper case, no ending), nothing if there is none.
  /// `loadProgram` looks in the folder of the file if this is empty.
  std::function<std::optional<nc::LoadedText>(std::string_view name)> subprogram;
  /// The radius of a tool of the machine, see `nc::CursorOptions::toolRadiusMm`. May be empty.
  nc::heidenhain::ToolRadius toolRadiusMm;
  /// Where the machine that runs it has the zero of a work offset (by key of its G function, -1:
  /// none named), without a tool's length. Nothing, or empty: only the control knows.
  std::function<std::optional<base::Vec3>(int workOffset)> workOffsetMm;
  /// What becomes of the moves. Those of a whole job stay as they are: its stretches are counted in
  /// points.
  MoveRules moveRules{};
  /// Told now and then how much has been read, 0 to 1. False: give up (GcodeError::Cancelled).
  std::function<bool(double share)> progress;

  void setReading(const TextReading& reading) { static_cast<TextReading&>(*this) = reading; }
};

struct Statistics {
  std::size_t lines = 0;
  std::array<std::size_t, 4> motions{};  ///< blocks that move with G0, G1, G2, G3
  std::size_t points = 0;                ///< of the trajectory, arcs flattened
  base::Vec3 minMm{};                    ///< smallest programmed coordinate per axis (NaN if never)
  base::Vec3 maxMm{};                    ///< largest
  double rapidLengthMm = 0.0;
  double cutLengthMm = 0.0;           ///< G1, G2, G3; arcs at their true length. A move that
                                      ///< names an axis for the first time has no known length
  std::vector<double> feedsMmPerMin;  ///< every F programmed, ascending, each once
};

/// What stands between a program and its stream.
enum class Readiness {
  Streamable,
  NotUnderstood,  ///< a finding is an error: the path is not known everywhere
  NoMotion,
  /// It gives directions of the tool, or turns rotary axes while X, Y and Z are those of the tool's
  /// tip: that needs a transformation of the control, which no method switches on.
  NeedsTransformation,
};
/// "streamable", "not understood", "no motion", "needs a transformation".
[[nodiscard]] std::string_view readinessName(Readiness readiness);
/// One sentence for the user.
[[nodiscard]] std::string_view describe(Readiness readiness);

/// A text that controls execute differently, and nothing shows for which of them it is.
struct Ambiguity {
  struct Reading {
    Dialect dialect = Dialect::Fanuc;
    /// Where the tool is after the move, mm; NaN: the axis has not been named. Nothing: no move.
    std::optional<base::Vec3> endMm;
  };
  std::array<Reading, 2> readings;
  base::LineNumber line;  ///< of the first move that differs
};
/// "as fanuc the tool goes to X10 Y2, as linuxcnc to X10 Y0"
[[nodiscard]] std::string describe(const Ambiguity& ambiguity);

/// Moves that were replaced by fewer ones, within a tolerance.
struct MergedMoves {
  std::size_t of = 0;        ///< points of the program
  std::size_t to = 0;        ///< … that are left, before long moves are divided
  double toleranceMm = 0.0;  ///< what was allowed; degrees of rotary axes
  double deviationMm = 0.0;  ///< measured by `pathDeviation`, <= tolerance

  friend bool operator==(const MergedMoves&, const MergedMoves&) = default;
};
/// "1200 of 10000 points are streamed, at most 0.0049 mm off the program."
[[nodiscard]] std::string describe(const MergedMoves& merged);

struct Program {
  std::string name;  ///< file name without folders
  std::string text;  ///< as read
  std::string hash;  ///< 16 hex digits of the text, shown to tell versions apart
  Dialect dialect = Dialect::Fanuc;
  std::string dialectEvidence;  ///< what decided, "" if nothing did or it was ordered
  Trajectory trajectory;
  /// In text order, at most `kDiagnosticsMax` and one that says how many more there were (with the
  /// worst severity of those). Words without effect on the path are noted at their first place.
  std::vector<Diagnostic> diagnostics;
  Statistics statistics;
  ProgramFacts facts;
  /// Asks for `LoadOptions::dialect`; a finding of severity error says the same.
  std::optional<Ambiguity> ambiguity;
  std::optional<MergedMoves> merged{};  ///< nothing: no tolerance was given

  /// True if no finding is an error: the whole path is known.
  [[nodiscard]] bool isUnderstood() const;
  [[nodiscard]] Readiness readiness() const;
  /// True if a method can stream it; method window alone where rotary axes turn on the path
  /// (`turnedAxes`).
  [[nodiscard]] bool isStreamable() const { return readiness() == Readiness::Streamable; }
};

/// The first finding with this code; null: there is none.
[[nodiscard]] const Diagnostic* findingOf(const Program& program, DiagnosticCode code);
/// The finding that leaves the path to a setting of the control: its unit, what numbers without a
/// decimal point are, or another one that the program needs. Null: there is none.
[[nodiscard]] const Diagnostic* openSetting(const Program& program);
/// What has been taken from settings of the control that nobody has said, by its findings.
[[nodiscard]] ControlSettings openSettings(const Program& program);

/// Merges the moves of a program within the tolerance of the rules, then divides those that take
/// too long. @param budget  of the new trajectory
/// @return whether anything was changed; BudgetError::Exceeded; GcodeError::BadTolerance if the
/// path cannot be kept within the tolerance. On an error the program stays as it was.
[[nodiscard]] base::Result<bool> applyRules(Program& program, const MoveRules& rules,
                                            const base::Budget& budget = {});

/// Interprets an NC text. @return error EmptyProgram, NoMotion or BudgetError::Exceeded; findings
/// are in the program.
/// @threadsafety pure.
[[nodiscard]] base::Result<Program> interpretProgram(std::string name, std::string text,
                                                     const LoadOptions& options = {});

/// Reads and interprets a file. @return error FileUnreadable, EmptyProgram, NoMotion,
/// BudgetError::Exceeded. @threadsafety reads the file, else pure.
[[nodiscard]] base::Result<Program> loadProgram(const std::filesystem::path& path,
                                                const LoadOptions& options = {});

}  // namespace rivulet::gcode
