// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the methods of [P1] share: the first N points fill the slots, the run cell starts the loop,
/// then the client watches the control and refills what has been passed. They differ in what they
/// watch. @threadsafety one object, one thread.
#pragma once

#include <vector>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

/// Beyond the shortest possible time, before a run counts as slower than planned.
inline constexpr base::Duration kLoopSlowerThanPlanned = std::chrono::milliseconds{250};

class LoopMethod : public Method {
 public:
  std::optional<Action> poll(base::Instant now) final;
  void handle(const Answer& answer, base::Instant now) final;
  void requestStop() final { m_stopWanted = true; }
  const Progress& progress() const final { return m_progress; }
  bool waitsForClient() const final { return false; }
  std::string_view adviceWhenLost() const final;
  std::string_view adviceWhenStalled() const final;

 protected:
  /// @param watched  what is read again and again
  LoopMethod(MethodSetup&& setup, std::vector<opcua::Variable> watched)
      : m_plan(std::move(setup)), m_watched(std::move(watched)) {}

  /// The loop runs. @param sent  when the run cell was written
  virtual void begun(base::Instant sent, base::Instant now) = 0;
  /// What has been read. Sets `m_refillDue` where a slot or window has been passed.
  virtual void observe(const Answer& answer, base::Instant now) = 0;
  /// Adds the points that go where the control has just passed. @return how many are new
  virtual std::size_t addRefill() = 0;
  /// True once the control is in the loop with the last point: the stop is read at its end.
  [[nodiscard]] virtual bool isInLastLoop() const = 0;
  /// True once every point has been written.
  [[nodiscard]] virtual bool hasSentAll() const = 0;

  SlotPlan m_plan;
  Progress m_progress;
  bool m_refillDue = false;
  base::Instant m_nextAccess{};  ///< when the control can have passed more, at the earliest

 private:
  enum class Phase { Fill, Run, Watch, Refill, Stop };

  [[nodiscard]] Action write(Phase phase, std::size_t points);

  std::vector<opcua::Variable> m_watched;
  Phase m_phase = Phase::Fill;
  bool m_waiting = false;  ///< an answer is outstanding
  bool m_stopWanted = false;
};

/// Methods position and signal seen from the job; a `MethodType` for each is made of its method and
/// of the place of its pauses.
class LoopMethodType : public MethodType {
 public:
  [[nodiscard]] std::vector<std::size_t> pausesBefore(std::span<const gcode::StreamPoint> points,
                                                      std::size_t pointsPerLoop,
                                                      bool place) const final;

 protected:
  /// Points after which the axes stand within a loop as well; 0: only at its end.
  [[nodiscard]] virtual std::size_t pauseWithinLoop(std::size_t pointsPerLoop) const = 0;
};

}  // namespace rivulet::streaming
