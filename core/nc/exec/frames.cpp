// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What moves the coordinates of the program: frames, offsets, poles.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "nc/exec/executor.h"

namespace rivulet::nc {

using base::Vec3;

/// TRANS, ROT, SCALE, MIRROR and their additive forms.
void Executor::setFrame(const std::string& name, const BlockWords& words) {
  finishCurve();
  const bool additive = name[0] == 'A';
  const std::string_view kind = additive ? std::string_view(name).substr(1) : name;
  Frame frame = additive ? m_position.frame : m_state.baseFrame;
  if (!knowsAllAxes(words, name)) {
    return;
  }
  if (kind == "TRANS") {
    Vec3 offset;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      // Of frames X is a radius, also with DIAMON (MD20360, bit 3, as delivered).
      offset.set(axis, words.axes.has(axis) ? lengthMm(words, axis) : 0.0);
    }
    if (words.movesLinear()) {
      frame.translate(offset);
    }
  } else if (kind == "ROT") {
    // About Z, then the turned Y, then the turned X.
    for (std::size_t axis = base::kAxisCount; axis-- > 0;) {
      if (words.axes.has(axis)) {
        frame.rotate(axis, words.axes.value[axis]);
      }
    }
    if (const NamedWord* const inPlane = words.named("RPL")) {
      frame.rotate(m_state.planeThirdAxis(), inPlane->value);
    }
  } else {
    const std::optional<Vec3> factors = scaleFactors(kind == "MIRROR", words);
    if (!factors) {
      return;
    }
    if (words.movesLinear()) {
      frame.scale(*factors);
    }
  }
  const Vec3 before = m_position.programmedMm;
  m_position.setFrame(frame);
  m_to.words.forget(std::nullopt);
  keepIncrements(before);
}

void Executor::keepIncrements(Vec3 before) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_state.incrementFrom[axis] = m_state.incrementFrom[axis].value_or(before[axis]);
  }
}

/// The axes stay where they are; another work offset or tool gives the place other coordinates.
void Executor::takeZero() {
  const auto offset = m_options.workOffsetsMm.find(m_state.workOffset);
  m_state.workOffsetMm = offset == m_options.workOffsetsMm.end() ? Vec3{} : offset->second;
  const Vec3 zeroMm = m_state.zeroMm();
  if (zeroMm != m_position.zeroMm) {
    const Vec3 before = m_position.programmedMm;
    m_position.setZero(zeroMm);
    keepIncrements(before);
  }
}

std::optional<Vec3> Executor::scaleFactors(bool mirrors, const BlockWords& words) {
  Vec3 factors{1.0, 1.0, 1.0};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.axes.has(axis)) {
      continue;
    }
    factors.set(axis, mirrors ? -1.0 : words.axes.value[axis]);
    if (factors[axis] == 0.0) {
      m_to.faults.error(*words.axes.token[axis], FaultCode::ValueOutOfRange);
      return std::nullopt;
    }
  }
  return factors;
}

/// Frames shift, turn and scale X, Y and Z; where the other axes would go is not known.
bool Executor::knowsAllAxes(const BlockWords& words, const std::string& statement) {
  if (words.hasRotary) {
    error(words, FaultCode::UnsupportedGCode, statement);
    return false;
  }
  return true;
}

/// G92: where the axes stand gets these coordinates. Of an axis whose place is not known, its
/// offset is zero, which is right where the tool was brought there.
void Executor::setPosition(const BlockWords& words, const std::string& statement) {
  const Vec3 position = m_position.programmedMm;
  bool isKnown = true;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.axes.has(axis) && std::isnan(position[axis])) {
      isKnown = false;
      m_position.programmedMm.set(axis, radiusMm(words, axis));
    } else if (words.axes.has(axis)) {
      m_setOffset.mm.set(axis, m_setOffset.mm[axis] + position[axis] - radiusMm(words, axis));
    }
    const std::size_t rotary = axis + kFirstRotary;
    if (words.axes.has(rotary) && std::isnan(m_position.rotaryDeg[axis])) {
      isKnown = false;
      m_position.rotaryDeg[axis] = words.axes.value[rotary];
      m_rotaryFirst[axis] = words.axes.value[rotary];
    } else if (words.axes.has(rotary)) {
      m_setOffset.rotaryDeg[axis] = m_position.rotaryDeg[axis] - words.axes.value[rotary] -
                                    m_workOffsets[workOffsetNumber()].rotaryDeg[axis];
    }
  }
  if (!isKnown && !m_options.placeIsSaid) {
    m_to.faults.report(Severity::Warning, 1, FaultCode::ControlSettingOpen,
                       statement + ": place=G92");
  }
}

