// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves along splines: BSPLINE over several blocks, G5, G5.1 and G5.2.

#include <algorithm>
#include <cmath>
#include <utility>

#include "nc/exec/executor.h"

namespace rivulet::nc {

using base::Vec3;

/// The start of a curve, as its first block names it.
constexpr double kSameMm = 1e-3;

void Executor::selectSpline(G function) {
  if (function == G::NurbsWithKnots && m_curve.hasKnots && m_state.motion == Motion::Nurbs) {
    return;  // the curve goes on
  }
  m_state.cycle = {};
  m_curve.isClosed = function == G::NurbsOff;
  finishCurve();
  m_curve.hasKnots = function == G::NurbsWithKnots;
  m_curve.knots.clear();
  if (function != G::CubicSpline) {
    m_curve.lastTangent = {};
  }
  switch (function) {
    case G::CubicSpline:
      m_state.motion = Motion::CubicSpline;
      break;
    case G::QuadraticSpline:
      m_state.motion = Motion::QuadraticSpline;
      break;
    case G::NurbsOn:
    case G::NurbsWithKnots:
      m_state.motion = Motion::Nurbs;
      m_curve.degree = m_curve.hasKnots ? 3 : 2;
      break;
    default:
      m_state.motion = Motion::None;  // G5.3 closes the curve: the next block names its own motion
      m_state.motionNamed = true;
      break;
  }
}

namespace {

/// An axis that nobody has named yet stays where it is; along any other the curve is known.
bool isCurveKnown(Vec3 from, Vec3 target) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (std::isnan(from[axis]) != std::isnan(target[axis])) {
      return false;
    }
  }
  return true;
}

}  // namespace

/// G6.2: K is the next knot, P the order of the curve. Blocks without axes name the last knots.
void Executor::takeKnot(const BlockWords& words) {
  if (words.centre.has(2)) {
    m_curve.knots.push_back(words.centre.value[2]);
  }
  if (words.p && *words.p >= 2.0) {
    m_curve.degree = static_cast<int>(std::min(*words.p - 1.0, 9.0));
  }
}

void Executor::addControlPoint(const BlockWords& words, Vec3 target, const Move& move) {
  const Vec3 from = programmed();
  // What is between two blocks may make known axes unknown.
  const Vec3 first = m_curve.end ? m_curve.spline.controlMm.front() : from;
  if (!isCurveKnown(from, target) || !isCurveKnown(first, target)) {
    error(words, FaultCode::ArcFromUnknownPosition, "X Y Z");
    unknownWay(target, move);
    return;
  }
  if (!m_curve.end) {
    m_curve.spline = {};
    m_curve.spline.controlMm.push_back(from);
    m_curve.spline.weights.push_back(m_state.motion == Motion::Nurbs ? m_curve.firstWeight : 1.0);
    m_curve.firstWeight = 1.0;
    if (m_curve.hasKnots) {  // the first block names the start
      if (base::distance(from, target) > kSameMm) {
        error(words, FaultCode::ValueOutOfRange, "G6.2");
      }
      m_curve.spline.controlMm.clear();
      m_curve.spline.weights.clear();
    }
  }
  const double weight = weightOf(words);
  m_curve.spline.controlMm.push_back(target);
  m_curve.spline.weights.push_back(weight);
  m_curve.end = target;
  m_curve.move = move;
}

double Executor::weightOf(const BlockWords& words) {
  double weight = 1.0;
  if (m_language.leavesSplines && !m_curve.hasKnots && !words.p) {
    error(words, FaultCode::NumberMissing, "P");
  }
  if (m_curve.hasKnots) {
    weight = words.hasRadius ? words.radius : 1.0;
  } else if (m_state.motion == Motion::Nurbs) {
    weight = words.p.value_or(1.0);
    if (words.l) {
      m_curve.degree = static_cast<int>(std::clamp(*words.l - 1.0, 1.0, 9.0));
    }
  } else if (const NamedWord* const given = words.named("PW")) {
    weight = given->value;
  }
  if (words.named("PL") != nullptr) {
    error(words, FaultCode::UnsupportedGCode, "PL");
  }
  if (!(weight > 0.0)) {
    error(words, FaultCode::ValueOutOfRange, "PW");
    weight = 1.0;
  }
  return weight;
}

