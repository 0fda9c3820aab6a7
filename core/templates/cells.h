// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The contract between the flexible program and the client: which R-parameter means what. The
/// template generator and the streaming methods both work from a `CellMap`. @threadsafety plain
/// values.
#pragma once

#include <array>
#include <system_error>
#include <vector>

#include "base/method_kind.h"
#include "base/result.h"
#include "base/vec3.h"

namespace rivulet::templates {

enum class TemplateError {
  TooFewPointsPerLoop = 1,  ///< N < 1 (position) or < 2 (signal)
  DoesNotFit,               ///< N points do not fit the R-parameters of the control
  NoAxis,                   ///< no axis chosen
  FileNotWritable,
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

struct TemplateParameters {
  base::MethodKind method = base::MethodKind::Signal;
  int pointsPerLoop = 7;  ///< N
  Layout layout = Layout::Paper;
  SignalStop signalStop = SignalStop::EachSignal;
  std::array<bool, base::kAxisCount> axes{true, true, true};
  int rParameterCount = 100;  ///< MD28050: R0 to R(count-1) exist
};

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

  /// Cells of one slot in axis order, only the chosen axes. @param slot from 0
  [[nodiscard]] std::vector<int> slotCells(int slot) const;
  /// Largest R number used.
  [[nodiscard]] int last() const;
};

/// Where everything lies. @return DoesNotFit (the message names the MD28050 value that would
/// do), TooFewPointsPerLoop, NoAxis
[[nodiscard]] base::Result<CellMap> planCells(const TemplateParameters& parameters);

/// Largest N that fits. 0 if none does.
[[nodiscard]] int pointsPerLoopMax(const TemplateParameters& parameters);

/// Number the program writes into the layout cell: changes with method, N, layout, axes and the
/// version of the generator, so that a client never drives another program.
[[nodiscard]] int layoutNumber(const TemplateParameters& parameters);

}  // namespace rivulet::templates

template <>
struct std::is_error_code_enum<rivulet::templates::TemplateError> : std::true_type {};
