// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the words of each dialect do to the path, as data; the tables are in nc/dialects.
/// @threadsafety pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nc/syntax/dialect.h"

namespace rivulet::nc {

inline constexpr std::size_t kProgrammedAxisCount = 9;
inline constexpr std::array<char, kProgrammedAxisCount> kProgrammedAxes{'X', 'Y', 'Z', 'A', 'B',
                                                                        'C', 'U', 'V', 'W'};
/// Index of the first of A, B, C and of U, V, W.
inline constexpr std::size_t kFirstRotary = 3;
inline constexpr std::size_t kFirstFurther = 6;

/// How a G function is handled.
enum class GEffect : unsigned char {
  Unknown,
  Motion,           ///< G0 to G3
  Distance,         ///< G90, G91
  CentreMode,       ///< G90.1, G91.1
  Plane,            ///< G17 to G19
  Units,            ///< G20 G21 G70 G71 G700 G710
  FeedMode,         ///< G93 G94 G95
  SpindleMode,      ///< G96, G97: what S means, and on a SINUMERIK F as well
  Diameter,         ///< G7, G8 of LinuxCNC
  Dwell,            ///< G4: the block's X, F, S, P and U are times
  Pole,             ///< G110 to G112: the block's words set the pole
  Polar,            ///< G16: X and Y of the plane are radius and angle; G15
  Spline,           ///< G5, G5.1, G5.2, G5.3 of LinuxCNC
  None,             ///< no effect on the path
  BlockEnd,         ///< G9, G60: how a block ends, no effect on the path
  Tolerance,        ///< the same with a tolerance; P and Q of the block belong to it
  ToolLength,       ///< lives on the control; afterwards Z is somewhere else
  CycleOff,         ///< G80
  WorkOffset,       ///< no effect as long as it does not change under the tool
  WorkOffsetP,      ///< the same with its number in P: G54.1, G154
  MachineMove,      ///< G53, G153: this block is in machine coordinates
  FixedPoint,       ///< G75 of SINUMERIK: the axes the block names go to a fixed point
  SetPosition,      ///< G92: the present position gets the values of the block
  ResetPosition,    ///< G92.1
  SuspendPosition,  ///< G92.2: the same, until G92.3
  RestorePosition,  ///< G92.3
  LocalOffset,      ///< G52: an offset
  Turn,             ///< G68 of Fanuc: turns the coordinates about a place of the plane
  TurnOff,          ///< G69
  Scale,            ///< G51 of Fanuc
  ScaleOff,         ///< G50
  Mirror,           ///< G51.1 of Fanuc
  MirrorOff,        ///< G50.1
  SetWorkOffset,    ///< G10 L2 of RS-274: lives on the control
  MacroCall,        ///< G65: a subprogram with arguments
  ModalMacro,       ///< G66: the same behind each block that moves
  ModalMacroOff,    ///< G67
  Compensation,     ///< G40 to G42 of SINUMERIK
  Mode,             ///< not supported; the block still moves
  MotionMode,       ///< not supported; replaces G0 to G3
  Cycle,            ///< a canned cycle: its motions are missing; replaces G0 to G3
  TakesBlock,       ///< not supported; takes the axis words of its block for itself
  TurningCycle,     ///< of a lathe: takes the words of its block, sets no state
};

/// A G function by what it means, whatever its number in a dialect.
enum class G : unsigned char {
  Unknown,
  Rapid,
  Line,
  ArcClockwise,
  ArcCounter,
  Absolute,
  Incremental,
  AbsoluteOrTurning,  ///< G90 of a lathe: a cycle where axes stand beside it
  CentreAbsolute,
  CentreIncremental,
  PlaneXY,
  PlaneZX,
  PlaneYZ,
  Inches,
  Millimetres,
  InchesOfLengths,       ///< the feed stays in mm/min
  MillimetresOfLengths,  ///< the same
  FeedInverseTime,
  FeedPerMinute,
  FeedPerMinuteOrFacing,  ///< G94 of a lathe: a cycle where axes stand beside it
  FeedPerRevolution,
  FeedUnknown,                ///< neither: the number of F is not understood
  SurfaceSpeed,               ///< S is a cutting speed; F keeps its meaning
  SurfaceSpeedPerMinute,      ///< ... and F is per minute
  SurfaceSpeedPerRevolution,  ///< ... and F is per revolution
  SpindleSpeed,               ///< S is a speed of rotation again
  SpindleSpeedPerMinute,
  SpindleSpeedPerRevolution,
  Diameter,
  Radius,
  Dwell,
  PoleFromPosition,
  PoleFromZero,
  PoleFromPole,
  PolarOn,
  PolarOff,
  CubicSpline,
  QuadraticSpline,
  NurbsOn,
  NurbsOff,
  NurbsWithKnots,
  Harmless,  ///< of the path nothing changes
  TipLength,
  RetractToStart,  ///< G98, of canned cycles
  RetractToR,
  CornersRound,
  CornersIntersect,
  ExactStopOnce,
  ExactStop,
  ExactPath,  ///< as exact stop, with its words P and Q
  Continuous,
  ContinuousByDistance,
  Accuracy,  ///< G187 of Haas: how closely corners are rounded, not whether
  ToolLength,
  ToolLengthOff,
  CycleOff,
  WorkOffset,
  WorkOffsetP,
  MachineMove,
  FixedPoint,
  SetPosition,
  ResetPosition,
  SuspendPosition,
  RestorePosition,
  LocalOffset,
  Turn,
  TurnOff,
  Scale,
  ScaleOff,
  Mirror,
  MirrorOff,
  SetWorkOffset,
  MacroCall,
  ModalMacro,
  ModalMacroOff,
  CompensationOff,
  CompensationLeft,
  CompensationRight,
  Mode,
  MotionMode,
  Cycle,
  TakesBlock,
  TurningCycle,
};
[[nodiscard]] GEffect effectOf(G function);

/// What a word changes besides what it says of the machine.
enum class Changes : unsigned char {
  Nothing,  ///< neither path nor feed nor where the tool is; a claim that needs its source
  Path,
  Feed,
  Tool,   ///< its length or radius
  State,  ///< what later words mean
};

/// A G function of a dialect.
struct GRow {
  int key = 0;  ///< ten times its number, so that G91.1 has one
  G function = G::Unknown;
  Changes changes = Changes::Path;
  std::string_view takes;             ///< addresses of the block that belong to it
  std::string_view source;            ///< manual, and its chapter
  GEffect effect = GEffect::Unknown;  ///< that of the function; the table sets it
};

/// What a program has for the machine and not for the path.
enum class MachineWord : unsigned char {
  Spindle,    ///< S, as programmed
  M,          ///< M function
  Tool,       ///< T number
  NamedTool,  ///< index of its name in the order of the program
  Dwell,      ///< G4, seconds; NaN: in turns of a spindle whose speed is not known
  Edge,       ///< D: the cutting edge whose offsets hold
};

inline constexpr std::size_t kGKeys = 10000;

/// All G functions of a dialect.
class GTable {
 public:
  /// @param rows  what stands later wins
  explicit GTable(std::span<const GRow> rows = {}, std::span<const GRow> lathe = {});

