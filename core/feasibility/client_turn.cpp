// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "feasibility/client_turn.h"

#include "base/vec3.h"
#include "templates/cells.h"

namespace rivulet::feasibility {

using base::MethodKind;

ClientTurn turnOf(const TurnSize& size) {
  switch (size.method) {
    case MethodKind::Position:
      return {static_cast<int>(base::kAxisCount), size.cellsPerPoint, 0};
    case MethodKind::Signal:
      return {1, size.cellsPerPoint * (size.pointsPerLoop / 2), 0};
    case MethodKind::Credit:
    case MethodKind::Window:
    case MethodKind::File:
      break;
  }
  const int content =
      size.cellsPerPoint * size.pointsPerLoop + templates::WindowProtocol::WindowCells;
  return {size.method == MethodKind::Credit ? 2 : 1, content, 1};
}

int chargedCells(const TurnSize& size) {
  const ClientTurn turn = turnOf(size);
  return (base::hasWindows(size.method) ? 1 : turn.read) + turn.content + turn.number;
}

}  // namespace rivulet::feasibility
