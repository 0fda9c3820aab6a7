// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The contract between the flexible program and the client: which R-parameter means what. The
/// template generator and the streaming methods both work from a `CellMap`. @threadsafety plain
/// values.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/axes.h"
#include "base/method_kind.h"
#include "base/packing.h"
#include "base/result.h"
#include "base/vec3.h"
#include "templates/window_protocol.h"

namespace rivulet::templates {

enum class TemplateError {
  TooFewPointsPerLoop = 1,  ///< N < 1 (position, window) or < 2 (signal)
  DoesNotFit,               ///< N points do not fit the R-parameters of the control
  NoAxis,                   ///< no axis selected
  BadCells,                 ///< base, stride or number of windows out of range
  FileNotWritable,
  RotaryNeedsWindow,  ///< rotary axes with a method of [P1], which moves X, Y and Z
  TooManyAxes,        ///< more than `base::kStreamedAxesMax`
  BadAxes,            ///< letters that are not axes
  BadCorrection,      ///< limit of the online correction out of range, or no axis or method for it
  BadFactor,          ///< bounds of the factor out of range, or no method for it
  NotOnTarget,        ///< a method or setting that the make of control does not have
};

[[nodiscard]] std::error_code make_error_code(TemplateError code);

enum class Layout {
  Paper,       ///< slot i at R(10·i+1), R(10·i+2), R(10·i+3), i from 1, as in [P1] Algorithm I
  Contiguous,  ///< slots packed from R10 on: one array node can carry a window
};

/// "paper", "contiguous".
[[nodiscard]] std::string_view layoutName(Layout layout);
[[nodiscard]] std::optional<Layout> layoutFromName(std::string_view name);

/// Where method signal stops the pre-run. [P1] leaves it open; see docs/methods.md.
enum class SignalStop {
  EachSignal,   ///< STOPRE before each of the two signals (default: reproduces [P1]'s figures)
  OncePerLoop,  ///< one STOPRE per loop: the pre-run overwrites the first signal; for study only
};

/// Largest limit of the online correction: more would be another path, not a correction.
inline constexpr double kCorrectionLimitMmMax = 1.0;

/// Largest lift of the tool; what the control allows besides is SD43350 of its tool axis.
inline constexpr double kLiftMmMax = 10.0;

/// Without a sign of the client for so long, the axes stand; and what may be chosen instead.
inline constexpr double kSilenceLimitS = 1.0;
inline constexpr double kSilenceLimitSMin = 0.2;
inline constexpr double kSilenceLimitSMax = 60.0;

/// What may be agreed as the bounds of a factor of the override; 1 has to be among them.
inline constexpr double kFactorMin = 0.01;
inline constexpr double kFactorMax = 2.0;

/// Methods position and signal: their own settings.
struct LoopSettings {
  Layout layout = Layout::Paper;
  SignalStop signalStop = SignalStop::EachSignal;  ///< method signal
};

/// Methods window, credit and file.
struct WindowSettings {
  int windows = 2;     ///< k, 1 to 8
  int baseCell = 0;    ///< R number of the first cell
  int slotStride = 0;  ///< cells per point; 0: as many as axes. Not for method file
  /// Largest correction of each linear axis by a client, in steps of 0.001 mm; 0: the program has
  /// no online correction. Not for method file
  double correctionLimitMm = 0.0;
  /// While the axes are held, the client may lift the tool along Z by so much, in steps of 0.001
  /// mm; 0: it may not. Not with an online correction, nor for method file
  double liftMm = 0.0;
  /// Each point has a cell for its feed, after its coordinates; otherwise the feed is that of the
  /// window. Not for method file, whose blocks have their own
  bool feedPerPoint = false;
  /// Points after the first of a window have one cell for all their coordinates (`base::Packing`).
  /// Not for method file, nor with a stride
  bool packed = false;
  /// s. When the heartbeat of the client has not changed for longer, the override is 0 until it
  /// does; 0: it is not watched, for a control without timers of the main run. Of a program with a
  /// feed cell
  double silenceLimitS = kSilenceLimitS;
  /// A source beside the operator multiplies the override by a factor within these bounds; anything
  /// else in its cell holds the axes. 0 and 0: the program has no factor
  double factorLeast = 0.0;
  double factorMost = 0.0;

