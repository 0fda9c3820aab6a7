// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method 1 of [P1]: watch the tool; when it is within δ of the point due, put the next point of
/// the list into that point's slot. Kept as published, with its hazards: a point that is passed
/// between two reads is waited for for ever while the control repeats its loop.
/// @source [P1] Algorithm II. @threadsafety one object, one thread.
#pragma once

#include <array>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

class PositionMethod final : public Method {
 public:
  explicit PositionMethod(MethodSetup setup);

  std::optional<Action> poll(base::Instant now) override;
  void handle(const Answer& answer, base::Instant now) override;
  void requestStop() override { m_stopWanted = true; }
  const Progress& progress() const override { return m_progress; }
  std::optional<base::Vec3> positionMm() const override { return m_positionMm; }

 private:
  enum class Phase { Fill, Run, Watch, Refill, Stop };

  void observe(const Answer& answer, base::Instant now);
  [[nodiscard]] Action write(Phase phase, std::size_t points);

  SlotPlan m_plan;
  std::array<opcua::Variable, base::kAxisCount> m_watched;
  Phase m_phase = Phase::Fill;
  bool m_waiting = false;  ///< an answer is outstanding
  bool m_stopWanted = false;
  bool m_refillDue = false;
  base::Instant m_nextPointEarliest{};  ///< when the tool can be at the point due
  std::size_t m_due = 0;                ///< index of the point the tool is on its way to
  std::optional<base::Vec3> m_positionMm;
  Progress m_progress;
};

}  // namespace rivulet::streaming
