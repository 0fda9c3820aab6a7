// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The move of a block: where it goes, how fast, and which kind of path it takes.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "nc/exec/executor.h"
#include "nc/function_number.h"
#include "nc/unknown.h"

namespace rivulet::nc {

using base::Vec3;

void Executor::executeMotion(BlockWords& words) {
  const Motion motion = m_state.motion;
  const bool isPolar = words.rare && (words.named("AP") != nullptr || words.named("RP") != nullptr);
  const bool isTurn = words.rare && words.named("AR") != nullptr;
  const bool moves =
      words.moves() || isPolar || (isPlaneArc(motion) && (words.hasAnyCentre() || isTurn));
  if (words.machineToken != nullptr && words.moves() && !m_options.knowsMachineCoordinates) {
    leaveOutMachineMove(words);
    return;
  }
  if (m_state.cycle.key != 0 && moves) {
    runCannedCycle(words);
    return;
  }
  if (motion == Motion::Unsupported) {
    if (m_state.cycle.key != 0 && (words.hasRadius || words.parameter != nullptr)) {
      m_to.faults.error(words.hasRadius ? *words.radiusToken : *words.parameter,
                        FaultCode::UnknownWord);
    }
    if (moves) {
      m_to.words.foreignMotion();
    }
    return;
  }
  const bool hasFurther = words.axes.hasAny(kFirstFurther, kProgrammedAxisCount);
  for (std::size_t axis = kFirstFurther; axis < kProgrammedAxisCount; ++axis) {
    if (words.axes.has(axis)) {
      m_to.faults.error(*words.axes.token[axis], FaultCode::UnknownWord);
    }
  }
  if (hasFurther && !words.axes.hasAny(0, kFirstFurther)) {
    if (motion == Motion::Rapid || motion == Motion::Line) {
      m_to.words.motion(motionNumber(), words.axes);
    }
    return;  // nothing of the path moves
  }
  const bool hasKnots = motion == Motion::Nurbs && m_curve.hasKnots;
  if (hasKnots) {
    takeKnot(words);
  } else if (!isPlaneArc(motion) && motion != Motion::CubicSpline &&
             motion != Motion::QuadraticSpline) {
    rejectArcWords(words);
  }
  if (motion == Motion::Nurbs && words.rare && words.rare->spline != nullptr &&
      words.rare->spline->function == G::NurbsOn && !moves) {
    m_curve.firstWeight = words.p.value_or(1.0);
  }
  if (!moves) {
    const bool hasFeed = m_state.feedMmPerS > 0.0 || m_state.feedMmPerRev > 0.0;
    if (m_language.needsMotion && words.g.motion != nullptr && motion != Motion::Rapid &&
        !hasFeed) {
      noteMissingFeed(words);
    }
    return;
  }
  if (words.machineToken == nullptr) {
    move(words);
    return;
  }
  // The length of the tool counts in machine coordinates too, unless D0 is programmed.
  const Frame frame = m_position.frame;
  const Vec3 zeroMm = m_position.zeroMm;
  m_position.setFrame({});
  m_position.setZero(m_state.toolMm());
  move(words);
  m_position.setZero(zeroMm);
  m_position.setFrame(frame);
}

/// G75: the axes that the block names go to a place of the machine, whatever their values say.
void Executor::moveToFixedPoint(const BlockWords& words) {
  const NamedWord* const number = words.named("FP");
  const auto place = m_options.fixedPointsMm.find(
      number == nullptr ? 1 : functionNumber(number->value).value_or(-1));
  if (place == m_options.fixedPointsMm.end()) {
    m_to.faults.error(*words.rare->fixedPoint, FaultCode::UnsupportedGCode,
                      wordText(*words.rare->fixedPoint));
    m_to.words.foreignMotion();
    return;
  }
  finishCurve();
  const Frame frame = m_position.frame;
  const Vec3 zeroMm = m_position.zeroMm;
  m_position.setFrame({});
  m_position.setZero({});
  Vec3 target = m_position.programmedMm;
  static constexpr std::array<std::string_view, base::kAxisCount> kNames{"X1", "Y1", "Z1"};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.axes.has(axis) || words.named(kNames[axis]) != nullptr) {
      target.set(axis, place->second[axis]);
      m_state.incrementFrom[axis].reset();
    }
  }
  Move move;
  move.line = words.line;
  move.motion = Motion::Rapid;
  move.exactStop = true;
  move.column = words.rare->fixedPoint->column;
  line(target, move);
  m_position.setZero(zeroMm);
  m_position.setFrame(frame);
}

