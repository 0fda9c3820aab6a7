// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/path_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contract.h"

namespace rivulet::machine {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A path shorter than this is no motion; far below the resolution of any control.
constexpr double kLengthMmMin = 1e-9;
/// A turn smaller than this is none.
constexpr double kTurnDegMin = 1e-9;
/// Time below this is rounding, not motion.
constexpr double kTimeSMin = 1e-12;
/// Room for rounding where a braking length is compared with what is left.
constexpr double kRoundingMm = 1e-9;
/// Speeds that differ by less are the same.
constexpr double kSameMmPerS = 1e-9;
/// Highest path override.
constexpr double kOverrideMax = 2.0;
/// Exit speeds tried where the obvious ones cannot be reached.
constexpr int kExitsTried = 32;

// Shares of an arc. Along and across are at right angles: 0.5² + 0.866² = 1.
constexpr double kAlongArc = 0.5;
constexpr double kAcrossArc = 0.866;

// Shares of the jerk with SOFT. On a line: half along the path. On an arc: the change of the
// centripetal acceleration has a part along the path, speed³·curvature², and one across it,
// 3·speed·acceleration·curvature; hypot(0.3 + 0.1, 0.3) = 0.5. At the ends of an arc the
// acceleration steps: 0.4 of the jerk times one cycle. Where the course steps: 0.05.
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

SpeedLimits weaker(const SpeedLimits& a, const SpeedLimits& b) {
  return {std::min(a.accelerationMmPerS2, b.accelerationMmPerS2),
          std::min(a.jerkMmPerS3, b.jerkMmPerS3)};
}

}  // namespace

PathPlanner::PathPlanner(const MachineConfig& config, base::Vec3 startMm, base::RotaryDeg startDeg)
    : m_config(config),
      m_cycleS(base::toSeconds(config.interpolationCycle)),
      m_commandMm(startMm),
      m_endMm(startMm),
      m_commandDeg(startDeg),
      m_endDeg(startDeg) {
}

void PathPlanner::append(const PreparedMotion& motion) {
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
  const base::Vec3 fromMm = m_endMm;
  const base::RotaryDeg fromDeg = m_endDeg;
  m_endMm = motion.targetMm;
  m_endDeg = motion.targetDeg;
  block.turnDeg = base::turnDeg(fromDeg, motion.targetDeg);
  const bool turns = block.turnDeg > kTurnDegMin;
  const double straightMm = base::distance(fromMm, motion.targetMm);
  if (!motion.arc && straightMm <= kLengthMmMin && !turns) {
    m_blocks.push_back(block);
    return;
  }
  const bool inDegrees = !motion.arc && turns && straightMm * base::kDegPerMmMax < block.turnDeg;
  const PathPiece path = motion.arc  ? PathPiece::arc(fromMm, motion.targetMm, *motion.arc)
                         : inDegrees ? PathPiece::turning(fromMm, motion.targetMm, block.turnDeg)
                                     : PathPiece::line(fromMm, motion.targetMm);
  block.lengthMm = path.lengthMm();
  block.wayMm = inDegrees ? straightMm : path.lengthMm();
  base::RotaryDeg degPerMm{};
  for (std::size_t axis = 0; turns && axis < base::kRotaryAxisCount; ++axis) {
    degPerMm[axis] = (motion.targetDeg[axis] - fromDeg[axis]) / path.lengthMm();
  }
  double feedMmPerS = inDegrees ? motion.feedDegPerS : motion.feedMmPerS;
  if (m_config.blocksPerCycleMax > 0.0) {
    // The main run takes a new block once a cycle at most: short blocks are passed slower.
    feedMmPerS = std::min(feedMmPerS, m_config.blocksPerCycleMax * block.lengthMm / m_cycleS);
  }
  Piece piece = makePiece(path, feedMmPerS, motion.dynamics, degPerMm);
  piece.startDeg = fromDeg;
  piece.inDegrees = inDegrees;
  piece.endsBlock = true;
  boundToCycle(piece);

  const bool mayRunOn = !m_blocks.empty() && m_blocks.back().pieces > 0 &&
                        m_blocks.back().end == BlockEnd::Rounded &&
                        m_blocks.back().dynamics == motion.dynamics && !m_aborting;
  if (mayRunOn) {
    const Undo undo{m_pieces.back(), m_blocks.back(), m_pieces.size() - 1};
    Block openBlock = block;
    Piece openPiece = piece;
    if (connect(openBlock, openPiece)) {
      push(openBlock, openPiece);
      m_blocks.push_back(openBlock);
      planBackwards(false);
      if (isStanding() || reachableExit(stretch())) {
        return;
      }
      m_blocks.pop_back();
    }
    m_pieces.resize(undo.pieces);
    m_pieces.push_back(undo.piece);
    m_blocks.back() = undo.block;
  }
  push(block, piece);
  m_blocks.push_back(block);
  planBackwards(mayRunOn);
}

