// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One run of the emulator of [P2], and how far it is from what was observed: the objective Q.
/// @threadsafety pure functions.
#pragma once

#include <array>
#include <vector>

#include "emulator/paper/course.h"
#include "emulator/paper/parameters.h"

namespace rivulet::emulator::paper {

/// The objective of a candidate that ran away is at least this, and that of any other less: with
/// the limits of a stable run on both axes and λ = 1 it is at most 2.1e8.
inline constexpr double kDivergedObjective = 1e9;

/// What the emulator does at the points of a course.
struct Emulation {
  std::array<std::vector<double>, 2> mm;      ///< of X, of Y
  std::array<std::vector<double>, 2> mmPerS;  ///< likewise
  /// Share of the course until an axis ran away, 1 if none did. Points after it are 0.
  double stableShare = 1.0;

  [[nodiscard]] bool diverged() const { return stableShare < 1.0; }
};

/// Both axes from rest at the first set points to the last point of the course.
/// @param plant  its stepS is that of the course
[[nodiscard]] Emulation emulate(const Course& course, const Parameters& values,
                                const PlantSettings& plant);

/// Mean squares over the points at kTransienceS and later, of X and of Y.
struct Misfit {
  std::array<double, 2> mm2{};
  std::array<double, 2> mm2PerS2{};
  double stableShare = 1.0;

  /// Q(x, y), mm². @source [P2] section 3.1
  [[nodiscard]] double positionMm2() const { return mm2[kAxisX] + mm2[kAxisY]; }
  [[nodiscard]] double speedMm2PerS2() const { return mm2PerS2[kAxisX] + mm2PerS2[kAxisY]; }
  /// Q; for a candidate that ran away more than any other has, and the less the later it did.
  /// @param lambda  weight of the speeds, s², >= 0. @source [P2] section 2.3
  [[nodiscard]] double objective(double lambda) const;
};

/// @pre the course has speeds, or they count nothing (their mean squares are 0 then)
[[nodiscard]] Misfit misfitOf(const Course& course, const Emulation& emulation);

}  // namespace rivulet::emulator::paper
