// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pre-run in time: when a block is interpreted (its R values are latched then), when it
/// reaches the buffer, and what makes the pre-run wait. @threadsafety one object, one thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "machine/config.h"
#include "machine/interpreter.h"
#include "machine/path_planner.h"
#include "machine/sync_action.h"

namespace rivulet::machine {

class Prerun {
 public:
  /// @param syncActions  where synchronized actions go; must outlive the pre-run
  Prerun(const MachineConfig& config, SyncActions& syncActions)
      : m_config(config), m_syncActions(syncActions) {}

  void start(std::unique_ptr<Interpreter> interpreter, base::Instant now);
  void stop();

  /// When `handle` is due; nothing while it waits for the main run or is at rest.
  [[nodiscard]] std::optional<base::Instant> nextEvent() const;
  void handle(base::Instant now, PathPlanner& planner);

  /// After each cycle of the main run: there may be room in the buffer, or the axes may have
  /// stopped.
  void mainRunAdvanced(base::Instant now, PathPlanner& planner);

  /// Since the last call, the axes have stopped at a STOPRE: the standstill it causes begins.
  [[nodiscard]] bool takeStandstill();

  [[nodiscard]] bool hasEnded() const { return m_state == State::Ended; }
  /// Set as soon as everything before the faulty block has been executed.
  [[nodiscard]] const std::optional<Alarm>& alarm() const { return m_alarm; }
  [[nodiscard]] const std::string& message() const { return m_message; }

 private:
  enum class State {
    Idle,
    Preparing,   ///< m_prepared is ready at m_at
    BufferFull,  ///< m_prepared waits for room
    AwaitStand,  ///< STOPRE: waits for the main run
    Relatching,  ///< the axes have stopped; continues at m_at
    AwaitEnd,    ///< M30 or an alarm: the main run empties the buffer
    Ended,
    Alarmed,
  };

  void interpret(base::Instant now);
  void deliver(base::Instant now, PathPlanner& planner);
  void checkStand(base::Instant now, const PathPlanner& planner);

  MachineConfig m_config;
  SyncActions& m_syncActions;
  std::unique_ptr<Interpreter> m_interpreter;
  State m_state = State::Idle;
  Prepared m_prepared;
  base::Instant m_at{};
  bool m_standstill = false;
  std::optional<Alarm> m_alarm;
  std::string m_message;
};

}  // namespace rivulet::machine
