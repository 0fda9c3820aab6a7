// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Spindle, tools and coolant of the machine: carries out the actions of blocks in the main run,
/// says how long the next block waits for them, and records them. @threadsafety one object, one
/// thread.
#pragma once

#include <vector>

#include "base/instant.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "machine/prepared.h"
#include "trace/control_trace.h"

namespace rivulet::machine {

/// Its speed changes evenly.
class Spindle {
 public:
  /// @param perMin  negative: counterclockwise @return how long it takes
  base::Duration command(const SpindleConfig& config, double perMin, base::Instant at);
  [[nodiscard]] double perMinAt(base::Instant at) const;
  [[nodiscard]] double commandPerMin() const { return m_to; }

 private:
  double m_from = 0.0;
  double m_to = 0.0;
  base::Instant m_began{};
  base::Duration m_time{};
};

class Equipment {
 public:
  /// @param config  outlives it
  explicit Equipment(const MachineConfig& config)
      : m_config(config), m_tool(config.tools ? config.tools->inSpindle : Tool{}) {}

  /// @return s until the next block may begin; infinity: until the next cycle start
  [[nodiscard]] double carryOut(const PreparedActions& actions, base::Instant at,
                                std::vector<trace::ControlEvent>& events);
  /// @param continues  nothing has moved since the dwell before
  void recordDwell(base::LineNumber line, base::Instant at, double seconds, bool continues,
                   std::vector<trace::ControlEvent>& events) const;
  /// Spindle and coolant go off, the offsets too; the tool stays in the spindle.
  void endProgram(base::Instant at, std::vector<trace::ControlEvent>& events);

  [[nodiscard]] EquipmentState state(base::Instant at) const;
  /// In the spindle.
  [[nodiscard]] const Tool& tool() const { return m_tool; }

 private:
  [[nodiscard]] base::Duration carryOut(const MachineAction& action, trace::ControlEvent& event);
  [[nodiscard]] base::Duration turnSpindle(trace::ControlEvent& event);
  [[nodiscard]] base::Duration changeTool(const Tool& tool, trace::ControlEvent& event);

  const MachineConfig& m_config;
  Spindle m_spindle;
  double m_programmedPerMin = 0.0;
  double m_direction = 0.0;  ///< 1, -1 or 0
  Tool m_tool;
  Tool m_next;  ///< selected by T
  int m_edge = 0;
  int m_workOffset = kNoWorkOffset;
  bool m_flood = false;
  bool m_mist = false;
};

}  // namespace rivulet::machine
