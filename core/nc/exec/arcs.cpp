// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves along circles and helices: G2, G3, CIP, CT.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "nc/exec/executor.h"

namespace rivulet::nc {

using base::Vec3;

namespace {

/// Full circles on top of an arc, as on the control.
constexpr double kTurnsMax = 999.0;

}  // namespace

/// G2 and G3 with an end and nothing else.
bool Executor::isLine(const BlockWords& words) const {
  const bool namesEnd =
      words.axes.has(m_state.planeFirstAxis) || words.axes.has(m_state.planeSecondAxis());
  return m_language.arcMayBeLine && namesEnd && !words.hasAnyCentre() && !words.hasRadius &&
         words.named("AP") == nullptr && words.named("RP") == nullptr;
}

void Executor::moveArc(const BlockWords& words, Vec3 target, Move move) {
  if (isLine(words)) {
    if (!m_options.arcLineIsSaid) {
      m_to.faults.report(Severity::Warning, words.motionColumn, FaultCode::ControlSettingOpen,
                         "G2, G3: arc=line");
    }
    m_to.words.motion(motionNumber(), words.axes);
    move.motion = Motion::Line;
    line(target, move);
    return;
  }
  const std::optional<Arc> arc = arcOf(words, target);
  if (!arc) {
    unknownWay(target, move);
    return;
  }
  if (m_state.feedMode == FeedMode::InverseTime && words.feed != nullptr) {
    // How long an ellipse is, is not known in advance.
    const Frame& frame = m_position.frame;
    move.feedMmPerS = frame.keepsCircles() ? arcLength(*arc) * frame.stretchMax() *
                                                 words.feed->value / 60.0 * m_state.feedOverride
                                           : 0.0;
  }
  m_to.path.arc(m_position, *arc, move);
  const SpaceArc turn = inSpace(*arc);
  arrive(arc->endMm, base::cross(turn.axis, arc->endMm - turn.centreMm), move);
}

/// @return nothing if a fault has been reported
std::optional<Arc> Executor::arcOf(const BlockWords& words, Vec3 target) {
  Arc arc;
  arc.firstAxis = m_state.planeFirstAxis;
  arc.clockwise = m_state.motion == Motion::ArcClockwise;
  if (!takeTurns(words, arc)) {
    m_to.words.motion(motionNumber(), words.axes);
    return std::nullopt;
  }
  ArcWords given = arcWordsOf(words);
  if (m_language.arcsNameEnd && !given.endIsGiven) {
    error(words, FaultCode::WordMissing,
          fmt::format("G{} {} {}", arc.clockwise ? 2 : 3, base::kAxisNames[arc.firstAxis],
                      base::kAxisNames[m_state.planeSecondAxis()]));
    return std::nullopt;
  }
  tellArc(words, arc, given);
  if (!toMillimetres(words, given)) {
    return std::nullopt;
  }
  usePoleAsCentre(words, given);
  const bool hasCentre = given.centre[0] || given.centre[1] || given.centre[2];
  if (!hasCentre && !given.radius && !given.degrees) {
    error(words, FaultCode::ArcWithoutCentre);
    return std::nullopt;
  }
  if (!startIsKnown(words)) {
    return std::nullopt;
  }
  arc.startMm = m_position.programmedMm;
  arc.endMm = target;
  ignoreCentreAcross(words, given);
  given = readAs(m_options.centres, given);
  if (m_polarTurnDegrees != 0.0 && words.named("AP") != nullptr) {
    arc.turns = std::max(0, static_cast<int>(std::ceil(std::abs(m_polarTurnDegrees) / 360.0)) - 1);
  }
  const ResolvedArc resolved = resolveArc(arc, given, m_options.arcRadiusToleranceMm);
  return reportArcProblem(resolved, words) ? std::optional(resolved.arc) : std::nullopt;
}

bool Executor::takeTurns(const BlockWords& words, Arc& arc) {
  const NamedWord* const turns = words.named("TURN");
  if (turns == nullptr) {
    // P1 is the arc alone.
    if (m_language.hasTurnsInP && words.p) {
      if (!(*words.p >= 1.0 && *words.p <= kTurnsMax && *words.p == std::floor(*words.p))) {
        error(words, FaultCode::ValueOutOfRange, "P");
        return false;
      }
      arc.turns = static_cast<int>(*words.p) - 1;
    }
    return true;
  }
  if (!(turns->value >= 0.0 && turns->value <= kTurnsMax &&
        turns->value == std::floor(turns->value))) {
    error(words, FaultCode::ValueOutOfRange, "TURN=");
    return false;
  }
  arc.turns = static_cast<int>(turns->value);
  return true;
}

ArcWords Executor::arcWordsOf(const BlockWords& words) const {
  ArcWords given;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.centre.has(axis)) {
      given.centre[axis] = words.centre.value[axis];
      const Reference from = words.centre.reference[axis];
      given.centreIsAbsolute[axis] =
          from == Reference::Absolute || (from == Reference::Modal && m_state.centreIsAbsolute);
    }
  }
  if (words.hasRadius) {
    given.radius = words.radius;
  }
  given.endIsGiven =
      words.axes.has(m_state.planeFirstAxis) || words.axes.has(m_state.planeSecondAxis());
  if (const NamedWord* const angle = words.named("AR")) {
    given.degrees = angle->value;
  }
  return given;
}

/// Arcs with AP= turn about the pole.
void Executor::usePoleAsCentre(const BlockWords& words, ArcWords& given) const {
  const bool hasCentre = words.hasAnyCentre() || words.hasRadius || given.degrees;
  if (hasCentre || words.named("AP") == nullptr) {
    return;
  }
  for (const std::size_t axis : {m_state.planeFirstAxis, m_state.planeSecondAxis()}) {
    given.centre[axis] = m_state.poleMm[axis];
    given.centreIsAbsolute[axis] = true;
  }
}

