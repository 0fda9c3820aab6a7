// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The milling cycles of SINUMERIK that clear an area: POCKET3, POCKET4, LONGHOLE, SLOT1, SLOT2,
/// CYCLE61, CYCLE71, CYCLE76, CYCLE77 and CYCLE90. Parameters as in the Cycles Programming Manual
/// of the 840D (PGZ), chapter Milling cycles; those of CYCLE61 as newer controls have it. Extent,
/// depths, infeeds, planes and feeds are those of the parameters. The way in between is not the
/// control's, which no manual tells in full: lines from the middle outwards, and straight down into
/// the material.
/// @threadsafety pure.
#pragma once

#include "nc/cycles/drilling.h"

namespace rivulet::nc {

inline constexpr int kToolTooLarge = 61105;

/// @param name  upper case
[[nodiscard]] bool isMillingCycle(std::string_view name);

/// @param name  isMillingCycle @return kToolTooLarge, kReferencePlaneWrong
[[nodiscard]] tl::expected<std::vector<CycleStep>, CycleFault> expandMilling(
    std::string_view name, CycleArguments arguments, const CycleStart& start);

}  // namespace rivulet::nc
