// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/signal.h"

#include <cmath>

namespace rivulet::streaming {

namespace {

constexpr double kFirstPassed = 0.0;
constexpr double kSecondPassed = 1.0;
constexpr double kRefilled = 2.0;
constexpr base::Duration kSlowerThanPlanned = std::chrono::milliseconds{250};

}  // namespace

SignalMethod::SignalMethod(MethodSetup setup)
    : m_plan(std::move(setup)), m_watched{opcua::rParameter(m_plan.cells().signal)} {
}

std::size_t SignalMethod::windowSize(std::size_t window) const {
  const std::size_t first = m_plan.slotCount() / 2;
  return window % 2 == 0 ? first : m_plan.slotCount() - first;
}

std::size_t SignalMethod::windowBegin(std::size_t window) const {
  return window / 2 * m_plan.slotCount() + (window % 2 == 0 ? 0 : m_plan.slotCount() / 2);
}

Action SignalMethod::write(Phase phase, std::size_t points) {
  m_phase = phase;
  m_waiting = true;
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

std::optional<Action> SignalMethod::poll(base::Instant) {
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
  // The stop is read at the end of a loop: written while the second window of the last loop
  // runs, that is once its first window has been signalled.
  const bool lastLoopRuns = m_passed > 2 * m_plan.lastLoop();
  if (!m_progress.stopWritten && (m_stopWanted || lastLoopRuns)) {
    m_progress.stopWritten = true;
    m_plan.addCell(m_plan.cells().stop, 1.0);
    return write(Phase::Stop, 0);
  }
  if (m_refillDue) {
    m_refillDue = false;
    // The window passed last is due again two windows later.
    const std::size_t window = m_passed + 1;
    const std::size_t begin = windowBegin(window);
    const std::size_t end = begin + windowSize(window);
    for (std::size_t index = begin; index < end; ++index) {
      m_plan.addPoint(index);
    }
    m_plan.addCell(m_plan.cells().signal, kRefilled);
    const std::size_t count = m_plan.pointCount();
    return write(Phase::Refill, std::min(end, count) - std::min(begin, count));
  }
  m_phase = Phase::Watch;
  m_waiting = true;
  return Action{Action::Kind::Read, m_watched, {}, 0};
}

void SignalMethod::handle(const Answer& answer, base::Instant now) {
  RIVULET_ASSERT(m_waiting);
  m_waiting = false;
  switch (m_phase) {
    case Phase::Fill:
      m_phase = Phase::Run;
      break;
    case Phase::Run:
      m_progress.lastProgress = now;
      m_progress.nextEarliest =
          answer.sent + m_plan.approachTime() + m_plan.travelTime(0, windowSize(0) - 1);
      m_progress.nextLatest = m_progress.nextEarliest + kSlowerThanPlanned;
      m_phase = Phase::Watch;
      break;
    case Phase::Watch:
      observe(answer, now);
      break;
    case Phase::Refill:
      m_progress.nextEarliest = m_nextSignalEarliest;
      break;
    case Phase::Stop:
      break;
  }
  m_progress.allSent = windowBegin(m_passed + 2) >= m_plan.pointCount();
}

void SignalMethod::observe(const Answer& answer, base::Instant now) {
  const double signal = answer.readings[0].number;
  if (signal != kFirstPassed && signal != kSecondPassed) {
    return;
  }
  const std::size_t expected = m_passed % 2;
  const bool inTurn = signal == static_cast<double>(expected);
  if (!inTurn) {
    // Algorithm III does not ask whether the signals alternate: it refills what the cell names.
    // A signal out of turn means that one was lost and a window has been executed twice.
    ++m_progress.brokenSignals;
    ++m_passed;
  }
  ++m_passed;
  m_refillDue = true;
  ++m_progress.stopsPassed;
  m_progress.executed = std::min(windowBegin(m_passed), m_plan.pointCount());
  m_progress.lastProgress = now;
  // The control is in the window after the one it has signalled. It entered that window after
  // the request was sent at the earliest, and at the feed it cannot reach its end any sooner.
  const base::Duration travel = m_plan.travelTime(
      std::max<std::size_t>(windowBegin(m_passed), 1) - 1, windowBegin(m_passed + 1) - 1);
  m_nextSignalEarliest = answer.sent - m_plan.settings().accessTime * 2 + travel;
  // The refill is due at once: no read for the display may go in front of it.
  m_progress.nextEarliest = now;
  m_progress.nextLatest = now + travel + kSlowerThanPlanned;
}

}  // namespace rivulet::streaming
