// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where and why the axes stood, in the trace of any control; nothing has to be known about how the
/// program was executed. @threadsafety pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/instant.h"
#include "base/vec3.h"
#include "trace/motion.h"
#include "trace/recording.h"

namespace rivulet::trace {

enum class StopCause {
  Unknown,
  ExactStop,         ///< the path turns there, and the axes did nothing but brake and accelerate
  Dwell,             ///< G4
  ProgrammedStop,    ///< M0, M1
  ToolChange,        ///< or another auxiliary function
  Hold,              ///< override 0
  WaitingForData,    ///< the client wrote the data while the axes stood
  PreprocessorStop,  ///< STOPRE: the program on the control jumps back to its loop
};
/// "unknown", "exact stop", "dwell", ...
[[nodiscard]] std::string_view stopCauseName(StopCause cause);

struct Standstill {
  base::Instant start{};
  base::Duration duration{};     ///< 0: the axes stopped for a moment between two samples
  base::Duration uncertainty{};  ///< the sampling allows the duration to differ by this much
  base::Vec3 placeMm;
  std::uint32_t line = 0;  ///< of the program on the control; 0: not recorded
  StopCause cause = StopCause::Unknown;
  std::string evidence;  ///< what shows the cause; in English
};

/// All stops between the first and the last motion, also those that no sample hit: the path stopped
/// for a moment if its braking, continued at the same rate, ends before the acceleration begins.
/// Standing samples are counted as `findPauses` counts them.
[[nodiscard]] std::vector<Standstill> findStandstills(const Motion& motion);

/// The causes that the trace itself shows: events of the control, override, turns of the path,
/// jumps of the program. @param recording  whose accesses show more; may be null
void findCauses(std::vector<Standstill>& stops, const Motion& motion, const Recording* recording);

}  // namespace rivulet::trace
