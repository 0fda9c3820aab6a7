// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/loop.h"

namespace rivulet::streaming {

using templates::LoopProtocol;

Action LoopMethod::write(Phase phase, std::size_t points) {
  m_phase = phase;
  m_waiting = true;
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

std::optional<Action> LoopMethod::poll(base::Instant) {
  if (m_waiting) {
    return std::nullopt;
  }
  m_plan.clearWrites();
  if (m_phase == Phase::Fill) {
    m_plan.addFirstLoop();
    return write(Phase::Fill, std::min(m_plan.slotCount(), m_plan.pointCount()));
  }
  if (m_phase == Phase::Run) {
    m_plan.addCell(m_plan.cells().run, LoopProtocol::kRun);
    return write(Phase::Run, 0);
  }
  // Not before the last loop: a program that is still waiting for its start would take the stop as
  // its end.
  if (!m_progress.stopWritten && (m_stopWanted || isInLastLoop())) {
    m_progress.stopWritten = true;
    m_plan.addCell(m_plan.cells().stop, LoopProtocol::kStop);
    return write(Phase::Stop, 0);
  }
  if (m_refillDue) {
    m_refillDue = false;
    return write(Phase::Refill, addRefill());
  }
  m_phase = Phase::Watch;
  m_waiting = true;
  return Action{Action::Kind::Read, m_watched, {}, 0};
}

void LoopMethod::handle(const Answer& answer, base::Instant now) {
  RIVULET_ASSERT(m_waiting);
  m_waiting = false;
  switch (m_phase) {
    case Phase::Fill:
      m_phase = Phase::Run;
      break;
    case Phase::Run:
      m_progress.lastProgress = now;
      begun(answer.sent, now);
      m_phase = Phase::Watch;
      break;
    case Phase::Watch:
      observe(answer, now);
      break;
    case Phase::Refill:
      m_progress.expected.set(Expectation::Access, m_nextAccess);
      break;
    case Phase::Stop:
      break;
  }
  m_progress.allSent = hasSentAll();
}

std::string_view LoopMethod::adviceWhenLost() const {
  return "The control continues with the points it has and repeats them: stop the program at the "
         "control.";
}

std::string_view LoopMethod::adviceWhenStalled() const {
  return "The stream made no progress although the program was active: a point or a signal was "
         "missed and old points were repeated, or the control was on hold. See the report, then "
         "reduce the feed or release the hold.";
}

std::vector<std::size_t> LoopMethodType::pausesBefore(std::span<const gcode::StreamPoint> points,
                                                      std::size_t pointsPerLoop,
                                                      WindowCut /*cut*/) const {
  const std::size_t within = pauseWithinLoop(pointsPerLoop);
  std::vector<std::size_t> pauses;
  for (std::size_t loop = 0; loop < points.size(); loop += pointsPerLoop) {
    pauses.push_back(loop);
    if (within > 0) {
      pauses.push_back(loop + within);
    }
  }
  return pauses;
}

}  // namespace rivulet::streaming