/// SUPA, G53, M91: where that is in the workpiece is not known.
void Executor::leaveOutMachineMove(const BlockWords& words) {
  const Token& token = *words.machineToken;
  m_to.faults.error(
      token, FaultCode::MachineCoordinates,
      token.kind == TokenKind::Word ? wordText(token) : base::toUpper(tokenName(token)));
  if (const int g = motionNumber(); g >= -1) {
    m_to.words.machineMotion(g, words.axes);
  } else {
    m_to.words.foreignMotion();
  }
}

/// 0 to 3 for G0 to G3, -1 before any of them, -2 for other motions.
int Executor::motionNumber() const {
  if (m_state.motion == Motion::None || (m_state.motion == Motion::Line && m_state.motionAssumed)) {
    return -1;
  }
  return m_state.motion < Motion::None ? static_cast<int>(m_state.motion) : -2;
}

void Executor::move(BlockWords& words) {
  if (m_state.motion == Motion::None && (m_language.needsMotion || m_state.motionIsOff)) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(words.axes.named));
    error(words, FaultCode::UnknownWord,
          axis < kProgrammedAxisCount ? std::string(words.axes.token[axis]->text) : "@ ^");
    m_to.words.foreignMotion();
    return;
  }
  if (m_state.motion == Motion::None) {
    m_to.faults.report(Severity::Warning, words.motionColumn, FaultCode::MotionModeAssumed, {});
    m_state.motion = Motion::Line;
    m_state.motionAssumed = !m_state.motionNamed;
  }
  m_state.motionAssumed = m_state.motionAssumed && words.g.motion == nullptr;
  if (!m_options.knowsWorkOffsets) {
    m_reader.setMoved();
  }
  const Vec3 target = targetOf(words);
  const Move move = moveOf(words, target);
  m_pathBegun = m_pathBegun || words.movesLinear() || words.rare || words.hasAnyCentre();
  if (move.motion != Motion::Rapid && (move.feedMmPerS == 0.0 || m_state.feedIsDefault)) {
    noteMissingFeed(words);
  }
  switch (m_state.motion) {
    case Motion::Rapid:
    case Motion::Line:
      m_to.words.motion(motionNumber(), words.axes);
      line(target, move);
      break;
    case Motion::ArcClockwise:
    case Motion::ArcCounter:
      moveArc(words, target, move);
      break;
    case Motion::ThreePointArc:
    case Motion::TangentArc:
      m_to.words.foreignMotion();
      moveSpaceArc(words, target, move);
      break;
    case Motion::BSpline:
    case Motion::Nurbs:
      m_to.words.foreignMotion();
      addControlPoint(words, target, move);
      break;
    case Motion::CubicSpline:
    case Motion::QuadraticSpline:
      m_to.words.foreignMotion();
      moveBezier(words, target, move);
      break;
    case Motion::None:
    case Motion::Unsupported:
      break;
  }
}

void Executor::noteMissingFeed(const BlockWords& words) {
  const int column = std::max(1, words.motionColumn);
  if (m_state.feedMode == FeedMode::InverseTime) {
    if (words.feed == nullptr) {  // each block has its own
      m_to.faults.report(Severity::Error, column, FaultCode::FeedMissing, {});
    }
  } else if (!m_feedMissingReported) {
    // A number whose meaning G94 has taken is no feed, and not one that a stream may choose. Where
    // only S is missing, it may.
    const bool isLost =
        m_feedIsNamed && (m_state.feedMode == FeedMode::PerMinute || m_state.feedMmPerRev == 0.0);
    m_to.faults.report(isLost ? Severity::Error : Severity::Warning, column,
                       isLost ? FaultCode::FeedLost : FaultCode::FeedMissing, {});
    m_feedMissingReported = true;
  }
}