/// The arc as it is written, in the unit of the program.
void Executor::tellArc(const BlockWords& words, const Arc& arc, const ArcWords& given) {
  if (words.named("AP") != nullptr) {
    // The end of a polar arc is calculated, not programmed.
    m_to.words.foreignMotion();
    return;
  }
  m_to.words.arc(words.axes, arc, given);
}

/// @return false if a value is too large, which has been reported
bool Executor::toMillimetres(const BlockWords& words, ArcWords& given) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!given.centre[axis]) {
      continue;
    }
    if (!(std::abs(*given.centre[axis] * m_state.lengthFactor) <= kCoordinateMmMax)) {
      m_to.faults.error(*words.centre.token[axis], FaultCode::ValueOutOfRange);
      return false;
    }
    // I=AC() is a diameter where X is one; an increment, and G90.1, is not.
    const bool isDiameter = m_state.diameter && axis == 0 && words.centre.has(axis) &&
                            words.centre.reference[axis] == Reference::Absolute;
    *given.centre[axis] *= isDiameter ? m_state.lengthFactor / 2.0 : m_state.lengthFactor;
  }
  if (given.radius) {
    *given.radius *= m_state.lengthFactor;
    if (!(std::abs(*given.radius) <= kCoordinateMmMax)) {
      m_to.faults.error(*words.radiusToken, FaultCode::ValueOutOfRange);
      return false;
    }
  }
  return true;
}

bool Executor::startIsKnown(const BlockWords& words) {
  const std::size_t third = m_state.planeThirdAxis();
  for (const std::size_t axis : {m_state.planeFirstAxis, m_state.planeSecondAxis(), third}) {
    const bool needed = axis != third || words.axes.has(third);
    if (needed && std::isnan(m_position.programmedMm[axis])) {
      error(words, FaultCode::ArcFromUnknownPosition, std::string(1, base::kAxisNames[axis]));
      return false;
    }
  }
  return true;
}

/// Of a helix the centre is a place in the plane; its third coordinate has no meaning.
void Executor::ignoreCentreAcross(const BlockWords& words, ArcWords& given) {
  const std::size_t third = m_state.planeThirdAxis();
  if (m_language.ignoresCentreAcross && given.centre[third].value_or(0.0) != 0.0 &&
      words.axes.has(third)) {
    const Token& token = *words.centre.token[third];
    m_to.faults.report(Severity::Warning, token.column, FaultCode::CentreOutsidePlane,
                       std::string(token.text));
    given.centre[third].reset();
  }
}

/// @return true if there is none
bool Executor::reportArcProblem(const ResolvedArc& resolved, const BlockWords& words) {
  switch (resolved.problem) {
    case ArcProblem::None:
      return true;
    case ArcProblem::CentreMissing:
      error(words, FaultCode::ArcWithoutCentre);
      break;
    case ArcProblem::CentreOutsidePlane:
      m_to.faults.error(*words.centre.token[resolved.axis], FaultCode::CentreOutsidePlane);
      break;
    case ArcProblem::CentreAndRadius:
      error(words, FaultCode::ConflictingGCodes,
            words.radiusIsWord ? "I J K and R" : "I J K and CR=");
      break;
    case ArcProblem::RadiusMismatch: {
      const ArcRadii radii = arcRadii(resolved.arc);
      const bool isSpiral =
          resolved.mismatch <= m_language.spiralShare * std::max(radii.startMm, radii.endMm);
      m_to.faults.report(isSpiral ? Severity::Warning : Severity::Error, words.motionColumn,
                         FaultCode::ArcRadiusMismatch, base::formatFixed(resolved.mismatch, 4));
      return isSpiral;
    }
    case ArcProblem::RadiusTooSmall:
      error(words, FaultCode::ArcRadiusTooSmall,
            fmt::format("{} < {}", base::formatFixed(resolved.mismatch, 4),
                        base::formatFixed(resolved.halfChord, 4)));
      break;
  }
  return false;
}

void Executor::moveSpaceArc(const BlockWords& words, Vec3 target, const Move& move) {
  const Vec3 from = m_position.programmedMm;
  if (!base::isFinite(from) || !base::isFinite(target)) {
    error(words, FaultCode::ArcFromUnknownPosition, "X Y Z");
    unknownWay(target, move);
    return;
  }
  std::optional<SpaceArc> arc;
  if (m_state.motion == Motion::ThreePointArc) {
    Vec3 middle = from;
    static constexpr std::array<std::string_view, base::kAxisCount> kNames{"I1", "J1", "K1"};
    bool given = false;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (const NamedWord* const word = words.named(kNames[axis])) {
        const bool isIncrement = isIncremental(*word);
        middle.set(axis, word->value * m_state.lengthFactor + (isIncrement ? from[axis] : 0.0));
        given = true;
      }
    }
    arc = given ? arcThrough(from, middle, target) : std::nullopt;
  } else {
    arc = tangentArc(from, m_position.direction, target);
    if (!arc && base::norm(m_position.direction) > 0.0) {
      line(target, move);  // straight on
      return;
    }
  }
  if (!arc) {
    error(words, FaultCode::ArcWithoutCentre);
    unknownWay(target, move);
    return;
  }
  m_to.path.spaceArc(m_position, *arc, target, move);
  arrive(target, base::cross(arc->axis, target - arc->centreMm), move);
}

}  // namespace rivulet::nc