void Executor::finishCurve() {
  if (!m_curve.end) {
    return;
  }
  m_curve.end.reset();
  if (m_language.leavesSplines && !m_curve.hasKnots && !m_curve.isClosed) {
    m_to.faults.fault(m_curve.move.column, {FaultCode::NotClosed, "G5.2", {}});
  }
  const std::size_t points = m_curve.spline.controlMm.size();
  m_curve.spline.degree = std::min(m_curve.degree, static_cast<int>(points) - 1);
  m_curve.spline.knots =
      m_curve.hasKnots ? std::move(m_curve.knots) : clampedKnots(points, m_curve.spline.degree);
  m_curve.knots.clear();
  if (!isClamped(m_curve.spline)) {
    m_to.faults.report(Severity::Error, m_curve.move.column, FaultCode::ValueOutOfRange, "K");
    unknownWay(m_curve.spline.controlMm.back(), m_curve.move);
    return;
  }
  spline(m_curve.spline, m_curve.move);
}

void Executor::spline(const Spline& spline, const Move& move) {
  m_to.path.spline(m_position, spline, move);
  const std::vector<Vec3>& control = spline.controlMm;
  Vec3 direction;
  for (std::size_t i = control.size() - 1; i-- > 0 && base::norm(direction) == 0.0;) {
    direction = control.back() - control[i];
  }
  if (!base::isFinite(direction)) {
    direction = {};
  }
  arrive(control.back(), direction, move);
}

namespace {

double centreOf(const BlockWords& words, std::size_t axis) {
  return words.centre.has(axis) ? words.centre.value[axis] : 0.0;
}

}  // namespace

/// G5: I J from the start, P Q from the end. G5.1: I J only.
void Executor::moveBezier(const BlockWords& words, Vec3 target, const Move& move) {
  const Vec3 from = m_position.programmedMm;
  const bool isCubic = m_state.motion == Motion::CubicSpline;
  if (!isCurveKnown(from, target) || m_state.planeFirstAxis != 0) {
    error(words, FaultCode::ArcFromUnknownPosition, "X Y Z");
    unknownWay(target, move);
    return;
  }
  if (m_language.leavesSplines) {
    m_state.motion = Motion::None;  // of this block alone
    m_state.motionNamed = true;
    const bool isWhole = words.centre.has(0) == words.centre.has(1) &&
                         (isCubic || words.centre.has(0)) && !words.axes.has(2) && !words.hasRotary;
    if (!isWhole || (isCubic && (!words.p || !words.q))) {
      error(words, FaultCode::ArcWithoutCentre);
      unknownWay(target, move);
      return;
    }
  }
  const double unit = m_state.lengthFactor;
  const bool hasStart = words.centre.has(0) || words.centre.has(1);
  const Vec3 start = hasStart ? Vec3{centreOf(words, 0) * unit, centreOf(words, 1) * unit, 0.0}
                              : -1.0 * m_curve.lastTangent;
  if (!hasStart && m_curve.lastTangent == Vec3{}) {
    error(words, FaultCode::ArcWithoutCentre);
    unknownWay(target, move);
    return;
  }
  Spline curve;
  curve.controlMm = {from, from + start};
  if (isCubic) {
    const Vec3 end{words.p.value_or(0.0) * unit, words.q.value_or(0.0) * unit, 0.0};
    curve.controlMm.push_back(target + end);
    m_curve.lastTangent = end;
  }
  curve.controlMm.push_back(target);
  curve.degree = static_cast<int>(curve.controlMm.size()) - 1;
  curve.weights.assign(curve.controlMm.size(), 1.0);
  curve.knots = clampedKnots(curve.controlMm.size(), curve.degree);
  spline(curve, move);
}

}  // namespace rivulet::nc
