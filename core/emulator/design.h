// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What to record next: the short program that tells most about the axes, given what is known of
/// them.
///
/// A program tells the more about a parameter, the more the positions would change with it. With S
/// the changes of all observed positions by the logarithms of the parameters, and the noise σ of a
/// position, S'S/σ² is the Fisher information; its inverse is the covariance that the parameters
/// can have at best. Programs are compared by the logarithm of its determinant, summed over the
/// axes (D-optimal): it counts the volume of what is still possible, whatever the units of the
/// parameters are. What is already known of a parameter, its interval, is added to its information.
///
/// Programs are lines, reversals and circles with feeds, in a box. The search exchanges one move at
/// a time and keeps what tells more. @threadsafety pure functions.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/vec3.h"
#include "emulator/emulator.h"

namespace rivulet::emulator {

/// A straight line, or a full circle in the XY plane around a centre.
struct DesignMove {
  base::Vec3 toMm;          ///< end of a line; a circle ends where it begins
  double feedMmPerS = 1.0;  ///< > 0
  double radiusMm = 0.0;    ///< 0: a line; else of a circle, whose centre is in +X from its begin
};

struct DesignBox {
  base::Vec3 minMm;
  base::Vec3 maxMm;  ///< as minMm in an axis: this one does not move
  double feedMmPerSMin = 1.0;
  double feedMmPerSMax = 50.0;
  double durationS = 25.0;  ///< the program is not longer
};

/// The set points that the machine makes of the moves, from the first place of the box on.
struct PlannedMoves {
  double periodS = 0.0;
  std::vector<base::Vec3> setPointsMm;
};
using PlanMoves = std::function<PlannedMoves(base::Vec3 startMm, std::span<const DesignMove>)>;

struct DesignOptions {
  double noiseMm = 0.001;                  ///< of one observed position, standard deviation, > 0
  double spacingS = 0.004;                 ///< between two observations
  int exchanges = 300;                     ///< how long to search
  std::uint64_t seed = 1;                  ///< same seed, same program
  bool usesIntervals = true;               ///< of the emulator; false: as if nothing were known
  std::function<bool(double)> progress{};  ///< share done, 0 to 1; false stops: the best so far
};

/// What is known of a parameter, and would be after a program.
struct ParameterGain {
  char axis = 'X';
  AxisParameter parameter = AxisParameter::PositionGain;
  double deviationBefore = 0.0;  ///< relative standard deviation
  double deviationAfter = 0.0;
};

struct ProposedProgram {
  std::vector<DesignMove> moves;
  double durationS = 0.0;
  double logDeterminant = 0.0;  ///< of the information afterwards, all axes that move together
  std::vector<ParameterGain> gains;
};

/// How much a run would tell.
/// @return logDeterminant and gains; moves stay empty
[[nodiscard]] ProposedProgram informationOf(const Emulator& emulator, const PlannedMoves& run,
                                            const DesignOptions& options);

/// @return EmulatorError::NoMotion if no axis of the emulator moves in the box, BadNumbers for a
/// box that is none; Cancelled before the first program
[[nodiscard]] base::Result<ProposedProgram> proposeProgram(const Emulator& emulator,
                                                           const DesignBox& box,
                                                           const PlanMoves& plan,
                                                           const DesignOptions& options);

/// As NC program: G64 G90 G17, G1 and G3, feeds in mm/min, M30.
[[nodiscard]] std::string programText(base::Vec3 startMm, std::span<const DesignMove> moves);

}  // namespace rivulet::emulator
