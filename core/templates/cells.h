// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The contract between the flexible program and the client: which R-parameter means what. The
/// template generator and the streaming methods both work from a `CellMap`. @threadsafety plain
/// values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/axes.h"
#include "base/method_kind.h"
#include "base/result.h"
#include "base/vec3.h"

namespace rivulet::templates {

enum class TemplateError {
  TooFewPointsPerLoop = 1,  ///< N < 1 (position, window) or < 2 (signal)
  DoesNotFit,               ///< N points do not fit the R-parameters of the control
  NoAxis,                   ///< no axis chosen
  BadCells,                 ///< base, stride or number of windows out of range
  FileNotWritable,
  RotaryNeedsWindow,  ///< rotary axes with a method of [P1], which moves X, Y and Z
  TooManyAxes,        ///< more than `base::kStreamedAxesMax`
  BadAxes,            ///< letters that are no axes
  BadCorrection,      ///< limit of the online correction out of range, or no axis or method for it
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
  EachSignal,   ///< STOPRE before each of the two signals (default: [P1]'s figures come out)
  OncePerLoop,  ///< one STOPRE per loop: the pre-run overwrites the first signal; for study only
};

/// Largest limit of the online correction: beyond it is no correction but another path.
inline constexpr double kCorrectionLimitMmMax = 1.0;

struct TemplateParameters {
  base::MethodKind method = base::MethodKind::Window;
  int pointsPerLoop = 7;  ///< N; method window: points per window
  int windows = 2;        ///< methods window and credit: k, 1 to 8
  int baseCell = 0;       ///< methods window and credit: R number of the first cell
  int slotStride = 0;     ///< methods window and credit: cells per point; 0: as many as axes
  /// Method credit: windows the program may have copied and not executed, the one in motion
  /// included, 1 to 8. As many are still executed behind a stop.
  int windowsAhead = 3;
  bool slowDown = true;  ///< method credit: lower the feed while the last window there is, is run
  /// Methods window and credit: what a client may lay over the path of each linear axis, at most,
  /// in steps of 0.001 mm; 0: the program has no online correction.
  double correctionLimitMm = 0.0;
  Layout layout = Layout::Paper;
  SignalStop signalStop = SignalStop::EachSignal;
  std::array<bool, base::kAxisCount> axes{true, true, true};
  base::RotarySet rotaryAxes{};  ///< method window: A, B, C, in degrees
  int rParameterCount = 100;     ///< MD28050: R0 to R(count-1) exist
};

/// Axes that are streamed, each with a cell in every slot.
[[nodiscard]] int cellsPerPoint(const TemplateParameters& parameters);

/// Cells in front of the slots of each window: number of points, feed, check number.
inline constexpr int kWindowOwnCells = 3;

/// R-parameter numbers by role.
struct CellMap {
  int signal = 0;  ///< written by both: 0 first window passed, 1 second passed, 2 refilled
  int run = 1;     ///< client: 1 lets the program leave its waiting loop
  int stop = 2;    ///< client: 1 ends the program at the end of the loop
  int feed = 3;    ///< client: feed, mm/min
  int layout = 4;  ///< NC at start: number of the template (`layoutNumber`)
  int firstSlot = 11;
  int slotStride = 10;
  int pointsPerLoop = 7;
  std::array<bool, base::kAxisCount> axes{true, true, true};
  base::RotarySet rotaryAxes{};

  // Methods window and credit only. `run` is 0 hold, 1 run, 2 end before the next window; `signal`,
  // `stop` and `feed` are not used there, and `firstSlot` is the first slot of window 0.
  int delivered = 0;  ///< client, last of each window: windows it has completed
  int latched = 0;    ///< NC: windows it has copied; their cells may be written again
  int executed = 0;   ///< NC: windows whose last point the axes have reached
  int state = 0;      ///< NC: `WindowState`
  int client = 0;     ///< client: the number of its run, to be granted the cells
  int owner = 0;      ///< NC: number of the run it obeys; only the first to ask is granted
  /// Method file, NC alone: the window the program asks for, then what its subprogram answered.
  int asked = 0;
  bool inFiles = false;  ///< method file: windows are subprograms, there are no slots
  int heartbeat = 0;     ///< client: changes while it lives
  int windows = 0;       ///< k; 0: another method
  int windowStride = 0;  ///< from a cell of a window to that of the next
  /// Client: online correction of X, Y, Z, in mm; -1: none. Behind the last slot.
  std::array<int, base::kAxisCount> correction{-1, -1, -1};

