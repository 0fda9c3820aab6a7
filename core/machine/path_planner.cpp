// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/path_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Time below this is rounding, not motion.
constexpr double kTimeSMin = 1e-12;
/// A motion that has left no more than this of a piece, or this share of it, ends there.
constexpr double kRoundingMm = 1e-9;
constexpr double kRoundingShare = 1e-9;
/// Highest path override.
constexpr double kOverrideMax = 2.0;
/// The jerk of BRISK: the acceleration changes within nanoseconds.
constexpr double kBriskJerkMmPerS3 = 1e12;
/// Halvings where only the safe side matters.
constexpr int kRoughHalvings = 16;
/// Motions in a row within one cycle; far more than are needed.
constexpr int kMotionsPerCycleMax = 10000;

// Shares of an arc. Along and across are at right angles: 0.5² + 0.866² = 1.
constexpr double kAlongArc = 0.5;
constexpr double kAcrossArc = 0.866;

// Shares of the jerk with SOFT. On a line: half along the path. On an arc: the change of the
// centripetal acceleration has a part along the path, speed³·curvature², and one across it,
// 3·speed·acceleration·curvature; hypot(0.3 + 0.1, 0.3) = 0.5. At the ends of an arc the
// acceleration steps: 0.4 of the jerk times one cycle. Where the course steps: 0.05 for the speed
// and as much for the acceleration along the path.
constexpr double kJerkAlongLine = 0.5;
constexpr double kJerkAlongArc = 0.3;
constexpr double kJerkOfTurning = 0.1;
constexpr double kJerkAcrossArc = 0.3;
constexpr double kJerkOfCurvatureStep = 0.4;
constexpr double kJerkOfCourseStep = 0.05;

/// A change of course by less than this is rounding of coordinates: it counts as none.
constexpr double kTurnMin = 1e-7;
/// Greatest step of the course that is passed without rounding, rad; and the share of the axes'
/// acceleration that is kept for it.
constexpr double kCourseStepMax = 0.1;
constexpr double kCourseStepShare = 0.1;

/// Smallest of limit/share over the axes that take part.
template <class LimitOf, class ShareOf>
double weakestAxis(LimitOf limitOf, ShareOf shareOf) {
  double smallest = kInfinity;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double share = std::abs(shareOf(axis));
    if (share > 1e-12) {
      smallest = std::min(smallest, limitOf(axis) / share);
    }
  }
  return smallest;
}

/// The same over the rotary axes of a machine.
template <class ShareOf>
double weakestRotary(const MachineConfig& config, double RotaryLimits::*limit, double factor,
                     ShareOf shareOf) {
  double smallest = kInfinity;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const double share = std::abs(shareOf(axis));
    if (share > 1e-12 && config.rotaryAxes[axis]) {
      smallest = std::min(smallest, factor * (*config.rotaryAxes[axis]).*limit / share);
    }
  }
  return smallest;
}

}  // namespace

PathPlanner::PathPlanner(const MachineConfig& config, base::Vec3 startMm, base::RotaryDeg startDeg)
    : m_config(config),
      m_cycleS(base::toSeconds(config.interpolationCycle)),
      m_place{.exactMm = startMm, .exactDeg = startDeg},
      m_endMm(startMm),
      m_endDeg(startDeg) {
}

void PathPlanner::append(const PreparedMotion& motion) {
  append(roughMotion(motion, {m_endMm, m_endDeg}, m_config));
}

void PathPlanner::append(const RoughMotion& rough) {
  if (m_unplanned.may && !isStanding()) {
    if (m_unplanned.motions.empty()) {
      m_unplanned.undo = undoOfLast();
    }
    m_unplanned.motions.push_back(rough);
  }
  extend(rough, !m_unplanned.may);
}

void PathPlanner::settle() {
  if (plan()) {
    m_unplanned.motions.clear();
    return;
  }
  takeBack(m_unplanned.undo);
  planFrom(m_pieces.size() - 1, true);
  m_appended -= m_unplanned.motions.size();
  for (const RoughMotion& rough : std::exchange(m_unplanned.motions, {})) {
    extend(rough, true);
  }
}

