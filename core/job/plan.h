// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A whole job: what Rivulet streams of a program, and what the control executes itself, in the
/// order of the program. Every block is in exactly one part. @threadsafety plain values.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/id.h"
#include "base/result.h"
#include "base/vec3.h"
#include "gcode/program.h"
#include "job/native_reason.h"
#include "nc/modal/state.h"

namespace rivulet::job {

/// Places of blocks in the order they are executed in. A program of millions of lines has few runs
/// of lines that follow one another.
class BlockPlaces {
 public:
  void add(const nc::Place& place);
  /// Of all of them. @pre not empty
  [[nodiscard]] const nc::Place& front() const { return m_runs.front().first; }
  [[nodiscard]] nc::Place back() const { return m_runs.back().at(m_runs.back().count - 1); }
  [[nodiscard]] std::vector<nc::Place> all() const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t bytes() const;  ///< held beside itself

 private:
  /// Lines of a file, one after another, whose blocks begin in the same column.
  struct Run {
    nc::Place first;
    std::uint32_t count = 1;
    [[nodiscard]] nc::Place at(std::uint32_t index) const;
  };
  std::vector<Run> m_runs;
};

/// Blocks that Rivulet reads: what they move is sent as points.
struct Stretch {
  int number = 0;              ///< from 1 in the order of the program; 0: its blocks move nothing
  std::size_t firstPoint = 0;  ///< of `Plan::program`'s trajectory
  std::size_t pointCount = 0;
  BlockPlaces blocks;
  /// Where the program has the tool before it, workpiece frame, mm; NaN: only the control knows.
  base::Vec3 startMm;

  [[nodiscard]] bool startIsKnown() const { return base::isFinite(startMm); }
};

/// A block that the control executes itself.
struct NativeBlock {
  nc::Place place;
  std::string file;  ///< the called file it stands in; empty: the program itself
  NativeReason reason = NativeReason::Other;
  std::string source;  ///< its line as written
  /// What the control gets. SINUMERIK: the line, without a jump label, a skip mark and a call that
  /// Rivulet has followed, and with values in place of calculations; others: its translation.
  /// Empty: nothing is left for the control.
  std::string text;
  nc::ModalState before;  ///< in force when the program reaches it
  /// TRANS, ROT and the like in force, one line each, mm; empty: none.
  std::vector<std::string> frame;
  bool moves = false;  ///< it names an axis
  /// "G28", "G30 P2": the point of the source's control to which it moves; empty: none.
  std::string fixedPoint;
  bool setsFrame = false;  ///< TRANS, ROT and the like
  /// It may move with the feed that the machine begins with: the program has named none.
  bool usesDefaultFeed = false;
  /// Of X, Y, Z: a change of the tool length does not concern the others.
  std::array<bool, base::kAxisCount> shifts{true, true, true};
  /// Of X, Y, Z: it names the axis with an absolute value, or with an increment.
  std::array<bool, base::kAxisCount> places{};
  std::array<bool, base::kAxisCount> increments{};
  bool calculates = false;  ///< its text still reads variables
  /// The same block also moves, and is streamed for that (not SINUMERIK).
  bool isHalf = false;
  /// Not of the program: it re-establishes the state in which a job goes on.
  bool isInserted = false;
};

using Part = std::variant<Stretch, NativeBlock>;

/// Why the job cannot run.
enum class RefusalCode : unsigned char {
  NotTranslated,      ///< argument: the word that the table has no translation for
  CurveInterrupted,   ///< a native block within a spline
  StartUnknown,       ///< argument: the block; only the control knows where its move begins
  CycleIncomplete,    ///< argument: the cycle and what it lacks, "G82 (Z)"
  FunctionUnknown,    ///< argument: what belongs to another machine, "M163", "W"
  LengthOfOtherTool,  ///< argument: the offset and the tool in the spindle, "H12 (T2)"
  ToolNotCalled,      ///< argument: an offset before any tool has been called, "H5"
  LengthKept,         ///< argument: the offset of the tool before, and the tool, "H1 (T2)"
};

struct Refusal {
  RefusalCode code = RefusalCode::NotTranslated;
  base::LineNumber line;
  std::string file;
  std::string argument;
};
/// "not-translated", "curve-interrupted", "start-unknown", "cycle-incomplete", "function-unknown",
/// "length-of-other-tool", "tool-not-called", "length-kept".
[[nodiscard]] std::string_view refusalName(RefusalCode code);
/// One English sentence.
[[nodiscard]] std::string describe(const Refusal& refusal);

/// What belongs to another machine: an M function of its builder, or an axis beside X Y Z A B C.
struct FunctionName {
  int number = 0;  ///< of the M function
  char axis = 0;   ///< U, V or W; 0: an M function

