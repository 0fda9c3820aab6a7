// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Triggers of live traces, as of an oscilloscope: what they wait for, and which stretch of time is
/// to be shown when it happens.
///
/// A condition fires when it becomes true, and once armed also if it is true at once (an edge: only
/// when the signal crosses the level). Before it can fire again, it must have been false. With
/// hysteresis the signal must have gone that far back, so noise at the level fires once.
/// @threadsafety one thread; samples come from the caller, no clock is read.
#pragma once

#include <optional>

#include "base/instant.h"

namespace rivulet::trace {

enum class TriggerKind {
  Above,    ///< the level or more
  Below,    ///< the level or less
  Rising,   ///< crosses the level upwards
  Falling,  ///< crosses it downwards
  Inside,   ///< between `low` and `high`, both included
  Outside,  ///< not between them
  Event,
};

enum class TriggerEvent { PauseBegins, Alarm };

struct TriggerCondition {
  TriggerKind kind = TriggerKind::Rising;
  double level = 0.0;  ///< in the unit of the signal
  double low = 0.0;
  double high = 0.0;        ///< >= low
  double hysteresis = 0.0;  ///< >= 0
  TriggerEvent event = TriggerEvent::PauseBegins;
};

struct TriggerSettings {
  TriggerCondition condition;
  base::Duration before{};  ///< shown before the trigger, >= 0
  base::Duration after{};   ///< shown after it, >= 0
  bool isRepeated = false;  ///< after what is shown, it waits for the next; else it fires once
};

/// A trigger that has fired, and what is to be shown.
struct TriggerShot {
  base::Instant at{};
  base::Instant from{};
  base::Instant to{};

  friend bool operator==(const TriggerShot&, const TriggerShot&) = default;
};

class Trigger {
 public:
  enum class State {
    Waiting,  ///< for the condition
    Filling,  ///< it has fired; the time after it is still to come
    Done,     ///< it has fired once and is over
  };

  explicit Trigger(const TriggerSettings& settings) : m_settings(settings) {}

  [[nodiscard]] State state() const { return m_state; }
  [[nodiscard]] const TriggerSettings& settings() const { return m_settings; }

  /// A value of the signal. @param at  not before the last call of any function
  /// @param value  NaN: a gap, the signal before it is forgotten
  /// @return the shot, as soon as all of it is there
  [[nodiscard]] std::optional<TriggerShot> sample(base::Instant at, double value);
  /// Something happened. @param at  may be earlier than the last sample: it was noticed late
  /// @param now  until when samples are there
  [[nodiscard]] std::optional<TriggerShot> happened(TriggerEvent event, base::Instant at,
                                                    base::Instant now);
  /// Samples are there until this instant.
  [[nodiscard]] std::optional<TriggerShot> advance(base::Instant now);
  /// Nothing more will come: a shot that is not complete is what there is.
  [[nodiscard]] std::optional<TriggerShot> finish();

 private:
  /// When the condition became true; nothing: it did not.
  [[nodiscard]] std::optional<base::Instant> test(base::Instant at, double value);
  [[nodiscard]] std::optional<TriggerShot> fire(base::Instant at, base::Instant now);
  [[nodiscard]] bool holds(double value) const;
  /// Whether the signal has gone back far enough for the next time.
  [[nodiscard]] bool releases(double value) const;

  TriggerSettings m_settings;
  State m_state = State::Waiting;
  std::optional<TriggerShot> m_shot;  ///< while Filling
  bool m_isReady = true;              ///< the condition was false since it fired
  bool m_hasBefore = false;
  base::Instant m_before{};  ///< last sample
  double m_valueBefore = 0.0;
};

}  // namespace rivulet::trace
