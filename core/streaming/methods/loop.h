// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Common to the methods of [P1]: the first N points fill the slots, the run cell starts the loop,
/// then the client watches the control and refills the slots that have been passed. The methods
/// differ in what they watch. @threadsafety one object, one thread.
#pragma once

#include <vector>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

/// Time in addition to the shortest possible time before a run counts as slower than planned.
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
  /// @param watched  the variables that are polled
  LoopMethod(MethodSetup&& setup, std::vector<opcua::Variable> watched)
      : m_plan(std::move(setup)), m_watched(std::move(watched)) {}

  /// The loop runs. @param sent  when the run cell was written
  virtual void begun(base::Instant sent, base::Instant now) = 0;
  /// Handles a reading. Sets `m_refillDue` if a slot or window has been passed.
  virtual void observe(const Answer& answer, base::Instant now) = 0;
  /// Adds the points for the slots that the control has just passed. @return how many are new
  virtual std::size_t addRefill() = 0;
  /// True as soon as the control is in the loop with the last point, at whose end it reads the
  /// stop.
  [[nodiscard]] virtual bool isInLastLoop() const = 0;
  /// True after every point has been written.
  [[nodiscard]] virtual bool hasSentAll() const = 0;

  SlotPlan m_plan;
  Progress m_progress;
  bool m_refillDue = false;
  base::Instant m_nextAccess{};  ///< earliest time at which the control can have passed more

 private:
  enum class Phase { Fill, Run, Watch, Refill, Stop };

  [[nodiscard]] Action write(Phase phase, std::size_t points);

  std::vector<opcua::Variable> m_watched;
  Phase m_phase = Phase::Fill;
  bool m_waiting = false;  ///< an answer is outstanding
  bool m_stopWanted = false;
};

/// Methods position and signal as seen by the job; the `MethodType` of each consists of its method
/// and the place of its pauses.
class LoopMethodType : public MethodType {
 public:
  [[nodiscard]] std::vector<std::size_t> pausesBefore(std::span<const gcode::StreamPoint> points,
                                                      std::size_t pointsPerLoop,
                                                      WindowCut cut) const final;

 protected:
  /// Points after which the axes also stop within a loop; 0: only at its end.
  [[nodiscard]] virtual std::size_t pauseWithinLoop(std::size_t pointsPerLoop) const = 0;
};

}  // namespace rivulet::streaming