PathPlanner::Undo PathPlanner::undoOfLast() const {
  return {m_pieces.back(), m_blocks.back(), m_pieces.size(), m_blocks.size()};
}

void PathPlanner::takeBack(const Undo& undo) {
  m_blocks.resize(undo.blocks);
  m_blocks.back() = undo.block;
  m_pieces.resize(undo.pieces - 1);
  m_pieces.push_back(undo.piece);
}

void PathPlanner::extend(const RoughMotion& rough, bool plansAtOnce) {
  const PreparedMotion& motion = rough.motion;
  m_isPlaced = m_isPlaced && m_pieces.size() > 1;  // the first one may change
  ++m_appended;
  Block block;
  block.line = motion.line;
  block.toMm = motion.targetMm;
  block.end = motion.end;
  block.rounding = motion.rounding;
  block.roundingMm = motion.roundingMm;
  block.dynamics = motion.dynamics;
  block.isStraight = !motion.arc;
  block.toDeg = motion.targetDeg;
  block.zeroMm = motion.zeroMm;
  block.turnDeg = rough.turnDeg;
  m_endZeroMm = motion.zeroMm;
  m_endMm = motion.targetMm;
  m_endDeg = motion.targetDeg;
  if (!rough.moves) {
    m_blocks.push_back(block);
    return;
  }
  block.lengthMm = rough.path.lengthMm();
  block.wayMm = rough.wayMm;
  Piece piece = makePiece(rough.path, rough.feedMmPerS, motion.dynamics, rough.degPerMm);
  piece.startDeg = rough.fromDeg;
  piece.inDegrees = rough.inDegrees;
  piece.endsBlock = true;
  boundToCycle(piece);

  const bool mayRunOn = !m_blocks.empty() && m_blocks.back().pieces > 0 &&
                        m_blocks.back().end == BlockEnd::Rounded &&
                        m_blocks.back().dynamics == motion.dynamics && !m_aborting;
  const std::size_t last = m_pieces.size() - 1;
  if (mayRunOn) {
    const Undo undo = undoOfLast();
    Block openBlock = block;
    Piece openPiece = piece;
    if (connect(openBlock, openPiece)) {
      push(openBlock, openPiece);
      m_blocks.push_back(openBlock);
      if (planFrom(last, plansAtOnce)) {
        return;
      }
    }
    takeBack(undo);
  }
  push(block, piece);
  m_blocks.push_back(block);
  planFrom(mayRunOn ? last : m_pieces.size() - 1, plansAtOnce);
}

bool PathPlanner::planFrom(std::size_t index, bool atOnce) {
  m_unplanned.from = std::min(m_unplanned.from, index);
  return !atOnce || plan();
}

bool PathPlanner::plan() {
  if (m_unplanned.from == Unplanned::kNone) {
    return true;
  }
  const std::size_t index = std::exchange(m_unplanned.from, Unplanned::kNone);
  std::deque<SpeedSection> tail;
  for (std::size_t i = index; i < m_pieces.size(); ++i) {
    const Piece& piece = m_pieces[i];
    tail.push_back({piece.path.lengthMm(), piece.feedMmPerS, piece.speedMmPerSMax, piece.limits,
                    piece.junctionMmPerSMax, piece.junctionMmPerS2Max});
  }
  const std::size_t changed = m_ceiling.replaceTail(index, tail);
  if (isStanding()) {
    m_profile.reset();
    return true;
  }
  if (m_profile && changed > m_reach) {
    return true;
  }
  if (!m_ceiling.isSafe(0, m_pathMm, m_state)) {
    return false;
  }
  m_profile.reset();
  return true;
}

void PathPlanner::append(const PreparedDwell& dwell) {
  settle();
  Block block;
  block.line = dwell.line;
  block.toMm = m_endMm;
  block.toDeg = m_endDeg;
  block.dwellS = base::toSeconds(dwell.duration);
  block.isDwell = true;
  block.zeroMm = m_endZeroMm;
  ++m_appended;
  m_blocks.push_back(block);
}

