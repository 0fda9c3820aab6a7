// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "alarm/alarm_list.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "base/contract.h"

namespace rivulet::alarm {

namespace {

constexpr std::array<std::string_view, 6> kEvents{"raised",  "returned",  "acknowledged",
                                                  "shelved", "unshelved", "shelving-expired"};

/// Smaller is more important.
auto rank(const Alarm& alarm) {
  const State state = alarm.state();
  const int group = state == State::Shelved ? 3 : state == State::Acknowledged ? 2 : 1;
  return std::tuple(group, -static_cast<int>(factsOf(alarm.code).priority), -alarm.raisedAt,
                    -alarm.number);
}

}  // namespace

std::string_view eventName(Event event) {
  return kEvents[static_cast<std::size_t>(event)];
}

std::optional<Event> eventOfName(std::string_view name) {
  const auto* found = std::find(kEvents.begin(), kEvents.end(), name);
  return found == kEvents.end() ? std::nullopt
                                : std::optional(static_cast<Event>(found - kEvents.begin()));
}

void AlarmList::raise(Code code, std::vector<std::string> arguments, UtcMs now, base::Error error) {
  const std::string subject = arguments.empty() ? "" : arguments.front();
  const auto same = std::find_if(m_alarms.begin(), m_alarms.end(), [&](const Alarm& alarm) {
    return alarm.code == code && alarm.subject() == subject;
  });
  if (same != m_alarms.end() && same->isActive) {
    return;
  }
  const bool isNew = same == m_alarms.end();
  Alarm& alarm = isNew ? m_alarms.emplace_back() : *same;
  if (isNew) {
    alarm.number = m_nextNumber++;
    alarm.code = code;
    alarm.count = 0;
  }
  alarm.arguments = std::move(arguments);
  alarm.error = std::move(error);
  alarm.raisedAt = now;
  ++alarm.count;
  alarm.isActive = true;
  alarm.isAcknowledged = false;
  record(alarm, Event::Raised, now);
  tidy();
}

void AlarmList::settle(Code code, UtcMs now) {
  for (Alarm& alarm : m_alarms) {
    if (alarm.code == code && std::exchange(alarm.isActive, false)) {
      record(alarm, Event::Returned, now);
    }
  }
  tidy();
}

void AlarmList::settleOthers(Code code, const std::string& subject, UtcMs now) {
  for (Alarm& alarm : m_alarms) {
    if (alarm.code == code && alarm.subject() != subject && std::exchange(alarm.isActive, false)) {
      record(alarm, Event::Returned, now);
    }
  }
  tidy();
}

bool AlarmList::acknowledge(int number, const std::string& by, UtcMs now) {
  Alarm* alarm = findByNumber(number);
  if (alarm == nullptr || std::exchange(alarm->isAcknowledged, true)) {
    return false;
  }
  record(*alarm, Event::Acknowledged, now, by);
  tidy();
  return true;
}

void AlarmList::acknowledgeAll(const std::string& by, UtcMs now) {
  for (Alarm& alarm : m_alarms) {
    if (!std::exchange(alarm.isAcknowledged, true)) {
      record(alarm, Event::Acknowledged, now, by);
    }
  }
  tidy();
}

bool AlarmList::shelve(int number, UtcMs until, const std::string& by, UtcMs now) {
  RIVULET_ASSERT(until > now);
  Alarm* alarm = findByNumber(number);
  if (alarm == nullptr) {
    return false;
  }
  alarm->shelving = Shelving{std::min(until, now + kShelvingMsMax), by};
  record(*alarm, Event::Shelved, now, by);
  tidy();
  return true;
}

bool AlarmList::unshelve(int number, const std::string& by, UtcMs now) {
  Alarm* alarm = findByNumber(number);
  if (alarm == nullptr || !alarm->shelving) {
    return false;
  }
  alarm->shelving.reset();
  record(*alarm, Event::Unshelved, now, by);
  tidy();
  return true;
}

void AlarmList::advance(UtcMs now) {
  for (Alarm& alarm : m_alarms) {
    if (alarm.shelving && alarm.shelving->until <= now) {
      alarm.shelving.reset();
      record(alarm, Event::ShelvingExpired, now);
    }
  }
  tidy();
}

void AlarmList::restore(Alarm alarm) {
  alarm.number = m_nextNumber++;
  alarm.isActive = false;
  alarm.isAcknowledged = false;
  alarm.shelving.reset();
  m_alarms.push_back(std::move(alarm));
  tidy();
}

const Alarm* AlarmList::find(int number) const {
  const auto found = std::find_if(m_alarms.begin(), m_alarms.end(),
                                  [number](const Alarm& alarm) { return alarm.number == number; });
  return found == m_alarms.end() ? nullptr : &*found;
}

Alarm* AlarmList::findByNumber(int number) {
  return const_cast<Alarm*>(find(number));
}

const Alarm* AlarmList::mostImportant() const {
  return m_alarms.empty() || m_alarms.front().state() == State::Shelved ? nullptr
                                                                        : &m_alarms.front();
}

std::size_t AlarmList::shownCount() const {
  return static_cast<std::size_t>(
      std::count_if(m_alarms.begin(), m_alarms.end(),
                    [](const Alarm& alarm) { return alarm.state() != State::Shelved; }));
}

std::vector<Transition> AlarmList::takeTransitions() {
  return std::exchange(m_transitions, {});
}

void AlarmList::record(const Alarm& alarm, Event event, UtcMs now, const std::string& by) {
  m_transitions.push_back({now, event, alarm, by});
}

void AlarmList::tidy() {
  std::erase_if(m_alarms, [](const Alarm& alarm) { return alarm.state() == State::Normal; });
  std::sort(m_alarms.begin(), m_alarms.end(),
            [](const Alarm& a, const Alarm& b) { return rank(a) < rank(b); });
  if (m_alarms.size() > kAlarmsMax) {
    m_alarms.resize(kAlarmsMax);
  }
}

}  // namespace rivulet::alarm
