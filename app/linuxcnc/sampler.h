// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What LinuxCNC's component sampler has recorded, as `halsampler -t` prints it: one line per
/// servo cycle. Its pins are, in this order: set points of X, Y, Z; actual positions of X, Y, Z;
/// path speed (`motion.current-vel`); line of the program (`motion.program-line`).
/// @threadsafety plain values.
#pragma once

#include <string_view>

#include "base/instant.h"
#include "base/vec3.h"
#include "trace/control_trace.h"

namespace rivulet::linuxcnc {

/// How the numbers of the machine become those of a trace.
struct SampleScale {
  base::Duration cycle{};  ///< servo period
  double mmPerUnit = 1.0;
  base::Vec3 zeroMm;  ///< of the workpiece frame, machine coordinates
};

/// Whether the line is no sample, but says that samples before the next one have been lost.
[[nodiscard]] bool isOverrun(std::string_view line);

/// Appends the line to the trace. Samples that the sampler lost make the trace incomplete.
/// @return false if it is no line of `halsampler -t` with these pins
bool addSample(trace::ControlTrace& trace, std::string_view line, const SampleScale& scale);

}  // namespace rivulet::linuxcnc
