// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/signal.h"

namespace rivulet::streaming {

using templates::LoopProtocol;

SignalMethod::SignalMethod(MethodSetup setup)
    : LoopMethod(std::move(setup), {opcua::rParameter(setup.cells.signal)}) {
}

std::size_t SignalMethod::windowSize(std::size_t window) const {
  const std::size_t first = m_plan.slotCount() / 2;
  return window % 2 == 0 ? first : m_plan.slotCount() - first;
}

std::size_t SignalMethod::windowBegin(std::size_t window) const {
  return window / 2 * m_plan.slotCount() + (window % 2 == 0 ? 0 : m_plan.slotCount() / 2);
}

void SignalMethod::begun(base::Instant sent, base::Instant /*now*/) {
  const base::Instant first =
      sent + m_plan.approachTime() + m_plan.travelTime(0, windowSize(0) - 1);
  m_progress.expected.set(Expectation::Access, first);
  m_progress.expected.set(Expectation::Progress, first + kLoopSlowerThanPlanned);
}

std::size_t SignalMethod::addRefill() {
  // The window just passed is due again two windows later.
  const std::size_t window = m_passed + 1;
  const std::size_t begin = windowBegin(window);
  const std::size_t end = begin + windowSize(window);
  for (std::size_t index = begin; index < end; ++index) {
    m_plan.addPoint(index);
  }
  m_plan.addCell(m_plan.cells().signal, LoopProtocol::kRefilled);
  const std::size_t count = m_plan.pointCount();
  return std::min(end, count) - std::min(begin, count);
}

void SignalMethod::observe(const Answer& answer, base::Instant now) {
  const double signal = answer.readings[0].number;
  if (signal != LoopProtocol::kFirstPassed && signal != LoopProtocol::kSecondPassed) {
    return;
  }
  const std::size_t expected = m_passed % 2;
  const bool inTurn = signal == static_cast<double>(expected);
  if (!inTurn) {
    // Algorithm III does not check whether the signals alternate: it refills the window that the
    // cell names. A signal out of sequence means that one was lost and a window has been executed
    // twice.
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
  m_nextAccess = answer.sent - m_plan.settings().accessTime * 2 + travel;
  // The refill is due at once: no read for the display may go before it.
  m_progress.expected.set(Expectation::Access, now);
  m_progress.expected.set(Expectation::Progress, now + travel + kLoopSlowerThanPlanned);
}

std::unique_ptr<Method> SignalMethodType::make(MethodSetup setup) const {
  return std::make_unique<SignalMethod>(std::move(setup));
}

}  // namespace rivulet::streaming
