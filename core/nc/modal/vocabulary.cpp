// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/modal/vocabulary.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::nc {

GEffect effectOf(G function) {
  switch (function) {
    case G::Unknown:
      return GEffect::Unknown;
    case G::Rapid:
    case G::Line:
    case G::ArcClockwise:
    case G::ArcCounter:
      return GEffect::Motion;
    case G::Absolute:
    case G::Incremental:
    case G::AbsoluteOrTurning:
      return GEffect::Distance;
    case G::CentreAbsolute:
    case G::CentreIncremental:
      return GEffect::CentreMode;
    case G::PlaneXY:
    case G::PlaneZX:
    case G::PlaneYZ:
      return GEffect::Plane;
    case G::Inches:
    case G::Millimetres:
    case G::InchesOfLengths:
    case G::MillimetresOfLengths:
      return GEffect::Units;
    case G::FeedInverseTime:
    case G::FeedPerMinute:
    case G::FeedPerMinuteOrFacing:
    case G::FeedPerRevolution:
    case G::FeedUnknown:
      return GEffect::FeedMode;
    case G::SurfaceSpeed:
    case G::SurfaceSpeedPerMinute:
    case G::SurfaceSpeedPerRevolution:
    case G::SpindleSpeed:
    case G::SpindleSpeedPerMinute:
    case G::SpindleSpeedPerRevolution:
      return GEffect::SpindleMode;
    case G::Diameter:
    case G::Radius:
      return GEffect::Diameter;
    case G::Dwell:
      return GEffect::Dwell;
    case G::PoleFromPosition:
    case G::PoleFromZero:
    case G::PoleFromPole:
      return GEffect::Pole;
    case G::PolarOn:
    case G::PolarOff:
      return GEffect::Polar;
    case G::CubicSpline:
    case G::QuadraticSpline:
    case G::NurbsOn:
    case G::NurbsOff:
    case G::NurbsWithKnots:
      return GEffect::Spline;
    case G::Harmless:
    case G::TipLength:
    case G::RetractToStart:
    case G::RetractToR:
    case G::CornersRound:
    case G::CornersIntersect:
      return GEffect::None;
    case G::ExactStopOnce:
    case G::ExactStop:
      return GEffect::BlockEnd;
    case G::ExactPath:
    case G::Continuous:
    case G::ContinuousByDistance:
    case G::Accuracy:
      return GEffect::Tolerance;
    case G::ToolLength:
    case G::ToolLengthOff:
      return GEffect::ToolLength;
    case G::CycleOff:
      return GEffect::CycleOff;
    case G::WorkOffset:
      return GEffect::WorkOffset;
    case G::WorkOffsetP:
      return GEffect::WorkOffsetP;
    case G::MachineMove:
      return GEffect::MachineMove;
    case G::FixedPoint:
      return GEffect::FixedPoint;
    case G::SetPosition:
      return GEffect::SetPosition;
    case G::ResetPosition:
      return GEffect::ResetPosition;
    case G::SuspendPosition:
      return GEffect::SuspendPosition;
    case G::RestorePosition:
      return GEffect::RestorePosition;
    case G::LocalOffset:
      return GEffect::LocalOffset;
    case G::Turn:
      return GEffect::Turn;
    case G::TurnOff:
      return GEffect::TurnOff;
    case G::Scale:
      return GEffect::Scale;
    case G::ScaleOff:
      return GEffect::ScaleOff;
    case G::Mirror:
      return GEffect::Mirror;
    case G::MirrorOff:
      return GEffect::MirrorOff;
    case G::SetWorkOffset:
      return GEffect::SetWorkOffset;
    case G::MacroCall:
      return GEffect::MacroCall;
    case G::ModalMacro:
      return GEffect::ModalMacro;
    case G::ModalMacroOff:
      return GEffect::ModalMacroOff;
    case G::CompensationOff:
    case G::CompensationLeft:
    case G::CompensationRight:
      return GEffect::Compensation;
    case G::Mode:
      return GEffect::Mode;
    case G::MotionMode:
      return GEffect::MotionMode;
    case G::Cycle:
      return GEffect::Cycle;
    case G::TakesBlock:
      return GEffect::TakesBlock;
    case G::TurningCycle:
      return GEffect::TurningCycle;
  }
  base::contractViolated("every G function has an effect", __FILE__, __LINE__);
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
