// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method 1 of [P1]: when the tool is within δ of the point due, put the next point of the list
/// into that point's slot. Kept as published, with its hazards: a point that is passed between two
/// reads is missed, and the control repeats old points.
///
/// [P1] III names two ways to see that a point has been reached. With `PassedBy::Position` the
/// tool's position is compared with the point. With `PassedBy::DistanceToGo` the distance to the
/// end of the block in motion is compared with δ, as Algorithm II has it. @deviation Algorithm II
/// does not say how a block is told from the one before. Here a block counts once: the distance has
/// to grow before it can count again. It is 0 before the first motion and at each STOPRE, so the
/// client waits for motion there too.
/// @source [P1] Algorithm II. @threadsafety one object, one thread.
#pragma once

#include <array>

#include "streaming/methods/loop.h"

namespace rivulet::streaming {

class PositionMethod final : public LoopMethod {
 public:
  explicit PositionMethod(MethodSetup setup);

  std::optional<base::Vec3> positionMm() const override { return m_positionMm; }
  bool readsPosition() const override { return !m_watchesDistance; }

 private:
  void begun(base::Instant sent, base::Instant now) override;
  void observe(const Answer& answer, base::Instant now) override;
  std::size_t addRefill() override;
  bool isInLastLoop() const override;
  bool hasSentAll() const override { return m_due + m_plan.slotCount() > m_plan.pointCount(); }

  /// The point due has been passed.
  void advance(base::Instant now);
  /// Shortest way to where the point due counts as passed, δ not subtracted.
  [[nodiscard]] double seePosition(const Answer& answer, base::Instant now);
  [[nodiscard]] double seeDistanceToGo(const Answer& answer, base::Instant now);

  bool m_watchesDistance;
  std::size_t m_due = 0;  ///< index of the point the tool is on its way to
  std::optional<base::Vec3> m_positionMm;
  /// Notes the distances. @return true if another block is in motion than at the read before
  [[nodiscard]] bool isNewBlock(base::Vec3 toGoMm);

  std::array<double, base::kAxisCount> m_toGoMm{};  ///< as read last; 0 before the first motion
  std::size_t m_grownFrom = 0;   ///< first axis that grew at the last read; 0: all, or none
  bool m_isBlockCounted = true;  ///< the block in motion has been counted
};

class PositionMethodType final : public LoopMethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;

 private:
  [[nodiscard]] std::size_t pauseWithinLoop(std::size_t) const override { return 0; }
};

}  // namespace rivulet::streaming
