// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Alarms in the language of the operator. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "alarm/alarm_list.h"
#include "gcode/diagnostic.h"

namespace rivulet::widgets {

/// What has happened.
[[nodiscard]] QString alarmText(const alarm::Alarm& alarm);
/// Why, as far as it is known; may be empty.
[[nodiscard]] QString alarmCause(const alarm::Alarm& alarm);
/// What to do.
[[nodiscard]] QString alarmRemedy(const alarm::Alarm& alarm);

[[nodiscard]] QString sourceText(alarm::Source source);
[[nodiscard]] QString stateText(alarm::State state);
[[nodiscard]] QString eventText(alarm::Event event);

/// Icon and colour of an alarm are those of a message of this severity.
[[nodiscard]] gcode::Severity severityOf(alarm::Priority priority);

/// Date and time of this computer, ISO 8601 without the T: "2026-11-22 08:30:05".
[[nodiscard]] QString dateTimeText(base::UtcMs at);

}  // namespace rivulet::widgets