void Executor::moveTo(Vec3 programmedMm, std::optional<double> feedMmPerS, base::LineNumber at) {
  finishCurve();
  if (feedMmPerS && !(*feedMmPerS > 0.0)) {
    m_to.faults.report(Severity::Error, 1, FaultCode::FeedMissing, {});
    return;
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (programmedMm[axis] != m_position.programmedMm[axis]) {
      m_state.incrementFrom[axis].reset();
    }
  }
  Move move;
  move.line = at;
  move.motion = feedMmPerS ? Motion::Line : Motion::Rapid;
  move.feedMmPerS = feedMmPerS.value_or(0.0);
  move.column = 1;
  line(programmedMm, move);
}

double Executor::feedMmPerS() const {
  switch (m_state.feedMode) {
    case FeedMode::PerMinute:
      return m_state.feedMmPerS * m_state.feedOverride;
    case FeedMode::PerRevolution:  // S may have changed since F
      return m_state.constantSurfaceSpeed
                 ? 0.0
                 : m_state.feedMmPerRev * m_state.spindlePerMin / 60.0 * m_state.feedOverride;
    default:
      return 0.0;
  }
}

void Executor::line(Vec3 target, const Move& move) {
  m_to.path.line(m_position, target, move);
  const Vec3 way = target - m_position.programmedMm;
  arrive(target, base::dot(way, way) > 0.0 ? way : m_position.direction, move);
}

void Executor::unknownWay(Vec3 target, const Move& move) {
  m_to.path.unknownWay(m_position, target, move);
  arrive(target, m_position.direction, move);
}

void Executor::arrive(Vec3 target, Vec3 direction, const Move& move) {
  m_position.programmedMm = target;
  m_position.direction = direction;
  if (move.turns) {
    m_position.rotaryDeg = move.rotaryDeg;
  }
}

// --- where to -----------------------------------------------------------------------------------

/// Takes the programmed axes over. @return the new position, programmed coordinates
Vec3 Executor::targetOf(const BlockWords& words) {
  // RS-274 counts the increments of a curve's points from its start.
  const Vec3 from = m_language.leavesSplines ? m_position.programmedMm : programmed();
  Vec3 target = from;
  const std::size_t first = m_state.planeFirstAxis;
  const std::size_t second = m_state.planeSecondAxis();
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const bool isPolar = m_state.polar && (axis == first || axis == second);
    if (!words.axes.has(axis) || isPolar) {
      continue;
    }
    if (const double value = coordinate(words, axis, from); !std::isnan(value)) {
      m_state.incrementFrom[axis].reset();
      target.set(axis, value);
    }
  }
  if (m_state.polar && (words.axes.has(first) || words.axes.has(second))) {
    takePolarPlane(words, from, target);
  } else if (words.rare) {
    takePolarWords(words, from, target);
  }
  return target;
}

/// G16 of Fanuc: the first axis of the plane is the radius, the second the angle. With G91 the
/// radius is measured from where the tool stands, and the angle is added to the one before ("Polar
/// coordinate command (G15, G16)" in the manual of the Series 0i).
void Executor::takePolarPlane(const BlockWords& words, Vec3 from, Vec3& target) {
  const std::size_t first = m_state.planeFirstAxis;
  const std::size_t second = m_state.planeSecondAxis();
  m_state.incrementFrom[first].reset();
  m_state.incrementFrom[second].reset();
  if (words.axes.has(first)) {
    m_state.polarRadiusMm = lengthMm(words, first);
    m_state.poleMm = words.axes.isIncrement(first) ? from : Vec3{};
  }
  if (words.axes.has(second)) {
    const bool adds = words.axes.isIncrement(second) && !std::isnan(m_state.polarDegrees);
    m_state.polarDegrees = words.axes.value[second] + (adds ? m_state.polarDegrees : 0.0);
  }
  if (std::isnan(m_state.polarRadiusMm) || std::isnan(m_state.polarDegrees)) {
    // Neither stands anywhere since G16: what the control takes then is not known.
    const std::size_t missing = std::isnan(m_state.polarRadiusMm) ? first : second;
    error(words, FaultCode::WordMissing, fmt::format("G16 {}", base::kAxisNames[missing]));
    return;
  }
  setPolar(words, from, target);
}

