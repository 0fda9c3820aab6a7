// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The frame of nc/modal under the name this folder uses. @threadsafety plain values.
#pragma once

#include "nc/modal/frame.h"

namespace rivulet::gcode {

using nc::Frame;

}  // namespace rivulet::gcode
