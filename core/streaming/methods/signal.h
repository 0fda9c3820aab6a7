// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method 2 of [P1]: the program sets a signal cell when it has passed one of its two windows
/// (0: the first ⌊N/2⌋ slots, 1: the rest); the client refills that window and answers 2. Kept as
/// published, with its hazards: a late client lets the control run an old window again, and a
/// signal can be overwritten before it is seen.
/// @source [P1] Algorithm III, with its slices read as meant: signal 0 refills the first ⌊N/2⌋
/// slots, signal 1 the remaining N-⌊N/2⌋. @threadsafety one object, one thread.
#pragma once

#include <array>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

class SignalMethod final : public Method {
 public:
  explicit SignalMethod(MethodSetup setup);

  std::optional<Action> poll(base::Instant now) override;
  void handle(const Answer& answer, base::Instant now) override;
  void requestStop() override { m_stopWanted = true; }
  const Progress& progress() const override { return m_progress; }

 private:
  enum class Phase { Fill, Run, Watch, Refill, Stop };

  void observe(const Answer& answer, base::Instant now);
  [[nodiscard]] Action write(Phase phase, std::size_t points);
  [[nodiscard]] std::size_t windowSize(std::size_t window) const;
  /// Number of points in front of a window, counting windows from the start of the run.
  [[nodiscard]] std::size_t windowBegin(std::size_t window) const;

  SlotPlan m_plan;
  std::array<opcua::Variable, 1> m_watched;
  Phase m_phase = Phase::Fill;
  bool m_waiting = false;
  bool m_stopWanted = false;
  bool m_refillDue = false;
  base::Instant m_nextSignalEarliest{};  ///< of the window the control is in
  std::size_t m_passed = 0;              ///< windows the control has signalled
  Progress m_progress;
};

}  // namespace rivulet::streaming
