// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The settings of a run and the reading of its program by name, in a form that does not depend on
/// the language: for the audit trail, for releases, and for clients of a service. @threadsafety
/// pure.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gcode/program.h"
#include "streaming/start/stream_settings.h"

namespace rivulet::preparation {

/// Names and values, in order.
using SettingsFacts = std::vector<std::pair<std::string, std::string>>;

/// Every setting of a run.
[[nodiscard]] SettingsFacts settingsFacts(const streaming::StreamSettings& settings);
/// Inverse of `settingsFacts`: what is not named, or is out of range, stays as it is. Whoever gives
/// names may sit at another computer: a source of factors is a port, and no path.
void applySettings(streaming::StreamSettings& settings, const SettingsFacts& facts);

/// How the text is read. What nobody has said is "auto".
[[nodiscard]] SettingsFacts readingFacts(const gcode::TextReading& reading);
/// Inverse of `readingFacts`: what is not named, or is no value, stays as it is.
void applyReading(gcode::TextReading& reading, const SettingsFacts& facts);
/// What a release names: every setting of a run, and of the reading and of a source of factors what
/// somebody has said.
[[nodiscard]] SettingsFacts releasedFacts(const streaming::StreamSettings& settings,
                                          const gcode::TextReading& reading);

/// "method=window;points=7;…".
[[nodiscard]] std::string textOf(const SettingsFacts& facts);
/// Inverse of `textOf`; what has no "=" is left out.
[[nodiscard]] SettingsFacts factsOfText(const std::string& text);

}  // namespace rivulet::preparation
