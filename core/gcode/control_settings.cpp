// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/control_settings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/axes.h"
#include "base/contract.h"
#include "base/sentence.h"
#include "base/text.h"

namespace rivulet::gcode {

namespace {

struct Row {
  ControlSetting setting;
  std::string_view name;
  std::string_view title;
  double machineDefault;
  double smallest;
  double largest;
  std::string_view onlyValue = {};
};

// A Fanuc as delivered lifts off along +X (parameter 5101 RD1 and RD2, 5148), as setting 27 of a
// Haas says too.
constexpr std::array kRows{
    Row{ControlSetting::RetractPlane, "plane",
        RIVULET_SENTENCE("ControlSettings",
                         "R plane of a cycle without R: below the height before it, mm"),
        0.0, 0.0, 1e4},
    Row{ControlSetting::Stroke, "stroke",
        RIVULET_SENTENCE("ControlSettings",
                         "peck depth of G73 and G83 without Q, mm (0: in one stroke)"),
        0.0, 0.0, 1e4},
    Row{ControlSetting::TapSpeed, "tap-speed",
        RIVULET_SENTENCE("ControlSettings", "spindle speed of tapping without S, 1/min"), 500.0,
        1.0, 1e5},
    Row{ControlSetting::Lift, "lift",
        RIVULET_SENTENCE("ControlSettings",
                         "direction in which a boring tool lifts off (X, -X, Y, -Y, Z, -Z)"),
        1.0, -3.0, 3.0},
    Row{ControlSetting::LiftBy, "lift-by",
        RIVULET_SENTENCE("ControlSettings", "lift-off of a boring tool without Q, mm"), 0.0, 0.0,
        100.0},
    Row{ControlSetting::LiftAngle, "lift-angle",
        RIVULET_SENTENCE("ControlSettings",
                         "angle of the spindle when a boring tool lifts off, degrees"),
        0.0, 0.0, 360.0},
    // Fanuc, parameter 3403 (CIR)
    Row{ControlSetting::Arc, "arc",
        RIVULET_SENTENCE("ControlSettings", "an arc without centre and radius is a straight line"),
        0.0, 0.0, 0.0, "line"},
    // G58 and G59 are G505 and G506; SINUMERIK ISO Milling has 93 more, which end at G599.
    Row{ControlSetting::Offset, "offset",
        RIVULET_SENTENCE("ControlSettings", "settable work offset for G54.1 P1 (507: G507)"), 507.0,
        505.0, 599.0},
    Row{ControlSetting::Clearance, "clearance",
        RIVULET_SENTENCE("ControlSettings", "retraction of G73 and G83 within the hole, mm"), 0.25,
        0.0, 100.0},
    Row{ControlSetting::Place, "place",
        RIVULET_SENTENCE("ControlSettings",
                         "before the start the tool stands where the first G92 says, in the work "
                         "offset of the control"),
        0.0, 0.0, 0.0, "G92"},
};

const Row& rowOf(ControlSetting setting) {
  const auto* const found = std::find_if(
      kRows.begin(), kRows.end(), [setting](const Row& row) { return row.setting == setting; });
  RIVULET_ASSERT(found != kRows.end());
  return *found;
}

std::optional<double> axisOf(std::string_view text) {
  const bool isNegative = text.starts_with('-');
  text.remove_prefix(isNegative || text.starts_with('+') ? 1 : 0);
  const auto& names = base::kAxisNames;
  const auto* const found = std::find(names.begin(), names.end(), text.empty() ? ' ' : text[0]);
  if (text.size() != 1 || found == names.end()) {
    return std::nullopt;
  }
  const double axis = 1.0 + static_cast<double>(found - names.begin());
  return isNegative ? -axis : axis;
}

std::optional<double> numberOf(ControlSetting setting, std::string_view text) {
  if (hasOneValue(setting)) {
    return text == rowOf(setting).onlyValue ? std::optional(0.0) : std::nullopt;
  }
  return setting == ControlSetting::Lift ? axisOf(text) : base::parseNumber(text);
}

}  // namespace

std::string_view settingTitle(ControlSetting setting) {
  return rowOf(setting).title;
}

bool hasOneValue(ControlSetting setting) {
  return !rowOf(setting).onlyValue.empty();
}

std::string valueText(ControlSetting setting, double value) {
  if (hasOneValue(setting)) {
    return std::string(rowOf(setting).onlyValue);
  }
  if (setting == ControlSetting::Lift) {
    return std::string(value < 0.0 ? "-" : "") +
           base::kAxisNames[static_cast<std::size_t>(std::abs(value)) - 1];
  }
  return base::formatNumber(value);
}

std::optional<double> settingValueOf(ControlSetting setting, std::string_view text) {
  const Row& row = rowOf(setting);
  const std::optional<double> value = numberOf(setting, text);
  return value && *value >= row.smallest && *value <= row.largest ? value : std::nullopt;
}

double machineDefault(ControlSetting setting) {
  return rowOf(setting).machineDefault;
}

std::string textOf(const ControlSettings& settings) {
  std::string text;
  for (const auto& [setting, value] : settings) {
    text += (text.empty() ? "" : " ") + std::string(rowOf(setting).name) + '=' +
            valueText(setting, value);
  }
  return text;
}

std::optional<ControlSettings> controlSettingsOf(std::string_view text) {
  ControlSettings settings;
  for (text = base::trim(text); !text.empty(); text = base::trim(text)) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size());
    const std::size_t sign = std::min(word.find('='), word.size() - 1);
    const auto* const row = std::find_if(kRows.begin(), kRows.end(), [&](const Row& each) {
      return each.name == word.substr(0, sign);
    });
    if (row == kRows.end()) {
      return std::nullopt;
    }
    const std::optional<double> value = settingValueOf(row->setting, word.substr(sign + 1));
    if (!value) {
      return std::nullopt;
    }
    settings[row->setting] = *value;
  }
  return settings;
}

}  // namespace rivulet::gcode
