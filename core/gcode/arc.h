// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The curves of nc/geometry, and how post-processors write the centre of an arc.
/// @threadsafety pure.
#pragma once

#include "gcode/facts.h"
#include "nc/geometry/arc.h"
#include "nc/geometry/spline.h"

namespace rivulet::gcode {

using nc::Arc;
using nc::ArcProblem;
using nc::ArcRadii;
using nc::arcThrough;
using nc::ArcWords;
using nc::chordCount;
using nc::clampedKnots;
using nc::kArcRadiusToleranceMm;
using nc::ResolvedArc;
using nc::SpaceArc;
using nc::Spline;
using nc::tangentArc;

/// The same words read as their writer may have meant the centre; AC() means what it says.
[[nodiscard]] ArcWords readAs(CentreReading reading, ArcWords words);

}  // namespace rivulet::gcode
