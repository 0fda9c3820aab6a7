// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the pipeline is compared with: the interpreter and the look-ahead of the virtual machine in
/// one loop, without tasks. It keeps the rule that what is planned does not depend on when blocks
/// arrive: the look-ahead is filled before each cycle.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "base/axes.h"
#include "machine/config.h"
#include "pipeline/items.h"
#include "pipeline/tasks/position.h"

namespace rivulet::tests {

/// Axes that keep every set point.
class KeptPoints final : public pipeline::AxisOutput {
 public:
  std::vector<pipeline::SetPoint> points;

  [[nodiscard]] base::Result<void> send(const pipeline::SetPoint& point) override {
    points.push_back(point);
    return {};
  }
};

struct Planned {
  struct Cycle {
    base::Vec3 mm;
    base::RotaryDeg deg{};
    double speed = 0.0;
    base::LineNumber line;
  };
  std::vector<Cycle> cycles;
  std::vector<std::string> actions;  ///< "kind value tool line"
  int alarm = 0;
  std::string alarmText;
};

[[nodiscard]] Planned planInProcess(const machine::MachineConfig& config, const std::string& text);

/// What differs first, to the bit; empty: nothing does.
[[nodiscard]] std::string firstDifference(const Planned& planned,
                                          const std::vector<pipeline::SetPoint>& points);

}  // namespace rivulet::tests