/// The place about which coordinates change: as named, always absolute, else where the tool is.
bool Executor::takeCentre(const BlockWords& words, std::size_t axis, Vec3& centreMm) {
  const double named = words.axes.has(axis) ? radiusMm(words, axis) : programmed()[axis];
  if (std::isnan(named)) {
    error(words, FaultCode::RelativeFromUnknownPosition, std::string(1, base::kAxisNames[axis]));
    return false;
  }
  centreMm.set(axis, named);
  return true;
}

/// G68 X Y R. In three dimensions, under G91 (where a parameter of the control says what R counts
/// from) and within scaling it is not made.
void Executor::setTurn(const BlockWords& words) {
  Change turn;
  turn.axis = m_state.planeThirdAxis();
  if (words.axes.has(turn.axis) || words.hasAnyCentre() || m_state.relative || m_scale ||
      m_mirror || !words.hasRadius) {
    error(words, FaultCode::UnsupportedGCode, words.hasRadius ? "G68" : "G68 without R");
    return;
  }
  m_turn.reset();
  makeBaseFrame();
  turn.degrees = words.radius;
  if (takeCentre(words, m_state.planeFirstAxis, turn.centreMm) &&
      takeCentre(words, m_state.planeSecondAxis(), turn.centreMm)) {
    m_turn = turn;
  }
}

/// G51 X Y Z P, or I J K. Without a point P and I J K count 0.001 or 0.00001, as a parameter of the
/// control says: nobody knows here.
void Executor::setScale(const BlockWords& words) {
  if (m_turn || m_mirror || (!words.p && !words.hasAnyCentre())) {
    error(words, FaultCode::UnsupportedGCode, "G51");
    return;
  }
  m_scale.reset();
  makeBaseFrame();
  Change scale;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const bool isOwn = words.centre.has(axis);
    const Token* const token = isOwn ? words.centre.token[axis] : words.parameter;
    if (!isOwn && !words.p) {
      continue;  // not scaled
    }
    const double factor = isOwn ? words.centre.value[axis] : *words.p;
    if (token == nullptr || !token->hasPoint || !(std::abs(factor) >= 0.001)) {
      error(words, FaultCode::UnsupportedGCode, "G51");
      return;
    }
    scale.factors.set(axis, factor);
    if (factor != 1.0 && !takeCentre(words, axis, scale.centreMm)) {
      return;
    }
  }
  // An arc stays one on the control, whatever the factors: with different ones nobody draws it so.
  const Vec3 size = scale.factors;
  if (std::abs(size.x) != std::abs(size.y) || std::abs(size.x) != std::abs(size.z)) {
    error(words, FaultCode::UnsupportedGCode, "G51");
    return;
  }
  m_scale = scale;
}

/// G51.1 X: X is mirrored about this coordinate. G50.1 X: X no more, G50.1: none.
void Executor::setMirror(const BlockWords& words) {
  if (m_turn || m_scale) {
    error(words, FaultCode::UnsupportedGCode, "G51.1");
    return;
  }
  const bool begins = words.rare->offset == GEffect::Mirror;
  Change mirror = m_mirror.value_or(Change{});
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const bool isNamed = words.axes.has(axis) || (!begins && !words.movesLinear());
    if (isNamed) {
      mirror.factors.set(axis, begins ? -1.0 : 1.0);
      mirror.centreMm.set(axis, begins ? radiusMm(words, axis) : 0.0);
    }
  }
  m_mirror = mirror.factors == Vec3{1.0, 1.0, 1.0} ? std::nullopt : std::optional(mirror);
}

/// G92 to G92.3, G52, G50, G10, and G68, G51 and G51.1 of Fanuc.
void Executor::setOffset(const BlockWords& words) {
  finishCurve();
  const GEffect offset = words.rare->offset;
  m_to.words.forget(std::nullopt);
  const bool further = words.axes.hasAny(kFirstFurther, kProgrammedAxisCount);
  const bool isLocal = offset == GEffect::LocalOffset;
  const std::string statement = isLocal ? "G52" : m_state.isLathe ? "G50" : "G92";
  if ((isLocal || further) && !knowsAllAxes(words, statement)) {
    return;
  }
  if ((m_turn || m_scale || m_mirror) && (isLocal || offset == GEffect::SetPosition)) {
    // Not allowed by the manual of the control, and others count from different places.
    error(words, FaultCode::UnsupportedGCode, statement);
    return;
  }
  Offset& set = m_setOffset;
  switch (offset) {
    case GEffect::LocalOffset:
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (words.axes.has(axis)) {
          (m_language.sharesOffset ? set.mm : m_localOffsetMm).set(axis, radiusMm(words, axis));
        }
      }
      m_keptOffset = set;
      break;
    case GEffect::ResetPosition:
      m_keptOffset = Offset{};
      [[fallthrough]];
    case GEffect::SuspendPosition:
      set = {};
      break;
    case GEffect::RestorePosition:
      if (!m_keptOffset) {
        error(words, FaultCode::UnsupportedGCode, "G92.3");
        return;
      }
      set = *m_keptOffset;
      break;
    case GEffect::ScaleOff:  // with other words it is a function of a lathe
      if (words.moves() || words.spindle != nullptr) {
        error(words, FaultCode::UnsupportedGCode, "G50");
        return;
      }
      m_scale.reset();
      break;
    case GEffect::Turn:
      setTurn(words);
      break;
    case GEffect::TurnOff:
      m_turn.reset();
      break;
    case GEffect::Scale:
      setScale(words);
      break;
    case GEffect::Mirror:
    case GEffect::MirrorOff:
      setMirror(words);
      break;
    case GEffect::SetWorkOffset:
      setWorkOffset(words);
      break;
    default:
      if (!words.moves()) {
        return;  // G92 S: a limit of the spindle; G92 alone: nothing
      }
      setPosition(words, statement);
      m_keptOffset = set;
      break;
  }
  makeBaseFrame();
}