void PathPlanner::append(PreparedActions actions) {
  m_endZeroMm = actions.zeroMm;
  append(PreparedDwell{actions.line, {}});
  m_blocks.back().actions = std::make_shared<const PreparedActions>(std::move(actions));
}

/// @return s, how long it waits if it moves nothing
double PathPlanner::beginBlock(Block& block, base::Instant at) {
  block.startedAt = at;
  m_zeroMm = block.zeroMm;
  if (m_auxiliaries != nullptr && block.actions) {
    return m_auxiliaries->begin(*block.actions, at);
  }
  if (m_auxiliaries != nullptr && block.isDwell) {
    m_auxiliaries->dwell(block.line, at, block.dwellS);
  }
  return block.dwellS;
}

PathPlanner::Piece PathPlanner::makePiece(const PathPiece& path, double feedMmPerS,
                                          Dynamics dynamics,
                                          const base::RotaryDeg& degPerMm) const {
  const auto weakest = [&](auto limit) {
    return weakestAxis([&](std::size_t axis) { return m_config.axes[axis].*limit; },
                       [&](std::size_t axis) { return path.axisShare(axis); });
  };
  const auto weakestTurn = [&](double RotaryLimits::*limit) {
    return weakestRotary(m_config, limit, 1.0, [&](std::size_t axis) { return degPerMm[axis]; });
  };
  const double turning = weakestTurn(&RotaryLimits::accelerationDegPerS2Max);
  const double turningJerk = kJerkAlongLine * weakestTurn(&RotaryLimits::jerkDegPerS3Max);
  const double acceleration = weakest(&AxisLimits::accelerationMmPerS2Max);
  const double jerk = weakest(&AxisLimits::jerkMmPerS3Max);
  const bool soft = dynamics == Dynamics::Soft;
  Piece piece;
  piece.path = path;
  piece.isSoft = soft;
  piece.feedMmPerS = feedMmPerS;
  piece.degPerMm = degPerMm;
  piece.speedMmPerSMax =
      std::min(weakest(&AxisLimits::speedMmPerSMax), weakestTurn(&RotaryLimits::speedDegPerSMax));
  if (path.isStraight()) {
    piece.limits = {std::min(acceleration, turning),
                    soft ? std::min(kJerkAlongLine * jerk, turningJerk) : kBriskJerkMmPerS3};
    return piece;
  }
  const double curvature = path.curvaturePerMm();
  piece.speedMmPerSMax =
      std::min(piece.speedMmPerSMax, std::sqrt(kAcrossArc * acceleration / curvature));
  piece.limits = {std::min(kAlongArc * acceleration, turning), kBriskJerkMmPerS3};
  if (soft) {
    const double fastest = std::cbrt(kJerkOfTurning * jerk / (curvature * curvature));
    piece.speedMmPerSMax = std::min(piece.speedMmPerSMax, fastest);
    piece.limits = {std::min({kAlongArc * acceleration,
                              kJerkAcrossArc * jerk / (3.0 * fastest * curvature), turning}),
                    std::min(kJerkAlongArc * jerk, turningJerk)};
    piece.boundToCycle = true;
  }
  return piece;
}

void PathPlanner::boundToCycle(Piece& piece) const {
  if (piece.boundToCycle) {
    piece.speedMmPerSMax = std::min(piece.speedMmPerSMax, piece.path.lengthMm() / m_cycleS);
  }
}

bool PathPlanner::isLastUnderWay() const {
  return m_pieces.size() == 1 && !(isStanding() && m_pathMm == 0.0);
}

bool PathPlanner::connect(Block& next, Piece& piece) {
  const Piece& last = m_pieces.back();
  if (last.inDegrees != piece.inDegrees) {
    return false;
  }
  const base::Vec3 change = piece.path.tangent(0.0) - last.path.tangent(last.path.lengthMm());
  const double turn = base::norm(change);
  const double rateTurn = base::turnDeg(last.degPerMm, piece.degPerMm);
  const bool turns = m_blocks.back().turnDeg > kPathTurnDegMin || next.turnDeg > kPathTurnDegMin;
  if (!turns && turn > kTurnMin && last.path.isStraight() && piece.path.isStraight() &&
      roundCornerInto(next, piece)) {
    return true;
  }
  return stepInto(piece, turn, rateTurn);
}

