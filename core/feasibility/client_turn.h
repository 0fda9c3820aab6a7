// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One turn of the client: the number of cells in each request. Everything that counts cells (the
/// equations, measured access times, the probability) takes the numbers from here. @threadsafety
/// pure.
#pragma once

#include <chrono>

#include "base/instant.h"
#include "base/method_kind.h"
#include "feasibility/symbols.h"

namespace rivulet::feasibility {

/// What determines the number of cells of a turn.
struct TurnSize {
  base::MethodKind method = base::kDefaultMethod;
  int pointsPerLoop = 7;           ///< N; methods with windows: points per window
  int cellsPerPoint = kPaperAxes;  ///< axes that are streamed: `templates::cellsPerPoint`
  int cellsOfFirst = 0;            ///< so many more: `templates::cellsOfFirstPoint`
  friend bool operator==(const TurnSize&, const TurnSize&) = default;
};

/// | method   | read               | content          | number |
/// |----------|--------------------|------------------|--------|
/// | position | X Y Z of the tool  | one point        | -      |
/// | signal   | the signal         | ⌊N/2⌋ points     | -      |
/// | window   | windows taken      | N points, count, feed, check | window number |
/// | credit   | windows taken and executed | as window | window number |
struct ClientTurn {
  int read = 0;     ///< in one request
  int content = 0;  ///< written in one request
  int number = 0;   ///< written in a request of its own, after the content
  /// Cells that the equations charge for it. Method credit reads two cells and is charged one: the
  /// equations are those of method window.
  int charged = 0;
};

[[nodiscard]] ClientTurn turnOf(const TurnSize& size);
[[nodiscard]] ClientTurn pointTurn(int cellsPerPoint);
[[nodiscard]] ClientTurn halfLoopTurn(int pointsPerLoop, int cellsPerPoint);
[[nodiscard]] ClientTurn windowTurn(int pointsPerWindow, int cellsPerPoint, int cellsOfFirst = 0);

/// The axes and the feed are read for the display this often even if the stream leaves no time for
/// it, by methods in which a late client only makes the machine wait.
inline constexpr base::Duration kDisplayIntervalMax = std::chrono::milliseconds{900};

}  // namespace rivulet::feasibility
