// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Runs with faults drawn from a seed, a third of those of method window with rotary axes: the
/// faults of `FaultyLink`, stops and holds at any moment, a control that drops into reset, another
/// writer in the same cells, another program on the control. Afterwards an operator resumes the
/// run, as often as necessary. The result is evidence, not a judgement: the machine's own trace,
/// and each write into a window that must not be written.
/// @threadsafety pure; runs on the calling thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "random_scenario.h"
#include "streaming/simulation/faulty_link.h"

namespace rivulet::streaming {

struct FaultScenario {
  RandomScenario run;
  gcode::Trajectory whole;  ///< before moves were merged, if the run has a tolerance
  LinkFaults faults;
  std::optional<base::Duration> stopAfter;  ///< of the first attempt
  std::optional<base::Duration> holdAfter;  ///< of the first attempt
  base::Duration holdFor{};
  /// Of each attempt, ascending: holds and overrides. The last one lets the axes go.
  struct Order {
    base::Duration after{};
    FeedOrder order;
  };
  std::vector<Order> orders;
  std::optional<base::Duration> resetAfter;     ///< the control drops into reset
  std::optional<base::Duration> intruderAfter;  ///< from then on another client writes now and then
  bool wrongProgram = false;  ///< the control runs another template than the one transferred
  bool resumes = true;        ///< an operator resumes the run
  /// … the moment the connection is lost, while requests of the old one are still on their way.
  bool hurries = false;
};

/// One start of the program on the control, up to the next or to the end.
struct FaultSegment {
  trace::ControlTrace trace;
  base::Vec3 endMm;  ///< position of the tool at its end
  base::RotaryDeg endDeg{};
  bool wasReset = false;  ///< the control dropped into reset meanwhile
};

struct FaultEvidence {
  bool wasResetWhileHeld = false;  ///< by the operator, as the client that held the axes was gone
  std::vector<FaultSegment> segments;
  std::vector<RunReport> reports;       ///< of each attempt
  std::vector<std::string> violations;  ///< writes and motions that must not occur
  std::size_t strayWrites = 0;
  std::size_t intrusions = 0;
  bool endedByItself = true;  ///< whenever the client was gone, the channel went to reset
};

/// @param method  the method exposed to it
[[nodiscard]] FaultScenario drawFaults(std::uint64_t seed, const machine::MachineConfig& preset,
                                       base::MethodKind method);

[[nodiscard]] FaultEvidence expose(const FaultScenario& scenario);

}  // namespace rivulet::streaming
