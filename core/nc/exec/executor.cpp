// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/executor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "nc/unknown.h"

namespace rivulet::nc {

Executor::Executor(const Language& language, const ExecutorOptions& options, Variables& variables,
                   Sinks to)
    : m_language(language),
      m_options(options),
      m_to(to),
      m_reader(language, m_state, variables, to) {
}

std::optional<double> Executor::positionOf(char axis) const {
  if (axis < 'X' || axis > 'Z') {
    return std::nullopt;
  }
  const double value = programmed()[static_cast<std::size_t>(axis - 'X')] / m_state.lengthFactor;
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void Executor::execute(BlockWords& words) {
  if (words.hasRotary) {
    leaveOutMissingAxes(words);
  }
  if (words.foreignMotion) {
    finishCurve();
  }
  if (words.latheKey >= 0 && words.latheKey != 910 && words.motionKey < 0 && words.movesLinear()) {
    executeTurningCycle(words);
  }
  setModes(words);
  if (m_state.workOffset != m_frameOffset) {
    m_frameOffset = m_state.workOffset;
    if (!m_workOffsets.empty()) {
      finishCurve();
      makeBaseFrame();
    }
  }
  if (m_options.knowsMachineCoordinates) {
    takeZero();
  }
  if (words.rare) {
    executeRare(words);
  }
  if (hasUnusedParameter(words)) {
    m_to.faults.error(*words.parameter, FaultCode::UnknownWord);
  }
  if (words.dwell) {
    executeDwell(words);
  } else {
    if (words.feed != nullptr && !(words.taken && words.rare && words.rare->macroCall)) {
      setFeed(words);
      if (!(words.feed->value > 0.0)) {
        words.feed = nullptr;  // reported; with G93, no motion takes it
      }
    }
    if (!words.taken) {
      executeMotion(words);
    }
  }
  m_reader.endBlock();
}

void Executor::leaveOutMissingAxes(BlockWords& words) const {
  words.hasRotary = false;
  for (std::size_t axis = kFirstRotary; axis < kProgrammedAxisCount; ++axis) {
    const bool exists = axis < kFirstFurther ? m_options.rotaryAxes[axis - kFirstRotary]
                                             : m_options.refusesFurtherAxes;
    words.axes.given[axis] = words.axes.given[axis] && exists;
    words.hasRotary = words.hasRotary || words.axes.given[axis];
  }
  const bool isFurther = words.parameter != nullptr && words.parameter->address == 'U';
  if (isFurther && !m_options.refusesFurtherAxes) {
    words.parameter = nullptr;
  }
}

/// G90 X Z and G94 X Z of a lathe go along a rectangle; with G0 to G3 they are what they are on
/// a mill.
void Executor::executeTurningCycle(BlockWords& words) {
  error(words, FaultCode::CycleNotRun, fmt::format("G{}", words.latheKey / 10));
  m_to.words.foreignMotion();
  words.taken = true;
}

bool Executor::hasUnusedParameter(const BlockWords& words) const {
  if (words.parameter == nullptr || words.dwell || words.tolerance || words.taken ||
      m_state.motion == Motion::Unsupported || m_state.motion == Motion::CubicSpline ||
      m_state.motion == Motion::Nurbs) {
    return false;
  }
  return !words.rare || !(words.rare->call98 || words.rare->workOffsetToken != nullptr ||
                          words.rare->call || words.rare->returns);
}

void Executor::setModes(const BlockWords& words) {
  if (words.unitsKey >= 0) {
    const bool inches = words.unitsKey == 200 || words.unitsKey == 700 || words.unitsKey == 7000;
    const bool lengthsOnly = words.unitsKey == 700 && m_language.inchesOfLengthsOnly;
    m_state.lengthFactor = inches ? base::kMmPerInch : 1.0;
    m_state.feedFactor = lengthsOnly ? 1.0 : m_state.lengthFactor;
    m_to.words.units(inches);
  }
  if (words.planeKey >= 0) {
    m_state.planeFirstAxis = words.planeKey == 170 ? 0 : (words.planeKey == 180 ? 2 : 1);
  }
  if (words.motionKey >= 0) {
    finishCurve();
    m_state.motion = static_cast<Motion>(words.motionKey / 10);
  }
  if (words.blockEndKey >= 0) {
    setBlockEnd(words.blockEndKey);
  }
  if (words.compensationKey >= 0) {
    setCompensation(words);
  }
}

/// Whoever takes the path offsets it.
void Executor::setCompensation(const BlockWords& words) {
  if (words.compensationKey != 400 && !m_options.compensatesRadius) {
    m_to.faults.error(*words.compensation, FaultCode::UnsupportedGCode,
                      wordText(*words.compensation));
    return;
  }
  m_state.compensationSide = words.compensationKey == 400   ? 0
                             : words.compensationKey == 410 ? 1
                                                            : -1;
}

void Executor::setBlockEnd(int key) {
  constexpr std::array kExactStops{600, 610, 611};
  constexpr int kByDistance = 6410;
  constexpr int kAccuracy = 1870;  // G187 of Haas: how closely, not whether
  if (key == kAccuracy) {
    return;
  }
  const bool stops = std::find(kExactStops.begin(), kExactStops.end(), key) != kExactStops.end();
  m_state.blockEnd = stops ? BlockEnd::ExactStop : BlockEnd::Rounded;
  m_state.rounding = key == kByDistance ? RoundingKind::Distance : RoundingKind::Deviation;
}

/// What must happen before the axes of the block are read.
void Executor::executeRare(BlockWords& words) {
  const RareWords& rare = *words.rare;
  if (rare.threePointArc || rare.tangentArc) {
    finishCurve();
    m_state.motion = rare.threePointArc ? Motion::ThreePointArc : Motion::TangentArc;
  }
  if (rare.bSpline) {
    finishCurve();
    m_state.motion = Motion::BSpline;
    m_splineDegree = 3;
  }
  if (rare.machineAxis != nullptr && rare.fixedPoint == nullptr) {
    m_to.faults.error(*rare.machineAxis, FaultCode::UnknownWord);
  }
  if (rare.fixedPoint != nullptr) {
    moveToFixedPoint(words);
  }
  if (const NamedWord* const degree = words.named("SD")) {
    m_splineDegree = degree->value >= 2.0 && degree->value < 3.0 ? 2 : 3;
  }
  if (rare.splineKey >= 0) {
    selectSpline(rare.splineKey);
  }
  if (rare.workOffsetToken != nullptr && !words.p) {
    m_to.faults.error(*rare.workOffsetToken, FaultCode::NumberMissing, "P");
  } else if (rare.workOffsetToken != nullptr) {
    m_reader.selectWorkOffset(rare.workOffsetKey, *rare.workOffsetToken, *words.p);
  }
  if (rare.poleKey >= 0) {
    setPole(words);
  }
  if (!rare.frame.empty()) {
    setFrame(rare.frame, words);
  }
  if (rare.offset != GEffect::None) {
    setOffset(words);
  }
}

/// X, F, P and U of a dwell are times, S turns of the spindle; what else it names would be lost.
void Executor::executeDwell(const BlockWords& words) {
  for (std::size_t axis = 1; axis < base::kAxisCount; ++axis) {
    if (words.axes.given[axis]) {
      m_to.faults.error(*words.axisTokens[axis], FaultCode::UnknownWord);
    }
  }
  rejectArcWords(words);
  double seconds = kUnknown;
  if (words.spindle != nullptr) {
    m_state.spindlePerMin = words.spindleBefore;
    if (words.spindleBefore > 0.0) {
      seconds = words.spindle->value * 60.0 / words.spindleBefore;
    }
  }
  if (words.feed != nullptr) {
    seconds = words.feed->value;
  } else if (words.p) {
    // Fanuc counts milliseconds where there is no point, RS-274/NGC seconds.
    const bool milliseconds = m_language.dwellInMilliseconds && !words.parameter->hasPoint;
    seconds = milliseconds ? *words.p / 1000.0 : *words.p;
  } else if (words.axes.given[0]) {
    seconds = words.axes.value[0];
  } else if (words.axes.given[kFirstFurther]) {
    seconds = words.axes.value[kFirstFurther];
  }
  m_to.path.machineWord(MachineWord::Dwell, seconds, words.line);
}

void Executor::rejectArcWords(const BlockWords& words) {
  if (words.hasRadius) {
    m_to.faults.error(*words.radiusToken, FaultCode::UnknownWord);
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.hasCentre[axis]) {
      m_to.faults.error(*words.centreTokens[axis], FaultCode::UnknownWord);
    }
  }
}

void Executor::setFeed(const BlockWords& words) {
  const double feed = words.feed->value;
  m_to.words.feed(feed);
  if (!(feed > 0.0)) {
    m_to.faults.error(*words.feed, FaultCode::FeedNotPositive, base::formatNumber(feed));
    return;
  }
  double mmPerMin = feed * m_state.feedFactor;
  if (m_state.feedMode == FeedMode::PerRevolution) {
    m_state.feedMmPerRev = feed * m_state.feedFactor;
    m_state.feedDegPerRev = feed;
    mmPerMin = m_state.feedMmPerRev * m_state.spindlePerMin;
  } else if (m_state.feedMode != FeedMode::PerMinute) {
    return;  // known block by block, or not at all
  }
  // A SINUMERIK refuses such a number; others move as fast as the machine can.
  constexpr double kReducedMmPerMinMax = 1e9;
  const bool reduces = m_language.dialect != Dialect::Sinumerik;
  if (!(mmPerMin <= (reduces ? kReducedMmPerMinMax : kCoordinateMmMax))) {
    m_to.faults.error(*words.feed, FaultCode::ValueOutOfRange);
    return;
  }
  m_to.path.feed(mmPerMin);
  m_state.feedMmPerS = base::mmPerSFromMmPerMin(mmPerMin);
  m_state.feedDegPerS = feed / 60.0;
  m_state.feedIsDefault = false;
}

}  // namespace rivulet::nc