double PathPlanner::cutMmMax(double blockMm, const Piece& piece) const {
  // With SOFT what is left between two arcs must not be passed in less than a cycle.
  return piece.isSoft ? 0.25 * blockMm : 0.5 * blockMm;
}

bool PathPlanner::roundCornerInto(Block& next, Piece& piece) {
  Block& block = m_blocks.back();
  Piece& last = m_pieces.back();
  const bool underWay = isLastUnderWay();
  const double leftMm = last.path.lengthMm() - (m_pieces.size() == 1 ? m_pathMm : 0.0);
  const double spareMm = std::min(cutMmMax(block.lengthMm, last), underWay ? 0.5 * leftMm : leftMm);
  const double cutMm = std::min(spareMm, cutMmMax(next.lengthMm, piece));
  const std::optional<CornerArc> corner =
      roundCorner(block.toMm, last.path.tangent(0.0), piece.path.tangent(0.0), cutMm,
                  block.rounding, block.roundingMm);
  if (!corner) {
    return false;
  }
  const bool soft = block.dynamics == Dynamics::Soft;
  Piece first = makePiece(corner->firstHalf, last.feedMmPerS, block.dynamics, {});
  Piece second = makePiece(corner->secondHalf, piece.feedMmPerS, block.dynamics, {});
  first.startDeg = block.toDeg;  // neither block turns a rotary axis
  second.startDeg = block.toDeg;
  // The two halves are one arc: there is no step between them.
  const double wholeMm = first.path.lengthMm() + second.path.lengthMm();
  if (soft) {
    for (Piece* half : {&first, &second}) {
      half->boundToCycle = false;
      half->speedMmPerSMax = std::min(half->speedMmPerSMax, wholeMm / m_cycleS);
    }
  }
  first.endsBlock = true;
  second.junctionMmPerSMax = kInfinity;

  block.pathLengthMm -= last.path.lengthMm();
  last.path.trimEnd(corner->cutMm);
  piece.path.trimStart(corner->cutMm);
  last.boundToCycle = last.boundToCycle || soft;
  piece.boundToCycle = piece.boundToCycle || soft;
  piece.junctionMmPerSMax = curvatureStepSpeed(second, piece);
  boundToCycle(piece);
  if (last.path.lengthMm() <= kPathLengthMmMin) {
    // Both corners of the block have used all of it: arc follows arc.
    const double junction = last.junctionMmPerSMax;
    m_pieces.pop_back();
    --block.pieces;
    first.junctionMmPerSMax =
        m_pieces.empty() ? junction : curvatureStepSpeed(m_pieces.back(), first);
  } else {
    last.endsBlock = false;
    block.pathLengthMm += last.path.lengthMm();
    boundToCycle(last);
    first.junctionMmPerSMax = curvatureStepSpeed(last, first);
  }
  push(block, first);
  push(next, second);
  return true;
}