/// @return NaN if it is not known: the axis stays where it is
double Executor::coordinate(const BlockWords& words, std::size_t axis, Vec3 from) {
  double value = lengthMm(words, axis);
  if (!(std::abs(value) <= kCoordinateMmMax)) {
    if (!std::isnan(value)) {  // else it has been reported
      m_to.faults.error(*words.axes.token[axis], FaultCode::ValueOutOfRange);
    }
    return kUnknown;
  }
  if (isOfTurns(words.axes.reference[axis])) {
    m_to.faults.error(*words.axes.token[axis], FaultCode::UnknownWord);  // of rotary axes only
    return kUnknown;
  }
  value = radiusMm(words, axis);
  if (words.axes.isIncrement(axis)) {
    const double origin = m_state.incrementFrom[axis].value_or(from[axis]);
    if (std::isnan(origin)) {
      if (value != 0.0) {  // an increment of nothing leaves the axis where it is
        m_to.faults.error(*words.axes.token[axis], FaultCode::RelativeFromUnknownPosition,
                          std::string(1, base::kAxisNames[axis]));
      }
      return kUnknown;
    }
    value += origin;
  }
  return value;
}

/// The axes of the plane stay where they are if it is not known where the polar coordinates point
/// to.
void Executor::setPolar(const BlockWords& words, Vec3 from, Vec3& target) {
  Vec3 placeMm = m_state.poleMm;
  addPolar(placeMm, m_state.polarRadiusMm, m_state.polarDegrees);
  const std::array<std::size_t, 2> plane{m_state.planeFirstAxis, m_state.planeSecondAxis()};
  for (const std::size_t axis : plane) {
    if (!(std::abs(placeMm[axis]) <= kCoordinateMmMax)) {
      error(words,
            std::isnan(m_state.poleMm[axis]) ? FaultCode::RelativeFromUnknownPosition
                                             : FaultCode::ValueOutOfRange,
            std::string(1, base::kAxisNames[axis]));
      placeMm = from;
      break;
    }
  }
  for (const std::size_t axis : plane) {
    target.set(axis, placeMm[axis]);
  }
}

void Executor::takePolarWords(const BlockWords& words, Vec3 from, Vec3& target) {
  const NamedWord* const radius = words.named("RP");
  const NamedWord* const angle = words.named("AP");
  if (radius == nullptr && angle == nullptr) {
    return;
  }
  const std::size_t first = m_state.planeFirstAxis;
  const std::size_t second = m_state.planeSecondAxis();
  m_state.incrementFrom[first].reset();
  m_state.incrementFrom[second].reset();
  if (m_language.hasPolarSigns && first != 0) {
    error(words, FaultCode::UnsupportedGCode, "@ ^");  // in the plane of G17 alone
    return;
  }
  const double across = from[first] - m_state.poleMm[first];
  const double up = from[second] - m_state.poleMm[second];
  // RS-274 counts radius and angle from the start.
  const bool countsFromStart = m_language.hasPolarSigns;
  for (const std::size_t axis : {first, second}) {
    if (countsFromStart && words.axes.has(axis)) {
      m_to.faults.error(*words.axes.token[axis], FaultCode::UnknownWord);
    }
  }
  const double radiusMm = std::hypot(across, up);
  const double degrees = std::atan2(up, across) * 180.0 / std::acos(-1.0);
  const bool needsStart = m_state.relative || angle == nullptr;
  if (countsFromStart && needsStart && !(radiusMm > 0.0)) {
    // RS-274/NGC: of the origin nobody knows the angle.
    error(words, FaultCode::RelativeFromUnknownPosition,
          angle == nullptr ? "@" : "^" + base::formatNumber(angle->value));
    return;
  }
  if (countsFromStart) {
    m_state.polarRadiusMm = radiusMm;
    m_state.polarDegrees = degrees;
  }
  bool lacksRadius = std::isnan(m_state.polarRadiusMm);
  if (radius != nullptr) {
    const bool relative =
        countsFromStart ? isIncremental(*radius) : radius->reference == Reference::Incremental;
    lacksRadius = lacksRadius && relative;
    m_state.polarRadiusMm =
        radius->value * m_state.lengthFactor + (relative ? m_state.polarRadiusMm : 0.0);
  }
  m_polarTurnDegrees = 0.0;
  if (angle != nullptr) {
    const bool relative = isIncremental(*angle);
    if (relative) {
      m_polarTurnDegrees = angle->value;
    }
    m_state.polarDegrees = angle->value + (relative ? degrees : 0.0);
  } else if (std::isnan(m_state.polarDegrees) && up == 0.0 && across > 0.0) {
    m_state.polarDegrees = 0.0;  // never named, and the tool stands there
  }
  const bool lacksAngle = angle == nullptr && std::isnan(m_state.polarDegrees);
  if (lacksRadius || lacksAngle) {
    error(words, FaultCode::WordMissing, lacksRadius ? "AP RP" : "RP AP");
    return;
  }
  setPolar(words, from, target);
  if (m_polarTurnDegrees != 0.0 && std::fmod(m_polarTurnDegrees, 360.0) == 0.0) {
    target.set(first, from[first]);
    target.set(second, from[second]);
  }
}