  /// @param key  below kGKeys. A function that is not listed is `G::Unknown`.
  [[nodiscard]] const GRow& row(std::size_t key) const { return m_rows[m_index[key]]; }
  /// The same where a program is one for a lathe.
  [[nodiscard]] const GRow& latheRow(std::size_t key) const;
  [[nodiscard]] GEffect operator[](std::size_t key) const { return row(key).effect; }
  [[nodiscard]] std::span<const GRow> rows() const { return m_rows; }

 private:
  std::vector<GRow> m_rows;
  std::vector<GRow> m_lathe;
  std::vector<std::uint8_t> m_index;
};
[[nodiscard]] const GTable& gTable(Dialect dialect);

/// The G function a SINUMERIK means by G[group]=number, as a key; nothing: a group without effect
/// on the path, or one that is not known here.
[[nodiscard]] std::optional<int> gOfGroup(int group, int number);

enum class MEffect : unsigned char {
  None,               ///< no effect on the path
  End,                ///< M2, M30
  Return,             ///< M17, M99
  Call,               ///< M98
  LocalCall,          ///< M97 of Haas: blocks of the same program
  Refused,            ///< it changes the path or the feed in a way that is not made here
  MachineMove,        ///< M91, M92 of plain text: this block is in machine coordinates
  Retract,            ///< M140 of plain text: along the tool, to where only the control knows
  FeedPerRevolution,  ///< M136 of plain text
  FeedPerMinute,      ///< M137
  TurnsShortest,      ///< M126: rotary axes take the shortest way
  TurnsAsWritten,     ///< M127
  SaveState,          ///< M70 of LinuxCNC
  ForgetState,        ///< M71
  RestoreState,       ///< M72
  SaveUntilReturn,    ///< M73: restored at the end of the subprogram
};

/// An M function of a dialect.
struct MRow {
  int number = 0;
  MEffect effect = MEffect::None;
  Changes changes = Changes::Nothing;
  std::string_view source;   ///< manual, and its chapter
  std::string_view takes{};  ///< addresses of the block that belong to it
};
/// @return null: a function of the builder of the machine, of which nothing is known
[[nodiscard]] const MRow* mFunction(Dialect dialect, int number);
[[nodiscard]] std::span<const MRow> mFunctions(Dialect dialect);
/// What `mFunction` does; None where it is not known.
[[nodiscard]] MEffect mEffect(Dialect dialect, int number);

enum class NameEffect : unsigned char {
  Unknown,         ///< a variable or a subprogram
  None,            ///< no effect on the path, with or without a value or arguments
  Dynamics,        ///< SOFT, BRISK, DRIVE: no effect on the path
  Rounding,        ///< ADIS=: the same
  BlockFeed,       ///< FB=: the feed of this block
  Override,        ///< OVR=: percent of the feed, from this block on
  OtherOverride,   ///< OVRRAP=, OVRA[]=: only 100 percent is made
  SpeedLimit,      ///< LIMS=: the largest speed while S is a cutting speed
  Feed,            ///< a feed of another kind: refused
  FeedGroup,       ///< FGROUP(): the axes that F counts; as written here, X, Y and Z
  Query,           ///< no effect on the path; sets variables to what only the control knows
  End,             ///< returns or ends the program
  Mode,            ///< not supported; the block still moves
  TakesBlock,      ///< not supported; takes the rest of its block
  Cycle,           ///< a cycle of the control: its motions are missing
  Frame,           ///< TRANS, ROT, SCALE, MIRROR and their additive forms
  Motion,          ///< CIP, CT: modal, as G2
  Spline,          ///< BSPLINE: modal, as G1
  OtherCurve,      ///< not supported: modal, replaces G0 to G3
  MachineMove,     ///< SUPA
  Diameter,        ///< DIAMON, DIAMOF, DIAM90
  Transformation,  ///< TRAORI, TRAFOOF: X, Y, Z stay those of the tool's tip
  Address,         ///< an address of its own: CR=, AR=, AP=, RP=, TURN=, I1=, A3=, PW=
  MachineAxis,     ///< FP=, X1=: words of G75; in other blocks they are not understood
};

/// @param name  upper case
[[nodiscard]] NameEffect nameEffect(Dialect dialect, std::string_view name);

}  // namespace rivulet::nc