bool PathPlanner::stepInto(Piece& next, double turn, double rateTurn) {
  Piece& last = m_pieces.back();
  next.junctionMmPerSMax = curvatureStepSpeed(last, next);
  if (turn <= kTurnMin && rateTurn <= kTurnMin) {
    return true;
  }
  // In a path of degrees the rates are its course.
  if ((next.inDegrees ? rateTurn : turn) > kCourseStepMax || isLastUnderWay()) {
    return false;
  }
  const base::Vec3 change = next.path.tangent(0.0) - last.path.tangent(last.path.lengthMm());
  const bool soft = next.isSoft;
  const double speed = weakestAxis(
      [&](std::size_t axis) {
        const AxisLimits& limits = m_config.axes[axis];
        const double brisk = kCourseStepShare * limits.accelerationMmPerS2Max * m_cycleS;
        return soft ? std::min(brisk,
                               kJerkOfCourseStep * limits.jerkMmPerS3Max * m_cycleS * m_cycleS)
                    : brisk;
      },
      [&](std::size_t axis) { return change[axis]; });
  const auto rateStep = [&](std::size_t axis) { return next.degPerMm[axis] - last.degPerMm[axis]; };
  double turning = weakestRotary(m_config, &RotaryLimits::accelerationDegPerS2Max,
                                 kCourseStepShare * m_cycleS, rateStep);
  if (soft) {
    turning = std::min(turning, weakestRotary(m_config, &RotaryLimits::jerkDegPerS3Max,
                                              kJerkOfCourseStep * m_cycleS * m_cycleS, rateStep));
  }
  next.junctionMmPerSMax = std::min({next.junctionMmPerSMax, speed, turning});
  if (soft) {
    // The acceleration along the path turns with the course.
    next.junctionMmPerS2Max =
        std::min(weakestAxis(
                     [&](std::size_t axis) {
                       return kJerkOfCourseStep * m_config.axes[axis].jerkMmPerS3Max * m_cycleS;
                     },
                     [&](std::size_t axis) { return change[axis]; }),
                 weakestRotary(m_config, &RotaryLimits::jerkDegPerS3Max,
                               kJerkOfCourseStep * m_cycleS, rateStep));
  }
  for (Piece* piece : {&last, &next}) {
    if (!piece->holdsReserve) {
      piece->holdsReserve = true;
      piece->limits.accelerationMmPerS2 *= 1.0 - kCourseStepShare;
      if (!piece->path.isStraight()) {
        piece->speedMmPerSMax *= std::sqrt(1.0 - kCourseStepShare);
      }
    }
    piece->boundToCycle = true;
    boundToCycle(*piece);
  }
  return true;
}

double PathPlanner::curvatureStepSpeed(const Piece& before, const Piece& after) const {
  if (!after.isSoft) {
    return kInfinity;
  }
  const base::Vec3 step = after.path.curvature(0.0) - before.path.curvature(before.path.lengthMm());
  return std::sqrt(weakestAxis(
      [&](std::size_t axis) {
        return kJerkOfCurvatureStep * m_config.axes[axis].jerkMmPerS3Max * m_cycleS;
      },
      [&](std::size_t axis) { return step[axis]; }));
}

void PathPlanner::push(Block& block, Piece piece) {
  ++block.pieces;
  block.pathLengthMm += piece.path.lengthMm();
  m_pieces.push_back(std::move(piece));
}

void PathPlanner::abort() {
  settle();
  m_aborting = true;
}

void PathPlanner::setOverride(double factor) {
  m_override = std::clamp(factor, 0.0, kOverrideMax);
}

double PathPlanner::capMmPerS() const {
  const Piece& front = m_pieces.front();
  return std::min(front.feedMmPerS * m_override, front.speedMmPerSMax);
}

void PathPlanner::takeOverride() {
  if (m_pieces.empty() || m_override == 0.0 || m_override == m_ceiling.override()) {
    return;
  }
  const SpeedCeiling before = m_ceiling;
  m_ceiling.setOverride(m_override);
  if (m_ceiling.isSafe(0, m_pathMm, m_state)) {
    m_profile.reset();
    return;
  }
  const Piece& front = m_pieces.front();
  SpeedProfile slower = SpeedProfile::change(m_state, capMmPerS(), front.limits);
  const double thereMm = m_pathMm + slower.lengthMm();
  if (fadedSpeedMmPerS(m_state, front.limits.jerkMmPerS3) > capMmPerS() &&
      thereMm < front.path.lengthMm() && m_ceiling.isSafe(0, thereMm, slower.end())) {
    follow(std::move(slower));
    m_isCommitted = true;
    return;
  }
  m_ceiling = before;
}

void PathPlanner::follow(SpeedProfile profile) {
  m_profile = std::move(profile);
  m_profileS = 0.0;
  m_offsetMm = m_pathMm;
  m_standsAtEnd = false;
  m_isCommitted = false;
}

