// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/prerun.h"

#include "machine/travel.h"

namespace rivulet::machine {

void Prerun::start(std::unique_ptr<Interpreter> interpreter, base::Instant now) {
  m_interpreter = std::move(interpreter);
  m_alarm.reset();
  m_message.clear();
  m_standstill = false;
  interpret(now);
}

void Prerun::stop() {
  m_state = State::Idle;
  m_interpreter.reset();
  m_standstill = false;
}

std::optional<base::Instant> Prerun::nextEvent() const {
  if (m_state == State::Preparing || m_state == State::Relatching) {
    return m_at;
  }
  return std::nullopt;
}

void Prerun::interpret(base::Instant now) {
  // The values are latched now, the block is ready one preparation later: a write that comes in
  // between is too late, as on the control.
  m_prepared = m_interpreter->next();
  if (const auto* motion = std::get_if<PreparedMotion>(&m_prepared)) {
    if (std::optional<Alarm> alarm = travelAlarm(m_config, *motion)) {
      m_prepared = std::move(*alarm);
    }
  }
  m_at = now + m_config.blockPreparation;
  m_state = State::Preparing;
}

void Prerun::handle(base::Instant now, PathPlanner& planner) {
  if (m_state == State::Relatching) {
    m_interpreter->refresh();
    interpret(now);
    return;
  }
  deliver(now, planner);
}

void Prerun::deliver(base::Instant now, PathPlanner& planner) {
  const bool forMainRun = std::holds_alternative<PreparedMotion>(m_prepared) ||
                          std::holds_alternative<PreparedActions>(m_prepared) ||
                          std::holds_alternative<PreparedDwell>(m_prepared);
  if (forMainRun) {
    if (planner.blockCount() >= m_config.bufferedBlocksMax) {
      m_state = State::BufferFull;
      return;
    }
    if (const auto* motion = std::get_if<PreparedMotion>(&m_prepared)) {
      planner.append(*motion);
    } else if (auto* actions = std::get_if<PreparedActions>(&m_prepared)) {
      planner.append(std::move(*actions));
    } else {
      planner.append(std::get<PreparedDwell>(m_prepared));
    }
    interpret(now);
    return;
  }
  if (const auto* message = std::get_if<PreparedMessage>(&m_prepared)) {
    m_message = message->text;
    interpret(now);
    return;
  }
  if (auto* sync = std::get_if<PreparedSync>(&m_prepared)) {
    m_syncActions.add(std::move(sync->action), planner.blocksAppended());
    interpret(now);
    return;
  }
  if (const auto* cancel = std::get_if<PreparedCancel>(&m_prepared)) {
    m_syncActions.cancel(cancel->id);
    interpret(now);
    return;
  }
  if (const auto* nothing = std::get_if<PreparedNothing>(&m_prepared)) {
    if (nothing->jumped && m_config.jumpStops) {
      m_state = State::AwaitStand;
      checkStand(now, planner);
    } else {
      interpret(now);
    }
    return;
  }
  m_state =
      std::holds_alternative<PreparedStopre>(m_prepared) ? State::AwaitStand : State::AwaitEnd;
  checkStand(now, planner);
}

void Prerun::mainRunAdvanced(base::Instant now, PathPlanner& planner) {
  if (m_state == State::BufferFull) {
    deliver(now, planner);
  } else {
    checkStand(now, planner);
  }
}

void Prerun::checkStand(base::Instant now, const PathPlanner& planner) {
  if (planner.blockCount() > 0) {
    return;
  }
  if (m_state == State::AwaitStand) {
    m_at = now + m_config.relatch;
    m_state = State::Relatching;
    m_standstill = true;
  } else if (m_state == State::AwaitEnd) {
    if (auto* alarm = std::get_if<Alarm>(&m_prepared)) {
      m_alarm = *alarm;
      m_state = State::Alarmed;
    } else {
      m_state = State::Ended;
    }
  }
}

bool Prerun::takeStandstill() {
  return std::exchange(m_standstill, false);
}

}  // namespace rivulet::machine
