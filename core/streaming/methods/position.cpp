// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/position.h"

namespace rivulet::streaming {

namespace {

/// Beyond the shortest possible time, before a run counts as slower than planned.
constexpr base::Duration kSlowerThanPlanned = std::chrono::milliseconds{250};

}  // namespace

PositionMethod::PositionMethod(MethodSetup setup) : m_plan(std::move(setup)) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_watched[axis] = {opcua::VariableKind::ActualPosition, static_cast<int>(axis)};
  }
}

Action PositionMethod::write(Phase phase, std::size_t points) {
  m_phase = phase;
  m_waiting = true;
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

std::optional<Action> PositionMethod::poll(base::Instant) {
  if (m_waiting) {
    return std::nullopt;
  }
  m_plan.clearWrites();
  if (m_phase == Phase::Fill) {
    m_plan.addFirstLoop();
    return write(Phase::Fill, std::min(m_plan.slotCount(), m_plan.pointCount()));
  }
  if (m_phase == Phase::Run) {
    m_plan.addCell(m_plan.cells().run, 1.0);
    return write(Phase::Run, 0);
  }
  // Not before the first point of the last loop: a program that still waits for its start would
  // take the stop for an end.
  const bool lastLoopRuns = m_due > m_plan.lastLoop() * m_plan.slotCount();
  if (!m_progress.stopWritten && (m_stopWanted || lastLoopRuns)) {
    m_progress.stopWritten = true;
    m_plan.addCell(m_plan.cells().stop, 1.0);
    return write(Phase::Stop, 0);
  }
  if (m_refillDue) {
    m_refillDue = false;
    // The point that has just been passed was m_due - 1; its slot is due again one loop later.
    const std::size_t index = m_due - 1 + m_plan.slotCount();
    m_plan.addPoint(index);
    return write(Phase::Refill, index < m_plan.pointCount() ? 1 : 0);
  }
  m_phase = Phase::Watch;
  m_waiting = true;
  return Action{Action::Kind::Read, m_watched, {}, 0};
}

void PositionMethod::handle(const Answer& answer, base::Instant now) {
  RIVULET_ASSERT(m_waiting);
  m_waiting = false;
  switch (m_phase) {
    case Phase::Fill:
      m_phase = Phase::Run;
      break;
    case Phase::Run:
      m_progress.lastProgress = now;
      m_progress.nextEarliest = now;
      m_progress.nextLatest = now + m_plan.approachTime() + kSlowerThanPlanned;
      m_phase = Phase::Watch;
      break;
    case Phase::Watch:
      observe(answer, now);
      break;
    case Phase::Refill:
      m_progress.nextEarliest = m_nextPointEarliest;
      break;
    case Phase::Stop:
      break;
  }
  m_progress.allSent = m_due + m_plan.slotCount() > m_plan.pointCount();
}

void PositionMethod::observe(const Answer& answer, base::Instant now) {
  base::Vec3 toolMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    toolMm.set(axis, answer.readings[axis].number);
  }
  m_positionMm = toolMm;
  double distanceMm = base::distance(toolMm, m_plan.pointMm(m_due));
  if (m_due < m_plan.pointCount() && distanceMm < m_plan.settings().deltaMm) {
    ++m_due;
    m_refillDue = true;
    m_progress.executed = m_due;
    m_progress.lastProgress = now;
    if (m_due % m_plan.slotCount() == 0) {
      ++m_progress.stopsPassed;
    }
    // Only progress moves this limit: a tool that circles through old points is late.
    distanceMm = base::distance(m_plan.pointMm(m_due - 1), m_plan.pointMm(m_due));
    m_progress.nextLatest = now + m_plan.travelTime(m_due - 1, m_due) + kSlowerThanPlanned;
  }
  // The position was valid at some time after the request was sent; at the feed the tool cannot
  // be within δ of the point due any sooner than this.
  const double freeMm = std::max(0.0, distanceMm - 2.0 * m_plan.settings().deltaMm);
  m_nextPointEarliest = answer.sent + base::fromSeconds(freeMm / m_plan.settings().feedMmPerS);
  // A refill is due at once: no read for the display may go in front of it.
  m_progress.nextEarliest = m_refillDue ? now : m_nextPointEarliest;
}

}  // namespace rivulet::streaming