void PathPlanner::makeProfile(double seconds) {
  const bool stops = m_aborting || m_override == 0.0;
  const Piece& front = m_pieces.front();
  m_reach = 0;
  if (stops) {
    SpeedProfile brake = SpeedProfile::change(m_state, 0.0, front.limits);
    if (m_pathMm + brake.lengthMm() <= front.path.lengthMm()) {
      follow(std::move(brake));
      m_standsAtEnd = true;
      return;
    }
  }
  if (stops || m_override < m_ceiling.override()) {
    if (std::optional<SpeedProfile> brake = brakeFor(seconds, stops ? 0.0 : capMmPerS())) {
      follow(std::move(*brake));
      return;
    }
  }
  follow(m_ceiling.profile(m_pathMm, m_state, &m_reach));
}

std::optional<SpeedProfile> PathPlanner::brakeFor(double seconds, double speedMmPerS) const {
  const Piece& front = m_pieces.front();
  const double j = front.limits.jerkMmPerS3;
  const double leftMm = front.path.lengthMm() - m_pathMm;
  const double from = m_state.accelerationMmPerS2;
  const auto towards = [&](double acceleration) {
    SpeedProfile profile(m_state);
    const double changeS = std::min(seconds, std::abs(acceleration - from) / j);
    profile.add(changeS, acceleration < from ? -j : j);
    profile.add(seconds - changeS, 0.0);
    if (profile.lengthMm() > leftMm) {
      profile.cut(profile.secondsAt(leftMm));
      profile.setEnd(leftMm, profile.end());
    }
    return profile;
  };
  const auto isLowEnough = [&](const SpeedProfile& profile) {
    return fadedSpeedMmPerS(profile.end(), j) >= speedMmPerS;
  };
  double acceleration = -front.limits.accelerationMmPerS2;
  if (!isLowEnough(towards(acceleration))) {
    double tooLow = acceleration;
    acceleration = 0.0;
    for (int i = 0; i < kRoughHalvings; ++i) {
      const double middle = 0.5 * (tooLow + acceleration);
      (isLowEnough(towards(middle)) ? acceleration : tooLow) = middle;
    }
  }
  SpeedProfile profile = towards(acceleration);
  const bool passes = profile.lengthMm() >= leftMm;
  const bool isSafe = passes ? m_ceiling.isSafeAtJoint(profile.end())
                             : m_ceiling.isSafe(0, m_pathMm + profile.lengthMm(), profile.end());
  if (!isLowEnough(profile) || !isSafe) {
    return std::nullopt;
  }
  return profile;
}

double PathPlanner::advance(double seconds) {
  if (!m_profile) {
    makeProfile(seconds);
  }
  const double lengthMm = m_pieces.front().path.lengthMm();
  const double endS = m_profile->durationS();
  const double thereMm = m_offsetMm + m_profile->lengthMmAt(m_profileS + seconds);
  if (m_profileS + seconds < endS && thereMm < lengthMm) {
    m_profileS += seconds;
    m_state = m_profile->stateAt(m_profileS);
    m_pathMm = thereMm;
    return 0.0;
  }
  const double left = std::max(0.0, seconds - std::max(0.0, endS - m_profileS));
  m_state = m_profile->end();
  m_pathMm = m_offsetMm + m_profile->lengthMm();
  if (m_standsAtEnd) {
    m_profileS = endS;
    m_pathMm = std::min(lengthMm, m_pathMm);
    return 0.0;
  }
  if (m_pathMm > lengthMm - std::min(kRoundingMm, kRoundingShare * lengthMm)) {
    m_pathMm = lengthMm;
    m_state = m_ceiling.passJoint(m_state);
  }
  m_profile.reset();
  m_isCommitted = false;
  return left;
}

void PathPlanner::moveTo(double mm) {
  if (!m_isPlaced) {
    const Piece& piece = m_pieces.front();
    m_place.path = piece.path;
    m_place.startDeg = piece.startDeg;
    m_place.degPerMm = piece.degPerMm;
    m_isPlaced = true;
  }
  m_place.mm = mm;
  m_place.exactMm.reset();
  m_place.exactDeg.reset();
}

void PathPlanner::finishPiece() {
  const double lengthMm = m_pieces.front().path.lengthMm();
  moveTo(lengthMm);
  m_blockMm += lengthMm;
  m_pieces.pop_front();
  m_isPlaced = false;
  m_ceiling.popFront();
  m_pathMm = 0.0;
  m_profile.reset();
}