/// What Rivulet adds to the work offset of the control.
void Executor::makeBaseFrame() {
  const WorkOffset& work = m_workOffsets[workOffsetNumber()];
  m_state.baseFrame = {};
  if (work.degrees != 0.0) {
    m_state.baseFrame.rotate(2, work.degrees);
  }
  const Vec3 offsetMm = m_setOffset.mm + m_localOffsetMm;
  if (offsetMm != Vec3{}) {
    m_state.baseFrame.translate(offsetMm);
  }
  for (const std::optional<Change>& change : {m_mirror, m_scale, m_turn}) {
    if (change) {
      m_state.baseFrame.translate(change->centreMm);
      m_state.baseFrame.scale(change->factors);
      m_state.baseFrame.rotate(change->axis, change->degrees);
      m_state.baseFrame.translate(-1.0 * change->centreMm);
    }
  }
  m_position.setFrame(m_state.baseFrame);
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    m_state.rotaryOffset[axis] = work.rotaryDeg[axis] + m_setOffset.rotaryDeg[axis];
  }
}

int Executor::workOffsetNumber() const {
  static constexpr std::array kKeys{540, 550, 560, 570, 580, 590, 591, 592, 593};
  const auto* const found = std::find(kKeys.begin(), kKeys.end(), m_state.workOffset);
  return found == kKeys.end() ? 1 : static_cast<int>(found - kKeys.begin()) + 1;
}

/// G10 L2: the control gets X, Y and Z; the turn about Z and the rotary axes are added here.
void Executor::setWorkOffset(const BlockWords& words) {
  constexpr double kLast = 9.0;
  const double number = words.p.value_or(-1.0);
  constexpr double kOrigin = 2.0;
  if (words.l != kOrigin || number != std::floor(number) || number < 0.0 || number > kLast ||
      words.hasAnyCentre() ||
      (m_language.setsListedOffsets && (number < 1.0 || m_state.relative || words.hasRadius))) {
    error(words, FaultCode::UnsupportedGCode, "G10 L" + base::formatNumber(words.l.value_or(0.0)));
    return;
  }
  WorkOffset& work = m_workOffsets[number == 0.0 ? workOffsetNumber() : static_cast<int>(number)];
  // A value that could not be computed has been reported.
  work.degrees = words.hasRadius && std::isfinite(words.radius) ? words.radius : work.degrees;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const double degrees = words.axes.value[axis + kFirstRotary];
    if (words.axes.has(axis + kFirstRotary) && std::isfinite(degrees)) {
      work.rotaryDeg[axis] = degrees;
    }
  }
  error(words, FaultCode::UnsupportedGCode, "G10");
}

/// G110, G111, G112: whatever G90 and G91 say (840Di sl Fundamentals 4.2.1).
void Executor::setPole(const BlockWords& words) {
  const G from = words.rare->pole->function;
  const Vec3 position = programmed();
  Vec3 pole = from == G::PoleFromPosition ? position
              : from == G::PoleFromPole   ? m_state.poleMm
                                          : Vec3{};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.axes.has(axis)) {
      continue;
    }
    pole.set(axis, pole[axis] + lengthMm(words, axis));
  }
  if (const NamedWord* const radius = words.named("RP")) {
    const NamedWord* const angle = words.named("AP");
    addPolar(pole, radius->value * m_state.lengthFactor, angle == nullptr ? 0.0 : angle->value);
  }
  m_state.poleMm = pole;
}

void Executor::addPolar(Vec3& point, double radiusMm, double degrees) const {
  const double radians = degrees * std::acos(-1.0) / 180.0;
  const std::size_t first = m_state.planeFirstAxis;
  const std::size_t second = m_state.planeSecondAxis();
  point.set(first, point[first] + radiusMm * std::cos(radians));
  point.set(second, point[second] + radiusMm * std::sin(radians));
}

}  // namespace rivulet::nc
