// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program may leave to the settings of its control (parameters of a Fanuc, settings of a
/// Haas) or to who sets it up: what each is called, and what a virtual machine is set to. Lengths
/// in mm, angles in degrees. @threadsafety plain values.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rivulet::gcode {

enum class ControlSetting : unsigned char {
  RetractPlane,  ///< no R: how far below the height before the cycle
  Stroke,        ///< no Q of G73 and G83; 0: down to the depth at once
  TapSpeed,      ///< no S of G74 and G84: turns per minute
  Lift,          ///< of G76 and back boring: the axis from 1, negative against it
  LiftBy,        ///< no Q of G76 and back boring
  LiftAngle,     ///< where the spindle stands when the tool lifts off
  Arc,           ///< G2 and G3 with neither centre nor radius; 0: a straight line
  Offset,        ///< which settable frame G54.1 P1 is: 507 is G507, and those of P2 and on follow
  Clearance,     ///< how far G73 draws back, and above which depth the feed of G83 begins again
  Place,         ///< the tool stands where a G92 before its axis has moved says
};

/// What is known of these settings; one that is not there is open.
using ControlSettings = std::map<ControlSetting, double>;

/// What a virtual machine is set to. The clearance, within the hole, is that of every machine
/// unless it is given.
[[nodiscard]] double machineDefault(ControlSetting setting);

/// What a machinist calls it, in English with its unit (translated in context "ControlSettings").
[[nodiscard]] std::string_view settingTitle(ControlSetting setting);
/// True if it has no other value than the one of a virtual machine.
[[nodiscard]] bool hasOneValue(ControlSetting setting);
/// Its value alone: "0", "-X", "line".
[[nodiscard]] std::string valueText(ControlSetting setting, double value);
/// Inverse. @return nothing: the setting cannot have it
[[nodiscard]] std::optional<double> settingValueOf(ControlSetting setting, std::string_view text);

/// "plane=0 lift=-X", in the order of the settings.
[[nodiscard]] std::string textOf(const ControlSettings& settings);
/// Inverse. @return nothing: a name or value is none
[[nodiscard]] std::optional<ControlSettings> controlSettingsOf(std::string_view text);

}  // namespace rivulet::gcode