void PathPlanner::finishBlock(base::Instant at, std::vector<trace::ExecutedBlock>& executed) {
  const Block& block = m_blocks.front();
  if (m_blocks.size() == 1) {
    m_place.exactMm = block.toMm;
  }
  ++m_finished;
  if (!block.isDwell) {
    m_place.exactDeg = block.toDeg;  // the end of a turn is never rounded
    executed.push_back({block.startedAt.value_or(at), at, block.line, block.toMm - block.zeroMm,
                        block.wayMm, block.toDeg, block.turnDeg});
  }
  m_blocks.pop_front();
  m_blockMm = 0.0;
}

void PathPlanner::step(base::Instant end, std::vector<trace::ExecutedBlock>& executed) {
  double left = m_cycleS;
  settle();
  takeOverride();
  if (!m_isCommitted && (m_standsAtEnd || m_aborting || m_override < m_ceiling.override())) {
    m_profile.reset();  // what slows down is decided anew in every cycle
  }
  int motions = 0;
  const base::Instant begin = end - m_config.interpolationCycle;
  const auto instantNow = [&] { return begin + base::fromSeconds(m_cycleS - left); };
  while (!m_blocks.empty()) {
    Block& block = m_blocks.front();
    if (!block.startedAt) {
      m_dwellLeftS = beginBlock(block, instantNow());
    }
    m_line = block.line;
    if (block.pieces == 0) {
      const double waited = std::min(left, m_dwellLeftS);
      m_dwellLeftS -= waited;
      left -= waited;
      if (m_aborting) {
        break;
      }
      if (m_dwellLeftS > kTimeSMin) {
        return;
      }
      finishBlock(instantNow(), executed);
      continue;
    }
    RIVULET_ASSERT(++motions < kMotionsPerCycleMax);
    left = advance(left);
    if (m_pathMm >= m_pieces.front().path.lengthMm()) {
      const bool endsBlock = m_pieces.front().endsBlock;
      finishPiece();
      if (endsBlock) {
        finishBlock(instantNow(), executed);
      }
    } else {
      moveTo(m_pathMm);
      if (m_aborting && m_standsAtEnd && isStanding()) {
        break;
      }
    }
    if (left <= kTimeSMin && !m_blocks.empty()) {
      return;
    }
  }
  // Nothing left to move: the path stands, here or where it was aborted.
  m_finished = m_appended;
  m_blocks.clear();
  m_pieces.clear();
  m_isPlaced = false;
  m_ceiling.clear();
  m_unplanned.from = Unplanned::kNone;
  m_profile.reset();
  m_isCommitted = false;
  m_standsAtEnd = false;
  m_endMm = commandMm();
  m_endDeg = commandDeg();
  m_pathMm = 0.0;
  m_blockMm = 0.0;
  m_state = {};
  m_aborting = false;
}

double PathPlanner::feedCommandMmPerS() const {
  return m_pieces.empty() ? 0.0 : capMmPerS();
}

base::Vec3 PathPlanner::distanceToGoMm() const {
  return m_blocks.empty() ? base::Vec3{} : m_blocks.front().toMm - commandMm();
}

base::RotaryDeg PathPlanner::distanceToGoDeg() const {
  base::RotaryDeg toGo{};
  const base::RotaryDeg command = commandDeg();
  for (std::size_t axis = 0; !m_blocks.empty() && axis < base::kRotaryAxisCount; ++axis) {
    toGo[axis] = m_blocks.front().toDeg[axis] - command[axis];
  }
  return toGo;
}

double PathPlanner::pathToGoMm() const {
  return m_blocks.empty() ? 0.0
                          : std::max(0.0, m_blocks.front().pathLengthMm - m_blockMm - m_pathMm);
}

double PathPlanner::pathShare() const {
  if (m_blocks.empty() || !(m_blocks.front().pathLengthMm > 0.0)) {
    return 0.0;
  }
  return std::min(1.0, (m_blockMm + m_pathMm) / m_blocks.front().pathLengthMm);
}

}  // namespace rivulet::machine
