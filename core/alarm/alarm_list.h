// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The alarms that are not normal, and the transitions between the states of ISA-18.2. Two alarms
/// of one code with the same subject are one alarm. @threadsafety shares nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "alarm/alarm.h"

namespace rivulet::alarm {

enum class Event { Raised, Returned, Acknowledged, Shelved, Unshelved, ShelvingExpired };

[[nodiscard]] std::string_view eventName(Event event);
[[nodiscard]] std::optional<Event> eventOfName(std::string_view name);

/// What happened to an alarm: a line of the history.
struct Transition {
  UtcMs at = 0;
  Event event = Event::Raised;
  Alarm alarm;     ///< afterwards
  std::string by;  ///< who did it; empty: nobody
};

class AlarmList {
 public:
  /// More are not kept: the least important one gives way. Codes are few, but control alarms have
  /// many numbers.
  static constexpr std::size_t kAlarmsMax = 200;
  /// Nothing may be put aside for longer than a shift.
  static constexpr UtcMs kShelvingMsMax = UtcMs{8} * 3600 * 1000;

  /// The condition holds. While the alarm is active already, nothing happens.
  void raise(Code code, std::vector<std::string> arguments, UtcMs now, base::Error error = {});
  /// The condition holds no more. Nothing happens if the alarm is not active.
  void settle(Code code, UtcMs now);
  /// The same for all of this code but one subject.
  void settleOthers(Code code, const std::string& subject, UtcMs now);
  /// @return false: there is no such alarm, or it is acknowledged already
  bool acknowledge(int number, const std::string& by, UtcMs now);
  /// Acknowledges every alarm.
  void acknowledgeAll(const std::string& by, UtcMs now);
  /// @param until  after `now`; at most `kShelvingMsMax` later, else it is shortened to that
  /// @return false: there is no such alarm
  bool shelve(int number, UtcMs until, const std::string& by, UtcMs now);
  bool unshelve(int number, const std::string& by, UtcMs now);
  /// Ends shelvings that have expired.
  void advance(UtcMs now);
  /// An alarm of an earlier session that nobody acknowledged: its cause is not known to hold.
  void restore(Alarm alarm);

  /// The most important first: unacknowledged before acknowledged, then by priority, then the
  /// newest; shelved ones last.
  [[nodiscard]] const std::vector<Alarm>& alarms() const { return m_alarms; }
  [[nodiscard]] const Alarm* find(int number) const;
  /// What has to be shown; null: nothing that is not shelved.
  [[nodiscard]] const Alarm* mostImportant() const;
  /// Without those that are shelved.
  [[nodiscard]] std::size_t shownCount() const;
  /// Since the last call, the oldest first.
  [[nodiscard]] std::vector<Transition> takeTransitions();

 private:
  [[nodiscard]] Alarm* findByNumber(int number);
  void record(const Alarm& alarm, Event event, UtcMs now, const std::string& by = {});
  /// Removes what is normal and sorts the rest.
  void tidy();

  std::vector<Alarm> m_alarms;
  std::vector<Transition> m_transitions;
  int m_nextNumber = 1;
};

}  // namespace rivulet::alarm
