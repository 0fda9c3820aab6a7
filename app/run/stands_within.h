// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// How soon the axes stand after a stop by the feed cell. @threadsafety pure.
#pragma once

#include "base/instant.h"
#include "feasibility/client_turn.h"
#include "machine/config.h"

namespace rivulet::run {

/// An access of a whole window that is in progress, that of the cell, braking from this feed at the
/// highest override, and two interpolation cycles.
/// @param turn  of the client  @param perNode  what a variable costs  @param feedMmPerS  > 0
[[nodiscard]] base::Duration standsWithin(const machine::MachineConfig& machine,
                                          const feasibility::TurnSize& turn, base::Duration perNode,
                                          double feedMmPerS);

}  // namespace rivulet::run
