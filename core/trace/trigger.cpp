// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/trigger.h"

#include <cmath>

namespace rivulet::trace {

using base::Instant;

namespace {

bool isEdge(TriggerKind kind) {
  return kind == TriggerKind::Rising || kind == TriggerKind::Falling;
}

}  // namespace

bool Trigger::holds(double value) const {
  const TriggerCondition& condition = m_settings.condition;
  switch (condition.kind) {
    case TriggerKind::Above:
    case TriggerKind::Rising:
      return value >= condition.level;
    case TriggerKind::Below:
    case TriggerKind::Falling:
      return value <= condition.level;
    case TriggerKind::Inside:
      return value >= condition.low && value <= condition.high;
    case TriggerKind::Outside:
      return value < condition.low || value > condition.high;
    case TriggerKind::Event:
      break;
  }
  return false;
}

bool Trigger::releases(double value) const {
  const TriggerCondition& condition = m_settings.condition;
  const double apart = condition.hysteresis;
  switch (condition.kind) {
    case TriggerKind::Above:
    case TriggerKind::Rising:
      return value < condition.level && value <= condition.level - apart;
    case TriggerKind::Below:
    case TriggerKind::Falling:
      return value > condition.level && value >= condition.level + apart;
    case TriggerKind::Inside:
      return value < condition.low - apart || value > condition.high + apart;
    case TriggerKind::Outside:
      return value >= condition.low + apart && value <= condition.high - apart;
    case TriggerKind::Event:
      break;
  }
  return false;
}

std::optional<Instant> Trigger::test(Instant at, double value) {
  const TriggerCondition& condition = m_settings.condition;
  if (condition.kind == TriggerKind::Event) {
    return std::nullopt;
  }
  if (std::isnan(value)) {
    m_hasBefore = false;
    return std::nullopt;
  }
  const bool hadBefore = m_hasBefore;
  const Instant before = m_before;
  const double valueBefore = m_valueBefore;
  m_hasBefore = true;
  m_before = at;
  m_valueBefore = value;
  if (!holds(value)) {
    m_isReady = m_isReady || releases(value);
    return std::nullopt;
  }
  // An edge has to be seen: a signal that is beyond the level when the trigger is armed, or after a
  // gap, has not crossed it.
  const bool hasCrossed = hadBefore && !holds(valueBefore);
  if (!m_isReady || (isEdge(condition.kind) && !hasCrossed)) {
    return std::nullopt;
  }
  m_isReady = false;
  if (!isEdge(condition.kind)) {
    return at;
  }
  const double share = (condition.level - valueBefore) / (value - valueBefore);
  return before + base::fromSeconds(share * base::toSeconds(at - before));
}

std::optional<TriggerShot> Trigger::fire(Instant at, Instant now) {
  m_shot = TriggerShot{at, Instant{at - m_settings.before}, Instant{at + m_settings.after}};
  m_state = State::Filling;
  return advance(now);
}

std::optional<TriggerShot> Trigger::sample(Instant at, double value) {
  const auto firedAt = test(at, value);
  if (m_state == State::Waiting && firedAt) {
    return fire(*firedAt, at);
  }
  return advance(at);
}

std::optional<TriggerShot> Trigger::happened(TriggerEvent event, Instant at, Instant now) {
  const TriggerCondition& condition = m_settings.condition;
  const bool isWanted = condition.kind == TriggerKind::Event && condition.event == event;
  return m_state == State::Waiting && isWanted ? fire(at, now) : advance(now);
}

std::optional<TriggerShot> Trigger::advance(Instant now) {
  return m_state == State::Filling && now >= m_shot->to ? finish() : std::nullopt;
}

std::optional<TriggerShot> Trigger::finish() {
  if (m_state != State::Filling) {
    return std::nullopt;
  }
  m_state = m_settings.isRepeated ? State::Waiting : State::Done;
  const auto shot = m_shot;
  m_shot.reset();
  return shot;
}

}  // namespace rivulet::trace
