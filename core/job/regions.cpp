// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/regions.h"

#include <algorithm>
#include <array>
#include <limits>

namespace rivulet::job {

namespace {

/// What a word does to the regions.
enum class Effect : unsigned char {
  Transforms,
  TransformsNoMore,
  Curve,
  Corner,
  ModalCorner,  ///< its end is a value: taken to stay
  Compensates,
};

struct Word {
  std::string_view name;
  Effect effect;
};
constexpr std::array kWords{Word{"TRAORI", Effect::Transforms},
                            Word{"TRANSMIT", Effect::Transforms},
                            Word{"TRACYL", Effect::Transforms},
                            Word{"TRAANG", Effect::Transforms},
                            Word{"TRACON", Effect::Transforms},
                            Word{"TRAFOON", Effect::Transforms},
                            Word{"ROTS", Effect::Transforms},
                            Word{"AROTS", Effect::Transforms},
                            Word{"TOFRAME", Effect::Transforms},
                            Word{"TOFRAMEX", Effect::Transforms},
                            Word{"TOFRAMEY", Effect::Transforms},
                            Word{"TOFRAMEZ", Effect::Transforms},
                            Word{"TOROT", Effect::Transforms},
                            Word{"PAROT", Effect::Transforms},
                            Word{"GEOAX", Effect::Transforms},
                            Word{"TRAFOOF", Effect::TransformsNoMore},
                            Word{"TOROTOF", Effect::TransformsNoMore},
                            Word{"PAROTOF", Effect::TransformsNoMore},
                            Word{"ASPLINE", Effect::Curve},
                            Word{"CSPLINE", Effect::Curve},
                            Word{"POLY", Effect::Curve},
                            Word{"RND", Effect::Corner},
                            Word{"RNDM", Effect::ModalCorner},
                            Word{"CHF", Effect::Corner},
                            Word{"CHR", Effect::Corner},
                            Word{",R", Effect::Corner},
                            Word{",C", Effect::Corner},
                            Word{"G41", Effect::Compensates},
                            Word{"G42", Effect::Compensates},
                            Word{"G41.1", Effect::Compensates},
                            Word{"G42.1", Effect::Compensates},
                            Word{"RL", Effect::Compensates},
                            Word{"RR", Effect::Compensates}};

}  // namespace

std::optional<NativeReason> Regions::reason() const {
  if (m_transforms) {
    return NativeReason::Transformation;
  }
  if (m_compensation != Compensation::Off) {
    return NativeReason::RadiusCompensation;
  }
  if (m_modalCall) {
    return NativeReason::Cycle;
  }
  if (m_curve) {
    return NativeReason::OtherMotion;
  }
  return m_cornerMotions > 0 ? std::optional(NativeReason::Corner) : std::nullopt;
}

void Regions::word(std::string_view name, bool isEmptyCall) {
  if (name == "CYCLE800") {
    m_transforms = !isEmptyCall;
    return;
  }
  const auto* const found = std::find_if(kWords.begin(), kWords.end(),
                                         [name](const Word& each) { return each.name == name; });
  if (found == kWords.end()) {
    return;
  }
  switch (found->effect) {
    case Effect::Transforms:
    case Effect::TransformsNoMore:
      m_transforms = found->effect == Effect::Transforms;
      break;
    case Effect::Curve:
      m_curve = true;
      break;
    case Effect::Corner:
      m_cornerMotions = 2;
      break;
    case Effect::ModalCorner:
      m_cornerMotions = std::numeric_limits<int>::max();
      break;
    case Effect::Compensates:
      m_compensation = Compensation::On;
      break;
  }
}

void Regions::compensationOff() {
  if (m_compensation == Compensation::On) {
    m_compensation = Compensation::Leaving;
  }
}

void Regions::blockExecuted(const nc::BlockWords& words, const nc::ModalState& state) {
  const bool movesInPlane = words.axes.has(state.planeFirstAxis) ||
                            words.axes.has(state.planeSecondAxis()) || words.hasAnyCentre();
  // The tool returns to the programmed path with the next motion in the plane.
  if (m_compensation == Compensation::Leaving && movesInPlane) {
    m_compensation = Compensation::Off;
  }
  m_curve = m_curve && words.g.motion == nullptr;
  if (m_cornerMotions > 0 && (words.moves() || words.hasAnyCentre())) {
    --m_cornerMotions;
  }
}

}  // namespace rivulet::job
