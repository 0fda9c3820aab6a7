// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/modal/vocabulary.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::nc {

namespace {

struct EffectRow {
  G function;
  GEffect effect;
};

// In the order of G.
constexpr std::array kEffects{
    EffectRow{G::Unknown, GEffect::Unknown},
    EffectRow{G::Rapid, GEffect::Motion},
    EffectRow{G::Line, GEffect::Motion},
    EffectRow{G::ArcClockwise, GEffect::Motion},
    EffectRow{G::ArcCounter, GEffect::Motion},
    EffectRow{G::Absolute, GEffect::Distance},
    EffectRow{G::Incremental, GEffect::Distance},
    EffectRow{G::AbsoluteOrTurning, GEffect::Distance},
    EffectRow{G::CentreAbsolute, GEffect::CentreMode},
    EffectRow{G::CentreIncremental, GEffect::CentreMode},
    EffectRow{G::PlaneXY, GEffect::Plane},
    EffectRow{G::PlaneZX, GEffect::Plane},
    EffectRow{G::PlaneYZ, GEffect::Plane},
    EffectRow{G::Inches, GEffect::Units},
    EffectRow{G::Millimetres, GEffect::Units},
    EffectRow{G::InchesOfLengths, GEffect::Units},
    EffectRow{G::MillimetresOfLengths, GEffect::Units},
    EffectRow{G::FeedInverseTime, GEffect::FeedMode},
    EffectRow{G::FeedPerMinute, GEffect::FeedMode},
    EffectRow{G::FeedPerMinuteOrFacing, GEffect::FeedMode},
    EffectRow{G::FeedPerRevolution, GEffect::FeedMode},
    EffectRow{G::FeedUnknown, GEffect::FeedMode},
    EffectRow{G::SurfaceSpeed, GEffect::SpindleMode},
    EffectRow{G::SurfaceSpeedPerMinute, GEffect::SpindleMode},
    EffectRow{G::SurfaceSpeedPerRevolution, GEffect::SpindleMode},
    EffectRow{G::SpindleSpeed, GEffect::SpindleMode},
    EffectRow{G::SpindleSpeedPerMinute, GEffect::SpindleMode},
    EffectRow{G::SpindleSpeedPerRevolution, GEffect::SpindleMode},
    EffectRow{G::Diameter, GEffect::Diameter},
    EffectRow{G::Radius, GEffect::Diameter},
    EffectRow{G::Dwell, GEffect::Dwell},
    EffectRow{G::PoleFromPosition, GEffect::Pole},
    EffectRow{G::PoleFromZero, GEffect::Pole},
    EffectRow{G::PoleFromPole, GEffect::Pole},
    EffectRow{G::PolarOn, GEffect::Polar},
    EffectRow{G::PolarOff, GEffect::Polar},
    EffectRow{G::CubicSpline, GEffect::Spline},
    EffectRow{G::QuadraticSpline, GEffect::Spline},
    EffectRow{G::NurbsOn, GEffect::Spline},
    EffectRow{G::NurbsOff, GEffect::Spline},
    EffectRow{G::NurbsWithKnots, GEffect::Spline},
    EffectRow{G::Harmless, GEffect::None},
    EffectRow{G::TipLength, GEffect::None},
    EffectRow{G::RetractToStart, GEffect::None},
    EffectRow{G::RetractToR, GEffect::None},
    EffectRow{G::CornersRound, GEffect::None},
    EffectRow{G::CornersIntersect, GEffect::None},
    EffectRow{G::ExactStopOnce, GEffect::BlockEnd},
    EffectRow{G::ExactStop, GEffect::BlockEnd},
    EffectRow{G::ExactPath, GEffect::Tolerance},
    EffectRow{G::Continuous, GEffect::Tolerance},
    EffectRow{G::ContinuousByDistance, GEffect::Tolerance},
    EffectRow{G::Accuracy, GEffect::Tolerance},
    EffectRow{G::ToolLength, GEffect::ToolLength},
    EffectRow{G::ToolLengthOff, GEffect::ToolLength},
    EffectRow{G::CycleOff, GEffect::CycleOff},
    EffectRow{G::WorkOffset, GEffect::WorkOffset},
    EffectRow{G::WorkOffsetP, GEffect::WorkOffsetP},
    EffectRow{G::MachineMove, GEffect::MachineMove},
    EffectRow{G::FixedPoint, GEffect::FixedPoint},
    EffectRow{G::SetPosition, GEffect::SetPosition},
    EffectRow{G::ResetPosition, GEffect::ResetPosition},
    EffectRow{G::SuspendPosition, GEffect::SuspendPosition},
    EffectRow{G::RestorePosition, GEffect::RestorePosition},
    EffectRow{G::LocalOffset, GEffect::LocalOffset},
    EffectRow{G::Turn, GEffect::Turn},
    EffectRow{G::TurnOff, GEffect::TurnOff},
    EffectRow{G::Scale, GEffect::Scale},
    EffectRow{G::ScaleOff, GEffect::ScaleOff},
    EffectRow{G::Mirror, GEffect::Mirror},
    EffectRow{G::MirrorOff, GEffect::MirrorOff},
    EffectRow{G::SetWorkOffset, GEffect::SetWorkOffset},
    EffectRow{G::MacroCall, GEffect::MacroCall},
    EffectRow{G::ModalMacro, GEffect::ModalMacro},
    EffectRow{G::ModalMacroOff, GEffect::ModalMacroOff},
    EffectRow{G::CompensationOff, GEffect::Compensation},
    EffectRow{G::CompensationLeft, GEffect::Compensation},
    EffectRow{G::CompensationRight, GEffect::Compensation},
    EffectRow{G::Mode, GEffect::Mode},
    EffectRow{G::MotionMode, GEffect::MotionMode},
    EffectRow{G::Cycle, GEffect::Cycle},
    EffectRow{G::TakesBlock, GEffect::TakesBlock},
    EffectRow{G::TurningCycle, GEffect::TurningCycle},
};

constexpr bool everyFunctionHasItsRow() {
  for (std::size_t i = 0; i < kEffects.size(); ++i) {
    if (kEffects[i].function != static_cast<G>(i)) {
      return false;
    }
  }
  return kEffects.back().function == G::TurningCycle;
}
static_assert(everyFunctionHasItsRow());

}  // namespace

GEffect effectOf(G function) {
  const auto index = static_cast<std::size_t>(function);
  RIVULET_ASSERT(index < kEffects.size());
  return kEffects[index].effect;
}

GTable::GTable(std::span<const GRow> rows, std::span<const GRow> lathe)
    : m_rows{GRow{}}, m_lathe(lathe.begin(), lathe.end()), m_index(kGKeys, 0) {
  for (const GRow& row : rows) {
    m_index[static_cast<std::size_t>(row.key)] = static_cast<std::uint8_t>(m_rows.size());
    m_rows.push_back(row);
    m_rows.back().effect = effectOf(row.function);
  }
  for (GRow& row : m_lathe) {
    row.effect = effectOf(row.function);
  }
}

const GRow& GTable::latheRow(std::size_t key) const {
  const auto found = std::find_if(m_lathe.begin(), m_lathe.end(), [key](const GRow& row) {
    return static_cast<std::size_t>(row.key) == key;
  });
  return found == m_lathe.end() ? row(key) : *found;
}

}  // namespace rivulet::nc
