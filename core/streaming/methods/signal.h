// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method 2 of [P1]: the program sets a signal cell when it has passed one of its two windows (0:
/// the first ⌊N/2⌋ slots, 1: the rest); the client refills that window and answers 2. Kept as
/// published, with its hazards: a late client makes the control execute an old window again, and a
/// signal can be overwritten before it is seen.
/// @source [P1] Algorithm III, with its slices read as meant: signal 0 refills the first ⌊N/2⌋
/// slots, signal 1 the remaining N-⌊N/2⌋. @threadsafety one object, one thread.
#pragma once

#include "streaming/methods/loop.h"

namespace rivulet::streaming {

class SignalMethod final : public LoopMethod {
 public:
  explicit SignalMethod(MethodSetup setup);

 private:
  void begun(base::Instant sent, base::Instant now) override;
  void observe(const Answer& answer, base::Instant now) override;
  std::size_t addRefill() override;
  bool isInLastLoop() const override { return m_passed > 2 * m_plan.lastLoop(); }
  bool hasSentAll() const override { return windowBegin(m_passed + 2) >= m_plan.pointCount(); }

  [[nodiscard]] std::size_t windowSize(std::size_t window) const;
  /// Number of points before a window, counting windows from the start of the run.
  [[nodiscard]] std::size_t windowBegin(std::size_t window) const;

  std::size_t m_passed = 0;  ///< windows the control has signalled
};

class SignalMethodType final : public LoopMethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;

 private:
  [[nodiscard]] std::size_t pauseWithinLoop(std::size_t pointsPerLoop) const override {
    return pointsPerLoop / 2;
  }
};

}  // namespace rivulet::streaming