// --- what else the words say --------------------------------------------------------------------

Move Executor::moveOf(const BlockWords& words, Vec3 target) {
  Move move;
  move.line = words.line;
  move.motion = m_state.motion;
  move.exactStop = words.exactStop;
  move.column = words.motionColumn;
  move.feedMmPerS = m_state.feedMmPerS;
  move.feedDegPerS = m_state.feedDegPerS;
  if (m_state.feedMode == FeedMode::InverseTime) {
    move.feedMmPerS =
        words.feed != nullptr ? m_position.lengthMmTo(target) * words.feed->value / 60.0 : 0.0;
  }
  if (m_state.feedMode == FeedMode::PerRevolution) {  // S may have changed since F
    const double perMin = spindlePerMin(words, target);
    move.feedMmPerS = m_state.feedMmPerRev * perMin / 60.0;
    move.feedDegPerS = m_state.feedDegPerRev * perMin / 60.0;
  }
  if (words.rare && words.rare->blockFeed != nullptr) {
    takeBlockFeed(words, target, move);
  }
  if (words.hasRotary) {
    takeRotary(words, move);
  }
  if (m_state.feedMode == FeedMode::InverseTime) {
    const double turnDeg = move.turns ? m_position.turnDegTo(move.rotaryDeg) : 0.0;
    move.feedDegPerS =
        words.feed != nullptr && turnDeg > 0.0 ? turnDeg * words.feed->value / 60.0 : 0.0;
  }
  move.feedMmPerS *= m_state.feedOverride;
  move.feedDegPerS *= m_state.feedOverride;
  if (words.rare) {
    takeDirection(words, move);
  }
  return move;
}

/// FB=: the feed of this block alone, of the kind that G94 or G95 has chosen.
void Executor::takeBlockFeed(const BlockWords& words, Vec3 target, Move& move) {
  const Token& token = *words.rare->blockFeed;
  if (token.value == 0.0) {
    return;  // that of F
  }
  if (m_state.feedMode == FeedMode::PerMinute) {
    move.feedMmPerS = base::mmPerSFromMmPerMin(token.value * m_state.feedFactor);
    move.feedDegPerS = token.value / 60.0;
  } else if (m_state.feedMode == FeedMode::PerRevolution) {
    const double perMin = spindlePerMin(words, target);
    move.feedMmPerS = token.value * m_state.feedFactor * perMin / 60.0;
    move.feedDegPerS = token.value * perMin / 60.0;
  } else {
    m_to.faults.error(token, FaultCode::UnsupportedGCode, "FB");
  }
}

void Executor::takeRotary(const BlockWords& words, Move& move) {
  move.rotaryDeg = m_position.rotaryDeg;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (!words.axes.has(axis + kFirstRotary)) {
      continue;
    }
    const std::optional<double> degrees = rotaryTarget(words, axis);
    if (!degrees) {
      continue;
    }
    move.rotaryDeg[axis] = *degrees;
    move.turns = true;
    noteRotary(axis, *degrees, words.motionColumn);
  }
}

