// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/exec/executor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "nc/unknown.h"

namespace rivulet::nc {

namespace {

Motion motionOf(G function) {
  switch (function) {
    case G::Rapid:
      return Motion::Rapid;
    case G::Line:
      return Motion::Line;
    case G::ArcClockwise:
      return Motion::ArcClockwise;
    default:
      return Motion::ArcCounter;
  }
}

}  // namespace

Executor::Executor(const Language& language, const ExecutorOptions& options, Variables& variables,
                   Sinks to)
    : m_language(language),
      m_options(options),
      m_to(to),
      m_reader(language, options.runsCannedCycles, m_state, variables, to),
      m_unitIsSaid(options.unitIsSaid || !language.unitIsOfMachine) {
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
  if (words.g.turning != nullptr && words.g.motion == nullptr && words.movesLinear()) {
    executeTurningCycle(words);
  }
  const bool hasFeedBefore =
      words.g.units != nullptr && m_language.feedComesBeforeUnits && !words.taken;
  if (hasFeedBefore) {
    setSpindle(words);
    takeFeed(words);
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
  if (!hasFeedBefore && (words.spindle != nullptr || words.rare)) {
    setSpindle(words);
  }
  if (words.rare) {
    executeRare(words);
  }
  if (words.changesLength && !m_options.knowsMachineCoordinates) {
    constexpr std::size_t kToolAxis = 2;  // of RS-274, in each plane
    m_position.programmedMm.set(kToolAxis, kUnknown);
    m_state.incrementFrom[kToolAxis].reset();
  }
  if (hasUnusedParameter(words)) {
    m_to.faults.error(*words.parameter, FaultCode::UnknownWord);
  }
  if (words.dwell) {
    executeDwell(words);
  }
  if (!words.dwell || m_language.dwellsBesideMove) {
    if (!hasFeedBefore) {
      takeFeed(words);
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
    if (!exists) {
      words.axes.remove(axis);
    }
    words.hasRotary = words.hasRotary || words.axes.has(axis);
  }
  const bool isFurther = words.parameter != nullptr && words.parameter->address == 'U';
  if (isFurther && !m_options.refusesFurtherAxes) {
    words.parameter = nullptr;
  }
}

/// G90 X Z and G94 X Z of a lathe go along a rectangle; with G0 to G3 they are what they are on
/// a mill.
void Executor::executeTurningCycle(BlockWords& words) {
  error(words, FaultCode::CycleNotRun, fmt::format("G{}", words.g.turning->key / 10));
  m_to.words.foreignMotion();
  words.taken = true;
}

bool Executor::hasUnusedParameter(const BlockWords& words) const {
  if (words.parameter == nullptr || words.tolerance || words.taken ||
      m_state.motion == Motion::Unsupported || m_state.motion == Motion::CubicSpline ||
      m_state.motion == Motion::Nurbs || words.takesParameter) {
    return false;
  }
  const bool isP = words.parameter->address == 'P';
  if ((words.dwell && (isP || !m_language.dwellsBesideMove)) ||
      (m_language.hasTurnsInP && isPlaneArc(m_state.motion) && isP)) {
    return false;
  }
  return !words.rare ||
         !(words.rare->call98 || words.rare->call97 || words.rare->workOffsetToken != nullptr ||
           words.rare->call || words.rare->returns);
}

void Executor::setModes(const BlockWords& words) {
  if (words.g.units != nullptr) {
    setUnits(words.g.units->function);
  }
  if (words.g.plane != nullptr) {
    const G plane = words.g.plane->function;
    const std::size_t first = plane == G::PlaneXY ? 0 : (plane == G::PlaneZX ? 2 : 1);
    if (m_turn && first != m_state.planeFirstAxis) {  // G68 turns in the plane it began in
      error(words, FaultCode::UnsupportedGCode, fmt::format("G{}", words.g.plane->key / 10));
    }
    m_state.planeFirstAxis = first;
  }
  if (words.g.motion != nullptr) {
    m_curve.lastTangent = {};
    m_state.cycle = {};
    finishCurve();
    m_state.motion = motionOf(words.g.motion->function);
    m_state.motionIsOff = false;
  }
  if (words.g.blockEnd != nullptr) {
    setBlockEnd(words.g.blockEnd->function);
  }
  if (words.g.compensationMode != nullptr) {
    setCompensation(words);
  }
}

void Executor::setUnits(G units) {
  const bool inches = units == G::Inches || units == G::InchesOfLengths;
  const double feedFactor = inches && units != G::InchesOfLengths ? base::kMmPerInch : 1.0;
  const bool isKept = m_language.keepsFeedOverUnits || feedFactor == m_state.feedFactor;
  if (!m_state.feedIsDefault && !(m_unitIsSaid && isKept)) {
    m_state.loseFeed();
  }
  m_unitIsSaid = true;
  m_state.lengthFactor = inches ? base::kMmPerInch : 1.0;
  m_state.feedFactor = feedFactor;
  m_to.words.units(inches);
}

/// Whoever takes the path offsets it.
void Executor::setCompensation(const BlockWords& words) {
  const G mode = words.g.compensationMode->function;
  if (mode != G::CompensationOff && !m_options.compensatesRadius) {
    m_to.faults.error(*words.compensation, FaultCode::UnsupportedGCode,
                      wordText(*words.compensation));
    return;
  }
  m_state.compensationSide = mode == G::CompensationOff ? 0 : mode == G::CompensationLeft ? 1 : -1;
}

void Executor::setBlockEnd(G function) {
  const bool stops = function == G::ExactStop || function == G::ExactPath;
  m_state.blockEnd = stops ? BlockEnd::ExactStop : BlockEnd::Rounded;
  m_state.rounding =
      function == G::ContinuousByDistance ? RoundingKind::Distance : RoundingKind::Deviation;
}

/// What S means, and its value.
void Executor::setSpindle(const BlockWords& words) {
  if (words.dwell && !m_language.dwellsBesideMove) {
    return;  // turns of the spindle
  }
  if (words.rare && words.rare->speedMax != nullptr) {
    m_state.surfaceSpeedPerMinMax = words.rare->speedMax->value;
  }
  if (words.rare && words.rare->spindleMode != nullptr) {
    const G mode = words.rare->spindleMode->function;
    const bool isSurface = mode == G::SurfaceSpeed || mode == G::SurfaceSpeedPerMinute ||
                           mode == G::SurfaceSpeedPerRevolution;
    if (isSurface != m_state.constantSurfaceSpeed) {
      m_state.constantSurfaceSpeed = isSurface;
      m_state.spindlePerMin = 0.0;
      m_state.surfaceMmPerMin = 0.0;
    }
    if (isSurface && words.edge != nullptr && m_language.speedLimitIsD) {
      m_state.surfaceSpeedPerMinMax = words.edge->value;
    }
  }
  if (words.spindle == nullptr) {
    return;
  }
  const double speed = words.spindle->value;
  const bool isLimit =
      words.rare && words.taken &&
      (words.rare->offset == GEffect::SetPosition || words.rare->offset == GEffect::ScaleOff);
  if (isLimit) {  // G50 S, G92 S of Fanuc
    m_state.surfaceSpeedPerMinMax = speed;
  } else if (m_state.constantSurfaceSpeed) {
    // Metres a minute, or feet.
    constexpr double kMmPerM = 1000.0;
    constexpr double kInchesPerFoot = 12.0;
    const bool inches = m_state.feedFactor != 1.0;
    m_state.surfaceMmPerMin = speed * (inches ? base::kMmPerInch * kInchesPerFoot : kMmPerM);
  } else {
    m_state.spindlePerMin = std::min(speed, m_options.spindlePerMinMax);
  }
}

/// Of the move to a place; 0: not known. With a cutting speed it follows from the diameter, and
/// where that changes along a move, one feed does not describe it.
double Executor::spindlePerMin(const BlockWords& words, base::Vec3 target) {
  if (!m_state.constantSurfaceSpeed) {
    return m_state.spindlePerMin;
  }
  constexpr double kSameMm = 1e-9;
  const double radiusMm = std::abs(target.x);
  const double perMin = m_state.surfaceMmPerMin / (2.0 * std::acos(-1.0) * radiusMm);
  const double before =
      m_state.surfaceMmPerMin / (2.0 * std::acos(-1.0) * std::abs(m_position.programmedMm.x));
  const double limit = m_state.surfaceSpeedPerMinMax;
  const auto limited = [this, limit](double speed) {
    return std::min(limit > 0.0 ? std::min(speed, limit) : speed, m_options.spindlePerMinMax);
  };
  const bool isConstant = std::abs(m_position.programmedMm.x - target.x) <= kSameMm ||
                          limited(before) == limited(perMin);
  const bool isOneDiameter = isConstant && !isPlaneArc(m_state.motion);
  if (!isOneDiameter || !std::isfinite(limited(perMin)) || !(m_state.surfaceMmPerMin > 0.0)) {
    if (m_state.motion != Motion::Rapid) {
      error(words, FaultCode::UnsupportedGCode, "G96");
    }
    return 0.0;
  }
  return limited(perMin);
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
    m_curve.degree = 3;
  }
  if (rare.machineAxis != nullptr && rare.fixedPoint == nullptr) {
    m_to.faults.error(*rare.machineAxis, FaultCode::UnknownWord);
  }
  if (rare.fixedPoint != nullptr) {
    moveToFixedPoint(words);
  }
  if (const NamedWord* const degree = words.named("SD")) {
    m_curve.degree = degree->value >= 2.0 && degree->value < 3.0 ? 2 : 3;
  }
  if (rare.spline != nullptr) {
    selectSpline(rare.spline->function);
  }
  if (rare.workOffsetToken != nullptr && !words.p) {
    m_to.faults.error(*rare.workOffsetToken, FaultCode::NumberMissing, "P");
  } else if (rare.workOffsetToken != nullptr) {
    m_reader.selectWorkOffset(rare.workOffset->key, *rare.workOffsetToken, *words.p);
  }
  if (rare.pole != nullptr) {
    setPole(words);
  }
  if (!rare.frame.empty()) {
    setFrame(rare.frame, words);
  }
  if (rare.offset != GEffect::None) {
    setOffset(words);
  }
  if (rare.savedState != MEffect::None) {
    changeSavedState(words);
  }
}

/// X, F, P and U of a dwell are times, S turns of the spindle; what else it names would be lost.
void Executor::executeDwell(const BlockWords& words) {
  if (m_language.dwellNeedsP && (!words.p || !(*words.p >= 0.0))) {
    m_to.faults.report(Severity::Error, 1, FaultCode::WordMissing, "G4 P");
    return;
  }
  if (m_language.dwellsBesideMove) {
    m_to.path.machineWord(MachineWord::Dwell, *words.p, words.line);
    return;
  }
  for (std::size_t axis = 1; axis < base::kAxisCount; ++axis) {
    if (words.axes.has(axis)) {
      m_to.faults.error(*words.axes.token[axis], FaultCode::UnknownWord);
    }
  }
  rejectArcWords(words);
  double seconds = kUnknown;
  if (words.spindle != nullptr && m_state.spindlePerMin > 0.0) {
    seconds = words.spindle->value * 60.0 / m_state.spindlePerMin;
  }
  if (words.feed != nullptr) {
    seconds = words.feed->value;
  } else if (words.p) {
    // Fanuc counts milliseconds where there is no point, RS-274/NGC seconds.
    const bool milliseconds = m_language.dwellInMilliseconds && !words.parameter->hasPoint;
    seconds = milliseconds ? *words.p / 1000.0 : *words.p;
  } else if (words.axes.has(0)) {
    seconds = words.axes.value[0];
  } else if (words.axes.has(kFirstFurther)) {
    seconds = words.axes.value[kFirstFurther];
  }
  m_to.path.machineWord(MachineWord::Dwell, seconds, words.line);
}

void Executor::rejectArcWords(const BlockWords& words) {
  if (words.hasRadius) {
    m_to.faults.error(*words.radiusToken, FaultCode::UnknownWord);
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.centre.has(axis)) {
      m_to.faults.error(*words.centre.token[axis], FaultCode::UnknownWord);
    }
  }
}

void Executor::takeFeed(BlockWords& words) {
  if (words.feed == nullptr || (words.taken && words.rare && words.rare->isMacro())) {
    return;
  }
  setFeed(words);
  if (!(words.feed->value > 0.0)) {
    words.feed = nullptr;  // reported; with G93, no motion takes it
  }
}

void Executor::setFeed(const BlockWords& words) {
  const double feed = words.feed->value;
  m_to.words.feed(feed);
  if (!(feed > 0.0)) {
    m_to.faults.error(*words.feed, FaultCode::FeedNotPositive, base::formatNumber(feed));
    return;
  }
  m_feedIsNamed = true;
  double mmPerMin = feed * m_state.feedFactor;
  if (m_state.feedMode == FeedMode::PerRevolution) {
    m_state.feedMmPerRev = feed * m_state.feedFactor;
    m_state.feedDegPerRev = feed;
    mmPerMin = m_state.feedMmPerRev * (m_state.constantSurfaceSpeed ? 0.0 : m_state.spindlePerMin);
  } else if (m_state.feedMode != FeedMode::PerMinute) {
    return;  // known block by block, or not at all
  }
  // A SINUMERIK refuses such a number; others move as fast as the machine can.
  constexpr double kReducedMmPerMinMax = 1e9;
  const bool reduces = !m_language.refusesLargeFeeds;
  const bool isStill = mmPerMin > 0.0 && mmPerMin < base::kFeedMmPerMinLeast;
  if (isStill || !(mmPerMin <= (reduces ? kReducedMmPerMinMax : kCoordinateMmMax))) {
    m_to.faults.error(*words.feed, FaultCode::ValueOutOfRange);
    return;
  }
  m_to.path.feed(mmPerMin);
  m_state.feedMmPerS = base::mmPerSFromMmPerMin(mmPerMin);
  m_state.feedDegPerS = feed / 60.0;
  m_state.feedIsDefault = false;
}

// --- saved state --------------------------------------------------------------------------------

SavedState Executor::save() {
  finishCurve();
  return {m_state, m_position.frame};
}

void Executor::restore(const SavedState& saved) {
  finishCurve();
  const ModalState now = m_state;
  const base::Vec3 before = m_position.programmedMm;
  m_state = saved.modal;
  // Where the tool is, and what belongs to it or to the machine, is no setting.
  m_state.incrementFrom = now.incrementFrom;
  m_state.workOffsetMm = now.workOffsetMm;
  m_state.toolLengthMm = now.toolLengthMm;
  m_state.tipWord = now.tipWord;
  m_state.cycle = now.cycle;
  m_state.retractsToR = now.retractsToR;
  m_state.isModulo = now.isModulo;
  m_state.poleMm = now.poleMm;
  m_state.polarRadiusMm = now.polarRadiusMm;
  m_state.polarDegrees = now.polarDegrees;
  m_state.roundingMm = now.roundingMm;
  if (m_language.savesFeedAndSpeed) {
    // M70 of RS-274: feed and speed, and no motion.
    m_state.motion = now.motion;
    m_state.motionBeforeUnsupported = now.motionBeforeUnsupported;
    m_state.motionAssumed = now.motionAssumed;
    m_state.motionNamed = now.motionNamed;
    m_state.motionIsOff = now.motionIsOff;
    m_state.baseFrame = now.baseFrame;
    m_state.rotaryOffset = now.rotaryOffset;
    restoreFeedAndSpeed(now);
    if (m_state.workOffset != now.workOffset) {
      m_frameOffset = m_state.workOffset;
      makeBaseFrame();
    }
  } else {
    m_state.spindlePerMin = now.spindlePerMin;
    m_state.surfaceMmPerMin = now.surfaceMmPerMin;
    m_state.surfaceSpeedPerMinMax = now.surfaceSpeedPerMinMax;
    m_state.feedOverride = now.feedOverride;
    // F is no G function; its number keeps its meaning only where that is still the same.
    if (now.feedMode == saved.modal.feedMode && now.feedFactor == saved.modal.feedFactor) {
      m_state.feedMmPerS = now.feedMmPerS;
      m_state.feedDegPerS = now.feedDegPerS;
      m_state.feedIsDefault = now.feedIsDefault;
      m_state.feedMmPerRev = now.feedMmPerRev;
      m_state.feedDegPerRev = now.feedDegPerRev;
    }
    m_position.setFrame(saved.frame);
    keepIncrements(before);
  }
  m_to.words.forget(std::nullopt);
  m_to.words.units(m_state.lengthFactor != 1.0);
}

/// LinuxCNC gives back what has changed as words of a block, F with one decimal and S with none:
/// its `rs274 -g` goes on with F0.3 where F0.28 was saved.
void Executor::restoreFeedAndSpeed(const ModalState& now) {
  const auto written = [](double number, int decimals) {
    return base::parseNumber(base::formatFixed(number, decimals)).value_or(number);
  };
  if (m_state.feedMmPerS != now.feedMmPerS && m_state.feedMode == FeedMode::PerMinute) {
    const double feed =
        written(base::mmPerMinFromMmPerS(m_state.feedMmPerS) / m_state.feedFactor, 1);
    m_state.feedMmPerS = base::mmPerSFromMmPerMin(feed * m_state.feedFactor);
    m_state.feedDegPerS = feed / 60.0;
  } else if (m_state.feedMmPerRev != now.feedMmPerRev &&
             m_state.feedMode == FeedMode::PerRevolution) {
    m_state.feedDegPerRev = written(m_state.feedMmPerRev / m_state.feedFactor, 1);
    m_state.feedMmPerRev = m_state.feedDegPerRev * m_state.feedFactor;
  }
  if (m_state.spindlePerMin != now.spindlePerMin) {
    m_state.spindlePerMin = written(m_state.spindlePerMin, 0);
  }
}

void Executor::enterCall(bool saves) {
  SavedCall& call = m_calls.emplace_back();
  if (saves) {
    call.saved = std::make_unique<const SavedState>(save());
    call.restoresOnReturn = true;
  }
}

void Executor::leaveCall() {
  if (m_calls.size() <= 1) {
    return;
  }
  const SavedCall call = std::move(m_calls.back());
  m_calls.pop_back();
  if (call.saved && call.restoresOnReturn) {
    restore(*call.saved);
  }
}

/// M70 to M73.
void Executor::changeSavedState(const BlockWords& words) {
  SavedCall& call = m_calls.back();
  switch (words.rare->savedState) {
    case MEffect::SaveState:
    case MEffect::SaveUntilReturn:
      call.saved = std::make_unique<const SavedState>(save());
      call.restoresOnReturn = words.rare->savedState == MEffect::SaveUntilReturn;
      break;
    case MEffect::ForgetState:
      call.saved.reset();
      break;
    default:
      if (!call.saved) {
        m_to.faults.error(*words.rare->savedStateToken, FaultCode::UnsupportedGCode, "M72");
      } else {
        restore(*call.saved);
      }
      break;
  }
}

}  // namespace rivulet::nc