  [[nodiscard]] bool hasFactor() const { return factorLeast != 0.0 || factorMost != 0.0; }
  /// The program lays something over the axes.
  [[nodiscard]] bool hasOverlay() const { return correctionLimitMm != 0.0 || liftMm != 0.0; }
};

/// Method credit, in addition to those of method window.
struct CreditSettings {
  /// Windows that the program may have copied but not executed, including the one in motion, 1 to
  /// 8. As many are still executed after a stop.
  int windowsAhead = 3;
  bool slowDown = true;  ///< lower the feed while nothing follows the window in motion
};

/// The make of control that a program is written for.
enum class TargetControl {
  Sinumerik,
  LinuxCnc,  ///< methods window and credit; its cells are pins of the HAL
};

/// "sinumerik", "linuxcnc".
[[nodiscard]] std::string_view targetName(TargetControl target);
[[nodiscard]] std::optional<TargetControl> targetFromName(std::string_view name);
/// As a person calls it: "LinuxCNC".
[[nodiscard]] std::string_view targetTitle(TargetControl target);
/// The settings of a program. A method reads its own settings and does not change the others, so
/// that they are kept when the user tries another method.
struct TemplateParameters : LoopSettings, WindowSettings, CreditSettings {
  base::MethodKind method = base::kDefaultMethod;
  int pointsPerLoop = 7;  ///< N; methods window, credit and file: points per window
  std::array<bool, base::kAxisCount> axes{true, true, true};
  base::RotarySet rotaryAxes{};  ///< methods window and file: A, B, C, in degrees
  int rParameterCount = 100;     ///< MD28050: R0 to R(count-1) exist
  TargetControl target = TargetControl::Sinumerik;
};

/// R numbers, inclusive at both ends.
struct CellRange {
  int first = 0;
  int last = 0;
};

/// Cells of methods position and signal.
struct LoopCells {
  int signal = 0;  ///< written by both; see `LoopProtocol`
  int stop = 2;    ///< client: 1 ends the program at the end of the loop
  int feed = 3;    ///< client: feed, mm/min
};

/// Cells of methods window, credit and file; see `WindowProtocol`.
struct WindowCells {
  int delivered = 0;  ///< client, last of each window: windows it has completed
  int latched = 0;    ///< NC: windows it has copied; their cells may be written again
  int executed = 0;   ///< NC: windows whose last point the axes have reached
  int state = 0;      ///< NC: `WindowState`
  int client = 0;     ///< client: the number of its run, to be granted the cells
  int owner = 0;      ///< NC: number of the run it obeys; only the first to ask is granted
  /// Client: changes while it lives. Before the start of the program: who has claimed the cells;
  /// that also with the methods of [P1], at the same place.
  int heartbeat = 0;
  int overrideWanted = -1;  ///< client: path override in percent, see `FeedCell`; -1: no feed cell
  int overrideActs = -1;    ///< NC, in every interpolation cycle: the override in force
  /// Client: factor of the override, see `WindowSettings`; -1: none. After all others.
  int factor = -1;
  double factorLeast = 0.0;
  double factorMost = 0.0;
  double silenceLimitS = 0.0;  ///< NC: see `WindowSettings`; 0: it does not watch the heartbeat
  int windows = 0;             ///< k; 0: another method
  int windowStride = 0;        ///< from a cell of a window to that of the next
  /// Client: online correction of X, Y, Z, in mm; -1: none. After the last slot.
  std::array<int, base::kAxisCount> correction{-1, -1, -1};
  /// The only correction is that of Z, not below 0: the lift of axes that are held.
  bool lifts = false;

  /// The last cell of each slot is the feed of the point, mm/min; the feed of the window is unused.
  bool feedPerPoint = false;
  /// The first slot of a window has its coordinates, the others one cell for the way from there.
  bool packed = false;

