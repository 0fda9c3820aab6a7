// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The axes at the end of the pipeline: the servo of the virtual machine follows the set points,
/// and all of it goes into a trace. Without a new set point the axes stand. @threadsafety one
/// object, one thread. @source [P3] II.A: in the place of Powerlink
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "cnc/segment.h"
#include "machine/config.h"
#include "machine/servo_model.h"
#include "trace/control_trace.h"

namespace rivulet::cnc {

class Axes {
 public:
  /// @param ring  outlives it
  [[nodiscard]] static base::Result<Axes> open(pipeline::RingMemory<AxisPoint>& ring,
                                               const machine::MachineConfig& config);

  /// Follows what has been sent. @return SetPointMissing, RingRubbish
  [[nodiscard]] base::Result<void> follow();

  [[nodiscard]] std::uint64_t pointCount() const { return m_cycle; }
  /// The set points as they were sent, with the actual positions.
  [[nodiscard]] const trace::ControlTrace& trace() const { return m_trace; }
  /// When each was sent, monotonic.
  [[nodiscard]] const std::vector<std::int64_t>& sentNs() const { return m_sentNs; }
  /// The last one, if it was the end of the program.
  [[nodiscard]] const pipeline::CycleHead& last() const { return m_last; }

 private:
  Axes(pipeline::RingReader<AxisPoint> in, const machine::MachineConfig& config);

  pipeline::RingReader<AxisPoint> m_in;
  machine::ServoModel m_servo;
  base::AxisPosition m_at;
  base::Duration m_interval;
  std::uint64_t m_cycle = 0;
  pipeline::CycleHead m_last;
  trace::ControlTrace m_trace;
  std::vector<std::int64_t> m_sentNs;
};

}  // namespace rivulet::cnc
