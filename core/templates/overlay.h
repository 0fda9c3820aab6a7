// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program for SINUMERIK lays over the path by $AA_OFF: the online correction, or the lift
/// of a tool whose axes are held. @threadsafety pure.
///
/// The lift is interlocked on the control, whatever a client writes: the tool goes up only while
/// the feed cell holds the axes, is lowered as soon as it no longer does, and the path goes on only
/// when it is back.
#pragma once

#include <string>
#include <vector>

#include "templates/cells.h"

namespace rivulet::templates {

/// "X" with its cell and its action, for each axis that is corrected.
struct Corrected {
  char letter;
  int cell;
  int action;
};

[[nodiscard]] std::vector<Corrected> correctedAxes(const WindowCells& cells);

/// An overlay is active: "(ABS($AA_OFF_VAL[X])>0.0005) OR …" of all axes that are corrected.
[[nodiscard]] std::string overlayThere(const WindowCells& cells);

/// A control that adds up what is written would drive the axes away (MD36750): the condition of
/// that.
[[nodiscard]] std::string overlayIntegrates(const WindowCells& cells);

/// The blocks that put the cells into force. A value beyond the limit is ignored: the last accepted
/// one stays. @param limitMm  of the correction, or of the lift
[[nodiscard]] std::vector<std::string> overlayBlocks(const WindowCells& cells, double limitMm);

/// What the override in force asks besides: " AND ($AA_OFF_VAL[Z]<=0.0005)" where the tool may be
/// lifted.
[[nodiscard]] std::string andLowered(const WindowCells& cells);

}  // namespace rivulet::templates
