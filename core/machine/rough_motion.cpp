// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/rough_motion.h"

#include <algorithm>

namespace rivulet::machine {

RoughMotion roughMotion(const PreparedMotion& motion, const base::AxisPosition& from,
                        const MachineConfig& config) {
  RoughMotion rough;
  rough.motion = motion;
  rough.fromDeg = from.deg;
  rough.turnDeg = base::turnDeg(from.deg, motion.targetDeg);
  const bool turns = rough.turnDeg > kPathTurnDegMin;
  const double straightMm = base::distance(from.mm, motion.targetMm);
  rough.moves = motion.arc || straightMm > kPathLengthMmMin || turns;
  if (!rough.moves) {
    return rough;
  }
  rough.inDegrees = !motion.arc && turns && straightMm * base::kDegPerMmMax < rough.turnDeg;
  rough.path = motion.arc        ? PathPiece::arc(from.mm, motion.targetMm, *motion.arc)
               : rough.inDegrees ? PathPiece::turning(from.mm, motion.targetMm, rough.turnDeg)
                                 : PathPiece::line(from.mm, motion.targetMm);
  rough.wayMm = rough.inDegrees ? straightMm : rough.path.lengthMm();
  for (std::size_t axis = 0; turns && axis < base::kRotaryAxisCount; ++axis) {
    rough.degPerMm[axis] = (motion.targetDeg[axis] - from.deg[axis]) / rough.path.lengthMm();
  }
  rough.feedMmPerS = rough.inDegrees ? motion.feedDegPerS : motion.feedMmPerS;
  if (config.blocksPerCycleMax > 0.0) {
    // The main run takes a new block once a cycle at most: short blocks are passed slower.
    rough.feedMmPerS = std::min(rough.feedMmPerS, config.blocksPerCycleMax * rough.path.lengthMm() /
                                                      base::toSeconds(config.interpolationCycle));
  }
  return rough;
}

}  // namespace rivulet::machine
