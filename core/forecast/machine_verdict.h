// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The verdict on a program on a machine: the stricter of the equations of [P1] and of what this
/// machine would do. The equations know averages, even windows and no requests; the machine's
/// motion and each request of the client are followed with their scatter (feasibility/probability),
/// over the real points. `experiment verdict` says how often a run that it allows goes wrong.
/// @threadsafety pure.
#pragma once

#include <vector>

#include "feasibility/verdict.h"
#include "machine/config.h"

namespace rivulet::forecast {

/// A run is allowed if at most one of so many is expected to go wrong at a feed that is higher by
/// `kFeedReserve`.
inline constexpr double kRunsPerFailure = 1e4;
/// The model's feeds are not exact: `feasibility::kFeedErrorFactor`.
inline constexpr double kFeedReserve = 1.05;
/// Longer programs are judged by so many points around their tightest place, as if all were like
/// it.
inline constexpr std::size_t kJudgedPointsMax = 1500;

/// The access of a machine, with the cost that was measured. The scatter keeps its proportion.
void charge(machine::AccessCost& cost, const feasibility::MeasuredAccess& measured);

/// `feasibility::judge`, and one more condition, `Equation::Machine`. Methods position and signal:
/// it must hold as well. Methods with windows: it decides in place of the reach, which takes every
/// window for the shortest and the axes for infinitely quick.
/// @param points  as streamed; with feeds of their own: those at which the run is to be made
/// @param machine  whatever its dynamics after a reset are, the worse of BRISK and SOFT counts: the
/// flexible program does not set them, and a control can be set to either. BRISK is faster; SOFT
/// keeps the tool longer near points that are not due
/// @return as `feasibility::judge` @threadsafety pure; position and signal: about 20 predictions,
/// up to half a second
[[nodiscard]] base::Result<feasibility::Verdict> judgeOn(
    const machine::MachineConfig& machine, const std::vector<gcode::StreamPoint>& points,
    const feasibility::OperatingPoint& operatingPoint,
    const feasibility::ProgramDistances& distances, const feasibility::AccessModel& access = {},
    const feasibility::SafetyFactors& safety = {});

}  // namespace rivulet::forecast
