// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The fixed cycles of Heidenhain that need the radius of the tool: pockets, slots, studs, bores,
/// threads and faces. Shape, depth, planes and feeds are those of the TNC 640 User's Manual Cycle
/// Programming, chapters "Pocket Milling / Stud Milling / Slot Milling", "Drilling" (208),
/// "Tapping / Thread Milling" (262) and "Multipass Milling" (232); the old cycles 4 and 5 those of
/// the TNC 426 User's Manual. How the tool clears the area in between is not the control's: see
/// `nc/cycles/area`. @threadsafety pure.
#pragma once

#include "nc/dialects/heidenhain/cycle_values.h"

namespace rivulet::nc::heidenhain {

[[nodiscard]] Steps pocketOld(Values& values);          ///< 4
[[nodiscard]] Steps circularPocketOld(Values& values);  ///< 5
[[nodiscard]] Steps boreByMilling(Values& values);      ///< 208
[[nodiscard]] Steps faceByMilling(Values& values);      ///< 232
[[nodiscard]] Steps rectangularPocket(Values& values);  ///< 251
[[nodiscard]] Steps circularPocket(Values& values);     ///< 252
[[nodiscard]] Steps slot(Values& values);               ///< 253
[[nodiscard]] Steps circularSlot(Values& values);       ///< 254
[[nodiscard]] Steps rectangularStud(Values& values);    ///< 256
[[nodiscard]] Steps circularStud(Values& values);       ///< 257
[[nodiscard]] Steps threadByMilling(Values& values);    ///< 262

}  // namespace rivulet::nc::heidenhain