  friend auto operator<=>(const FunctionName&, const FunctionName&) = default;
};
/// "M163", "W"
[[nodiscard]] std::string textOf(const FunctionName& name);

/// Such a word of the program, and what the control gets for it.
struct FunctionUse {
  FunctionName name;
  base::LineNumber line;  ///< of the first call
  std::size_t count = 0;
  std::string text;        ///< line for the control; empty: it is left out
  bool isAssumed = false;  ///< nobody has said so: `Profile::leavesOutFunctions`
};

/// A length or a radius that no tool of the program has: that of the tool in the spindle is taken.
struct AssumedTool {
  base::LineNumber line;
  std::string word;  ///< "H5", "G41"; "H3 (T2)" of another tool; empty: there is none
};

inline constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

struct Plan {
  /// The streamed points alone, and the findings about streamed blocks.
  gcode::Program program;
  std::vector<Part> parts;
  std::vector<Refusal> refusals;            ///< at most `gcode::kDiagnosticsMax`
  std::vector<FunctionUse> functions;       ///< by name
  AssumedTool assumedTool;                  ///< before any tool change: `Profile::assumesTool`
  std::vector<AssumedTool> assumedLengths;  ///< of other tools, each once: the same
  int lastEdge = 0;                         ///< greatest D of a SINUMERIK
  /// What all moves reach, native ones too, as far as they are known; workpiece frame, mm; NaN: the
  /// axis is not named.
  base::Vec3 minMm{kNowhere, kNowhere, kNowhere};
  base::Vec3 maxMm{kNowhere, kNowhere, kNowhere};

  /// True if control and Rivulet together execute every block.
  [[nodiscard]] bool isWhole() const { return refusals.empty() && program.isUnderstood(); }
  [[nodiscard]] std::size_t stretchCount() const;
  [[nodiscard]] std::size_t nativeCount() const;
  /// Native blocks beside the end of the program: what is missing if the motion alone is streamed.
  [[nodiscard]] std::size_t actionCount() const;
};

/// What a machine has for words that its control spells differently.
struct Profile {
  /// Retracts the tool where the source moves to a fixed point or in machine coordinates.
  std::string retract = "SUPA G0 Z0 D0";
  /// The axes across the tool, afterwards.
  std::string home = "SUPA G0 X0 Y0";
  /// With the number of the tool in place of "%1".
  std::string toolChange = "T%1 M6";
  /// What the control does for such a word: a line, of an axis its word alone; empty: left out.
  std::map<FunctionName, std::string> functions{};
  /// Those that are not listed are left out too, else they are refused. For a machine that moves
  /// nothing but a picture.
  bool leavesOutFunctions = false;
  /// H5 is the length of the tool in the spindle before the program has called a tool, and where it
  /// has called another one; else it is refused. For a machine that is set up for the program.
  bool assumesTool = false;

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Splits a program. A block that Rivulet and the control both do not understand stays a finding of
/// severity error. @return error EmptyProgram, Cancelled @threadsafety pure
[[nodiscard]] base::Result<Plan> makePlan(std::string name, std::string text,
                                          const gcode::LoadOptions& options = {},
                                          const Profile& profile = {});
/// The same of a program that has been read. `Plan::program` has no text: it is that of `read`.
[[nodiscard]] base::Result<Plan> makePlan(const gcode::Program& read,
                                          const gcode::LoadOptions& options = {},
                                          const Profile& profile = {});
/// The same for a plan that is not kept: `each` gets the parts in their order, and the plan has
/// none.
[[nodiscard]] base::Result<Plan> visitPlan(const gcode::Program& read,
                                           const gcode::LoadOptions& options,
                                           const std::function<void(const Part&)>& each);

}  // namespace rivulet::job
