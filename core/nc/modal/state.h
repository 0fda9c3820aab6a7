// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What stays in force from block to block: the active function of each modal group, and what the
/// next block counts from. Lengths in mm, programmed coordinates. @threadsafety plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "base/axes.h"
#include "base/vec3.h"
#include "nc/modal/frame.h"
#include "nc/unknown.h"

namespace rivulet::nc {

/// The first four are G0 to G3.
enum class Motion : unsigned char {
  Rapid,
  Line,
  ArcClockwise,
  ArcCounter,
  None,             ///< no motion has been named yet
  ThreePointArc,    ///< CIP
  TangentArc,       ///< CT
  BSpline,          ///< BSPLINE
  CubicSpline,      ///< G5
  QuadraticSpline,  ///< G5.1
  Nurbs,            ///< G5.2
  Unsupported,      ///< a cycle, a thread: motions that are not made here
};

[[nodiscard]] constexpr bool isPlaneArc(Motion motion) {
  return motion == Motion::ArcClockwise || motion == Motion::ArcCounter;
}

enum class FeedMode : unsigned char { PerMinute, InverseTime, PerRevolution, Unknown };

/// How the path continues after a block.
enum class BlockEnd : unsigned char {
  ExactStop,  ///< G60, G9: the axes stop
  Rounded,    ///< G64 and G641 to G645: the corner is rounded
};

/// What bounds the rounding of a corner.
enum class RoundingKind : unsigned char {
  Deviation,  ///< G64, G642: largest distance of the rounded path from the corner
  Distance,   ///< G641 ADIS=, ADISPOS=: path length before the corner at which rounding may begin
};

/// How the path speed changes.
enum class Dynamics : unsigned char {
  Brisk,  ///< BRISK: with the axes' acceleration
  Soft,   ///< SOFT: with the axes' acceleration and jerk
};

/// A canned cycle of RS-274 in force. Numbers as written, in the unit of the program.
struct CannedCycle {
  int key = 0;           ///< of its G function; 0: none
  bool isFirst = false;  ///< no block of it has been executed
  bool hasStart = false;
  std::size_t planeFirstAxis = 0;
  double start = 0.0;    ///< height before the first of several cycles
  double retract = 0.0;  ///< R
  double bottom = 0.0;
  double stroke = 0.0;  ///< Q
  double dwellS = 0.0;  ///< P
};

struct ModalState {
  Motion motion = Motion::None;
  Motion motionBeforeUnsupported = Motion::None;
  bool motionAssumed = false;  ///< G1 by default, not by a word
  bool motionNamed = false;
  bool motionIsOff = false;  ///< G80, where none may be assumed afterwards

  std::size_t planeFirstAxis = 0;  ///< 0: G17, 2: G18, 1: G19
  double lengthFactor = 1.0;       ///< mm per unit of the program
  double feedFactor = 1.0;         ///< mm/min per unit of F
  bool relative = false;           ///< G91
  bool centreIsAbsolute = false;   ///< G90.1
  bool diameter = false;           ///< X is a diameter
  bool diameterIncrements = false;
  bool isLathe = false;  ///< ISO: turning cycles, U and W as increments

  FeedMode feedMode = FeedMode::PerMinute;
  double feedMmPerS = 0.0;             ///< 0: none is programmed
  double feedDegPerS = 0.0;            ///< the same number, for blocks that only turn
  bool feedIsDefault = false;          ///< of the machine: the program has named none
  double spindlePerMin = 0.0;          ///< as S says; 0: not known
  bool constantSurfaceSpeed = false;   ///< G96: S is a cutting speed
  double surfaceMmPerMin = 0.0;        ///< the cutting speed
  double surfaceSpeedPerMinMax = 0.0;  ///< LIMS=: limit of the spindle meanwhile; 0: none
  double feedOverride = 1.0;           ///< OVR=
  double feedMmPerRev = 0.0;           ///< with G95
  double feedDegPerRev = 0.0;          ///< the same number
  /// The number of F means something else from now on.
  void loseFeed() { feedMmPerS = feedDegPerS = feedMmPerRev = feedDegPerRev = 0.0; }

  CannedCycle cycle;
  std::optional<bool> retractsToR;  ///< G99; else G98, to where the cycle began

  BlockEnd blockEnd = BlockEnd::ExactStop;
  RoundingKind rounding = RoundingKind::Deviation;
  double roundingMm = 0.0;  ///< ADIS=
  Dynamics dynamics = Dynamics::Brisk;

  int workOffset = -1;            ///< key of its G function; -1: none named
  double workOffsetNumber = 0.0;  ///< of the further ones of G54.1 and G154
  base::Vec3 workOffsetMm;        ///< its value; zero where only the control knows it
  double toolLengthMm = 0.0;      ///< of the cutting edge in effect, along the tool
  int compensationSide = 0;       ///< G41 1: left of the path; G42 -1; G40 0
  bool cornersIntersect = false;  ///< G451; else G450
  bool goesAroundStart = false;   ///< KONT; else NORM
  bool turnsShortest = false;     ///< M126: absolute values of rotary axes are `Nearest`
  /// DC() and the like have shown that the axis counts from 0 to 360 degrees.
  std::array<bool, base::kRotaryAxisCount> isModulo{};
  std::string tipWord;  ///< what keeps X Y Z at the tip of the tool; empty: nothing

  Frame baseFrame;                 ///< G52 and G92; TRANS and ROT work on it
  base::RotaryDeg rotaryOffset{};  ///< G92
  /// Programmed coordinates from before a change of the frame. The next increment of an axis counts
  /// from there, so that it passes the shift of the frame as well (SD42440, as delivered).
  std::array<std::optional<double>, base::kAxisCount> incrementFrom;

  base::Vec3 poleMm;
  bool polar = false;  ///< G16
  double polarRadiusMm = kUnknown;  ///< none has been named
  double polarDegrees = kUnknown;   ///< none has been named

  [[nodiscard]] std::size_t planeSecondAxis() const {
    return (planeFirstAxis + 1) % base::kAxisCount;
  }
  [[nodiscard]] std::size_t planeThirdAxis() const {
    return (planeFirstAxis + 2) % base::kAxisCount;
  }
  /// Of the active plane: the tool stands on it.
  [[nodiscard]] base::Vec3 toolMm() const {
    base::Vec3 tool;
    tool.set(planeThirdAxis(), toolLengthMm);
    return tool;
  }
  /// Zero of the workpiece frame in machine coordinates, with the tool's tip as reference.
  [[nodiscard]] base::Vec3 zeroMm() const { return workOffsetMm + toolMm(); }
};

}  // namespace rivulet::nc
