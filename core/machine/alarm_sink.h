// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The first fault of a block as the alarm the control would show. @threadsafety one object, one
/// thread.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "machine/alarm.h"
#include "nc/exec/sink.h"

namespace rivulet::machine {

class AlarmSink final : public nc::FaultSink {
 public:
  /// Warnings are none of the control, but for a block without feed.
  void report(nc::Severity severity, int column, nc::FaultCode code,
              std::string argument) override {
    const bool isName = !argument.starts_with('G') || argument.size() < 2 || argument[1] > '9';
    if (code == nc::FaultCode::UnsupportedGCode && isName) {
      code = nc::FaultCode::NotDefined;
    }
    if (severity == nc::Severity::Error || code == nc::FaultCode::FeedMissing) {
      fault(column, {code, std::move(argument), {}});
    }
  }
  void fault(int /*column*/, const nc::Fault& fault) override { raise(alarmOf(fault)); }
  void raise(Alarm alarm) {
    if (!m_alarm) {
      m_alarm = std::move(alarm);
    }
  }

  [[nodiscard]] std::optional<Alarm> take() { return std::exchange(m_alarm, std::nullopt); }

 private:
  std::optional<Alarm> m_alarm;
};

}  // namespace rivulet::machine
