// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/position.h"

namespace rivulet::streaming {

namespace {

/// The distance of an axis has grown by more than this: another block is in motion. Less is the
/// rounded end of the same block, where the tool leaves its line by up to 0.01 mm on `dmu75`.
constexpr double kGrownMm = 0.02;

std::vector<opcua::Variable> watchedBy(const RunSettings& settings) {
  const opcua::VariableKind kind = settings.passedBy == PassedBy::DistanceToGo
                                       ? opcua::VariableKind::DistanceToGo
                                       : opcua::VariableKind::ActualPosition;
  std::vector<opcua::Variable> watched;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    watched.push_back({kind, static_cast<int>(axis)});
  }
  return watched;
}

base::Vec3 vectorOf(const Answer& answer) {
  base::Vec3 mm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    mm.set(axis, answer.readings[axis].number);
  }
  return mm;
}

}  // namespace

PositionMethod::PositionMethod(MethodSetup setup)
    : LoopMethod(std::move(setup), watchedBy(setup.settings)),
      m_watchesDistance(m_plan.settings().passedBy == PassedBy::DistanceToGo) {
}

void PositionMethod::begun(base::Instant /*sent*/, base::Instant now) {
  m_progress.expected.set(Expectation::Access, now);
  m_progress.expected.set(Expectation::Progress,
                          now + m_plan.approachTime() + kLoopSlowerThanPlanned);
}

std::size_t PositionMethod::addRefill() {
  // The point that has just been passed was m_due - 1; its slot is due again one loop later.
  const std::size_t index = m_due - 1 + m_plan.slotCount();
  m_plan.addPoint(index);
  return index < m_plan.pointCount() ? 1 : 0;
}

bool PositionMethod::isInLastLoop() const {
  return m_due > m_plan.lastLoop() * m_plan.slotCount();
}

void PositionMethod::advance(base::Instant now) {
  ++m_due;
  m_refillDue = true;
  m_progress.executed = m_due;
  m_progress.lastProgress = now;
  if (m_due % m_plan.slotCount() == 0) {
    ++m_progress.stopsPassed;
  }
  // Only progress moves this limit: a tool that circles through old points is late.
  m_progress.expected.set(Expectation::Progress,
                          now + m_plan.travelTime(m_due - 1, m_due) + kLoopSlowerThanPlanned);
}

double PositionMethod::seePosition(const Answer& answer, base::Instant now) {
  const base::Vec3 toolMm = vectorOf(answer);
  m_positionMm = toolMm;
  const double distanceMm = base::distance(toolMm, m_plan.pointMm(m_due));
  if (m_due < m_plan.pointCount() && distanceMm < m_plan.settings().deltaMm) {
    advance(now);
    return base::distance(m_plan.pointMm(m_due - 1), m_plan.pointMm(m_due));
  }
  return distanceMm;
}

bool PositionMethod::isNewBlock(base::Vec3 toGoMm) {
  // Axes before the first that grew at the read before belong to the same change of blocks.
  std::size_t first = base::kAxisCount;
  bool isNew = false;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double distanceMm = std::abs(toGoMm[axis]);
    if (distanceMm > m_toGoMm[axis] + kGrownMm) {
      first = std::min(first, axis);
      isNew = isNew || axis >= m_grownFrom;
    }
    m_toGoMm[axis] = distanceMm;
  }
  m_grownFrom = isNew ? first : 0;
  return isNew;
}

double PositionMethod::seeDistanceToGo(const Answer& answer, base::Instant now) {
  const base::Vec3 toGoMm = vectorOf(answer);
  const double distanceMm = base::norm(toGoMm);
  m_isBlockCounted = !isNewBlock(toGoMm) && m_isBlockCounted;
  if (m_due < m_plan.pointCount() && !m_isBlockCounted && distanceMm < m_plan.settings().deltaMm) {
    m_isBlockCounted = true;
    advance(now);
  }
  if (!m_isBlockCounted || m_due == 0) {
    return distanceMm;
  }
  return distanceMm + base::distance(m_plan.pointMm(m_due - 1), m_plan.pointMm(m_due));
}

void PositionMethod::observe(const Answer& answer, base::Instant now) {
  const double distanceMm =
      m_watchesDistance ? seeDistanceToGo(answer, now) : seePosition(answer, now);
  // What was read was valid at some time after the request was sent; at the feed the tool cannot be
  // within δ of the point due any sooner than this.
  const double freeMm = std::max(0.0, distanceMm - 2.0 * m_plan.settings().deltaMm);
  m_nextAccess = answer.sent + base::fromSeconds(freeMm / m_plan.settings().feedMmPerS);
  // A refill is due at once: no read for the display may go in front of it.
  m_progress.expected.set(Expectation::Access, m_refillDue ? now : m_nextAccess);
}

std::unique_ptr<Method> PositionMethodType::make(MethodSetup setup) const {
  return std::make_unique<PositionMethod>(std::move(setup));
}

}  // namespace rivulet::streaming
