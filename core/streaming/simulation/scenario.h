// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One run in virtual time, as a value: everything that decides it is in the scenario, and the same
/// scenario gives the same run to the bit. It uses the production job, driver and methods.
/// @threadsafety pure; runs on the calling thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/random.h"
#include "gcode/program.h"
#include "machine/config.h"
#include "streaming/run/run.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::streaming {

struct Scenario {
  machine::MachineConfig machine;
  std::shared_ptr<const gcode::Program> program;
  RunSettings settings;
  std::uint64_t seed = 1;
  /// A run without progress repeats its loop forever: it is stopped after this much machine time.
  base::Duration limit = std::chrono::hours{2};
};

/// Runs it from preflight to the oracle's judgement.
/// @param load  receives the machine's count of the accesses; may be null
[[nodiscard]] RunReport simulate(const Scenario& scenario, ServiceLoad* load = nullptr);

/// Program whose points are streamed as they are.
[[nodiscard]] std::shared_ptr<const gcode::Program> programOf(
    const std::vector<base::Vec3>& pointsMm);
/// The same with angles of those rotary axes, one per point.
[[nodiscard]] std::shared_ptr<const gcode::Program> programOf(
    const std::vector<base::Vec3>& pointsMm, const std::vector<base::RotaryDeg>& anglesDeg,
    const base::RotarySet& rotaryAxes);

/// The machine with these rotary axes: those it lacks are like A of dmu75-5axis.
[[nodiscard]] machine::MachineConfig withRotaryAxes(machine::MachineConfig machine,
                                                    const base::RotarySet& rotaryAxes);

/// A contour like that of [P1]: thinned so that no two neighbours are closer than d_min, and most
/// are further apart. Steps are d_min plus an exponential rest; the direction varies at random in
/// the plane Z = 0, within the working area.
struct ContourOptions {
  std::size_t points = 200;
  double pointDistanceMmMin = 0.15;  ///< d_min
  double restMmMean = 0.15;          ///< 0: evenly spaced
};
[[nodiscard]] std::vector<base::Vec3> drawContour(const ContourOptions& options,
                                                  base::Random& random);

}  // namespace rivulet::streaming
