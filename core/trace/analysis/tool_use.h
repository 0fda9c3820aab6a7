// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which tool was in the spindle for how long, with which speed, coolant and work offset, by the
/// control's own trace. @threadsafety pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/instant.h"
#include "trace/control_trace.h"

namespace rivulet::trace {

/// From one tool change to the next.
struct ToolUse {
  /// T; 0: it has only a name, or there is none. Nothing: before the first change of the trace.
  std::optional<int> number;
  std::string name;
  base::Duration change{};     ///< until the next block could begin
  base::Duration inSpindle{};  ///< afterwards, until the next change or the end of the trace
  base::Duration turning{};    ///< the spindle was commanded to turn
  base::Duration cooling{};    ///< M7 or M8
  double perMinLeast = 0.0;    ///< speeds commanded, without direction; 0: it did not turn
  double perMinMost = 0.0;
  bool clockwise = false;         ///< M3
  bool counterclockwise = false;  ///< M4
  bool flood = false;             ///< M8
  bool mist = false;              ///< M7
  std::vector<int> workOffsets;   ///< numbers of the G functions, as they came into force
};

/// Finds them in a trace that comes in pieces. Its memory grows with the number of tool changes
/// only.
class ToolUseFinder {
 public:
  /// The next part of the trace.
  void add(const ControlTrace& piece);
  /// In order; empty if the machine has recorded neither tools nor spindle nor coolant. To be
  /// called once.
  [[nodiscard]] std::vector<ToolUse> finish();

 private:
  void take(const ControlEvent& event);
  void passTo(base::Instant at);
  void begin(const ControlEvent& event);
  void turn(double perMin);
  void noteCoolant();
  void noteOffset();

  std::vector<ToolUse> m_uses{1};
  std::optional<base::Instant> m_to;  ///< all time before is accounted for
  base::Instant m_end{};
  bool m_hasTools = false;
  double m_perMin = 0.0;
  int m_coolant = 0;
  std::optional<int> m_offset;
};

/// The uses of a whole trace.
[[nodiscard]] std::vector<ToolUse> toolUses(const ControlTrace& trace);

}  // namespace rivulet::trace