  /// True if the program obeys an override by the client.
  [[nodiscard]] bool hasFeedCell() const { return overrideWanted >= 0; }
  /// True if the override is multiplied by a factor.
  [[nodiscard]] bool hasFactor() const { return factor >= 0; }
  /// True if the program obeys corrections.
  [[nodiscard]] bool corrects() const { return correction != std::array{-1, -1, -1}; }
};

/// Cells of method file, in addition to those of the header.
struct FileCells {
  int files = 0;  ///< subprograms that the program calls in turn; 0: another method
  /// NC only: the requested window, then the answer of its subprogram.
  int asked = 0;
};

/// R-parameter numbers by role. A method sets its own; those of other methods keep their defaults
/// and have no meaning.
struct CellMap : LoopCells, WindowCells, FileCells {
  int run = 1;     ///< client: lets the program continue; `LoopProtocol`, `WindowProtocol`
  int layout = 4;  ///< NC at start: number of the template (`layoutNumber`)
  int firstSlot = 11;
  int slotStride = 10;
  int pointSlots = 7;  ///< number of point slots; method file: none
  int pointsPerLoop = 7;
  std::array<bool, base::kAxisCount> axes{true, true, true};
  base::RotarySet rotaryAxes{};

  // Cells that a run uses before it knows the program's state, and to end the program.
  std::vector<int> cleared{1, 2};  ///< cells that the client sets to 0 before cycle start
  int endCell = 2;                 ///< client: `endValue` in it ends the program
  int endValue = LoopProtocol::kStop;
  /// Consecutive cells that the client overwrites anyway: the forms of access may be tried on them.
  /// The first and the last are not written. Nothing: the cells are not consecutive.
  std::optional<CellRange> scratch;

  /// Cells of one slot in the order X Y Z A B C, only the selected axes, or one for them all; then
  /// the feed, if each point has its own.
  /// @param slot from 0; methods window and credit: window · N + place in the window
  [[nodiscard]] std::vector<int> slotCells(int slot) const;
  [[nodiscard]] int slotCount() const { return pointSlots; }
  [[nodiscard]] int axisCount() const {
    return static_cast<int>(std::count(axes.begin(), axes.end(), true)) +
           static_cast<int>(base::count(rotaryAxes));
  }
  /// Cells before a window's slots. @param window  from 0, below `windows`
  [[nodiscard]] int windowCount(int window) const {
    return firstSlot - WindowProtocol::WindowCells + window * windowStride;
  }
  [[nodiscard]] int windowFeed(int window) const {
    return windowCount(window) + WindowProtocol::Feed;
  }
  [[nodiscard]] int windowCheck(int window) const {
    return windowCount(window) + WindowProtocol::Check;
  }
  /// Largest R number used.
  [[nodiscard]] int last() const;
};

/// Limit of the online correction, or of the lift, in thousandths of a millimetre, as the program
/// has it.
[[nodiscard]] int correctionSteps(const WindowSettings& settings);

/// Letters of the selected axes, e.g. "XYZAC".
[[nodiscard]] std::string axisLetters(const TemplateParameters& parameters);
/// Selects the axes by their letters, in any order. @return BadAxes for anything but X Y Z A B C,
/// each once
[[nodiscard]] base::Result<void> chooseAxes(TemplateParameters& parameters,
                                            std::string_view letters);

/// Largest N that fits. 0 if none does.
[[nodiscard]] int pointsPerLoopMax(const TemplateParameters& parameters);

/// Axes that are streamed, each with a cell in every slot.
[[nodiscard]] int axisCount(const TemplateParameters& parameters);

/// Cells of a point: its axes, and its feed where it has its own. Packed: of a point after the
/// first of its window.
[[nodiscard]] int cellsPerPoint(const TemplateParameters& parameters);
/// So many more has the first point of a window that is packed; 0: none.
[[nodiscard]] int cellsOfFirstPoint(const TemplateParameters& parameters);
/// Points that share a window lie so near to its first that they can be packed; nothing: they are
/// not packed.
[[nodiscard]] std::optional<base::Packing> packingOf(const TemplateParameters& parameters);

/// Cells of the client's longest request during a run.
[[nodiscard]] int longestWrite(const TemplateParameters& parameters);

}  // namespace rivulet::templates

template <>
struct std::is_error_code_enum<rivulet::templates::TemplateError> : std::true_type {};