/// Where a rotary axis turns to; full turns count. @return nothing if a fault has been reported
std::optional<double> Executor::rotaryTarget(const BlockWords& words, std::size_t axis) {
  constexpr double kTurn = 360.0;
  constexpr double kSameDegrees = 1e-9;
  const std::size_t word = axis + kFirstRotary;
  const double value = words.axes.value[word];
  const double from = m_position.rotaryDeg[axis];
  const Reference reference = words.axes.reference[word];
  const bool isIncrement = words.axes.isIncrement(word);
  const bool isDirected = isOfTurns(reference);
  const bool turnsShortest = m_state.turnsShortest && !isIncrement;
  if (isDirected) {
    m_state.isModulo[axis] = true;
  }
  const bool startMatters = isIncrement || isDirected || turnsShortest || m_state.isModulo[axis];
  if (startMatters && std::isnan(from)) {
    // How far it turns is not known, but where to is. An increment of nothing turns nothing.
    if (isIncrement && value == 0.0) {
      return std::nullopt;
    }
    if (isIncrement || isDirected || turnsShortest) {
      m_to.faults.report(isIncrement ? Severity::Error : Severity::Warning, words.motionColumn,
                         FaultCode::RelativeFromUnknownPosition,
                         std::string(1, kProgrammedAxes[word]));
    }
    return isIncrement ? std::nullopt : std::optional(value + m_state.rotaryOffset[axis]);
  }
  if (isIncrement) {
    return from + value;
  }
  const double target = value + m_state.rotaryOffset[axis];
  if (reference == Reference::Nearest || (turnsShortest && !isDirected)) {
    return from + std::remainder(target - from, kTurn);
  }
  if (isDirected) {
    const double ahead = std::fmod(std::fmod(target - from, kTurn) + kTurn, kTurn);
    const bool isThere = ahead < kSameDegrees || kTurn - ahead < kSameDegrees;
    return isThere ? from : reference == Reference::Positive ? from + ahead : from + ahead - kTurn;
  }
  if (m_state.isModulo[axis]) {
    if (!(value >= 0.0 && value < kTurn)) {
      m_to.faults.error(*words.axes.token[word], FaultCode::ValueOutOfRange);
      return std::nullopt;
    }
    return std::floor(from / kTurn + kSameDegrees) * kTurn + target;
  }
  return target;
}

void Executor::noteRotary(std::size_t axis, double degrees, int column) {
  // An axis first named in mid-path turns there: where it stood before is not known.
  const bool turns = m_rotaryFirst[axis] ? *m_rotaryFirst[axis] != degrees : m_pathBegun;
  m_rotaryFirst[axis] = m_rotaryFirst[axis].value_or(degrees);
  if (turns && !m_state.tipWord.empty() && !m_tipReported) {
    m_tipReported = true;
    m_to.faults.report(Severity::Warning, column, FaultCode::ToolTip, m_state.tipWord);
  }
  if (turns && !m_rotaryReported[axis]) {
    m_rotaryReported[axis] = true;
    m_to.faults.report(Severity::Warning, column, FaultCode::RotaryAxes,
                       std::string(1, kProgrammedAxes[axis + kFirstRotary]));
  }
}

void Executor::takeDirection(const BlockWords& words, Move& move) {
  const NamedWord* const a = words.named("A3");
  const NamedWord* const b = words.named("B3");
  const NamedWord* const c = words.named("C3");
  if (a == nullptr && b == nullptr && c == nullptr) {
    return;
  }
  const auto value = [](const NamedWord* word) { return word == nullptr ? 0.0 : word->value; };
  const Vec3 direction{value(a), value(b), value(c)};
  const double length = base::norm(direction);
  if (!(length > 0.0)) {
    error(words, FaultCode::ValueOutOfRange, "A3= B3= C3=");
    return;
  }
  move.toolDirection = (1.0 / length) * direction;
  if (!m_directionReported) {
    m_directionReported = true;
    m_to.faults.report(Severity::Warning, words.motionColumn, FaultCode::ToolDirections,
                       "A3 B3 C3");
  }
}

}  // namespace rivulet::nc
