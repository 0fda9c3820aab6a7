// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What moves the coordinates of the program: frames, offsets, poles.

#include <algorithm>
#include <cmath>

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
      offset.set(axis, words.axes.given[axis] ? lengthMm(words, axis) : 0.0);
    }
    if (words.movesLinear()) {
      frame.translate(offset);
    }
  } else if (kind == "ROT") {
    // About Z, then the turned Y, then the turned X.
    for (std::size_t axis = base::kAxisCount; axis-- > 0;) {
      if (words.axes.given[axis]) {
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
    if (!words.axes.given[axis]) {
      continue;
    }
    factors.set(axis, mirrors ? -1.0 : words.axes.value[axis]);
    if (factors[axis] == 0.0) {
      m_to.faults.error(*words.axisTokens[axis], FaultCode::ValueOutOfRange);
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

/// G92: where the axes stand gets these coordinates. Where that is for an axis that has not
/// moved yet, the operator has seen to: its offset is zero.
void Executor::setPosition(const BlockWords& words) {
  const Vec3 position = m_position.programmedMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (words.axes.given[axis] && std::isnan(position[axis])) {
      m_position.programmedMm.set(axis, lengthMm(words, axis));
    } else if (words.axes.given[axis]) {
      m_state.setOffsetMm.set(axis,
                              m_state.setOffsetMm[axis] + position[axis] - lengthMm(words, axis));
    }
    const std::size_t rotary = axis + kFirstRotary;
    if (words.axes.given[rotary] && std::isnan(m_position.rotaryDeg[axis])) {
      m_position.rotaryDeg[axis] = words.axes.value[rotary];
      m_rotaryFirst[axis] = words.axes.value[rotary];
    } else if (words.axes.given[rotary]) {
      m_state.rotaryOffset[axis] = m_position.rotaryDeg[axis] - words.axes.value[rotary];
    }
  }
}

/// G92, G92.1 and G52.
void Executor::setOffset(const BlockWords& words) {
  finishCurve();
  const GEffect offset = words.rare->offset;
  m_to.words.forget(std::nullopt);
  const bool further = std::find(words.axes.given.begin() + kFirstFurther, words.axes.given.end(),
                                 true) != words.axes.given.end();
  const bool isLocal = offset == GEffect::LocalOffset;
  if ((isLocal || further) && !knowsAllAxes(words, isLocal ? "G52" : "G92")) {
    return;
  }
  if (isLocal) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.axes.given[axis]) {
        m_state.localOffsetMm.set(axis, lengthMm(words, axis));
      }
    }
  } else if (offset == GEffect::ResetPosition) {
    m_state.setOffsetMm = {};
    m_state.rotaryOffset = {};
  } else if (words.moves()) {
    setPosition(words);
  } else {
    return;  // G92 S: a limit of the spindle; G92 alone: nothing
  }
  m_state.baseFrame = {};
  const Vec3 offsetMm = m_state.setOffsetMm + m_state.localOffsetMm;
  if (offsetMm != Vec3{}) {
    m_state.baseFrame.translate(offsetMm);
  }
  m_position.setFrame(m_state.baseFrame);
}

/// G110, G111, G112, and CC of Heidenhain's plain text.
void Executor::setPole(const BlockWords& words) {
  constexpr int kFromPosition = 1100;
  constexpr int kFromZero = 1110;
  constexpr int kFromPole = 1120;
  const int key = words.rare->poleKey;
  const Vec3 position = programmed();
  Vec3 pole = key == kFromPosition                            ? position
              : key == kFromPole || m_language.turnsAboutPole ? m_state.poleMm
                                                              : Vec3{};
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!words.axes.given[axis]) {
      continue;
    }
    // IX of Heidenhain counts from the position, as G110 does.
    const double origin = words.axes.isIncrement[axis] ? position[axis]
                          : key != kFromZero           ? pole[axis]
                                                       : 0.0;
    pole.set(axis, origin + lengthMm(words, axis));
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
