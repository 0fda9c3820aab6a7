// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The six tasks and their ring buffers in one memory. @threadsafety each task in a thread of its
/// own, or all in one.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "machine/config.h"
#include "pipeline/items.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"
#include "pipeline/tasks/discrete.h"
#include "pipeline/tasks/interpolate.h"
#include "pipeline/tasks/interpret.h"
#include "pipeline/tasks/look_ahead.h"
#include "pipeline/tasks/position.h"
#include "pipeline/tasks/receive.h"

namespace rivulet::pipeline {

/// All ring buffers; may lie in shared memory.
struct Rings {
  RingMemory<ProgramText> b1;
  RingMemory<NcBlock> b2;
  RingMemory<RoughBlock> b3;
  RingMemory<CyclePlace> b4;
  RingMemory<SetPoint> b5;
};

/// One task on its rings. @param rings, output  outlive it; output is for position control only
/// @return RingLayout
[[nodiscard]] base::Result<std::unique_ptr<Stage>> makeStage(Task task, Rings& rings,
                                                             const machine::MachineConfig& config,
                                                             AxisOutput& output);

/// All tasks of one pipeline in one process.
class Pipeline {
 public:
  /// @param output  outlives it
  Pipeline(const machine::MachineConfig& config, AxisOutput& output);

  [[nodiscard]] ReceiveTask& receive() { return *m_receive; }
  [[nodiscard]] std::array<Stage*, kTaskCount> stages() const;

 private:
  std::unique_ptr<Rings> m_rings;
  std::array<std::unique_ptr<Stage>, kTaskCount> m_stages;
  ReceiveTask* m_receive = nullptr;
};

}  // namespace rivulet::pipeline