  /// Cells of one slot in the order X Y Z A B C, only the chosen axes.
  /// @param slot from 0; method window: window · N + place in the window
  [[nodiscard]] std::vector<int> slotCells(int slot) const;
  /// Slots there are. Method window: N per window.
  [[nodiscard]] int slotCount() const {
    return inFiles ? 0 : windows > 0 ? windows * pointsPerLoop : pointsPerLoop;
  }
  /// Cells in front of a window's slots (method window). @param window from 0, below `windows`
  [[nodiscard]] int windowCount(int window) const {
    return firstSlot - kWindowOwnCells + window * windowStride;
  }
  [[nodiscard]] int windowFeed(int window) const { return windowCount(window) + 1; }
  [[nodiscard]] int windowCheck(int window) const { return windowCount(window) + 2; }
  /// True if the program obeys corrections.
  [[nodiscard]] bool corrects() const { return correction != std::array{-1, -1, -1}; }
  /// Largest R number used.
  [[nodiscard]] int last() const;
};

/// What the program of methods window and credit says in its state cell.
enum class WindowState {
  Runs = 0,               ///< it waits or moves
  Done = 1,               ///< ended behind the last window
  Stopped = 2,            ///< ended because the client said so
  Damaged = 3,            ///< ended: a window did not fit its check number; it was not executed
  Abandoned = 4,          ///< ended: no window and no sign of life from the client for too long
  OverlayLeft = 5,        ///< ended before it began: something was laid over the axes already
  OverlayIntegrates = 6,  ///< ended before it began: the control adds up corrections (MD36750)
};

/// Factors of the check number of a window, so that no window passes for another: the program and
/// the client add up run number, window number, count, feed and coordinates, each times its own.
inline constexpr double kCheckNumber = 7.31;
inline constexpr double kCheckCount = 13.7;
inline constexpr double kCheckFeed = 0.917;
/// @param place  of the coordinate in the window, from 0
[[nodiscard]] double checkFactor(int place);

/// Method credit: path override, in percent, while nothing is left behind the window in motion.
inline constexpr int kCreditSlowPercent = 40;

/// Limit of the online correction in thousandths of a millimetre, as the program has it.
[[nodiscard]] int correctionSteps(const TemplateParameters& parameters);

/// Letters of the chosen axes, e.g. "XYZAC".
[[nodiscard]] std::string axisLetters(const TemplateParameters& parameters);
/// Chooses the axes by their letters, in any order. @return BadAxes for anything but X Y Z A B C,
/// each once
[[nodiscard]] base::Result<void> chooseAxes(TemplateParameters& parameters,
                                            std::string_view letters);

/// Where everything lies. @return DoesNotFit (the message names the MD28050 value that would
/// do), TooFewPointsPerLoop, NoAxis, TooManyAxes, RotaryNeedsWindow, BadCorrection
[[nodiscard]] base::Result<CellMap> planCells(const TemplateParameters& parameters);

/// Largest N that fits. 0 if none does.
[[nodiscard]] int pointsPerLoopMax(const TemplateParameters& parameters);

/// Number the program writes into the layout cell: changes with method, N, layout, axes, limit of
/// the correction and the version of the generator, so that a client never drives another program.
/// Programs with correction that differ in the limit alone have different numbers; those that
/// differ in more share one only by chance, about 1 in 15 million.
[[nodiscard]] int layoutNumber(const TemplateParameters& parameters);

}  // namespace rivulet::templates

template <>
struct std::is_error_code_enum<rivulet::templates::TemplateError> : std::true_type {};
