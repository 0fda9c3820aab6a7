// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs on which everything goes wrong that can, drawn from a seed, a third of those of method
/// window with rotary axes: what `FaultyLink` does, stops
/// and holds at any moment, a control that drops into reset, another writer in the same cells,
/// another program on the control. Afterwards an operator takes the run up again, as often as it
/// takes. What is left behind is evidence, not a judgement: the machine's own trace, and each write
/// into a window that was not to be written into.
/// @threadsafety pure; runs on the calling thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/random_scenario.h"

namespace rivulet::streaming {

struct FaultScenario {
  RandomScenario run;
  LinkFaults faults;
  std::optional<base::Duration> stopAfter;  ///< of the first attempt
  std::optional<base::Duration> holdAfter;  ///< of the first attempt
  base::Duration holdFor{};
  std::optional<base::Duration> resetAfter;     ///< the control drops into reset
  std::optional<base::Duration> intruderAfter;  ///< from then on someone else writes now and then
  bool wrongProgram = false;  ///< the control runs another template than the one transferred
  bool resumes = true;        ///< an operator takes the run up again
  /// … the moment the connection is lost, while requests of the old one are still on their way.
  bool hurries = false;
};

/// One start of the program on the control, up to the next or to the end.
struct FaultSegment {
  trace::ControlTrace trace;
  base::Vec3 endMm;  ///< where the tool stood when it was over
  base::RotaryDeg endDeg{};
  bool wasReset = false;  ///< the control dropped into reset meanwhile
};

struct FaultEvidence {
  std::vector<FaultSegment> segments;
  std::vector<RunReport> reports;       ///< of each attempt
  std::vector<std::string> violations;  ///< writes and motions that must not have been
  std::size_t strayWrites = 0;
  std::size_t intrusions = 0;
  bool endedByItself = true;  ///< wherever the client was gone, the channel came to reset
};

/// @param method  which is exposed to it
[[nodiscard]] FaultScenario drawFaults(std::uint64_t seed, const machine::MachineConfig& preset,
                                       base::MethodKind method);

[[nodiscard]] FaultEvidence expose(const FaultScenario& scenario);

}  // namespace rivulet::streaming
