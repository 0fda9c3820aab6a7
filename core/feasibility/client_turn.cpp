// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/client_turn.h"

#include "base/vec3.h"
#include "templates/cells.h"

namespace rivulet::feasibility {

ClientTurn pointTurn(int cellsPerPoint) {
  constexpr int kRead = static_cast<int>(base::kAxisCount);
  return {kRead, cellsPerPoint, 0, kRead + cellsPerPoint};
}

ClientTurn halfLoopTurn(int pointsPerLoop, int cellsPerPoint) {
  const int content = cellsPerPoint * (pointsPerLoop / 2);
  return {1, content, 0, 1 + content};
}

ClientTurn windowTurn(int pointsPerWindow, int cellsPerPoint, int cellsOfFirst) {
  const int content =
      cellsPerPoint * pointsPerWindow + cellsOfFirst + templates::WindowProtocol::WindowCells;
  return {1, content, 1, 1 + content + 1};
}

ClientTurn turnOf(const TurnSize& size) {
  switch (base::methodTraits(size.method).portion) {
    case base::Portion::Point:
      return pointTurn(size.cellsPerPoint);
    case base::Portion::HalfLoop:
      return halfLoopTurn(size.pointsPerLoop, size.cellsPerPoint);
    case base::Portion::Window:
      break;
  }
  ClientTurn turn = windowTurn(size.pointsPerLoop, size.cellsPerPoint, size.cellsOfFirst);
  // What has been taken is not yet what has been executed.
  turn.read = base::goesOn(size.method) ? 2 : turn.read;
  return turn;
}

}  // namespace rivulet::feasibility