void PathPlanner::append(const PreparedDwell& dwell) {
  Block block;
  block.line = dwell.line;
  block.toMm = m_endMm;
  block.toDeg = m_endDeg;
  block.dwellS = base::toSeconds(dwell.duration);
  block.isDwell = true;
  ++m_appended;
  m_blocks.push_back(block);
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
  piece.feedMmPerS = feedMmPerS;
  piece.degPerMm = degPerMm;
  piece.speedMmPerSMax =
      std::min(weakest(&AxisLimits::speedMmPerSMax), weakestTurn(&RotaryLimits::speedDegPerSMax));
  if (path.isStraight()) {
    piece.limits = {std::min(acceleration, turning),
                    soft ? std::min(kJerkAlongLine * jerk, turningJerk) : kInfinity};
    return piece;
  }
  const double curvature = path.curvaturePerMm();
  piece.speedMmPerSMax =
      std::min(piece.speedMmPerSMax, std::sqrt(kAcrossArc * acceleration / curvature));
  piece.limits = {std::min(kAlongArc * acceleration, turning), kInfinity};
  if (soft) {
    piece.speedMmPerSMax =
        std::min(piece.speedMmPerSMax, std::cbrt(kJerkOfTurning * jerk / (curvature * curvature)));
    const double fastest = std::min(piece.speedMmPerSMax, kOverrideMax * feedMmPerS);
    piece.limits = {std::min({kAlongArc * acceleration,
                              kJerkAcrossArc * jerk / (3.0 * fastest * curvature), turning}),
                    std::min(kJerkAlongArc * jerk, turningJerk)};
    piece.boundToCycle = true;
  }
  return piece;
}

double PathPlanner::cap(const Piece& piece) const {
  return std::min(piece.feedMmPerS * m_override, piece.speedMmPerSMax);
}

void PathPlanner::boundToCycle(Piece& piece) const {
  if (piece.boundToCycle) {
    piece.speedMmPerSMax = std::min(piece.speedMmPerSMax, piece.path.lengthMm() / m_cycleS);
  }
}

bool PathPlanner::isLastUnderWay() const {
  if (isStanding() && m_pathMm == 0.0) {
    return false;
  }
  for (std::size_t i = m_pieces.size(); i-- > 1;) {
    if (!m_pieces[i].joinsPrevious) {
      return false;
    }
  }
  return true;
}

bool PathPlanner::connect(Block& next, Piece& piece) {
  const Piece& last = m_pieces.back();
  if (last.inDegrees != piece.inDegrees) {
    return false;
  }
  const base::Vec3 change = piece.path.tangent(0.0) - last.path.tangent(last.path.lengthMm());
  const double turn = base::norm(change);
  const double rateTurn = base::turnDeg(last.degPerMm, piece.degPerMm);
  const bool turns = m_blocks.back().turnDeg > kTurnDegMin || next.turnDeg > kTurnDegMin;
  if (!turns && turn > kTurnMin && last.path.isStraight() && piece.path.isStraight() &&
      roundCornerInto(next, piece)) {
    return true;
  }
  return stepInto(piece, turn, rateTurn);
}

double PathPlanner::cutMmMax(double blockMm, const Piece& piece) const {
  const double cycleMm = piece.feedMmPerS * m_cycleS;
  if (std::isinf(piece.limits.jerkMmPerS3)) {
    return 0.5 * blockMm;
  }
  // What is left between two arcs must not be passed in less than a cycle: it must not be tiny.
  return blockMm > 2.0 * cycleMm ? 0.5 * (blockMm - cycleMm) : 0.25 * blockMm;
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
  if (last.path.lengthMm() <= kLengthMmMin) {
    // Both corners of the block have used all of it: arc follows arc.
    const double junction = last.junctionMmPerSMax;
    m_pieces.pop_back();
    --block.pieces;
    first.junctionMmPerSMax =
        m_pieces.empty() ? junction : curvatureStepSpeed(m_pieces.back(), first);
  } else {
    last.endsBlock = false;
    block.pathLengthMm += last.path.lengthMm();
    if (!underWay) {
      boundToCycle(last);
    }
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
  const bool soft = !std::isinf(next.limits.jerkMmPerS3);
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
  if (std::isinf(after.limits.jerkMmPerS3)) {
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
  if (!m_pieces.empty() && !std::isinf(piece.limits.jerkMmPerS3)) {
    const Piece& last = m_pieces.back();
    // Compared at full override, so that it does not depend on the moment.
    const double speed = std::min(piece.feedMmPerS, piece.speedMmPerSMax);
    const double before = std::min(last.feedMmPerS, last.speedMmPerSMax);
    const bool even = std::abs(before - speed) <= kSameMmPerS && piece.junctionMmPerSMax >= speed;
    piece.joinsPrevious = even;
    if (even && isLastUnderWay()) {
      // What is under way must not get weaker limits than those it was planned with.
      const Stretch moving = stretch();
      piece.joinsPrevious = weaker(moving.limits, piece.limits) == moving.limits &&
                            m_state.speedMmPerS <= moving.capMmPerS &&
                            m_state.accelerationMmPerS2 <= 0.0;
    }
  }
  m_pieces.push_back(std::move(piece));
}

void PathPlanner::planBackwards(bool everything) {
  double exit = 0.0;
  double bearable = 0.0;
  std::size_t end = m_pieces.size();  // behind the group that is planned as one
  while (end > 0) {
    std::size_t begin = end - 1;
    double lengthMm = m_pieces[begin].path.lengthMm();
    SpeedLimits limits = m_pieces[begin].limits;
    while (begin > 0 && m_pieces[begin].joinsPrevious) {
      --begin;
      lengthMm += m_pieces[begin].path.lengthMm();
      limits = weaker(limits, m_pieces[begin].limits);
    }
    if (begin == 0) {
      return;  // it has been entered: its profile takes care of it
    }
    Piece& piece = m_pieces[begin];
    const Piece& before = m_pieces[begin - 1];
    exit = std::min({piece.junctionMmPerSMax, cap(piece), cap(before),
                     brakingSpeedMmPerS(exit, lengthMm, limits)});
    bearable = std::min({piece.junctionMmPerSMax, piece.speedMmPerSMax, before.speedMmPerSMax,
                         brakingSpeedMmPerS(bearable, lengthMm, limits)});
    const bool unchanged = exit == piece.entryMmPerSMax && bearable == piece.entryMmPerSBearable &&
                           end < m_pieces.size();
    piece.entryMmPerSMax = exit;
    piece.entryMmPerSBearable = bearable;
    if (unchanged && !everything) {
      return;
    }
    end = begin;
  }
}

PathPlanner::Stretch PathPlanner::stretch() const {
  const Piece& front = m_pieces.front();
  Stretch stretch;
  stretch.lengthMm = front.path.lengthMm() - m_pathMm;
  stretch.capMmPerS = cap(front);
  stretch.limits = front.limits;
  std::size_t next = 1;
  for (; next < m_pieces.size() && m_pieces[next].joinsPrevious; ++next) {
    const Piece& piece = m_pieces[next];
    stretch.lengthMm += piece.path.lengthMm();
    stretch.capMmPerS = std::min({stretch.capMmPerS, cap(piece), piece.junctionMmPerSMax});
    stretch.limits = weaker(stretch.limits, piece.limits);
  }
  if (next < m_pieces.size()) {
    stretch.exitMmPerS = m_pieces[next].entryMmPerSMax;
    stretch.exitMmPerSBearable = m_pieces[next].entryMmPerSBearable;
  }
  return stretch;
}

std::optional<double> PathPlanner::reachableExit(const Stretch& ahead) const {
  const double speed = m_state.speedMmPerS;
  if (std::isinf(ahead.limits.jerkMmPerS3)) {
    // The harder the braking, the lower the exit: the bearable one decides.
    const double lowest =
        std::sqrt(std::max(0.0, speed * speed - 2.0 * ahead.limits.accelerationMmPerS2 *
                                                    (ahead.lengthMm + kRoundingMm)));
    const double exit = std::max(ahead.exitMmPerS, lowest);
    return lowest <= ahead.exitMmPerSBearable ? std::optional<double>(exit) : std::nullopt;
  }
  const Piece& front = m_pieces.front();
  if (front.boundToCycle && front.path.lengthMm() < speed * m_cycleS) {
    return std::nullopt;
  }
  const double a = m_state.accelerationMmPerS2;
  const double faded = std::max(0.0, speed + 0.5 * a * std::abs(a) / ahead.limits.jerkMmPerS3);
  const auto isReachable = [&](double exit) {
    return exit <= ahead.exitMmPerSBearable &&
           SpeedProfile::reaches(m_state, exit, ahead.lengthMm, ahead.limits);
  };
  // An exit above the fading speed is reached by accelerating, or not: then a lower one will do.
  if (ahead.exitMmPerS >= faded && isReachable(faded)) {
    return ahead.exitMmPerS;
  }
  for (const double exit : {ahead.exitMmPerS, m_exitMmPerS, faded}) {
    if (isReachable(exit)) {
      return exit;
    }
  }
  for (int part = kExitsTried; part >= 0; --part) {
    const double exit = ahead.exitMmPerSBearable * part / kExitsTried;
    if (isReachable(exit)) {
      return exit;
    }
  }
  return std::nullopt;
}

void PathPlanner::abort() {
  m_aborting = true;
  m_profile.reset();
}

void PathPlanner::setOverride(double factor) {
  const double bounded = std::clamp(factor, 0.0, kOverrideMax);
  if (bounded == m_override) {
    return;
  }
  m_override = bounded;
  m_profile.reset();
  planBackwards(true);
}

void PathPlanner::makeProfile() {
  const Stretch ahead = stretch();
  const double exit = reachableExit(ahead).value_or(ahead.exitMmPerS);
  m_plannedFor = ahead;
  m_exitMmPerS = exit;
  m_profileS = 0.0;
  m_offsetMm = m_pathMm;
  m_standsAtEnd = false;
  if (m_aborting || ahead.capMmPerS <= 0.0) {
    SpeedProfile brake = SpeedProfile::toStand(m_state, ahead.limits);
    if (brake.lengthMm() <= ahead.lengthMm) {
      m_profile = std::move(brake);
      m_standsAtEnd = true;
      return;
    }
  }
  m_profile = SpeedProfile::along(m_state, std::max(ahead.capMmPerS, kSameMmPerS), exit,
                                  ahead.lengthMm, ahead.limits);
}

double PathPlanner::advance(double seconds) {
  if (m_profile && !m_standsAtEnd) {
    // Blocks that have come in the meantime may have changed what lies ahead.
    Stretch ahead = stretch();
    ahead.lengthMm += m_pathMm - m_offsetMm;
    if (ahead.capMmPerS != m_plannedFor.capMmPerS || ahead.exitMmPerS != m_plannedFor.exitMmPerS ||
        ahead.limits != m_plannedFor.limits ||
        std::abs(ahead.lengthMm - m_plannedFor.lengthMm) > kRoundingMm) {
      m_profile.reset();
    }
  }
  if (!m_profile) {
    makeProfile();
  }
  const double lengthMm = m_pieces.front().path.lengthMm();
  const bool isLast = m_pieces.size() == 1 || !m_pieces[1].joinsPrevious;
  double endS = kInfinity;
  if (isLast && !m_standsAtEnd) {
    endS = m_profile->durationS();
  } else if (lengthMm - m_offsetMm <= m_profile->lengthMm()) {
    endS = m_profile->secondsAt(lengthMm - m_offsetMm);
  }
  if (m_profileS + seconds >= endS) {
    const double left = seconds - std::max(0.0, endS - m_profileS);
    m_profileS = endS;
    m_state = m_profile->stateAt(endS);
    m_pathMm = lengthMm;
    return left;
  }
  m_profileS += seconds;
  m_state = m_profile->stateAt(m_profileS);
  m_pathMm = std::min(lengthMm, m_profile->lengthMmAt(m_profileS) + m_offsetMm);
  return 0.0;
}

base::RotaryDeg PathPlanner::turned(const Piece& piece, double mm) {
  base::RotaryDeg angles = piece.startDeg;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    angles[axis] += mm * piece.degPerMm[axis];
  }
  return angles;
}

void PathPlanner::finishPiece() {
  const double lengthMm = m_pieces.front().path.lengthMm();
  m_commandMm = m_pieces.front().path.at(lengthMm);
  m_commandDeg = turned(m_pieces.front(), lengthMm);
  m_blockMm += lengthMm;
  m_pieces.pop_front();
  m_pathMm = 0.0;
  m_offsetMm -= lengthMm;
  const bool goesOn = !m_pieces.empty() && m_pieces.front().joinsPrevious;
  if (!goesOn) {
    m_profile.reset();
  } else {
    m_pieces.front().joinsPrevious = false;
  }
}

void PathPlanner::finishBlock(base::Instant at, std::vector<trace::ExecutedBlock>& executed) {
  const Block& block = m_blocks.front();
  if (m_blocks.size() == 1) {
    m_commandMm = block.toMm;
  }
  ++m_finished;
  if (!block.isDwell) {
    m_commandDeg = block.toDeg;  // the end of a turn is never rounded
    executed.push_back({block.startedAt.value_or(at), at, block.line, block.toMm, block.wayMm,
                        block.toDeg, block.turnDeg});
  }
  m_blocks.pop_front();
  m_blockMm = 0.0;
}

void PathPlanner::step(base::Instant end, std::vector<trace::ExecutedBlock>& executed) {
  double left = m_cycleS;
  const base::Instant begin = end - m_config.interpolationCycle;
  const auto instantNow = [&] { return begin + base::fromSeconds(m_cycleS - left); };
  while (!m_blocks.empty()) {
    Block& block = m_blocks.front();
    if (!block.startedAt) {
      block.startedAt = instantNow();
      m_dwellLeftS = block.dwellS;
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
    left = advance(left);
    if (m_pathMm >= m_pieces.front().path.lengthMm()) {
      const bool endsBlock = m_pieces.front().endsBlock;
      finishPiece();
      if (endsBlock) {
        finishBlock(instantNow(), executed);
      }
    } else {
      m_commandMm = m_pieces.front().path.at(m_pathMm);
      m_commandDeg = turned(m_pieces.front(), m_pathMm);
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
  m_profile.reset();
  m_endMm = m_commandMm;
  m_endDeg = m_commandDeg;
  m_pathMm = 0.0;
  m_blockMm = 0.0;
  m_state = {};
  m_aborting = false;
}

double PathPlanner::feedCommandMmPerS() const {
  return m_pieces.empty() ? 0.0 : cap(m_pieces.front());
}

base::Vec3 PathPlanner::distanceToGoMm() const {
  return m_blocks.empty() ? base::Vec3{} : m_blocks.front().toMm - m_commandMm;
}

base::RotaryDeg PathPlanner::distanceToGoDeg() const {
  base::RotaryDeg toGo{};
  for (std::size_t axis = 0; !m_blocks.empty() && axis < base::kRotaryAxisCount; ++axis) {
    toGo[axis] = m_blocks.front().toDeg[axis] - m_commandDeg[axis];
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
